#include "proofs/verify_explain.hpp"

#include "certify/equation/statement.hpp"
#include "certify/theorem/fact.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "symbol/document.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace kov::cli {

extern const char* const rules_text; // rules_text.cpp.in

namespace {

using certify::CheckedStep;

constexpr std::size_t longest_formula = 400;

const Entry& table() {
  static const Entry all = parse_document(rules_text, "rules.toml");
  return all;
}
const Entry& row(const std::string& format, const std::string& key, const std::string& rule) {
  return table().at("rule").at(format).at(key).at(rule);
}
// The rows of `conclude` have their page and their functions from it.
std::string entry(const CheckedStep& s, const char* what) {
  if (const Entry* e = row(s.format, s.key, s.rule).find(what)) return e->string();
  const Entry* of_rule =
      s.key == "theorem" ? row(s.format, "rule", "conclude").find(what) : nullptr;
  return of_rule != nullptr ? of_rule->string() : "";
}

std::string cut(const std::string& text) {
  return text.size() <= longest_formula ? text : text.substr(0, longest_formula) + " ...";
}

// With the nodes of trees, which a file of this format may have.
std::vector<CheckedStep> with_nodes(const std::vector<CheckedStep>& steps) {
  std::vector<CheckedStep> all = steps;
  for (const auto& [format, keys] : table().at("rule").members())
    for (const char* key : {"node", "zero"})
      if (const Entry* rows = keys.find(key);
          rows &&
          std::ranges::any_of(steps, [&, of = &format](const auto& s) { return s.format == *of; }))
        for (const auto& [name, row] : rows->members())
          all.push_back({format, key, name});
  return all;
}

std::string lines_of_judge(const std::vector<CheckedStep>& steps) {
  std::set<std::string> folders;
  for (const CheckedStep& s : steps)
    folders.insert(entry(s, "cpp").substr(0, entry(s, "cpp").find('/')));
  folders.erase("proof"); // of which all is counted
  long lines = table().at("lines").at("proof").integer();
  for (const std::string& folder : folders)
    lines += table().at("lines").at(folder).integer();
  return std::to_string(lines) + " lines of C++ in lib/proof and lib/certify (" +
         joined(std::vector<std::string>(folders.begin(), folders.end())) + "), over lib/exact (" +
         std::to_string(table().at("lines").at("exact").integer()) +
         " lines), FLINT, nlohmann-json, the compiler and the machine";
}

std::string rules_by_page(const std::vector<CheckedStep>& steps) {
  std::vector<std::pair<std::string, std::vector<std::string>>> pages;
  for (const CheckedStep& s : steps) {
    const std::string page = entry(s, "page");
    auto at = std::ranges::find_if(pages, [&](const auto& p) { return p.first == page; });
    if (at == pages.end()) at = pages.insert(pages.end(), {page, {}});
    add_once(at->second, s.rule);
  }
  std::vector<std::string> said;
  for (const auto& [page, rules] : pages)
    said.push_back(page + ": " + joined(rules));
  return joined(said, "; ");
}

std::string literature_of(const std::vector<std::string>& theorems) {
  std::vector<std::string> said;
  for (const certify::NamedTheorem& t : certify::named_theorems()) {
    if (!is_among(t.id, theorems)) continue;
    std::vector<std::string> hypotheses;
    for (const auto& [how, what] : t.hypotheses)
      hypotheses.push_back(what + " (" + how + ")");
    said.push_back(t.title + ", if " + joined(hypotheses, ", if "));
  }
  return said.empty() ? "the theorems that these pages cite" : joined(said, "; ");
}

} // namespace

std::vector<std::string> explained(const std::vector<CheckedStep>& steps) {
  std::vector<std::string> lines;
  std::map<std::string, std::size_t> first;
  std::size_t number = 0;
  for (const CheckedStep& s : steps) {
    const std::size_t before =
        first.emplace(s.format + " " + s.key + " " + s.rule, ++number).first->second;
    const std::string indent(2 * s.inside, ' ');
    std::vector<std::string> of;
    for (const std::string& id : s.of)
      of.push_back(certify::quoted(id));
    lines.push_back(
        indent + std::to_string(number) + ". " +
        (s.id.empty() ? "" : certify::quoted(s.id) + " by ") + s.rule +
        (before == number ? " (" + entry(s, "page") + ")" : ", as in " + std::to_string(before)) +
        (of.empty() ? "" : ", from " + joined(of)));
    if (before == number) {
      lines.push_back(indent + "   so " + entry(s, "says"));
      lines.push_back(indent + "   checked " + entry(s, "checked"));
    }
    if (!s.found.empty()) lines.push_back(indent + "   here " + cut(s.found));
  }
  return lines;
}

std::vector<std::string> needed(const std::vector<CheckedStep>& steps,
                                const std::vector<std::string>& theorems, std::size_t trusted,
                                const std::string& limits) {
  const auto all = with_nodes(steps);
  const std::string on_trust = trusted == 0 ? "nothing"
                                            : std::to_string(trusted) +
                                                  (trusted == 1 ? " sentence" : " sentences") +
                                                  ", which the statement quotes";
  return {"judge       " + lines_of_judge(all), "rules       " + rules_by_page(all),
          "literature  " + literature_of(theorems), "on trust    " + on_trust,
          "limits      " + limits};
}

} // namespace kov::cli
