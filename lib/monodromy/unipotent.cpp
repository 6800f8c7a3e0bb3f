#include "monodromy/unipotent.hpp"

#include "exact/factor.hpp"

#include <algorithm>

namespace kov::monodromy {
namespace {

constexpr long largest_power = 1000; // beyond, the power of a matrix of balls is useless

// An entry of A that is not 0: f^order unit, the unit modulo f.
struct Leading {
  long order = 0;
  Poly unit;
};
using LocalMatrix = std::vector<std::vector<std::optional<Leading>>>;
using ResidueMatrix = std::vector<std::vector<Poly>>; // over K[z]/f

LocalMatrix leading_parts(const DifferentialSystem& s, const Poly& f) {
  LocalMatrix a;
  for (const Row& row : s.rows) {
    const auto [pole, rest] = remove_factor(row.den, f);
    const Poly inverse = inverse_mod(rest, f);
    a.emplace_back(row.num.size());
    for (std::size_t j = 0; j < row.num.size(); ++j)
      if (!is_zero(row.num[j])) {
        const auto [zero, unit] = remove_factor(row.num[j], f);
        a.back()[j] = Leading{zero - pole, unit * inverse % f};
      }
  }
  return a;
}

// Integers w with ord a_ij + w_i - w_j >= -1: shortest paths (Bellman and Ford).
std::optional<std::vector<long>> simple_pole_weights(const LocalMatrix& a) {
  std::vector<long> w(a.size(), 0);
  for (std::size_t round = 0; round <= a.size(); ++round) {
    bool changed = false;
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t j = 0; j < a.size(); ++j)
        if (a[i][j] && w[i] + a[i][j]->order + 1 < w[j]) {
          w[j] = w[i] + a[i][j]->order + 1;
          changed = true;
        }
    if (!changed) return w;
  }
  return std::nullopt;
}

// The residue matrix for X_i = f^w_i Y_i; f = f'(s) (z - s) + ... at a root s of f.
ResidueMatrix residue(const LocalMatrix& a, const std::vector<long>& w, const Poly& f) {
  const Poly slope = inverse_mod(derivative(f), f);
  ResidueMatrix r(a.size(), std::vector<Poly>(a.size(), Poly(f.field())));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < a.size(); ++j)
      if (a[i][j] && a[i][j]->order + w[i] - w[j] == -1) r[i][j] = a[i][j]->unit * slope % f;
    r[i][i] += Poly(w[i]);
  }
  return r;
}

ResidueMatrix multiply(const ResidueMatrix& a, const ResidueMatrix& b, const Poly& f) {
  ResidueMatrix c(a.size(), std::vector<Poly>(a.size(), Poly(f.field())));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j) {
      for (std::size_t k = 0; k < a.size(); ++k)
        c[i][j] += a[i][k] * b[k][j];
      c[i][j] = c[i][j] % f;
    }
  return c;
}

// Ascending coefficients of det(x - r), by Faddeev and LeVerrier.
std::vector<Poly> characteristic_polynomial(const ResidueMatrix& r, const Poly& f) {
  const std::size_t n = r.size();
  std::vector<Poly> c(n + 1, Poly(f.field()));
  c[n] = coerce(Poly(1), f.field());
  ResidueMatrix m(n, std::vector<Poly>(n, Poly(f.field())));
  for (std::size_t k = 1; k <= n; ++k) {
    for (std::size_t i = 0; i < n; ++i)
      m[i][i] += c[n - k + 1];
    m = multiply(r, m, f);
    for (std::size_t i = 0; i < n; ++i)
      c[n - k] -= m[i][i];
    c[n - k] = scale(c[n - k], NfElem(Rational(Integer(1), Integer(static_cast<long>(k)))));
  }
  return c;
}

// The polynomial over Q, if all coefficients are rational numbers.
std::optional<Poly> over_the_rationals(const std::vector<Poly>& c) {
  std::vector<NfElem> rational;
  for (const Poly& a : c) {
    if (degree(a) > 0 || !is_rational(a.coeff(0))) return std::nullopt;
    rational.emplace_back(to_rational(a.coeff(0)));
  }
  return Poly::from_coefficients(rational);
}

// The least common denominator of the roots, if all are rational.
std::optional<long> common_denominator(const Poly& f, const Budget& budget) {
  Integer n(1);
  for (const Factor& root : irreducible_factors(f, budget)) {
    if (degree(root.base) != 1) return std::nullopt;
    n = lcm(n, to_rational(root.base.coeff(0)).den());
  }
  if (Integer(largest_power) < n) return std::nullopt;
  return to_long(n);
}

// The system in x = 1/z.
DifferentialSystem at_infinity(const DifferentialSystem& s) {
  const RationalFunction x(coerce(Poly::z(), s.field));
  const RationalFunction inverse = RationalFunction(1) / x;
  std::vector<std::vector<RationalFunction>> a;
  for (const Row& row : s.rows) {
    a.emplace_back();
    for (const Poly& num : row.num)
      a.back().push_back(-(inverse * inverse) * compose(RationalFunction(num, row.den), inverse));
  }
  return make_system(a);
}

} // namespace

std::optional<long> unipotent_power(const DifferentialSystem& s, const Poly& f,
                                    const Budget& budget) {
  const Poly place = coerce(f, s.field);
  const LocalMatrix a = leading_parts(s, place);
  const auto w = simple_pole_weights(a);
  if (!w) return std::nullopt;
  const auto c = over_the_rationals(characteristic_polynomial(residue(a, *w, place), place));
  return c ? common_denominator(*c, budget) : std::nullopt;
}

std::optional<long> unipotent_power_at_infinity(const DifferentialSystem& s, const Budget& budget) {
  const DifferentialSystem in_x = at_infinity(s);
  return unipotent_power(in_x, coerce(Poly::z(), in_x.field), budget);
}

} // namespace kov::monodromy
