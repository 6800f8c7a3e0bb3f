// Parameters at which the system does not exist are in no stratum, and values at which a function is
// a number are like all others.

#include "classify/classify.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::domain_test {
namespace {

using testing::Contains;
using testing::IsEmpty;

System plane(const std::string& potential) {
  return read_system(parse_document(
      "[system]\nkind = \"hamiltonian\"\ncoordinates = [\"x\", \"y\"]\nmomenta = [\"p\", \"q\"]\n"
      "parameters = [\"a\", \"b\"]\nhamiltonian = \"(p^2 + q^2)/2 + " +
          potential + "\"\n",
      "plane.toml"));
}

SystemClassification classified(const System& s) {
  ClassifyOptions options;
  options.check.decide.budget.give(1e8 * 20);
  options.check.decide.want_certificate = false;
  options.degree = 2;
  options.degree_at_points = 2;
  options.order = 1;
  return classify_system(s, options);
}

// Of "a != 0 or b != 0": are both a = 0 and b = 0 conditions of the stratum?
bool is_outside(const std::vector<std::string>& conditions, const std::string& needed) {
  for (const std::string name : {"a", "b"})
    if (needed.find(name + " != 0") != std::string::npos &&
        std::find(conditions.begin(), conditions.end(), name + " = 0") == conditions.end())
      return false;
  return true;
}

TEST(ClassifyDomain, WhereASystemExistsItIsIntegrable) {
  const std::vector<std::pair<std::string, std::string>> known{
      {"1/(a*x + b*y)^2", "a != 0 or b != 0"},       {"1/(a*x - b*y)^4", "a != 0 or b != 0"},
      {"1/(1 + x^2 + y^2/a^2)", "a != 0"},           {"x^2/(b*(1 + x^2))", "b != 0"},
      {"y^2 + 1/(a^2*x^2 + b)", "a != 0 or b != 0"}, {"log(a*x)", "a != 0"}};
  for (const auto& [potential, needed] : known) {
    const System s = plane(potential);
    const SystemClassification c = classified(s);
    EXPECT_EQ(to_string(c.status()), "integrable") << potential;
    EXPECT_THAT(c.assumptions, Contains(needed)) << potential;
    for (const ClassifiedStratum& x : c.strata)
      EXPECT_FALSE(is_outside(conditions(c, x.where), needed)) << potential;
  }
}

TEST(ClassifyDomain, AFunctionMayBecomeANumber) {
  for (const std::string potential : {"sqrt(a*x^2 + 1)", "sqrt(a*x^2 + 4)", "exp(a*x)", "cos(a*x)",
                                      "cosh(a*y)", "log(1 + a*x^2)", "sqrt(1 + a*(x^2 + y^2))"}) {
    const SystemClassification c = classified(plane(potential));
    EXPECT_EQ(to_string(c.status()), "integrable") << potential;
    EXPECT_THAT(places(c, {StratumStatus::open}), IsEmpty()) << potential;
  }
}

} // namespace
} // namespace kov::domain_test
