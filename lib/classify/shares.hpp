#pragma once
// The parts of the work that is left, of all that is no stage (stage.hpp): `kovacic classify --plan` shows
// them.

namespace kov::share {

inline constexpr double stated = 0.3;      ///< the manifolds of the file
inline constexpr double change = 0.05;     ///< of variables
inline constexpr double symmetries = 0.02; ///< of the family
inline constexpr double follower = 0.1;    ///< what is known carried over to one that follows
inline constexpr double here_first = 0.15; ///< in the user's variables, where others are simpler
inline constexpr double there = 0.6;
inline constexpr double round = 0.5;               ///< special values need the rest
inline constexpr double without_constants = 0.25;  ///< before algebraic constants are used
inline constexpr double before_a_last_look = 0.97; ///< for integrals of all that is open
inline constexpr double all_but_points = 0.8;      ///< matrices at a point of the parameters

} // namespace kov::share
