#pragma once
// Runs the steps of a theorem file.

#include "decide/decide.hpp"
#include "theorem/theorem.hpp"

#include <functional>

namespace kov {

struct ProveOptions {
  Options decide;
  bool found = false;      ///< TheoremResult::found
  bool with_bundle = true; ///< all of it as one certificate (bundle.hpp), if it is proved
  /// After each step: the step, and what is known so far (the rest is open).
  std::function<void(const NodeResult&, const TheoremResult&)> progress;
};

/// Files are found beside the theorem file.  Errors of one node make it open, with the reason; so
/// does the deadline of the budget, which is for all steps together.
/// Errors  InputError: a file that cannot be read
[[nodiscard]] TheoremResult prove(const Theorem& t, const ProveOptions& options = {});

/// The status of each node, from those of all that it rests on: is something open there, how much is on trust?
void settle_statuses(TheoremResult& result);

/// The regions of a step: one, or those that it lists.
[[nodiscard]] std::vector<Assumptions> regions_of(const NodeResult& n);

/// The step of this name; null: there is none.
[[nodiscard]] const NodeResult* node_with(const TheoremResult& result, const std::string& id);

/// One step each; `directory` ends in '/' or is empty.
void prove_claims(NodeResult& n, const std::string& directory, const ProveOptions& options);
void prove_case(NodeResult& n, const std::string& directory, const ProveOptions& options);
/// The study of a case whose found ones do not reach all of its region.
void study_again(NodeResult& n, const std::string& directory, const ProveOptions& options);
/// The curves of a trusted node with a file, studied: the bundle may prove what it says (found.special).
/// Errors  InputError; Error: a limit, ...
void study_curves(TheoremNode& node, const std::string& directory, const ProveOptions& options);
void prove_splitting(NodeResult& n, const std::string& directory, const ProveOptions& options);
void prove_lowest_order(NodeResult& n, const std::string& directory);
void prove_theorem(NodeResult& n);
[[nodiscard]] std::string not_integrable(const std::vector<IntegralClass>& excluded);
/// Nothing is computed: what the node says is taken on trust, under the name that it gives, and counted.
void prove_trusted(NodeResult& n);
/// By `prove`; a node whose step `classify` has found is on trust where this does not prove it.
void prove_or_trust(NodeResult& n, const ProveOptions& options,
                    const std::function<void(NodeResult&)>& prove);

/// The step's system is the theorem's, or one that a step `of` leads to: its region, or unbound.
void settle_place(NodeResult& n, const TheoremResult& result, const std::string& directory);
/// The regions of the needs cover that of the node, up to the symmetries of the system: by a tree of conditions.
void prove_cover(NodeResult& n, const TheoremResult& result, const std::string& directory,
                 const std::stop_token& stop = {});

/// Errors  InputError without a place, which `prove` adds: `name` is not one of `known`
void require_known(const std::string& name, const std::vector<std::string>& known,
                   const std::string& what);

/// The parameters without a value.
[[nodiscard]] std::vector<std::string> free_parameters(const System& s);

/// The path of a file named in the theorem file.
[[nodiscard]] std::string beside(const std::string& directory, const std::string& file);

/// "A = 1, B = 2": the values of parameters, in the file and in `where`.
[[nodiscard]] std::string values_of(const System& s);
/// The same as a formula of the step.
void show_setting(NodeResult& n, const System& s);

} // namespace kov
