#include "integrability/expect.hpp"

#include <algorithm>
#include <chrono>

namespace kov {
namespace {

std::string group_name(const GaloisGroup& g) {
  return to_string(g.type) + (g.n ? "_" + to_string(*g.n) : "");
}

// What one manifold has to say; empty: as expected.
std::string compare(const SystemExpectation& x, const ManifoldReport& m) {
  std::string wrong;
  const auto differs = [&](const std::string& what, const std::string& expected,
                           const std::string& found) {
    if (!expected.empty() && expected != found)
      wrong += what + ": expected " + expected + ", found " + found + "; ";
  };
  differs("verdict", x.verdict, to_string(m.verdict));
  const BlockReport* block = nullptr;
  for (const auto& b : m.blocks)
    if (b.ode && (!block || b.abelian == Truth::no)) block = &b;
  if (!block) {
    if (x.p || x.q || x.r || !x.group.empty() || !x.abelian.empty())
      wrong += "no equation of second order was found; ";
  } else {
    const auto same = [&](const char* what, const std::optional<MFraction>& expected,
                          const std::optional<MFraction>& found) {
      if (expected && (!found || !(*expected == *found)))
        wrong += std::string(what) + " = " + (found ? to_string(*found) : "?") + ", expected " +
                 to_string(*expected) + "; ";
    };
    same("p", x.p, block->ode->p);
    same("q", x.q, block->ode->q);
    same("r", x.r, block->ode->r);
    differs("abelian", x.abelian,
            block->abelian == Truth::yes  ? "yes"
            : block->abelian == Truth::no ? "no"
                                          : "undecided");
    if (block->decision) {
      const Decision& d = *block->decision;
      differs("group", x.group, d.group ? group_name(*d.group) : "undetermined");
      if (x.kovacic_case)
        differs("case", std::to_string(*x.kovacic_case),
                d.kovacic_case ? std::to_string(*d.kovacic_case) : "undetermined");
      differs("identity component", x.identity_component,
              d.component ? to_string(*d.component) : "undetermined");
    } else if (!x.group.empty() || x.kovacic_case) {
      wrong += "no group was determined; ";
    }
  }
  if (!wrong.empty())
    for (const auto& r : m.reasons)
      wrong += r + "; ";
  return wrong;
}

} // namespace

std::string unmet(const SystemExpectation& x, const CheckReport& report) {
  std::string wrong;
  for (const auto& m : report.manifolds) {
    if (!x.manifold.empty() && x.manifold != m.name) continue;
    const std::string one = compare(x, m);
    if (one.empty()) return {}; // one manifold is enough
    wrong += "[" + m.name + "] " + one;
  }
  return wrong.empty() ? "the file has no such manifold" : wrong;
}

std::string describe(const SystemExpectation& x) {
  std::string s;
  for (const auto& [name, value] : x.where)
    s += (s.empty() ? "" : ", ") + name + " = " + value;
  if (!s.empty()) s += ": ";
  s += x.verdict.empty() ? "the stages" : x.verdict;
  if (!x.group.empty()) s += ", group " + x.group;
  if (!x.source.empty()) s += "  (" + x.source + ")";
  return s;
}

namespace {

std::string run(const Entry& document, const SystemExpectation& x, const CheckOptions& options) {
  const System s = read_system(document, x.where);
  CheckOptions how = options;
  how.only_manifold = x.manifold;
  // read again: the values of `where` apply to p, q, r of the expectation as well
  const auto here = std::find_if(s.expectations.begin(), s.expectations.end(),
                                 [&](const SystemExpectation& e) { return e.line == x.line; });
  return unmet(*here, check_system(s, how));
}

} // namespace

std::vector<ExpectationResult> test_system_file(const std::string& path,
                                                const CheckOptions& options) {
  const Entry document = read_document(path);
  const System s = read_system(document);
  std::vector<ExpectationResult> results;
  const auto timed = [&](long line, std::string name, auto&& work) {
    const auto start = std::chrono::steady_clock::now();
    ExpectationResult r{path, line, std::move(name), false, work(), 0};
    r.passed = r.message.empty();
    r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    results.push_back(std::move(r));
  };
  for (const auto& claim : s.claims)
    timed(claim.line, claim.name.empty() ? claim.text : claim.name, [&]() -> std::string {
      const ClaimResult r = decide_claim(s, claim, options.decide.budget);
      return is_met(claim, r) ? "" : r.detail;
    });
  for (const auto& x : s.expectations) {
    timed(x.line, describe(x), [&] { return run(document, x, options); });
  }
  return results;
}

} // namespace kov
