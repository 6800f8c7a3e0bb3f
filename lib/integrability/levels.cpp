#include "integrability/levels.hpp"

#include "exact/lists.hpp"
#include "integrability/check.hpp"
#include "integrability/parameters.hpp"
#include "integrability/special_strata.hpp"

#include "exact/error.hpp"

#include <algorithm>

namespace kov {

std::vector<MPoly> merging_locus(const MFraction& r, std::size_t z, std::size_t h) {
  std::vector<MPoly> places;
  for (auto& f : factor(r.den()).second)
    if (uses(f.base, z)) places.push_back(std::move(f.base));
  std::vector<MPoly> events;
  for (std::size_t i = 0; i < places.size(); ++i) {
    events.push_back(coefficients(places[i], z).back());
    if (degree(places[i], z) > 1) events.push_back(discriminant(places[i], z));
    for (std::size_t j = 0; j < i; ++j)
      events.push_back(resultant(places[i], places[j], z));
  }
  std::vector<MPoly> locus;
  for (const auto& e : events) {
    if (is_zero(e) || !uses(e, h)) continue;
    for (auto& f : factor(e).second)
      if (uses(f.base, h) && !is_among(f.base, locus)) locus.push_back(std::move(f.base));
  }
  std::ranges::sort(locus, [&](const MPoly& a, const MPoly& b) {
    return degree(a, h) != degree(b, h) ? degree(a, h) < degree(b, h) : compare(a, b) < 0;
  });
  return locus;
}

namespace {

/// The parameter named in the file, or one that r has and the vector field has not: it labels a
/// level.
std::optional<std::size_t> energy_parameter(const System& s, const ReduceSpec& reduce,
                                            const MFraction& r) {
  std::optional<std::size_t> found;
  for (const std::size_t i : level_parameters(s)) // others are not a choice of a level
    if (uses(r, i) && (!found || s.ring()->name(i) == reduce.energy_parameter)) found = i;
  return found;
}

/// The system with the parameter h made an algebraic constant: a root of f.
System at_root(const System& s, std::size_t h, const MPoly& f) {
  System special = s;
  std::erase(special.field.parameters, h);
  special.field.constants.push_back(h);
  special.field.relations.push_back(f);
  for (auto& r : special.reductions)
    r.energy.clear();
  return special;
}

/// The whole way again at one level: nothing is taken over from the generic one.
EnergyResult decide_at(const Study& study, const System& special, const BlockReport& block) {
  EnergyResult result;
  const ManifoldReport there = check_manifold(special, study.manifold, study.claims, study.options);
  for (const auto& b : there.blocks) {
    if (b.unknowns != block.unknowns) continue;
    if (b.equation) result.r = b.equation->r;
    if (b.decision && b.abelian == b.decision->abelian) result.decision = b.decision;
    result.way = b.way;
    result.missing = b.missing; // the decision may hold for some values of other parameters only
    return result;
  }
  for (const auto& reason : reasons(there))
    result.missing.push_back({Missing::What::elsewhere, reason});
  if (result.missing.empty()) result.missing.push_back({Missing::What::other_blocks});
  return result;
}

// The parameters for which f has no root h: none if a coefficient of a positive power is proved not
// to vanish.
std::optional<strata::Stratum> without_level(const strata::Question& q, const MPoly& f,
                                             std::size_t h, const std::string& name) {
  const ParametrisedSet all(q.r.ring(), q.assumptions);
  strata::Stratum nowhere;
  const auto in_h = coefficients(f, h);
  for (std::size_t k = 1; k < in_h.size(); ++k) {
    if (is_zero(in_h[k])) continue;
    const MPoly c = transfer(MFraction(in_h[k]), q.r.ring()).num();
    if (is_constant(c) || !all.doubtful_factor(c)) return std::nullopt;
    nowhere.conditions.push_back({c, Sign::zero});
  }
  nowhere.leaf = strata::open_leaf(
      strata::NoEquation{strata::NoEquation::Why::no_level,
                         "there is no level " + name + " with " + to_string(f) + " = 0"});
  return nowhere;
}

// All parameters with f = 0 at once.  Any level is as good as
// another, so that what is assumed of h is left out; where f has no root h there is no such level.
void decide_locus(const Study& study, const std::vector<BlockReport>& generic, const MPoly& f,
                  std::size_t h, BlockReport& block) {
  const System& s = study.system;
  System all_levels = s;
  forget_assumptions(h, all_levels);
  strata::Question q = strata_question(all_levels, *block.ode);
  const auto nowhere = without_level(q, f, h, s.ring()->name(h));
  q.assumptions.require(transfer(MFraction(f), q.r.ring()), Sign::zero);
  EnergyResult e;
  e.at = {to_string(f), "0"};
  e.strata = strata::decide_strata(q, strata_limits(s, *block.ode, study.options));
  decide_special_strata(study, generic, block.unknowns, *e.strata, block.special_studies);
  if (nowhere) e.strata->strata.push_back(*nowhere);
  if (e.strata->abelian() == Truth::no) {
    block.abelian = Truth::no; // for every body there is such a level
    block.missing.clear();
  }
  block.energies.push_back(std::move(e));
}

bool has_other_parameters(const System& s, const MFraction& r, std::size_t h) {
  const auto used = used_variables(r);
  const auto& parameters = s.field.parameters;
  return std::ranges::any_of(used,
                             [&](std::size_t i) { return i != h && is_among(i, parameters); });
}

} // namespace

void study_levels(const Study& study, const ReduceSpec& reduce,
                  const std::vector<BlockReport>& generic, BlockReport& block) {
  const System& s = study.system;
  const auto h = energy_parameter(s, reduce, block.ode->r);
  if (!h) { // every level is like every other
    if (!study.options.stop_at_r && !block.decision && !block.strata)
      block.strata = strata::decide_strata(strata_question(s, *block.ode),
                                           strata_limits(s, *block.ode, study.options));
    return;
  }
  block.special = merging_locus(block.ode->r, block.ode->z, *h);
  std::erase_if(block.special, [&](const MPoly& f) { return not_excluded(s, {f}).empty(); });
  if (has_other_parameters(s, block.ode->r, *h)) {
    if (study.options.stop_at_r) return; // strata are about the group
    for (const auto& f : block.special) {
      decide_locus(study, generic, f, *h, block);
      if (block.abelian == Truth::no) return; // an abelian one says nothing of the others
    }
    const auto tells = [](const EnergyResult& e) {
      return e.strata && e.strata->decided() && somewhere_not_abelian(*e.strata);
    };
    if (std::ranges::none_of(block.energies, tells))
      block.strata = strata::decide_strata(strata_question(s, *block.ode),
                                           strata_limits(s, *block.ode, study.options));
    return;
  }
  const auto run = [&](const MPoly& f, LevelEquation at, bool sample) {
    EnergyResult e = decide_at(study, at_root(s, *h, f), block);
    e.at = std::move(at);
    e.sample = sample;
    if (e.decision && e.decision->abelian == Truth::no) {
      block.abelian = Truth::no;
      block.missing.clear(); // one level is enough
    }
    block.energies.push_back(std::move(e));
  };
  for (const auto& f : block.special)
    if (used_variables(f).size() == 1) run(f, {to_string(f), "0"}, false);
  const std::string name = s.ring()->name(*h);
  for (const Rational& sample : {Rational(1), Rational(2), Rational(1, 2)}) {
    if (block.abelian == Truth::no) return;
    const MFraction f = MFraction::variable(s.ring(), *h) - MFraction(s.ring(), sample);
    if (not_excluded(s, {f.num()}).empty()) continue; // the file assumes another one
    run(f.num(), {name, to_string(sample)}, true);
  }
  if (block.abelian != Truth::no) // perhaps abelian on all levels
    block.strata = strata::decide_strata(strata_question(s, *block.ode),
                                         strata_limits(s, *block.ode, study.options));
}

} // namespace kov
