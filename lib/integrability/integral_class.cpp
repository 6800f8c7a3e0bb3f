#include "integrability/integral_class.hpp"

#include "exact/error.hpp"
#include "exact/factor.hpp"
#include "integrability/check.hpp"

#include <algorithm>

namespace kov {

std::string to_string(IntegralClass c) {
  return c == IntegralClass::meromorphic ? "meromorphic"
                                         : "meromorphic also at the ends of the phase curve "
                                           "(points at infinity, equilibria, poles of the system)";
}

IntegralClass integral_class(const RationalFunction& r) {
  bool irregular = !is_zero(r) && order_at_infinity(r) < 2;
  if (!is_zero(r) && degree(r.den()) > 0)
    for (const auto& f : squarefree_factors(r.den()))
      if (f.exponent > 2) irregular = true;
  return irregular ? IntegralClass::meromorphic_at_infinity : IntegralClass::meromorphic;
}

namespace {

// One or more equations with a non-abelian identity component.
struct NonAbelian {
  IntegralClass integrals = IntegralClass::meromorphic;
  bool sl2 = true; ///< each is known to have the group SL(2, C)
  bool any = false;

  void add(IntegralClass c, bool is_sl2) {
    integrals = std::max(integrals, c);
    sl2 = sl2 && is_sl2;
    any = true;
  }
  void add(const RationalFunction& r, const Decision& d) {
    if (d.abelian == Truth::no) add(integral_class(r), d.component == Connected::sl2);
  }
  void add(const strata::StrataAnswer& answer) {
    for (const strata::Stratum& x : answer.told_apart())
      if (x.leaf.abelian == Truth::no)
        add(strata::has_irregular_place(x.leaf) ? IntegralClass::meromorphic_at_infinity
                                                : IntegralClass::meromorphic,
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
  [[nodiscard]] bool survives_covers() const {
    return sl2 && integrals == IntegralClass::meromorphic;
  }
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
  return *std::min_element(enough.begin(), enough.end(),
                           [](const NonAbelian& a, const NonAbelian& b) {
                             return std::pair(!a.survives_covers(), a.integrals) <
                                    std::pair(!b.survives_covers(), b.integrals);
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
    if (std::find(main.begin(), main.end(), i) == main.end() && moves(s, m, i)) all.push_back(i);
  };
  for (const std::size_t i : s.field.coordinates)
    look_at(i);
  for (const FunctionSymbol& f : s.field.functions)
    look_at(f.variable);
  return all;
}

ExcludedIntegrals excluded_integrals(const System& s, const ManifoldReport& report) {
  // Loops on the curve itself, but for coordinates that are left out.
  if (report.matrices)
    return {IntegralClass::meromorphic, moving_and_left_out(s, *report.manifold)};
  const NonAbelian by = what_decides(report);
  if (!by.any || !report.manifold || by.survives_covers()) return {by.integrals, {}};
  return {by.integrals, moving_and_left_out(s, *report.manifold)};
}

} // namespace kov
