#include "theorem/bundle_symmetries.hpp"

#include "certify/equation/facts.hpp"
#include "certify/strata/arithmetic.hpp"
#include "exact/error.hpp"
#include "theorem/bundle_place.hpp"

#include <algorithm>

namespace kov {
namespace {

bool is_real(const StrataFamily& family) {
  const auto& all = family.complex();
  return std::ranges::none_of(all, [](bool x) { return x; });
}

// As the certificate has it: the same inverses and assumptions, in the same order.
bool is_written_alike(const StrataFamily& family, const FamilyWriter& x) {
  if (family.ring()->names() != x.ring()->names()) return false;
  const auto& inverses = family.phase().inverses;
  if (inverses.size() != x.divisors().size()) return false;
  const auto same = [&](const Condition& a, const Condition& b) {
    return a.sign == b.sign && transfer(b.p, family.ring()) == MFraction(a.p);
  };
  const auto &ours = family.assumptions(), &theirs = x.assumptions();
  return std::ranges::equal(ours, theirs, same);
}

} // namespace

BundleSymmetries::BundleSymmetries(const StrataFamily& family, std::string file, std::string name,
                                   const Budget& budget)
    : family_(family), file_(std::move(file)), name_(std::move(name)), budget_(budget) {
  const System& s = family.system();
  if (!s.field.hamiltonian || !s.field.poisson || !s.field.functions.empty() || !is_real(family))
    return;
  try {
    if (!is_written_alike(family, FamilyWriter(s, name_, s.assumptions))) return;
    for (FamilySymmetry& one : family_symmetries(s, budget)) {
      if (one.parameters.empty() || !keeps_assumptions(s, one)) continue;
      Substitution there;
      for (const auto& [i, value] : one.parameters)
        there[family.ring()->index(s.ring()->name(i))] = transfer(value, family.ring());
      parameters_.push_back(std::move(there));
      all_.push_back(std::move(one));
    }
  } catch (const DomainError&) {
    all_.clear();
  }
}

std::vector<Condition> BundleSymmetries::before(std::size_t s,
                                                const std::vector<Condition>& region) const {
  std::vector<Condition> all;
  for (const Condition& c : region)
    all.push_back({is_zero(c.p) ? c.p : substitute(c.p, parameters_[s]).num(), c.sign});
  return all;
}

Json::Object BundleSymmetries::step(std::size_t s) const {
  const System& x = family_.system();
  const Equivalence e = equivalence(x, all_[s]);
  Place place;
  for (std::size_t j = 0; j < x.field.dimension(); ++j)
    place.as.emplace_back(x.field.name(j), to_string(e.phase[j]));
  for (const auto& [i, value] : e.parameters)
    place.as.emplace_back(e.ring->name(i), to_string(value));
  const Located found = locate(file_, file_, x, place);
  if (!found.objection.empty() || !found.map) throw DomainError(found.objection);
  FamilyWriter writer(x, name_, x.assumptions);
  Json::Object members{{"system", json_text(name_)}};
  for (auto& m : map_members(writer, {}, x, *found.map, {}, target_of(writer, {}, false), budget_))
    members.push_back(std::move(m));
  return members;
}

std::optional<std::size_t> BundleSymmetries::use(std::size_t s) {
  if (const auto known = used_.find(s); known != used_.end()) return known->second;
  try {
    steps_.push_back(step(s));
    return used_[s] = steps_.size() - 1;
  } catch (const DomainError&) {
    return used_[s] = std::nullopt;
  } catch (const InputError&) {
    return used_[s] = std::nullopt;
  }
}

} // namespace kov
