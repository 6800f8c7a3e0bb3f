// The pieces that a verdict is made of, each against what it means at points: places, arithmetic
// conditions, exponents of exponential solutions, their polynomials, logarithmic integrals.

#include "closed/parts.hpp"
#include "strata/at_point.hpp"
#include "strata/bounds.hpp"
#include "strata/exponent_sums.hpp"
#include "strata/exponential_families.hpp"
#include "strata/families.hpp"
#include "strata/log_integral.hpp"
#include "strata/uniform.hpp"

namespace kov::strata::pieces_test {
namespace {

using test::ExactPoint;
using test::Family;
using test::Random;
using test::random_exact_point;
using test::random_rounds;

const Ring& ring = test::family_ring;
const MFraction z = MFraction::variable(ring, "z");
const MFraction a = MFraction::variable(ring, "a");
const MFraction b = MFraction::variable(ring, "b");
const MFraction n = MFraction::variable(ring, "n");
const MFraction one(ring, Rational(1));
const ParametrisedSet everywhere(ring, {});

MFraction number(long p, long q = 1) { return MFraction(ring, Rational(p, q)); }

/// The places where all that matters does not vanish, and that region.
std::pair<Scheme, ParametrisedSet> generic_scheme(const MFraction& r) {
  ParametrisedSet region = everywhere;
  for (;;) {
    auto found = scheme(r, 0, region);
    if (const auto* needs = std::get_if<Needs>(&found))
      region = region.where_nonzero(needs->p);
    else
      return {std::get<Scheme>(std::move(found)), region};
  }
}

template <class Visit>
void at_generic_points(const MFraction& r, const ParametrisedSet& region, int points, Visit visit) {
  Question q;
  q.r = r;
  Random random(20);
  for (int k = 0; k < points; ++k) {
    const ExactPoint point = random_exact_point(q, random, k % 3 == 0);
    const bool here =
        std::ranges::all_of(region.path(), [&](const Condition& c) { return point.holds(c); });
    if (!here) continue;
    SCOPED_TRACE(point.text(ring));
    visit(point);
  }
}

bool is_irregular(PlaceKind kind) {
  return kind == PlaceKind::irregular || kind == PlaceKind::ramified;
}

class Places : public testing::TestWithParam<Family> {};

// Kind, order, exponent difference and logarithm at the places of degree 1.
TEST_P(Places, AreThoseOfTheEquationWithNumbers) {
  const auto [s, region] = generic_scheme(GetParam().r);
  const Scheme& places = s;
  at_generic_points(s.r, region, 12, [&](const ExactPoint& point) {
    const RationalFunction r = point.equation(places.r);
    if (is_zero(r)) return; // no places
    const Singularities there = singularities(r);
    for (PlaceIndex i = 0; i < number_of_places(places); ++i) {
      const ParametricPlace& p = place_at(places, i);
      if (p.degree(0) != 1) continue;
      Singularity found;
      if (p.at_infinity) {
        found = there.infinity;
      } else {
        const auto line = coefficients(p.q, 0);
        const NfElem at = -point(MFraction(line[0]) / MFraction(line[1]));
        for (const Singularity& t : there.finite)
          if (degree(t.place) == 1 && t.place.coeff(0) == -at) found = t;
      }
      SCOPED_TRACE(place_name(p, 0));
      if (is_irregular(p.kind)) {
        EXPECT_EQ(found.kind, p.kind);
        EXPECT_EQ(p.at_infinity ? 4 - found.order : found.order, p.order);
        continue;
      }
      EXPECT_FALSE(is_irregular(found.kind));
      const NfElem square = found.delta_squared.coeff(0);
      const bool rational = p.exponent == ExponentKind::rational;
      if (rational || p.chi.size() == 2) {
        EXPECT_EQ(square, rational ? NfElem(p.delta * p.delta) : -point(p.chi[0] / p.chi[1]));
      }
      EXPECT_FALSE(p.exponent == ExponentKind::irrational && found.delta);
      EXPECT_FALSE(p.log == Truth::yes && found.log != Truth::yes);
      EXPECT_FALSE(rational && p.log == Truth::no && found.log == Truth::yes);
    }
  });
}

// No exponential solution where its exponents do not add up to a natural number.
TEST_P(Places, ExponentsOfAnExponentialSolutionAddUp) {
  const auto [s, region] = generic_scheme(GetParam().r);
  const auto needs = exponential_needs(s);
  const bool never = exponential_bound(s).excludes();
  const auto* sum = needs ? std::get_if<SumIn>(&*needs) : nullptr;
  if (!needs && !never) return;
  at_generic_points(s.r, region, 6, [&](const ExactPoint& point) {
    if (!never && sum != nullptr && is_so(Statement{*sum}, point)) return;
    NormalForm equation;
    equation.r = point.equation(GetParam().r);
    Options options;
    options.want_solutions = false;
    const Decision d = decide(equation, options);
    EXPECT_FALSE(d.group && kovacic_case(*d.group) == 1) << reason(d);
  });
}

INSTANTIATE_TEST_SUITE_P(OfFamilies, Places, testing::ValuesIn(test::families()),
                         [](const auto& one) { return std::string(one.param.name); });

// P'' + 2 omega P' + (omega' + omega^2 - r) P = 0 where the conditions hold.
TEST(Exponential, ItsPolynomialSolvesWhereTheConditionsHold) {
  int solved = 0;
  for (const MFraction& r : {z * z + a, number(1, 4) - a / z + (b * b - number(1, 4)) / (z * z),
                             z * z + a + number(2) / (z * z), z * z * z * z + a * z}) {
    const auto [s, region] = generic_scheme(r);
    const auto families = families_of_exponents(s);
    EXPECT_EQ(families.missing, "");
    for (const ExponentialFamily& f : families.all)
      for (const long d : {0L, 1L, 2L, 3L}) {
        const PolynomialPart part = polynomial_part(s, f, d, region);
        if (part.conditions.empty() || part.p.empty()) continue;
        ASSERT_EQ(part.p.size(), static_cast<std::size_t>(d) + 1);
        EXPECT_TRUE(is_one(part.p.back()));
        MFraction P(ring);
        for (std::size_t k = part.p.size(); k-- > 0;)
          P = P * z + part.p[k];
        const MFraction slope = derivative(P, 0);
        const MFraction rest = derivative(slope, 0) + number(2) * f.omega * slope +
                               (derivative(f.omega, 0) + f.omega * f.omega - r) * P;
        if (part.conditions.size() != 1) continue;
        const auto there = region.where_zero(part.conditions.front());
        const auto* on = std::get_if<ParametrisedSet>(&there);
        if (on == nullptr) continue;
        ++solved;
        EXPECT_TRUE(is_zero(on->restrict(rest)))
            << to_string(r) << ", degree " << d << ": " << to_string(P);
      }
  }
  EXPECT_GT(solved, 4);
}

TEST(Exponential, OneForAllParametersSolvesTheEquation) {
  int found = 0;
  random_rounds(10, [&](Random& random) {
    const auto c = [&] {
      const MFraction x = random.one_of(std::vector<MFraction>{a, b, n, a + b, one});
      return Rational(random.between(1, 5), random.between(1, 2)) * x;
    };
    const MFraction omega = random.once_in(2) ? c() + c() / z : c() * z + c() / (z - b);
    const MFraction r = derivative(omega, 0) + omega * omega;
    const auto [s, region] = generic_scheme(r);
    const auto w = exponential_solutions(s, region).w;
    if (!w) return;
    ++found;
    EXPECT_EQ(derivative(*w, 0) + *w * *w, r);
  });
  EXPECT_GT(found, 4);
}

TEST(Exponential, ALogarithmicIntegralIsUndoneByTheDerivative) {
  random_rounds(20, [](Random& random) {
    const auto c = [&] {
      const MFraction x = random.one_of(std::vector<MFraction>{a, b, one, a / b, one / (a + n)});
      return Rational(random.between(-4, 5), random.between(1, 3)) * x;
    };
    const MFraction q = z * z + a * z + b;
    const MFraction w =
        c() / (z - a) + c() / ((z - b) * (z - b)) + c() * z * z + c() + c() * derivative(q, 0) / q;
    const auto y = log_integral(w, 0);
    ASSERT_TRUE(y) << to_string(w);
    EXPECT_EQ(log_derivative(*y, 0), w);
    for (const auto& [base, power] : y->powers)
      EXPECT_FALSE(uses(power, 0));
  });
  const MFraction q = z * z - a;
  EXPECT_FALSE(log_integral(one / q, 0)); // the residues at +-sqrt(a) differ
  EXPECT_FALSE(log_integral(z / (q * q), 0));
  EXPECT_EQ(log_integral(MFraction(ring), 0)->powers.size(), 0U);
}

TEST(Uniform, AnInvariantHoldsWherePlacesMeet) {
  random_rounds(6, [](Random& random) {
    const auto c = [&] { return number(random.between(1, 4), random.between(1, 3)); };
    const MFraction v = z * z * z + c() * a * z + b, phi = derivative(v, 0) / (number(2) * v);
    Question q;
    q.r = c() * n / v + derivative(phi, 0) / number(2) + phi * phi / number(4);
    const auto leaf = abelian_for_all(q.r, 0, everywhere, {});
    ASSERT_TRUE(leaf) << to_string(q.r);
    EXPECT_EQ(leaf->abelian, Truth::yes);
    for (int k = 0; k < 6; ++k) {
      const ExactPoint point = random_exact_point(q, random, false);
      NormalForm equation;
      equation.r = point.equation(q.r);
      Options options;
      options.want_solutions = false;
      EXPECT_NE(decide(equation, options).abelian, Truth::no) << point.text(ring);
    }
  });
}

// ---- arithmetic conditions on one number

Statement random_condition(Random& random) {
  const auto square = [&] {
    const MFraction x =
        random.one_of(std::vector<MFraction>{a, number(2) * a, a + number(1, 2), a - number(1, 3),
                                             a / number(2), one - a, number(1, 2), number(3)});
    return x * x;
  };
  const bool holds = random.once_in(2);
  switch (random.between(1, 6)) {
  case 1:
    return {
        SumIn{{square()}, {{Rational(random.between(0, 3), 2), Rational(random.between(1, 2))}}},
        holds};
  case 2:
    return {SumIn{{square(), square()}, {{Rational(random.between(0, 2), 3), Rational(1)}}}, holds};
  case 3:
    return {AllRational{{square()}}, holds};
  case 4:
    return {SomeIn{{square(), square()}, Classes{half_integers}}, holds};
  case 5:
    return {Separated{{square(), square()}}, holds};
  default:
    return {WithoutLogarithm{{square(), square(), square()}}, holds};
  }
}

std::vector<NfElem> values_of_a() {
  const NfElem root = NfElem::generator(make_field({-2, 0, 1}, "w"));
  std::vector<NfElem> all{root, root + NfElem(Rational(1, 2))};
  for (const long d : {1, 2, 3, 4, 6, 7})
    for (long k = -5 * d; k <= 5 * d; ++k)
      all.emplace_back(Rational(k, d));
  return all;
}

bool all_hold(const std::vector<Statement>& all, const NfElem& where_a_is) {
  const ExactPoint point(0, {{1, where_a_is}, {2, NfElem(0)}, {3, NfElem(0)}});
  return std::ranges::all_of(all, [&](const auto& c) { return is_so(c, point); });
}

// Proved empty: no point. Known on the region: so at each of its points.
TEST(Arithmetic, WhatIsProvedOfAConditionHoldsAtPoints) {
  Assumptions of_integers, of_rationals;
  of_integers.require_integral(a, true);
  of_rationals.declare_rational(a);
  const std::vector<NfElem> values = values_of_a();
  int empty = 0, known = 0;
  random_rounds(150, [&](Random& random) {
    const long which = random.between(0, 2);
    const ParametrisedSet region(ring, which == 0   ? Assumptions{}
                                       : which == 1 ? of_integers
                                                    : of_rationals);
    const auto admitted = [&](const NfElem& x) {
      return which == 0 || (is_rational(x) && (which == 2 || is_integer(to_rational(x))));
    };
    std::vector<Statement> all;
    for (long k = random.between(1, 3); k > 0; --k)
      all.push_back(random_condition(random));
    std::string text;
    for (const Statement& c : all)
      text += to_string(c) + "; ";
    SCOPED_TRACE(text + std::to_string(which));
    if (proved_empty(all, region)) {
      ++empty;
      for (const NfElem& x : values)
        EXPECT_FALSE(admitted(x) && all_hold(all, x)) << to_string(x);
    }
    const Statement last = all.back();
    all.pop_back();
    const Truth here = holds_on(last.says, all, region);
    if (here == Truth::unknown) return;
    ++known;
    for (const NfElem& x : values)
      if (admitted(x) && all_hold(all, x)) {
        EXPECT_EQ(all_hold({Statement{last.says}}, x), here == Truth::yes) << to_string(x);
      }
  });
  EXPECT_GT(empty, 10);
  EXPECT_GT(known, 10);
}

// Both sides of a split are visited, but for those without points; together they are everything.
TEST(Arithmetic, PartsCoverAndAreDisjoint) {
  random_rounds(40, [](Random& random) {
    Parts parts(everywhere);
    const Assertion s = random_condition(random).says, t = random_condition(random).says;
    const auto leaf = [&] { parts.add(Truth::yes, GroupBound::unknown); };
    parts.split(
        s, [&] { parts.split(t, leaf, leaf); }, leaf);
    const auto all = parts.take();
    EXPECT_GE(all.size(), 1U);
    EXPECT_LE(all.size(), 3U);
    for (const NfElem& x : values_of_a()) {
      const auto here =
          std::ranges::count_if(all, [&](const Part& p) { return all_hold(p.where, x); });
      EXPECT_EQ(here, 1) << to_string(Statement{s}) << "; " << to_string(Statement{t}) << " at "
                         << to_string(x);
    }
  });
}

} // namespace
} // namespace kov::strata::pieces_test
