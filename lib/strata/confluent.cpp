#include "strata/confluent.hpp"

#include <algorithm>

namespace kov::strata {

std::optional<MFraction> exact_sqrt(const MFraction& f) {
  if (is_zero(f)) return f;
  MFraction root(f.ring(), Rational(1));
  for (const bool top : {true, false}) {
    const auto [content, factors] = factor(top ? f.num() : f.den());
    const auto c = kov::exact_sqrt(Rational(content));
    if (!c) return std::nullopt;
    MFraction side(f.ring(), *c);
    for (const auto& one : factors) {
      if (one.exponent % 2 != 0) return std::nullopt;
      side *= MFraction(pow(one.base, static_cast<unsigned long>(one.exponent / 2)));
    }
    root = top ? root * side : root / side;
  }
  return root;
}

namespace {

Leaf leaf(Truth abelian, const std::optional<GaloisGroup>& group, const std::string& reason) {
  Leaf l;
  l.abelian = abelian;
  l.group = group;
  if (group) l.group_text = describe(*group);
  l.reason = reason;
  return l;
}

} // namespace

std::optional<Leaf> bessel_leaf(const Scheme& s, const Region& region) {
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
  if (powers.size() != 1 || !region.is_nonzero(c[powers[0]])) return std::nullopt;
  const Rational step(static_cast<long>(powers[0]));
  const MFraction square =
      MFraction(ring, Rational(1)) + Rational(4) * (MFraction(c[0]) / MFraction(shifted.den()));
  const std::string family = "z = x^(2/s) turns the equation into one of Bessel, nu^2 = " +
                             to_factored_string((Rational(1) / (step * step)) * square) +
                             " (s = " + kov::to_string(step) + ")";
  const auto delta = exact_sqrt(square);
  Truth half = Truth::unknown;
  std::string condition =
      "sqrt(" + to_factored_string((Rational(1) / (step * step)) * square) + ")";
  if (delta) {
    const MFraction nu = (Rational(1) / step) * *delta;
    condition = to_factored_string(nu);
    half = region.is_integral(nu - MFraction(ring, Rational(1, 2)));
  } else if (is_constant(square)) {
    half = Truth::no; // nu is irrational
  }
  const std::optional<GaloisGroup> torus =
      step == Rational(2) ? std::optional(GaloisGroup{GroupType::Gm, {}}) : std::nullopt;
  switch (half) {
  case Truth::yes:
    return leaf(Truth::yes, torus, family + ", and nu - 1/2 is an integer");
  case Truth::no:
    return leaf(Truth::no, GaloisGroup{GroupType::SL2, {}},
                family + ", and nu - 1/2 is not an integer");
  default:
    Leaf open;
    open.open_condition = "abelian exactly where " + condition + " - 1/2 is an integer";
    open.reason = "undecided: " + open.open_condition + "; " + family;
    return open;
  }
}

std::optional<Leaf> weber_leaf(const Scheme& s, const Region& region) {
  const auto c = coefficients(s.r.num(), s.z);
  if (!s.finite.empty() || c.size() != 3) return std::nullopt;
  const MFraction den(s.r.den());
  const auto a = exact_sqrt(MFraction(c[2]) / den);
  const std::string torus = "the equation is irregular at infinity, and D_4 = -2 < 0";
  Leaf l = leaf(Truth::no, std::nullopt, torus);
  l.group_text = "SL(2, C) or the full triangular group";
  if (!a) return l;
  const MFraction b = MFraction(c[1]) / den;
  const MFraction e = (MFraction(c[0]) / den - b * b / (Rational(4) * (*a * *a))) / *a;
  const MFraction v = Rational(1, 2) * (e - MFraction(s.r.ring(), Rational(1)));
  const Truth odd = region.is_integral(v);
  const std::string condition = to_factored_string(e) + " is an odd integer";
  if (odd == Truth::unknown) {
    l.group_text = "the full triangular group where " + condition + ", SL(2, C) elsewhere";
    l.reason += "; there is an exponential solution exactly where " + condition;
    return l;
  }
  return leaf(Truth::no, GaloisGroup{odd == Truth::yes ? GroupType::Borel : GroupType::SL2, {}},
              torus + "; there is " + (odd == Truth::yes ? "an" : "no") +
                  " exponential solution, since " + to_factored_string(e) +
                  (odd == Truth::yes ? " is" : " is not") + " an odd integer");
}

} // namespace kov::strata
