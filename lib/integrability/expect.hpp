#pragma once
// The claims and [[expect]] blocks of a system file as tests.

#include "integrability/check.hpp"

namespace kov {

struct ExpectationResult {
  std::string file;
  long line = 0;
  std::string name; ///< source, or what is claimed
  bool passed = false;
  std::string message; ///< what was found instead
  double seconds = 0;
};

/// Each claim must be proved (or refuted, where the file says holds = false); each [[expect]] is
/// run with its own parameter values.   Errors  InputError
[[nodiscard]] std::vector<ExpectationResult> test_system_file(const std::string& path,
                                                              const CheckOptions& options = {});

} // namespace kov
