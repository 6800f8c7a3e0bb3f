#include "exact/poly.hpp"

#include "exact/error.hpp"
#include "exact/fields.hpp"
#include "exact/laws.hpp"
#include "exact/read_back.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using namespace testing;

class PolyLaws : public OverFields {};

// Schoolbook arithmetic on coefficient lists, for comparison with Kronecker's substitution.
Poly schoolbook_product(const Poly& a, const Poly& b) {
  std::vector<NfElem> c(static_cast<std::size_t>(std::max(0L, degree(a) + degree(b) + 1)));
  for (long i = 0; i <= degree(a); ++i)
    for (long j = 0; j <= degree(b); ++j)
      c[static_cast<std::size_t>(i + j)] += a.coeff(i) * b.coeff(j);
  return coerce(Poly::from_coefficients(c), a.field());
}

// Division from the top, one coefficient at a time.
std::pair<Poly, Poly> long_division(Poly a, const Poly& b) {
  Poly q(a.field());
  while (degree(a) >= degree(b)) {
    const Poly term = Poly::monomial(lead(a) / lead(b), degree(a) - degree(b));
    q += term;
    a -= schoolbook_product(term, b);
  }
  return {q, a};
}

Poly euclid(Poly a, Poly b) {
  while (!is_zero(b)) {
    Poly r = long_division(a, b).second;
    a = std::move(b);
    b = std::move(r);
  }
  return is_zero(a) ? a : scale(a, inverse(lead(a)));
}

TEST_P(PolyLaws, CommutativeRingWithoutZeroDivisors) {
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const Poly a = poly(6);
    const Poly b = poly(4);
    const Poly c = poly(3);
    ring_laws(a, b, c, Poly(k), constant(1));
    domain_laws(a, b);
    value_laws(a, b);
    aliasing_laws(a);
    order_laws(a, b, c);
    EXPECT_EQ(a * b, schoolbook_product(a, b));
    EXPECT_EQ(degree(a * b), is_zero(a * b) ? -1 : degree(a) + degree(b));
    EXPECT_EQ(lead(a * b), lead(a) * lead(b));
  }
  power_laws(poly(2), constant(1));
}

TEST_P(PolyLaws, CoefficientsInAndOut) {
  for (int i = 0; i < 10; ++i) {
    const Poly f = poly(6);
    std::vector<NfElem> c;
    Poly sum(k);
    for (long j = 0; j <= degree(f); ++j) {
      c.push_back(f.coeff(j));
      sum += Poly::monomial(f.coeff(j), j);
    }
    EXPECT_EQ(sum, f);
    EXPECT_EQ(coerce(Poly::from_coefficients(c), k), f);
    EXPECT_TRUE(is_zero(f.coeff(-1)));
    EXPECT_TRUE(is_zero(f.coeff(degree(f) + 1)));
    Poly g = f;
    const NfElem e = element();
    g.set_coeff(3, e);
    EXPECT_EQ(g - f, Poly::monomial(e - f.coeff(3), 3));
    g.set_coeff(3, f.coeff(3));
    EXPECT_EQ(g, f);
  }
}

TEST_P(PolyLaws, DerivationAndScaling) {
  for (int i = 0; i < 10; ++i) {
    const Poly a = poly(6);
    const Poly b = poly(5);
    const NfElem c = element();
    derivation_laws(a, b, [](const Poly& f) { return derivative(f); });
    EXPECT_EQ(derivative(scale(a, c)), scale(derivative(a), c));
    EXPECT_EQ(scale(a, c), a * Poly(c));
    EXPECT_EQ(derivative(pow(a, 4)), constant(4) * pow(a, 3) * derivative(a));
    EXPECT_TRUE(is_zero(derivative(coerce(Poly(c), k))));
  }
}

TEST_P(PolyLaws, DivisionWithRemainder) {
  for (int i = 0; i < 15; ++i) {
    SCOPED_TRACE(i);
    const Poly a = poly(9);
    const Poly b = scale(monic_poly(number(0, 4)), nonzero());
    const auto [q, r] = divrem(a, b);
    EXPECT_EQ(q * b + r, a);
    EXPECT_LT(degree(r), degree(b));
    EXPECT_EQ(std::pair(q, r), long_division(a, b));
    EXPECT_EQ(a % b, r);
    EXPECT_EQ(quotient(a, b), q);
    EXPECT_EQ(exact_div(a * b, b), a);
    EXPECT_TRUE(divides(b, a * b));
    EXPECT_EQ(divides(b, a), is_zero(r));
  }
  EXPECT_THROW((void)divrem(z(), Poly(k)), DomainError);
  EXPECT_THROW((void)exact_div(z() * z() + constant(1), z()), InternalError);
}

TEST_P(PolyLaws, GcdAgainstEuclid) {
  for (int i = 0; i < 10; ++i) {
    SCOPED_TRACE(i);
    const Poly common = monic_poly(number(0, 3));
    const Poly a = common * scale(monic_poly(number(0, 3)), nonzero());
    const Poly b = common * scale(monic_poly(number(0, 3)), nonzero());
    const Poly g = gcd(a, b);
    EXPECT_EQ(g, euclid(a, b));
    EXPECT_EQ(gcd(b, a), g);
    EXPECT_TRUE(divides(common, g));
    EXPECT_TRUE(is_one(lead(g)));
    EXPECT_EQ(lcm(a, b) * g, monic(a * b));
    EXPECT_EQ(gcd(a, Poly(k)), monic(a));
    EXPECT_EQ(gcd(Poly(k), a), monic(a));
    EXPECT_EQ(gcd(a, scale(a, nonzero())), monic(a));
  }
  EXPECT_TRUE(is_zero(gcd(Poly(k), Poly(k))));
  EXPECT_TRUE(is_zero(lcm(z(), Poly(k))));
  EXPECT_THROW((void)monic(Poly(k)), DomainError);
}

// Beyond the degree at which the gcd over Q changes its algorithm.
TEST_P(PolyLaws, GcdOfLongPolynomials) {
  Poly common = constant(1);
  Poly a = constant(1);
  Poly b = constant(1);
  for (long i = 1; i <= 7; ++i) {
    common *= z() - Poly(element()) * constant(i);
    a *= z() + constant(i);
    b *= z() * z() + constant(i);
  }
  const Poly square = z() * z() + constant(43); // no root of 43 in any field of the list
  a *= square;
  EXPECT_EQ(gcd(common * a, common * pow(square, 2)), common * square);
  EXPECT_EQ(gcd(pow(common, 2), common * square), common);
}

TEST_P(PolyLaws, ExtendedGcdAsInverse) {
  for (int i = 0; i < 8; ++i) {
    SCOPED_TRACE(i);
    const Poly q = monic_poly(number(1, 4));
    const Poly a = poly(5);
    if (degree(gcd(a, q)) > 0 || is_zero(a)) {
      EXPECT_THROW((void)inverse_mod(a, q), DomainError);
      continue;
    }
    const Poly s = inverse_mod(a, q);
    EXPECT_LT(degree(s), degree(q));
    EXPECT_TRUE(is_one((s * a) % q));
    EXPECT_EQ(inverse_mod(s, q), a % q);
    EXPECT_THROW((void)inverse_mod(a * q, q), DomainError);
    EXPECT_THROW((void)inverse_mod(a * (z() - constant(1)), q * (z() - constant(1))), DomainError);
  }
}

TEST_P(PolyLaws, ChineseRemainders) {
  const Poly p = pow(z(), 3) - constant(2) * z() + constant(7);
  const Poly q = pow(z() - constant(1), 2);
  for (int i = 0; i < 5; ++i) {
    const Poly a = poly(2);
    const Poly b = poly(1);
    const Poly x = (a * q * inverse_mod(q, p) + b * p * inverse_mod(p, q)) % (p * q);
    EXPECT_EQ(x % p, a);
    EXPECT_EQ(x % q, b);
  }
}

TEST_P(PolyLaws, CompositionAndEvaluation) {
  for (int i = 0; i < 6; ++i) {
    SCOPED_TRACE(i);
    const Poly f = poly(4);
    const Poly g = poly(3);
    const Poly h = poly(2);
    const NfElem c = element();
    EXPECT_EQ(compose(f, compose(g, h)), compose(compose(f, g), h));
    EXPECT_EQ(compose(f + g, h), compose(f, h) + compose(g, h));
    EXPECT_EQ(compose(f * g, h), compose(f, h) * compose(g, h));
    EXPECT_EQ(compose(f, z()), f);
    EXPECT_EQ(derivative(compose(f, g)), compose(derivative(f), g) * derivative(g));
    EXPECT_EQ(evaluate(compose(f, g), c), evaluate(f, evaluate(g, c)));
    EXPECT_EQ(evaluate(f * g, c), evaluate(f, c) * evaluate(g, c));
    EXPECT_EQ(Poly(evaluate(f, c)), coerce(f % (z() - Poly(c)), k)); // the remainder theorem
    EXPECT_EQ(evaluate(f, NfElem(0)), f.coeff(0));
    const ComplexBall at = evaluate(f, embed(c, 128), 128);
    EXPECT_TRUE(acb_overlaps(at.raw(), embed(evaluate(f, c), 128).raw()));
  }
}

TEST_P(PolyLaws, TaylorShift) {
  for (const long n : {0L, 3L, 20L}) { // 20: by halves
    const Poly f = monic_poly(n);
    const NfElem c = element();
    const NfElem d = element();
    EXPECT_EQ(taylor_shift(f, c), compose(f, z() + Poly(c)));
    EXPECT_EQ(taylor_shift(taylor_shift(f, c), d), taylor_shift(f, c + d));
    EXPECT_EQ(taylor_shift(f, NfElem(0)), f);
    // the coefficients are f^(j)(c)/j!
    Poly derivative_j = f;
    Rational factorial(1);
    for (long j = 0; j <= std::min(n, 5L); ++j) {
      EXPECT_EQ(taylor_shift(f, c).coeff(j), evaluate(derivative_j, c) / NfElem(factorial));
      derivative_j = derivative(derivative_j);
      factorial *= Rational(j + 1);
    }
  }
}

TEST_P(PolyLaws, ShiftsTruncationReversal) {
  for (int i = 0; i < 8; ++i) {
    const Poly f = poly(6);
    EXPECT_EQ(shift_left(f, 3), pow(z(), 3) * f);
    EXPECT_EQ(shift_right(shift_left(f, 3), 3), f);
    EXPECT_EQ(shift_left(shift_right(f, 2), 2) + truncate(f, 2), f);
    EXPECT_EQ(truncate(f, 4), f % pow(z(), 4));
    EXPECT_TRUE(is_zero(truncate(f, 0)));
    EXPECT_TRUE(is_zero(truncate(f, -1)));
    EXPECT_EQ(reverse(reverse(f, 8), 8), f);
    for (long j = 0; j < 8; ++j)
      EXPECT_EQ(reverse(f, 8).coeff(j), f.coeff(7 - j));
  }
}

TEST_P(PolyLaws, PowerSeriesInverse) {
  for (const long n : {1L, 2L, 5L, 9L}) {
    Poly f = poly(6);
    f.set_coeff(0, nonzero());
    const Poly g = inverse_series(f, n);
    EXPECT_LT(degree(g), n);
    EXPECT_TRUE(is_one(truncate(f * g, n)));
  }
  EXPECT_THROW((void)inverse_series(z(), 3), DomainError);
}

TEST_P(PolyLaws, RemovingAFactor) {
  for (long e = 0; e <= 6; ++e) {
    const Poly q = z() * z() + constant(43);
    const Poly rest = (z() - constant(2)) * pow(z() + Poly(element()), 2);
    const auto [exponent, left] = remove_factor(pow(q, static_cast<unsigned long>(e)) * rest, q);
    EXPECT_EQ(exponent, e);
    EXPECT_EQ(left, rest);
  }
}

TEST_P(PolyLaws, SquareRoots) {
  for (int i = 0; i < 6; ++i) {
    const Poly f = monic_poly(number(0, 4));
    EXPECT_EQ(exact_sqrt(f * f), f);
    EXPECT_FALSE(exact_sqrt(f * f * z()));
    EXPECT_FALSE(exact_sqrt(f * f * (z() * z() + constant(43))));
  }
}

TEST_P(PolyLaws, TheNormIsMultiplicativeAndExtendsThePower) {
  for (int i = 0; i < 4; ++i) {
    const Poly f = poly(3);
    const Poly g = poly(2);
    EXPECT_EQ(norm(f * g), norm(f) * norm(g));
    EXPECT_TRUE(is_zero(f) || divides(f, coerce(norm(f), k)));
    const Poly rational_poly = Poly(rational()) + Poly::z() * Poly(rational());
    EXPECT_EQ(norm(coerce(rational_poly, k)),
              pow(rational_poly, static_cast<unsigned long>(k->degree())));
  }
}

TEST_P(PolyLaws, TextAndBack) {
  std::map<std::string, Poly> names{{"z", z()}};
  if (!k->is_rational())
    names.emplace(k->letter(), Poly(NfElem::generator(k) / NfElem(Rational(k->scale()))));
  ReadBack<RationalFunction> read(
      [&] {
        std::map<std::string, RationalFunction> functions;
        for (const auto& [name, f] : names)
          functions.emplace(name, RationalFunction(f));
        return functions;
      }(),
      [](const Integer& n, const RationalFunction&) { return RationalFunction(Rational(n)); });
  for (int i = 0; i < 25; ++i) {
    const Poly f = poly(5);
    EXPECT_EQ(read(to_string(f)), RationalFunction(f)) << to_string(f);
  }
  EXPECT_EQ(to_string(Poly(k)), "0");
  EXPECT_EQ(to_string(-z(), "x"), "-x");
}

TEST_P(PolyLaws, RationalPolynomialsAreASubring) {
  const Poly f = pow(Poly::z(), 3) + Poly(Rational(1, 2)); // over Q
  EXPECT_EQ(coerce(f, k), f); // the same polynomial, whatever its layout
  EXPECT_EQ(f, coerce(f, k));
  const NfElem c = element();
  EXPECT_EQ(f * Poly(c), coerce(f, k) * Poly(c));
  EXPECT_EQ((f + Poly(c)).field(), k);
  EXPECT_EQ(divrem(f, z() - Poly(c)), divrem(coerce(f, k), z() - Poly(c)));
}

KOV_OVER_ALL_FIELDS(PolyLaws);

TEST(Poly, EqualityDoesNotDependOnTheLayout) {
  const Field k = make_field({1, 0, 1}, "I"); // z sits at position 3 of the flat layout, I at 1
  const Poly z = Poly::z();
  EXPECT_FALSE(coerce(z, k) == pow(z, 3));
  EXPECT_FALSE(Poly(NfElem::generator(k)) == z);
  EXPECT_TRUE(coerce(z, k) == z);
  const Field l = make_field({-2, 0, 1}, "s");
  EXPECT_TRUE(coerce(z, k) == coerce(z, l));
  EXPECT_FALSE(Poly(NfElem::generator(k)) == Poly(NfElem::generator(l)));
  EXPECT_EQ(RationalFunction(coerce(z, k), Poly(1)), RationalFunction(z));
}

} // namespace
} // namespace kov
