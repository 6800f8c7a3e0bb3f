#include "exact/ideal.hpp"

#include "exact/error.hpp"
#include "exact/polynomials.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using namespace testing;

class IdealLaws : public Polynomials {
protected:
  static constexpr std::size_t X = 0, Y = 1, Z = 2;

  [[nodiscard]] Ideal make(const std::vector<MFraction>& generators,
                           const std::vector<MFraction>& nonzero = {}) const {
    std::vector<MPoly> g;
    for (const MFraction& f : generators)
      g.push_back(f.num());
    std::vector<MPoly> h;
    for (const MFraction& f : nonzero)
      h.push_back(f.num());
    return {ring, {X, Y, Z}, g, h};
  }
  // Ideals of several shapes: a curve, points, a surface, a parameter in the coefficients, fat
  // ones.
  [[nodiscard]] std::vector<std::vector<MFraction>> examples() const {
    return {{y - x * x, z - x * x * x},
            {x * x + y * y - one, x - y, z},
            {x * y - z * z + a},
            {x * x - a * y, y * y - a * z, z * z - x},
            {x * x, x * y, y * y, z - a},
            {x * (x - one), x * y, (x - one) * z},
            {a * x + y - one, x - a * y, z * z - Rational(2) * one},
            {x * y * z - one, x + y + z - a},
            {x * x + y + z - one, x + y * y + z - one, x + y + z * z - one},
            {x * x * y - z * z, x * z - y * y, y * y * y - x * x * z + a * x},
            {x + y + z - one, x * x + y * y + z * z - a, x * x * x + y * y * y + z * z * z}};
  }
  [[nodiscard]] static Monomial lead(const KPoly& f) { return f.begin()->first; }
  [[nodiscard]] static bool divides(const Monomial& m, const Monomial& n) {
    for (std::size_t i = 0; i < m.size(); ++i)
      if (m[i] > n[i]) return false;
    return true;
  }
  [[nodiscard]] MFraction monomial(const Monomial& m) const {
    return pow(x, m[0]) * pow(y, m[1]) * pow(z, m[2]);
  }
};

TEST_F(IdealLaws, EveryCombinationOfTheGeneratorsIsAMember) {
  for (const auto& generators : examples()) {
    const Ideal ideal = make(generators);
    for (int i = 0; i < 5; ++i) {
      MFraction sum(ring);
      for (const MFraction& g : generators)
        sum += MFraction(poly(3, 1)) * g;
      EXPECT_TRUE(ideal.contains(sum.num())) << to_string(sum);
      EXPECT_TRUE(is_zero(ideal.normal_form(sum)));
    }
  }
}

TEST_F(IdealLaws, TheNormalFormIsLinearIdempotentAndMultiplicative) {
  for (const auto& generators : examples()) {
    const Ideal ideal = make(generators);
    const auto nf = [&](const MFraction& f) { return ideal.normal_form(f); };
    for (int i = 0; i < 4; ++i) {
      const MFraction f{poly(4, 1)};
      const MFraction g{poly(4, 1)};
      EXPECT_EQ(nf(nf(f)), nf(f));
      EXPECT_EQ(nf(f + a * g), nf(f) + a * nf(g));
      EXPECT_EQ(nf(f * g), nf(nf(f) * nf(g)));
      EXPECT_TRUE(ideal.contains((f - nf(f)).num()));
      for (const auto& [m, c] : ideal.reduce(f)) // nothing left to divide
        for (const KPoly& b : ideal.basis())
          EXPECT_FALSE(divides(lead(b), m));
    }
  }
}

// Buchberger's criterion, stated again here: the basis is a Groebner basis, and the reduced one.
TEST_F(IdealLaws, TheBasisIsTheReducedGroebnerBasis) {
  for (const auto& generators : examples()) {
    const Ideal ideal = make(generators);
    const auto& basis = ideal.basis();
    for (std::size_t i = 0; i < basis.size(); ++i) {
      EXPECT_TRUE(is_one(basis[i].begin()->second)); // monic
      for (const auto& [m, c] : basis[i])
        for (std::size_t j = 0; j < basis.size(); ++j)
          if (j != i) {
            EXPECT_FALSE(divides(lead(basis[j]), m));
          }
      for (std::size_t j = 0; j < i; ++j) {
        Monomial l = lead(basis[i]);
        for (std::size_t v = 0; v < l.size(); ++v)
          l[v] = std::max(l[v], lead(basis[j])[v]);
        const MFraction s = monomial(l) / monomial(lead(basis[i])) * ideal.from_kpoly(basis[i]) -
                            monomial(l) / monomial(lead(basis[j])) * ideal.from_kpoly(basis[j]);
        EXPECT_TRUE(is_zero(ideal.normal_form(s)));
      }
    }
  }
}

TEST_F(IdealLaws, OtherGeneratorsOfTheSameIdealGiveTheSameBasis) {
  for (const auto& generators : examples()) {
    std::vector<MFraction> mixed(generators.rbegin(), generators.rend());
    for (std::size_t i = 1; i < mixed.size(); ++i)
      mixed[i] += (x - a * y) * mixed[i - 1];
    mixed.push_back(mixed.front() * z);
    mixed.emplace_back(ring);
    EXPECT_EQ(make(mixed).basis(), make(generators).basis());
  }
}

// The ideal of known points: membership is vanishing at each of them.
TEST_F(IdealLaws, MembershipInTheIdealOfPointsIsVanishing) {
  const Ideal points = make({y - x * x, z - one, (x - one) * (x - Rational(2) * one) * (x + a)});
  const auto at = [&](const MFraction& f, const MFraction& t) {
    return substitute(f, {{X, t}, {Y, t * t}, {Z, one}});
  };
  int members = 0;
  for (int i = 0; i < 40; ++i) {
    MFraction f{poly(3, 2)};
    if (i % 2 == 0) f = f * (x - one) * (y - Rational(4) * one) * (x + a);
    const bool vanishes =
        is_zero(at(f, one)) && is_zero(at(f, Rational(2) * one)) && is_zero(at(f, -a));
    EXPECT_EQ(points.contains(f.num()), vanishes) << to_string(f);
    EXPECT_EQ(points.vanishes(f.num()), vanishes);
    members += vanishes ? 1 : 0;
  }
  EXPECT_GE(members, 20);
}

TEST_F(IdealLaws, DimensionAndIndependentVariables) {
  const std::vector<int> dimensions{1, 0, 2, 0, 0, 1, 0, 1, 0, 0, 0};
  const auto all = examples();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Ideal ideal = make(all[i]);
    EXPECT_EQ(ideal.dimension(), dimensions[i]) << i;
    EXPECT_EQ(ideal.independent_variables().size(), static_cast<std::size_t>(dimensions[i]));
    EXPECT_FALSE(ideal.is_unit());
    // no polynomial in the independent variables alone is a member
    MFraction f = one;
    for (const std::size_t v : ideal.independent_variables())
      f = f * (MFraction::variable(ring, v) + a) + one;
    EXPECT_FALSE(ideal.contains(f.num()));
  }
  const Ideal nothing = make({});
  EXPECT_TRUE(nothing.is_zero_ideal());
  EXPECT_EQ(nothing.dimension(), 3);
  const Ideal everything = make({x - one, x});
  EXPECT_TRUE(everything.is_unit());
  EXPECT_EQ(everything.dimension(), -1);
  EXPECT_TRUE(make({a}).is_unit()); // a parameter is invertible
}

// Bezout: complete intersections of degrees d1, d2, d3 without points at infinity.
TEST_F(IdealLaws, StandardMonomialsCountThePoints) {
  for (long d1 = 1; d1 <= 3; ++d1)
    for (long d2 = 1; d2 <= 2; ++d2)
      for (long d3 = 1; d3 <= 2; ++d3) {
        const Ideal i = make({pow(x, d1) - y + a, pow(y, d2) - z * one, pow(z, d3) - a * one});
        EXPECT_EQ(i.standard_monomials().size(), static_cast<std::size_t>(d1 * d2 * d3));
        for (const Monomial& m : i.standard_monomials())
          EXPECT_EQ(i.normal_form(monomial(m)), monomial(m));
      }
  EXPECT_THROW((void)make({x * y}).standard_monomials(), InternalError);
}

// f is in I : g^infinity exactly when g^n f is in I for some n.
TEST_F(IdealLaws, SaturationByDefinition) {
  const struct {
    std::vector<MFraction> generators;
    MFraction g;
    std::vector<MFraction> inside, outside;
  } table[] = {{{x * (y - a)}, x, {y - a, x * (y - a)}, {x, y, one}},
               {{x * x * y, x * z}, x, {y, z, x * y}, {x, one}},
               {{x * x * y, x * z}, y, {x * x, x * z}, {x, z}},
               {{(x - y) * (x - z), (x - y) * y * y}, x - y, {x - z, y * y}, {y, x - y}}};
  for (const auto& [generators, g, inside, outside] : table) {
    const Ideal plain = make(generators);
    const Ideal saturated = make(generators, {g});
    const auto pushed_in = [&](const MFraction& f) {
      for (long n = 0; n <= 4; ++n)
        if (plain.contains((f * pow(g, n)).num())) return true;
      return false;
    };
    for (const MFraction& f : inside) {
      EXPECT_TRUE(saturated.contains(f.num())) << to_string(f);
      EXPECT_TRUE(pushed_in(f));
    }
    for (const MFraction& f : outside) {
      EXPECT_FALSE(saturated.contains(f.num())) << to_string(f);
      EXPECT_FALSE(pushed_in(f));
    }
  }
  EXPECT_TRUE(make({x}, {x}).is_unit());
  EXPECT_TRUE(make({x, y}, {MFraction(ring)}).is_unit()); // where 0 is not 0 there is no point
  EXPECT_TRUE(make({}, {MFraction(ring)}).is_unit());
  EXPECT_EQ(make({x}, {one, Rational(-3) * one}).basis(), make({x}).basis());
}

TEST_F(IdealLaws, SaturationByAProductIsSaturationByEachFactor) {
  const std::vector<MFraction> generators{x * y * (z - a), x * (y - one) * z};
  EXPECT_EQ(make(generators, {x, y}).basis(), make(generators, {x * y}).basis());
  EXPECT_EQ(make(generators, {x, y, z}).basis(), make(generators, {x * x * y * z * z}).basis());
}

TEST_F(IdealLaws, VanishingIsMembershipOfAPower) {
  for (const auto& generators : examples()) {
    const Ideal ideal = make(generators);
    for (const MFraction& f : {x, y, z, x - y, x * y, z - a, x * (y - one), generators.front()}) {
      bool power = false;
      for (long n = 1; n <= 4 && !power; ++n)
        power = ideal.contains(pow(f, n).num());
      EXPECT_EQ(ideal.vanishes(f.num()), power) << to_string(f);
    }
  }
  EXPECT_TRUE(make({one}).vanishes(x.num()));
  EXPECT_TRUE(make({one}).vanishes(one.num()));
  EXPECT_FALSE(make({x}).vanishes(one.num()));
}

// What is proved over Q(a) holds at every value of a at which nothing inverted vanishes.
TEST_F(IdealLaws, GenericMembershipHoldsWhereNothingInvertedVanishes) {
  const std::vector<MFraction> generators{(a * a - one) * x - y, x * y - one, z - x};
  const Ideal generic = make(generators);
  std::vector<std::string> names;
  for (const MPoly& f : generic.inverted())
    names.push_back(to_string(f));
  EXPECT_EQ(names, (std::vector<std::string>{"a - 1", "a + 1"}));
  const MFraction member = (a * a - one) * x * x - one;
  ASSERT_TRUE(generic.contains(member.num()));
  for (const long value : {-3L, 0L, 2L, 5L}) {
    const Substitution at{{3, MFraction(ring, Rational(value))}};
    std::vector<MFraction> special;
    for (const MFraction& g : generators)
      special.push_back(substitute(g, at));
    EXPECT_TRUE(make(special).contains(substitute(member, at).num())) << value;
  }
  const Substitution exception{{3, one}};
  std::vector<MFraction> special;
  for (const MFraction& g : generators)
    special.push_back(substitute(g, exception));
  EXPECT_TRUE(make(special).is_unit()); // y = 0 and x y = 1: another ideal
}

TEST_F(IdealLaws, TheMonomialOrderIsAnOrderCompatibleWithProducts) {
  std::vector<Monomial> all;
  for (std::uint32_t i = 0; i < 27; ++i)
    all.push_back({i % 3, i / 3 % 3, i / 9});
  for (const std::size_t eliminate : {0UL, 1UL}) {
    const MonomialOrder before{eliminate};
    for (const Monomial& m : all)
      for (const Monomial& n : all) {
        EXPECT_EQ(before(m, n) || before(n, m), m != n);
        EXPECT_FALSE(before(m, n) && before(n, m));
        Monomial mx = m, nx = n;
        ++mx[1], ++nx[1];
        EXPECT_EQ(before(mx, nx), before(m, n));
        if (m != n && divides(m, n)) {
          EXPECT_TRUE(before(n, m)); // 1 is the least
        }
        if (eliminate == 1 && m.back() > n.back()) {
          EXPECT_TRUE(before(m, n));
        }
      }
  }
}

TEST_F(IdealLaws, PolynomialsOverTheParametersAndBack) {
  const Ideal ideal = make({});
  for (int i = 0; i < 10; ++i) {
    const MFraction f = MFraction(poly(5)) / (a * a + Rational(3) * one);
    EXPECT_EQ(ideal.from_kpoly(ideal.to_kpoly(f)), f);
  }
  EXPECT_THROW((void)ideal.to_kpoly(one / x), InvalidArgument);
  EXPECT_THROW(Ideal(ring, {X, X}, {}), InvalidArgument);
}

TEST_F(IdealLaws, TheBudgetIsAsked) {
  Budget late = Budget::of_seconds(0);
  late.deadline = *late.deadline - std::chrono::seconds(1);
  EXPECT_THROW(Ideal(ring, {X, Y, Z}, {(x * x - a * y).num(), (x * y - z).num(), (x * z - y).num()},
                     {}, late),
               OutOfBudget);
}

} // namespace
} // namespace kov
