// What is proved depends on the work that is allowed, and more of it takes nothing back.

#include "classify/classify.hpp"
#include "support/points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::work_test {
namespace {

using testing::Each;
using testing::Ne;

System planar(const std::string& potential) {
  return read_system(parse_document(
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
      "parameters = ['b']\nhamiltonian = '(u^2 + v^2)/2 + " +
          potential + "'\n",
      "test.toml"));
}

SystemClassification classified(const System& s, double work) {
  ClassifyOptions options;
  options.check.decide.budget.give(work);
  return classify_system(s, options);
}

std::vector<std::string> at_some_points(const SystemClassification& c) {
  std::vector<std::string> all;
  for (const Rational& b : {Rational(0), Rational(1), Rational(2), Rational(6), Rational(1, 3),
                            Rational(16, 3), Rational(-5)})
    all.push_back(test::status_at(c, {{"b", b}}));
  return all;
}

const std::vector<std::string> potentials{"x^2*y + b*y^3", "x^4 + b*x^2*y^2 + y^4",
                                          "(x^2 + y^2)/2 + x^2*y + b*y^3"};

TEST(Work, WithoutItAllIsOpen) {
  for (const std::string& v : potentials) {
    const auto c = classified(planar(v), 0);
    EXPECT_THAT(at_some_points(c), Each("open")) << v;
    EXPECT_TRUE(c.complete); // another run says the same
  }
}

TEST(Work, TheSameIsTheSameTheorem) {
  for (const std::string& v : potentials)
    for (const double work : {1e6, 1e7, 4e7}) {
      const auto c = classified(planar(v), work);
      EXPECT_EQ(statement(c), statement(classified(planar(v), work))) << v << ", " << work;
      EXPECT_TRUE(c.complete);
    }
}

TEST(Work, FourTimesAsMuchTakesNothingBack) {
  for (const std::string& v : potentials) {
    std::vector<std::string> before(7, "open");
    for (double work = 2e5; work < 1e9; work *= 4) {
      const auto now = at_some_points(classified(planar(v), work));
      for (std::size_t k = 0; k < now.size(); ++k)
        if (before[k] != "open") {
          EXPECT_EQ(now[k], before[k]) << v << ", point " << k << ", work " << work;
        }
      before = now;
    }
    EXPECT_THAT(before, Each(Ne("open"))) << v;
  }
}

} // namespace
} // namespace kov::work_test
