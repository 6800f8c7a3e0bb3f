#pragma once
// The singular places of y'' = r y and the local data that every algorithm starts from.
//
// A place is an irreducible factor q of den(r) over K, or infinity; its residue field is K[c]/q,
// where c stands for any root of q.  Nothing here splits q.  With t = z - c:
//
//   order 1      r = b1/t + ...            one log-free line, exponent 1; Delta = 1, always a log
//   order 2      r = b/t^2 + ...           exponents (1 +- Delta)/2, Delta^2 = 1 + 4b
//   order 2nu    r = u t^(-2nu) (1 + ...)  [sqrt r]_c = a (t^-nu + ... + s_2 t^-2), a^2 = u,
//     (>= 4)                               exponents (nu +- eps)/2, eps = beta/a, eps^2 = beta^2/u
//   odd >= 3     ramified: exponent order/4 in case 2 only
//
// and at infinity, with t = 1/z and o = deg den - deg num:
//
//   o >= 4         regular point of the sphere or apparent: Delta = 1, no log
//   o = 3          Delta = 1, log
//   o = 2          growth exponents (1 +- Delta)/2
//   o = -2nu <= 0  r = u z^(2nu) (1 + ...), [sqrt r]_inf = a (z^nu + ... + s_0),
//                  growth exponents (+-eps - nu)/2
//   o odd <= 1     ramified
//
// Source  [Kovacic1986] §3.1, §4.1; docs/theory/local_exponents.md, 1

#include "exact/budget.hpp"
#include "exact/factor.hpp"
#include "exact/rational_function.hpp"
#include "exact/truth.hpp"

#include <optional>
#include <vector>

namespace kov {

enum class PlaceKind : std::uint8_t {
  ordinary,  ///< infinity only: o >= 4
  simple,    ///< order 1, or o = 3 at infinity: Delta = 1 with a logarithm
  regular,   ///< order 2
  irregular, ///< even order >= 4, or even o <= 0 at infinity
  ramified   ///< odd order >= 3, or odd o <= 1 at infinity
};

/// One singular place with its local data.  At infinity `place` is 1 and `order` is o.
struct Singularity {
  Poly place = Poly(1); ///< monic irreducible over K, or 1 at infinity
  bool at_infinity = false;
  long order = 0;
  PlaceKind kind = PlaceKind::ordinary;

  /// regular: Delta^2; irregular: eps^2.  A polynomial in c of degree < deg q (a constant at
  /// infinity).  Unset for ramified places; 1 for simple and ordinary ones.
  Poly delta_squared = Poly(1);
  /// The root >= 0 of delta_squared if that is the square of a rational number.
  std::optional<Rational> delta;
  /// regular, Delta a natural number: is there a logarithm?  no for the kinds without question
  /// (Delta not an integer), yes for simple places and for Delta = 0.
  Truth log = Truth::no;

  /// irregular: r = u t^(-2nu) (1 + ...) with u here, and [sqrt r]/a = sum_i sqrt_tail[i] t^(i-nu)
  /// for 0 <= i <= nu-2 (finite; at infinity 0 <= i <= nu, powers of 1/z), sqrt_tail[0] = 1.
  Poly leading = Poly(0);
  std::vector<Poly> sqrt_tail;
  /// irregular: beta, with eps = beta/a.
  Poly beta = Poly(0);

  [[nodiscard]] long degree() const noexcept { return at_infinity ? 1 : kov::degree(place); }
  [[nodiscard]] long nu() const noexcept { return at_infinity ? -order / 2 : order / 2; }
};

struct Singularities {
  RationalFunction r;
  std::vector<Singularity> finite; ///< sorted: order, degree, coefficients
  Singularity infinity;
};

/// One of the places of an equation: an index into Singularities::finite; unset: infinity.
using PlaceIndex = std::optional<std::size_t>;
[[nodiscard]] inline const Singularity& place_at(const Singularities& s, PlaceIndex i) {
  return i ? s.finite.at(*i) : s.infinity;
}

/// Requires r != 0; otherwise InvalidArgument.
/// Throws   OutOfBudget
/// Cost     one factorisation of den(r); per place a few products modulo q; for Delta a natural
///          number N the logarithm test costs O(N) operations modulo q (first modulo one prime)
/// Example  singularities(z).infinity.kind  // -> PlaceKind::ramified
/// Example  singularities(RationalFunction(2, z*z)).finite.front().delta  // -> 3
/// Example  singularities(RationalFunction(1, z*z - 2)).finite.front().place  // -> z^2 - 2
[[nodiscard]] Singularities singularities(const RationalFunction& r, const Budget& budget = {});

} // namespace kov
