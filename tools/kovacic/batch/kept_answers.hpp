#pragma once
// --resume: the answers that an earlier run of the same batch left behind.

#include "equations/result.hpp"
#include "process/settings.hpp"

#include <deque>
#include <set>
#include <string>

namespace kov::cli {

/// The whole lines of a file of answers, as far as they are needed to go on behind them.
struct KeptAnswers {
  std::deque<Json> ids;               ///< of the answers, in order
  std::set<std::string> certificates; ///< the names of their files
  int exit = exit_decided;            ///< of these answers together
  std::uintmax_t bytes = 0;           ///< of the whole lines; what follows was cut short
};

/// A file that is not there has no answers.  Throws InputError for a line that is not an answer.
[[nodiscard]] KeptAnswers kept_answers(const std::string& path);

} // namespace kov::cli
