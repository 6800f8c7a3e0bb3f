#include "linode/centre.hpp"

#include <algorithm>

namespace kov {
namespace {

// A rational centre of fewer bits makes no coefficients that are worth a move.
constexpr std::size_t long_number = 64;

// The mean of the roots, with their multiplicities; unset for a constant.
std::optional<NfElem> mean_of_roots(const Poly& f) {
  const long n = degree(f);
  if (n < 1) return std::nullopt;
  return -(f.coeff(n - 1) / (f.coeff(n) * NfElem(n)));
}

std::size_t bits(const Integer& n) { return fmpz_bits(n.raw()); }

std::optional<Poly> over_the_rationals(const Poly& f) {
  std::vector<NfElem> coefficients;
  for (long i = 0; i <= degree(f); ++i) {
    const NfElem c = f.coeff(i);
    if (!is_rational(c)) return std::nullopt;
    coefficients.emplace_back(to_rational(c));
  }
  return Poly::from_coefficients(coefficients);
}

std::optional<RationalFunction> over_the_rationals(const RationalFunction& f) {
  const auto num = over_the_rationals(f.num()), den = over_the_rationals(f.den());
  if (!num || !den) return std::nullopt;
  return RationalFunction::from_coprime(*num, *den);
}

} // namespace

RationalFunction moved_by(const RationalFunction& f, const NfElem& c) {
  return RationalFunction::from_coprime(taylor_shift(f.num(), c), taylor_shift(f.den(), c));
}

std::optional<Centred> centred(const NormalForm& equation) {
  const auto& [r, p] = equation;
  const auto c = mean_of_roots(degree(r.den()) > 0 ? r.den() : r.num());
  if (!c) return std::nullopt;
  if (r.field()->is_rational() && p.field()->is_rational()) {
    const Rational q = to_rational(*c);
    if (std::max(bits(q.num()), bits(q.den())) < long_number) return std::nullopt;
  } else if (is_rational(*c)) {
    return std::nullopt;
  }
  const auto there = over_the_rationals(moved_by(r, *c)),
             factor = over_the_rationals(moved_by(p, *c));
  if (!there || !factor) return std::nullopt;
  return Centred{*c, {*there, *factor}};
}

std::string centred_variable(const std::string& variable, const NfElem& centre) {
  return "(" + to_string(Poly::from_coefficients({-centre, NfElem(1)}), variable) + ")";
}

} // namespace kov
