#pragma once
// The state at a node of the tree: strata_certificates.md 3, and the substitution of 4 `solve`.

#include "certify/strata/certificate.hpp"
#include "proof/condition/set.hpp"

namespace kov::certify {

class Stratum : public ConditionSet {
public:
  /// The stratum of all admitted points.
  Stratum(const StrataCertificate& c, Arithmetic& arithmetic);

  [[nodiscard]] bool defined() const { return r_.has_value(); } ///< den is not 0
  [[nodiscard]] const Fraction& r() const;                      ///< Refuses when den became 0.

  /// Refuses a polynomial with the variable z or with parameters that are solved for.
  void need_parameters(const MPoly& p) const;
  void need_variables(const MPoly& p) const; ///< the same; z is allowed
  /// By its data alone: 4 `empty` without terms.
  [[nodiscard]] bool plainly_empty() const;

  /// The points with p = 0, p = l x + m.
  void solve(const MPoly& p, const SolvedStratum& how);
  [[nodiscard]] double size() const;

private:
  void replace_r(std::size_t x, const Root& root, const std::optional<Fraction>& given);

  std::optional<Fraction> r_;
};

} // namespace kov::certify
