// Matrices that are known in closed form must lie in their enclosures.

#include "monodromy/monodromy.hpp"

#include "exact/error.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>
#include <tuple>

namespace {

using namespace kov;
using namespace kov::monodromy;
using Matrix = std::vector<std::vector<RationalFunction>>;

RationalFunction z() { return {Poly::z(), Poly(1)}; }
RationalFunction q(long n, long d = 1) { return {Rational(Integer(n), Integer(d))}; }
RationalFunction pole(const RationalFunction& residue, const RationalFunction& at) {
  return residue / (z() - at);
}

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c(a.size(), std::vector<RationalFunction>(a.size()));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j)
      for (std::size_t k = 0; k < a.size(); ++k)
        c[i][j] += a[i][k] * b[k][j];
  return c;
}

// exp(2 pi i x) for rational x
ComplexBall root_of_unity(const Rational& x, long bits) {
  ComplexBall w;
  arb_set_fmpq(acb_realref(w.raw()), (Rational(2) * x).raw(), bits);
  acb_exp_pi_i(w.raw(), w.raw(), bits);
  return w;
}

ComplexBall value(const RationalFunction& f, const Point& at, long bits) {
  ComplexBall num = evaluate(f.num(), exact(at), bits);
  const ComplexBall den = evaluate(f.den(), exact(at), bits);
  acb_div(num.raw(), num.raw(), den.raw(), bits);
  return num;
}

BallMatrix values(const Matrix& a, const Point& at, long bits) {
  BallMatrix m(static_cast<long>(a.size()));
  for (long i = 0; i < m.size(); ++i)
    for (long j = 0; j < m.size(); ++j)
      acb_set(m.entry(i, j), value(a[i][j], at, bits).raw());
  return m;
}

void expect_accurate(const Monodromy& m, long digits) {
  Ball bound;
  arb_set_si(bound.raw(), 10);
  arb_pow_ui(bound.raw(), bound.raw(), static_cast<ulong>(digits), 64);
  arb_inv(bound.raw(), bound.raw(), 64);
  EXPECT_TRUE(arb_le(largest_radius(m).raw(), bound.raw()) != 0);
}

// An upper triangular P with ones on the diagonal after a lower triangular one, so that P and its
// inverse are polynomial, and its inverse.
struct Gauge {
  Matrix p, inverse, derivative;
};

Gauge random_gauge(std::size_t n, std::mt19937& random) {
  Matrix lower(n, std::vector<RationalFunction>(n)), upper = lower;
  for (std::size_t i = 0; i < n; ++i) {
    lower[i][i] = upper[i][i] = q(1);
    if (i + 1 < n) {
      lower[i + 1][i] = i == 0 ? z() : q(static_cast<long>(random() % 2));
      upper[i][i + 1] = q(static_cast<long>(random() % 3) - 1);
    }
  }
  const auto inverse = [n](const Matrix& unipotent) { // 1 - N + N^2 - ...
    Matrix minus(n, std::vector<RationalFunction>(n)), power = minus, sum = minus;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        minus[i][j] = i == j ? q(0) : -unipotent[i][j];
        power[i][j] = sum[i][j] = q(i == j ? 1 : 0);
      }
    for (std::size_t k = 1; k < n; ++k) {
      power = product(power, minus);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          sum[i][j] += power[i][j];
    }
    return sum;
  };
  Gauge g{product(lower, upper), product(inverse(upper), inverse(lower)), {}};
  g.derivative = g.p;
  for (auto& row : g.derivative)
    for (RationalFunction& f : row)
      f = derivative(f);
  return g;
}

// Y = P X with X' = D X: Y' = (P' + P D) P^-1 Y.
Matrix transformed(const Gauge& g, const Matrix& d) {
  Matrix sum = product(g.p, d);
  for (std::size_t i = 0; i < d.size(); ++i)
    for (std::size_t j = 0; j < d.size(); ++j)
      sum[i][j] += g.derivative[i][j];
  return product(sum, g.inverse);
}

// Diagonal systems in disguise: the matrices are P(b) diag(exp(2 pi i residue)) P(b)^-1.
void diagonal_in_disguise(std::size_t n, const std::vector<RationalFunction>& places, long digits,
                          std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<std::vector<Rational>> residues(places.size());
  Matrix d(n, std::vector<RationalFunction>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < places.size(); ++k) {
      residues[k].emplace_back(Integer(static_cast<long>(random() % 13) - 6), Integer(5));
      d[i][i] += pole(RationalFunction(residues[k].back()), places[k]);
    }
    d[i][i] += q(static_cast<long>(random() % 2)); // infinity is irregular
  }
  const Gauge g = random_gauge(n, random);
  const Monodromy m = monodromy::monodromy(make_system(transformed(g, d)), {digits, {}, {}});
  expect_accurate(m, digits);
  for (const LoopMatrix& l : m.loops) {
    const std::size_t k =
        std::find(places.begin(), places.end(), RationalFunction(-l.place.factor.coeff(0))) -
        places.begin();
    ASSERT_LT(k, places.size());
    BallMatrix expected(static_cast<long>(n));
    for (std::size_t i = 0; i < n; ++i)
      acb_set(expected.entry(i, i), root_of_unity(residues[k][i], m.bits).raw());
    expected = multiply(multiply(values(g.p, m.base, m.bits), expected, m.bits),
                        values(g.inverse, m.base, m.bits), m.bits);
    EXPECT_TRUE(overlap(expected, l.matrix)) << n << " at " << to_string(l.place);
  }
}

TEST(Monodromy, DiagonalSystemsInDisguise) {
  for (std::size_t n = 1; n <= 3; ++n)
    diagonal_in_disguise(n, {q(0), q(1), q(-3, 2)}, 20, static_cast<std::uint32_t>(n));
}

TEST(Monodromy, TheLargestSystems) { diagonal_in_disguise(8, {q(0)}, 10, 8); }

TEST(Monodromy, NearlyMergedSingularities) {
  for (const long digits : {3, 12}) {
    const RationalFunction gap(Rational(1) / Rational(pow(Integer(10), digits)));
    diagonal_in_disguise(2, {q(0), gap, q(1)}, 30, static_cast<std::uint32_t>(digits));
  }
}

TEST(Monodromy, HighAccuracy) { diagonal_in_disguise(2, {q(0), q(1)}, 200, 5); }

// y = exp(int omega) solves y'' = (omega' + omega^2) y: (1, omega(b)) is an eigenvector of every
// matrix, with eigenvalue exp(2 pi i residue).
void known_solution(const std::vector<std::pair<RationalFunction, Rational>>& poles, long digits) {
  RationalFunction omega;
  for (const auto& [at, residue] : poles)
    omega += pole(RationalFunction(residue), at);
  const RationalFunction r = derivative(omega) + omega * omega;
  const Monodromy m = monodromy::monodromy(RationalFunction(0), -r, {digits, {}, {}});
  expect_accurate(m, digits);
  EXPECT_THAT(m.self_tests, testing::SizeIs(3));
  const ComplexBall w = value(omega, m.base, m.bits);
  for (const LoopMatrix& l : m.loops) {
    Rational residue;
    for (const auto& [at, value] : poles)
      if (at == RationalFunction(-l.place.factor.coeff(0))) residue = value;
    const ComplexBall e = root_of_unity(residue, m.bits);
    for (long i = 0; i < 2; ++i) { // M (1, w) = e (1, w)
      ComplexBall found, expected = e;
      acb_mul(found.raw(), l.matrix.entry(i, 1), w.raw(), m.bits);
      acb_add(found.raw(), found.raw(), l.matrix.entry(i, 0), m.bits);
      if (i == 1) acb_mul(expected.raw(), e.raw(), w.raw(), m.bits);
      EXPECT_TRUE(acb_overlaps(found.raw(), expected.raw()) != 0) << to_string(l.place);
    }
  }
}

TEST(Monodromy, KnownSolutions) {
  known_solution({{q(0), Rational(Integer(1), Integer(3))},
                  {q(1), Rational(Integer(-2), Integer(7))},
                  {q(-4), Rational(Integer(5), Integer(2))}},
                 40);
}

TEST(Monodromy, LargeExponents) {
  known_solution(
      {{q(0), Rational(Integer(301), Integer(3))}, {q(1), Rational(Integer(-200), Integer(7))}},
      30);
}

// A logarithm: Y' = N/z Y with N nilpotent gives exp(2 pi i N).
TEST(Monodromy, NilpotentResidue) {
  const Matrix a{{q(0), q(1) / z(), q(0)}, {q(0), q(0), q(1) / z()}, {q(0), q(0), q(0)}};
  const Monodromy m = monodromy::monodromy(make_system(a), {50, {}, {}});
  ASSERT_EQ(m.loops.size(), 1U);
  ComplexBall two_pi_i;
  arb_const_pi(acb_imagref(two_pi_i.raw()), m.bits);
  acb_mul_2exp_si(two_pi_i.raw(), two_pi_i.raw(), 1);
  BallMatrix n(3);
  acb_set(n.entry(0, 1), two_pi_i.raw());
  acb_set(n.entry(1, 2), two_pi_i.raw());
  acb_mat_exp(n.raw(), n.raw(), m.bits);
  EXPECT_TRUE(overlap(n, m.loops.front().matrix));
}

// Euler's y'' = a/z^2 y at irrational exponents, over Q(sqrt 5) with its generator as a
// coefficient.
TEST(Monodromy, NumberFieldCoefficients) {
  const Field k = make_field({-5, 0, 1}, "s", 0);
  const RationalFunction s{Poly(NfElem::generator(k))};
  const Monodromy m = monodromy::monodromy(RationalFunction(0),
                                           -(s / (z() * z()) + q(1) / (z() - s)), {30, {}, {}});
  EXPECT_EQ(m.loops.size(), 2U);
  EXPECT_THAT(m.self_tests, testing::SizeIs(3));
  expect_accurate(m, 30);
}

TEST(Monodromy, AnotherBaseHasTheSameTraces) {
  const RationalFunction r =
      q(1, 7) / pow(z(), 2) + q(3) / pow(z() - q(1), 2) + q(1) / (z() + q(2));
  const Monodromy a = monodromy::monodromy(RationalFunction(0), -r, {30, {}, {}});
  const Monodromy b =
      monodromy::monodromy(RationalFunction(0), -r, {30, Point{Real(0), Real(2)}, {}});
  for (const LoopMatrix& l : a.loops)
    for (const LoopMatrix& k : b.loops)
      if (l.place.factor == k.place.factor) {
        EXPECT_TRUE(acb_overlaps(trace(l.matrix, a.bits).raw(), trace(k.matrix, b.bits).raw()));
      }
}

TEST(Monodromy, NoSingularities) {
  const Monodromy m = monodromy::monodromy(RationalFunction(0), -z(), {30, {}, {}});
  EXPECT_TRUE(m.loops.empty());
}

TEST(Monodromy, BadInputIsTold) {
  const RationalFunction r = q(1) / pow(z(), 2) + q(1) / (z() - q(1));
  const auto at = [](long x) { return Point{Real(x), Real(0)}; };
  EXPECT_THROW(std::ignore = monodromy::monodromy(RationalFunction(0), -r, {30, at(1), {}}),
               InvalidArgument);
  EXPECT_THROW(std::ignore = monodromy::monodromy(RationalFunction(0), -r, {30, at(5), {}}),
               InvalidArgument);
  EXPECT_THROW(std::ignore = make_system(Matrix(9, std::vector<RationalFunction>(9))),
               InvalidArgument);
  EXPECT_THROW(std::ignore = make_system({{q(1), q(0)}}), InvalidArgument);
}

} // namespace
