#include "theorem/bundle_symmetries.hpp"

#include "certify/equation/facts.hpp"
#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "integrability/specialise.hpp"
#include "moves/frames.hpp"
#include "proof/algebra/arithmetic.hpp"

#include <algorithm>

namespace kov {

Json::Object symmetry_members(const BundleFamily& family, const PartPlace& here,
                              const PlaceMap& map, const Budget& budget) {
  Json::Object all{{"system", json_text(family.name())}};
  if (!here.put.empty()) all.emplace_back("at", here.values);
  if (!here.region.empty()) all.emplace_back("region", json_conditions(here.region));
  const certify::Target y = certify::target_of(family.family(), {}, !map.roots.all().empty());
  std::ranges::move(map_members(family, here, map, y, budget), std::back_inserter(all));
  return all;
}

BundleSymmetries::BundleSymmetries(const BundleFamily& family, const Budget& budget)
    : family_(family), budget_(budget), is_plain_(family.family().is_plain()) {
  if (!is_plain_) return;
  const System& s = family.system();
  try {
    for (const FamilySymmetry& one : family_symmetries(s, budget))
      if (!one.parameters.empty() && keeps_assumptions(s, one)) add(equivalence(s, one), {});
  } catch (const DomainError&) {
    clear();
  }
}

void BundleSymmetries::add(const Equivalence& e, const Substitution& at) {
  const System& x = family_.system();
  One one{at, {e.ring, Roots(), {}, {}, e.bracket, e.time}, {}, {}, {}};
  Substitution moved = e.parameters;
  for (const auto& [i, value] : at)
    moved[x.ring()->index(family_.ring()->name(i))] = value;
  for (std::size_t j = 0; j < x.field.dimension(); ++j) {
    one.map.values.emplace(x.field.name(j), e.phase[j]);
    one.map.jacobian.emplace_back();
    for (const std::size_t k : x.field.coordinates)
      one.map.jacobian.back().push_back(derivative(e.phase[j], k));
  }
  for (const std::size_t i : x.field.parameters) {
    const auto value = moved.find(i);
    one.map.values.emplace(x.ring()->name(i), value == moved.end()
                                                  ? MFraction::variable(e.ring, i)
                                                  : transfer(value->second, e.ring));
  }
  auto names = family_.ring()->names();
  if (e.root) {
    names.push_back(e.ring->name(*e.root));
    one.map.roots = Roots({{*e.root, transfer(MFraction(e.square), e.ring)}});
    one.square = transfer(MFraction(e.square), family_.ring()).num();
    one.conditions = family_.placed(at, {}).conditions();
  }
  const Ring ring = e.root ? make_ring(names) : family_.ring();
  for (const auto& [i, value] : moved) {
    const std::size_t j = ring->index(x.ring()->name(i));
    one.values[j] = transfer(value, ring);
    if (e.root && is_zero(value) && !at.contains(j)) // where it is 0 nothing need be turned
      one.conditions.push_back({MPoly::variable(family_.ring(), j), Sign::nonzero});
  }
  const auto is_known = [&](const One& x) {
    return x.values == one.values && x.conditions == one.conditions;
  };
  if (std::ranges::none_of(all_, is_known)) all_.push_back(std::move(one));
}

void BundleSymmetries::look_for_rotations(const std::vector<Condition>& region) {
  constexpr std::size_t most = 8;
  const System& s = family_.system();
  for (const Condition& c : region) {
    if (!is_plain_ || c.sign != Sign::zero || tried_.size() == most) continue;
    for (const std::size_t i : used_variables(c.p)) {
      const auto line = coefficients(c.p, i);
      if (line.size() != 2 || !is_constant(line[1]) || is_zero(line[0])) continue;
      const Substitution at{{i, -MFraction(line[0]) / MFraction(line[1])}};
      if (!is_among(at, tried_)) {
        tried_.push_back(at);
        tried<DomainError, InputError, OutOfBudget>([&] { // there is none then
          const auto frame = find_frame(at_values(s, family_.in_system(at)), budget_);
          if (frame && frame->to.real) add(frame->to, at);
        });
      }
      break;
    }
  }
}

std::vector<Condition> BundleSymmetries::before(const One& one,
                                                const std::vector<Condition>& region) const {
  const Ring& ring = family_.ring();
  std::vector<Condition> all;
  for (const Condition& c : region) {
    if (!one.square) {
      all.push_back({substitute(c.p, one.values).num(), c.sign});
      continue;
    }
    const Ring& larger = one.values.begin()->second.ring();
    const MFraction there = substitute(transfer(MFraction(c.p), larger), one.values);
    const std::size_t root = larger->size() - 1;
    MPoly half[2] = {MPoly(ring), MPoly(ring)};
    if (!is_zero(there)) {
      const auto rows = coefficients(there.num(), root);
      for (std::size_t k = rows.size(); k-- > 0;) {
        half[k % 2] = half[k % 2] * *one.square;
        if (!is_zero(rows[k])) half[k % 2] = half[k % 2] + transfer(MFraction(rows[k]), ring).num();
      }
    }
    const auto& [even, odd] = half;
    if (is_zero(odd))
      all.push_back({even, c.sign});
    else if (c.sign == Sign::nonzero)
      all.push_back({even * even - odd * odd * *one.square, c.sign});
    else
      throw DomainError("a condition that depends on a root");
  }
  all.insert(all.end(), one.conditions.begin(), one.conditions.end());
  return all;
}

std::vector<BundleSymmetries::Word>
BundleSymmetries::before(const std::vector<Condition>& region) const {
  std::vector<Word> words;
  for (std::size_t s = 0; s < all_.size(); ++s)
    tried<DomainError>([&] {
      const Word one{{s}, before(all_[s], region)};
      words.push_back(one);
      for (std::size_t next = 0; all_[s].square && next < all_.size(); ++next)
        if (!all_[next].square) words.push_back({{s, next}, before(all_[next], one.conditions)});
    });
  return words;
}

std::optional<std::size_t> BundleSymmetries::use(std::size_t s) {
  if (const auto known = used_.find(s); known != used_.end()) return known->second;
  return used_[s] = tried<DomainError, InputError>([&]() -> std::optional<std::size_t> {
           const One& one = all_[s];
           std::vector<Condition> region;
           if (one.square) region.push_back(one.conditions.back());
           const PartPlace here = family_.placed(one.at, std::move(region));
           steps_.push_back(symmetry_members(family_, here, one.map, budget_));
           return steps_.size() - 1;
         });
}

std::optional<std::vector<std::size_t>>
BundleSymmetries::use(const std::vector<std::size_t>& letters) {
  std::vector<std::size_t> word;
  for (const std::size_t s : letters) {
    const auto k = use(s);
    if (!k) return std::nullopt;
    word.push_back(*k);
  }
  return word;
}

} // namespace kov
