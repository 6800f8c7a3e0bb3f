#include "integrals/stratum.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "system/vector_field.hpp"

#include <algorithm>
#include <numeric>

namespace kov {

ParameterSet::ParameterSet(Ring ring, std::vector<std::size_t> parameters, Budget budget)
    : ring_(std::move(ring)), parameters_(std::move(parameters)), budget_(std::move(budget)) {}

namespace {

// The equations say what some parameters are, as polynomials in the others: all others are free.
bool is_graph(const Ideal& ideal) {
  return std::ranges::all_of(ideal.basis(), [](const KPoly& f) {
    const Monomial& lead = f.begin()->first;
    return std::accumulate(lead.begin(), lead.end(), 0UL) == 1;
  });
}

std::vector<MPoly> numerators(const Ideal& ideal) {
  std::vector<MPoly> all;
  for (const KPoly& f : ideal.basis())
    all.push_back(ideal.from_kpoly(f).num());
  return all;
}

} // namespace

// The inequations as functions where the equations hold: their product is smaller then; and a prime ideal needs none.
Ideal ParameterSet::ideal_of(const std::vector<MPoly>& equations) const {
  Ideal ideal(ring_, parameters_, equations, {}, budget_);
  std::vector<MPoly> factors;
  for (const MPoly& g : nonzero_) {
    const MPoly here = ideal.normal_form(MFraction(g)).num();
    if (is_zero(here)) return {ring_, parameters_, {MPoly(ring_, Integer(1))}, {}, budget_};
    for (MFactor& x : factor(here).second)
      add_once(factors, std::move(x.base));
  }
  if (factors.empty() || is_graph(ideal)) return ideal;
  return {ring_, parameters_, numerators(ideal), factors, budget_};
}

void ParameterSet::add_equation(MPoly p) {
  auto all = equations(); // a basis of what was there: less work than the equations as they came
  all.push_back(std::move(p));
  known_.clear();
  factors_.reset();
  ideal_.emplace(ideal_of(all));
}

// I : (f g)^infinity = (I : f^infinity) : g^infinity, and a prime ideal without f stays as it is.
void ParameterSet::add_inequations(const std::vector<MPoly>& p) {
  nonzero_.insert(nonzero_.end(), p.begin(), p.end());
  std::erase_if(known_, [](const auto& entry) { return !entry.second; });
  factors_.reset();
  if (!ideal_ || p.empty()) return;
  const bool is_prime = is_graph(*ideal_);
  if (is_prime && std::ranges::none_of(p, [&](const MPoly& f) { return is_zero(restrict(f)); }))
    return;
  ideal_.emplace(ring_, parameters_, equations(), p, budget_);
}

ParameterSet ParameterSet::where_zero(const MPoly& p) const {
  ParameterSet s = *this;
  const MFraction here = restrict(p);
  s.add_equation(is_zero(here) ? p : squarefree_part(here.num()));
  return s;
}

ParameterSet ParameterSet::where_nonzero(const MPoly& p) const {
  ParameterSet s = *this;
  std::vector<MPoly> fresh;
  for (const MFactor& f : factor(p).second)
    if (!s.irreducible_is_nonzero(f.base)) fresh.push_back(f.base);
  s.add_inequations(fresh);
  return s;
}

bool ParameterSet::is_empty() const { return ideal_ && ideal_->is_unit(); }

MFraction ParameterSet::restrict(const MPoly& f) const {
  if (!ideal_ || is_zero(f)) return f;
  return ideal_->normal_form(MFraction(f));
}

// The irreducible factors of the inequations, as functions on a graph.
const std::vector<MPoly>& ParameterSet::factors_of_inequations() const {
  if (factors_) return *factors_;
  factors_.emplace();
  for (const MPoly& g : nonzero_)
    for (MFactor& x : factor(restrict(g).num()).second)
      factors_->push_back(std::move(x.base));
  return *factors_;
}

bool ParameterSet::irreducible_is_nonzero(const MPoly& f) const {
  if (is_among(f, nonzero_)) return true;
  if (!ideal_) return false; // without equations f vanishes somewhere else, by the Nullstellensatz
  const auto [place, is_new] = known_.try_emplace(to_string(f), false);
  if (!is_new) return place->second;
  if (is_empty()) return place->second = true;
  if (!is_graph(*ideal_)) {
    auto all = equations();
    all.push_back(f);
    return place->second = ideal_of(all).is_unit();
  }
  // a polynomial in the free parameters vanishes only where others do: by the Nullstellensatz each of its
  // factors divides one of theirs
  const MFraction here = restrict(f);
  if (is_zero(here)) return false;
  const auto& known = factors_of_inequations();
  const auto factors = factor(here.num()).second;
  return place->second = std::ranges::all_of(
             factors, [&](const MFactor& x) { return is_among(x.base, known); });
}

bool ParameterSet::vanishes(const MPoly& f) const {
  return is_zero(restrict(f)) || where_nonzero(f).is_empty(); // the ideal need not be radical
}

bool ParameterSet::is_nonzero(const MPoly& f) const {
  return !is_zero(f) && doubtful_factors(f).empty();
}

std::vector<MPoly> ParameterSet::doubtful_factors(const MPoly& f) const {
  std::vector<MPoly> doubtful;
  if (is_constant(f)) return doubtful;
  for (const MFactor& x : factor(f).second)
    if (!irreducible_is_nonzero(x.base)) doubtful.push_back(x.base);
  return doubtful;
}

std::vector<MPoly> ParameterSet::equations() const {
  return ideal_ ? numerators(*ideal_) : std::vector<MPoly>{};
}

std::vector<MPoly> ParameterSet::proper_inequations() const {
  if (!ideal_) return nonzero_;
  std::vector<MPoly> proper, factors;
  for (const MPoly& f : nonzero_) {
    const MFraction here = restrict(f);
    if (is_constant(here)) continue;
    if (is_graph(*ideal_)) { // polynomials in the free parameters: said are those with a new factor
      bool is_new = false;
      for (MFactor& x : factor(here.num()).second)
        if (!is_among(x.base, factors)) {
          factors.push_back(std::move(x.base));
          is_new = true;
        }
      if (is_new) proper.push_back(f);
      continue;
    }
    auto equations = this->equations();
    equations.push_back(f);
    // at a limit: true, and said though it may follow
    if (!tried<OutOfBudget>(
            [&] { return Ideal(ring_, parameters_, equations, proper, budget_).is_unit(); }))
      proper.push_back(f);
  }
  return proper;
}

} // namespace kov
