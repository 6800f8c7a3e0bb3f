#pragma once
// The commands: a row each.

#include "flags.hpp"

#include <span>

namespace kov::cli {

struct Command {
  const char* name;
  const char* summary; ///< its line of the help
  void (*declare)(CLI::App&, Flags&, Asked&);
  int (*run)(const CLI::App&, Asked&);
};

/// In the order of the help.
[[nodiscard]] std::span<const Command> command_table();

} // namespace kov::cli
