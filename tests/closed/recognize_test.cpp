// Classical equations in disguise.

#include "closed/recognize.hpp"

#include "closed/generic_form.hpp"
#include "closed/lame.hpp"
#include "closed/number_answers.hpp"
#include "decide/decide.hpp"
#include "decide/words.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kov::recognize_test {
namespace {

const Poly z = Poly::z();

Rational q(long n, long d = 1) { return {Integer(n), Integer(d)}; }

std::string value(const Recognized& found, const std::string& name) {
  for (const auto& [key, text] : found.parameters)
    if (key == name) return text;
  return "";
}

Moebius random_map(std::mt19937& gen) {
  for (;;) {
    const auto number = [&] { return NfElem(static_cast<long>(gen() % 7) - 3); };
    const Moebius m{number(), number(), number(), number()};
    if (!is_zero(m.a * m.d - m.b * m.c)) return m;
  }
}

// The family is found, and its closed answer is what the engines say.
Recognized expect_family(const RationalFunction& r, Classical family) {
  const auto found = recognize(r);
  EXPECT_TRUE(found) << to_string(r);
  if (!found) return {};
  EXPECT_EQ(found->family, family) << to_string(r);
  Options options;
  options.want_solutions = false;
  const Decision d = decide({.r = r, .p = RationalFunction()}, options);
  if (found->answer) {
    EXPECT_EQ(found->answer->abelian, d.abelian) << to_string(r) << ": " << reason(d);
    if (found->answer->group && d.group) {
      EXPECT_EQ(describe(*found->answer->group), describe(*d.group)) << to_string(r);
    }
  }
  return *found;
}

TEST(Recognize, LameBehindAMoebiusMap) {
  std::mt19937 gen(21);
  for (int i = 0; i < 40; ++i) {
    const Rational n(static_cast<long>(gen() % 9), 1 + static_cast<long>(gen() % 4));
    const LameParameters<NfElem> p{NfElem(static_cast<long>(gen() % 7) - 3),
                                   NfElem(static_cast<long>(gen() % 7) + 1),
                                   NfElem(static_cast<long>(gen() % 7) - 9)};
    if (is_zero(p.g2 * p.g2 * p.g2 - NfElem(27) * p.g3 * p.g3)) continue;
    const RationalFunction r = lame_equation(NfElem(n * (n + Rational(1))), p);
    const Recognized found = expect_family(pull_back(r, random_map(gen)), Classical::lame);
    EXPECT_EQ(value(found, "n"), to_string(n));
    // B, g2, g3 come back up to x -> c x: B g2/g3 does not change
    const auto number = [&](const char* name) { return Rational::parse(value(found, name)); };
    EXPECT_EQ(NfElem(number("B") * number("g2") / number("g3")), p.b * p.g2 / p.g3);
  }
}

TEST(Recognize, LameWithConjugatePlacesAndIrrationalDegree) {
  const RationalFunction r =
      lame_equation(NfElem(-2), {NfElem(1), NfElem(0), NfElem(8)}); // x^3 = 2
  EXPECT_EQ(value(expect_family(r, Classical::lame), "n"), "-1/2 + sqrt(-7)/2");
}

// recognition.md 7, with its places at +-sqrt(d).
template <class F>
F mathieu(const F& x, const F& d, const F& alpha, const F& beta, const F& three_eighths) {
  const F p = x * x - d;
  return (alpha * x + beta) / p - three_eighths * ((x * x + d) / (p * p));
}
RationalFunction mathieu(long d, long alpha, long beta) {
  const auto number = [](long n, long m = 1) { return RationalFunction(Poly(Rational(n, m))); };
  return mathieu(RationalFunction(z), number(d), number(alpha), number(beta), number(3, 8));
}

TEST(Recognize, MathieuBehindAMoebiusMap) {
  std::mt19937 gen(22);
  for (int i = 0; i < 20; ++i) {
    const long d = static_cast<long>(gen() % 9) + 1; // conjugate places, too
    const long alpha = static_cast<long>(gen() % 5) + 1;
    const long beta = static_cast<long>(gen() % 9) - 4;
    const RationalFunction r = mathieu(d, alpha, beta);
    const Recognized moved = expect_family(pull_back(r, random_map(gen)), Classical::mathieu);
    EXPECT_EQ(value(moved, "a"), to_string(q(8 * beta - 1, 2)));
    EXPECT_EQ(value(moved, "q"), value(expect_family(r, Classical::mathieu), "q"));
  }
  EXPECT_EQ(value(expect_family(mathieu(1, 3, 2), Classical::mathieu), "q"), "6");
}

TEST(Recognize, MathieuWithParameters) {
  const Ring ring = make_ring({"x", "d", "u", "v"});
  const auto var = [&](const char* name) {
    return MFraction::variable(ring, std::string_view(name));
  };
  const auto found = strata::generic_form(
      mathieu(var("x") + var("v"), var("d"), var("u"), var("v"), MFraction(ring, Rational(3, 8))),
      0, ParametrisedSet(ring, {}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->answer.form.family, Classical::mathieu);
  EXPECT_EQ(found->answer.form.squares.front().second,
            MFraction(ring, Rational(4)) * var("d") * var("u") * var("u"));
  EXPECT_EQ(to_string(found->answer.form.values.front().second), "(8*v - 1)/2");
  EXPECT_EQ(found->abelian(), Truth::no);
}

TEST(Recognize, NeighboursOfMathieu) {
  const RationalFunction x(z), one(Poly(1));
  const auto plain = mathieu(1, 1, 1);
  for (const RationalFunction& other :
       {plain + one / ((x - one) * (x - one)), plain + one, plain - x / (x * x - one)})
    if (const auto found = recognize(other)) {
      EXPECT_NE(found->family, Classical::mathieu) << to_string(other);
    }
}

TEST(Recognize, FourHalvesAreLameWithDegreeZero) {
  const RationalFunction r = lame_equation(NfElem(0), {NfElem(1), NfElem(4), NfElem(0)});
  EXPECT_EQ(value(expect_family(r, Classical::lame), "n"), "0");
}

TEST(Recognize, RiemannBehindAMoebiusMap) {
  std::mt19937 gen(22);
  for (int i = 0; i < 60; ++i) {
    SquaredExponents e;
    for (NfElem& x : e) {
      const Rational root(static_cast<long>(gen() % 7), 1 + static_cast<long>(gen() % 4));
      x = NfElem(i % 5 == 0 ? root : root * root);
    }
    const RationalFunction r = riemann_equation(e);
    if (is_zero(r)) continue;
    const auto found = recognize(pull_back(r, random_map(gen)));
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->family == Classical::riemann || found->family == Classical::euler)
        << to_string(r);
    expect_family(r, found->family);
  }
}

TEST(Recognize, RiemannWithConjugatePlaces) {
  const Poly cubic = z * z * z - Poly(2); // all three conjugate
  for (const Poly& a : {Poly(q(-2, 9)), Poly(q(-3, 16)), Poly(3), Poly(0) + z, z * z - Poly(1)}) {
    const Poly n = a * derivative(cubic) * derivative(cubic) % cubic;
    if (is_zero(n)) continue;
    expect_family(RationalFunction(n, cubic * cubic), Classical::riemann);
  }
  const Poly two = z * z + Poly(1); // a conjugate pair and infinity
  for (long i = 1; i < 12; ++i) {
    const Poly n = scale(two, NfElem(q(i * i - 36, 144))) + Poly(q(3 - 2 * i, 9));
    expect_family(RationalFunction(n, two * two), i == 6 ? Classical::euler : Classical::riemann);
  }
}

TEST(Recognize, Euler) {
  for (const Rational& a : {q(2), q(-3, 16), q(-1, 4), q(1), q(-2, 9), q(1, 3)}) {
    expect_family(RationalFunction(Poly(a), pow(z - Poly(3), 2)), Classical::euler);
    expect_family(RationalFunction(Poly(a) * Poly(4), pow(z * z - Poly(1), 2)), Classical::euler);
    expect_family(RationalFunction(Poly(a) * Poly(8), pow(z * z - Poly(2), 2)), Classical::euler);
  }
}

TEST(Recognize, WhittakerGridAgainstTheEngines) {
  std::mt19937 gen(1989);
  for (long k2 = -6; k2 <= 6; ++k2)
    for (const Rational& m :
         {q(0), q(1, 2), q(1), q(3, 2), q(2), q(5, 2), q(1, 3), q(1, 4), q(3, 4)}) {
      const RationalFunction r(Poly(m * m - q(1, 4)) - scale(z, NfElem(q(k2, 2))) +
                                   scale(z * z, NfElem(q(1, 4))),
                               z * z);
      if (k2 == 0 && m == q(1, 2)) continue; // constant
      const Recognized found = expect_family(r, k2 == 0 ? Classical::bessel : Classical::whittaker);
      EXPECT_EQ(value(found, "m"), to_string(m));
      if (k2 % 3 == 0)
        expect_family(pull_back(r, random_map(gen)),
                      k2 == 0 ? Classical::bessel : Classical::whittaker);
    }
}

TEST(Recognize, WhittakerOverOtherFields) { // a = 2, 3, -1: k irrational or imaginary
  for (const Rational& a : {q(2), q(3), q(-1)})
    for (long b = -2; b <= 2; ++b)
      for (const Rational& c : {q(0), q(2), q(-3, 16), q(-1, 4), q(1)}) {
        const RationalFunction r(scale(z * z, NfElem(a)) + scale(z, NfElem(b)) + Poly(c), z * z);
        if (degree(r.den()) == 0) continue;
        expect_family(r, b == 0 ? Classical::bessel : Classical::whittaker);
      }
}

TEST(Recognize, BesselInASquareRoot) {
  for (const Rational& m : {q(0), q(1, 2), q(1), q(3, 2), q(1, 3), q(2), q(5, 2)}) {
    const RationalFunction r(scale(z, NfElem(3)) + Poly((m * m - q(1)) / q(4)), z * z);
    EXPECT_EQ(value(expect_family(r, Classical::bessel), "m"), to_string(m));
    expect_family(pull_back(r, {NfElem(1), NfElem(2), NfElem(1), NfElem(0)}), Classical::bessel);
  }
}

TEST(Recognize, Polynomials) {
  expect_family(RationalFunction(Poly(-3)), Classical::constant);
  expect_family(RationalFunction(scale(z, NfElem(5)) + Poly(1)), Classical::airy);
  for (long a = -6; a <= 6; ++a)
    for (const long u : {1L, 4L, 2L, -1L})
      expect_family(RationalFunction(scale(z * z, NfElem(u)) + z + Poly(q(1, 4 * u) + q(a))),
                    Classical::weber);
  expect_family(RationalFunction(z * z * z + Poly(1)), Classical::polynomial);
  expect_family(RationalFunction(pow(z, 4) + scale(z, NfElem(2))), Classical::polynomial);
  expect_family(RationalFunction(Poly(1), pow(z, 4)), Classical::constant); // at infinity: z = 1/x
  expect_family(RationalFunction(Poly(1), pow(z, 5)), Classical::airy);
}

TEST(Recognize, OverNumberFields) {
  const Field k = make_field({Integer(-2), Integer(0), Integer(1)}, "s");
  const NfElem s = NfElem::generator(k);
  const RationalFunction r = lame_equation(s, {s, s + NfElem(1), NfElem(3)});
  expect_family(pull_back(r, {s, NfElem(1), NfElem(1), NfElem(0)}), Classical::lame);
  expect_family(riemann_equation({s, NfElem(1) + s, NfElem(4)}), Classical::riemann);
  expect_family(RationalFunction(scale(z * z, s) + Poly(1)), Classical::weber);
}

TEST(Recognize, BehindASquare) { // u(z) = y((z-c)^2)/sqrt(z-c)
  std::mt19937 gen(4);
  const auto square = [](const RationalFunction& r, long c) {
    const Poly w = pow(z - Poly(c), 2);
    return RationalFunction(4) * RationalFunction(w) * compose(r, RationalFunction(w)) +
           RationalFunction(Poly(q(3, 4)), w);
  };
  for (int i = 0; i < 12; ++i) {
    const LameParameters<NfElem> p{NfElem(i), NfElem(5), NfElem(-3)};
    const Rational n(static_cast<long>(gen() % 9), 1 + static_cast<long>(gen() % 4));
    const RationalFunction r =
        square(pull_back(lame_equation(NfElem(n * (n + Rational(1))), p), random_map(gen)), i % 3);
    const Recognized found = expect_family(r, Classical::lame);
    EXPECT_EQ(value(found, "n"), to_string(n));
    EXPECT_TRUE(found.centre && *found.centre == NfElem(i % 3));
  }
  const SquaredExponents e{NfElem(q(1, 9)), NfElem(q(4, 25)), NfElem(q(1, 4))};
  expect_family(square(pull_back(riemann_equation(e), random_map(gen)), 1), Classical::riemann);
}

TEST(Recognize, WhatIsNotClassical) {
  EXPECT_FALSE(recognize(RationalFunction(0)));
  EXPECT_FALSE(recognize(RationalFunction(Poly(1), z * (z - Poly(1)) * (z - Poly(2)) *
                                                       (z - Poly(3)) * (z - Poly(4)))));
  EXPECT_FALSE(recognize(RationalFunction(z * z + Poly(1), z)));
  const auto heun =
      recognize(RationalFunction(Poly(1), z * (z - Poly(1)) * (z - Poly(2)) * (z - Poly(3))));
  ASSERT_TRUE(heun);
  EXPECT_EQ(heun->family, Classical::heun);
}

} // namespace
} // namespace kov::recognize_test
