#include "classify/classification.hpp"

#include "classify/parameter_split.hpp"
#include "integrability/integral_class.hpp"
#include "parameters/conditions.hpp"

#include <algorithm>

namespace kov {

std::string to_string(StratumStatus s) {
  return s == StratumStatus::integrable ? "integrable"
         : s == StratumStatus::excluded ? "excluded"
                                        : "open";
}

std::string to_string(ExcludedClass c) {
  switch (c) {
  case ExcludedClass::meromorphic:
    return "meromorphic";
  case ExcludedClass::meromorphic_at_infinity:
    return to_string(IntegralClass::meromorphic_at_infinity);
  default:
    return "rational";
  }
}

namespace {

std::string listed(const std::vector<std::string>& all, const std::string& first) {
  std::string text;
  for (const std::string& one : all)
    text += (text.empty() ? first : ", ") + one;
  return text;
}

} // namespace

std::string integrals_class(const SystemClassification& c) {
  if (!c.excluded) return "";
  const std::string in = listed(c.functions, " (in the coordinates and ");
  return to_string(*c.excluded) + in + (in.empty() ? "" : ")") +
         (c.on_leaves ? " and independent on the symplectic leaves of the solutions" : "") +
         listed(c.without, " and do not contain ");
}

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

namespace {

void add_conditions(const SystemClassification& c, const ParameterSet& where,
                    std::vector<std::string>& all) {
  for (const MPoly& p : where.equations())
    all.push_back(to_string(Condition{p, Sign::zero}));
  for (const MPoly& p : inequations(where))
    if (std::find(c.nonzero.begin(), c.nonzero.end(), p) == c.nonzero.end())
      all.push_back(to_string(Condition{p, Sign::nonzero}));
}

std::string joined(const std::vector<std::string>& all) {
  std::string text;
  for (const std::string& one : all)
    text += (text.empty() ? "" : ", ") + one;
  return text.empty() ? "all parameters" : text;
}

} // namespace

std::vector<std::string> conditions(const SystemClassification& c, const ClassifiedStratum& s) {
  std::vector<std::string> all;
  add_conditions(c, s.where, all);
  for (const DifferenceCondition& x : s.special)
    all.push_back(to_string(x));
  return all;
}

std::vector<std::string> places(const SystemClassification& c,
                                const std::vector<StratumStatus>& wanted) {
  std::vector<ParameterSet> plain;
  std::vector<std::string> all, others;
  for (const ClassifiedStratum& s : c.strata) {
    if (std::find(wanted.begin(), wanted.end(), s.status) == wanted.end()) continue;
    if (s.special.empty())
      plain.push_back(s.where);
    else
      others.push_back(joined(conditions(c, s)));
  }
  for (const ParameterSet& where : united(std::move(plain))) {
    std::vector<std::string> one;
    add_conditions(c, where, one);
    all.push_back(joined(one));
  }
  std::move(others.begin(), others.end(), std::back_inserter(all));
  return all;
}

} // namespace kov
