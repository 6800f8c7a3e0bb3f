#include "proof/condition/condition.hpp"

#include <algorithm>
#include <array>

namespace kov::certify {

namespace {

constexpr std::array<const char*, 4> signs{"positive", "nonnegative", "nonzero", "zero"};
constexpr std::array<const char*, 4> relations{" > 0", " >= 0", " != 0", " = 0"};

} // namespace

std::string to_string(Sign s) { return signs.at(static_cast<std::size_t>(s)); }

std::string relation(Sign s) { return relations.at(static_cast<std::size_t>(s)); }

std::string text_of(const Condition& c) { return to_string(c.p) + relation(c.sign); }

Sign read_sign(const Node& n) {
  const auto at = std::ranges::find(signs, n.text());
  if (at == signs.end()) n.fail("positive, nonnegative, nonzero or zero is expected");
  return static_cast<Sign>(at - signs.begin());
}

bool is_ordered(Sign s) { return s == Sign::positive || s == Sign::nonnegative; }

bool excludes_zero(Sign s) { return s == Sign::positive || s == Sign::nonzero; }

bool allows(Sign s, int sign) {
  return s == Sign::dropped || (s == Sign::positive && sign > 0) ||
         (s == Sign::nonnegative && sign >= 0) || (s == Sign::nonzero && sign != 0) ||
         (s == Sign::zero && sign == 0);
}

Condition negation(const Condition& c) {
  switch (c.sign) {
  case Sign::positive:
    return {-c.p, Sign::nonnegative};
  case Sign::nonnegative:
    return {-c.p, Sign::positive};
  case Sign::nonzero:
    return {c.p, Sign::zero};
  default:
    return {c.p, Sign::nonzero};
  }
}

Condition primitive(const Condition& c) { return {primitive(c.p), c.sign}; }

Conditions read_conditions(const Ring& ring, const Node& n, const std::vector<bool>& names) {
  Conditions all;
  for (const Node& x : n.items()) {
    Keys k(x);
    all.push_back({read_poly(ring, k.at("p"), names), read_sign(k.at("sign"))});
    k.done();
  }
  return all;
}

std::optional<Rational> constant_value(const Fraction& f) {
  if (is_zero(f.den)) return std::nullopt;
  if (is_zero(f.num)) return Rational(0);
  if (!is_multiple(f.num, f.den)) return std::nullopt;
  return Rational(f.num.coefficient(0), f.den.coefficient(0));
}

Fraction combined(const Fraction& f, const Rational& c, const Fraction& g, Arithmetic& a) {
  const MPoly left = scaled(a.times(f.num, g.den), c.den());
  const MPoly right = scaled(a.times(g.num, f.den), c.num());
  return {a.plus(left, right), scaled(a.times(f.den, g.den), c.den())};
}

} // namespace kov::certify
