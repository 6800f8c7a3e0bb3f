#pragma once
// Values for the parameters of a family, rational or in a number field Q(t): also where given
// polynomials vanish, so that strata without a random point are met.

#include "strata/decide_strata.hpp"
#include "support/random.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace kov::test {

/// A value for every parameter, in Q(t), t in one more variable of a larger ring.
class ParameterPoint {
public:
  /// values: of all parameters, in the variable t of the larger ring; field: of t
  ParameterPoint(std::size_t z, std::size_t t, Substitution values, Field field)
      : z_(z), t_(t), values_(std::move(values)), field_(std::move(field)) {}

  /// f, a function of z and the parameters.  Throws DomainError where it has no value.
  [[nodiscard]] RationalFunction at(const MFraction& f) const;
  /// f, a function of the parameters alone.
  [[nodiscard]] NfElem number(const MFraction& f) const;
  [[nodiscard]] bool holds(const Condition& c) const; ///< no order but between rationals
  [[nodiscard]] bool meets(const Assumptions& all) const;
  /// "a = 2, b = t, t a root of t^2 - 2"
  [[nodiscard]] std::string text(const Ring& ring) const;
  [[nodiscard]] const Field& field() const { return field_; }
  /// " --minpoly 't^2 - 2'", or nothing over Q: for a command line.
  [[nodiscard]] std::string minpoly_option() const;

private:
  [[nodiscard]] const Ring& larger() const { return values_.begin()->second.ring(); }
  [[nodiscard]] std::string minpoly() const;

  std::size_t z_, t_;
  Substitution values_;
  Field field_;
};

/// A point where all these polynomials in the parameters vanish; real parameters are rational, the
/// others rational or Gaussian.  Unset: none was met.
[[nodiscard]] std::optional<ParameterPoint>
random_point(const strata::Question& q, const std::vector<MPoly>& zero, Random& random);

} // namespace kov::test
