#include "integrals/stratum.hpp"

#include "system/vector_field.hpp"

#include <algorithm>

namespace kov {

ParameterSet::ParameterSet(Ring ring, std::vector<std::size_t> parameters, Budget budget)
    : ring_(std::move(ring)), parameters_(std::move(parameters)), budget_(std::move(budget)) {}

void ParameterSet::renew() {
  known_.clear();
  if (!zero_.empty()) ideal_.emplace(ring_, parameters_, zero_, nonzero_, budget_);
}

ParameterSet ParameterSet::where_zero(const MPoly& p) const {
  ParameterSet s = *this;
  const MFraction here = restrict(p);
  s.zero_.push_back(is_zero(here) ? p : squarefree_part(here.num()));
  s.renew();
  return s;
}

ParameterSet ParameterSet::where_nonzero(const MPoly& p) const {
  ParameterSet s = *this;
  for (const MFactor& f : factor(p).second)
    if (!s.irreducible_is_nonzero(f.base)) s.nonzero_.push_back(f.base);
  s.renew();
  return s;
}

bool ParameterSet::is_empty() const { return ideal_ && ideal_->is_unit(); }

MFraction ParameterSet::restrict(const MPoly& f) const {
  if (!ideal_ || is_zero(f)) return f;
  return ideal_->normal_form(MFraction(f));
}

bool ParameterSet::irreducible_is_nonzero(const MPoly& f) const {
  if (std::find(nonzero_.begin(), nonzero_.end(), f) != nonzero_.end()) return true;
  if (!ideal_) return false; // without equations f vanishes somewhere else, by the Nullstellensatz
  const auto [place, is_new] = known_.try_emplace(to_string(f), false);
  if (is_new) {
    auto equations = zero_;
    equations.push_back(f);
    place->second = Ideal(ring_, parameters_, equations, nonzero_, budget_).is_unit();
  }
  return place->second;
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
  std::vector<MPoly> all;
  if (ideal_)
    for (const KPoly& f : ideal_->basis())
      all.push_back(ideal_->from_kpoly(f).num());
  return all;
}

std::vector<MPoly> ParameterSet::proper_inequations() const {
  if (!ideal_) return nonzero_;
  std::vector<MPoly> proper;
  for (const MPoly& f : nonzero_) {
    auto equations = zero_;
    equations.push_back(f);
    const MFraction here = ideal_->normal_form(MFraction(f));
    if (!is_constant(here) && !Ideal(ring_, parameters_, equations, proper, budget_).is_unit())
      proper.push_back(f);
  }
  return proper;
}

} // namespace kov
