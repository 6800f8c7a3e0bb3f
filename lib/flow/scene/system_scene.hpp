#pragma once
// A scene of any system: which section, which level, which orbits.  A [scene] or [[scene]] table of a system file, or
// a file of its own that names the system:
//
//   format = "scene/1"       system = "henon_heiles.toml"        (only in a file of its own)
//   name        of the files that are written; needed if a file has several scenes
//   title       source
//   set         {k = "sqrt(2)", ...}: values of the parameters that the system leaves open
//   section     "q1" or "q1 = 0": any formula of the system
//   direction   "upward": the formula grows | "downward" | "both"       where = a formula that is positive there
//   levels      {H = "1/12", "x^2 + y^2" = 1}: names or formulas, and their values
//   start       ["z = 0", ...]: further equations that hold at the start of each orbit
//   plot        ["q2", "p2"]: what is drawn; or ["z"]: each value of z against the next one (states only)
//                            angles = ["phi"]: which of it counts modulo 2 pi
//   vary        {r = [a, b, n]}: a diagram over n values of a parameter; plot has one function
//   range       [[a, b], [c, d]] for grid, random and the picture; without it what lies over the level (window.hpp)
//   seeds       [[u, v], ...] values of what is drawn; and/or grid = [columns, rows]; and/or random = orbits;
//   states      [[x1, x2, ...], ...]: all coordinates, anywhere
//   crossings   of each orbit, and/or time;              skip = how many first crossings are not drawn
//   tolerance   drift    digits                          as in scene.hpp
//   indicator   "megno" | "lyapunov" | "fli" | "sali": the colour of an orbit (growth.hpp, spectrum.hpp)
//   exponents   "all" or a number k: that many Lyapunov exponents of each orbit, SALI, GALI_2 ... GALI_k (spectrum.hpp)
//   winding     true: the winding number of each orbit on the section (winding.hpp)
//   errors      true | false: are the errors of the points estimated?  Without this key: where there is an indicator
//   scan        {of = "megno", over = {y = [a, b, cells], v = [c, d, cells]}}: no points, but one number of each orbit
//   [[scene.expect]]  as in scene.hpp
//
// The coordinates at a start are what section, levels, start and what is drawn leave: as many equations as
// coordinates, and each of their solutions is an orbit.  With one equation too many the section is not one of them: an
// angle q1 that is seen where sin(q1) = 0 starts at `start = "q1 = 0"`.

#include "flow/field/field.hpp"
#include "flow/scene/own_units.hpp"

namespace kov::flow {

/// A formula of the system and its text.
struct SceneFormula {
  MFraction value;
  std::string text;
};

enum class Indicator : std::uint8_t { none, megno, lyapunov, fli, sali };
[[nodiscard]] std::string to_string(Indicator i);

enum class ScanValue : std::uint8_t { megno, lyapunov, fli, crossings, time };

/// One axis of a scan: `count` cells from `from` to `to`.
struct ScanAxis {
  enum class Kind : std::uint8_t { drawn, coordinate, parameter };
  std::string name;
  Kind kind = Kind::drawn;
  std::size_t place = 0; ///< which of `plot`, which coordinate, or the parameter in the ring
  Quantity from, to;
  std::size_t count = 1;
};

/// One number of each orbit over a line or a plane of starts or parameters (scan.hpp).
struct Scan {
  ScanValue of = ScanValue::megno;
  std::vector<ScanAxis> axes; ///< one or two
};

struct SystemScene {
  std::string file, name, title, source;
  System system;
  std::vector<FunctionMeaning> meanings; ///< of its function symbols: sin(q1), ...
  Values values;                         ///< parameters without a rational value
  std::shared_ptr<const Graph>
      written; ///< how the file writes the field and the functions of the scene
  SceneFormula section;
  bool falling = false, rising = true;
  std::optional<SceneFormula> where;
  struct Level {
    SceneFormula function;
    Quantity value;
  };
  std::vector<Level> levels;
  std::vector<SceneFormula> start; ///< 0 at the start
  std::array<SceneFormula, 2> plot;
  bool return_map = false; ///< the second is the next value of the first
  /// A vector n, where atan2(n1, n2) in [0, 2 pi) and n3/|n| are drawn: `plot` has their names, n1 and n3.
  std::optional<std::array<MFraction, 3>> sphere;
  std::optional<MFraction> sign_of; ///< two colours, by its sign at the start
  std::array<bool, 2> angle{};
  std::optional<std::array<std::array<Quantity, 2>, 2>> range;
  std::vector<std::array<Quantity, 2>> seeds;
  std::vector<std::vector<Quantity>> states;
  int columns = 0, rows = 0;
  long random = 0;
  long crossings = -1, skip = 0;
  std::optional<Quantity> time;
  Quantity tolerance = "10^-15", drift = "10^-9";
  int digits = 0;
  Indicator indicator = Indicator::none;
  long exponents = 0;   ///< how many deviation vectors are followed for them
  bool winding = false; ///< numbers are computed
  bool errors = false;  ///< of the points are estimated
  std::optional<Scan> scan;
  std::vector<SceneExpectation> expect;
  std::shared_ptr<const BodyScene> body; ///< of which this is the scene, in its own units
  std::string varied;                    ///< the parameter of a diagram
  Quantity value;                        ///< its value, of a member of the family
  std::vector<SystemScene> family;       ///< one scene for each value; empty: no diagram

  /// Does the run itself follow a tangent vector?
  [[nodiscard]] bool has_tangent() const noexcept {
    return indicator != Indicator::none && indicator != Indicator::sali;
  }
  /// The functions whose values say what is drawn.
  [[nodiscard]] std::vector<MFraction> drawn() const {
    if (sphere) return {sphere->begin(), sphere->end()};
    return {plot[0].value, plot[1].value};
  }
  /// The functions that must not change along an orbit: H, the integrals and Casimirs of the file
  /// that are proved, relations.
  [[nodiscard]] std::vector<SceneFormula> integrals() const;
};

/// Is this a system file with scenes, a scene that names a system, or that of a body (scene.hpp)?
[[nodiscard]] bool has_system_scenes(const Entry& document);
/// The scenes of such a document.  Errors  InputError with the place
[[nodiscard]] std::vector<SystemScene> read_system_scenes(const Entry& document);

} // namespace kov::flow
