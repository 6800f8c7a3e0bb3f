// A file: its claims, then each of its manifolds with its share of the time.

#include "integrability/check.hpp"

#include "exact/error.hpp"
#include "integrability/parameters.hpp"
#include "integrability/study.hpp"

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

std::vector<ClaimReport> decide_claims(const System& s, const CheckOptions& options) {
  std::vector<ClaimReport> all;
  for (const auto& claim : s.claims)
    all.push_back({claim, decide_claim(s, claim, options.decide.budget)});
  return all;
}

namespace {

// An equal share, so that one manifold does not take the time of the others.
CheckOptions for_one_of(std::size_t manifolds, CheckOptions options) {
  options.decide.budget =
      part_of_the_time(options.decide.budget, 1 / static_cast<double>(manifolds));
  return options;
}

} // namespace

CheckReport check_system(const System& s, const CheckOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  require_consistent(s);
  CheckReport report;
  report.system = s;
  report.claims = decide_claims(s, options);
  auto left = manifolds_to_check(s, options);
  for (; !left.empty(); left.erase(left.begin()))
    report.manifolds.push_back(
        check_manifold(s, *left.front(), report.claims, for_one_of(left.size(), options)));
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

} // namespace kov
