// The compiled kernels against the vector field X' = J(X) dH/dX of the paper, in exact arithmetic.
//
// The field is made here from the Hamiltonian (integralsM) by dual numbers over Q, without the formulas of
// body.hpp and jets.hpp; the kernels run over Q.  Higher coefficients are checked by putting the series back
// into the differential equation, in truncated power series over Q.

#include "flow/orbit/jets.hpp"
#include "flow/orbit/section_jets.hpp"
#include "support.hpp"

#include "exact/integer.hpp"

#include <gtest/gtest.h>

#include <random>
#include <utility>

namespace kov::flow {
namespace {

// a + b epsilon, epsilon^2 = 0.
struct Dual {
  Rational a, b;
  Dual(long n = 0) : a(n) {}
  Dual(Rational x, Rational y = Rational()) : a(std::move(x)), b(std::move(y)) {}
  friend Dual operator+(const Dual& x, const Dual& y) { return {x.a + y.a, x.b + y.b}; }
  friend Dual operator-(const Dual& x, const Dual& y) { return {x.a - y.a, x.b - y.b}; }
  friend Dual operator*(const Dual& x, const Dual& y) { return {x.a * y.a, x.a * y.b + x.b * y.a}; }
  friend Dual operator/(const Dual& x, const Dual& y) {
    return {x.a / y.a, (x.b * y.a - x.a * y.b) / (y.a * y.a)};
  }
};

Rational half() { return Rational(1) / Rational(2); }

// H(M, Gamma) as the paper prints it: J as a matrix, Omega by Cramer's rule.
template <class T> T hamiltonian(const Body<Rational>& b, const Vec<T>& m, const Vec<T>& gamma) {
  const auto lift = [](const Rational& q) { return T(q); };
  Vec<T> lever{};
  Mat<T> inertia{}, j{};
  for (int i = 0; i < 3; ++i) {
    lever[i] = lift(b.lever[i]);
    for (int k = 0; k < 3; ++k)
      inertia[i][k] = lift(b.inertia[i][k]);
  }
  const Vec<T> v = cross(lever, gamma);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      j[i][k] = inertia[i][k] + (b.sliding ? T(lift(b.mass) * v[i] * v[k]) : T(Rational(0)));
  const T det = dot(j[0], cross(j[1], j[2]));
  Vec<T> omega{};
  for (int i = 0; i < 3; ++i) {
    Mat<T> c = j;
    for (int k = 0; k < 3; ++k)
      c[k][i] = m[k];
    omega[i] = dot(c[0], cross(c[1], c[2])) / det;
  }
  const T speed = b.sliding ? dot(gamma, cross(omega, lever)) : T(Rational(0));
  const T half_(half());
  return half_ * dot(omega, times(inertia, omega)) + half_ * lift(b.mass) * speed * speed +
         lift(b.mass) * lift(b.gravity) * dot(gamma, lever);
}

struct Rates {
  Vec<Rational> m, gamma;
};

// M' = (M - B) x dH/dM + Gamma x dH/dGamma,  Gamma' = Gamma x dH/dM.
Rates hamiltonian_field(const Body<Rational>& b, const Vec<Rational>& m, const Vec<Rational>& g) {
  Vec<Rational> by_m, by_gamma;
  for (int i = 0; i < 3; ++i) {
    Vec<Dual> md, gd;
    for (int k = 0; k < 3; ++k) {
      md[k] = Dual(m[k], Rational(k == i ? 1 : 0));
      gd[k] = Dual(g[k]);
    }
    by_m[i] = hamiltonian(b, md, gd).b;
    for (int k = 0; k < 3; ++k) {
      md[k] = Dual(m[k]);
      gd[k] = Dual(g[k], Rational(k == i ? 1 : 0));
    }
    by_gamma[i] = hamiltonian(b, md, gd).b;
  }
  return {plus(cross(minus(m, b.gyrostat), by_m), cross(g, by_gamma)), cross(g, by_m)};
}

class Dice {
public:
  explicit Dice(unsigned seed) : gen_(seed) {}
  Rational nonzero() {
    const long n = pick_(gen_), d = 1 + std::abs(pick_(gen_));
    return Rational(Integer(n == 0 ? 1 : n), Integer(d));
  }
  Vec<Rational> vector() { return {nonzero(), nonzero(), nonzero()}; }
  Body<Rational> body(const Effects& e) {
    Body<Rational> b;
    for (int i = 0; i < 3; ++i)
      b.inertia[i][i] = Rational(5 + i) + nonzero() / Rational(20);
    if (e.full_inertia)
      for (int i = 0; i < 3; ++i)
        b.inertia[i][(i + 1) % 3] = b.inertia[(i + 1) % 3][i] = nonzero() / Rational(10);
    if (e.gyrostat) b.gyrostat = vector();
    b.lever = vector();
    if (e.axial) { // each of the three axes gets its turn
      const int axis = turn_++ % 3;
      b.lever[(axis + 1) % 3] = b.lever[(axis + 2) % 3] = Rational();
    }
    if (e.gravity) b.gravity = nonzero();
    b.mass = Rational(3) / Rational(2);
    b.sliding = e.sliding;
    if (!e.lever()) b.lever = {};
    return b;
  }

private:
  std::mt19937 gen_;
  std::uniform_int_distribution<long> pick_{-9, 9};
  int turn_ = 0;
};

struct Series {
  int order;
  Model<Rational> model;
  std::vector<Rational> memory;
  Jet<Rational> jet{};
  Series(const Body<Rational>& b, const Effects& e, const State<Rational>& x, int p)
      : order(p), model(model_of(b, e)),
        memory(static_cast<std::size_t>(Jet<Rational>::count) * (p + 2)) {
    for (int i = 0; i < Jet<Rational>::count; ++i)
      jet.s[i] = memory.data() + static_cast<std::ptrdiff_t>(i) * (p + 2);
    for (int i = 0; i < 3; ++i) {
      jet.s[inner(i)][0] = x.omega[i];
      jet.s[3 + inner(i)][0] = x.gamma[i];
    }
  }
  int inner(int axis) const { return (axis + 3 - model.shift) % 3; }
  const Rational& omega(int axis, int k) const { return jet.s[inner(axis)][k]; }
  const Rational& gamma(int axis, int k) const { return jet.s[3 + inner(axis)][k]; }
};

template <std::size_t I> void compare_with_hamiltonian() {
  constexpr Effects e = effect_sets[I];
  Dice dice(7 + I);
  for (int trial = 0; trial < 6; ++trial) {
    const Body<Rational> b = dice.body(e);
    EXPECT_EQ(effects_of(b), e);
    const State<Rational> x{dice.vector(), dice.vector()};
    Series s(b, e, x, 1);
    jets<e, Rational>(s.model, s.jet, 1);
    // push (Omega', Gamma') forward to M' by a dual number
    Body<Dual> bd;
    State<Dual> xd;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k)
        bd.inertia[i][k] = Dual(b.inertia[i][k]);
      bd.lever[i] = Dual(b.lever[i]);
      xd.omega[i] = Dual(x.omega[i], s.omega(i, 1));
      xd.gamma[i] = Dual(x.gamma[i], s.gamma(i, 1));
    }
    bd.mass = Dual(b.mass);
    bd.sliding = b.sliding;
    const Vec<Dual> m = momentum(bd, xd);
    const Rates want = hamiltonian_field(b, {m[0].a, m[1].a, m[2].a}, x.gamma);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(m[i].b, want.m[i])
          << "M' of axis " << i << ", effects " << I << ", trial " << trial;
      EXPECT_EQ(s.gamma(i, 1), want.gamma[i]) << "effects " << I;
    }
  }
}

TEST(VectorField, EveryKernelIsTheHamiltonianFieldAtRationalPoints) {
  [&]<std::size_t... I>(std::index_sequence<I...>) { (compare_with_hamiltonian<I>(), ...); }
  (std::make_index_sequence<effect_sets.size()>{});
}

// Truncated power series over Q, as a number type for the right-hand side written with cross products.
struct PowerSeries {
  std::vector<Rational> c;
  explicit PowerSeries(std::size_t n) : c(n) {}
  friend PowerSeries operator*(const PowerSeries& a, const PowerSeries& b) {
    PowerSeries r(a.c.size());
    for (std::size_t i = 0; i < a.c.size(); ++i)
      for (std::size_t k = 0; i + k < a.c.size(); ++k)
        r.c[i + k] += a.c[i] * b.c[k];
    return r;
  }
  friend PowerSeries operator+(PowerSeries a, const PowerSeries& b) {
    for (std::size_t i = 0; i < a.c.size(); ++i)
      a.c[i] += b.c[i];
    return a;
  }
};

PowerSeries scaled_series(const Rational& q, PowerSeries a) {
  for (Rational& x : a.c)
    x *= q;
  return a;
}

PowerSeries derived(const PowerSeries& a) { // the last coefficient is lost
  PowerSeries r(a.c.size());
  for (std::size_t i = 0; i + 1 < a.c.size(); ++i)
    r.c[i] = a.c[i + 1] * Rational(static_cast<long>(i) + 1);
  return r;
}

template <std::size_t I> void put_back() {
  constexpr Effects e = effect_sets[I];
  constexpr int p = 6;
  Dice dice(100 + I);
  const Body<Rational> b = dice.body(e);
  const State<Rational> x{dice.vector(), dice.vector()};
  Series s(b, e, x, p);
  jets<e, Rational>(s.model, s.jet, p);
  const auto series = [&](bool gamma, int axis) {
    PowerSeries r(p + 1);
    for (int k = 0; k <= p; ++k)
      r.c[k] = gamma ? s.gamma(axis, k) : s.omega(axis, k);
    return r;
  };
  const std::vector<PowerSeries> o{series(false, 0), series(false, 1), series(false, 2)};
  const std::vector<PowerSeries> g{series(true, 0), series(true, 1), series(true, 2)};
  std::vector<PowerSeries> k(3, PowerSeries(p + 1)), v = k;
  for (int i = 0; i < 3; ++i) {
    for (int n = 0; n < 3; ++n)
      k[i] = k[i] + scaled_series(b.inertia[i][n], o[n]);
    v[i] = scaled_series(b.lever[(i + 1) % 3], g[(i + 2) % 3]) +
           scaled_series(-b.lever[(i + 2) % 3], g[(i + 1) % 3]);
  }
  // I Omega' = (K - B) x Omega - m (g + z'') v: here z'' is the second derivative of L.Gamma
  PowerSeries z(p + 1);
  for (int i = 0; i < 3; ++i)
    z = z + scaled_series(b.lever[i], g[i]);
  PowerSeries push = e.sliding ? derived(derived(z)) : PowerSeries(p + 1);
  push.c[0] += b.gravity;
  for (int i = 0; i < 3; ++i) {
    const int n = (i + 1) % 3, l = (i + 2) % 3;
    PowerSeries kn = k[n], kl = k[l];
    kn.c[0] -= b.gyrostat[n];
    kl.c[0] -= b.gyrostat[l];
    const PowerSeries right =
        kn * o[l] + scaled_series(Rational(-1), kl * o[n]) + scaled_series(-b.mass, push * v[i]);
    const PowerSeries left = derived(k[i]);
    const PowerSeries turn = g[n] * o[l] + scaled_series(Rational(-1), g[l] * o[n]);
    for (int c = 0; c + 2 <= p; ++c) {
      EXPECT_EQ(left.c[c], right.c[c]) << "effects " << I << ", axis " << i << ", order " << c;
      EXPECT_EQ(derived(g[i]).c[c], turn.c[c]);
    }
  }
}

TEST(VectorField, TheSeriesOfEveryKernelSolveTheDifferentialEquation) {
  [&]<std::size_t... I>(std::index_sequence<I...>) { (put_back<I>(), ...); }
  (std::make_index_sequence<effect_sets.size()>{});
}

template <std::size_t I> void section_series() {
  constexpr Effects e = effect_sets[I];
  constexpr int p = 5;
  Dice dice(200 + I);
  for (int axis = 0; axis < 3; ++axis) {
    const Body<Rational> b = dice.body(e);
    const State<Rational> x{dice.vector(), dice.vector()};
    Series s(b, e, x, p);
    jets<e, Rational>(s.model, s.jet, p);
    section_jets<e, Rational>(s.model, s.jet, p, s.inner(axis));
    // S = F2 N_a - (N.N) Gamma_a from the series of the state, with z' = (L.Gamma)'
    const auto series = [&](bool gamma, int i) {
      PowerSeries r(p + 1);
      for (int k = 0; k <= p; ++k)
        r.c[k] = gamma ? s.gamma(i, k) : s.omega(i, k);
      return r;
    };
    PowerSeries z(p + 2), nn(p + 1), casimir(p + 1);
    z.c.resize(p + 1);
    std::vector<PowerSeries> n(3, PowerSeries(p + 1));
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        n[i] = n[i] + scaled_series(b.inertia[i][k], series(false, k));
    if (e.sliding) {
      const std::vector<PowerSeries> o{series(false, 0), series(false, 1), series(false, 2)};
      const std::vector<PowerSeries> g{series(true, 0), series(true, 1), series(true, 2)};
      PowerSeries speed(p + 1);
      std::vector<PowerSeries> v(3, PowerSeries(p + 1));
      for (int i = 0; i < 3; ++i) {
        v[i] = scaled_series(b.lever[(i + 1) % 3], g[(i + 2) % 3]) +
               scaled_series(-b.lever[(i + 2) % 3], g[(i + 1) % 3]);
        speed = speed + v[i] * o[i];
      }
      for (int i = 0; i < 3; ++i)
        n[i] = n[i] + scaled_series(b.mass, speed * v[i]);
    }
    for (int i = 0; i < 3; ++i) {
      n[i].c[0] -= b.gyrostat[i];
      nn = nn + n[i] * n[i];
      casimir = casimir + n[i] * series(true, i);
    }
    for (int k = 1; k <= p; ++k)
      EXPECT_EQ(casimir.c[k], Rational(0)) << "F2 is not constant, effects " << I;
    const PowerSeries want =
        casimir * n[axis] + scaled_series(Rational(-1), nn * series(true, axis));
    for (int k = 0; k <= p; ++k)
      EXPECT_EQ(s.jet.s[Jet<Rational>::section][k], want.c[k])
          << "effects " << I << ", order " << k;
  }
}

TEST(VectorField, TheSectionSeriesIsThatOfTheSectionFunction) {
  [&]<std::size_t... I>(std::index_sequence<I...>) { (section_series<I>(), ...); }
  (std::make_index_sequence<effect_sets.size()>{});
}

// A kernel for more effects gives the same numbers: the others are multiplied by zero.
TEST(VectorField, ASupersetOfEffectsComputesTheSame) {
  Dice dice(9);
  constexpr Effects few{true, true, false, false, true}, all{true, true, true, true, false};
  static_assert(covers(all, few));
  const Body<Rational> b = dice.body(few);
  const State<Rational> x{dice.vector(), dice.vector()};
  Series s(b, few, x, 4), w(b, all, x, 4);
  jets<few, Rational>(s.model, s.jet, 4);
  jets<all, Rational>(w.model, w.jet, 4);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k <= 4; ++k) {
      EXPECT_EQ(s.omega(i, k), w.omega(i, k));
      EXPECT_EQ(s.gamma(i, k), w.gamma(i, k));
    }
}

} // namespace
} // namespace kov::flow
