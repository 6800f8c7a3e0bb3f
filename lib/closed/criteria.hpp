#pragma once
// The exact answers of classical equations for all parameters at once, as parts of a stratum that
// are told apart by arithmetic conditions.
//
//   two regular places                          Euler
//   three of them                               Riemann (Kimura's theorem)
//   one irregular place and at most one other   y'' = c y, Airy, Weber, polynomials, Bessel,
//                                               Whittaker
//
// and equations that become one of these in w = (z - c)^k: the identity component is the same.
//
// Source  docs/theory/strata.md, 10; kimura.md, confluent.md

#include "closed/classical.hpp"
#include "closed/parts.hpp"
#include "places/scheme.hpp"

namespace kov::strata {

/// The equation is this classical one after a Moebius map of w = (z - centre)^power, power != 0.
struct ClassicalForm {
  Classical family = Classical::constant;
  std::vector<std::pair<std::string, MFraction>> squares; ///< names and squares of its numbers
  MFraction centre;
  long power = 1;
  std::vector<std::pair<std::string, MFraction>> values{}; ///< of its other numbers
};

/// y'' = r y in x, for a certificate: strata_certificates.md 7.8.
struct ClassicalEquation {
  std::size_t z = 0; ///< also the name of x
  MFraction r;
  std::vector<MPoly> factors;     ///< of Riemann, Lame: the finite places
  std::vector<MFraction> numbers; ///< squares, as the format wants them
};

struct ClassicalAnswer {
  ClassicalForm form;
  std::vector<Part> parts; ///< at least one; disjoint, and they cover the stratum
  /// Its variable as a function of z; of Euler and Riemann: the places are not moved.
  MFraction x;
  std::optional<ClassicalEquation> equation{}; ///< where the format has a rule
  /// A number of the equation on which the answer does not depend.
  std::optional<std::pair<std::string, MFraction>> scale{};
};

/// Unset: another equation.  Needs: the answer depends on whether this vanishes.
/// maps: Lame's equation and w = (z - c)^k are looked at, too.
/// Throws  OutOfBudget
/// Given   const ParametrisedSet there = everywhere.where_nonzero(a.num());
/// Given   const Scheme s = std::get<Scheme>(scheme(a, 0, there));
/// Given   const auto answer = std::get<ClassicalAnswer>(classical_answer(s, there));
/// Example answer.form.family  // -> constant
[[nodiscard]] std::variant<std::monostate, ClassicalAnswer, Needs>
classical_answer(const Scheme& s, const ParametrisedSet& region, const Budget& budget = {},
                 bool maps = true);

} // namespace kov::strata
