#pragma once
// R = K(z)[w_1, ..., w_k]/(w_i^(d_i) - v_i) with its derivation D: system_certificates.md C1, C2.
// R is free over K(z), so that an element is 0 exactly if its reduced numerator is.

#include "certify/system/certificate.hpp"
#include "proof/algebra/arithmetic.hpp"

#include <set>

namespace kov::certify {

/// The names in an element as it was given, and in the steps of the tower that it uses.
[[nodiscard]] std::set<std::string> names_in(const PhaseCurve& c, const CurveFunction& f);

class CurveAlgebra {
public:
  /// C1; refuses denominators and a tower that are not of its form.
  CurveAlgebra(const PhaseCurve& c, Arithmetic& a);
  void need_derivation(); ///< C2

  [[nodiscard]] CurveFunction zero() const { return {MPoly(c_.ring), Integer(1), {}}; }
  [[nodiscard]] CurveFunction integer(long n) const {
    return {MPoly(c_.ring, Integer(n)), {1}, {}};
  }
  [[nodiscard]] CurveFunction variable(std::size_t i) const {
    return {MPoly::variable(c_.ring, i), Integer(1), {}};
  }
  /// The element in its canonical basis, shortened by what is easily seen.
  [[nodiscard]] CurveFunction reduced(CurveFunction f) const;
  [[nodiscard]] CurveFunction plus(const CurveFunction& f, const CurveFunction& g) const;
  [[nodiscard]] CurveFunction minus(const CurveFunction& f, const CurveFunction& g) const;
  [[nodiscard]] CurveFunction times(const CurveFunction& f, const CurveFunction& g) const;
  [[nodiscard]] CurveFunction power(const CurveFunction& f, unsigned long e) const;
  [[nodiscard]] CurveFunction over(const CurveFunction& f, const Integer& n) const {
    return {f.p, f.n * n, f.over};
  }
  [[nodiscard]] CurveFunction derivative(const CurveFunction& f) const; ///< D f
  [[nodiscard]] bool equal(const CurveFunction& f, const CurveFunction& g) const {
    return is_zero(minus(f, g).p);
  }
  /// The determinant of the multiplication by f, times denominators and a number, in z and the parameters: f
  /// has an inverse in R unless it is 0.
  [[nodiscard]] MPoly norm(const CurveFunction& f) const;
  /// Is the norm not 0 for all z wherever no denominator is, and none of these?
  [[nodiscard]] bool is_unit(MPoly norm, const std::vector<MPoly>& where) const;
  /// Work that is not seen in polynomials: see Arithmetic.
  void charge(double products) const { a_.charge(products); }
  /// A polynomial whose variable i has this value.
  [[nodiscard]] CurveFunction evaluate(const MPoly& f,
                                       const std::vector<std::optional<CurveFunction>>& at) const;

private:
  [[nodiscard]] MPoly denominator(const std::vector<unsigned long>& e) const;
  [[nodiscard]] CurveFunction shortened(CurveFunction f) const;
  [[nodiscard]] CurveFunction lowered(const CurveFunction& f, std::size_t i) const;
  [[nodiscard]] bool depends_on_z_only(const MPoly& f) const;
  void by_tower(const MPoly& f, std::size_t steps, std::vector<MPoly>& row) const;

  const PhaseCurve& c_;
  Arithmetic& a_;
};

} // namespace kov::certify
