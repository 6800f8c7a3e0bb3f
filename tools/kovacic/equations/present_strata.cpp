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

Json group_name(const strata::Leaf& leaf) {
  if (!leaf.group) return nullptr;
  return to_string(leaf.group->type) + (leaf.group->n ? "_" + to_string(*leaf.group->n) : "");
}

// "" where the format has no words for the contrary.
using ToldCondition = WithContrary;
std::vector<ToldCondition> told_conditions(const strata::Stratum& s) {
  std::vector<ToldCondition> all;
  for (const Condition& c : in_pairs(s.conditions)) {
    const bool is_zero = c.sign == Sign::zero;
    const bool has_contrary = is_zero || c.sign == Sign::nonzero;
    all.push_back({to_string(c),
                   has_contrary ? to_string(Condition{c.p, is_zero ? Sign::nonzero : Sign::zero})
                                : std::string()});
  }
  std::ranges::move(with_contraries(s.arithmetic), std::back_inserter(all));
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

struct ToldStratum {
  std::vector<ToldCondition> where;
  std::optional<bool> liouvillian{}; ///< there is such a solution; unset: not known
};
std::optional<bool> has_liouvillian(const strata::Leaf& leaf) {
  if (leaf.abelian == Truth::yes) return true;
  if (!leaf.group) return std::nullopt;
  return leaf.group->type != GroupType::SL2;
}

// The sets with a Liouvillian solution, in few words; "" where that is not known of all, or so on all or none.
std::string where_liouvillian(const std::vector<ToldStratum>& strata) {
  std::vector<std::vector<ToldCondition>> sets;
  for (const ToldStratum& s : strata) {
    if (!s.liouvillian) return "";
    if (*s.liouvillian) sets.push_back(s.where);
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

namespace {

Json stratum_json(const strata::Stratum& s, bool general) {
  Json one{{"conditions", strata::condition_texts(s)},
           {"abelian", word_of(s.leaf.abelian)},
           {"group", group_name(s.leaf)},
           {"group_text", strata::group_text(s.leaf)},
           {"reason", strata::reason(s.leaf)},
           {"generic", general}};
  if (std::string brief = strata::reason_in_brief(s.leaf); brief != one.at("reason"))
    one["brief"] = std::move(brief);
  if (s.leaf.open) one["open"] = strata::open_condition(s.leaf);
  if (std::string others = elsewhere(s); !others.empty()) one["elsewhere"] = std::move(others);
  put_trace(one, s.leaf.trace);
  return one;
}

} // namespace

void put_strata(Json& j, const strata::StrataAnswer& a) {
  if (a.question) j["assumed"] = in_words(a.question->assumptions, a.question->r.ring());
  const long general = fewest_equations(a);
  j["strata"] = list_of(a.told_apart(),
                        [&](const auto& s) { return stratum_json(s, equations(s) == general); });
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
  const std::string group = stratum.at("group_text");
  return (group.empty() ? "" : group + ", ") + "identity component " +
         whether_abelian(stratum.at("abelian"));
}

void print_solutions(std::ostream& out, const Json& s, const std::string& on, const std::string& y);

void print_whole(std::ostream& out, const Json& s, const std::string& y) {
  put(out, "stratum", where(s));
  if (s.contains("equation")) put(out, "equation", s.at("equation"), 4);
  put(out, "group", answer(s), 4);
  put(out, "because", s.at("reason"), 4);
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
  put(out, "stratum", elsewhere.empty() ? where_any(a) : elsewhere);
  const std::string reason = s.contains("brief") ? s.at("brief") : s.at("reason");
  std::string last;
  for (const Json* x : a.strata)
    if (x->contains("equation") && x->at("equation") != last) {
      last = x->at("equation");
      put(out, "equation", last + (a.strata.size() > 1 ? "   where " + where(*x) : ""), 4);
    }
  put(out, "group", answer(s), 4);
  const auto others = std::ranges::count_if(
      a.strata, [&](const Json* x) { return x->at("reason") != s.at("reason"); });
  const std::string here = others == 0                 ? ""
                           : s.value("generic", false) ? "in general: "
                                                       : "where " + where(s) + ": ";
  put(out, "because", here + reason, 4);
  if (others > 0)
    put(out, "",
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
      put(out, i == 0 ? "solutions" : "",
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
    put(out, "", "on " + std::to_string(told.size() - most) + " more strata (--verbose)", 4);
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
    put(out, "more",
        std::to_string(left_out) + (left_out == 1 ? " more case" : " more cases") + ": --verbose");
}

} // namespace

void print_strata(std::ostream& out, const Json& j, bool whole) {
  if (j.contains("contradictory")) put(out, "strata", "no parameters satisfy the assumptions");
  const std::string given = listed(j.value("assumed", Json::array()));
  if (!given.empty()) put(out, "assumed", given);
  if (j.contains("domain"))
    put(out, "domain",
        listed(j.at("domain")) +
            (j.contains("given") && j.at("given").contains("substitution")
                 ? "; for other values there is no linear equation of the second order"
                 : "; for other values there is no equation"));
  if (j.contains("no_equation")) put(out, "none", j.at("no_equation"));
  const std::string y = j.contains("variable") ? unknown_of(j) : "y";
  if (whole)
    for (const Json& s : j.at("strata"))
      print_whole(out, s, y);
  else
    print_in_brief(out, j, y);
  if (j.contains("unvisited"))
    for (const Json& u : j.at("unvisited"))
      put(out, "open", u);
  for (const Json& t : j.at("trusted"))
    put(out, "trusted", t);
}

namespace {

// exp(-1/2 int p), for all parameters: closed where that needs no condition.
std::string factor_of(const ParametricEquation& f, const Budget& budget) {
  if (is_zero(f.p)) return "1";
  const Ring& ring = f.question.r.ring();
  const strata::Question zero{
      .r = MFraction(ring), .z = f.question.z, .assumptions = {}, .generic = {}};
  const auto found = strata::solutions_on(zero, f.gauge, {}, ParametrisedSet(ring, {}), budget);
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
  ParametrisedSet region(f.question.r.ring(), f.question.assumptions);
  for (std::size_t i = f.question.assumptions.conditions.size(); i > 0 && region.pending(); --i) {
    const auto parts = irreducible_parts(*region.pending());
    if (parts.size() != 1) break;
    auto there = region.where_zero(parts.front());
    if (!std::holds_alternative<ParametrisedSet>(there)) break;
    region = std::get<ParametrisedSet>(std::move(there));
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

namespace {

using answer::Family;
using answer::FamilyPart;

// Conditions that hold wherever there is an equation: in all parts, or what is so in the others.
std::vector<std::string> domain_of(const Family& f) {
  std::vector<std::string> all;
  const auto of = [](const FamilyPart& p) {
    return p.answer ? in_words(strata::domain(*p.answer)) : std::vector<std::string>{};
  };
  const auto or_elsewhere = [&](const FamilyPart& p, std::string text) {
    for (const auto& [here, elsewhere] : p.part.where)
      if (!is_among(here, all) && elsewhere != text)
        text += (text.empty() ? "" : " or ") + elsewhere;
    return text;
  };
  for (const FamilyPart& p : f.parts)
    if (!p.part.none.empty()) all.push_back(or_elsewhere(p, {}));
  for (const FamilyPart& p : f.parts)
    for (const std::string& condition : of(p)) {
      const bool everywhere = std::ranges::all_of(f.parts, [&](const FamilyPart& x) {
        return !x.part.none.empty() || is_among(condition, of(x));
      });
      add_once(all, everywhere ? condition : or_elsewhere(p, condition));
    }
  return all;
}

// Two strata with one answer that differ by a sign, a = b and a = -b, are one.
void unite_up_to_sign(std::vector<strata::Stratum>& all, std::vector<Json>& answers) {
  for (std::size_t i = all.size(); i-- > 0;)
    for (std::size_t j = 0; j < i; ++j)
      if (answers[i] == answers[j] && all[i].arithmetic == all[j].arithmetic)
        if (auto both = up_to_sign(all[j].conditions, all[i].conditions)) {
          all[j].conditions = *std::move(both);
          all.erase(all.begin() + static_cast<long>(i));
          answers.erase(answers.begin() + static_cast<long>(i));
          break;
        }
}

// The strata of one part, which also go to `told`; first: its equation stands at the top.
void put_part(Json& j, const Family& f, const FamilyPart& p, const std::vector<std::string>& domain,
              bool first, const std::string& unknown, std::vector<ToldStratum>& told) {
  if (!p.part.none.empty()) return;
  const bool only = f.whole && f.parts.size() == 1 && p.answer; // the others are assumed away
  std::vector<std::string> where;
  std::vector<ToldCondition> of_part;
  for (const auto& [here, elsewhere] : p.part.where)
    if (!only && !is_among(here, domain)) {
      where.push_back(here);
      of_part.push_back({here, elsewhere});
    }
  if (!p.answer) {
    told.push_back({of_part});
    j["strata"].push_back({{"conditions", where},
                           {"abelian", "undecided"},
                           {"group", nullptr},
                           {"group_text", ""},
                           {"reason", "another equation, which is not decided: " + p.part.open},
                           {"generic", false},
                           {"open", p.part.open}});
    return;
  }
  const strata::StrataAnswer a = strata::on_domain(*p.answer);
  auto all = a.told_apart();
  const long general = fewest_equations(a);
  const std::string prefix = first ? "" : "where " + joined(where) + ": ";
  std::vector<Json> answers; // each without its conditions
  for (std::size_t i = 0; i < all.size(); ++i) {
    Json s = stratum_json(all[i], first && equations(all[i]) == general);
    for (const char* key : {"conditions", "elsewhere"})
      s.erase(key);
    if (!first) {
      s["equation"] = question_text(equation_there(*p.part.equation), unknown);
      s["variable"] = p.part.equation->variable;
    }
    if (p.solutions && i < p.solutions->on_strata.size())
      for (const answer::Solutions& here : p.solutions->on_strata[i]) {
        Json one{{"where", here.where}, {"y", Json::array()}};
        for (const Expression& y : here.y)
          one["y"].push_back(answer::for_people(y));
        if (!here.y.empty()) s["solutions"].push_back(std::move(one));
        for (const std::string& text : here.failed)
          j["failed"].push_back(prefix + text);
      }
    answers.push_back(std::move(s));
  }
  unite_up_to_sign(all, answers);
  for (std::size_t i = 0; i < all.size(); ++i) {
    Json& s = answers[i];
    std::vector<std::string> conditions = where;
    for (const std::string& c : strata::condition_texts(all[i]))
      add_once(conditions, c);
    s["conditions"] = conditions;
    if (std::string others = elsewhere(all[i]); !others.empty()) s["elsewhere"] = std::move(others);
    ToldStratum& one_told = told.emplace_back(of_part, has_liouvillian(all[i].leaf));
    for (const ToldCondition& c : told_conditions(all[i]))
      if (!is_among(c.text, where)) one_told.where.push_back(c);
    j["strata"].push_back(std::move(s));
  }
  if (!p.failed.empty()) j["failed"].push_back(prefix + p.failed);
  for (const std::string& text : a.unvisited)
    j["unvisited"].push_back(prefix + text);
  for (const Json& text : Json(sentences(a.trusted)))
    if (!is_among(text, j.at("trusted"))) j["trusted"].push_back(text);
  j["seconds"] = j.at("seconds").get<double>() + a.seconds;
}

// Why it is not decided for all parameters; "" where it is.
std::string open_text(const Json& j, const Family& f) {
  const Json& strata = j.at("strata");
  for (const Json& s : strata)
    if (s.at("abelian") == "undecided") {
      const std::string where = listed(s.at("conditions"));
      return (where.empty() ? "" : "where " + where + ": ") +
             s.value("open", s.at("reason").get<std::string>());
    }
  if (j.contains("unvisited")) return "not looked at: " + j.at("unvisited")[0].get<std::string>();
  if (!strata.empty()) return "";
  const FamilyPart& p = f.parts.front();
  if (!p.answer) return "where " + answer::in_words(p.part) + ": " + p.part.none;
  return p.answer->strata.empty() ? "nothing was looked at"
                                  : "there is no equation for any of these parameters: " +
                                        strata::open_condition(p.answer->strata.front().leaf);
}

// The verdict of all strata together.
void conclude(Json& j, const Family& f) {
  const Truth abelian = f.abelian();
  const auto group = f.group();
  std::string open = open_text(j, f);
  if (abelian != Truth::unknown || open.empty())
    j["abelian"] = abelian == Truth::unknown ? "depends" : word_of(abelian);
  if (group) {
    j["group"] = group_json(*group);
    j["identity_component"] = to_string(identity_component(*group));
    j["case"] = kovacic_case(*group);
    if (!open.empty()) // by a formula, where the strata are not decided
      j["reason"] = "for all values of the parameters: " + recognized_text(j.at("recognized"));
    if (!open.empty()) return;
  }
  if (j.at("strata").empty() && !j.contains("unvisited")) j["no_equation"] = open;
  if (!open.empty()) return set_undecided(j, "parameter", open);
  const std::size_t n = j.at("strata").size();
  j["reason"] = n == 1 ? j.at("strata")[0].at("reason").get<std::string>()
                       : "decided on each of " + std::to_string(n) + " strata";
}

} // namespace

Json family_result(const Json& id, const Family& f, const std::string& unknown) {
  Json j = unread_result(id);
  const auto first = std::ranges::find_if(f.parts, [](const FamilyPart& p) { return !!p.answer; });
  if (first != f.parts.end()) {
    const ParametricEquation& e = *first->part.equation;
    j["variable"] = e.variable;
    j["r"] = to_string_by_powers(e.question.r, e.question.z);
    put_original_form(j, e);
    j["assumed"] = in_words(e.assumed, e.question.r.ring());
  }
  if (f.known) j["recognized"] = symbolic_json(*f.known, f.parts.front().part);
  for (const char* key : {"strata", "trusted"})
    j[key] = Json::array();
  j["seconds"] = 0.0;
  const std::vector<std::string> domain = domain_of(f);
  std::vector<ToldStratum> told;
  for (auto p = f.parts.begin(); p != f.parts.end(); ++p)
    put_part(j, f, *p, domain, p == first, unknown, told);
  if (std::string where = where_liouvillian(told); f.whole && !where.empty())
    j["liouvillian_where"] = std::move(where);
  if (!f.whole) j["unvisited"].push_back("where " + f.parts.back().part.where.back().second);
  if (!domain.empty()) j["domain"] = domain;
  if (first != f.parts.end() && first->answer->contradictory) {
    j["contradictory"] = true;
    set_undecided(j, "parameter", "no parameters satisfy the assumptions");
    return j;
  }
  conclude(j, f);
  if (!f.refusal().empty()) {
    const auto refused = std::ranges::find_if(
        f.parts, [](const FamilyPart& p) { return p.answer && !p.answer->refusal.empty(); });
    j["refused_by_checker"] = refused->answer->certificate->json;
    set_undecided(j, name_of(Unable::Why::methods_disagree), open_text(j, f));
  }
  if (first != f.parts.end() && first->solutions) put_answer(j, first->solutions->general);
  return j;
}

} // namespace kov::cli
