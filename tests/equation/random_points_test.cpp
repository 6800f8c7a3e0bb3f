// Families with parameters against the solver without, at random points of every stratum.
// An exponent difference that is itself a parameter s takes many rational values.

#include "equation/assumptions.hpp"
#include "equation/parametric_equation.hpp"
#include "strata/specialisation.hpp"

#include <iostream>

namespace kov {
namespace {

struct Sample {
  const char* r;
  const char* assume;
};

class RandomPoints : public ::testing::TestWithParam<Sample> {};

TEST_P(RandomPoints, Agree) {
  EquationText text;
  text.r = parse_expression(GetParam().r, "r");
  text.variable = "z";
  text.assume.push_back({GetParam().assume, nullptr, ""});
  text.parameters = names_in_assumption({GetParam().assume, nullptr, ""});
  const ParametricEquation f = read_parametric_equation(text);
  const auto answer = strata::decide_strata(f.question);
  EXPECT_FALSE(answer.contradictory);
  const int compared = test::compare(f.question, answer, 7);
  std::cout << compared << " points on " << answer.strata.size() << " strata\n";
}

INSTANTIATE_TEST_SUITE_P(
    Families, RandomPoints,
    ::testing::Values(
        // Riemann (1/2, 1/3, s), (1/3, 1/3, s), (1/2, 1/2, s), (s, 1/2, 1/4)
        Sample{"-3/(16*z^2) - 2/(9*(z-1)^2) + ((s^2-1)/4+3/16+2/9)/(z*(z-1))", "s > 0, s < 2"},
        Sample{"-2/(9*z^2) - 2/(9*(z-1)^2) + ((s^2-1)/4+4/9)/(z*(z-1))", "s > 0, s < 3"},
        Sample{"-3/(16*z^2) - 3/(16*(z-1)^2) + ((s^2-1)/4+3/8)/(z*(z-1))", "s complex"},
        Sample{"(s^2-1)/(4*z^2) - 3/(16*(z-1)^2) + (-15/64-(s^2-1)/4+3/16)/(z*(z-1))",
               "s > 0, s < 2"},
        // Lame: B free, the difference at infinity s
        Sample{"-3/(16*z^2) - 3/(16*(z-1)^2) - 3/(16*(z+1)^2)"
               " + (((s^2-1)/4+9/16)*z + b)/(z*(z^2-1))",
               "s > 0, s < 2, b complex"},
        Sample{"-3/(16*z^2) - 3/(16*(z-1)^2) - 3/(16*(z-a)^2) + (9/16*z + b)/(z*(z-1)*(z-a))",
               "a complex, b complex"},
        // irregular
        Sample{"1/4 - k/z + (s^2-1)/(4*z^2)", "k complex, s > 0, s < 4"},
        Sample{"z^2 + a + (s^2-1)/(4*z^2)", "a complex, s > 0, s < 4"},
        Sample{"z^4 + a*z^2 + b*z + c", "a complex, b complex, c complex"},
        Sample{"a/z^4 + b/z^2", "a complex, b complex"},
        Sample{"a/z^3 + b/z^2", "a complex, b complex"}, Sample{"1 + a/z + 2/z^2", "a complex"},
        // places that meet, orders that drop, logarithms that depend on a parameter
        Sample{"3/(4*z^2) + a/z + b/(z-1)", "a complex, b complex"},
        Sample{"3/(4*z^2) + 3/(4*(z-a)^2) + b/(z*(z-a))", "a complex, b complex"},
        Sample{"2/(z-a)^2 + 2/(z+a)^2", "a complex"}, Sample{"(z^2 + a)/(z^2 - 1)^2", "a complex"},
        Sample{"-3/(16*(z^2-a)) + b/(z^2-a)^2", "a complex, b complex"},
        Sample{"-2/(9*(z^2-a)^2)", "a complex"}, Sample{"(a*z+b)/(z^2+1)^2", "a real, b real"}));

} // namespace
} // namespace kov
