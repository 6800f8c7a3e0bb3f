#pragma once
// Homogeneous potentials, or such parts of them, at their Darboux points: theorem_certificates.md 16.

#include "certify/theorem/fact.hpp"

namespace kov::certify {

/// Which terms of the potential are looked at.
enum class PotentialPart : std::uint8_t { all, highest, lowest };

/// The directions of Darboux points of H = p.M p/2 + V(q) in a chart, w along the first coordinate:
/// q = (a w - b, b w + a).
struct DarbouxChart {
  std::array<std::size_t, 2> coordinates{}, momenta{}; ///< as variables of the ring
  PotentialPart part = PotentialPart::all;
  long degree = 0, a = 1, b = 0;
};

/// The contents of the chart: polynomials in w and the parameters.
struct DarbouxForms {
  MPoly potential; ///< V(w, 1)
  MPoly circle;    ///< 0 at the isotropic directions
  MPoly
      directions; ///< 0 at the directions of Darboux points, and where the potential vanishes twice
  MPoly determinant; ///< of the masses
};
/// Refuses a Hamiltonian of another kind.
[[nodiscard]] DarbouxForms darboux_forms(const StepPlace& x, const DarbouxChart& c, Arithmetic& a);
/// Res(f, g) by w as Sylvester's determinant, up to its sign.
[[nodiscard]] MPoly resultant_in(const MPoly& f, const MPoly& g, std::size_t w, Arithmetic& a);
/// prod (L - Lambda_i) over the zeros of `proper`, up to a factor: by powers of L.
[[nodiscard]] Coefficients eigenvalues_at(const DarbouxForms& f, const DarbouxChart& c,
                                          const MPoly& proper, Arithmetic& a);
/// The multisets of n numbers Lambda = lambda - 1 != 0, lambda in the table of Morales-Ruiz and Ramis for the
/// degree k >= 3, with this sum of 1/Lambda; each ascending, in this order.
[[nodiscard]] std::vector<std::vector<Rational>> eigenvalue_sets(long k, long n,
                                                                 const Rational& sum);
/// All vanish exactly where these are the zeros of chi with their multiplicities.
[[nodiscard]] std::vector<MPoly> equations_for(const Coefficients& chi,
                                               const std::vector<Rational>& values, Arithmetic& a);

} // namespace kov::certify
