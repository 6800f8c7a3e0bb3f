#include "exact/lists.hpp"
#include "parameters/set.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace kov {
namespace {

using Sets = std::vector<Set>;

void append(Sets& all, Sets more) { std::move(more.begin(), more.end(), std::back_inserter(all)); }

// No point of b^2 = 4, b != 2 is left where b >= 0 is assumed.  old: equations that were looked at.
bool has_points(const Set& s, const std::vector<MPoly>& old, const MayVanish& may_vanish) {
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
Halves halves(const Set& where, const MPoly& p, const MayVanish& may_vanish) {
  const MFraction here = where.restrict(p);
  if (is_zero(here)) return {{where}, {}};
  Set rest = where;
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

namespace {

// The statements as they are: what is left of them is looked at when all is cut.
CutParts split_by_polynomials(const Set& where, const Cut& cut, const MayVanish& may_vanish) {
  CutParts parts{{where}, {}};
  for (const MPoly& p : cut.zero) {
    Sets inside;
    for (const Set& s : parts.inside) {
      Halves h = halves(s, p, may_vanish);
      append(inside, std::move(h.zero));
      append(parts.outside, std::move(h.nonzero));
    }
    parts.inside = std::move(inside);
  }
  for (const auto& list : cut.not_all_zero) {
    Sets inside;
    Sets rest = std::move(parts.inside);
    for (const MPoly& p : list) {
      Sets left;
      for (const Set& s : rest) {
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

} // namespace

CutParts split(const Set& where, const Cut& cut, const MayVanish& may_vanish) {
  CutParts parts;
  CutParts whole = split_by_polynomials(where, cut, may_vanish);
  for (const Set& set : whole.outside)
    if (auto part = set.settled()) parts.outside.push_back(*std::move(part));
  for (const Set& set : whole.inside) {
    auto part = set.settled();
    for (const Statement& s : cut.statements) {
      if (!part) break;
      if (auto out = part->where(negation(s))) parts.outside.push_back(*std::move(out));
      part = part->where(s);
    }
    if (part) parts.inside.push_back(*std::move(part));
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

std::vector<MPoly> proper_equations(const Set& where, const std::vector<MPoly>& known) {
  auto all = where.equations();
  if (known.empty()) return all;
  std::ranges::stable_sort(
      all, [](const MPoly& a, const MPoly& b) { return total_degree(a) < total_degree(b); });
  Set so_far = where.plain();
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

std::vector<MPoly> inequations(const Set& where) {
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

bool same_set(const Set& a, const Set& b) {
  return a.equations() == b.equations() && same_elements(inequations(a), inequations(b));
}

bool vanishes(const MPoly& p, const Set& there) { return is_zero(there.restrict(p)); }

// The union, if the two are the halves of a set.
std::optional<Set> union_of(const Set& zero, const Set& nonzero) {
  const auto& equations = nonzero.equations();
  if (!(zero.statements() == nonzero.statements()) ||
      !std::ranges::all_of(equations, [&](const MPoly& f) { return vanishes(f, zero); }))
    return std::nullopt;
  const auto proper = nonzero.proper_inequations();
  for (const MPoly& p : proper) {
    if (!vanishes(p, zero)) continue; // cheap beside what follows
    auto others = proper;
    std::erase(others, p);
    Set whole = nonzero.with_inequations(others);
    if (same_set(whole.where_zero(p), zero)) return whole;
  }
  return std::nullopt;
}

} // namespace

std::vector<Set> united(std::vector<Set> sets) {
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
std::optional<Line> linear_equation(const std::vector<MPoly>& equations, const Set& where) {
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

SolvedSet solve(const Set& where) {
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

std::vector<Set> by_factors(const Set& where, const MayVanish& may_vanish) {
  for (const MPoly& p : solve(where).left) {
    const auto factors = factor(p).second;
    if (factors.size() < 2) continue;
    Sets parts, rest{where};
    for (const MFactor& f : factors)
      for (const Set& left : std::exchange(rest, {})) {
        CutParts cut = split(left, {.zero = {f.base}}, may_vanish);
        append(parts, std::move(cut.inside));
        append(rest, std::move(cut.outside));
      }
    return parts; // p vanishes on all of the set: nothing is left outside
  }
  return {where};
}

} // namespace kov
