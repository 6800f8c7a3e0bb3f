#pragma once
// Values that steps of theorem_certificates.md compute, for the judge and for a writer: by section.

#include "certify/theorem/fact.hpp"

namespace kov::certify {

// ---- 13: enough first integrals where some parameters are functions of the others

/// A multiple of f by a number, less multiples of the equations: from the last variable to the first it is
/// divided by the first of those whose last variable this is, with a number as its leading coefficient there.
[[nodiscard]] MPoly modulo_equations(MPoly f, const std::vector<MPoly>& equations, Arithmetic& a);

/// For a writer: the polynomial of which a coefficient is shown not to vanish.  rank: of the bracket, or
/// of the fields.   Errors  Refused
[[nodiscard]] MPoly minor_of(const StepPlace& x, const ClaimedIntegrals& c, bool rank,
                             const std::vector<std::size_t>& columns, Arithmetic& a);

// ---- 6: splitting of separatrices of a perturbed Euler top

/// The names of a step, and its perturbation H1 = first/(2 (A B C)^power) of this order.
struct SplittingData {
  std::array<std::size_t, 3> moments{}, small{}; ///< parameters of the family
  unsigned long order = 1, power = 1;
  MPoly first;
  Conditions region;
};

/// The real variables of the proof: those of the family, _alpha, _beta, _delta, _s, _F, _Y (and _i,
/// which does not occur in a condition).
[[nodiscard]] Ring splitting_ring(const Family& y);

/// Z4, Z5: the conditions of which the proof shows that no point satisfies them all, in the ring
/// above.  Refuses a perturbation of degree above 12.
[[nodiscard]] Conditions splitting_conditions(const Family& y, const SplittingData& d,
                                              const Ring& ring, Arithmetic& a);

// ---- 16: homogeneous potentials, or such parts of them, at their Darboux points

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

// ---- 17: two exponent differences that are special together at finitely many values only

/// A number whose square is a function of parameters.  If the identity component is abelian it is in (1/N)Z, and
/// special.
class ExponentDifference {
public:
  /// Refuses one of which nothing follows.   Requires that its polynomials are in one ring
  explicit ExponentDifference(OneDifference d);

  [[nodiscard]] const Fraction& square() const { return d_.square; }
  [[nodiscard]] const Integer& N() const { return N_; }
  [[nodiscard]] bool is_special(const Rational& x) const;

private:
  OneDifference d_;
  Integer N_;
};

/// Delta2^2 = F(Delta1^2), F = A/B.
struct ValuesOfDifferences {
  Poly A, B;
  long bound = 0; ///< of N Delta1
  /// For larger ones N Delta2 lies between this number and the next; unset:
  /// Delta2^2 is negative.
  std::optional<Integer> gap{};
};
/// It is 0 where Delta2^2 = F(Delta1^2).
[[nodiscard]] MPoly off_function(const ExponentDifference& first, const ExponentDifference& second,
                                 const ValuesOfDifferences& f, Arithmetic& a);
/// Is it shown that there is no value from the bound on?
[[nodiscard]] bool shows_bound(const ExponentDifference& first, const ExponentDifference& second,
                               const ValuesOfDifferences& f);
/// Delta1 is none of the values at which both may be special.
[[nodiscard]] Conditions no_common_values(const ExponentDifference& first,
                                          const ExponentDifference& second,
                                          const ValuesOfDifferences& f);

} // namespace kov::certify
