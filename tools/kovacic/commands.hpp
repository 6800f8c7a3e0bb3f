#pragma once
// The sub-commands.  Each returns an exit code and writes its answer by itself.

#include "process/settings.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kov::cli {

struct SolveArguments {
  std::string file; ///< an equation file; "-" = standard input
  std::optional<std::string> r, ode, p, q;
  std::string variable, unknown;
  std::optional<std::string> minpoly;
  std::vector<std::string> parameters; ///< free names
  std::string batch;                   ///< a file of JSON lines; "-" = standard input
  bool resume = false;                 ///< --batch: go on behind the answers that are in -o
  bool no_times = false;               ///< --batch: the same bytes in every run
};

struct LameArguments {
  std::string file; ///< with a [lame] table
  std::optional<std::string> n, alpha, b, g2, g3;
};

struct PotentialArguments {
  long degree = 0;
  std::optional<std::string> eigenvalue;
};

struct MonodromyArguments {
  std::optional<std::string> r, ode, p, q;
  std::string variable, unknown;
  std::optional<std::string> minpoly;
  std::string system;              ///< a system file instead of one equation
  std::string stage = "ve";        ///< which of its linear systems
  std::optional<std::string> base; ///< x + y*I
  std::optional<std::string> time; ///< F: y'' is by t, (dz/dt)^2 = F(z)
  long digits = 30;
};

struct SpectrumArguments {
  std::optional<std::string> r, ode;
  std::string variable, unknown;
  std::string energy = "E"; ///< the parameter that is asked for
  long levels = 4;          ///< how many integers N are written out
};

struct IntegralsArguments {
  std::string file;
  std::optional<long> degree; ///< unset: 2, and 4 where that is quick
  std::optional<long> coefficients;
};

struct ClassifyArguments {
  std::string file;
  long degree = 0;        ///< of the first integrals; 0: as ClassifyOptions has it
  bool only_file = false; ///< no solutions but those of the file
  bool plan = false;      ///< only what would be tried
  std::string as_theorem; ///< the theorem file that is written; or empty
};

int solve(const Settings& settings, const SolveArguments& arguments);
/// Monodromy matrices with proven radii.
int monodromy(const Settings& settings, const MonodromyArguments& arguments);
/// Lame's equation: the classical criterion, or the condition on what is left free.
int lame(const Settings& settings, const LameArguments& arguments);
/// The values of a parameter with a Liouvillian solution.
int spectrum(const Settings& settings, const SpectrumArguments& arguments);
/// The eigenvalues that an integrable homogeneous potential may have.
int potential(const Settings& settings, const PotentialArguments& arguments);
struct BatchArguments {
  std::string path; ///< of the questions; "-" = standard input
  bool resume = false;
  bool no_times = false;
};
int batch(const Settings& settings, const BatchArguments& arguments);
int check(const Settings& settings, const std::vector<std::string>& files);
int test(const Settings& settings, const std::vector<std::string>& paths);
/// Stages of the way from a system to r(z).
int show(const Settings& settings, const std::string& file, const std::string& stage);
int find_manifolds(const Settings& settings, const std::string& file);
/// For `check` of a system without manifolds.
struct ProposedManifolds {
  std::string
      blocks;       ///< [[manifold]] for the sets found whose phase curves levels cut out; "": none
  std::string note; ///< what is studied, or why nothing is, with what was left out
};
[[nodiscard]] ProposedManifolds propose_manifolds(const Settings& settings,
                                                  const std::string& file);
/// First integrals, at all parameter values.
int integrals(const Settings& settings, const IntegralsArguments& arguments);
/// For which parameters is a system integrable?
int classify(const Settings& settings, const ClassifyArguments& arguments);
int explain(const Settings& settings, const std::string& code);
/// A formula instead of a system file.
struct OneLineArguments {
  std::string hamiltonian, lagrangian;
  std::vector<std::string> coordinates, rates, parameters; ///< empty: guessed, and told

  [[nodiscard]] bool given() const { return !hamiltonian.empty() || !lagrangian.empty(); }
};
/// The system file of a formula, into settings.given; what was guessed is told on standard error.  Returns the
/// name that messages call it.
[[nodiscard]] std::string take_one_line(Settings& settings, const OneLineArguments& arguments);

/// The text of a system file with a scene to begin with, by --energy and --set.
[[nodiscard]] std::string with_scene(const Settings& settings, const std::string& system);

int make_new(const Settings& settings, const std::string& kind);
int verify(const Settings& settings, const std::vector<std::string>& arguments);
/// A theorem file: the status of every step, and a report as text, JSON, LaTeX or HTML.
int prove(const Settings& settings, const std::string& file);
/// The same for one system file.
int report_system(const Settings& settings, const std::string& file);
int version();
/// "kovacic 0.1.0", and what it computes with.
std::string program_version();
std::string libraries();

/// Of two exit codes the one that a script should hear of.
[[nodiscard]] int worse(int a, int b);

} // namespace kov::cli
