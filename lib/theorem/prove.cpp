#include "theorem/prove.hpp"

#include "exact/error.hpp"

#include <chrono>

namespace kov {
namespace {

void run(NodeResult& n, const std::string& directory, const ProveOptions& options) {
  switch (n.node.kind) {
  case NodeKind::claims:
    return prove_claims(n, directory);
  case NodeKind::case_file:
    return prove_case(n, directory, options);
  case NodeKind::splitting:
    return prove_splitting(n, directory, options);
  case NodeKind::scaling:
    return prove_scaling(n, directory);
  case NodeKind::lowest_order:
    return prove_lowest_order(n, directory);
  case NodeKind::theorem:
    n.status = NodeStatus::trusted;
    return;
  case NodeKind::argument:
    n.status = NodeStatus::reasoned;
    return;
  }
}

// A limit of one step is not an error of the file.
void run_step(NodeResult& n, const std::string& file, const std::string& directory,
              const ProveOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  try {
    run(n, directory, options);
  } catch (const InputError& why) { // the file is wrong
    if (!why.file().starts_with("--set")) throw;
    throw InputError(file, n.node.line, 0, 1,
                     "node '" + n.node.id + "', " + why.file().substr(6) + ": " + why.message(),
                     why.hint());
  } catch (const InternalError&) {
    throw; // the program is
  } catch (const Error& why) {
    n.status = NodeStatus::open;
    n.summary = why.what();
  }
  n.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// A hypothesis is checked by a node that is proved, or rests on one that is trusted or reasoned and
// named.
void settle_hypotheses(TheoremResult& result) {
  std::map<std::string, NodeStatus> status;
  for (const NodeResult& n : result.nodes)
    status[n.node.id] = n.status;
  for (NodeResult& n : result.nodes)
    for (Hypothesis& h : n.node.hypotheses)
      h.checked = !h.by.empty() && status.at(h.by) == NodeStatus::proved;
}

// Openness travels up the tree; the file has no circles.
bool is_open_below(TheoremResult& result, const std::string& id) {
  bool open = false;
  for (NodeResult& n : result.nodes) {
    if (n.node.id != id) continue;
    for (const std::string& child : n.node.needs)
      n.rests_on_open = is_open_below(result, child) || n.rests_on_open;
    open = n.rests_on_open || n.status == NodeStatus::open || n.status == NodeStatus::refuted;
  }
  return open;
}

} // namespace

TheoremResult prove(const Theorem& t, const ProveOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const auto slash = t.file.rfind('/');
  const std::string directory = slash == std::string::npos ? "" : t.file.substr(0, slash + 1);
  TheoremResult result{t, {}, 0};
  for (const TheoremNode& node : t.nodes) {
    NodeResult n;
    n.node = node;
    run_step(n, t.file, directory, options);
    if (options.progress) options.progress(n);
    result.nodes.push_back(std::move(n));
  }
  settle_hypotheses(result);
  for (const TheoremNode& node : t.nodes)
    (void)is_open_below(result, node.id);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

} // namespace kov
