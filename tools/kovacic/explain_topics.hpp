#pragma once
// What `kovacic explain` knows: the words of answers and errors.

#include <span>

namespace kov::cli {

struct Topic {
  const char* names; ///< "NAME|ALSO|...": as answers write it
  const char* text;  ///< one paragraph
};

[[nodiscard]] std::span<const Topic> explain_topics();

} // namespace kov::cli
