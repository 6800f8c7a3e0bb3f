#pragma once
// Exponential solutions y = P exp(int omega) of y'' = r(z; parameters) y on one stratum: the families
// of Kovacic's first case with parameters in them.
//
// Source  Kovacic 1986, section 3; docs/theory/spectrum.md, 1 and 2

#include "places/scheme.hpp"

namespace kov::strata {

/// One choice of an exponent at every place.
struct ExponentialFamily {
  MFraction omega;
  MFraction degree; ///< of P, in the parameters: a solution needs a natural number
  /// exp(int omega) = prod base^power exp(exponent).
  std::vector<std::pair<MPoly, MFraction>> powers;
  MFraction exponent;
};

/// All families: each exponential solution at each point of the stratum is in one of them.
struct ExponentialFamilies {
  std::vector<ExponentialFamily> all;
  std::string missing; ///< why they cannot be written down here; empty: they are all there
};

/// Cost  2^(number of places) families, at most 4096
/// Throws  OutOfBudget
/// Given   const Scheme weber = std::get<Scheme>(strata::scheme(z * z + a, 0, everywhere));
/// Example families_of_exponents(weber).all.size()  // -> 2
/// Example families_of_exponents(weber).all.at(0).degree  // -> (a - 1)/2
[[nodiscard]] ExponentialFamilies families_of_exponents(const Scheme& s, const Budget& budget = {});

/// P of a family, of the degree d, and what the parameters have to satisfy.
struct PolynomialPart {
  std::vector<MPoly> conditions; ///< each = 0; empty: for all parameters of the stratum
  std::vector<MFraction> p;      ///< ascending; monic
  std::string open;              ///< why the conditions were not found, or empty
};

/// P'' + 2 omega P' + (omega' + omega^2 - r) P = 0 with P monic of degree d.  Where the conditions
/// hold, and only there, P exists; that it solves the equation there is checked by substitution.
/// Requires 0 <= d
/// Throws  OutOfBudget
/// Example polynomial_part(weber, families_of_exponents(weber).all.at(0), 0, everywhere).conditions
///         // -> {a - 1}
[[nodiscard]] PolynomialPart polynomial_part(const Scheme& s, const ExponentialFamily& f, long d,
                                             const ParametrisedSet& region,
                                             const Budget& budget = {});

/// Exponential solutions on a stratum, as far as they were found.
struct ExponentialSolutions {
  std::optional<MFraction> w; ///< y'/y of one that exists at every point
  bool none = false;          ///< there is none at any point
  /// Irreducible, if neither: there is one only where this vanishes, or another polynomial does.
  std::optional<MPoly> needs;
};

/// Cost    polynomial parts of degree 20 at most
/// Given   const ParametrisedSet there = everywhere.where_nonzero(a.num());
/// Given   const MFraction square = pow(z, 6) * a * a + Rational(3) * a * z * z;
/// Given   const Scheme s = std::get<Scheme>(scheme(square, 0, there));
/// Example *exponential_solutions(s, there).w  // -> z^3*a
/// Given   const Scheme shifted = std::get<Scheme>(scheme(square + a * a - a, 0, there));
/// Given   const MPoly needs = *exponential_solutions(shifted, there).needs;
/// Example needs  // -> a - 1
/// Example exponential_solutions(shifted, there.where_nonzero(needs)).none  // -> yes
[[nodiscard]] ExponentialSolutions
exponential_solutions(const Scheme& s, const ParametrisedSet& region, const Budget& budget = {});

} // namespace kov::strata
