#include "theorem/prove.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "proof/text/refused.hpp"
#include "symbol/given_text.hpp"
#include "theorem/bundle.hpp"
#include "theorem/setting.hpp"

#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

namespace kov {
namespace {

void run(NodeResult& n, const std::string& directory, const ProveOptions& options) {
  switch (n.node.kind) {
  case NodeKind::claims:
    return prove_claims(n, directory, options);
  case NodeKind::case_file:
    return prove_case(n, directory, options);
  case NodeKind::splitting:
    return prove_splitting(n, directory, options);
  case NodeKind::lowest_order:
    return prove_lowest_order(n, directory);
  case NodeKind::theorem:
    return n.node.theorem == nullptr ? void(n.status = NodeStatus::reasoned) : prove_theorem(n);
  case NodeKind::cover: // when its needs are known
    return;
  case NodeKind::argument:
    n.status = NodeStatus::reasoned;
    return;
  case NodeKind::trusted:
    if (!n.node.file.empty() && n.node.found.special.empty())
      tried<Error>([&] { study_curves(n.node, directory, options); });
    return prove_trusted(n);
  case NodeKind::open_part:
    n.status = NodeStatus::open;
    n.summary = "nothing is said of these parameters";
    return;
  }
}

// A limit of one step is not an error of the file.
void run_step(NodeResult& n, const TheoremResult& result, const std::string& directory,
              const ProveOptions& options) {
  const std::string& file = result.theorem.file;
  const auto start = std::chrono::steady_clock::now();
  try {
    options.decide.budget.check();
    n.summary.clear();
    run(n, directory, options);
    settle_place(n, result, directory);
  } catch (const InputError& why) {               // the file is wrong
    const bool of_values = why.file() == "--set"; // in where, sample or units
    const std::string node = "node '" + n.node.id + "'";
    if (!of_values && !why.file().empty())
      throw InputError(why.file(), why.line(), why.column(), why.length(), why.message(),
                       why.hint() + (why.hint().empty() ? "" : "; ") + "read for " + node + " of " +
                           file,
                       why.source_line());
    throw InputError(
        file, n.node.line, 0, 1,
        node +
            (of_values ? ", value of " + why.source_line().substr(0, why.source_line().find('='))
                       : "") +
            ": " + why.message(),
        why.hint());
  } catch (const InternalError&) {
    throw; // the program is
  } catch (const Error& why) {
    n.status = NodeStatus::open;
    n.says = Conclusion::none;
    n.summary = why.what();
  }
  n.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void settle_hypotheses(TheoremResult& result) {
  for (NodeResult& n : result.nodes)
    for (Hypothesis& h : n.node.hypotheses)
      h.checked = !h.by.empty() && node_with(result, h.by)->status == NodeStatus::proved;
}

// Covers after their needs; the file has no circles.
void settle_covers(TheoremResult& result, const std::string& directory,
                   const std::stop_token& stop) {
  std::set<std::string> done;
  const auto leave_open = [](NodeResult& n, const Error& why) {
    n.status = NodeStatus::open;
    n.summary = why.what();
  };
  const std::function<void(NodeResult&)> settle = [&](NodeResult& n) {
    if (!done.insert(n.node.id).second) return;
    for (NodeResult& need : result.nodes)
      if (is_among(need.node.id, n.node.needs)) settle(need);
    if (n.node.kind != NodeKind::cover) return;
    n.summary.clear();
    try {
      prove_cover(n, result, directory, stop);
    } catch (const DomainError& why) {
      leave_open(n, why);
    } catch (const OutOfBudget& why) {
      leave_open(n, why);
    }
    settle_statuses(result);
  };
  for (NodeResult& n : result.nodes)
    settle(n);
}

// The steps that the certificate has on trust, and the class that it excludes, are those of the theorem.
void take_from_bundle(TheoremResult& result, const TheoremBundle& b) {
  for (NodeResult& n : result.nodes) {
    n.trusted.clear();
    for (const auto& [id, step] : b.on_trust)
      if (id == n.node.id) n.trusted.push_back(step);
  }
  NodeResult& root = result.nodes.front();
  const std::vector<IntegralClass> excluded = at_once(b.excluded);
  const bool excludes_as_much = std::ranges::all_of(excluded, [&](const IntegralClass& there) {
    return std::ranges::any_of(
        root.excluded, [&](const IntegralClass& c) { return contains(there, c) == Truth::yes; });
  });
  if (excludes_as_much) return;
  const std::string said = first_integrals(root.excluded);
  root.excluded = excluded;
  if (const auto at = root.statement.find(said); at != std::string::npos)
    root.statement.replace(at, said.size(), first_integrals(root.excluded));
}

// All of it as one certificate: then no decision of Z3 is needed for what it carries.  Where there is none,
// no judge has seen that the steps together give the statement.
void certify_whole(TheoremResult& result, const std::string& directory,
                   const ProveOptions& options) {
  if (!result.complete_but_for_open_parts()) return;
  TheoremBundle b;
  try {
    b = theorem_bundle(result, directory, options);
  } catch (const InputError&) {
    throw;
  } catch (const InternalError&) {
    throw;
  } catch (const Error& why) {
    b.none = why.what();
  } catch (const certify::Refused& why) {
    b.none = why.why; // of the system itself: Jacobi's identity by a relation, say
  }
  result.bundle = b.json;
  result.no_bundle = b.none;
  result.bundle_open = b.open;
  if (result.bundle.empty()) {
    NodeResult& root = result.nodes.front();
    if (root.node.kind == NodeKind::cover)
      root.trusted.push_back({Trusted::Step::composition, b.none});
    return settle_statuses(result);
  }
  if (is_of_strata(result.theorem)) take_from_bundle(result, b);
  for (NodeResult& n : result.nodes) {
    for (const LiteratureTheorem* t : b.by_points[n.node.id])
      n.theorems.push_back(used(*t));
    if (!is_among(n.node.id, b.carried)) continue;
    std::erase_if(n.trusted, [](const Trusted& x) { return x.by_z3(); });
    if (!std::exchange(n.on_trust, false)) continue;
    n.status = NodeStatus::proved;
    if (!result.found) n.statement = not_integrable(n.excluded = result.nodes.front().excluded);
  }
  settle_statuses(result);
}

} // namespace

TheoremResult prove(const Theorem& t, const ProveOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const std::string directory = folder_of(t.file);
  TheoremResult result{t, {}, 0};
  result.found = options.found;
  for (const TheoremNode& node : t.nodes) {
    result.nodes.emplace_back();
    result.nodes.back().node = node;
    result.nodes.back().summary = "not reached";
  }
  for (NodeResult& n : result.nodes) {
    run_step(n, result, directory, options);
    if (!options.progress) continue;
    TheoremResult so_far = result;
    settle_statuses(so_far);
    options.progress(n, so_far);
  }
  result.files = input_files(t);
  settle_covers(result, directory, options.decide.budget.stop);
  settle_statuses(result);
  settle_hypotheses(result);
  if (options.with_bundle) certify_whole(result, directory, options);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

} // namespace kov
