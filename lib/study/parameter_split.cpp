#include "study/parameter_split.hpp"
#include "exact/lists.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace kov {
namespace {

using Sets = std::vector<ParameterSet>;

void append(Sets& all, Sets more) { std::move(more.begin(), more.end(), std::back_inserter(all)); }

// No point of b^2 = 4, b != 2 is left where b >= 0 is assumed.  old: equations that were looked at.
bool has_points(const ParameterSet& s, const std::vector<MPoly>& old, const MayVanish& may_vanish) {
  if (s.is_empty()) return false;
  const auto equations = s.equations();
  return std::ranges::all_of(equations, [&](const MPoly& p) {
    if (is_among(p, old)) return true;
    const auto factors = factor(p).second;
    return std::ranges::any_of(factors, [&](const MFactor& f) { return may_vanish(f.base); });
  });
}

// The set where p vanishes, one part for each irreducible factor, and the rest.
struct Halves {
  Sets zero, nonzero;
};
Halves halves(const ParameterSet& where, const MPoly& p, const MayVanish& may_vanish) {
  const MFraction here = where.restrict(p);
  if (is_zero(here)) return {{where}, {}};
  ParameterSet rest = where;
  const auto old = where.equations();
  Halves all;
  for (const MFactor& f : factor(here.num()).second) {
    if (!may_vanish(f.base)) continue;
    if (auto zero = rest.where_zero(f.base); has_points(zero, old, may_vanish))
      all.zero.push_back(std::move(zero));
    rest = rest.where_nonzero(f.base);
    if (!has_points(rest, old, may_vanish)) return all;
  }
  all.nonzero.push_back(std::move(rest));
  return all;
}

} // namespace

SetParts split_set(const ParameterSet& where, const std::vector<MPoly>& zero,
                   const std::vector<std::vector<MPoly>>& not_all_zero,
                   const MayVanish& may_vanish) {
  SetParts parts{{where}, {}};
  for (const MPoly& p : zero) {
    Sets inside;
    for (const ParameterSet& s : parts.inside) {
      Halves h = halves(s, p, may_vanish);
      append(inside, std::move(h.zero));
      append(parts.outside, std::move(h.nonzero));
    }
    parts.inside = std::move(inside);
  }
  for (const auto& list : not_all_zero) {
    Sets inside;
    Sets rest = std::move(parts.inside);
    for (const MPoly& p : list) {
      Sets left;
      for (const ParameterSet& s : rest) {
        Halves h = halves(s, p, may_vanish);
        append(inside, std::move(h.nonzero));
        append(left, std::move(h.zero));
      }
      rest = std::move(left);
    }
    append(parts.outside, std::move(rest));
    parts.inside = std::move(inside);
  }
  return parts;
}

namespace {

unsigned long total_degree(const MPoly& f) {
  unsigned long degree = 0;
  for (long t = 0; t < f.length(); ++t) {
    const auto e = f.exponents(t);
    degree = std::max(degree, std::accumulate(e.begin(), e.end(), 0UL));
  }
  return degree;
}

} // namespace

std::vector<MPoly> proper_equations(const ParameterSet& where, const std::vector<MPoly>& known) {
  auto all = where.equations();
  if (known.empty()) return all;
  std::ranges::stable_sort(
      all, [](const MPoly& a, const MPoly& b) { return total_degree(a) < total_degree(b); });
  ParameterSet so_far = where.plain();
  for (const MPoly& p : known)
    so_far = so_far.where_zero(p);
  std::vector<MPoly> proper;
  for (const MPoly& p : all) {
    if (is_zero(so_far.restrict(p))) continue;
    so_far = so_far.where_zero(p);
    proper.push_back(p);
  }
  return proper;
}

std::vector<MPoly> inequations(const ParameterSet& where) {
  std::vector<MPoly> all;
  for (const MPoly& p : where.proper_inequations())
    for (const MFactor& f : factor(where.restrict(p).num()).second)
      add_once(all, f.base);
  return all;
}

namespace {

bool same_elements(const std::vector<MPoly>& a, const std::vector<MPoly>& b) {
  return a.size() == b.size() &&
         std::ranges::all_of(a, [&](const MPoly& p) { return is_among(p, b); });
}

bool same_set(const ParameterSet& a, const ParameterSet& b) {
  return a.equations() == b.equations() && same_elements(inequations(a), inequations(b));
}

// The set with p != 0 among its conditions, without that one.
ParameterSet without_inequation(const ParameterSet& s, const MPoly& p) {
  ParameterSet larger = s.plain();
  for (const MPoly& f : s.equations())
    larger = larger.where_zero(f);
  for (const MPoly& f : s.proper_inequations())
    if (!(f == p)) larger = larger.where_nonzero(f);
  return larger;
}

bool vanishes(const MPoly& p, const ParameterSet& there) { return is_zero(there.restrict(p)); }

// The union, if the two are the halves of a set.
std::optional<ParameterSet> union_of(const ParameterSet& zero, const ParameterSet& nonzero) {
  const auto& equations = nonzero.equations();
  if (!std::ranges::all_of(equations, [&](const MPoly& f) { return vanishes(f, zero); }))
    return std::nullopt;
  for (const MPoly& p : nonzero.proper_inequations()) {
    if (!vanishes(p, zero)) continue; // cheap beside what follows
    ParameterSet whole = without_inequation(nonzero, p);
    if (same_set(whole.where_zero(p), zero)) return whole;
  }
  return std::nullopt;
}

} // namespace

std::vector<ParameterSet> united(std::vector<ParameterSet> sets) {
  for (std::size_t i = 0; i < sets.size(); ++i)
    for (std::size_t j = 0; j < sets.size(); ++j) {
      if (i == j) continue;
      auto whole = union_of(sets[i], sets[j]);
      if (!whole) continue;
      sets[i] = *std::move(whole);
      sets.erase(sets.begin() + static_cast<long>(j));
      return united(std::move(sets));
    }
  return sets;
}

namespace {

struct Line {
  std::size_t equation = 0, variable = 0;
};

// An equation that is linear in a parameter; constant slopes first.
std::optional<Line> linear_equation(const std::vector<MPoly>& equations,
                                    const ParameterSet& where) {
  for (const bool constant : {true, false})
    for (std::size_t i = 0; i < equations.size(); ++i) {
      const auto used = used_variables(equations[i]);
      for (auto x = used.rbegin(); x != used.rend(); ++x) {
        if (degree(equations[i], *x) != 1) continue;
        const MPoly slope = coefficients(equations[i], *x)[1];
        if (is_constant(slope) == constant && where.is_nonzero(slope)) return Line{i, *x};
      }
    }
  return std::nullopt;
}

} // namespace

SolvedSet solve(const ParameterSet& where) {
  SolvedSet s{{}, where.equations()};
  while (const auto line = linear_equation(s.left, where)) {
    const auto c = coefficients(s.left[line->equation], line->variable);
    const Substitution step{{line->variable, -(MFraction(c[0]) / MFraction(c[1]))}};
    s.left.erase(s.left.begin() + static_cast<long>(line->equation));
    for (auto& [i, value] : s.values)
      value = substitute(value, step);
    s.values.insert(*step.begin());
    for (MPoly& p : s.left)
      p = substitute(p, step).num();
    std::erase_if(s.left, [](const MPoly& p) { return is_zero(p); });
  }
  return s;
}

std::vector<ParameterSet> by_factors(const ParameterSet& where, const MayVanish& may_vanish) {
  for (const MPoly& p : solve(where).left) {
    const auto factors = factor(p).second;
    if (factors.size() < 2) continue;
    Sets parts, rest{where};
    for (const MFactor& f : factors)
      for (const ParameterSet& left : std::exchange(rest, {})) {
        SetParts cut = split_set(left, {f.base}, {}, may_vanish);
        append(parts, std::move(cut.inside));
        append(rest, std::move(cut.outside));
      }
    return parts; // p vanishes on all of the set: nothing is left outside
  }
  return {where};
}

} // namespace kov
