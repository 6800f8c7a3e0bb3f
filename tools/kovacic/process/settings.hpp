#pragma once
// The flags that several commands share.

#include "decide/decide.hpp"
#include "exact/truth.hpp"
#include "output/render.hpp"
#include "process/supervisor.hpp"
#include "symbol/document.hpp"

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace kov::cli {

/// Exit codes: what happened, not what the verdict is.
enum Exit : int {
  exit_decided = 0,
  exit_no = 1,    ///< a "no" from check, test, prove or verify
  exit_input = 2, ///< usage error or bad input file
  exit_undecided = 3,
  exit_internal = 4,
  exit_not_abelian = 10, ///< with --exit-verdict only
  exit_abelian = 20,     ///< with --exit-verdict only
  exit_interrupted = 130,
  exit_terminated = 143 ///< interrupted by SIGTERM
};

struct Settings {
  std::vector<std::string> set;    ///< "a=1/2"
  std::vector<std::string> assume; ///< sentences about parameters
  std::string energy;              ///< section: of a system without a scene
  double timeout = 0;
  long max_degree = Budget{}.max_degree;
  long max_families = Budget{}.max_families;
  double max_work = Budget{}.max_work;
  std::size_t memory = 4 * 1024; ///< MiB
  std::size_t max_print = 4;     ///< MiB of solutions; 0 = no limit
  std::string manifold;          ///< system files: only this one
  int only_case = 0;
  int order = 0; ///< check, classify: of the variational equations; 0 = as the command has it
  std::string method = "automatic";
  std::string format = "text";
  std::string output;      ///< -o; empty = standard output
  std::string certificate; ///< --certificate
  std::string color = "auto";
  bool trace = false;
  bool quiet = false;
  int verbose = 0;
  bool one_page = false; ///< a text is cut to a page, unless it is verbose
  bool exit_verdict = false;
  long jobs = 0; ///< --batch: so many lines at the same time; 0 = as many as there are cores
  bool in_a_batch = false;          ///< one line of many
  bool second_opinion = false;      ///< also ask the monodromy matrices
  bool polynomial_of_y = false;     ///< solve: for A4, S4, A5
  bool special_functions = false;   ///< solve: also for the lines of a batch
  bool complex = false;             ///< solve: exp(I x) instead of cos(x), sin(x)
  bool strict = false;              ///< verify: refuse trusted steps
  bool needs = false;               ///< verify: what must be believed
  bool explain = false;             ///< verify: the steps
  std::optional<std::string> given; ///< a file's text from -H or -L; its name is that flag
  std::string no_manifolds;         ///< check: what a search for manifolds came to that found none

  /// The file of this name, or the text that was given instead, with what is assumed besides.
  [[nodiscard]] Entry document(const std::string& file) const;

  [[nodiscard]] Options solver_options() const;
  /// Of a search that ends when this part of the time is over; its message says what was given.
  [[nodiscard]] Budget search_budget(double part_of_the_time) const;
  [[nodiscard]] bool wants_solutions() const { return !exit_verdict; }
  [[nodiscard]] ProcessLimits process_limits() const { return {timeout, memory}; }
  /// Colours on this stream (a file descriptor)?  --color, NO_COLOR, is it a terminal.
  [[nodiscard]] bool colors(int descriptor) const;
  [[nodiscard]] Style style() const;
  /// The exit code before anything is answered, for worse() to start from.
  [[nodiscard]] Exit nothing_yet() const { return exit_verdict ? exit_abelian : exit_decided; }
  /// The exit code of a question about an identity component, --exit-verdict taken into account.
  [[nodiscard]] int exit_of(Truth abelian, bool decided) const;
  /// --set as name and formula.  Throws InputError.
  [[nodiscard]] std::vector<std::pair<std::string, Expression>> settings() const;
};

/// The formula (or the equation) after an option; nothing if it is not given.  Throws InputError.
[[nodiscard]] std::optional<Expression>
formula(const std::string& option, const std::optional<std::string>& text, bool equation = false);
/// Writes to -o or to standard output.  Throws InputError if the file cannot be written.
void write_output(const Settings& settings, const std::string& text);
/// Writes the file at once or not at all.
void write_file(const std::string& path, const std::string& text);
/// Never throws.
[[nodiscard]] bool is_directory(const std::string& path);
/// With its parents, if it is not there.  Throws InputError.
void make_directory(const std::string& path);
/// Throws InputError unless everything that was put into it is in the file.
void close_file(std::ofstream& out, const std::string& path);
/// An input error with its caret, on standard error; returns exit_input.
int report(const Settings& settings, const InputError& error);
/// One line on standard error: "kovacic: error: ...".
void complain(const Settings& settings, const std::string& message, const std::string& hint = {});

} // namespace kov::cli
