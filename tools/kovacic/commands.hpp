#pragma once
// The sub-commands.  Each returns an exit code and writes its answer by itself.

#include "settings.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kov::cli {

struct SolveArguments {
  std::string file; ///< an equation file; "-" = standard input
  std::optional<std::string> r, ode, p, q;
  std::string variable;
  std::optional<std::string> minpoly;
  std::string batch; ///< a file of JSON lines; "-" = standard input
};

int solve(const Settings& settings, const SolveArguments& arguments);
int batch(const Settings& settings, const std::string& path);
int check(const Settings& settings, const std::vector<std::string>& files);
int test(const Settings& settings, const std::vector<std::string>& paths);
/// Stages of the way from a system to r(z).
int show(const Settings& settings, const std::string& file, const std::string& stage);
int find_manifolds(const Settings& settings, const std::string& file);
int explain(const Settings& settings, const std::string& code);
int make_new(const Settings& settings, const std::string& kind);
int verify(const Settings& settings, const std::vector<std::string>& arguments);
int version();

/// Of two exit codes the one that a script should hear of.
[[nodiscard]] int worse(int a, int b);

} // namespace kov::cli
