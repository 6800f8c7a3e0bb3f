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
    std::string name = s_.family.name();
    for (const auto& [p, value] : found.at)
      name += ", " + p + " = " + value;
    const System base = read_system(beside(s_.directory, s_.family.name()), found.at);
    StrataParts there(s_, base, name);
    const BundleFamily& y = there.family;
    std::vector<std::string> small;
    for (const auto& [p, weight] : found.small)
      if (weight == 1) small.push_back(ring_of(found)->name(p));
    const EulerPerturbation p = perturbation_of_euler(y.system(), small);
    const std::vector<Condition> region = region_of(found, p, y);
    const PartPlace x = s_.family.placed(found.at, base, s_.family.moved(region));
    const std::string id = n.node.id + "-splitting";
    there.put_step(id, "splitting", splitting_members(y, p, small, region, s_.budget));
    if (!found.at.empty())
      there.put_place(id + "-place", id, s_.family, x, identity_map(base),
                      certify::target_of(y.family(), region, true));
    s_.take(there);
    s_.add_region(id + (found.at.empty() ? "" : "-place"), x.conditions());
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
