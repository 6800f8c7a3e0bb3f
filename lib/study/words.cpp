#include "study/classification.hpp"

#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "parameters/conditions.hpp"
#include "study/parameter_split.hpp"
#include "study/places.hpp"

#include <algorithm>

namespace kov {

std::string to_string(StratumStatus s) {
  return s == StratumStatus::integrable ? "integrable"
         : s == StratumStatus::excluded ? "excluded"
                                        : "open";
}

std::string integrals_class(const SystemClassification& c) { return sentence(c.excluded); }

std::string to_string(ClassificationStatus s) {
  switch (s) {
  case ClassificationStatus::integrable:
    return "integrable";
  case ClassificationStatus::non_integrable:
    return "non-integrable";
  case ClassificationStatus::depends:
    return "depends";
  default:
    return "open";
  }
}

ClassificationStatus SystemClassification::status() const {
  const auto all = [&](StratumStatus status) {
    return std::all_of(strata.begin(), strata.end(),
                       [&](const ClassifiedStratum& s) { return s.status == status; });
  };
  if (strata.empty()) return ClassificationStatus::open;
  if (all(StratumStatus::integrable)) return ClassificationStatus::integrable;
  if (all(StratumStatus::excluded)) return ClassificationStatus::non_integrable;
  const bool open = std::any_of(strata.begin(), strata.end(), [](const ClassifiedStratum& s) {
    return s.status == StratumStatus::open;
  });
  return open ? ClassificationStatus::open : ClassificationStatus::depends;
}

std::string integrals_text(const ClassifiedStratum& s) {
  std::string text;
  for (const FoundIntegral& f : s.integrals)
    text += (text.empty() ? "" : ", ") + (f.hamiltonian ? "H" : to_string(f));
  std::string fields;
  for (const std::string& y : s.fields)
    fields += (fields.empty() ? "" : ", ") + y;
  if (fields.empty()) return text;
  return text + (text.empty() ? "" : ", and ") + "the commuting field" +
         (s.fields.size() > 1 ? "s " : " ") + fields;
}

namespace {

// "i^2 + 1 = 0" is told where i is declared; what follows from it and from other equations is not.
std::vector<MPoly> equations_told(const SystemClassification& c, const ParameterSet& where) {
  try {
    return proper_equations(where, c.relations);
  } catch (const OutOfBudget&) {
    return where.equations();
  }
}

// What is assumed, as it reads on the set: on b = 2*a "a != 0" may be b != 0.
std::vector<MPoly> assumed_on(const SystemClassification& c, const ParameterSet& where) {
  std::vector<MPoly> all = c.nonzero;
  for (const MPoly& p : c.nonzero)
    if (const MFraction here = where.restrict(p); !is_zero(here))
      for (const MFactor& f : factor(here.num()).second)
        all.push_back(f.base);
  return all;
}

void add_conditions(const SystemClassification& c, const ParameterSet& where,
                    std::vector<std::string>& all) {
  for (const MPoly& p : equations_told(c, where))
    all.push_back(to_string(Condition{p, Sign::zero}));
  const auto assumed = assumed_on(c, where);
  for (const MPoly& p : inequations(where))
    if (std::find(assumed.begin(), assumed.end(), p) == assumed.end())
      all.push_back(to_string(Condition{p, Sign::nonzero}));
}

} // namespace

std::vector<std::string> conditions(const SystemClassification& c, const ClassifiedStratum& s) {
  std::vector<std::string> all;
  add_conditions(c, s.where, all);
  for (const DifferenceCondition& x : s.special)
    all.push_back(to_string(x));
  return all;
}

std::vector<std::string> texts_of(const SystemClassification& c, std::vector<ParameterPlace> all) {
  if (c.at_work.empty())
    all = in_few_words(std::move(all), c.nonzero, c.known); // on the way that takes too long
  std::vector<std::string> texts;
  for (const ParameterPlace& p : all) {
    const std::string text = joined(conditions(c, {p.where, p.special}));
    texts.push_back(text.empty() ? "all parameters" : text);
  }
  return texts;
}

std::vector<std::string> places(const SystemClassification& c,
                                const std::vector<StratumStatus>& wanted) {
  std::vector<ParameterPlace> all;
  for (const ClassifiedStratum& s : c.strata)
    if (std::find(wanted.begin(), wanted.end(), s.status) != wanted.end())
      all.push_back({s.where, s.special});
  return texts_of(c, std::move(all));
}

namespace {

constexpr std::size_t most_told = 8;
constexpr std::size_t longest_told = 600; // some lines

// "a = 1, b = 0 or (a = 2, b = 3)"; where they are many, they stand below the theorem.
std::string alternatives(const SystemClassification& c, const std::vector<StratumStatus>& wanted,
                         const std::string& named) {
  const auto all = places(c, wanted);
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool several = all.size() > 1 && all[i].find(", ") != std::string::npos;
    text += (i == 0                ? ""
             : i + 1 == all.size() ? " or "
                                   : ", ") +
            (several ? "(" + all[i] + ")" : all[i]);
  }
  if (all.size() <= most_told && text.size() <= longest_told) return "for " + text;
  return all.size() == 1 ? "in the set of parameters below that is " + named
                         : "in one of the " + std::to_string(all.size()) +
                               " sets of parameters below that are " + named;
}

bool has(const SystemClassification& c, StratumStatus status) {
  return std::any_of(c.strata.begin(), c.strata.end(),
                     [&](const ClassifiedStratum& s) { return s.status == status; });
}

bool has_logarithms(const SystemClassification& c) {
  return std::any_of(c.strata.begin(), c.strata.end(), [](const ClassifiedStratum& s) {
    return std::any_of(s.integrals.begin(), s.integrals.end(),
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
    return "the clock ended the work: with more time more may be decided";
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
  std::vector<std::string> texts;
  for (const ClassificationNote& n : all)
    texts.push_back(sentence(n));
  return texts;
}

std::vector<std::string> theorem_names(const std::vector<const LiteratureTheorem*>& all) {
  std::vector<std::string> texts;
  for (const LiteratureTheorem* t : all)
    texts.push_back(t->name);
  return texts;
}

std::string statement(const ExclusionReason& by) {
  return "not integrable with " + first_integrals({by.integrals});
}

std::string statement(const SystemClassification& c) {
  const std::string integrable =
      std::string("The system is integrable") +
      (has_logarithms(c) ? ", with logarithms in some of the first integrals," : "");
  switch (c.status()) {
  case ClassificationStatus::integrable:
    return integrable + " for all parameters.";
  case ClassificationStatus::non_integrable:
    return "The system is not integrable with " + first_integrals(c.excluded) + ".";
  case ClassificationStatus::depends:
    return integrable + " exactly " + alternatives(c, {StratumStatus::integrable}, "integrable") +
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
            ? integrable + " " + alternatives(c, {StratumStatus::integrable}, "integrable") + "."
            : "";
    if (some.empty() && almost.empty())
      return "Nothing is proved: no obstruction and no further first integral was found.";
    return some + (some.empty() || almost.empty() ? "" : " ") + almost;
  }
  std::string only =
      alternatives(c, {StratumStatus::integrable, StratumStatus::open}, "integrable or open");
  if (only.starts_with("for "))
    only.erase(0, 4);
  else
    only.insert(0, "its parameters are ");
  return "If the system is integrable with " + first_integrals(c.excluded) + ", then " + only +
         "." + (almost.empty() ? "" : " " + almost);
}

} // namespace kov
