#include "galois/jacobian.hpp"

#include "support/random.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

NmodPoly from(mp_limb_t p, const std::vector<long>& c) {
  NmodPoly f(p);
  for (std::size_t i = 0; i < c.size(); ++i) {
    const long r = c[i] % static_cast<long>(p);
    f.set_coeff(static_cast<long>(i), static_cast<mp_limb_t>(r < 0 ? r + static_cast<long>(p) : r));
  }
  return f;
}

// S^2 = G(x) with G squarefree of degree 2g+1.
struct Curve {
  const char* name;
  mp_limb_t p;
  std::vector<long> g;
  [[nodiscard]] NmodPoly equation() const { return from(p, g); }
};
void PrintTo(const Curve& c, std::ostream* out) { *out << c.name; }

class JacobianLaws : public ::testing::TestWithParam<Curve> {
protected:
  NmodPoly g = GetParam().equation();
  mp_limb_t p = GetParam().p;
  Jacobian jacobian{g};
  test::Random random{test::number_in_environment("KOV_RANDOM_SEED", 1)};

  // The class of a point (x, s) - infinity, or nothing if there is none over x.
  [[nodiscard]] std::optional<DivisorClass> point(mp_limb_t x) const {
    const mp_limb_t square = evaluate(g, x);
    const mp_limb_t s = n_sqrtmod(square, p);
    if (s == 0 && square != 0) return std::nullopt;
    NmodPoly v(p);
    v.set_coeff(0, s);
    NmodPoly u = from(p, {0, 1});
    u.set_coeff(0, x == 0 ? 0 : p - x);
    return DivisorClass{u, v};
  }
  [[nodiscard]] DivisorClass random_point() {
    while (true)
      if (const auto d = point(static_cast<mp_limb_t>(random.between(0, static_cast<long>(p) - 1))))
        return *d;
  }
  [[nodiscard]] DivisorClass random_class() {
    DivisorClass sum = jacobian.zero();
    for (long i = random.between(0, 4); i >= 0; --i)
      sum = jacobian.add(sum, random_point());
    return sum;
  }
  [[nodiscard]] DivisorClass minus(const DivisorClass& d) const {
    return jacobian.multiply(d, Integer(-1));
  }
  // Mumford's conditions
  void expect_reduced(const DivisorClass& d) const {
    EXPECT_LE(degree(d.u), jacobian.genus());
    EXPECT_LT(degree(d.v), std::max(degree(d.u), 1L));
    EXPECT_EQ(d.u.coeff(degree(d.u)), 1U);
    const NmodPoly defect = d.v * d.v - g;
    EXPECT_EQ(exact_div(defect, d.u) * d.u, defect);
  }
};

TEST_P(JacobianLaws, CommutativeGroup) {
  const DivisorClass zero = jacobian.zero();
  for (int i = 0; i < 25; ++i) {
    const DivisorClass a = random_class();
    const DivisorClass b = random_class();
    const DivisorClass c = random_class();
    EXPECT_EQ(jacobian.add(a, b), jacobian.add(b, a));
    EXPECT_EQ(jacobian.add(jacobian.add(a, b), c), jacobian.add(a, jacobian.add(b, c)));
    EXPECT_EQ(jacobian.add(a, zero), a);
    EXPECT_EQ(jacobian.add(a, minus(a)), zero);
    EXPECT_EQ(minus(minus(a)), a);
    EXPECT_EQ(minus(jacobian.add(a, b)), jacobian.add(minus(a), minus(b)));
    expect_reduced(jacobian.add(a, b));
  }
}

TEST_P(JacobianLaws, MultiplesAreRepeatedSums) {
  const DivisorClass a = random_class();
  const DivisorClass b = random_class();
  DivisorClass sum = jacobian.zero();
  for (long n = 0; n < 12; ++n, sum = jacobian.add(sum, a)) {
    EXPECT_EQ(jacobian.multiply(a, Integer(n)), sum);
    EXPECT_EQ(jacobian.multiply(a, Integer(-n)), minus(sum));
  }
  EXPECT_EQ(jacobian.multiply(jacobian.multiply(a, Integer(5)), Integer(7)),
            jacobian.multiply(a, Integer(35)));
  EXPECT_EQ(jacobian.multiply(jacobian.add(a, b), Integer(9)),
            jacobian.add(jacobian.multiply(a, Integer(9)), jacobian.multiply(b, Integer(9))));
}

// Cantor's reduction keeps the class: points with product u and interpolated v, all at once, have
// the sum of their classes.
TEST_P(JacobianLaws, ReductionKeepsTheClass) {
  for (int i = 0; i < 10; ++i) {
    std::vector<mp_limb_t> xs, ys;
    DivisorClass sum = jacobian.zero();
    NmodPoly u = from(p, {1});
    while (static_cast<long>(xs.size()) < jacobian.genus() + 3) {
      const DivisorClass d = random_point();
      const mp_limb_t x = d.u.coeff(0) == 0 ? 0 : p - d.u.coeff(0);
      if (std::find(xs.begin(), xs.end(), x) != xs.end()) continue;
      xs.push_back(x);
      ys.push_back(d.v.coeff(0));
      u = u * d.u;
      sum = jacobian.add(sum, d);
    }
    NmodPoly v(p);
    nmod_poly_interpolate_nmod_vec(v.raw(), xs.data(), ys.data(), static_cast<slong>(xs.size()));
    const DivisorClass reduced = jacobian.reduce({u, v});
    expect_reduced(reduced);
    EXPECT_EQ(reduced, sum);
    EXPECT_EQ(jacobian.reduce(reduced), reduced);
  }
}

// A function S - v(x) is worth nothing: the points where it vanishes add up to zero.
TEST_P(JacobianLaws, DivisorsOfFunctionsAreZero) {
  for (int i = 0; i < 10; ++i) {
    NmodPoly v(p);
    for (long j = 0; j <= jacobian.genus(); ++j)
      v.set_coeff(j, random.bits()() % p);
    NmodPoly u = v * v - g; // of degree 2g+1 > 2 deg v
    nmod_poly_make_monic(u.raw(), u.raw());
    EXPECT_EQ(jacobian.reduce({u, v}), jacobian.zero());
  }
}

TEST_P(JacobianLaws, BranchPointsHaveOrderTwo) {
  for (const mp_limb_t x : roots(g)) {
    const DivisorClass d = *point(x);
    EXPECT_EQ(jacobian.add(d, d), jacobian.zero());
    EXPECT_EQ(jacobian.order(d, {}), Integer(2));
  }
  EXPECT_EQ(jacobian.order(jacobian.zero(), {}), Integer(1));
}

TEST_P(JacobianLaws, TheOrderIsTheLeastMultipleThatVanishes) {
  for (int i = 0; i < 5; ++i) {
    const DivisorClass a = random_class();
    const auto n = jacobian.order(a, {});
    ASSERT_TRUE(n);
    EXPECT_EQ(jacobian.multiply(a, *n), jacobian.zero());
    for (long q = 2; q < 2000; ++q) { // no prime can go
      if (!n_is_prime(static_cast<ulong>(q)) || fmpz_divisible_si(n->raw(), q) == 0) continue;
      EXPECT_FALSE(jacobian.multiply(a, exact_div(*n, Integer(q))) == jacobian.zero());
    }
    if (*n <= Integer(300)) {
      long least = 1;
      for (DivisorClass sum = a; !(sum == jacobian.zero()); sum = jacobian.add(sum, a))
        ++least;
      EXPECT_EQ(Integer(least), *n);
    }
    // the order of a multiple
    const DivisorClass tripled = jacobian.multiply(a, Integer(3));
    EXPECT_EQ(jacobian.order(tripled, {}), exact_div(*n, gcd(*n, Integer(3))));
  }
}

// Lagrange: in genus 1 the order divides the number of points, counted one by one.
TEST_P(JacobianLaws, GenusOneOrdersDivideTheNumberOfPoints) {
  if (jacobian.genus() != 1) return;
  long count = 1;
  for (mp_limb_t x = 0; x < p; ++x)
    if (evaluate(g, x) == 0)
      ++count;
    else if (point(x))
      count += 2;
  for (int i = 0; i < 10; ++i)
    EXPECT_EQ(jacobian.multiply(random_class(), Integer(count)), jacobian.zero());
}

INSTANTIATE_TEST_SUITE_P(
    Curves, JacobianLaws,
    ::testing::Values(Curve{"Genus1", 101, {1, 1, 0, 1}}, Curve{"Genus1Split", 97, {0, -1, 0, 1}},
                      Curve{"Genus1Lead", 1009, {5, 0, 3, 2}}, // leading coefficient 2
                      Curve{"Genus2", 103, {1, 0, 0, 0, 0, 1}},
                      Curve{"Genus2Lead", 211, {7, 1, 0, -3, 0, 3}},
                      Curve{"Genus3", 61, {1, 1, 0, 0, 2, 0, 0, 1}},
                      Curve{"SmallField", 7, {1, 0, 1, 0, 0, 1}}),
    [](const auto& test) { return test.param.name; });

// On S^2 = x^n + 1, n odd, the function S - 1 vanishes n times at (0, 1): order n.
TEST(Jacobian, KnownTorsionPoints) {
  for (const long n : {3L, 5L, 7L})
    for (const mp_limb_t p : {1009UL, 97UL}) {
      std::vector<long> c(static_cast<std::size_t>(n) + 1, 0);
      c.front() = c.back() = 1;
      const Jacobian j(from(p, c));
      EXPECT_EQ(j.genus(), (n - 1) / 2);
      EXPECT_EQ(j.order({from(p, {0, 1}), from(p, {1})}, {}), Integer(n));
    }
  const Jacobian j(from(1009, {1, 0, 0, 1}));
  EXPECT_EQ(j.order({from(1009, {-2, 1}), from(1009, {3})}, {}), Integer(6)); // (2, 3)
  EXPECT_EQ(j.order({from(1009, {1, 1}), from(1009, {0})}, {}), Integer(2));  // (-1, 0)
}

TEST(Jacobian, BeyondReachIsSaid) {
  const mp_limb_t p = 2305843009213693951UL;
  const Jacobian j(from(p, {1, 1, 0, 1}));
  EXPECT_FALSE(j.order({from(p, {0, 1}), from(p, {1})}, {}));
}

} // namespace
} // namespace kov
