#pragma once
// The equations of motion around a line of configurations and the series that solve them: the rules
// J1 to J5 of docs/theory/jet_certificates.md.

#include "certify/jets/certificate.hpp"
#include "certify/jets/series.hpp"

namespace kov::certify {

class Motion {
public:
  Motion(const JetsCertificate& c, Arithmetic& a);

  void need_line();     ///< J1
  void need_place();    ///< J2
  void need_normal();   ///< J3
  void need_jets();     ///< J4
  void need_residues(); ///< J5
  void need_minor();    ///< J6

  [[nodiscard]] const std::string& rule() const { return rule_; } ///< the one that was last begun
  [[nodiscard]] const CurveAlgebra& algebra() const { return a_; }
  [[nodiscard]] long degree() const { return degree_; } ///< k of the potential on the line
  /// rho2 - rho1
  [[nodiscard]] Rational difference() const;
  /// v, g = -A v' or w in time of the system, as polynomials in y, ascending.
  [[nodiscard]] CurveRow potential() const { return column(potential_, 0); }
  [[nodiscard]] CurveRow tangential() const { return column(along_, 0); }
  [[nodiscard]] CurveRow normal() const { return column(across_, 1); }
  /// The coefficient of c1^i c2^(order + 1 - i) in the form.
  [[nodiscard]] CurveFunction entry(long i) const;
  /// The value of H on the solution, a polynomial in e.
  [[nodiscard]] CurveFunction energy() const;

private:
  void need_free(const CurveFunction& given, bool of_e) const;
  [[nodiscard]] CurveFunction dot(const std::array<CurveFunction, 2>& a,
                                  const std::array<CurveFunction, 2>& b) const;
  /// The Hamiltonian on the invariant subspace.
  [[nodiscard]] MPoly restricted() const;
  [[nodiscard]] Table chart_potential(const MPoly& v) const;
  [[nodiscard]] CurveRow column(const Table& f, long power_of_x) const;
  [[nodiscard]] LocalSeries polynomial_at(const CurveRow& f) const;
  [[nodiscard]] LocalSeries read(const JetSeries& x, long degree_in_c) const;
  void need_solution(const LocalSeries& x, const LocalSeries& force, long last_root) const;
  [[nodiscard]] LocalSeries acceleration(const LocalSeries& x) const;
  [[nodiscard]] CurveFunction by(const CurveFunction& f, std::size_t i) const;
  [[nodiscard]] bool equal(const CurveFunction& f, const CurveFunction& g) const {
    return a_.equal(f, g);
  }

  const JetsCertificate& c_;
  Arithmetic& arithmetic_;
  std::string rule_ = "J1";
  CurveAlgebra a_;
  SeriesAlgebra s_;
  Table potential_, across_, along_; ///< V, and the forces in time of the system
  long degree_ = 0;
  long first_ = 0, last_ = 0; ///< d sigma and d (2 - sigma)
  LocalSeries y_;
  std::array<LocalSeries, 2> u_;
  GradedSeries forces_x_, forces_y_, x_;
};

} // namespace kov::certify
