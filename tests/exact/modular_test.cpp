#include "exact/modular.hpp"

#include "exact/error.hpp"
#include "exact/fields.hpp"
#include "exact/laws.hpp"

#include <gtest/gtest.h>

#include <set>

namespace kov {
namespace {

using namespace testing;

// Polynomials over F_p, for small, middle and word-size primes.
class ModularLaws : public ::testing::TestWithParam<mp_limb_t> {
protected:
  mp_limb_t p = GetParam();
  std::mt19937_64 gen{p};
  [[nodiscard]] NmodPoly poly(long n) {
    NmodPoly f(p);
    for (long i = 0; i <= n; ++i)
      f.set_coeff(i, gen() % p);
    return f;
  }
  [[nodiscard]] NmodPoly constant(mp_limb_t c) const {
    NmodPoly f(p);
    f.set_coeff(0, c % p);
    return f;
  }
  [[nodiscard]] NmodPoly z() const {
    NmodPoly f(p);
    f.set_coeff(1, 1);
    return f;
  }
  // f(g), by Horner's rule
  [[nodiscard]] NmodPoly compose(const NmodPoly& f, const NmodPoly& g) const {
    NmodPoly value(p);
    for (long i = degree(f); i >= 0; --i)
      value = value * g + constant(f.coeff(i));
    return value;
  }
};

NmodPoly operator-(const NmodPoly& f) { return NmodPoly(f.modulus()) - f; }

TEST_P(ModularLaws, CommutativeRingWithoutZeroDivisors) {
  for (int i = 0; i < 12; ++i) {
    const NmodPoly a = poly(6);
    const NmodPoly b = poly(3);
    const NmodPoly c = poly(4);
    EXPECT_EQ(a + b, b + a);
    EXPECT_EQ((a + b) + c, a + (b + c));
    EXPECT_EQ(a - b, a + (-b));
    EXPECT_EQ((a * b) * c, a * (b * c));
    EXPECT_EQ(a * (b + c), a * b + a * c);
    EXPECT_EQ(a * constant(1), a);
    domain_laws(a, b);
    value_laws(a, b);
    derivation_laws(a, b, [](const NmodPoly& f) { return derivative(f); });
    const mp_limb_t s = gen() % p;
    EXPECT_EQ(scale(a, s), a * constant(s));
  }
}

TEST_P(ModularLaws, AssignmentTakesTheModulusAlong) {
  NmodPoly a(3);
  NmodPoly b = poly(2);
  b.set_coeff(2, 1);
  a = b;
  EXPECT_EQ(a.modulus(), p);
  EXPECT_EQ((a * a).coeff(4), 1U);
  NmodPoly c(std::move(b));
  EXPECT_EQ(c, a);
}

TEST_P(ModularLaws, GcdDividesAndIsGreatest) {
  for (int i = 0; i < 10; ++i) {
    const NmodPoly g = poly(2) + compose(z() * z() * z(), z()); // monic of degree 3
    const NmodPoly a = g * (poly(2) + z() * z() * z());
    const NmodPoly b = g * (poly(1) + z() * z());
    const NmodPoly d = gcd(a, b);
    EXPECT_EQ(exact_div(a, d) * d, a);
    EXPECT_EQ(exact_div(b, d) * d, b);
    EXPECT_EQ(exact_div(d, g) * g, d); // a multiple of every common factor
    EXPECT_EQ(degree(gcd(exact_div(a, d), exact_div(b, d))), 0);
  }
}

TEST_P(ModularLaws, PowerSeries) {
  for (const long n : {1L, 4L, 9L}) {
    NmodPoly f = poly(5);
    f.set_coeff(0, 1 + gen() % (p - 1));
    const NmodPoly g = poly(7);
    EXPECT_EQ(mul_series(f, g, n), truncate(f * g, n));
    EXPECT_EQ(truncate(f * inverse_series(f, n), n), constant(1));
    EXPECT_EQ(pow_series(f, 5, n), truncate(f * f * f * f * f, n));
    EXPECT_EQ(pow_series(f, 0, n), constant(1));
  }
}

TEST_P(ModularLaws, TaylorShiftAndEvaluation) {
  for (int i = 0; i < 8; ++i) {
    const NmodPoly f = poly(p > 7 ? 6 : 1); // FLINT divides by factorials
    const mp_limb_t c = gen() % p;
    EXPECT_EQ(taylor_shift(f, c), compose(f, z() + constant(c)));
    EXPECT_EQ(evaluate(taylor_shift(f, c), 0), evaluate(f, c));
    EXPECT_EQ(taylor_shift(taylor_shift(f, c), c == 0 ? 0 : p - c), f);
    const NmodPoly g = poly(4);
    EXPECT_EQ(evaluate(f * g, c), nmod_mul(evaluate(f, c), evaluate(g, c), f.mod()));
  }
}

TEST_P(ModularLaws, RootsAreThosePlanted) {
  for (int i = 0; i < 6; ++i) {
    NmodPoly f = constant(1 + gen() % (p - 1));
    std::set<mp_limb_t> planted;
    for (int j = 0; j < 5; ++j) {
      const mp_limb_t root = gen() % p;
      planted.insert(root);
      f = f * (z() - constant(root));
    }
    EXPECT_EQ(roots(f), std::vector<mp_limb_t>(planted.begin(), planted.end()));
  }
  EXPECT_TRUE(roots(constant(1)).empty());
  EXPECT_THROW((void)roots(NmodPoly(p)), InvalidArgument);
}

INSTANTIATE_TEST_SUITE_P(Primes, ModularLaws,
                         ::testing::Values(2UL, 3UL, 5UL, 7UL, 101UL, 65537UL,
                                           2305843009213693951UL,  // 2^61 - 1
                                           9223372036854775783UL), // the largest below 2^63
                         ::testing::PrintToStringParamName());

// All polynomials of degree at most 4 over the smallest fields: their roots are what values show.
TEST(Roots, OfAllPolynomialsOverSmallFields) {
  for (const mp_limb_t p : {2UL, 3UL, 5UL}) {
    const long n = p == 5 ? 3 : 4;
    mp_limb_t count = 1;
    for (long i = 0; i <= n; ++i)
      count *= p;
    for (mp_limb_t code = 1; code < count; ++code) {
      NmodPoly f(p);
      mp_limb_t rest = code;
      for (long i = 0; i <= n; ++i, rest /= p)
        f.set_coeff(i, rest % p);
      std::vector<mp_limb_t> expected;
      for (mp_limb_t x = 0; x < p && degree(f) > 0; ++x)
        if (evaluate(f, x) == 0) expected.push_back(x);
      EXPECT_EQ(roots(f), expected) << code << " in base " << p;
    }
  }
}

TEST(Roots, OfQuadraticPolynomialsAreThoseThatTheValuesShow) {
  for (const mp_limb_t p : {3UL, 5UL, 7UL, 13UL, 17UL, 31UL})
    for (mp_limb_t lead = 1; lead < p; lead += p / 2)
      for (mp_limb_t b = 0; b < p; ++b)
        for (mp_limb_t c = 0; c < p; ++c) {
          NmodPoly f(p);
          f.set_coeff(0, c);
          f.set_coeff(1, b);
          f.set_coeff(2, lead);
          std::vector<mp_limb_t> expected;
          for (mp_limb_t x = 0; x < p; ++x)
            if (evaluate(f, x) == 0) expected.push_back(x);
          EXPECT_EQ(roots(f), expected) << lead << " " << b << " " << c << " mod " << p;
        }
}

// ---- reduction of a number field

class ReductionLaws : public OverFields {};

TEST_P(ReductionLaws, ReductionIsARingMap) {
  PrimeIdeals primes = PrimeIdeals::large(k);
  for (int i = 0; i < 3; ++i) {
    const PrimeIdeal prime = primes.next();
    nmod_t mod;
    nmod_init(&mod, prime.p);
    for (int j = 0; j < 5; ++j) {
      const NfElem a = element();
      const NfElem b = nonzero();
      EXPECT_EQ(*prime.reduce(a + b), nmod_add(*prime.reduce(a), *prime.reduce(b), mod));
      EXPECT_EQ(*prime.reduce(a * b), nmod_mul(*prime.reduce(a), *prime.reduce(b), mod));
      EXPECT_EQ(*prime.reduce(a / b), nmod_div(*prime.reduce(a), *prime.reduce(b), mod));
      const Poly f = poly(5);
      const Poly g = poly(4);
      EXPECT_EQ(*prime.reduce(f) * *prime.reduce(g), *prime.reduce(f * g));
      EXPECT_EQ(*prime.reduce(f) + *prime.reduce(g), *prime.reduce(f + g));
      EXPECT_EQ(*prime.reduce(derivative(f)), derivative(*prime.reduce(f)));
      EXPECT_EQ(evaluate(*prime.reduce(f), *prime.reduce(a)), *prime.reduce(evaluate(f, a)));
      const Rational q = rational();
      EXPECT_EQ(prime.reduce(q), prime.reduce(NfElem(q, k)));
    }
  }
}

TEST_P(ReductionLaws, TheImageOfTheGeneratorIsASimpleRoot) {
  for (PrimeIdeals primes : {PrimeIdeals::large(k), PrimeIdeals(k, 3)}) {
    mp_limb_t last = 0;
    for (int i = 0; i < 4; ++i) {
      const PrimeIdeal prime = primes.next();
      EXPECT_GT(prime.p, last); // one ideal per prime, upwards
      last = prime.p;
      EXPECT_TRUE(n_is_prime(prime.p));
      if (k->is_rational()) continue;
      NmodPoly m(prime.p);
      fmpz_poly_get_nmod_poly(m.raw(), k->minpoly());
      EXPECT_EQ(evaluate(m, prime.generator), 0U);
      EXPECT_NE(evaluate(derivative(m), prime.generator), 0U);
    }
  }
}

TEST_P(ReductionLaws, TheSameWalkTwiceGivesTheSameIdeals) {
  PrimeIdeals one(k, 100);
  PrimeIdeals two(k, 100);
  for (int i = 0; i < 20; ++i) { // more than the list of the latest answers holds
    const PrimeIdeal a = one.next();
    const PrimeIdeal b = two.next();
    EXPECT_EQ(a.p, b.p);
    EXPECT_EQ(a.generator, b.generator);
  }
}

TEST_P(ReductionLaws, CompletelySplitPrimesHaveAllTheirIdeals) {
  PrimeIdeals primes(k, 1000);
  const auto ideals = primes.next_split();
  ASSERT_EQ(static_cast<long>(ideals.size()), k->degree());
  std::set<mp_limb_t> images;
  mp_limb_t norm_image = 1; // the product of the images of a is the norm of a
  const NfElem a = nonzero();
  nmod_t mod;
  nmod_init(&mod, ideals.front().p);
  for (const PrimeIdeal& ideal : ideals) {
    EXPECT_EQ(ideal.p, ideals.front().p);
    images.insert(ideal.generator);
    norm_image = nmod_mul(norm_image, *ideal.reduce(a), mod);
  }
  EXPECT_EQ(static_cast<long>(images.size()), k->degree());
  EXPECT_EQ(norm_image, *ideals.front().reduce(norm(coerce(Poly(a), k)).coeff(0)));
}

TEST_P(ReductionLaws, DenominatorsThatVanishAreRefused) {
  PrimeIdeals primes(k, 50);
  const PrimeIdeal prime = primes.next();
  const Rational bad(Integer(1), Integer(prime.p));
  EXPECT_FALSE(prime.reduce(bad));
  EXPECT_FALSE(prime.reduce(NfElem(bad, k)));
  EXPECT_FALSE(prime.reduce(z() + Poly(NfElem(bad))));
  EXPECT_TRUE(is_zero(*prime.reduce(Poly(k))));
}

TEST_P(ReductionLaws, TheGcdBoundIsABound) {
  for (int i = 0; i < 6; ++i) {
    const Poly g = monic_poly(number(0, 2));
    const Poly a = g * monic_poly(2);
    const Poly b = g * monic_poly(3);
    const auto bound = gcd_degree_bound(a, b);
    ASSERT_TRUE(bound);
    EXPECT_GE(*bound, degree(gcd(a, b)));
    if (provably_coprime(a, b)) {
      EXPECT_EQ(degree(gcd(a, b)), 0);
    }
    EXPECT_FALSE(provably_coprime(a, z() * a));
  }
  EXPECT_FALSE(gcd_degree_bound(z(), Poly(k)));
  EXPECT_TRUE(provably_coprime(z(), z() + constant(1)));
}

KOV_OVER_ALL_FIELDS(ReductionLaws);

// Every small fraction comes back, and nothing else is claimed to be small.
TEST(RationalReconstruction, AllSmallFractions) {
  const long m = 9973; // bound: floor(sqrt(m/2)) = 70
  nmod_t mod;
  nmod_init(&mod, static_cast<mp_limb_t>(m));
  for (long d = 1; d <= 70; ++d)
    for (long n = -70; n <= 70; n += 3) {
      const Rational q(n, d);
      const PrimeIdeal prime{static_cast<mp_limb_t>(m), 0};
      EXPECT_EQ(rational_reconstruction(Integer(*prime.reduce(q)), Integer(m)), q);
    }
  long failures = 0;
  for (long c = 0; c < m; ++c) {
    const auto q = rational_reconstruction(Integer(c), Integer(m));
    if (!q) {
      ++failures;
      continue;
    }
    EXPECT_EQ(*(PrimeIdeal{static_cast<mp_limb_t>(m), 0}.reduce(*q)), static_cast<mp_limb_t>(c));
    EXPECT_LE(abs(Rational(q->num())), Rational(70));
    EXPECT_LE(q->den(), Integer(70));
  }
  EXPECT_GT(failures, 0); // there are more residues than small fractions
}

} // namespace
} // namespace kov
