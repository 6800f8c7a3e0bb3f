#pragma once
// Facts known at a node of the tree: strata_certificates.md 3, and the substitution of 4 `solve`.

#include "certify/strata/arithmetic.hpp"
#include "certify/strata/certificate.hpp"

namespace kov::certify {

class Stratum {
public:
  /// The stratum of all admitted points.
  Stratum(const StrataCertificate& c, Arithmetic& arithmetic);

  [[nodiscard]] Arithmetic& arithmetic() const { return *arithmetic_; }
  [[nodiscard]] const std::vector<Condition>& conditions() const { return conditions_; }
  /// Refuses an index that is out of range.
  [[nodiscard]] const Condition& condition(std::size_t i) const;
  [[nodiscard]] const std::vector<MPoly>& group(std::size_t i) const;
  [[nodiscard]] bool defined() const { return r_.has_value(); } ///< den is not 0
  [[nodiscard]] const Fraction& r() const;                      ///< Refuses when den became 0.

  /// Refuses a polynomial with the variable z or with parameters that are solved for.
  void need_parameters(const MPoly& p) const;
  void need_variables(const MPoly& p) const; ///< the same; z is allowed
  [[nodiscard]] bool all_real(const MPoly& p) const;
  [[nodiscard]] bool is_rational(std::size_t variable) const { return rational_[variable]; }
  [[nodiscard]] const Membership& membership(std::size_t i) const; ///< Refuses, as condition().
  /// Refuses unless a membership would have the value that it has not: where p = 0; everywhere if p
  /// is null.
  void need_violated(const Violation& v, const MPoly* p) const;
  /// p without the members of **nonzero**, each as often as it divides what is left.
  [[nodiscard]] MPoly stripped(MPoly p) const;
  [[nodiscard]] bool known_nonzero(const MPoly& p) const;
  [[nodiscard]] bool known_positive(const MPoly& p) const;
  /// By its data alone: 4 `empty` without terms.
  [[nodiscard]] bool plainly_empty() const;

  /// Members are refined: the new one is divided by the old ones and these by it, so that a product
  /// of members is recognised whatever the order in which they came.
  void add_nonzero(const MPoly& p);
  void add_positive(const MPoly& p);
  /// The points with p = 0, p = l x + m.
  void solve(const MPoly& p, const SolvedStratum& how);
  /// A number that the work of copying this is proportional to.
  [[nodiscard]] double size() const;

private:
  void replace_conditions(std::size_t x, const class Root& root);
  void replace_r(std::size_t x, const class Root& root, const std::optional<Fraction>& given);
  void learn_field(const MPoly& p, std::size_t x);

  Arithmetic* arithmetic_;
  std::vector<bool> left_; ///< by variable; false for z and for what was solved for
  std::vector<bool> real_, rational_;
  std::vector<Condition> conditions_;
  std::vector<Membership> memberships_;
  std::vector<MPoly> nonzero_; ///< primitive
  std::vector<std::vector<MPoly>> generic_;
  std::optional<Fraction> r_;
};

} // namespace kov::certify
