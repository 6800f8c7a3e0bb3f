#pragma once
// The sub-commands that read system files: check, show, find-manifolds.
//
// Each returns an exit code: 0 decided, 2 bad input, 3 something undecided, 1 a claim of the file
// refuted.  InputError and InternalError pass to the caller, which prints them.

#include "integrability/check.hpp"

#include <iosfwd>

namespace kov::cli {

struct MechanicsArguments {
  std::string file;
  kov::Settings set;                ///< --set name=value
  std::string format = "text"; ///< text | json
  std::string stage = "r";     ///< show: system | lowest | ve | nve | ode | r
  std::string manifold;        ///< only this one
  bool exit_verdict = false;   ///< 10 non-integrable, 20 no obstruction, 0 undecided
  Options decide;
};

[[nodiscard]] int run_check(const MechanicsArguments& a, std::ostream& out);
[[nodiscard]] int run_show(const MechanicsArguments& a, std::ostream& out);
[[nodiscard]] int run_find_manifolds(const MechanicsArguments& a, std::ostream& out);

} // namespace kov::cli
