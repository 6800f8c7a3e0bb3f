#pragma once
// Functions in the names of a system certificate: on phase space, where what is divided by becomes
// a symbol, and on the phase curve, in the names of a tower (docs/theory/system_certificates.md).

#include "algebraize/tower.hpp"
#include "certify/system/check.hpp"
#include "exact/factors.hpp"
#include "integrability/curve_rows.hpp"
#include "system/system.hpp"

namespace kov {

/// Written by its Hamiltonian and a bracket, and not by its components.
[[nodiscard]] inline bool has_bracket(const VectorField& v) { return v.poisson && v.hamiltonian; }

/// Polynomials in the phase names; what is divided by becomes a symbol.
class PhaseWriter {
public:
  explicit PhaseWriter(const System& s) : s_(s), v_(s.field) {}

  /// To be called for everything that is written later.
  void divide(const MFraction& f) {
    if (!is_zero(f)) factors_.of(f.den());
  }
  void divide(const VectorField& v); ///< all that write(v) writes
  /// To be called once, between the two.
  void make_ring();

  [[nodiscard]] certify::PhaseFunction write(const MFraction& f);
  /// The field of the system, or one that equals it modulo its relations.
  [[nodiscard]] certify::PhaseSystem write(const VectorField& v);
  [[nodiscard]] MPoly moved(const MPoly& f) const;
  [[nodiscard]] const Ring& ring() const { return ring_; }
  [[nodiscard]] const std::vector<MPoly>& divisors() const { return factors_.all(); }
  [[nodiscard]] std::size_t first_inverse() const {
    return v_.dimension() + v_.functions.size() + v_.constants.size();
  }
  /// The variable of the system with this place in the ring; not for inverses.
  [[nodiscard]] std::size_t original(std::size_t i) const {
    return s_.ring()->index(ring_->name(i));
  }

private:
  [[nodiscard]] std::string fresh(std::string name) const;

  const System& s_;
  const VectorField& v_;
  Factors factors_;
  Ring ring_;
};

/// Elements of the function field in the names of the tower, which must stay alive.
class CurveWriter {
public:
  CurveWriter(const System& s, std::size_t z, const Tower& tower);

  [[nodiscard]] certify::CurveFunction write(const FunctionField::Element& a);
  [[nodiscard]] certify::CurveRow write(const CurveRows::Row& row);
  [[nodiscard]] const Ring& ring() const { return ring_; }
  [[nodiscard]] const std::vector<MPoly>& denominators() const { return factors_.all(); }
  [[nodiscard]] MPoly moved(const MPoly& f) const { return transfer(MFraction(f), ring_).num(); }

private:
  [[nodiscard]] MPoly monomial(const Tower::Exponents& e) const;

  const Tower& tower_;
  Factors factors_;
  Ring ring_;
};

} // namespace kov
