#include "process/subprocess.hpp"

#include <array>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ; // NOLINT(readability-redundant-declaration)

namespace kov::cli {
namespace {

// The process, or unset.  `out`: a file descriptor for its standard output, or -1.
std::optional<pid_t> start(std::vector<std::string> words, const std::string& directory, int out) {
  std::vector<char*> argv;
  for (std::string& w : words)
    argv.push_back(w.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", 1 /* O_WRONLY */, 0);
  if (out >= 0) posix_spawn_file_actions_adddup2(&actions, out, 1);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return failed == 0 ? std::optional(child) : std::nullopt;
}

int exit_code_of(pid_t child) {
  int status = 0;
  if (waitpid(child, &status, 0) != child) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace

int run_program(const std::vector<std::string>& words, const std::string& directory) {
  const auto child = start(words, directory, -1);
  return child ? exit_code_of(*child) : -1;
}

std::optional<std::string> output_of(const std::vector<std::string>& words) {
  int ends[2];
  if (pipe(ends) != 0) return std::nullopt;
  const auto child = start(words, ".", ends[1]);
  close(ends[1]);
  std::string text;
  std::array<char, 4096> buffer{};
  for (ssize_t n = 0; child && (n = read(ends[0], buffer.data(), buffer.size())) > 0;)
    text.append(buffer.data(), static_cast<std::size_t>(n));
  close(ends[0]);
  if (!child || exit_code_of(*child) != 0) return std::nullopt;
  return text;
}

} // namespace kov::cli
