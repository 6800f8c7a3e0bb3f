#include "exact/joined.hpp"
#include "report/render_theorem.hpp"

#include "exact/lists.hpp"
#include "theorem/prove.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <set>

namespace kov::report {
namespace {

std::string mark(const std::string& status, std::size_t width) {
  std::string s = "[" + status + "]";
  s.resize(width, ' ');
  return s;
}

// Fills lines to `width` characters, each after `indent` blanks.
std::string filled(const std::string& text, std::size_t indent, std::size_t width = 100) {
  std::string out, line;
  const auto flush = [&] {
    if (!line.empty()) out += std::string(indent, ' ') + line + "\n";
    line.clear();
  };
  std::string word;
  for (const char c : text + " ") {
    if (c != ' ') {
      word += c;
      continue;
    }
    if (!line.empty() && indent + line.size() + 1 + word.size() > width) flush();
    line += (line.empty() ? "" : " ") + word;
    word.clear();
  }
  flush();
  return out;
}

// "  [Ziglin1980, Ziglin1983]"
std::string cited(const std::vector<TheoremUsed>& uses) {
  std::set<std::string> keys;
  for (const TheoremUsed& u : uses)
    keys.insert(u.theorem->cite);
  std::string out = joined(keys, [](const std::string& key) { return key; });
  return out.empty() ? "" : "  [" + out + "]";
}

// Cautions that no short form may hide: why a step is not proved, and what does not fit.
void put_caution(std::string& out, const NodeResult& n, std::size_t indent) {
  const bool good = n.status == NodeStatus::proved || n.status == NodeStatus::trusted;
  for (const Hypothesis& h : n.node.hypotheses)
    if (!h.checked) out += filled("HYPOTHESIS NOT CHECKED: " + h.text, indent);
  if (!good && !n.summary.empty())
    out += filled(n.summary, indent);
  else if (!n.caution.empty())
    out += filled(n.caution, indent);
}

struct TheoremTree {
  const TheoremResult& theorem;
  TheoremDetail detail;
  std::size_t width = 11; ///< of a mark
  std::set<std::string> seen{};
  std::string text{};

  void put(const std::string& id, std::size_t depth) {
    const NodeResult& n = *node_with(theorem, id);
    const bool again = !seen.insert(id).second;
    const bool whole = detail == TheoremDetail::whole;
    if (again && !whole) return;
    text += mark(status_of(n), width) + " " + std::string(2 * depth, ' ') + n.node.title +
            (whole ? "" : cited(n.theorems)) + (n.rests_on_open ? "  (rests on open steps)" : "") +
            (again ? "  (above)" : "") + "\n";
    if (again) return;
    put_caution(text, n, width + 2 * depth + 3);
    const std::string inner(2 * depth + 3, ' ');
    if (whole)
      for (const TheoremUsed& u : each_once(n.theorems))
        text += mark("trusted", width) + inner + u.theorem->in_words() + "\n";
    for (const std::string& child : n.node.needs)
      put(child, depth + 1);
  }
};

void put_step(std::string& out, const NodeResult& n) {
  out += "\n" + n.node.title + "  [" + status_of(n) + ", " + to_string(n.node.kind) + "]\n";
  if (!n.statement.empty()) out += filled(n.statement + ".", 2);
  if (!n.node.statement.empty()) out += filled(remark(n) + n.node.statement, 2);
  if (const std::string found = finding(n); !found.empty()) out += filled("found: " + found, 2);
  for (const Hypothesis& h : n.node.hypotheses)
    out += filled((h.checked ? "hypothesis, for which the author names step '" + h.by + "': "
                             : std::string("HYPOTHESIS NOT CHECKED: ")) +
                      h.text,
                  2);
  for (const CheckedIdentity& c : n.checks)
    out += filled(std::string(c.holds ? "ok  " : "NO  ") + c.statement, 4);
  for (const Formula& f : n.formulas)
    out += filled(f.label + ": " + shortened(f.text, 400), 4);
  for (const Grid& g : n.tables) {
    out += filled(g.caption, 4);
    if (g.rows.empty()) out += filled("- none", 6);
    for (const auto& row : g.rows)
      out += filled("- " + joined(row, " | "), 6);
  }
  for (const TheoremUsed& u : each_once(n.theorems))
    out += filled("by " + u.theorem->in_words(), 4);
  if (!n.node.note.empty()) out += filled("note: " + n.node.note, 2);
}

// A system with its equations, or a file with its hash alone.
void put_file(std::string& out, const InputFile& f) {
  out += "\n" + f.name + "  [SHA-256 " + f.sha256 + "]\n";
  if (!f.assumed.empty()) out += filled(f.assumed, 4);
  for (const Formula& line : f.setting)
    out += filled(line.label + ": " + shortened(line.text, 400), 4);
}

void put_hypotheses(std::string& out, const TheoremResult& t) {
  for (const TheoremUsed& use : t.uses()) {
    const LiteratureTheorem& theorem = *use.theorem;
    out += filled(theorem.name + " [" + theorem.cite + "]: " + theorem.statement, 2);
    for (const TheoremHypothesis& h : use.hypotheses)
      out += filled(settled(h) + h.text, 4);
  }
}

// All that is believed: the steps, the hypotheses that nobody checked, the theorems.
std::string trust(const TheoremResult& t, bool whole) {
  std::string out;
  for (const std::string& s : t.trusted_steps())
    out += filled(s, 2);
  for (const std::string& s : t.unchecked_hypotheses())
    out += filled("HYPOTHESIS NOT CHECKED  " + s, 2);
  if (whole) put_hypotheses(out, t);
  for (const TheoremUsed& u : t.uses())
    if (!whole) out += "  " + u.theorem->in_words() + "  [" + u.theorem->cite + "]\n";
  return "trusted\n" + (out.empty() ? "  nothing\n" : out);
}

std::vector<std::string> ids(const std::vector<TheoremUsed>& uses) {
  return mapped<std::string>(uses, [&](const TheoremUsed& use) { return use.id(); });
}

std::vector<std::string> names(const std::vector<TheoremUsed>& uses) {
  return mapped<std::string>(uses, [&](const TheoremUsed& use) { return use.theorem->name; });
}

} // namespace

std::string theorem_text(const TheoremResult& t, TheoremDetail detail) {
  const bool whole = detail == TheoremDetail::whole;
  std::string out = t.theorem.title + "  (the author's title)\n";
  if (whole && !t.theorem.statement.empty())
    out += filled("the author's words: " + t.theorem.statement, 2);
  out += "\n" + filled(t.conclusion() + ".", 0);
  if (!t.statement().empty()) out += filled(t.statement() + ".", 2);
  out += "time " + t.time() + "\n\n";
  TheoremTree tree{t, detail};
  for (const NodeResult& n : t.nodes)
    tree.width = std::max(tree.width, status_of(n).size() + 2);
  for (const NodeResult* n : roots(t))
    tree.put(n->node.id, 0);
  out += tree.text + "\n" + trust(t, whole);
  if (!whole) return out + "Each step with what was checked: --verbose, or -o NAME.html\n";
  for (const InputFile& f : t.files)
    put_file(out, f);
  for (const NodeResult& n : t.nodes)
    put_step(out, n);
  return out;
}

std::string theorem_json(const TheoremResult& t) {
  using Json = nlohmann::ordered_json;
  const auto labelled = [](const Formula& f) { return Json{{"label", f.label}, {"text", f.text}}; };
  Json nodes = Json::array();
  for (const NodeResult& n : t.nodes) {
    Json j{{"id", n.node.id},
           {"title", n.node.title},
           {"kind", to_string(n.node.kind)},
           {"status", status_of(n)},
           {"rests_on_open", n.rests_on_open},
           {"steps_on_trust", n.steps_on_trust},
           {"statement", n.statement},
           {"remark", n.node.statement},
           {"summary", n.summary},
           {"needs", n.node.needs},
           {"cite", n.node.cite},
           {"theorems", ids(n.theorems)},
           {"trusted", sentences(n.trusted)},
           {"certificates", n.certificates.size()}};
    j["hypotheses"] = mapped<Json>(n.node.hypotheses, [](const Hypothesis& h) {
      return Json{{"text", h.text}, {"by", h.by}, {"checked", h.checked}};
    });
    j["checks"] = mapped<Json>(n.checks, [](const CheckedIdentity& c) {
      return Json{{"statement", c.statement}, {"holds", c.holds}};
    });
    j["formulas"] = mapped<Json>(n.formulas, labelled);
    j["tables"] = mapped<Json>(n.tables, [](const Grid& g) {
      return Json{{"caption", g.caption}, {"header", g.header}, {"rows", g.rows}};
    });
    if (!n.node.file.empty()) j["file"] = n.node.file;
    if (n.node.kind == NodeKind::case_file) j["expect"] = n.node.expect;
    if (n.found) {
      j["verdict"] = to_string(n.found->verdict);
      j["integrals_class"] =
          n.found->excluded.empty() ? Json(nullptr) : Json(sentence(n.found->excluded));
    }
    for (const auto& [key, values] :
         {std::pair{"where", &n.node.where}, std::pair{"sample", &n.node.sample}})
      for (const auto& [name, value] : *values)
        j[key][name] = value;
    j["seconds"] = n.seconds;
    nodes.push_back(std::move(j));
  }
  const auto files = mapped<Json>(t.files, [&](const InputFile& f) {
    return Json{{"name", f.name},
                {"sha256", f.sha256},
                {"assumed", f.assumed},
                {"setting", mapped<Json>(f.setting, labelled)}};
  });
  const Json all{{"format", "kovacic-proof/1"},
                 {"title", t.theorem.title},
                 {"statement", t.statement()},
                 {"remark", t.theorem.statement},
                 {"complete", t.complete()},
                 {"conclusion", t.conclusion()},
                 {"verdict", t.verdict()},
                 {"proved", t.count(NodeStatus::proved)},
                 {"open", t.count(NodeStatus::open)},
                 {"refuted", t.count(NodeStatus::refuted)},
                 {"arguments", t.count(NodeStatus::reasoned)},
                 {"unbound", t.count(NodeStatus::unbound)},
                 {"trusted", names(t.uses())},
                 {"trusted_steps", t.trusted_steps()},
                 {"unchecked_hypotheses", t.unchecked_hypotheses()},
                 {"identities", t.identities()},
                 {"certificates", t.certificates()},
                 {"nodes", nodes},
                 {"files", files},
                 {"seconds", t.seconds}};
  return all.dump(2) + "\n";
}

} // namespace kov::report
