#include "study/expect.hpp"

#include "exact/joined.hpp"

#include <algorithm>

namespace kov::study {
namespace {

std::string group_name(const GaloisGroup& g) {
  return to_string(g.type) + (g.n ? "_" + to_string(*g.n) : "");
}

// The verdict, or that of the first order where higher ones say more.
std::string verdict_for(const SystemExpectation& x, const CurveStudy& study) {
  std::string first = to_string(study.first.verdict);
  return x.verdict == first ? first : to_string(study.headline.verdict);
}

// The difference of one manifold from the expectation; empty: as expected.
std::string compare(const SystemExpectation& x, const CurveStudy& study) {
  const ManifoldReport& m = study.first;
  std::string wrong;
  const auto differs = [&](const std::string& what, const std::string& expected,
                           const std::string& found) {
    if (!expected.empty() && expected != found)
      wrong += what + ": expected " + expected + ", found " + found + "; ";
  };
  differs("verdict", x.verdict, verdict_for(x, study));
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
    for (const auto& r : reasons(m))
      wrong += r + "; ";
  return wrong;
}

} // namespace

std::string unmet(const SystemExpectation& x, std::span<const CurveStudy> manifolds) {
  std::string wrong;
  for (const CurveStudy& m : manifolds) {
    if (!x.manifold.empty() && x.manifold != m.name()) continue;
    const std::string one = compare(x, m);
    if (one.empty()) return {}; // one manifold is enough
    wrong += "[" + m.name() + "] " + one;
  }
  return wrong.empty() ? "the file has no such manifold" : wrong;
}

std::string describe(const SystemExpectation& x) {
  std::string s = joined(x.where, [](const auto& v) { return v.first + " = " + v.second; });
  if (!s.empty()) s += ": ";
  s += x.verdict.empty() ? "the stages" : x.verdict;
  if (!x.group.empty()) s += ", group " + x.group;
  if (!x.source.empty()) s += "  (" + x.source + ")";
  return s;
}

} // namespace kov::study
