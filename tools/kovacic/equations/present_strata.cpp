#include "equations/present_strata.hpp"

#include "answer/notation.hpp"
#include "decide/words.hpp"
#include "equations/present.hpp"
#include "equations/recognized.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "output/render.hpp"
#include "strata/certificate.hpp"
#include "strata/domain.hpp"
#include "strata/parametric_basis.hpp"
#include "strata/words.hpp"
#include "systems/mechanics.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

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

// A condition, and what holds where it does not; "" where the format has no words for that.
struct ToldCondition {
  std::string text, contrary;
};
std::vector<ToldCondition> told_conditions(const strata::Stratum& s) {
  std::vector<ToldCondition> all;
  for (const Condition& c : s.conditions) {
    const bool is_zero = c.sign == Sign::zero;
    const bool has_contrary = is_zero || c.sign == Sign::nonzero;
    all.push_back({to_string(c),
                   has_contrary ? to_string(Condition{c.p, is_zero ? Sign::nonzero : Sign::zero})
                                : std::string()});
  }
  for (const ArithmeticCondition& c : s.arithmetic)
    all.push_back({to_string(c), to_string(ArithmeticCondition{c.statement, !c.holds})});
  return all;
}

// "a = 0 or n is an integer" of the stratum where a != 0 and n is not.
std::string elsewhere(const strata::Stratum& s) {
  const auto all = told_conditions(s);
  if (std::ranges::any_of(all, [](const ToldCondition& c) { return c.contrary.empty(); }))
    return "";
  return joined(
      all, [](const ToldCondition& c) { return c.contrary; }, ", or ");
}

// Two sets that differ by a condition and its contrary are one without it.
std::optional<std::vector<ToldCondition>> united(const std::vector<ToldCondition>& a,
                                                 const std::vector<ToldCondition>& b) {
  const auto is_in = [](const std::vector<ToldCondition>& all, const std::string& text) {
    return std::ranges::count(all, text, &ToldCondition::text) > 0;
  };
  std::vector<ToldCondition> both;
  std::ranges::copy_if(a, std::back_inserter(both),
                       [&](const ToldCondition& c) { return is_in(b, c.text); });
  if (a.size() != b.size() || both.size() + 1 != a.size()) return std::nullopt;
  for (const ToldCondition& c : a)
    if (!is_in(b, c.text) && is_in(b, c.contrary)) return both;
  return std::nullopt;
}

// The sets with a Liouvillian solution, in few words; "" where that is not known of all, or so on all or none.
std::string where_liouvillian(const std::vector<strata::Stratum>& strata) {
  std::vector<std::vector<ToldCondition>> sets;
  for (const strata::Stratum& s : strata) {
    if (s.leaf.abelian != Truth::yes && !s.leaf.group) return "";
    if (s.leaf.abelian == Truth::yes || to_string(s.leaf.group->type) != "SL2")
      sets.push_back(told_conditions(s));
  }
  if (sets.size() == strata.size()) return "";
  for (std::size_t i = 0; i < sets.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (auto one = united(sets[i], sets[j])) {
        sets[j] = *std::move(one);
        sets.erase(sets.begin() + static_cast<long>(i));
        i = 0; // all once more
        break;
      }
  return joined(
      sets,
      [](const auto& set) {
        return joined(
            set, [](const auto& c) { return c.text; }, " and ");
      },
      "; or ");
}

long equations(const strata::Stratum& s) {
  return std::ranges::count_if(s.conditions,
                               [](const Condition& c) { return c.sign == Sign::zero; });
}

// The general ones have the fewest equations between parameters.
long fewest_equations(const strata::StrataAnswer& a) {
  long fewest = 0;
  for (const auto& s : a.strata)
    fewest = &s == &a.strata.front() ? equations(s) : std::min(fewest, equations(s));
  return fewest;
}

} // namespace

void put_strata(Json& j, const strata::StrataAnswer& a) {
  if (a.question) j["assumed"] = in_words(a.question->assumptions, a.question->r.ring());
  Json all = Json::array();
  const long general = fewest_equations(a);
  for (const auto& s : a.told_apart()) {
    Json one{{"conditions", strata::condition_texts(s)},
             {"abelian", word(s.leaf.abelian)},
             {"group", group_name(s.leaf)},
             {"group_text", strata::group_text(s.leaf)},
             {"reason", strata::reason(s.leaf)},
             {"generic", equations(s) == general}};
    if (std::string brief = strata::reason_in_brief(s.leaf); brief != one.at("reason"))
      one["brief"] = std::move(brief);
    if (s.leaf.open) one["open"] = strata::open_condition(s.leaf);
    if (std::string others = elsewhere(s); !others.empty()) one["elsewhere"] = std::move(others);
    put_trace(one, s.leaf.trace);
    all.push_back(std::move(one));
  }
  j["strata"] = std::move(all);
  if (std::string where = where_liouvillian(a.told_apart()); !where.empty())
    j["liouvillian_where"] = std::move(where);
  if (!a.unvisited.empty()) j["unvisited"] = a.unvisited;
  if (a.contradictory) j["contradictory"] = true;
  j["trusted"] = sentences(a.trusted);
}

void put_trace(Json& j, const kovacic::Trace& trace) {
  for (const kovacic::Step& t : trace)
    j["trace"].push_back({{"step", name(t)}, {"text", t.text}});
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

namespace {

std::string where(const Json& stratum) {
  const std::string text =
      joined(stratum.at("conditions").get<std::vector<std::string>>(), ", ", " and ");
  return text.empty() ? "all parameter values" : text;
}

std::string answer(const Json& stratum) {
  const std::string group = stratum.at("group_text"), abelian = stratum.at("abelian");
  return (group.empty() ? "" : group + ", ") + std::string("identity component ") +
         (abelian == "yes"  ? "abelian"
          : abelian == "no" ? "not abelian"
                            : "abelian or not: undecided");
}

void print_solutions(std::ostream& out, const Json& s, const std::string& on, const std::string& y);

void print_whole(std::ostream& out, const Json& s, const std::string& y) {
  line(out, "stratum", where(s));
  if (s.contains("equation")) line(out, "equation", s.at("equation"), 4);
  line(out, "group", answer(s), 4);
  line(out, "because", s.at("reason"), 4);
  if (s.contains("solutions")) print_solutions(out, s, "", y);
  print_trace(out, s);
}

// Strata with the same answer.
struct SameAnswer {
  std::vector<const Json*> strata;
  [[nodiscard]] const Json& first() const { return *strata.front(); }
  [[nodiscard]] bool generic() const { return first().value("generic", false); } // general
  // Those for which something holds that must be looked at come first.
  [[nodiscard]] int rank() const {
    const std::string abelian = first().at("abelian");
    return abelian == "undecided" ? 0 : abelian == "yes" ? 1 : 2;
  }
};

std::vector<SameAnswer> alike(const Json& strata) {
  std::vector<SameAnswer> all;
  for (const Json& s : strata) {
    const auto same = [&](const SameAnswer& a) {
      return answer(a.first()) == answer(s) &&
             a.first().contains("equation") == s.contains("equation") &&
             (s.at("abelian") != "undecided" || a.first().at("reason") == s.at("reason"));
    };
    auto it = std::ranges::find_if(all, same);
    if (it == all.end()) it = all.insert(all.end(), SameAnswer{});
    it->strata.push_back(&s);
  }
  for (SameAnswer& a : all) // the reason of the general one stands for all
    std::stable_partition(a.strata.begin(), a.strata.end(),
                          [](const Json* s) { return s->value("generic", false); });
  return all;
}

constexpr std::size_t short_condition = 40;  // characters
constexpr std::size_t long_conditions = 240; // no more are named

// "C = A; or C = 2*A", some of them.
std::string where_any(const SameAnswer& a) {
  std::string text;
  std::size_t named = 0;
  for (; named < a.strata.size() && text.size() < long_conditions; ++named)
    text += (named == 0 ? "" : "; or ") + where(*a.strata[named]);
  const std::size_t more = a.strata.size() - named;
  return text + (more == 0   ? ""
                 : more == 1 ? "; or on 1 more stratum (--verbose)"
                             : "; or on " + std::to_string(more) + " more strata (--verbose)");
}

void print_solutions(std::ostream& out, const SameAnswer& a, const std::string& y,
                     const Json& shown);

// shown: solutions that stand above.
void print_alike(std::ostream& out, const SameAnswer& a, const std::string& elsewhere,
                 const std::string& y, const Json& shown) {
  const Json& s = a.first();
  line(out, "stratum", elsewhere.empty() ? where_any(a) : elsewhere);
  const std::string reason = s.contains("brief") ? s.at("brief") : s.at("reason");
  std::string last;
  for (const Json* x : a.strata)
    if (x->contains("equation") && x->at("equation") != last) {
      last = x->at("equation");
      line(out, "equation", last + (a.strata.size() > 1 ? "   where " + where(*x) : ""), 4);
    }
  line(out, "group", answer(s), 4);
  const auto others = std::ranges::count_if(
      a.strata, [&](const Json* x) { return x->at("reason") != s.at("reason"); });
  const std::string here = others == 0                 ? ""
                           : s.value("generic", false) ? "in general: "
                                                       : "where " + where(s) + ": ";
  line(out, "because", here + reason, 4);
  if (others > 0)
    line(out, "",
         others == 1
             ? "on another stratum for another reason (--verbose)"
             : "on " + std::to_string(others) + " more strata for reasons of their own (--verbose)",
         4);
  print_solutions(out, a, y, shown);
}

// y1, y2 under their conditions; "" for none.
void print_solutions(std::ostream& out, const Json& s, const std::string& on,
                     const std::string& unknown) {
  for (const Json& part : s.at("solutions")) {
    const std::string conditions = listed(part.at("where"));
    const std::string here = on + (on.empty() || conditions.empty() ? "" : ", ") + conditions;
    const Json& y = part.at("y");
    for (std::size_t i = 0; i < y.size(); ++i)
      line(out, i == 0 ? "solutions" : "",
           unknown + std::to_string(i + 1) + " = " + y[i].get<std::string>() +
               (i == 0 && !here.empty() ? "   where " + here : ""),
           4);
  }
}

// Those of strata with one answer: their own conditions where the formulas differ.
void print_solutions(std::ostream& out, const SameAnswer& a, const std::string& y,
                     const Json& shown) {
  std::vector<const Json*> told;
  for (const Json* s : a.strata) {
    if (!s->contains("solutions") || s->at("solutions")[0].at("y") == shown) continue;
    const bool known = std::ranges::any_of(
        told, [&](const Json* x) { return x->at("solutions") == s->at("solutions"); });
    if (!known) told.push_back(s);
  }
  const bool all =
      std::ranges::all_of(a.strata, [](const Json* s) { return s->contains("solutions"); });
  constexpr std::size_t most = 6;
  for (std::size_t i = 0; i < told.size() && i < most; ++i)
    print_solutions(out, *told[i], all && told.size() == 1 ? "" : where(*told[i]), y);
  if (told.size() > most)
    line(out, "", "on " + std::to_string(told.size() - most) + " more strata (--verbose)", 4);
}

bool is_short(const SameAnswer& a) {
  return a.strata.size() == 1 && where(a.first()).size() <= short_condition;
}

// Equal answers together; where that is not short the last of them is that of all other parameters.
void print_in_brief(std::ostream& out, const Json& j, const std::string& y) {
  auto all = alike(j.at("strata"));
  const bool rest = !std::ranges::all_of(all, is_short) && !j.contains("unvisited");
  if (rest)
    std::ranges::stable_sort(
        all, [](const SameAnswer& a, const SameAnswer& b) { return a.rank() < b.rank(); });
  // an answer about one equation is read on one page
  const long most_lines = j.contains("equation") ? 24 : std::numeric_limits<long>::max();
  long lines = 0;
  std::size_t left_out = 0;
  for (const SameAnswer& a : all) {
    const bool last = rest && &a == &all.back() && a.generic() && !is_short(a);
    std::ostringstream text;
    print_alike(text, a,
                !last             ? ""
                : all.size() == 1 ? "all parameter values"
                                  : "elsewhere",
                y, j.value("answer", Json::object()).value("y", Json::array()));
    const std::string s = text.str();
    lines += std::ranges::count(s, '\n');
    if (&a != &all.front() && lines > most_lines)
      ++left_out;
    else
      out << s;
  }
  if (left_out > 0)
    line(out, "more",
         std::to_string(left_out) + (left_out == 1 ? " more case" : " more cases") + ": --verbose");
}

} // namespace

void print_strata(std::ostream& out, const Json& j, bool whole) {
  if (j.contains("contradictory")) line(out, "strata", "no parameters satisfy the assumptions");
  const std::string given = listed(j.value("assumed", Json::array()));
  if (!given.empty()) line(out, "assumed", given);
  if (j.contains("domain"))
    line(out, "domain",
         listed(j.at("domain")) +
             (j.contains("given") && j.at("given").contains("substitution")
                  ? "; for other values there is no linear equation of the second order"
                  : "; for other values there is no equation"));
  if (j.contains("no_equation")) line(out, "none", j.at("no_equation"));
  const std::string y = j.contains("variable") ? unknown_of(j) : "y";
  if (whole)
    for (const Json& s : j.at("strata"))
      print_whole(out, s, y);
  else
    print_in_brief(out, j, y);
  if (j.contains("unvisited"))
    for (const Json& u : j.at("unvisited"))
      line(out, "open", u);
  for (const Json& t : j.at("trusted"))
    line(out, "trusted", t);
}

void put_solutions_of_strata(Json& j, const answer::Given& given, const ParametricEquation& f,
                             const strata::StrataAnswer& all, const answer::Style& style,
                             const Budget& budget) {
  const answer::FamilySolutions found = answer::solutions_of(given, f, all, style, budget);
  for (std::size_t i = 0; i < found.on_strata.size() && i < j.at("strata").size(); ++i)
    for (const answer::Solutions& here : found.on_strata[i]) {
      Json one{{"where", here.where}, {"y", Json::array()}};
      for (const Expression& y : here.y)
        one["y"].push_back(answer::for_people(y));
      if (!here.y.empty()) j["strata"][i]["solutions"].push_back(std::move(one));
      for (const std::string& text : here.failed)
        j["failed"].push_back(text);
    }
  put_answer(j, found.general);
}

namespace {

std::string where(const strata::Stratum& s) {
  std::string text;
  for (const std::string& c : strata::condition_texts(s))
    text += (text.empty() ? "where " : ", ") + c;
  return text.empty() ? "" : text + ": ";
}

// What holds on every stratum stands on top; the rest is in the list.
void put_common(Json& j, const strata::StrataAnswer& a) {
  const auto asked = a.told_apart();
  if (asked.empty()) return;
  const auto& first = asked.front().leaf;
  const auto all = [&](auto same) { return std::ranges::all_of(asked, same); };
  if (a.unvisited.empty() &&
      all([&](const strata::Stratum& s) { return s.leaf.abelian == first.abelian; }))
    j["abelian"] = word(first.abelian);
  else if (a.unvisited.empty() &&
           all([](const strata::Stratum& s) { return s.leaf.abelian != Truth::unknown; }))
    j["abelian"] = "depends";
  const bool one_group =
      first.group && all([&](const strata::Stratum& s) { return s.leaf.group == first.group; });
  if (!one_group || !a.unvisited.empty()) return;
  j["group"] = group_json(*first.group);
  j["identity_component"] = to_string(identity_component(*first.group));
  j["case"] = kovacic_case(*first.group);
}

} // namespace

namespace {

// exp(-1/2 int p), for all parameters: closed where that needs no condition.
std::string factor_of(const ParametricEquation& f, const Budget& budget) {
  if (is_zero(f.p)) return "1";
  const Ring& ring = f.question.r.ring();
  const strata::Question zero{
      .r = MFraction(ring), .z = f.question.z, .assumptions = {}, .generic = {}};
  const auto found = strata::solutions_on(zero, f.gauge, {}, Region(ring, {}), budget);
  if (found.size() == 1 && found.front().zero.empty() && found.front().nonzero.empty())
    return found.front().y.front();
  return "exp(-1/2*int(" + to_string_by_powers(f.p, f.question.z) + ", " + f.variable + "))";
}

void put_original_form(Json& j, const ParametricEquation& f) {
  if (f.form == GivenEquation::Form::r) return;
  j["original"] = {{"form", f.form == GivenEquation::Form::pq ? "p, q" : "equation"},
                   {"p", to_string_by_powers(f.p, f.question.z)},
                   {"q", to_string_by_powers(f.q, f.question.z)},
                   {"factor", factor_of(f, Budget{})}};
}

// y'' + p y' + q y = 0 with what is assumed put into it.
Json equation_there(const ParametricEquation& f) {
  Region region(f.question.r.ring(), f.question.assumptions);
  for (std::size_t i = f.question.assumptions.conditions.size(); i > 0 && region.pending(); --i) {
    const auto parts = irreducible_parts(*region.pending());
    if (parts.size() != 1) break;
    auto there = region.where_zero(parts.front());
    if (!std::holds_alternative<Region>(there)) break;
    region = std::get<Region>(std::move(there));
  }
  Json j{{"variable", f.variable}, {"r", nullptr}};
  try {
    const auto text = [&](const MFraction& c) {
      return to_string_by_powers(region.restrict(c), f.question.z);
    };
    j["r"] = text(-f.q);
    j["original"] = {{"p", text(f.p)}, {"q", text(f.q)}, {"factor", is_zero(f.p) ? "1" : ""}};
  } catch (const DomainError&) { // it has no value there
  }
  return j;
}

} // namespace

Json family_result(const Json& id, const ParametricEquation& f, const strata::StrataAnswer& all) {
  Json j = unread_result(id);
  j["variable"] = f.variable;
  j["r"] = to_string_by_powers(f.question.r, f.question.z);
  put_original_form(j, f);
  const strata::StrataAnswer a = strata::on_domain(all);
  put_strata(j, a);
  if (a.question) j["assumed"] = in_words(f.assumed, f.question.r.ring());
  if (const auto domain = in_words(strata::domain(all)); !domain.empty()) j["domain"] = domain;
  j["seconds"] = a.seconds;
  if (a.contradictory) {
    set_undecided(j, "parameter", "no parameters satisfy the assumptions");
    return j;
  }
  put_common(j, a);
  std::string open;
  for (const auto& s : a.told_apart())
    if (s.leaf.abelian == Truth::unknown && open.empty())
      open = where(s) + strata::open_condition(s.leaf);
  if (a.strata.empty() && a.unvisited.empty()) {
    open = all.strata.empty() ? "nothing was looked at"
                              : "there is no equation for any of these parameters: " +
                                    strata::open_condition(all.strata.front().leaf);
    j["no_equation"] = open;
  }
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
  const std::size_t n = j.at("strata").size();
  j["reason"] = n == 1 ? strata::reason(a.strata.front().leaf)
                       : "decided on each of " + std::to_string(n) + " strata";
  return j;
}

std::string in_words(const EquationPart& part) {
  std::string text;
  for (const auto& [here, elsewhere] : part.where)
    text += (text.empty() ? "" : ", ") + here;
  return text;
}

namespace {

bool contains(const std::vector<std::string>& all, const std::string& one) {
  return is_among(one, all);
}

/// Puts the results of parts into that of the first.
class Together {
public:
  Together(const std::vector<PartResult>& all, std::string unknown)
      : all_(all), unknown_(std::move(unknown)) {
    for (const PartResult& p : all_)
      if (!p.part.none.empty()) exclude(p.part);
    for (const PartResult& p : all_)
      if (!p.result.is_null()) take_domain(p);
  }

  Json operator()(bool whole) {
    Json j;
    for (const PartResult& p : all_)
      if (j.is_null() && !p.result.is_null()) j = p.result;
    if (j.is_null()) { // no equation anywhere
      j = unread_result(nullptr);
      j["trusted"] = Json::array();
      j["seconds"] = 0.0;
      const EquationPart& part = all_.front().part;
      j["no_equation"] = "where " + in_words(part) + ": " + part.none + part.open;
      j["reason"] = j.at("no_equation");
    }
    const Json first = j;
    j["strata"] = Json::array();
    for (const PartResult& p : all_)
      take(j, p, p.result == first);
    if (!whole) j["unvisited"].push_back("where " + all_.back().part.where.back().second);
    if (!domain_.empty()) j["domain"] = domain_;
    conclude(j, first);
    return j;
  }

private:
  // What is so elsewhere, unless nothing is there.
  [[nodiscard]] std::string or_elsewhere(const EquationPart& part, std::string text) const {
    for (const auto& [here, elsewhere] : part.where)
      if (!contains(domain_, here) && elsewhere != text)
        text += (text.empty() ? "" : " or ") + elsewhere;
    return text;
  }
  void exclude(const EquationPart& part) { domain_.push_back(or_elsewhere(part, {})); }
  void take_domain(const PartResult& p) {
    for (const Json& condition : p.result.value("domain", Json::array())) {
      const auto has = [&](const PartResult& x) {
        const Json other =
            x.result.is_null() ? Json::array() : x.result.value("domain", Json::array());
        return !x.part.none.empty() || is_among(condition, other);
      };
      const std::string text = condition;
      const std::string one = std::ranges::all_of(all_, has) ? text : or_elsewhere(p.part, text);
      if (!contains(domain_, one)) domain_.push_back(one);
    }
  }

  void take(Json& j, const PartResult& p, bool first) const {
    if (!p.part.none.empty()) return;
    Json where = Json::array();
    for (const auto& [here, elsewhere] : p.part.where)
      if (!contains(domain_, here)) where.push_back(here);
    if (p.result.is_null()) {
      j["strata"].push_back({{"conditions", where},
                             {"abelian", "undecided"},
                             {"group", nullptr},
                             {"group_text", ""},
                             {"reason", "another equation, which is not decided: " + p.part.open},
                             {"generic", false},
                             {"open", p.part.open}});
      return;
    }
    for (Json s : p.result.at("strata")) {
      Json conditions = where;
      for (const Json& c : s.at("conditions"))
        if (!is_among(c, where)) conditions.push_back(c);
      s["conditions"] = conditions;
      if (!first) {
        s["generic"] = false;
        s["equation"] = question_text(equation_there(*p.part.equation), unknown_);
        s["variable"] = p.part.equation->variable;
      }
      j["strata"].push_back(std::move(s));
    }
    if (first) return;
    for (const char* key : {"unvisited", "failed"})
      for (const Json& text : p.result.value(key, Json::array()))
        j[key].push_back("where " + listed(where) + ": " + text.get<std::string>());
    for (const Json& text : p.result.at("trusted"))
      if (!is_among(text, j.at("trusted"))) j["trusted"].push_back(text);
    j["seconds"] = j.at("seconds").get<double>() + p.result.at("seconds").get<double>();
  }

  static void conclude(Json& j, const Json& first) {
    const Json& strata = j.at("strata");
    const auto all = [&](const char* key) {
      return std::ranges::all_of(strata,
                                 [&](const Json& s) { return s.at(key) == strata[0].at(key); });
    };
    const Json* open = nullptr;
    for (const Json& s : strata)
      if (open == nullptr && s.at("abelian") == "undecided") open = &s;
    const bool whole = !j.contains("unvisited");
    j["abelian"] = !whole || strata.empty() ? Json("undecided")
                   : all("abelian")         ? strata[0].at("abelian")
                   : open == nullptr        ? Json("depends")
                                            : Json("undecided");
    if (!whole || strata.empty() || !all("group"))
      for (const char* key : {"group", "identity_component", "case"})
        j[key] = nullptr;
    j["undecided"] = nullptr;
    if (open != nullptr)
      set_undecided(j, "parameter",
                    "where " + listed(open->at("conditions")) + ": " +
                        open->value("open", open->at("reason").get<std::string>()));
    else if (!whole)
      set_undecided(j, "parameter", "not looked at: " + j.at("unvisited")[0].get<std::string>());
    else if (strata.empty())
      set_undecided(j, "parameter", first.at("reason"));
    else
      j["reason"] = "decided on each of " + std::to_string(strata.size()) + " strata";
  }

  const std::vector<PartResult>& all_;
  std::vector<std::string> domain_;
  std::string unknown_;
};

} // namespace

Json together(const std::vector<PartResult>& all, bool whole, const std::string& unknown) {
  if (all.size() == 1 && whole && !all.front().result.is_null()) return all.front().result;
  return Together(all, unknown)(whole);
}

} // namespace kov::cli
