#include "exact/lists.hpp"
#include "study/classification.hpp"

#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "parameters/conditions.hpp"
#include "parameters/few_sets.hpp"
#include "parameters/set.hpp"
#include "study/headline.hpp"

#include <algorithm>

namespace kov {

std::string to_string(Rule r) {
  switch (r) {
  case Rule::first_order:
    return "variational equations";
  case Rule::higher_order:
    return "higher variational equations";
  case Rule::quadratures:
    return "higher variational equations by quadratures";
  case Rule::darboux_points:
    return "Darboux points";
  case Rule::multiple_darboux_point:
    return "multiple Darboux point";
  case Rule::splitting:
    return "splitting of separatrices";
  case Rule::leading_part:
    return "leading part";
  case Rule::known_integrals:
    return "integrals";
  case Rule::cover:
    return "cover";
  }
  return {};
}

std::string to_string(StratumStatus s) {
  return s == StratumStatus::integrable ? "integrable"
         : s == StratumStatus::excluded ? "excluded"
                                        : "open";
}

std::string integrals_class(const SystemClassification& c) { return sentence(c.excluded); }

std::string status_word(Verdict v) {
  return v == Verdict::undecided ? to_string(StratumStatus::open) : to_string(v);
}

namespace {

bool has(const SystemClassification& c, StratumStatus status) {
  return std::ranges::any_of(c.strata,
                             [&](const ClassifiedStratum& s) { return s.status == status; });
}

} // namespace

Verdict SystemClassification::status() const {
  return study::verdict_of_sets(has(*this, StratumStatus::open),
                                has(*this, StratumStatus::integrable),
                                has(*this, StratumStatus::excluded));
}

std::string integrals_text(const ClassifiedStratum& s) {
  std::string text = joined(
      s.integrals, [&](const FoundIntegral& f) { return f.hamiltonian ? "H" : to_string(f); });
  std::string fields = joined(s.fields);
  if (fields.empty()) return text;
  return text + (text.empty() ? "" : ", and ") + "the commuting field" +
         (s.fields.size() > 1 ? "s " : " ") + fields;
}

namespace {

// "i^2 + 1 = 0" is shown where i is declared; what follows from it and from other equations is not.
std::vector<MPoly> equations_told(const SystemClassification& c, const Set& where) {
  try {
    return proper_equations(where, c.relations);
  } catch (const OutOfBudget&) {
    return where.equations();
  }
}

// The assumptions, also as the equations of the set rewrite them: a != 0 gives b != 0 where b = 2*a.
std::vector<MPoly> assumed_on(const SystemClassification& c, const Set& where) {
  std::vector<MPoly> all = c.nonzero;
  for (const MPoly& p : c.nonzero)
    if (const MFraction here = where.restrict(p); !is_zero(here))
      for (const MFactor& f : factor(here.num()).second)
        all.push_back(f.base);
  return all;
}

} // namespace

std::vector<std::string> conditions(const SystemClassification& c, const Set& where) {
  std::vector<std::string> all;
  for (const MPoly& p : equations_told(c, where))
    all.push_back(to_string(Condition{p, Sign::zero}));
  const auto assumed = assumed_on(c, where);
  std::vector<Condition> nonzero;
  for (const MPoly& p : inequations(where))
    if (!is_among(p, assumed)) nonzero.push_back({p, Sign::nonzero});
  for (const Condition& x : in_pairs(std::move(nonzero)))
    all.push_back(to_string(x));
  for (const WithContrary& x : with_contraries(where.statements()))
    all.push_back(x.text);
  return all;
}

namespace {

struct ToldPlace {
  std::string text;
  bool several = false; ///< conditions, or one with alternatives of its own
};
std::vector<ToldPlace> told(const SystemClassification& c, std::vector<Set> all) {
  if (c.at_work.empty())
    all = in_few_words(std::move(all), c.nonzero, c.known); // on the way that takes too long
  std::vector<ToldPlace> places;
  for (const Set& p : all) {
    const auto list = conditions(c, p);
    places.push_back({list.empty() ? "all parameters" : joined(list, ", ", " and "),
                      list.size() > 1 || !p.is_algebraic()});
  }
  return places;
}
std::vector<std::string> texts(const std::vector<ToldPlace>& all) {
  return mapped<std::string>(all, &ToldPlace::text);
}

std::vector<ToldPlace> told_places(const SystemClassification& c,
                                   const std::vector<StratumStatus>& wanted) {
  std::vector<Set> all;
  for (const ClassifiedStratum& s : c.strata)
    if (is_among(s.status, wanted)) all.push_back(s.where);
  return told(c, std::move(all));
}

} // namespace

std::vector<std::string> texts_of(const SystemClassification& c, std::vector<Set> all) {
  return texts(told(c, std::move(all)));
}

std::vector<std::string> places(const SystemClassification& c,
                                const std::vector<StratumStatus>& wanted) {
  return texts(told_places(c, wanted));
}

namespace {

constexpr std::size_t most_told = 8;
constexpr std::size_t longest_told = 600; // some lines

/// "(a = 1, b = 0) or a = 2"; where they are many, they stand below the theorem.
struct Alternatives {
  std::string text;
  bool below = false; ///< "one of the 12 sets of parameters below"
};
Alternatives alternatives(const SystemClassification& c, const std::vector<StratumStatus>& wanted,
                          const std::string& named) {
  const auto all = told_places(c, wanted);
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool several = all.size() > 1 && all[i].several;
    text += (i == 0                ? ""
             : i + 1 == all.size() ? " or "
                                   : ", ") +
            (several ? "(" + all[i].text + ")" : all[i].text);
  }
  if (all.size() <= most_told && text.size() <= longest_told) return {text};
  return {all.size() == 1 ? "the set of parameters below that is " + named
                          : "one of the " + std::to_string(all.size()) +
                                " sets of parameters below that are " + named,
          true};
}
// "for a = 1", "in one of the 12 sets of parameters below"
std::string where_of(const Alternatives& a) { return (a.below ? "in " : "for ") + a.text; }

bool has_logarithms(const SystemClassification& c) {
  return std::ranges::any_of(c.strata, [](const ClassifiedStratum& s) {
    return s.status == StratumStatus::integrable &&
           std::ranges::any_of(s.integrals,
                               [](const FoundIntegral& f) { return !f.logarithms.empty(); });
  });
}

} // namespace

std::string sentence(const ClassificationNote& n) {
  using What = ClassificationNote::What;
  switch (n.what) {
  case What::not_used:
    return "not used, as the statement is about all levels: " + n.of;
  case What::used_on_manifolds:
    return "used along the file's manifolds only, as the statement is about all levels: " + n.of;
  case What::manifold:
    return "the file's manifold " + n.of;
  case What::limit:
    return n.of;
  case What::rest_is_open:
    return n.of + ": the rest counts as open";
  case What::clock:
    return "ended by the time limit, or on request: with more time more may be decided";
  case What::constants:
    return "algebraic constants: " + n.of;
  case What::almost_all:
    return "almost all parameters: " + n.of;
  case What::unfinished:
    return "a limit ended the work; what was proved before is shown";
  }
  return "";
}

std::vector<std::string> sentences(const std::vector<ClassificationNote>& all) {
  return mapped<std::string>(all, [&](const ClassificationNote& n) { return sentence(n); });
}

std::vector<std::string> theorem_names(const std::vector<const LiteratureTheorem*>& all) {
  return mapped<std::string>(all, [&](const LiteratureTheorem* t) { return t->name; });
}

std::string statement(const ExclusionReason& by) {
  return "not integrable with " + first_integrals({by.integrals});
}

std::string statement(const SystemClassification& c) {
  const std::string integrable =
      std::string("The system is integrable") +
      (has_logarithms(c) ? ", with logarithms in some of the first integrals" : "");
  const std::string comma = has_logarithms(c) ? "," : "";
  switch (c.status()) {
  case Verdict::integrable:
    return integrable + (c.no_parameters ? "." : comma + " for all parameters.");
  case Verdict::non_integrable:
    return "The system is not integrable with " + first_integrals(c.excluded) + ".";
  case Verdict::depends:
    return integrable + comma + " exactly " +
           where_of(alternatives(c, {StratumStatus::integrable}, "integrable")) +
           "; elsewhere it is not integrable with " + first_integrals(c.excluded) + ".";
  default:
    break;
  }
  const std::string almost =
      c.almost_all ? "For almost all parameters (all but a set of measure zero, which is not "
                     "determined) the system is " +
                         statement(c.almost_all->by) + "."
                   : "";
  if (!has(c, StratumStatus::excluded)) {
    const std::string some =
        has(c, StratumStatus::integrable)
            ? integrable + comma + " " +
                  where_of(alternatives(c, {StratumStatus::integrable}, "integrable")) + "."
            : "";
    const bool has_integrals = std::ranges::any_of(
        c.strata, [](const ClassifiedStratum& s) { return !s.integrals.empty(); });
    if (some.empty() && almost.empty())
      return has_integrals ? "Nothing is proved: no obstruction was found, and too few first "
                             "integrals."
                           : "Nothing is proved: no obstruction and no further first integral was "
                             "found.";
    return some + (some.empty() || almost.empty() ? "" : " ") + almost;
  }
  const Alternatives only =
      alternatives(c, {StratumStatus::integrable, StratumStatus::open}, "integrable or open");
  return "If the system is integrable with " + first_integrals(c.excluded) + ", then " +
         (only.below ? "its parameters are in " : "") + only.text + "." +
         (almost.empty() ? "" : " " + almost);
}

} // namespace kov
