#include "present_strata.hpp"

#include "mechanics.hpp"
#include "present.hpp"
#include "recognized.hpp"
#include "render.hpp"
#include "strata/certificate.hpp"
#include "strata/words.hpp"

#include <algorithm>

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

// What the strata are a part of; the equations of algebraic constants are none.
Json assumed(const Assumptions& all, const Ring& ring) {
  Json list = Json::array();
  std::vector<std::size_t> ordered;
  for (const auto& c : all.conditions) {
    const auto used = used_variables(c.p);
    if (c.sign == Sign::positive || c.sign == Sign::nonnegative)
      ordered.insert(ordered.end(), used.begin(), used.end());
    list.push_back(to_string(c));
  }
  for (const auto& m : all.memberships)
    list.push_back(to_string(m.value) + (m.in_integers ? " is an integer" : " is no integer"));
  for (const std::size_t i : all.real)
    if (std::find(ordered.begin(), ordered.end(), i) == ordered.end()) {
      list.push_back(ring->name(i) + " is real");
      ordered.push_back(i);
    }
  return list;
}

} // namespace

void put_strata(Json& j, const strata::StrataAnswer& a) {
  if (a.question) j["assumed"] = assumed(a.question->assumptions, a.question->r.ring());
  Json all = Json::array();
  for (const auto& s : a.strata) {
    Json conditions = Json::array();
    for (const auto& c : s.conditions)
      conditions.push_back(to_string(c));
    Json one{{"conditions", conditions},
             {"abelian", word(s.leaf.abelian)},
             {"group", group_name(s.leaf)},
             {"group_text", strata::group_text(s.leaf)},
             {"reason", strata::reason(s.leaf)}};
    if (s.leaf.open) one["open"] = strata::open_condition(s.leaf);
    put_trace(one, s.leaf.trace);
    all.push_back(std::move(one));
  }
  j["strata"] = std::move(all);
  if (!a.unvisited.empty()) j["unvisited"] = a.unvisited;
  if (a.contradictory) j["contradictory"] = true;
  j["trusted"] = a.trusted;
}

void put_trace(Json& j, const std::vector<TraceStep>& trace) {
  for (const TraceStep& t : trace)
    j["trace"].push_back({{"step", t.step}, {"text", t.text}});
}

void print_trace(std::ostream& out, const Json& j) {
  if (!j.contains("trace")) return;
  out << "    steps\n";
  for (const Json& t : j.at("trace")) {
    const std::string step = t.at("step");
    out << "      " << step << "  " << wrapped(t.at("text").get<std::string>(), 8 + step.size())
        << "\n";
  }
}

void print_strata(std::ostream& out, const Json& j) {
  if (j.contains("contradictory")) line(out, "strata", "no parameters satisfy the assumptions");
  std::string given;
  for (const Json& c : j.value("assumed", Json::array()))
    given += (given.empty() ? "" : ", ") + c.get<std::string>();
  if (!given.empty()) line(out, "assumed", given);
  for (const Json& s : j.at("strata")) {
    std::string where;
    for (const Json& c : s.at("conditions"))
      where += (where.empty() ? "" : ", ") + c.get<std::string>();
    line(out, "stratum", where.empty() ? "always" : where);
    if (s.contains("no_equation")) {
      line(out, "none", "no equation y'' = r y: " + s.at("reason").get<std::string>(), 4);
      continue;
    }
    const std::string group = s.at("group_text");
    const std::string abelian = s.at("abelian");
    line(out, "group",
         (group.empty() ? "" : group + ", ") + std::string("identity component ") +
             (abelian == "yes"  ? "abelian"
              : abelian == "no" ? "not abelian"
                                : "abelian or not: undecided"),
         4);
    line(out, "because", s.at("reason"), 4);
    print_trace(out, s);
  }
  if (j.contains("unvisited"))
    for (const Json& u : j.at("unvisited"))
      line(out, "open", u);
  for (const Json& t : j.at("trusted"))
    line(out, "trusted", t);
}

namespace {

// Values of the parameters for which there is no equation: nothing is asked there.
void mark_no_equation(Json& j, const strata::StrataAnswer& a) {
  for (std::size_t i = 0; i < a.strata.size(); ++i)
    if (a.strata[i].leaf.no_equation()) {
      Json& s = j["strata"][i];
      s["no_equation"] = true;
      s["reason"] = strata::open_condition(a.strata[i].leaf);
      s.erase("open");
    }
}

// The strata on which something is asked.
std::vector<const strata::Stratum*> with_equation(const strata::StrataAnswer& a) {
  std::vector<const strata::Stratum*> all;
  for (const strata::Stratum& s : a.strata)
    if (!s.leaf.no_equation()) all.push_back(&s);
  return all;
}

// What holds on every stratum stands on top; the rest is in the list.
void put_common(Json& j, const strata::StrataAnswer& a) {
  const auto asked = with_equation(a);
  if (asked.empty()) return;
  const auto& first = asked.front()->leaf;
  const auto all = [&](auto same) { return std::all_of(asked.begin(), asked.end(), same); };
  if (a.unvisited.empty() &&
      all([&](const strata::Stratum* s) { return s->leaf.abelian == first.abelian; }))
    j["abelian"] = word(first.abelian);
  else if (a.unvisited.empty() &&
           all([](const strata::Stratum* s) { return s->leaf.abelian != Truth::unknown; }))
    j["abelian"] = "depends";
  const bool one_group =
      first.group && all([&](const strata::Stratum* s) { return s->leaf.group == first.group; });
  if (!one_group || !a.unvisited.empty()) return;
  j["group"] = group_json(*first.group);
  j["identity_component"] = to_string(identity_component(*first.group));
  j["case"] = kovacic_case(*first.group);
}

} // namespace

Json family_result(const Json& id, const ParametricEquation& f, const strata::StrataAnswer& a) {
  Json j = unread_result(id);
  j["variable"] = f.variable;
  j["r"] = to_string_by_powers(f.question.r, f.question.z);
  put_strata(j, a);
  j["seconds"] = a.seconds;
  if (a.contradictory) {
    set_undecided(j, "parameter", "no parameters satisfy the assumptions");
    return j;
  }
  mark_no_equation(j, a);
  put_common(j, a);
  std::string open;
  for (const auto& s : a.strata)
    if (s.leaf.abelian == Truth::unknown && !s.leaf.no_equation() && open.empty())
      open = (s.conditions.empty() ? "" : "where " + to_string(s.conditions) + ": ") +
             strata::open_condition(s.leaf);
  if (with_equation(a).empty() && a.unvisited.empty())
    open =
        a.strata.empty() ? "nothing was looked at" : strata::open_condition(a.strata.front().leaf);
  if (open.empty() && !a.unvisited.empty()) open = "not looked at: " + a.unvisited.front();
  if (!a.refusal.empty()) {
    j["refused_by_checker"] = a.certificate->json;
    set_undecided(j, name_of(Unable::Why::methods_disagree), open);
    return j;
  }
  if (!open.empty()) {
    set_undecided(j, "parameter", open);
    return j;
  }
  j["reason"] = a.strata.size() == 1
                    ? strata::reason(a.strata.front().leaf)
                    : "decided on each of " + std::to_string(a.strata.size()) + " strata";
  return j;
}

} // namespace kov::cli
