#include "theorem/theorem.hpp"

#include "symbol/suggest.hpp"

#include <algorithm>
#include <functional>
#include <set>

namespace kov {
namespace {

const std::map<std::string, NodeKind>& kinds() {
  static const std::map<std::string, NodeKind> names{{"claims", NodeKind::claims},
                                                     {"case", NodeKind::case_file},
                                                     {"splitting", NodeKind::splitting},
                                                     {"scaling", NodeKind::scaling},
                                                     {"lowest-order", NodeKind::lowest_order},
                                                     {"theorem", NodeKind::theorem},
                                                     {"argument", NodeKind::argument}};
  return names;
}

NodeKind kind_of(const Entry& e) {
  const auto it = kinds().find(e.string());
  if (it != kinds().end()) return it->second;
  std::vector<std::string> known;
  for (const auto& [name, kind] : kinds())
    known.push_back(name);
  const auto near = nearest(e.string(), known);
  throw e.error("unknown kind '" + e.string() + "'",
                near ? "did you mean " + *near + "?" : "kinds: " + enumerate(known));
}

std::string text_of(const Entry& e, std::string_view key) {
  const Entry* found = e.find(key);
  return found ? found->string() : "";
}

std::vector<std::string> texts_of(const Entry& e, std::string_view key) {
  const Entry* found = e.find(key);
  return found ? found->strings() : std::vector<std::string>{};
}

ParameterValues read_values(const Entry& e, std::string_view key) {
  ParameterValues values;
  if (const Entry* table = e.find(key))
    for (const auto& [name, value] : table->members())
      values.emplace_back(name, value.string());
  return values;
}

Hypothesis read_hypothesis(const Entry& e) {
  e.check_keys({"text", "by"});
  return {e.at("text").string(), text_of(e, "by"), false};
}

TheoremNode read_node(const Entry& e) {
  e.check_keys({"id", "title", "statement", "note", "kind", "needs", "cite", "hypotheses", "file",
                "other", "where", "manifold", "expect", "small", "families", "triangle", "scaled",
                "sample"});
  TheoremNode n;
  n.id = e.at("id").string();
  n.title = text_of(e, "title");
  n.statement = e.at("statement").string();
  n.note = text_of(e, "note");
  n.kind = kind_of(e.at("kind"));
  n.needs = texts_of(e, "needs");
  n.cite = texts_of(e, "cite");
  n.file = text_of(e, "file");
  n.other = text_of(e, "other");
  n.manifold = text_of(e, "manifold");
  if (const Entry* x = e.find("expect")) {
    n.expect = x->string();
    const std::vector<std::string> known{"non-integrable", "no-obstruction", "depends", "any"};
    if (std::find(known.begin(), known.end(), n.expect) == known.end())
      throw x->error("'" + n.expect + "' is no verdict that a proof may end in",
                     "one of " + enumerate(known));
  }
  n.small = texts_of(e, "small");
  n.scaled = texts_of(e, "scaled");
  if (const Entry* families = e.find("families"))
    for (const Entry* f : families->list()) { // another node has to prove what is left to it
      f->check_keys({"family", "by"});
      n.families.push_back(f->at("family").string());
      n.needs.push_back(f->at("by").string());
    }
  if (const Entry* t = e.find("triangle")) n.triangle = t->boolean();
  n.where = read_values(e, "where");
  n.sample = read_values(e, "sample");
  if (const Entry* h = e.find("hypotheses"))
    for (const Entry* one : h->list())
      n.hypotheses.push_back(read_hypothesis(*one));
  n.line = e.line();
  const bool computes = n.kind != NodeKind::theorem && n.kind != NodeKind::argument;
  if (computes && n.file.empty()) throw e.error("this kind of node needs a file");
  return n;
}

void check_references(const Theorem& t, const Entry& document) {
  std::map<std::string, const TheoremNode*> by_id;
  for (const TheoremNode& n : t.nodes)
    if (!by_id.emplace(n.id, &n).second)
      throw document.error("the id '" + n.id + "' is used twice");
  std::vector<std::string> ids;
  for (const auto& [id, n] : by_id)
    ids.push_back(id);
  const auto known = [&](const std::string& id, const TheoremNode& n) {
    if (by_id.contains(id)) return;
    const auto near = nearest(id, ids);
    throw document.error("node '" + n.id + "' refers to '" + id + "', which is not there",
                         near ? "did you mean " + *near + "?" : "");
  };
  for (const TheoremNode& n : t.nodes) {
    for (const std::string& id : n.needs)
      known(id, n);
    for (const Hypothesis& h : n.hypotheses)
      if (!h.by.empty()) known(h.by, n);
  }
  std::set<std::string> open, done;
  const std::function<void(const TheoremNode&)> visit = [&](const TheoremNode& n) {
    if (done.contains(n.id)) return;
    if (!open.insert(n.id).second)
      throw document.error("node '" + n.id + "' rests on itself: a circle of needs");
    for (const std::string& id : n.needs)
      visit(*by_id.at(id));
    open.erase(n.id);
    done.insert(n.id);
  };
  for (const TheoremNode& n : t.nodes)
    visit(n);
}

} // namespace

std::string to_string(NodeKind k) {
  for (const auto& [name, kind] : kinds())
    if (kind == k) return name;
  return "";
}

std::string to_string(NodeStatus s) {
  switch (s) {
  case NodeStatus::proved:
    return "proved";
  case NodeStatus::trusted:
    return "trusted";
  case NodeStatus::reasoned:
    return "reasoned";
  case NodeStatus::refuted:
    return "refuted";
  default:
    return "open";
  }
}

bool is_theorem_document(const Entry& document) {
  const Entry* format = document.find("format");
  return format && format->kind() == Entry::Kind::string &&
         format->string().starts_with("theorem/");
}

Theorem read_theorem(const Entry& document) {
  document.check_keys({"format", "title", "statement", "cite", "node"});
  if (!is_theorem_document(document))
    throw document.error("a theorem file begins with format = \"theorem/1\"");
  if (document.at("format").string() != "theorem/1")
    throw document.at("format").error("this program reads format theorem/1");
  Theorem t;
  t.file = document.file();
  t.title = document.at("title").string();
  t.statement = document.at("statement").string();
  t.cite = texts_of(document, "cite");
  for (const Entry* e : document.at("node").list())
    t.nodes.push_back(read_node(*e));
  if (t.nodes.empty()) throw document.error("a theorem needs at least one [[node]]");
  check_references(t, document);
  return t;
}

} // namespace kov
