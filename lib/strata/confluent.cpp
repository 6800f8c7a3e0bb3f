#include "strata/confluent.hpp"

#include "closed/arithmetic.hpp"

#include <algorithm>

namespace kov::strata {

namespace {

// Is nu - 1/2 an integer?
Truth half_integral(const BesselForm& form, const Region& region) {
  if (form.nu) return region.is_integral(*form.nu - MFraction(region.ring(), Rational(1, 2)));
  return is_constant(form.nu_squared) ? Truth::no : Truth::unknown; // no: nu is irrational
}

// The form, if r is of this family.
std::optional<BesselForm> bessel_form(const Scheme& s, const Region& region) {
  if (s.finite.size() != 1 || kov::degree(s.finite[0].q, s.z) != 1 || s.finite[0].order != 2)
    return std::nullopt;
  const Ring& ring = s.r.ring();
  const auto line = coefficients(s.finite[0].q, s.z);
  const MFraction t = MFraction::variable(ring, s.z);
  const MFraction shifted =
      substitute(s.r, {{s.z, t - MFraction(line[0]) / MFraction(line[1])}}) * t * t;
  if (uses(shifted.den(), s.z)) return std::nullopt;
  const auto c = coefficients(shifted.num(), s.z);
  std::vector<std::size_t> powers;
  for (std::size_t i = 1; i < c.size(); ++i)
    if (!is_zero(c[i])) powers.push_back(i);
  if (powers.size() != 1 || !region.provably_nonzero(c[powers[0]])) return std::nullopt;
  const Rational step(static_cast<long>(powers[0]));
  const MFraction square =
      MFraction(ring, Rational(1)) + Rational(4) * (MFraction(c[0]) / MFraction(shifted.den()));
  BesselForm form{(Rational(1) / (step * step)) * square, {}, step};
  if (const auto delta = square_root(square)) form.nu = (Rational(1) / step) * *delta;
  return form;
}

} // namespace

std::optional<Leaf> bessel_leaf(const Scheme& s, const Region& region) {
  const auto form = bessel_form(s, region);
  if (!form) return std::nullopt;
  Leaf leaf;
  leaf.because.emplace_back(*form);
  leaf.abelian = half_integral(*form, region);
  if (leaf.abelian == Truth::unknown) {
    leaf.open = IntegralNu{};
    return leaf;
  }
  leaf.by = Conclusion::bessel;
  if (leaf.abelian == Truth::no)
    leaf.group = GaloisGroup{GroupType::SL2, {}};
  else if (form->s == Rational(2))
    leaf.group = GaloisGroup{GroupType::Gm, {}};
  return leaf;
}

std::optional<Leaf> weber_leaf(const Scheme& s, const Region& region) {
  const auto c = coefficients(s.r.num(), s.z);
  if (!s.finite.empty() || c.size() != 3) return std::nullopt;
  const MFraction den(s.r.den());
  const auto a = square_root(MFraction(c[2]) / den);
  Leaf leaf;
  leaf.abelian = Truth::no;
  leaf.by = Conclusion::weber;
  leaf.bound = GroupBound::SL2_or_Borel;
  leaf.because = {IrregularPlace{0}, NoInvariant{4, invariant_bound(s, 4)}};
  if (!a) return leaf;
  const MFraction b = MFraction(c[1]) / den;
  const MFraction e = (MFraction(c[0]) / den - b * b / (Rational(4) * (*a * *a))) / *a;
  const Truth odd = region.is_integral(Rational(1, 2) * (e - MFraction(s.r.ring(), Rational(1))));
  leaf.because.emplace_back(WeberForm{e, odd});
  if (odd == Truth::unknown)
    leaf.bound = GroupBound::Borel_where_odd;
  else
    leaf.group = GaloisGroup{odd == Truth::yes ? GroupType::Borel : GroupType::SL2, {}};
  return leaf;
}

} // namespace kov::strata
