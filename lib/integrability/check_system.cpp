// A file: its claims, then each of its manifolds with its share of the work.

#include "integrability/check.hpp"

#include "exact/error.hpp"
#include "integrability/parameters.hpp"

#include <algorithm>
#include <chrono>

namespace kov {

std::vector<const ManifoldSpec*> manifolds_to_check(const System& s, const CheckOptions& options) {
  const std::string& only = options.only_manifold;
  std::vector<const ManifoldSpec*> all;
  std::string names;
  for (const auto& spec : s.manifolds) {
    names += (names.empty() ? "" : ", ") + spec.name;
    if (only.empty() || only == spec.name) all.push_back(&spec);
  }
  if (!only.empty() && all.empty())
    throw InvalidArgument("there is no manifold '" + only +
                          "'; manifolds: " + (names.empty() ? "none" : names));
  return all;
}

namespace {

// An equal share, so that one manifold does not take the work of the others.
CheckOptions for_one_of(std::size_t manifolds, CheckOptions options) {
  Budget& budget = options.decide.budget;
  budget = part_of_the_work(budget, 1 / static_cast<double>(manifolds));
  return options;
}

// As much as one minute is enough for.
CheckOptions with_a_limit(CheckOptions options) {
  Budget& budget = options.decide.budget;
  if (!budget.work_end) budget.give(60 * std::max(budget.max_work, 1e8));
  return options;
}

} // namespace

CheckReport check_system(const System& s, const CheckOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  require_consistent(s);
  CheckReport report;
  report.system = s;
  report.claims = decide_claims(s, options.decide.budget);
  auto left = manifolds_to_check(s, options);
  const CheckOptions of_all = left.size() > 1 ? with_a_limit(options) : options;
  for (; !left.empty(); left.erase(left.begin()))
    report.manifolds.push_back(
        check_manifold(s, *left.front(), report.claims, for_one_of(left.size(), of_all)));
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

} // namespace kov
