#pragma once
// An answer on its way to the user: format, certificate file, exit code.

#include "equations/answer.hpp"

namespace kov::cli {

/// Prints the answer (or the error) in the format asked for and returns the exit code.
int present(const Settings& settings, Answer answer, const std::string& title);
/// The answer as text in the format of the settings; "" after an error, which is reported.
[[nodiscard]] std::string presented(const Settings& settings, const Answer& answer,
                                    const std::string& title);
/// Says on standard error what kept an answer from coming, if anything did.
void report_failure(const Settings& settings, const Answer& answer);

} // namespace kov::cli
