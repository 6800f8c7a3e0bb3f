#pragma once
// A scene: which body, on which level, seen in which section, with which orbits.  One TOML file.
//
//   format = "scene/1"
//   title  = "..."                      source = "..."
//   [body]      inertia = [A, B, C] or three rows;  lever = [L1, L2, L3];  mass;  gravity;
//               tip = "sliding" | "fixed";  gyrostat = [B1, B2, B3]
//   [levels]    H;  F1 (default 1);  F2
//   [section]   angle = "pi/2" | "3*pi/2";  direction = "upward" | "downward" | "both";
//               axis = 1 | 2 | 3
//   [orbits]    seeds = [[l, L/G], ...] and/or grid = [columns, rows];  crossings and/or time
//   [accuracy]  tolerance;  drift (the picture is refused beyond it);  digits (for high precision)
//   [plot]      sign_of = [c1, c2, c3]: two colours, by the sign of c.M at the start
//   [[expect]]  what a run must give: points (their number), drift (an upper bound), elliptic,
//               hyperbolic, inverse_hyperbolic (how many fixed points the section map has),
//               proved = true (all of these are proved), never_crossed = true, singular (how
//               many orbits end so);  source
//
// Numbers are integers or texts such as "8/9", "sqrt(11)/24", "3*pi/2", "10^-14" (quantity.hpp).
// Units: mass, length and time are the scene's own; l in radian; L/G, F1, tolerance dimensionless.

#include "flow/number/quantity.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace kov {
class Entry;
}

namespace kov::flow {

/// The section g = pi/2 or 3pi/2: S = 0, where S = F2 N_3 - (N.N) Gamma_3 = |N|^2 sqrt(..) cos g, on the side where
/// C = N_2 Gamma_1 - N_1 Gamma_2 has this sign; at g = pi/2 S falls where g grows, at 3pi/2 it rises.
struct SectionRule {
  bool falling = true, rising = false;
  int side = 1; ///< sign of C
  int axis = 2; ///< chart axis: L is the component of the momentum along this body axis (0, 1, 2)
};

struct Seed {
  Quantity l, y;
};

/// The expectations of a scene's author.
struct SceneExpectation {
  std::string source;
  std::optional<long> points, singular;
  std::optional<Quantity> drift;
  std::optional<long> elliptic, hyperbolic, inverse_hyperbolic;
  bool proved = false, never_crossed = false;
  [[nodiscard]] bool of_fixed_points() const {
    return elliptic || hyperbolic || inverse_hyperbolic || proved;
  }
};

[[nodiscard]] SceneExpectation read_expectation(const Entry& e);
/// The keys of these names, where they are written.  Errors  InputError: beyond their bounds
void read_direction(const Entry& e, bool& upward, bool& downward);
void read_tolerance(const Entry& e, Quantity& tolerance, Quantity& drift, int& digits);
/// grid, crossings and time.
void read_limits(const Entry& e, int& columns, int& rows, long& crossings,
                 std::optional<Quantity>& time);

struct Scene {
  std::string file, title, source;
  std::array<std::array<Quantity, 3>, 3> inertia;
  std::array<Quantity, 3> lever, gyrostat;
  Quantity mass = "1", gravity = "0";
  bool sliding = true;
  Quantity energy, length = "1", casimir;
  SectionRule section;
  std::vector<Seed> seeds;
  int columns = 0, rows = 0; ///< grid over l (columns) and L/G (rows); 0: none
  long crossings = -1;       ///< of each orbit; -1: no limit
  std::optional<Quantity> time;
  Quantity tolerance = "10^-16"; ///< relative; see safety_bits in section_stage.hpp
  Quantity drift = "10^-9";      ///< largest relative drift of an integral that may be drawn
  int digits = 0;                ///< 0: double; otherwise decimal digits
  std::optional<std::array<Quantity, 3>> sign_of;
  std::vector<SceneExpectation> expect;
};

/// Reads and checks a scene.
///
/// Errors  InputError with file, line and column: not TOML, an unknown key, a text that is not a
///         number, an inertia that is not symmetric and positive or violates a triangle inequality,
///         F1 <= 0, no orbits, no end
[[nodiscard]] Scene read_scene(const Entry& document);
[[nodiscard]] Scene read_scene(const std::string& path);
[[nodiscard]] Scene parse_scene(std::string text, const std::string& name);

} // namespace kov::flow
