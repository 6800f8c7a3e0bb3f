#include "splitting/surds.hpp"

#include "exact/error.hpp"

#include <utility>

namespace kov {

SurdField::SurdField(Ring ring, std::vector<SurdSymbol> surds)
    : ring_(std::move(ring)), surds_(std::move(surds)) {}

// s^(2k+e) = D^k s^e, for the surds from the last to the first.
MFraction SurdField::reduce_powers(const MPoly& f) const {
  MFraction value(f);
  for (auto surd = surds_.rbegin(); surd != surds_.rend(); ++surd) {
    const std::vector<MPoly> c = coefficients(value.num(), surd->variable);
    if (c.size() <= 2) continue;
    const MFraction s = MFraction::variable(ring_, surd->variable);
    MFraction even, odd, power(ring_, Rational(1));
    for (std::size_t k = 0; k < c.size(); k += 2) {
      even += power * MFraction(c[k]);
      if (k + 1 < c.size()) odd += power * MFraction(c[k + 1]);
      power *= surd->square;
    }
    value = (even + s * odd) / MFraction(value.den());
  }
  return value;
}

MFraction SurdField::conjugate(const MFraction& f, std::size_t variable) const {
  return substitute(f, {{variable, -MFraction::variable(ring_, variable)}});
}

MFraction SurdField::reduce(const MFraction& f) const {
  if (kov::is_zero(f)) return f;
  MFraction num = reduce_powers(f.num());
  MFraction den = reduce_powers(f.den());
  for (auto surd = surds_.rbegin(); surd != surds_.rend(); ++surd) {
    if (!uses(den, surd->variable)) continue;
    const MFraction other = conjugate(den, surd->variable);
    num = num * other;
    den = den * other;
    den = reduce_powers(den.num()) / MFraction(den.den());
  }
  if (kov::is_zero(den)) throw DomainError("division by zero in a field with square roots");
  num = reduce_powers(num.num()) / MFraction(num.den());
  MFraction value = num / den;
  // A common factor may have been cancelled; the numerator stays of degree <= 1 in each surd.
  for (const SurdSymbol& s : surds_)
    KOV_ENSURE(!uses(value.den(), s.variable));
  return value;
}

std::pair<MFraction, MFraction> SurdField::parts(const MFraction& f, std::size_t variable) const {
  if (kov::is_zero(f)) return {f, f};
  const std::vector<MPoly> c = coefficients(f.num(), variable);
  KOV_ENSURE(c.size() <= 2);
  const MFraction den(f.den());
  return {c.empty() ? MFraction(ring_) : MFraction(c[0]) / den,
          c.size() < 2 ? MFraction(ring_) : MFraction(c[1]) / den};
}

} // namespace kov
