// The table of Schwarz and Kimura comes out of the finite groups; the engines agree with it.

#include "closed/kimura.hpp"
#include "closed/number_answers.hpp"
#include "closed/polyhedral.hpp"
#include "decide/decide.hpp"
#include "decide/words.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace kov::kimura_test {
namespace {

Rational q(long n, long d = 1) { return {Integer(n), Integer(d)}; }

// [Kimura1969], table on p. 268, as printed: exponents, does the parity of the shifts matter.
struct Row {
  ExponentTriple exponents;
  bool even;
  GroupType group;
};
std::vector<Row> published() {
  using enum GroupType;
  const Rational h = q(1, 2);
  return {{{h, q(1, 3), q(1, 3)}, false, A4},      {{q(2, 3), q(1, 3), q(1, 3)}, true, A4},
          {{h, q(1, 3), q(1, 4)}, false, S4},      {{q(2, 3), q(1, 4), q(1, 4)}, true, S4},
          {{h, q(1, 3), q(1, 5)}, false, A5},      {{q(2, 5), q(1, 3), q(1, 3)}, true, A5},
          {{q(2, 3), q(1, 5), q(1, 5)}, true, A5}, {{h, q(2, 5), q(1, 5)}, false, A5},
          {{q(3, 5), q(1, 3), q(1, 5)}, true, A5}, {{q(2, 5), q(2, 5), q(2, 5)}, true, A5},
          {{q(2, 3), q(1, 3), q(1, 5)}, true, A5}, {{q(4, 5), q(1, 5), q(1, 5)}, true, A5},
          {{h, q(2, 5), q(1, 3)}, false, A5},      {{q(3, 5), q(2, 5), q(1, 3)}, true, A5}};
}

NfElem square(const Rational& e) { return NfElem(e * e); }

ClosedAnswer closed(const ExponentTriple& t) {
  return riemann_answer(SquaredExponents{square(t[0]), square(t[1]), square(t[2])});
}

Decision engines(const ExponentTriple& t) {
  Options options;
  options.want_solutions = false;
  return decide(
      {.r = riemann_equation({square(t[0]), square(t[1]), square(t[2])}), .p = RationalFunction()},
      options);
}

void expect_agreement(const ExponentTriple& t) {
  const std::string name = to_string(t[0]) + ", " + to_string(t[1]) + ", " + to_string(t[2]);
  const ClosedAnswer answer = closed(t);
  const Decision decision = engines(t);
  ASSERT_TRUE(answer.group && decision.group) << name << ": " << reason(decision);
  EXPECT_EQ(describe(*answer.group), describe(*decision.group)) << name << ": " << answer.reason;
  EXPECT_EQ(answer.abelian, decision.abelian) << name;
}

TEST(Kimura, PolyhedralGroups) {
  for (const auto& [type, orders] : std::map<GroupType, std::size_t>{
           {GroupType::A4, 24}, {GroupType::S4, 48}, {GroupType::A5, 120}}) {
    const PolyhedralGroup g(type);
    EXPECT_EQ(g.elements().size(), orders);
    for (const Rational& e : {q(0), q(1)}) // the elements -1 and 1
      EXPECT_EQ(
          std::count_if(g.elements().begin(), g.elements().end(),
                        [&](const Quaternion& x) { return g.exponent_of_real_part(x[0]) == e; }),
          1);
  }
}

TEST(Kimura, TheTableIsThePublishedOne) {
  EXPECT_EQ(schwarz_classes().size(), published().size());
  for (const Row& row : published()) {
    const SchwarzClass* found = schwarz_class(row.exponents);
    ASSERT_NE(found, nullptr) << to_string(row.exponents[0]);
    EXPECT_EQ(found->exponents, row.exponents);
    EXPECT_EQ(found->even, row.even) << to_string(row.exponents[0]);
    EXPECT_EQ(found->group, row.group);
  }
}

TEST(Kimura, EveryRowWithShiftsOfBothParities) {
  std::mt19937 gen(1969);
  for (const SchwarzClass& row : schwarz_classes())
    for (int i = 0; i < 6; ++i) {
      ExponentTriple t = row.exponents;
      std::shuffle(t.begin(), t.end(), gen);
      long sum = 0;
      for (Rational& e : t) {
        const long shift = static_cast<long>(gen() % 5) - 2;
        sum += shift;
        e = (gen() % 2 == 0 ? -e : e) + Rational(shift);
      }
      const ClosedAnswer answer = closed(t);
      if (!row.even || sum % 2 == 0) {
        EXPECT_EQ(answer.group->type, row.group);
      } else {
        EXPECT_NE(answer.group->type, row.group);
      }
      expect_agreement(t);
    }
}

TEST(Kimura, RandomExponentsOfSmallDenominator) {
  std::mt19937 gen(1873);
  std::map<GroupType, int> seen;
  for (int i = 0; i < 250; ++i) {
    ExponentTriple t;
    const long common = 1 + static_cast<long>(gen() % 6);
    for (Rational& e : t)
      e = q(static_cast<long>(gen() % 19) - 9,
            i % 2 == 0 ? common : 1 + static_cast<long>(gen() % 5));
    ++seen[closed(t).group->type];
    expect_agreement(t);
  }
  EXPECT_GE(seen.size(), 6U);
}

TEST(Kimura, ReducibleOnes) {
  std::mt19937 gen(3);
  for (int i = 0; i < 120; ++i) {
    const Rational a = q(static_cast<long>(gen() % 13) - 6, 1 + static_cast<long>(gen() % 4));
    const Rational b = q(static_cast<long>(gen() % 13) - 6, 1 + static_cast<long>(gen() % 3));
    const Rational c = q(1 + 2 * static_cast<long>(gen() % 4)) - a - b;
    const ClosedAnswer answer = closed({a, b, c});
    EXPECT_EQ(kovacic_case(*answer.group), 1);
    expect_agreement({a, b, c});
  }
}

TEST(Kimura, IrrationalExponents) { // squares in Q and in Q(sqrt 2)
  const Field k = make_field({Integer(-2), Integer(0), Integer(1)}, "s");
  const NfElem s = NfElem::generator(k);
  const auto e = [&](const NfElem& x) { return x * x; };
  const NfElem one(1);
  const std::vector<SquaredExponents> all{
      {s, NfElem(q(1, 4)), NfElem(q(1, 4))},             // Dinf
      {s, NfElem(5), NfElem(7)},                         // SL2
      {NfElem(3), NfElem(3), one},                       // 1 = sqrt 3 - sqrt 3 + 1
      {NfElem(3), NfElem(3), NfElem(4)},                 // no odd relation
      {e(s), e(s + one), NfElem(4)},                     // sqrt 2 - (1 + sqrt 2) + 2 = 1
      {e(s), e(s + one), NfElem(q(1, 9))},               //
      {e(s), e(NfElem(3) + s), NfElem(16)},              // 4 is trivial: 3 <= 3
      {e(s), e(NfElem(5) + s), NfElem(16)},              // 4 is not
      {e(s), e(s), NfElem(1)},                           // ordinary third place or a logarithm
      {NfElem(2), NfElem(q(1, 9)), NfElem(q(1, 9))},     //
      {NfElem(-1), NfElem(-1), NfElem(9)},               // purely imaginary
      {NfElem(-1), NfElem(q(1, 4)), NfElem(q(9, 4))},    //
      {e(s + one), e(q(1, 2) * s), e(q(1, 2) * s + one)} // reducible, not diagonal
  };
  for (const SquaredExponents& x : all) {
    const ClosedAnswer answer = riemann_answer(x);
    Options options;
    options.want_solutions = false;
    const Decision d = decide({.r = riemann_equation(x), .p = RationalFunction()}, options);
    ASSERT_TRUE(d.group) << reason(d);
    EXPECT_EQ(describe(*answer.group), describe(*d.group))
        << to_string(x[0]) << ", " << to_string(x[1]) << ", " << to_string(x[2]);
  }
}

TEST(Kimura, ThirdExponentsInFamilies) {
  for (const auto& [l, m] : std::vector<std::pair<Rational, Rational>>{{q(1, 3), q(1, 2)},
                                                                       {q(1, 5), q(3, 2)},
                                                                       {q(2, 3), q(2, 5)},
                                                                       {q(1, 4), q(1, 3)},
                                                                       {q(2), q(1, 2)}}) {
    const ThirdExponents families = abelian_third_exponents(l, m);
    EXPECT_FALSE(families.all);
    for (long n = 0; n <= 240; ++n) { // nu = n/60 covers [0, 4]
      const Rational nu = q(n, 60);
      const bool listed =
          std::any_of(families.classes.begin(), families.classes.end(), [&](const auto& c) {
            const Rational a = (nu - c.nu.a) / c.nu.step;
            const Rational b = (nu + c.nu.a) / c.nu.step;
            return is_integer(a) || is_integer(b);
          });
      EXPECT_EQ(closed({l, m, nu}).abelian, truth(listed)) << to_string(nu);
    }
  }
  EXPECT_TRUE(abelian_third_exponents(q(1, 2), q(-3, 2)).all);
}

} // namespace
} // namespace kov::kimura_test
