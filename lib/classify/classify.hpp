#pragma once
// For which parameters is a system integrable?  One theorem for a whole file:
//
//   particular solutions (those of the file and those found) -> parameters that each excludes
//          -> first integrals on what is left -> the same again where equations hold -> the theorem
//
// Source  docs/theory/classify.md

#include "integrability/report.hpp"
#include "study/classification.hpp"

#include <functional>

namespace kov {

struct ClassifyOptions {
  CheckOptions check;           ///< its deadline is that of the whole
  long degree = 4;              ///< of the first integrals that are looked for
  long degree_at_points = 6;    ///< the same at single points of the parameters, at last
  int order = 5;                ///< of the variational equations (docs/theory/jets.md), 1 to 7
  bool search_solutions = true; ///< also manifolds that the file does not name
  /// Square roots and eigenvalues that are not functions of the parameters, where open strata are
  /// left without them.
  bool adjoin_constants = true;
  /// If much is open, the same question in other canonical variables (lib/canonical).
  bool change_variables = true;
  bool leading_parts = true; ///< studied by themselves, by all of this
  /// Stages to skip, named as in `at_work`: those in which an earlier run of this file was stopped.
  std::vector<std::string> skip = {};
  /// Called before each stage with what is proved so far; the rest is open there.
  std::function<void(const SystemClassification&)> so_far = {};
};

/// Every limit ends in open strata.
/// Errors  InvalidArgument: contradictory assumptions, no such manifold
/// Given   const System cubic = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['x', 'y'], momenta = ['u', 'v'], parameters = ['a'], "
///             "hamiltonian = '(u^2 + v^2)/2 + a*x^2*y + y^3/3'}", "cubic.toml"));
/// Example to_string(classify_system(cubic).strata.front().status)  // -> integrable
[[nodiscard]] SystemClassification classify_system(const System& s,
                                                   const ClassifyOptions& options = {});

} // namespace kov
