#include "moves/scale.hpp"

#include "exact/linear.hpp"
#include "exact/lists.hpp"
#include "integrability/parameters.hpp"
#include "integrability/specialise.hpp"
#include "moves/scalings.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr std::size_t most_parameters = 8; // subsets of them are tried

// Each with its weights for these parameters in this order.
Matrix of_these(const std::vector<std::size_t>& parameters, const Matrix& all) {
  Matrix some;
  for (const auto& weights : all) {
    some.emplace_back();
    for (const std::size_t p : parameters)
      some.back().push_back(weights[p]);
  }
  return some;
}

// Reduced rows with 1 at the chosen columns; unset: they are not independent there.
std::optional<Matrix> solved_for(Matrix rows, const std::vector<std::size_t>& columns) {
  if (columns.size() > rows.size()) return std::nullopt;
  if (row_reduce(rows, columns) != columns) return std::nullopt;
  rows.resize(columns.size());
  return rows;
}

bool are_integers(const Matrix& rows) {
  return std::ranges::all_of(rows, [](const auto& row) {
    return std::ranges::all_of(
        row, [](const MFraction& x) { return is_zero(x) || is_integer(to_rational(x)); });
  });
}

MFraction power(const MFraction& x, long e) {
  MFraction all(x.ring(), Rational(1));
  for (long i = 0; i < (e < 0 ? -e : e); ++i)
    all = e < 0 ? all / x : all * x;
  return all;
}

// Keeps the assumptions that say something of the other parameters whatever the scale: "real" if
// all are.
void keep_assumptions(const System& before, const std::vector<std::size_t>& ones, System& s) {
  const bool positive = std::ranges::all_of(ones, [&](std::size_t i) {
    const MFraction x = MFraction::variable(before.ring(), i);
    return std::ranges::any_of(before.assumptions, [&](const Assumption& a) {
      return a.value == x && a.is(Sign::positive);
    });
  });
  const bool real = std::ranges::all_of(
      ones, [&](std::size_t i) { return before.real.contains(before.ring()->name(i)); });
  if (!real) s.real.clear(); // a real parameter divided by a power of one that is not
  std::vector<Assumption> kept;
  for (Assumption a : s.assumptions) {
    const auto used = used_variables(a.value);
    if (used.size() != 1) continue;
    const MFraction x = MFraction::variable(s.ring(), used.front());
    if (a.value != x && a.value != -x) continue;
    if (a.is(Sign::nonzero) || (a.is(Sort::real) && real) || (a.is_ordered() && positive))
      kept.push_back(a);
    else if (a.is_ordered() && real) {
      a.says = Sort::real;
      kept.push_back(std::move(a));
    }
  }
  s.assumptions = std::move(kept);
}

ScaledSystem at_one(const System& s, const std::vector<std::size_t>& parameters,
                    const std::vector<std::size_t>& columns, const Matrix& weights) {
  ScaledSystem x;
  for (const std::size_t c : columns) {
    x.ones.push_back(parameters[c]);
    x.values[parameters[c]] = MFraction(s.ring(), Rational(1));
  }
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    if (is_among(j, columns)) continue;
    MFraction p = MFraction::variable(s.ring(), parameters[j]);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const MFraction& w = weights[k][j];
      const long e = is_zero(w) ? 0 : to_long(to_rational(w).num());
      p = p * power(MFraction::variable(s.ring(), x.ones[k]), -e);
    }
    x.back[parameters[j]] = p;
  }
  x.values = with_functions(s, std::move(x.values));
  x.system = at_values(s, x.values);
  keep_assumptions(s, x.ones, x.system);
  return x;
}

} // namespace

std::vector<MPoly> ScaledSystem::before(std::vector<MPoly> all) const {
  for (MPoly& f : all)
    f = substitute(MFraction(f), back).num();
  return all;
}

Exclusion ScaledSystem::before(Exclusion e) const {
  static_cast<Cut&>(e) = moved(e, [&](const MFraction& f) { return substitute(f, back); });
  for (const std::size_t i : ones) {
    e.not_all_zero.push_back({MPoly::variable(system.ring(), i)});
    e.by.level.ones.push_back(system.ring()->name(i));
  }
  return e;
}

std::optional<ScaledSystem> scaled(const System& s) {
  const auto levels = level_parameters(s);
  std::vector<std::size_t> parameters;
  for (const std::size_t p : s.field.parameters)
    if (!is_among(p, levels)) parameters.push_back(p);
  if (parameters.empty() || parameters.size() > most_parameters) return std::nullopt;
  const Matrix basis = of_these(parameters, scalings(s));
  std::optional<ScaledSystem> best;
  for (std::size_t set = 1; set < (std::size_t{1} << parameters.size()); ++set) {
    std::vector<std::size_t> columns;
    for (std::size_t j = 0; j < parameters.size(); ++j)
      if ((set >> j & 1U) != 0) columns.push_back(j);
    if (columns.size() > basis.size() || (best && columns.size() <= best->ones.size())) continue;
    const auto weights = solved_for(basis, columns);
    if (weights && are_integers(*weights)) best = at_one(s, parameters, columns, *weights);
  }
  return best;
}

} // namespace kov
