#pragma once
// The system along the curve, and the rules C4 to N4 of system_certificates.md.

#include "certify/system/curve_algebra.hpp"
#include "certify/system/phase_space.hpp"

#include <set>

namespace kov::certify {

class OnCurve {
public:
  /// S1, S2 and C1.
  OnCurve(const Way& w, Arithmetic& a);

  void need_claims(); ///< S4
  void need_curve();  ///< C2 to C7
  void need_normal(); ///< N1, and N2, N3 for y'' = r y
  /// N4, for r in z, parameters and constants; of each group one member is not 0.
  void need_equation(const Fraction& r, const std::vector<std::vector<MPoly>>& generic);
  /// N4, what an equation assumes of the constants of the system.
  void need_assumptions(const StrataCertificate& c);
  /// N4, for r over Q(a), with a in the place of the generator.
  void need_equation(const Poly& num, const Poly& den, const std::optional<CurveFunction>& a);
  /// N5, for Y' = A Y likewise.
  void need_system(const LoopsCertificate& c, const std::optional<CurveFunction>& a);

  /// By phase variable: the functions that have a value (fixed: the fixed ones, too), and the coordinates with
  /// a value on which they depend.
  [[nodiscard]] std::vector<bool> seen_by_functions(bool fixed) const;
  /// Is it 0 along the curve?  false: a name has no value.
  [[nodiscard]] bool holds(const MPoly& f) const {
    return is_known(f) && is_zero(at({f, Integer(1)}).p);
  }

  /// Section 7: the leaves around the curve are regular, of dimension four, and cut out by Casimir
  /// functions that are claimed.
  [[nodiscard]] bool has_regular_leaves() const;
  /// Section 7: the names of what is left out and moves.
  [[nodiscard]] std::vector<std::string> moving();
  [[nodiscard]] const std::string& rule() const { return rule_; } ///< the one that was last begun

private:
  using Row = std::vector<CurveFunction>;

  [[nodiscard]] CurveFunction at(const PhaseFunction& f) const; ///< f(x)
  [[nodiscard]] std::optional<CurveFunction> velocity(std::size_t variable) const;
  void need_functions() const;
  void need_no_constant_in_disguise(); ///< C7
  void need_own_names() const;
  [[nodiscard]] bool is_known(const MPoly& f) const;
  [[nodiscard]] bool moves(const PhaseSymbol& f, bool divided) const;
  struct Content {
    MPoly factor, rest;
  };
  [[nodiscard]] Content content(const MPoly& f, bool constant = false) const;
  [[nodiscard]] std::optional<Rational> number(const CurveFunction& f) const;
  [[nodiscard]] bool holds(const CurveFunction& f, Sign sign) const;
  [[nodiscard]] std::vector<std::optional<CurveFunction>> values_of(const Ring& ring) const;
  [[nodiscard]] Row jacobian_row(std::size_t i) const;
  [[nodiscard]] bool is_nowhere_zero(const CurveFunction& f) const;
  [[nodiscard]] bool has_rank_four() const;
  [[nodiscard]] bool has_independent_casimirs(std::size_t k) const;
  [[nodiscard]] Row nabla(const Row& a) const;
  [[nodiscard]] Row combination(const Row& c, std::size_t entries) const;
  [[nodiscard]] CurveFunction dot(const Row& a, const Row& b) const;
  [[nodiscard]] Row tangent(const Row& given) const; ///< b_i of N3
  [[nodiscard]] bool equal(const Row& a, const Row& b) const;
  void need_length(const Row& a) const;
  void need_r(const CurveFunction& num, const CurveFunction& den) const;
  [[nodiscard]] CurveFunction value(const Poly& f, const CurveFunction& a) const;
  [[nodiscard]] CurveFunction root_of(const Field& k, const std::optional<CurveFunction>& a) const;
  void need_vectors(const std::vector<Row>& rows) const; ///< N3

  const Way& w_;
  Arithmetic& a_;
  std::string rule_ = "S1";
  PhaseSpace space_;
  CurveAlgebra algebra_;
  std::vector<PhaseFunction> field_;
  std::vector<std::optional<CurveFunction>> values_; ///< by phase variable
  std::vector<bool> fixed_; ///< by phase variable: algebraic over the coordinates and parameters
  std::vector<Row> jacobian_;
};

} // namespace kov::certify
