#include "monodromy/local_system.hpp"

#include "monodromy/imprecise.hpp"

#include <algorithm>

namespace kov::monodromy {
namespace {

using Coefficients = std::vector<ComplexBall>;

Coefficients embedded(const Poly& f, long bits) {
  Coefficients c;
  for (long i = 0; i <= degree(f); ++i)
    c.push_back(embed(f.coeff(i), bits));
  return c;
}

// f(c + t), by Horner's scheme: additions and products only, so exact numbers stay exact.
void shift(Coefficients& f, const ComplexBall& c, long precision) {
  for (std::size_t i = 0; i + 1 < f.size(); ++i)
    for (std::size_t j = f.size() - 1; j-- > i;)
      acb_addmul(f[j].raw(), f[j + 1].raw(), c.raw(), precision);
}

// f(scale t) scale^power
void stretch(Coefficients& f, const Ball& scale, bool once_more, long precision) {
  Ball factor;
  arb_one(factor.raw());
  if (once_more) arb_set(factor.raw(), scale.raw());
  for (ComplexBall& a : f) {
    acb_mul_arb(a.raw(), a.raw(), factor.raw(), precision);
    arb_mul(factor.raw(), factor.raw(), scale.raw(), precision);
  }
}

// The integer nearest below 2^unit x in absolute value; adds to `error` what was lost.
Integer rounded(const arb_struct* x, long unit, Magnitude& error) {
  Integer n;
  const bool inexact = arf_get_fmpz_fixed_si(n.raw(), arb_midref(x), -unit) != 0;
  Magnitude radius;
  mag_mul_2exp_si(radius.raw(), arb_radref(x), unit);
  if (inexact) radius += Magnitude(1);
  error = max(error, radius);
  return n;
}

GaussianPoly rounded(const Coefficients& f, long unit, Magnitude& error) {
  GaussianPoly g;
  for (const ComplexBall& a : f) {
    g.re.push_back(rounded(acb_realref(a.raw()), unit, error));
    g.im.push_back(rounded(acb_imagref(a.raw()), unit, error));
  }
  return g;
}

// e with 2^(e-1) <= |a| < 2^(e+1)
long binary_exponent(const ComplexBall& a) {
  if (acb_contains_zero(a.raw()) != 0)
    throw Imprecise("a centre of expansion cannot be told from a singularity");
  Magnitude m;
  acb_get_mag_lower(m.raw(), a.raw());
  return exponent(m);
}

std::vector<GaussianPoly*> polynomials(LocalRow& row) {
  std::vector<GaussianPoly*> all{&row.den};
  for (GaussianPoly& f : row.num)
    all.push_back(&f);
  return all;
}

// Divides an exact row by the largest power of two in it.
void strip_powers_of_two(LocalRow& row) {
  flint_bitcnt_t common = ~flint_bitcnt_t{0};
  for (const GaussianPoly* f : polynomials(row))
    for (const auto* part : {&f->re, &f->im})
      for (const Integer& n : *part)
        if (!is_zero(n)) common = std::min(common, fmpz_val2(n.raw()));
  for (GaussianPoly* f : polynomials(row))
    for (auto* part : {&f->re, &f->im})
      for (Integer& n : *part)
        fmpz_tdiv_q_2exp(n.raw(), n.raw(), common);
}

} // namespace

EmbeddedSystem::EmbeddedSystem(const DifferentialSystem& s, long bits)
    : precision_(s.field->is_rational() ? ARF_PREC_EXACT : bits) {
  for (const Row& row : s.rows) {
    Embedded e{embedded(row.den, precision_), {}};
    for (const Poly& f : row.num)
      e.num.push_back(embedded(f, precision_));
    rows_.push_back(std::move(e));
  }
}

LocalSystem EmbeddedSystem::at(const ComplexBall& c, const Ball& scale, long bits) const {
  LocalSystem s;
  const auto local = [&](Coefficients f, bool numerator) {
    shift(f, c, precision_);
    stretch(f, scale, numerator, precision_);
    s.degree = std::max(s.degree, static_cast<long>(f.size()) - 1);
    return f;
  };
  for (const Embedded& e : rows_) {
    const Coefficients den = local(e.den, false);
    const long unit = bits - binary_exponent(den.front());
    LocalRow row;
    row.den = rounded(den, unit, row.error);
    for (const Coefficients& f : e.num)
      row.num.push_back(rounded(local(f, true), unit, row.error));
    if (is_zero(row.error))
      strip_powers_of_two(row);
    else // of the real and of the imaginary part
      row.error += row.error;
    s.rows.push_back(std::move(row));
  }
  return s;
}

} // namespace kov::monodromy
