#pragma once
// The singular places of y'' = r(z; parameters) y on one stratum: the parametric counterpart of
// linode/singularities.hpp.
//
// A place is an irreducible factor q of den(r) over Q(parameters), or infinity, where t = 1/z turns
// r into t^-4 r(1/t).  The data hold at every root of q and at every point of the stratum;
// where that is not so, `scheme` names the polynomial whose vanishing has to be decided first.
// docs/theory/strata.md, 3

#include "linode/singularities.hpp"
#include "parameters/parametrised_set.hpp"

namespace kov::strata {

/// A place by its name alone.
struct PlaceName {
  MPoly q;
  bool at_infinity = false;
  std::size_t z = 0;
};

/// The change that happens where a polynomial vanishes.
struct Event {
  enum class Kind : std::uint8_t {
    assumed,             ///< it is assumed to vanish
    no_value,            ///< r has none there
    pole_to_infinity,    ///< a pole goes to infinity
    poles_meet,          ///< two poles meet
    order_drops,         ///< of the pole at `place`
    exponents_change,    ///< at `place`
    difference_real,     ///< the exponent difference at `place` becomes real
    logarithm_vanishes,  ///< there is none at `place`
    difference_is,       ///< Delta = value at `place`
    invariant_vanishes,  ///< the one that was found may be 0
    invariant_appears,   ///< Sym^m may have one
    exponential_appears, ///< there may be an exponential solution
    divided_by,          ///< the equation `solved` = 0 is solved by division by it
    reduction            ///< the reduction to y'' = r y divides by it: `shown`
  };
  Kind kind = Kind::assumed;
  PlaceName place{};
  long m = 0;
  Rational value{};
  MPoly solved{};
  std::string shown{}; ///< in the words of who made the reduction
};

/// Whether this polynomial vanishes matters, and is not known on the stratum.
struct Needs {
  MPoly p; ///< irreducible, in the parameters that are left
  Event why;
};

/// How it is known that Delta is not rational.
enum class Irrationality : std::uint8_t {
  none,
  constant,     ///< Delta^2 is an algebraic constant, not the square of a rational number
  coefficients, ///< those of chi are positive: no root is >= 0
  discriminant, ///< chi is real of degree 2 and its discriminant negative: no root is real
  refuted       ///< Z3: no root of chi is real and >= 0
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
  Irrationality irrational = Irrationality::none;
  bool negative_square = false; ///< Delta^2 < 0 on the whole stratum
  Truth log = Truth::no;        ///< Delta in N: yes = at every root, everywhere; no = nowhere
  /// Delta >= 1: no root is without logarithm unless this is 0.  log = yes: it is proved not to be;
  /// unknown: a factor of it that is in doubt.
  std::optional<MPoly> log_norm;

  [[nodiscard]] long degree(std::size_t z) const { return at_infinity ? 1 : kov::degree(q, z); }
};

struct Scheme {
  MFraction r;
  std::size_t z = 0;
  std::vector<ParametricPlace> finite;
  ParametricPlace infinity;
};

/// The number of a place: those of Scheme::finite, then infinity.
using PlaceIndex = std::size_t;
[[nodiscard]] inline const ParametricPlace& place_at(const Scheme& s, PlaceIndex i) {
  return i < s.finite.size() ? s.finite[i] : s.infinity;
}
[[nodiscard]] inline PlaceIndex number_of_places(const Scheme& s) { return s.finite.size() + 1; }

/// Requires r != 0, in the parameters left in the region.
/// Throws  OutOfBudget
/// Given   const Scheme airy = std::get<Scheme>(scheme(z + a, 0, everywhere));
/// Example airy.infinity.kind  // -> PlaceKind::ramified
/// Example std::get<Needs>(scheme(a / z, 0, everywhere)).p  // -> a
[[nodiscard]] std::variant<Scheme, Needs>
scheme(const MFraction& r, std::size_t z, const ParametrisedSet& region, const Budget& budget = {});

[[nodiscard]] PlaceName name_of(const ParametricPlace& p, std::size_t z);
/// "z = a/b", "z^2 - a = 0", "infinity"
[[nodiscard]] std::string place_name(const PlaceName& p);
[[nodiscard]] std::string place_name(const ParametricPlace& p, std::size_t z);
/// "Delta^2 = 9/4 - 2*A/C", or what Delta^2 is a root of.
[[nodiscard]] std::string square_text(const ParametricPlace& p);

} // namespace kov::strata
