#pragma once
// A family with parameters as a user asks for it, and its strata against the solver without
// parameters at random points.

#include "equation/parametric_equation.hpp"
#include "parameter_points.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace kov::test {

using Texts = std::vector<std::string>;

struct Asked {
  std::string equation; ///< "-r" or "-e"
  std::string text;
  Texts parameters;
  Texts assumptions = {};

  [[nodiscard]] std::string command() const;
  [[nodiscard]] ParametricEquation family() const;
};

[[nodiscard]] strata::StrataLimits little_time();

inline int compared = 0; ///< points with an answer on both sides
void report();           ///< how many

/// The stratum of the point; every point with an equation has one.
[[nodiscard]] const strata::Stratum* stratum_of(const strata::StrataAnswer& a,
                                                const ParameterPoint& point);
void compare_at(const Asked& asked, const ParametricEquation& f, const strata::StrataAnswer& a,
                const ParameterPoint& point);
/// Compares at points: random ones, and zeros of what the strata are made of and of `also`.
/// equations: how many of these a point meets at most.
void attack(const Asked& asked, const Texts& also, int points, Random& random, int equations = 1);

/// The form with these pieces for its letters, in parentheses.
[[nodiscard]] std::string replaced(const std::string& form,
                                   const std::map<char, std::string>& pieces);

/// Riemann's equation with these squares of exponent differences at 0, 1 and infinity.
inline const std::string riemann = "(P-1)/(4*z^2)+(Q-1)/(4*(z-1)^2)+(1-P-Q+R)/(4*z*(z-1))";

} // namespace kov::test
