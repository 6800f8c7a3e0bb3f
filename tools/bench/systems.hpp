#pragma once
// What kovacic-systems measures, and the integrators of others: they are compiled for this machine with contraction
// (systems_theirs.cpp), which our pairs of doubles must not be.

#include <functional>
#include <string>
#include <vector>

namespace kov::bench {

inline constexpr std::size_t compared = 10; ///< points of an orbit

/// A run of all orbits.
struct Ran {
  double drift = 0;          ///< of the energy, relative, at most
  std::vector<long> returns; ///< of each orbit
  std::vector<std::vector<std::vector<double>>>
      points; ///< the first of each orbit: all coordinates
};

/// A system as a person writes it, for Boost.odeint.
struct Theirs {
  /// method: "rkf78", "dopri5", "bulirsch-stoer";  tolerance: absolute and relative
  std::function<Ran(const std::string& method, double tolerance,
                    const std::vector<std::vector<double>>& starts, double time)>
      run;
};

/// By the name of the file without its ending; compiled in two ways (CMakeLists.txt).
[[nodiscard]] Theirs theirs_plain(const std::string& system);
[[nodiscard]] Theirs theirs_inlined(const std::string& system);

} // namespace kov::bench
