#include "system/domain.hpp"

#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"
#include "system/written_functions.hpp"

#include <algorithm>

namespace kov {
namespace {

using NotAllZero = ParameterDomain::NotAllZero;

// The coefficients of f by all that is not a parameter and no constant.
NotAllZero coefficients_of(const MPoly& f, const VectorField& v) {
  std::vector<std::size_t> moving = used_variables(f);
  std::erase_if(
      moving, [&](std::size_t i) { return is_among(i, v.parameters) || is_among(i, v.constants); });
  return nonzero_coefficients(f, moving);
}

// The function under the root that f is.
std::optional<MFraction> under_the_root(const MPoly& f,
                                        const std::vector<FunctionMeaning>& meanings) {
  const auto used = used_variables(f);
  if (used.size() != 1) return std::nullopt;
  const MFraction root = MFraction::variable(f.ring(), used[0]);
  if (!(MFraction(f) == root)) return std::nullopt;
  for (const FunctionMeaning& m : meanings)
    if (order_of_root(m.name) != 0 && (m.value ? *m.value == root : m.variable == used[0]))
      return m.argument;
  return std::nullopt;
}

} // namespace

void ParameterDomain::require(const MPoly& f, const VectorField& v,
                              const std::vector<FunctionMeaning>& meanings) {
  if (is_constant(f)) return;
  for (const MFactor& one : factor(f).second) {
    const auto inner = under_the_root(one.base, meanings);
    if (inner && !is_zero(*inner))
      require(inner->num(), v, meanings);
    else
      require(coefficients_of(one.base, v));
  }
}

void ParameterDomain::add(NotAllZero list) {
  const auto says = [](const NotAllZero& a, const NotAllZero& b) { // a says b
    return std::ranges::all_of(a, [&](const MPoly& p) { return is_among(p, b); });
  };
  if (std::ranges::any_of(lists_, [&](const auto& a) { return says(a, list); })) return;
  std::erase_if(lists_, [&](const auto& b) { return says(list, b); });
  lists_.push_back(std::move(list));
}

void ParameterDomain::require(NotAllZero list) {
  if (std::ranges::any_of(list, [](const MPoly& p) { return is_constant(p); })) return;
  MPoly common(list.front().ring());
  for (const MPoly& p : list)
    common = gcd(common, p);
  NotAllZero rest;
  bool is_settled = false; // a quotient is a number
  for (const MPoly& p : list) {
    const MPoly q = squarefree_part(exact_div(p, common));
    is_settled = is_settled || is_constant(q);
    add_once(rest, q);
  }
  if (!is_constant(common))
    for (const MFactor& f : factor(common).second)
      add({f.base});
  std::ranges::sort(rest, // the same words for the same list
                    [](const MPoly& p, const MPoly& q) { return to_string(p) < to_string(q); });
  if (!is_settled) add(std::move(rest));
}

std::vector<MPoly> ParameterDomain::nonzero() const {
  std::vector<MPoly> all;
  for (const NotAllZero& list : lists_)
    if (list.size() == 1) all.push_back(list.front());
  return all;
}

ParameterDomain ParameterDomain::at(const Substitution& values) const {
  ParameterDomain there;
  for (const NotAllZero& list : lists_) {
    NotAllZero left;
    for (const MPoly& p : list)
      if (const MFraction f = substitute(p, values); !is_zero(f)) left.push_back(f.num());
    if (left.empty())
      throw DomainError("the system does not exist there: needed is " + in_words(list));
    there.require(std::move(left));
  }
  return there;
}

ParameterDomain ParameterDomain::in(const Ring& ring) const {
  ParameterDomain there;
  for (const NotAllZero& list : lists_) {
    there.lists_.emplace_back();
    for (const MPoly& p : list)
      there.lists_.back().push_back(transfer(MFraction(p), ring).num());
  }
  return there;
}

std::string in_words(const ParameterDomain::NotAllZero& list) {
  return joined(
      list, [&](const MPoly& p) { return to_string(p) + " != 0"; }, " or ");
}

} // namespace kov
