#include "integrability/components.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"

#include <algorithm>

namespace kov {
namespace {

std::vector<MPoly> generators(const InvariantManifold& m) {
  return mapped<MPoly>(m.curve->basis(),
                       [&](const KPoly& g) { return m.curve->from_kpoly(g).num(); });
}

bool on_the_curve(const InvariantManifold& m, const MPoly& f) {
  return uses_any(f, m.curve->main());
}

// The zeros of f on the curve contain a curve on which X is defined and not 0.
bool vanishes_on_a_phase_curve(const System& s, const InvariantManifold& m, const MPoly& f,
                               const Budget& budget) {
  auto all = generators(m);
  all.push_back(f);
  std::vector<MPoly> defined(m.nonzero);
  for (const MFraction& x : s.field.components)
    if (!is_zero(x) && !is_constant(x.den())) defined.push_back(x.den());
  if (Ideal(s.ring(), m.curve->main(), all, defined, budget).dimension() < 1) return false;
  return std::ranges::any_of(s.field.components, [&](const MFraction& x) {
    if (is_zero(x)) return false;
    auto nonzero = defined;
    nonzero.push_back(x.num());
    return Ideal(s.ring(), m.curve->main(), all, nonzero, budget).dimension() >= 1;
  });
}

std::vector<MPoly> divided_by(const ManifoldReport& report) {
  std::vector<MPoly> all;
  const auto add = [&](const std::vector<MPoly>& some) {
    for (const MPoly& whole : some)
      if (const MPoly p = report.manifold->restrict(MFraction(whole)).num();
          on_the_curve(*report.manifold, p))
        for (const MFactor& f : factor(p).second)
          if (on_the_curve(*report.manifold, f.base) && !is_among(f.base, all))
            all.push_back(f.base);
  };
  add(report.normal.divisors);
  add(report.reduced.divisors);
  add(report.coupling_divisors);
  for (const BlockReport& b : report.blocks)
    if (b.ode) add(b.ode->divided_by);
  return all;
}

} // namespace

std::optional<LeftOut> component_left_out(const Study& study, const ManifoldReport& report) {
  try {
    for (const MPoly& f : divided_by(report))
      if (vanishes_on_a_phase_curve(study.system, *report.manifold, f, study.options.decide.budget))
        return LeftOut{LeftOut::What::component, to_string(f)};
  } catch (const OutOfBudget& limit) {
    return LeftOut{LeftOut::What::components, limit.what()};
  }
  return {};
}

bool may_fall_apart(const Study& study, const ManifoldReport& report) {
  return !study.system.field.parameters.empty() && !divided_by(report).empty();
}

} // namespace kov
