#pragma once
// The singular places of y'' = r(z; parameters) y on one stratum: the parametric counterpart of
// linode/singularities.hpp.
//
// A place is an irreducible factor q of den(r) over Q(parameters), or infinity, where t = 1/z turns
// r into t^-4 r(1/t).  What is stored holds at every root of q and at every point of the stratum;
// where that is not so, `scheme` names the polynomial whose vanishing has to be decided first.
// docs/theory/strata.md, 3

#include "linode/singularities.hpp"
#include "strata/region.hpp"

namespace kov::strata {

/// Whether this polynomial vanishes matters, and is not known on the stratum.
struct Needs {
  MPoly p; ///< irreducible, in the parameters that are left
  std::string why;
};

enum class ExponentKind : std::uint8_t {
  rational,   ///< Delta is one rational number
  irrational, ///< Delta is irrational at every root and every point of the stratum
  open        ///< Delta^2 depends on the parameters and may be the square of a rational number
};

struct ParametricPlace {
  bool at_infinity = false;
  MPoly q;        ///< in z; at infinity the variable itself
  long order = 0; ///< of the pole, in z or in t; 2 stands for "at most 2", Delta says the rest
  PlaceKind kind = PlaceKind::ordinary;
  ExponentKind exponent = ExponentKind::rational;
  std::vector<MFraction> chi; ///< minimal polynomial of Delta^2 over Q(parameters), ascending
  Rational delta = 1;         ///< if rational
  std::string irrational_because;
  bool negative_square = false;  ///< Delta^2 < 0 on the whole stratum
  Truth log = Truth::no;         ///< Delta in N: yes = at every root, everywhere; no = nowhere
  std::optional<MPoly> log_norm; ///< log unknown: no root has a log-free point unless this is 0

  [[nodiscard]] long degree(std::size_t z) const { return at_infinity ? 1 : kov::degree(q, z); }
};

struct Scheme {
  MFraction r;
  std::size_t z = 0;
  std::vector<ParametricPlace> finite;
  ParametricPlace infinity;
};

/// Requires r != 0, in the parameters left in the region.
[[nodiscard]] std::variant<Scheme, Needs> scheme(const MFraction& r, std::size_t z,
                                                 const Region& region, const Budget& budget = {});

/// At a regular place with Delta = N >= 1 in N: vanishes where some root of q has no logarithm.
/// Unset: identically 0, or N is too large to look.
[[nodiscard]] std::optional<MPoly> logarithm_defect(const MFraction& r, std::size_t z,
                                                    const ParametricPlace& p, const Region& region);

[[nodiscard]] std::string place_name(const ParametricPlace& p, std::size_t z);
/// "Delta^2 = 9/4 - 2*A/C", or what Delta^2 is a root of.
[[nodiscard]] std::string square_text(const ParametricPlace& p);

} // namespace kov::strata
