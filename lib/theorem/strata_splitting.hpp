#pragma once
// Parts that the splitting of separatrices excludes (docs/theory/theorem_certificates.md 6).

#include "moves/splitting.hpp"
#include "theorem/bundle_rules.hpp"
#include "theorem/strata_parts.hpp"

namespace kov {

class SplittingParts {
public:
  explicit SplittingParts(StrataParts& s) : s_(s) {}

  /// The bodies with A > B > C; symmetries send those with other orders of their moments there.
  /// Errors  DomainError, Refused: there is no rule for it, or no proof is found
  void operator()(const NodeResult& n) {
    const SplittingFinding& found = *n.node.found.splitting;
    if (!put_.insert(&found).second) return;
    if (!s_.family.family().is_plain()) throw DomainError("complex parameters");
    std::string name = s_.family.name(), id = n.node.id + "-splitting";
    for (const auto& [p, value] : found.at)
      name += ", " + p + " = " + value;
    const std::string file = beside(s_.directory, s_.family.name());
    const BundleFamily& y =
        found.at.empty() ? s_.family : s_.other(read_system(file, found.at), name);
    std::vector<std::string> small;
    for (const auto& [p, weight] : found.small)
      if (weight == 1) small.push_back(ring_of(found)->name(p));
    const EulerPerturbation p = perturbation_of_euler(y.system(), small);
    const std::vector<Condition> region = region_of(found, p, y);
    auto step = splitting_members(y, p, small, region, s_.budget);
    if (found.at.empty()) {
      s_.put_step(id, "splitting", std::move(step));
      return s_.add_region(id, s_.family.placed(Substitution(), region).conditions());
    }
    std::vector<Condition> here;
    for (const Condition& c : region)
      here.push_back(s_.family.moved(c));
    const System base = read_system(file, found.at);
    const PartPlace x = s_.family.placed(found.at, base, std::move(here));
    Json::Object members{{"of", json_text(id)},
                         {"system", json_text(s_.family.name())},
                         {"at", x.values},
                         {"region", json_conditions(x.region)}};
    for (auto& m : map_members(s_.family, x, identity_map(base),
                               certify::target_of(y.family(), region, true), s_.budget))
      members.push_back(std::move(m));
    s_.put_step(id, "splitting", std::move(step));
    id += "-place";
    s_.put_step(id, "place", std::move(members));
    s_.add_region(id, x.conditions());
  }

private:
  static const Ring& ring_of(const SplittingFinding& found) { return found.body.moments[0].ring(); }
  static std::vector<Condition> region_of(const SplittingFinding& found, const EulerPerturbation& p,
                                          const BundleFamily& y) {
    std::vector<MPoly> moments;
    for (const MFraction& inverse : p.inverse_inertia)
      for (const std::size_t i : used_variables(inverse))
        moments.push_back(MPoly::variable(y.ring(), inverse.ring()->name(i)));
    if (moments.size() != 3) throw DomainError("the moments of inertia are not parameters");
    std::vector<Condition> region{{moments[0] - moments[1], Sign::positive},
                                  {moments[1] - moments[2], Sign::positive},
                                  {moments[2], Sign::positive}};
    const auto put_not_all_zero = [&](const std::vector<MPoly>& all) {
      MPoly sum(y.ring());
      for (const MPoly& f : all) {
        const MPoly here = y.moved({f, Sign::nonzero}).p;
        if (all.size() == 1) return region.push_back({here, Sign::nonzero});
        sum = sum + here * here;
      }
      region.push_back({sum, Sign::positive});
    };
    std::vector<MPoly> direction;
    for (const std::size_t i : found.direction)
      direction.push_back(MPoly::variable(ring_of(found), i));
    put_not_all_zero(direction);
    for (const MPoly& f : found.nonzero)
      put_not_all_zero({f});
    for (const OrderOfMoments& one : found.orders)
      if (one.axes == std::array<std::size_t, 3>{0, 1, 2})
        for (const auto& left : one.left)
          put_not_all_zero(left);
    return region;
  }

  StrataParts& s_;
  std::set<const SplittingFinding*> put_;
};

} // namespace kov
