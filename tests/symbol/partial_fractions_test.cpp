// Sums over products of linear factors take a road of their own: it must lead to the same place.

#include "symbol/constants.hpp"
#include "symbol/rational_form.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace kov {
namespace {

RationalFunction value(const std::string& text) {
  const std::array<Expression, 1> e{parse_expression(text, "text")};
  Constants constants;
  constants.gather(e);
  Reading reading;
  reading.constants = &constants;
  return rational_function(e[0], reading);
}

// A quadratic factor that cancels keeps a term off that road.
std::string the_long_way(const std::string& term) { return "(z^2+1)*(" + term + ")/(z^2+1)"; }

TEST(PartialFractions, Examples) {
  EXPECT_EQ(value("1/(z-1)+1/(z+1)"), value("2*z/(z^2-1)"));
  EXPECT_EQ(value("1/(z-1)-1/(z-1)"), RationalFunction(0));
  EXPECT_EQ(value("1/(z-1)^2-1/(z-1)^2+3"), RationalFunction(3));
  EXPECT_EQ(value("1/(2*z-2)^3+(z+1)^2/z"), value(the_long_way("1/(2*z-2)^3+(z+1)^2/z")));
  EXPECT_EQ(value("z/(z-1)-1/(z-1)"), RationalFunction(1));
  EXPECT_EQ(value("-(1/(z-I))-1/(z+I)"), value("-2*z/((z-I)*(z+I))"));
  EXPECT_EQ(value("(z-1)/((1-z)*(z-2))+0/(z-3)"), value("1/(2-z)"));
  EXPECT_EQ(value("1/(z-1+1-z+z)+2/z"), value("3/z"));
  EXPECT_THROW((void)value("1/(z-1)+1/(z-z)"), InputError);
  EXPECT_THROW((void)value("1/(z-1)+1/(2-1-1)^2"), InputError);
}

TEST(PartialFractions, RandomSums) {
  std::mt19937 gen(11);
  const auto number = [&](long a, long b) {
    return std::uniform_int_distribution<long>(a, b)(gen);
  };
  const auto linear = [&] {
    const std::string constant = std::to_string(number(1, 4)) + "/" + std::to_string(number(1, 3));
    return "(" + std::to_string(number(1, 3)) + "*z" + (number(0, 1) ? "+" : "-") + constant +
           (number(0, 4) == 0 ? "*sqrt(2))" : ")") +
           (number(0, 1) ? "^" + std::to_string(number(1, 3)) : "");
  };
  for (int i = 0; i < 60; ++i) {
    std::string plain;
    std::string other;
    for (long k = 0, n = number(2, 7); k < n; ++k) {
      std::string term = "(" + std::to_string(number(-5, 5)) + ")";
      for (long j = 0, m = number(0, 2); j < m; ++j)
        term += "*" + linear();
      for (long j = 0, m = number(0, 3); j < m; ++j)
        term += "/" + linear();
      const std::string sign = k == 0 ? "" : number(0, 1) ? "+" : "-";
      plain += sign + term;
      other += sign + the_long_way(term);
    }
    EXPECT_EQ(value(plain), value(other)) << plain;
  }
}

} // namespace
} // namespace kov
