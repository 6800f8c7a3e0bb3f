// kovacic verify CERT: the independent checker is a program of its own.

#include "commands.hpp"

namespace kov::cli {

int verify(const Settings& settings, const std::vector<std::string>&) {
  complain(settings, "the certificate checker is not connected yet");
  return exit_undecided;
}

} // namespace kov::cli
