#include "study/higher_orders.hpp"

#include "exact/joined.hpp"
#include "integrability/parameters.hpp"

#include <algorithm>

namespace kov::study {
namespace {

// "p = 0 and q = 0"
std::string vanishing(const std::vector<MPoly>& list) {
  return joined(
      list, [&](const MPoly& p) { return to_string(p) + " = 0"; }, " and ");
}

std::vector<std::string> where_nothing_follows(const System& s, const Exclusion& e) {
  std::vector<std::string> all;
  for (const auto& list : e.not_all_zero) {
    if (not_excluded(s, list).size() < list.size()) continue; // one of them is not 0
    all.push_back(vanishing(list));
  }
  return all;
}

// The values that the file admits, as far as equations and inequations say.
Set admitted(const System& s) {
  std::vector<std::size_t> names = s.field.constants;
  names.insert(names.end(), s.field.parameters.begin(), s.field.parameters.end());
  Set all(s.ring(), names);
  for (const MPoly& p : s.field.relations)
    all = all.where_zero(p);
  for (const Assumption& a : s.assumptions) {
    if (a.is(Sign::zero)) all = all.where_zero(a.value.num());
    if (a.is_nonzero()) all = all.where_nonzero(a.value.num());
  }
  return all;
}

// p = 0 at all values that the file admits: proved.
bool vanishes_by_assumption(const System& s, const MPoly& p) {
  if (s.assumptions.empty() || is_constant(p)) return false;
  System other = s;
  other.assumptions.push_back({Sign::nonzero, MFraction(p)});
  return contradicts_itself(other) || admitted(other).is_empty();
}

// An obstruction that excludes no value that the file admits is none.
void withdraw_if_void(const System& s, HigherOrders& h) {
  for (const auto& list : h.excluded->not_all_zero) {
    if (!std::ranges::all_of(list, [&](const MPoly& p) { return vanishes_by_assumption(s, p); }))
      continue;
    h.planes.open = "VE_" + std::to_string(h.excluded->by.order) +
                    " excludes nothing that the file admits, as " + vanishing(list) + " there";
    h.planes.obstruction.reset();
    return h.excluded.reset();
  }
}

} // namespace

HigherOrders higher_orders(const System& s, const ManifoldSpec& m, int order,
                           const Options& options) {
  HigherOrders h;
  h.up_to = order;
  h.planes = jets::higher_orders(s, m, {order, options});
  h.excluded = exclusion_of(s, m, h.planes);
  if (h.excluded) withdraw_if_void(s, h);
  if (h.excluded) h.exceptions = where_nothing_follows(s, *h.excluded);
  if (h.excluded || h.planes.open.empty()) return h;
  const QuadratureOrders other = orders_by_quadratures(s, m, order, options.budget);
  if (other.obstruction) h.excluded = exclusion_of(m, *other.obstruction);
  if (!other.open.empty()) h.planes.open += "; " + other.open;
  return h;
}

std::string exceptions(const HigherOrders& h, bool possibly) {
  if (h.exceptions.empty()) return {};
  return (possibly ? "except possibly where " : "except where ") + joined(h.exceptions, "; or ");
}

} // namespace kov::study
