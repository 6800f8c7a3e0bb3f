// The pitfall suite: equations on which implementations are known to fail.

#include "kovacic/reader.hpp"
#include "kovacic/solve.hpp"
#include "support/equations.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kov::kovacic::pitfalls_test {
namespace {

using testing::lame;
using testing::read;
using testing::riemann;

struct Row {
  int number;
  RationalFunction r;
  int kovacic_case;
  bool unique_line = false; ///< case 1: exactly one exponential line
  int degree = 0;           ///< case 3: 4, 6 or 12 for A4, S4, A5
};

NfElem q(long n, long d = 1) { return NfElem(Rational(n, d)); }
RationalFunction square(long a, long b, long c, long d, long e, long f) {
  return riemann(q(a * a, b * b), q(c * c, d * d), q(e * e, f * f));
}
RationalFunction omega(const char* text) { return testing::from_omega(read(text)); }
// n(n+1) for n = a/b
RationalFunction lame_n(long a, long b, const NfElem& B, const NfElem& g2, const NfElem& g3) {
  return lame(q(a * (a + b), b * b), B, g2, g3);
}

const bool one = true;

std::vector<Row> table() {
  return {
      {1, read("0"), 1},
      {2, read("2/z^2"), 1},
      {3, read("3/(4*z^2)"), 1},
      {4, read("-1/(4*z^2)"), 1, one},
      {5, read("-3/(16*z^2)"), 1},
      {6, read("-2/(9*z^2)"), 1},
      {7, read("1/z^2"), 1},
      {8, read("1"), 1},
      {9, read("-1"), 1},
      {10, read("z"), 4},
      {11, read("z^2+1"), 1, one},
      {12, read("z^2+2"), 4},
      {13, read("z^2+3"), 1, one},
      {14, read("z^2-5"), 1, one},
      {15, read("z^4"), 4},
      {15, read("z^4+2*z"), 1, one},
      {16, read("1/z"), 4},
      {17, read("1/(4*z)-3/(16*z^2)"), 2},
      {18, read("1/z^3-3/(16*z^2)"), 2},
      {18, read("1/z^3"), 4},
      {19, read("-1+2/z^2"), 1},
      {20, read("-1+3/(4*z^2)"), 4},
      {21, read("1/z^4"), 1},
      {22, read("2/z^3+1/z^4"), 1, one},
      {23, read("3/(4*z^2)+1/z"), 4},
      {24, square(1, 2, 1, 2, 1, 2), 2},
      {25, square(1, 2, 1, 2, 1, 5), 2},
      {26, riemann(q(1, 4), q(1, 4), q(1, 2)), 2},
      {27, square(1, 2, 1, 2, 0, 1), 1, one},
      {28, square(1, 2, 1, 2, 1, 1), 1},
      {28, square(1, 2, 1, 2, 2, 1), 1},
      {29, square(1, 2, 1, 3, 1, 3), 3, false, 4},
      {29, square(2, 3, 2, 3, 2, 3), 3, false, 4},
      {30, square(1, 2, 1, 3, 1, 4), 3, false, 6},
      {31, square(1, 2, 1, 3, 1, 5), 3, false, 12},
      {31, square(2, 3, 1, 3, 1, 5), 3, false, 12},
      {32, square(5, 3, 1, 3, 1, 3), 1, one},
      {32, square(1, 3, 1, 3, 1, 3), 1, one},
      {33, square(5, 3, 1, 4, 1, 4), 4},
      {34, square(1, 2, 1, 3, 1, 7), 4},
      {35, square(1, 3, 1, 3, 1, 4), 4},
      {36, square(0, 1, 0, 1, 0, 1), 4},
      {37, square(0, 1, 0, 1, 13, 1), 1, one},
      {38, omega("3*z^2/(4*(z^3-2))"), 1, one},
      {39, omega("3*z^2/(3*(z^3-2))"), 1, one},
      {40, omega("-2*z/(z^2-2)"), 1},
      {41, lame_n(0, 1, q(1), q(4), q(1)), 2},
      {42, lame_n(1, 1, q(2), q(4), q(1)), 2},
      {43, lame_n(1, 1, q(0), q(0), q(4)), 2},
      {44, lame_n(1, 1, q(1), q(4), q(0)), 1, one},
      {45, lame_n(1, 2, q(0), q(4), q(1)), 2},
      {45, lame_n(1, 2, q(1), q(4), q(1)), 4},
      {46, lame_n(3, 2, q(3), q(12), q(1)), 2},
      {47, lame_n(5, 2, q(3), q(1), q(-3, 10)), 2},
      {48, lame_n(1, 4, q(0), q(0), q(4)), 3, false, 6},
      {49, lame_n(1, 10, q(0), q(0), q(4)), 3, false, 12},
      {50, lame_n(1, 6, q(0), q(4), q(0)), 3, false, 6},
      {51, lame_n(1, 3, q(1), q(4), q(1)), 4},
      {51, lame(q(-2), q(1), q(4), q(1)), 4},
      {52, read("1/4-1/z"), 1, one},
      {52, read("1/4-1/(3*z)-5/(36*z^2)"), 4},
  };
}

TEST(Pitfalls, EveryRow) {
  for (const Row& row : table()) {
    SCOPED_TRACE("row " + std::to_string(row.number) + ": " + to_string(row.r));
    const Outcome outcome = solve(row.r);
    EXPECT_EQ(case_of(outcome), row.kovacic_case);
    if (row.kovacic_case == 1) {
      EXPECT_EQ(std::holds_alternative<Exponential>(outcome), row.unique_line);
    }
    if (const auto* algebraic = std::get_if<Algebraic>(&outcome)) {
      EXPECT_EQ(static_cast<int>(algebraic->group), row.degree);
    }
  }
}

// ----- what the answer does not depend on -------------------------------------------------------

// Case, number of lines, primitive group.
int shape(const Outcome& outcome) {
  if (const auto* algebraic = std::get_if<Algebraic>(&outcome))
    return 30 + static_cast<int>(algebraic->group);
  if (const auto* pair = std::get_if<ExponentialPair>(&outcome)) return pair->every_line ? 12 : 11;
  return 10 * case_of(outcome).value_or(0);
}

class Invariance : public ::testing::TestWithParam<unsigned> {
protected:
  std::mt19937 gen_{GetParam()};
  Rational small() {
    const auto uniform = [&](long a, long b) {
      return std::uniform_int_distribution<long>(a, b)(gen_);
    };
    return Rational(uniform(-9, 9), uniform(1, 4));
  }
};

TEST_P(Invariance, Moebius) {
  for (const Row& row : table()) {
    Rational a = small();
    const Rational b = small();
    const Rational c = small();
    const Rational d = small();
    if (is_zero(a * d - b * c)) continue;
    const RationalFunction f(Poly::from_coefficients({b, a}), Poly::from_coefficients({d, c}));
    SCOPED_TRACE("row " + std::to_string(row.number) + " at " + to_string(f));
    EXPECT_EQ(shape(solve(testing::pull_back(row.r, f))), shape(solve(row.r)));
  }
}

// u = (a y + y')/sqrt(r + a' - a^2): the same projective group, and apparent singularities.
TEST_P(Invariance, Gauge) {
  for (const Row& row : table()) {
    const RationalFunction a(Poly::from_coefficients({small(), small()}));
    SCOPED_TRACE("row " + std::to_string(row.number) + " with a = " + to_string(a));
    if (is_zero(row.r + derivative(a) - a * a)) continue; // y' + a y = 0 for a solution y
    EXPECT_EQ(shape(solve(testing::gauge(row.r, a))), shape(solve(row.r)));
  }
}

TEST_P(Invariance, LargerField) {
  const Field k = make_field({-2 - 5 * static_cast<long>(GetParam()), 0, 1}, "s");
  for (const Row& row : table()) {
    SCOPED_TRACE("row " + std::to_string(row.number));
    EXPECT_EQ(shape(solve(coerce(row.r, k))), shape(solve(row.r)));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Invariance, ::testing::Range(1u, 6u));

} // namespace
} // namespace kov::kovacic::pitfalls_test
