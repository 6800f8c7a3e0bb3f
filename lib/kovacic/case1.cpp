#include "kovacic/case1.hpp"

#include "exact/error.hpp"
#include "kovacic/invariant_families.hpp"
#include "kovacic/lines.hpp"
#include "kovacic/necessary.hpp"
#include "kovacic/plug_back.hpp"

namespace kov::kovacic {
namespace {

Exponential verified(Exponential y, const RationalFunction& r) {
  KOV_ENSURE(solves_riccati(y.omega, r));
  return y;
}

// ----- (b) v = y1 y2 rational -------------------------------------------------------------------

// The space of rational v has dimension 0, 1 or 3; 3 belongs to the groups {1} and {+-1}.
std::optional<Outcome> from_second_power(const Singularities& s, const Budget& budget,
                                         Trace* trace) {
  const auto found =
      rational_products(s, 2, 1, "both lines at once, v = y1 y2 rational", budget, trace);
  if (found.empty()) return std::nullopt;
  KOV_ENSURE(found.size() == 1 || found.size() == 3);
  const RationalFunction v = rational_value(s, found.front());
  const NfElem w_squared = squared_wronskian(v, s.r);
  if (is_zero(w_squared)) { // v = y^2
    KOV_ENSURE(found.size() == 1);
    const RationalFunction omega = derivative(v) / (RationalFunction(2) * v);
    note(trace, 1, 3, [&] {
      return "v = " + to_string(v) + " is the square of a solution: y'/y = " + to_string(omega) +
             ", the only exponential line.";
    });
    return verified(Exponential{omega}, s.r);
  }
  KOV_ENSURE(found.size() == 1);
  note(trace, 1, 3, [&] {
    return "v = " + to_string(v) + ", w^2 = " + to_string(w_squared) +
           ": y'/y = (v' +- w)/(2v) are the two exponential lines.";
  });
  return ExponentialPair{v, w_squared, false};
}

// All solutions are exponential only if every local monodromy is +-1.
bool may_be_scalar(const Singularities& s) {
  return !any_place(s, [](const Singularity& place) {
    return certainly(place.log) || !has_denominator_dividing(place, 1);
  });
}

} // namespace

// Constant for a solution v of the second symmetric power, because its derivative is
// -2 v (v''' - 4 r v' - 2 r' v); so the value at one point is enough.
NfElem squared_wronskian(const RationalFunction& v, const RationalFunction& r) {
  NfElem at(0);
  while (is_zero(evaluate(v.den(), at)) || is_zero(evaluate(r.den(), at)))
    at += NfElem(1);
  const auto value = [&](const RationalFunction& f) {
    return evaluate(f.num(), at) / evaluate(f.den(), at);
  };
  // v = N/D: v' = (N' - v D')/D, v'' = (N'' - 2 v' D' - v D'')/D
  const Poly dN = derivative(v.num());
  const Poly dD = derivative(v.den());
  const NfElem D = evaluate(v.den(), at);
  const NfElem v0 = value(v);
  const NfElem v1 = (evaluate(dN, at) - v0 * evaluate(dD, at)) / D;
  const NfElem v2 = (evaluate(derivative(dN), at) - NfElem(2) * v1 * evaluate(dD, at) -
                     v0 * evaluate(derivative(dD), at)) /
                    D;
  return v1 * v1 - NfElem(2) * v0 * v2 + NfElem(4) * value(r) * v0 * v0;
}

std::optional<Outcome> case1(const Singularities& s, const Budget& budget, Trace* trace) {
  if (may_be_scalar(s)) {
    // one family; it finds one line, or all of them
    note(trace, 1, 0,
         "All exponent differences are integers, and no logarithm is known: there is "
         "one family up to integers.");
    return rational_lines(s, budget, trace);
  }
  if (auto lines = from_second_power(s, budget, trace)) return lines;
  return rational_lines(s, budget, trace);
}

} // namespace kov::kovacic
