#include "integrability/block.hpp"

#include "decide/words.hpp"
#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "integrability/change_search.hpp"
#include "integrability/constants.hpp"
#include "integrability/parameters.hpp"
#include "system/relations.hpp"
#include "variation/leaf.hpp"

#include <algorithm>

namespace kov {

std::vector<std::vector<std::size_t>> blocks_to_study(const LinearSystem& r,
                                                      const InvariantManifold& m) {
  auto parts = blocks(r, m);
  const auto coupled = [&](std::size_t i, std::size_t j) {
    return !m.vanishes_on_curve(r.a[i][j]) || !m.vanishes_on_curve(r.a[j][i]);
  };
  const auto neighbours = [&](std::size_t i) {
    std::vector<std::size_t> all;
    for (std::size_t j = 0; j < r.a.size(); ++j)
      if (j != i && coupled(i, j)) all.push_back(j);
    return all;
  };
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k].size() != 1) continue;
    const auto mine = neighbours(parts[k][0]);
    if (mine.size() != 1 || neighbours(mine[0]) != parts[k]) continue;
    const auto other = std::ranges::find(parts, mine);
    if (other == parts.end()) continue;
    parts[k] = {std::min(parts[k][0], mine[0]), std::max(parts[k][0], mine[0])};
    parts.erase(other);
    k = 0;
  }
  return parts;
}

namespace {

std::string parameter_names(const MFraction& f, const System& s) {
  std::string names;
  for (const std::size_t i : used_variables(f))
    if (is_among(i, s.field.parameters)) names += (names.empty() ? "" : ", ") + s.ring()->name(i);
  return names;
}

void decide_parameters(const System& s, const CheckOptions& options, BlockReport& block) {
  block.strata =
      strata::decide_strata(strata_question(s, *block.ode), strata_limits(s, *block.ode, options));
  block.abelian = block.strata->abelian();
}

// r has no parameters, but what was divided by on the way has: the answer holds where that is not
// 0.
void except_where_invalid(const System& s, const CheckOptions& options, BlockReport& block) {
  const AlgebraicOde& ode = *block.ode;
  const Truth generic = block.decision->abelian;
  const bool one_system = where_relations_fall_apart(s.field).empty();
  if (s.field.parameters.empty() || (ode.generic.empty() && one_system))
    return void(block.abelian = generic);
  if (s.field.constants.empty()) {
    decide_parameters(s, options, block);
    const auto& all = block.strata->strata;
    if (all.size() == 1 && !all.front().leaf.no_equation() && block.strata->unvisited.empty()) {
      block.strata.reset(); // valid for all parameters
      block.abelian = block.decision->abelian;
    } else {
      block.decision.reset();
    }
    return;
  }
  for (const MPoly& g : ode.generic)
    for (const std::size_t i : s.field.parameters)
      if (uses(g, i)) {
        block.abelian = Truth::unknown;
        block.missing = {{Missing::What::only_where, to_string(g), reason(*block.decision)}};
        return;
      }
  block.abelian = one_system ? generic : Truth::unknown;
  if (!one_system) block.missing = {{Missing::What::relations_fall_apart}};
}

// one_level: one value of the energy is enough, levels.cpp looks for it
void decide_block(const System& s, const CheckOptions& options, bool one_level,
                  BlockReport& block) {
  const AlgebraicOde& ode = *block.ode;
  const std::string names = parameter_names(ode.r, s);
  // a constant that depends on the parameters is one to strata
  if (!names.empty() || (!options.stop_at_r && !constants_are_numbers(s.field))) {
    if (options.stop_at_r)
      block.missing = {{Missing::What::parameters_in_r, names}};
    else if (!one_level)
      decide_parameters(s, options, block);
    return;
  }
  const ConstantField constants = ConstantField::make(s.field);
  NormalForm equation;
  equation.r = constants.convert(ode.r, ode.z);
  if (ode.p && parameter_names(*ode.p, s).empty() && parameter_names(*ode.q, s).empty()) {
    equation.p = constants.convert(*ode.p, ode.z);
    const NormalForm again = normal_form(equation.p, constants.convert(*ode.q, ode.z));
    KOV_ENSURE(again.r == equation.r); // two ways to r
  }
  block.equation = equation;
  if (options.stop_at_r) return;
  Options how = options.decide;
  how.variable = s.ring()->name(ode.z);
  block.decision = decide(equation, how);
  block.abelian = Truth::unknown; // until the exceptions are known, should a limit end that search
  except_where_invalid(s, options, block);
}

// An equation for every cyclic vector, that of the unknown asked for alone if it is one.
std::vector<NormalVariationalEquation> scalar_equations(const System& s, const InvariantManifold& m,
                                                        const LinearSystem& reduced,
                                                        const std::vector<MPoly>& divisors,
                                                        const std::vector<std::size_t>& members,
                                                        const ReduceSpec* reduce) {
  std::vector<NormalVariationalEquation> all;
  const std::string wish = reduce && reduce->unknown ? s.ring()->name(*reduce->unknown) : "";
  for (const bool wished : {true, false})
    for (const std::size_t i : members)
      if ((reduced.names[i] == wish) == wished)
        if (auto e = scalar_equation(s.field, m, reduced, members, i))
          if (all.empty() || all.front().unknown != wish) all.push_back(*std::move(e));
  KOV_ENSURE(!all.empty()); // the block is coupled
  for (auto& e : all)       // what was divided by before, too
    for (const auto& d : divisors)
      add_once(e.divisors, d);
  return all;
}

} // namespace

void study_block(const System& s, const InvariantManifold& m, const LinearSystem& reduced,
                 const std::vector<MPoly>& divisors, const std::vector<std::size_t>& members,
                 const CheckOptions& options, BlockReport& block) {
  for (const std::size_t i : members)
    block.unknowns.push_back(reduced.names[i]);
  if (members.size() == 1) {
    block.abelian = Truth::yes; // a first-order equation: its group is in the multiplicative group
    return;
  }
  if (members.size() > 2) {
    block.missing = {{Missing::What::large_block, std::to_string(members.size())}};
    return;
  }
  const ReduceSpec* reduce = reduction_for(s, m.name);
  block.scalar = scalar_equations(s, m, reduced, divisors, members, reduce);
  std::optional<UnknownsOfBlock> also;
  if (!reduce || !reduce->unknown) also.emplace(UnknownsOfBlock{reduced, members});
  find_change(s, m, reduce && reduce->change ? &*reduce->change : nullptr, options.decide.budget,
              block, also);
  if (!block.ode) return;
  std::ranges::copy(m.curve->inverted(), std::back_inserter(block.ode->generic));
  decide_block(s, options, reduce && reduce->energy == "auto", block);
}

namespace {

std::vector<std::string> names_of(const LinearSystem& s, const std::vector<std::size_t>& members) {
  std::vector<std::string> names;
  for (const std::size_t i : members)
    names.push_back(s.names[i]);
  return names;
}

} // namespace

void study_on_the_leaf(const Study& study, ManifoldReport& report, std::vector<MPoly> divisors,
                       const std::vector<std::size_t>& members, BlockReport& block) {
  const LinearSystem& reduced = report.reduced.system;
  std::vector<std::string> unknowns = names_of(reduced, members);
  if (members.size() == 2 && study.system.kind != SystemKind::hamiltonian) {
    const Restriction to{names_of(reduced, used_by(reduced, *report.manifold, members)),
                         report.reduced.eliminations};
    if (!seen_on_the_leaf(study.system.field, *report.manifold, report.normal, to, unknowns,
                          divisors)) {
      block.unknowns = std::move(unknowns);
      block.missing = {{Missing::What::not_on_the_leaf}};
      return;
    }
  }
  study_block(study.system, *report.manifold, report.reduced.system, divisors, members,
              study.options, block);
}

} // namespace kov
