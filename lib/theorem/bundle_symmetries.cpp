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
BundleSymmetries::BundleSymmetries(const BundleFamily& family, std::string file,
                                   const Budget& budget)
    : family_(family), file_(std::move(file)), budget_(budget),
      is_plain_(family.family().is_plain()) {
  if (!is_plain_) return;
  const System& s = family.system();
  try {
    for (const FamilySymmetry& one : family_symmetries(s, budget))
      if (!one.parameters.empty() && keeps_assumptions(s, one)) add(equivalence(s, one), {});
  } catch (const DomainError&) {
    clear();
  }
}

void BundleSymmetries::add(const Equivalence& e, const ParameterValues& at) {
  const System& x = family_.system();
  One one;
  one.place.at = at;
  auto names = family_.ring()->names();
  if (e.root) {
    const std::string square = to_string(e.square);
    names.push_back(e.ring->name(*e.root));
    one.square = transfer(MFraction(e.square), family_.ring()).num();
    one.place.roots.emplace_back(names.back(), square);
    one.place.conditions.push_back(square + " > 0");
  }
  const Ring ring = e.root ? make_ring(names) : family_.ring();
  for (std::size_t j = 0; j < x.field.dimension(); ++j)
    one.place.as.emplace_back(x.field.name(j), to_string(e.phase[j]));
  for (const auto& [i, value] : e.parameters) {
    one.place.as.emplace_back(e.ring->name(i), to_string(value));
    one.values[ring->index(e.ring->name(i))] = transfer(value, ring);
    if (!e.root || !is_zero(value)) continue; // where it is 0 nothing need be turned
    one.place.conditions.push_back(e.ring->name(i) + " != 0");
    const MPoly moved = MPoly::variable(family_.ring(), family_.ring()->index(e.ring->name(i)));
    one.conditions.push_back({moved, Sign::nonzero});
  }
  if (!at.empty()) {
    const System base = read_system(file_, at);
    const auto all = family_.placed(at, base, {}).conditions();
    one.conditions.insert(one.conditions.begin(), all.begin(), all.end());
    for (const auto& [name, text] : at) {
      one.place.as.emplace_back(name, text);
      one.values[ring->index(name)] = transfer(base.values.at(name), ring);
    }
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
      const MFraction value = -MFraction(line[0]) / MFraction(line[1]);
      const std::string& name = family_.ring()->name(i);
      const ParameterValues at{{name, to_string(value)}};
      if (!is_among(at, tried_)) {
        tried_.push_back(at);
        tried<DomainError, InputError, OutOfBudget>([&] { // there is none then
          const System there = at_values(s, {{s.ring()->index(name), transfer(value, s.ring())}});
          if (const auto frame = find_frame(there, budget_); frame && frame->to.real)
            add(frame->to, at);
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
    if (is_zero(c.p) || !one.square) {
      all.push_back({is_zero(c.p) ? c.p : substitute(c.p, one.values).num(), c.sign});
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

Json::Object BundleSymmetries::step(const One& one) const {
  const System& x = family_.system();
  const ParameterValues& at = one.place.at;
  const Located found = locate(file_, file_, x, one.place);
  if (!found.objection.empty() || !found.map) throw DomainError(found.objection);
  const System base = at.empty() ? x : read_system(file_, at);
  std::vector<Condition> region;
  if (one.square) region.push_back(one.conditions.back());
  const PartPlace here = family_.placed(at, base, region);
  Json::Object members{{"system", json_text(family_.name())}};
  if (!at.empty()) members.emplace_back("at", here.values);
  if (!region.empty()) members.emplace_back("region", json_conditions(region));
  const certify::Target y = certify::target_of(family_.family(), {}, one.square.has_value());
  for (auto& m : map_members(family_, here, *found.map, y, budget_))
    members.push_back(std::move(m));
  return members;
}

std::optional<std::size_t> BundleSymmetries::use(std::size_t s) {
  if (const auto known = used_.find(s); known != used_.end()) return known->second;
  return used_[s] = tried<DomainError, InputError>([&]() -> std::optional<std::size_t> {
           steps_.push_back(step(all_[s]));
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
