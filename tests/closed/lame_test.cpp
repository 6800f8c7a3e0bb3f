// Lame's equation: closed conditions, with symbolic parameters and with numbers, and the engines.

#include "closed/lame.hpp"
#include "decide/decide.hpp"
#include "decide/words.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kov::lame_test {
namespace {

Rational q(long n, long d = 1) { return {Integer(n), Integer(d)}; }

const Ring& ring() {
  static const Ring r = make_ring({"B", "g2", "g3"});
  return r;
}
MFraction var(const char* name) { return MFraction::variable(ring(), std::string_view(name)); }
LameParameters<MFraction> symbols() { return {var("B"), var("g2"), var("g3")}; }
MFraction monomial(const Rational& c, long b, long g2, long g3) {
  return c * (pow(var("B"), b) * pow(var("g2"), g2) * pow(var("g3"), g3));
}

std::string texts(const std::vector<MPoly>& all) {
  std::string s;
  for (const MPoly& f : all)
    s += (s.empty() ? "" : "; ") + to_string(f);
  return s;
}

struct Numbers {
  Rational n, b, g2, g3;
};
LameParameters<NfElem> parameters(const Numbers& x) {
  return {NfElem(x.b), NfElem(x.g2), NfElem(x.g3)};
}
NfElem alpha(const Rational& n) { return NfElem(n * (n + Rational(1))); }

Decision engines(const NfElem& a, const LameParameters<NfElem>& p) {
  Options options;
  options.want_solutions = false;
  return decide({.r = lame_equation(a, p), .p = RationalFunction()}, options);
}

// Closed answer and engines agree; where the formula does not name the group it says "dihedral".
void expect_agreement(const NfElem& a, const LameParameters<NfElem>& p, const std::string& name) {
  const ClosedAnswer answer = lame_answer(a, p);
  const Decision d = engines(a, p);
  ASSERT_NE(d.abelian, Truth::unknown) << name << ": " << reason(d);
  EXPECT_EQ(answer.abelian, d.abelian) << name << ": " << answer.reason << " | " << reason(d);
  if (answer.group && d.group) {
    EXPECT_EQ(describe(*answer.group), describe(*d.group)) << name << ": " << answer.reason;
  }
  if (!answer.group && d.group) {
    EXPECT_EQ(kovacic_case(*d.group), 2) << name;
  }
}
void expect_agreement(const Numbers& x) {
  expect_agreement(alpha(x.n), parameters(x),
                   "n = " + to_string(x.n) + ", B = " + to_string(x.b) +
                       ", g2 = " + to_string(x.g2) + ", g3 = " + to_string(x.g3));
}

TEST(Lame, BrioschiForSymbolicParameters) {
  EXPECT_TRUE(brioschi(1, symbols()) == var("B"));
  EXPECT_TRUE(brioschi(2, symbols()) == monomial(1, 2, 0, 0) - monomial(q(3, 4), 0, 1, 0));
  EXPECT_TRUE(brioschi(3, symbols()) ==
              monomial(1, 3, 0, 0) - monomial(7, 1, 1, 0) + monomial(20, 0, 0, 1));
  EXPECT_TRUE(brioschi(4, symbols()) == monomial(1, 4, 0, 0) - monomial(q(63, 2), 2, 1, 0) +
                                            monomial(216, 1, 0, 1) + monomial(q(945, 16), 0, 2, 0));
  EXPECT_EQ(degree(brioschi(20, symbols()).num(), 0), 20);
}

TEST(Lame, TheInvariantOfHermite) {
  const auto w = [](long n) { return lame_hermite(n, symbols()).w_squared; };
  EXPECT_TRUE(w(0) == monomial(4, 1, 0, 0));
  EXPECT_TRUE(w(1) == monomial(4, 3, 0, 0) - monomial(1, 1, 1, 0) - monomial(1, 0, 0, 1));
  const MFraction b2 = monomial(3, 0, 1, 0) - monomial(1, 2, 0, 0);
  const MFraction b3 = monomial(9, 1, 1, 0) - monomial(4, 3, 0, 0) - monomial(27, 0, 0, 1);
  EXPECT_TRUE(w(2) == q(1, 81) * (b2 * b3));
  for (long n = 0; n <= 8; ++n)
    EXPECT_EQ(degree(w(n).num(), 0), 2 * n + 1) << n;
}

TEST(Lame, ConditionsInWords) {
  const auto conditions = [](const Rational& n) {
    return lame_conditions(lame_index(n), symbols());
  };
  EXPECT_TRUE(conditions(q(7)).always());
  EXPECT_TRUE(conditions(q(-3)).always());
  EXPECT_EQ(to_string(*conditions(q(1)).reducible), "4*B^3 - B*g2 - g3");
  EXPECT_EQ(texts(conditions(q(3, 2)).abelian), "4*B^2 - 3*g2");
  EXPECT_EQ(texts(conditions(q(-5, 2)).abelian), "4*B^2 - 3*g2"); // n and -1-n
  EXPECT_TRUE(conditions(q(-1, 2)).never());
  EXPECT_TRUE(conditions(q(1, 3)).never());
  EXPECT_TRUE(conditions(q(-1, 10)).never()); // n + 1/2 = 2/5 leaves no room for the invariant
  EXPECT_EQ(texts(conditions(q(1, 4)).abelian), "B; g2");
  EXPECT_EQ(texts(conditions(q(1, 10)).abelian), "B; g2");
  EXPECT_EQ(texts(conditions(q(1, 6)).octahedral), "B; g3");
  EXPECT_TRUE(lame_conditions(lame_index(NfElem(-2)), symbols()).never()); // complex n
}

TEST(Lame, FinitePoints) { // on the conditions, one point each
  const std::vector<std::pair<Numbers, GroupType>> all{
      {{q(1, 4), 0, 0, 4}, GroupType::S4},
      {{q(1, 10), 0, 0, 4}, GroupType::A5},
      {{q(1, 6), 0, 4, 0}, GroupType::S4},
      {{q(1, 6), 1, 2160, 19440}, GroupType::A5},
      {{q(3, 10), 3, 30000, 1250000}, GroupType::A5},
      {{q(5, 6), 0, 4, 0}, GroupType::S4},
      {{q(3, 4), 3, -10752, 318464}, GroupType::S4},
      {{q(-5, 4), 0, 0, 1}, GroupType::S4}};
  for (const auto& [x, group] : all) {
    const ClosedAnswer answer = lame_answer(alpha(x.n), parameters(x));
    ASSERT_TRUE(answer.group);
    EXPECT_EQ(answer.group->type, group) << to_string(x.n);
    expect_agreement(x);
    Numbers near = x; // one step aside the group is SL2
    near.b += Rational(1);
    EXPECT_EQ(lame_answer(alpha(near.n), parameters(near)).group->type, GroupType::SL2);
    expect_agreement(near);
  }
}

TEST(Lame, EnginesOnAGrid) {
  std::mt19937 gen(1877);
  const std::vector<Rational> degrees{0,       1,       2,        3,        q(-1, 2), q(1, 2),
                                      q(3, 2), q(5, 2), q(7, 2),  q(1, 3),  q(1, 4),  q(3, 4),
                                      q(1, 6), q(5, 6), q(1, 10), q(3, 10), q(7, 10), q(2, 7)};
  for (const Rational& n : degrees)
    for (int i = 0; i < 5; ++i) {
      const auto number = [&] { return q(static_cast<long>(gen() % 13) - 6, 1 + i % 2); };
      expect_agreement({n, number(), number(), number()});
    }
}

TEST(Lame, OnBrioschisCurves) { // B given, g2 or g3 solved from Q_m = 0
  for (long b = 1; b <= 4; ++b) {
    expect_agreement({q(1, 2), 0, q(b), 1});
    expect_agreement({q(3, 2), q(b), q(4 * b * b, 3), 1});
    for (long g2 = -2; g2 <= 2; ++g2)
      expect_agreement({q(5, 2), q(b), q(g2), q(7 * b * g2 - b * b * b, 20)});
    // Q_4 is linear in g3
    const Rational g3 = (q(63, 2) * q(b * b) - q(b * b * b * b) - q(945, 16)) / q(216 * b);
    expect_agreement({q(7, 2), q(b), 1, g3});
    EXPECT_EQ(lame_answer(alpha(q(7, 2)), {NfElem(q(b)), NfElem(1), NfElem(g3)}).group->type,
              GroupType::D);
  }
}

TEST(Lame, LameFunctions) { // w^2 = 0: T_4
  for (long n = 1; n <= 4; ++n)
    for (long b = 1; b <= 3; ++b) {
      // w^2 as a polynomial in g3 at g2 = 4b, B = b: take a rational root where there is one
      const Rational g2 = q(4 * b);
      const std::vector<Rational> tries{q(4 * b * b * b) - q(b) * g2,
                                        (q(4 * b * b * b) - q(9 * b) * g2) / q(-27), 0};
      for (const Rational& g3 : tries)
        expect_agreement({q(n), q(b), g2, g3});
    }
}

TEST(Lame, DegenerateCurve) { // g2 = 12 a^2, g3 = -8 a^3, and a = 0
  std::mt19937 gen(12);
  for (const Rational& n :
       {q(0), q(1), q(2), q(1, 2), q(3, 2), q(1, 4), q(1, 6), q(-1, 6), q(2, 5)})
    for (const Rational& a : {q(0), q(1), q(-1, 3), q(2)})
      for (int i = 0; i < 4; ++i) {
        const Rational l(static_cast<long>(gen() % 9), 1 + static_cast<long>(gen() % 4));
        const Rational b = is_zero(a) ? q(i) : l * l * q(3) * a - n * (n + Rational(1)) * a;
        expect_agreement({n, b, q(12) * a * a, q(-8) * a * a * a});
      }
  const ThirdExponents l = degenerate_exponents(lame_index(q(1, 6))); // (1/2, 2/3, l)
  EXPECT_EQ(l.classes.size(), 6U); // 1/6 reducible, 1/2 dihedral, 1/3, 1/4, 1/5, 2/5; all modulo 1
}

TEST(Lame, AConstantExponentIsDecided) {
  const ThirdExponents half = degenerate_exponents(lame_index(q(1, 2))); // l in 1/2 + Z
  EXPECT_TRUE(contains_root(half, q(9, 4)));
  EXPECT_FALSE(contains_root(half, q(-1, 12)));
  EXPECT_FALSE(contains_root(half, q(1)));
  EXPECT_FALSE(contains_root(half, q(1, 2)));
  EXPECT_TRUE(contains_root(degenerate_exponents(lame_index(q(1))), q(-7, 3))); // every l
}

TEST(Lame, NumberFields) {
  const Field k = make_field({Integer(-3), Integer(0), Integer(1)}, "s"); // sqrt 3
  const NfElem s = NfElem::generator(k);
  expect_agreement(alpha(q(3, 2)), {NfElem(q(3, 2)) * s, NfElem(9), NfElem(2)}, "Q_2 = 0");
  expect_agreement(alpha(q(3, 2)), {s, NfElem(9), NfElem(2)}, "Q_2 != 0");
  expect_agreement(alpha(q(1)), {s, NfElem(1), s * NfElem(11)}, "w^2 = 0");
  expect_agreement(s, {NfElem(1), NfElem(4), NfElem(1)}, "n irrational");
  expect_agreement(NfElem(-2), {NfElem(1), NfElem(4), NfElem(1)}, "n complex"); // Kovalevskaya
}

TEST(Lame, ParametersOfAMechanicalProblem) { // B, g2, g3 that depend on h and C
  const Ring r = make_ring({"h", "C"});
  const MFraction h = MFraction::variable(r, std::string_view("h"));
  const MFraction c = MFraction::variable(r, std::string_view("C"));
  const MFraction one(r, Rational(1));
  const LameParameters<MFraction> p{-(h * (c - h * h + one)) / (Rational(3) * c),
                                    q(1, 3) * (h * h) + one,
                                    q(-1, 27) * (h * (h * h - q(9) * one))};
  const LameConditions x = lame_conditions(lame_index(q(3, 2)), p);
  EXPECT_EQ(to_string(x.discriminant), "h^4 - 2*h^2 + 1"); // (h^2-1)^2
  ASSERT_EQ(x.abelian.size(), 1U);
  std::mt19937 gen(5);
  for (int i = 0; i < 10; ++i) { // specialisations agree
    const Substitution at{{0, MFraction(r, q(2 + i, 3))}, {1, MFraction(r, q(1 + i % 4, 2))}};
    const auto value = [&](const MFraction& f) { return NfElem(to_rational(substitute(f, at))); };
    const ClosedAnswer number = lame_answer(alpha(q(3, 2)), {value(p.b), value(p.g2), value(p.g3)});
    EXPECT_EQ(number.abelian, truth(is_zero(substitute(x.abelian.front(), at))));
  }
}

} // namespace
} // namespace kov::lame_test
