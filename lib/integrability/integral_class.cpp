#include "integrability/integral_class.hpp"

#include "exact/error.hpp"
#include "exact/factor.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "integrability/regular_leaf.hpp"
#include "integrability/report.hpp"

#include <algorithm>

namespace kov {

IntegralClass::Near integrals_near(const RationalFunction& r) {
  bool irregular = !is_zero(r) && order_at_infinity(r) < 2;
  if (!is_zero(r) && degree(r.den()) > 0)
    for (const auto& f : squarefree_factors(r.den()))
      if (f.exponent > 2) irregular = true;
  return irregular ? IntegralClass::Near::closed_curve : IntegralClass::Near::curve;
}

namespace {

using Near = IntegralClass::Near;

// One or more equations with a non-abelian identity component.
struct NonAbelian {
  Near near = Near::curve;
  bool sl2 = true; ///< each is known to have the group SL(2, C)
  bool any = false;

  void add(Near where, bool is_sl2) {
    near = std::max(near, where);
    sl2 = sl2 && is_sl2;
    any = true;
  }
  void add(const RationalFunction& r, const Decision& d) {
    if (d.abelian == Truth::no) add(integrals_near(r), d.component == Connected::sl2);
  }
  void add(const strata::StrataAnswer& answer) {
    for (const strata::Stratum& x : answer.told_apart())
      if (x.leaf.abelian == Truth::no)
        add(strata::has_irregular_place(x.leaf) ? Near::closed_curve : Near::curve,
            x.leaf.group && x.leaf.group->type == GroupType::SL2);
  }
  void add(const BlockReport& block) {
    if (block.equation && block.decision) add(block.equation->r, *block.decision);
    if (block.strata) add(*block.strata);
    for (const auto& e : block.energies) {
      if (e.r && e.decision) add(*e.r, *e.decision);
      if (e.strata) add(*e.strata);
    }
  }
  /// By the theory page: an infinite Abelian cover of the curve keeps SL(2, C).
  [[nodiscard]] bool survives_covers() const { return sl2 && near == Near::curve; }
};

// One block that is not abelian for all parameters is enough, and the best one counts.
NonAbelian what_decides(const ManifoldReport& report) {
  NonAbelian all;
  std::vector<NonAbelian> enough;
  for (const auto& block : report.blocks) {
    all.add(block);
    NonAbelian one;
    one.add(block);
    if (block.abelian == Truth::no && one.any) enough.push_back(one);
  }
  if (enough.empty()) return all;
  return *std::ranges::min_element(enough, [](const NonAbelian& a, const NonAbelian& b) {
    return std::pair(!a.survives_covers(), a.near) < std::pair(!b.survives_covers(), b.near);
  });
}

bool moves(const System& s, const InvariantManifold& m, std::size_t variable) {
  try {
    return !m.vanishes_on_curve(lie_derivative(s.field, MFraction::variable(s.ring(), variable)));
  } catch (const OutOfBudget&) {
    return true; // not proved to be constant
  }
}

} // namespace

// Coordinates and functions: a logarithm that nothing contains is left out like an angle.
std::vector<std::size_t> moving_and_left_out(const System& s, const InvariantManifold& m) {
  std::vector<std::size_t> all;
  const auto& main = m.curve->main();
  const auto look_at = [&](std::size_t i) {
    if (!is_among(i, main) && moves(s, m, i)) all.push_back(i);
  };
  for (const std::size_t i : s.field.coordinates)
    look_at(i);
  for (const FunctionSymbol& f : s.field.functions)
    look_at(f.variable);
  return all;
}

namespace {

// Symbols that are functions of a coordinate that is left out, each with the coordinate.
std::vector<std::pair<std::string, std::string>>
functions_of(const System& s, const std::vector<std::size_t>& left_out) {
  std::vector<std::pair<std::string, std::string>> all;
  const auto is_left_out = [&](std::size_t i) { return is_among(i, left_out); };
  for (const FunctionSymbol& f : s.field.functions)
    for (std::size_t j = 0; j < s.field.coordinates.size(); ++j)
      if (const std::size_t q = s.field.coordinates[j];
          !is_left_out(f.variable) && is_left_out(q) && !is_zero(f.gradient[j]))
        all.emplace_back(s.ring()->name(q), s.ring()->name(f.variable));
  return all;
}

IntegralClass along(const System& s, const std::string& name, Near near,
                    const std::vector<std::size_t>& left_out) {
  IntegralClass c{.near = near, .curves = {name}};
  c.liouville = s.field.poisson.has_value();
  c.on_leaf = c.liouville && s.kind != SystemKind::hamiltonian;
  for (const FunctionSymbol& f : s.field.functions)
    if (!is_among(f.variable, left_out)) c.functions.push_back(s.ring()->name(f.variable));
  for (const std::size_t i : left_out)
    c.without.push_back(s.ring()->name(i));
  c.through = functions_of(s, left_out);
  return c;
}

} // namespace

IntegralClass excluded_integrals(const System& s, const std::string& name,
                                 const InvariantManifold* m, Near near, bool is_sl2) {
  const bool all_stay = m == nullptr || (is_sl2 && near == Near::curve);
  return along(s, name, near, all_stay ? std::vector<std::size_t>{} : moving_and_left_out(s, *m));
}

namespace {

// On regular leaves of dimension four (lemma T) integrals are excluded that are independent together with
// the Casimir functions.
IntegralClass near_the_leaf(IntegralClass c, const System& s, const ManifoldReport& report) {
  if (c.on_leaf && c.near == Near::curve && c.functions.empty() && c.without.empty())
    c.on_leaf = !tried<OutOfBudget>([&] { return has_regular_leaves(s, report); });
  return c;
}

} // namespace

IntegralClass excluded_integrals(const System& s, const ManifoldReport& report, Near near,
                                 bool is_sl2) {
  const auto* m = report.manifold ? &*report.manifold : nullptr;
  return near_the_leaf(excluded_integrals(s, report.name, m, near, is_sl2), s, report);
}

IntegralClass excluded_integrals(const System& s, const ManifoldReport& report) {
  // Matrices: loops on the curve itself, but for coordinates that are left out.
  if (report.matrices) {
    IntegralClass c = excluded_integrals(s, report, Near::curve, false);
    if (report.matrices->keeps_casimirs) c.on_leaf = false;
    return c;
  }
  const NonAbelian by = what_decides(report);
  return by.any ? excluded_integrals(s, report, by.near, by.sl2)
                : near_the_leaf(along(s, report.name, by.near, {}), s, report);
}

} // namespace kov
