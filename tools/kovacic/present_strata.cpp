#include "present_strata.hpp"

#include "mechanics.hpp"
#include "present.hpp"
#include "render.hpp"

namespace kov::cli {
namespace {

const char* word(Truth t) { return t == Truth::yes ? "yes" : t == Truth::no ? "no" : "undecided"; }

void line(std::ostream& out, const std::string& label, const std::string& text,
          std::size_t indent = 2) {
  out << std::string(indent, ' ') << label
      << std::string(label.size() < 10 ? 10 - label.size() : 1, ' ') << wrapped(text, indent + 10)
      << "\n";
}

Json group_name(const strata::Leaf& leaf) {
  if (!leaf.group) return nullptr;
  return to_string(leaf.group->type) + (leaf.group->n ? "_" + to_string(*leaf.group->n) : "");
}

} // namespace

void put_strata(Json& j, const strata::StrataAnswer& a) {
  Json all = Json::array();
  for (const auto& s : a.strata) {
    Json conditions = Json::array();
    for (const auto& c : s.conditions)
      conditions.push_back(strata::to_string(c));
    Json one{{"conditions", conditions},
             {"abelian", word(s.leaf.abelian)},
             {"group", group_name(s.leaf)},
             {"group_text", s.leaf.group_text},
             {"reason", s.leaf.reason}};
    if (!s.leaf.open_condition.empty()) one["open"] = s.leaf.open_condition;
    all.push_back(std::move(one));
  }
  j["strata"] = std::move(all);
  if (!a.unvisited.empty()) j["unvisited"] = a.unvisited;
  if (a.contradictory) j["contradictory"] = true;
  j["trusted"] = a.trusted;
}

void put_strata(std::ostream& out, const strata::StrataAnswer& a) {
  if (a.contradictory) line(out, "strata", "no parameters satisfy the assumptions");
  for (const auto& s : a.strata) {
    line(out, "stratum", strata::to_string(s.conditions));
    line(out, "group",
         (s.leaf.group_text.empty() ? "" : s.leaf.group_text + ", ") +
             (s.leaf.abelian == Truth::yes  ? "identity component abelian"
              : s.leaf.abelian == Truth::no ? "identity component not abelian"
                                            : "identity component abelian or not: undecided"),
         4);
    line(out, "because", s.leaf.reason, 4);
  }
  for (const auto& u : a.unvisited)
    line(out, "open", u);
  for (const auto& t : a.trusted)
    line(out, "trusted", t);
}

} // namespace kov::cli
