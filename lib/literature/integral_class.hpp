#pragma once
// Classes of first integrals, of which a theorem says that no complete set of integrals lies in them.
//
// A class is a value: it is computed where the theorem is applied, compared here, and put into words by
// sentence() alone.  Nothing reads those words.
//
// Source  docs/theory/mechanics.md (6), "Class of first integrals"

#include "exact/truth.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kov {

struct IntegralClass {
  enum class Kind : std::uint8_t { rational, meromorphic, real_analytic };
  /// The points near which the functions are of this kind.
  enum class Near : std::uint8_t {
    curve,        ///< near the phase curves
    closed_curve, ///< also at the points that close them: at infinity, equilibria, poles of the system
    level,        ///< on the leaves of a rigid body with F2 = 0
    origin,       ///< near the origin of the phase space
    phase_space ///< everywhere
  };

  Kind kind = Kind::meromorphic;
  Near near = Near::curve;
  std::vector<std::string> curves = {}; ///< near curve, closed_curve: near each of these
  /// Independent on the symplectic leaf of the phase curve; else together with the Casimir functions.
  bool on_leaf = false;
  /// Function symbols (of the coordinates) in which, beside the coordinates, they are of this kind.
  std::vector<std::string> functions = {};
  std::vector<std::string> without = {}; ///< coordinates and symbols on which they do not depend,
  /// but through symbols that are functions of them: coordinate and symbol.
  std::vector<std::pair<std::string, std::string>> through = {};
  std::string frame = {}; ///< whose coordinates these are: "of FILE", "X = x - 1, y"; empty: ours
  bool liouville = true;  ///< in involution; else with commuting vector fields

  friend bool operator==(const IntegralClass&, const IntegralClass&) = default;
};

/// The words of files and certificates: "rational", "meromorphic", "real-analytic"; "curve", "closed curve",
/// "level", "origin", "phase space".
/// Example word_of(IntegralClass::Kind::real_analytic)  // -> real-analytic
[[nodiscard]] std::string_view word_of(IntegralClass::Kind k);
/// Example word_of(IntegralClass::Near::closed_curve)  // -> closed curve
[[nodiscard]] std::string_view word_of(IntegralClass::Near n);
inline constexpr std::array all_kinds{IntegralClass::Kind::rational,
                                      IntegralClass::Kind::meromorphic,
                                      IntegralClass::Kind::real_analytic};
inline constexpr std::array all_places{
    IntegralClass::Near::curve, IntegralClass::Near::closed_curve, IntegralClass::Near::level,
    IntegralClass::Near::origin, IntegralClass::Near::phase_space};

/// Is each complete set of integrals of the class `inner` one of the class `outer`?  yes only where that is
/// proved: to exclude `outer` is to exclude `inner`.
///   rational, also in function symbols < meromorphic near the curve;
///   rational < meromorphic near the closed curve (without function symbols) < near the curve;
///   more curves < fewer; without x and y < without x; with fewer function symbols < with more;
///   independent on a leaf < independent together with the Casimir functions.
/// Example contains(IntegralClass{}, IntegralClass{.near = IntegralClass::Near::closed_curve})  // -> Truth::yes
/// Example contains(IntegralClass{.near = IntegralClass::Near::closed_curve}, IntegralClass{})  // -> Truth::unknown
[[nodiscard]] Truth contains(const IntegralClass& outer, const IntegralClass& inner);

/// If at each point one of several classes is excluded, the class that is excluded at all: integrals that are
/// of all these classes at once.  Few members: two are one where a class is known that both contain and
/// that contains all that is in both.
[[nodiscard]] std::vector<IntegralClass> at_once(const std::vector<IntegralClass>& classes);

/// Are all rational functions of the coordinates of this class, as far as independence is meant alike?
/// Example has_rational_functions(IntegralClass{})  // -> yes
[[nodiscard]] bool has_rational_functions(const IntegralClass& c);

/// Facts that decide about the classes along a map y = Phi(x), linear and invertible, that carries a system
/// to one of the same family.
struct MapFacts {
  bool real = true;
  std::map<std::string, std::vector<std::string>> uses =
      {}; ///< of each y the x on which y o Phi depends
};
/// A class L such that all f o Phi, f in the class c, are all of L: excluded with c.  The curves keep their
/// names.  Unset: what is left out is mixed with the rest, or c speaks of what the map does not know.
/// Source  docs/theory/mechanics.md (6), "Classes along maps"
[[nodiscard]] std::optional<IntegralClass> carried(const IntegralClass& c, const MapFacts& map);

/// "meromorphic (in the coordinates and s, c) and do not depend on q": what first integrals are.
/// Example sentence(IntegralClass{.near = IntegralClass::Near::origin})  // -> meromorphic near the origin
[[nodiscard]] std::string sentence(const IntegralClass& c);
/// "at once X and Y" of several.
[[nodiscard]] std::string sentence(const std::vector<IntegralClass>& classes);
/// "first integrals that are X", with commuting vector fields where the class has them.
[[nodiscard]] std::string first_integrals(const std::vector<IntegralClass>& classes);

} // namespace kov
