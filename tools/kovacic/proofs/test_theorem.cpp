#include "systems/case_file.hpp"
#include "systems/mechanics.hpp"
#include "theorem/prove.hpp"

namespace kov::cli {
namespace {

// A theorem file: each step that computes is an expectation that it is proved, and the whole that
// the proof is complete; unless the file expects it to be open.
Json theorem_expectations(const TheoremResult& result) {
  const bool open = result.theorem.expected_open;
  Json all = Json::array();
  for (const NodeResult& n : result.nodes)
    if (n.node.kind != NodeKind::argument && n.node.kind != NodeKind::theorem)
      all.push_back(
          {{"name", n.node.id + ": " + to_string(n.status)},
           {"met", n.status == NodeStatus::proved || (open && n.status != NodeStatus::refuted)},
           {"found", n.summary}});
  all.push_back({{"name", open ? "the proof is open" : "the proof is complete"},
                 {"met", result.complete() != open},
                 {"found", result.conclusion()}});
  return all;
}

} // namespace

CaseReport test_theorem(const Settings& settings, const std::string& path) {
  const Report r = supervised(settings, path, [&] {
    ProveOptions options;
    options.decide = settings.solver_options();
    const TheoremResult result = kov::prove(read_theorem(read_document(path)), options);
    return Report{exit_decided, "", Json{{"expected", theorem_expectations(result)}}};
  });
  CaseReport report;
  report.exit = r.exit;
  if (!r.json.contains("expected")) {
    report.expected.push_back({.name = "the proof is complete",
                               .met = false,
                               .found = r.json.value("reason", "a limit")});
    return report;
  }
  for (const Json& e : r.json.at("expected"))
    report.expected.push_back({e.at("name"), e.at("met"), e.at("found")});
  return report;
}

} // namespace kov::cli
