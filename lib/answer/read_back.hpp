#pragma once
// A solution is read back from its printed text before it is shown: GiNaC differentiates it and puts it into the given
// equation, and the value at random points is computed with balls of 40 digits.

#include "exact/multivariate.hpp"
#include "symbol/expression.hpp"

#include <map>
#include <string>
#include <vector>

namespace kov::answer {

enum class ReadBack : std::uint8_t {
  solves,   ///< the value is below 10^-25 of the largest term at each point
  differs,  ///< above: the text is not a solution
  too_long, ///< not looked at: above 20 000 characters, or the work that this allows
  unknown   ///< a function, a constant or a point that has no value here
};

struct ReadBackEquation {
  Expression ode; ///< left = right, in the unknown, its variable and parameters
  std::string unknown, variable;
  std::map<std::string, Expression> values; ///< of parameters, in others: what is so on a stratum
  std::map<std::string, std::string> constants; ///< I, alpha: root(p, approx)
};

/// text: as for_programs writes it.
/// Given   const ReadBackEquation airy{parse_expression("y'' = x*y", "-e", true), "y", "x", {}, {}};
/// Example read_back("airyai(x)", airy) == ReadBack::solves   // -> yes
/// Example read_back("airyai(2*x)", airy) == ReadBack::differs  // -> yes
[[nodiscard]] ReadBack read_back(const std::string& text, const ReadBackEquation& equation);

} // namespace kov::answer
