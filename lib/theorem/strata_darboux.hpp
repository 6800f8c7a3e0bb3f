#pragma once
// Parts that Darboux points exclude, region by region.

#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "theorem/darboux_step.hpp"
#include "theorem/strata_parts.hpp"

namespace kov {

class DarbouxParts {
public:
  explicit DarbouxParts(StrataParts& s) : s_(s) {}

  /// The regions that have no certificate of their own, and why; nothing: all of the node has one.
  std::optional<NodeResult> operator()(const NodeResult& n, std::string& why) {
    Left left;
    std::set<std::string> known;
    for (const Assumptions& r : regions_of(n)) {
      if (!known.insert(to_string(r.conditions)).second) continue;
      Budget little = s_.budget;
      constexpr double most_work = 6e8;
      if (!little.work_end || meter() + most_work < *little.work_end) little.give(most_work);
      const CaseProof proof(s_.family.proof(little));
      constexpr int most_cases = 8;
      put_darboux(n, r, proof, most_cases, left);
    }
    if (left.regions.empty()) return std::nullopt;
    why = n.node.darboux.empty() ? "" : joined(left.whys, "; ");
    NodeResult rest = n;
    rest.regions = std::move(left.regions);
    return rest;
  }

  TheoremsOfSteps theorems; ///< by Darboux points, in whole or in part

private:
  /// Regions without a certificate, and why.
  struct Left {
    std::vector<Assumptions> regions;
    std::vector<std::string> whys;
  };
  // A polynomial of which no proof is found that it is not 0 is so in one case, and 0 in the other, where
  // another chart may do.
  void put_darboux(const NodeResult& n, const Assumptions& r, const CaseProof& proof, int cases,
                   Left& left) {
    const PartPlace x = s_.solved(r);
    const auto no = put_darboux(n, x, proof);
    if (!no) return;
    const auto f = cases > 0 ? unknown_factor(no->unknown, x.given) : std::nullopt;
    if (!f) {
      left.regions.push_back(r);
      return add_once(left.whys, sentence(*no));
    }
    for (const Sign sign : {Sign::nonzero, Sign::zero}) {
      Assumptions part = r;
      part.conditions.push_back({*f, sign});
      put_darboux(n, part, proof, cases - 1, left);
    }
  }
  // An irreducible factor of which the region says nothing, of the lowest degree.
  static std::optional<MPoly> unknown_factor(const std::vector<MPoly>& all,
                                             const std::vector<Condition>& given) {
    std::optional<MPoly> best;
    for (const MPoly& f : all)
      for (const MFactor& g : factor(f).second)
        if (std::ranges::none_of(
                given, [&](const Condition& c) { return c.p == g.base || c.p == -g.base; }) &&
            (!best || total_degree(g.base) < total_degree(*best)))
          best = g.base;
    return best;
  }
  // Why there is no certificate, if there is none.
  std::optional<NoDarbouxStep> put_darboux(const NodeResult& n, const PartPlace& x,
                                           const CaseProof& proof) {
    using certify::PotentialPart;
    std::vector<PotentialPart> parts{n.node.part == "highest"  ? PotentialPart::highest
                                     : n.node.part == "lowest" ? PotentialPart::lowest
                                                               : PotentialPart::all};
    // A leading part excludes rational integrals only: it is used if no more is said than that.
    if (n.node.darboux.empty() && excludes_rational_only()) parts.push_back(PotentialPart::highest);
    const bool relation = n.node.darboux != "multiple";
    std::optional<NoDarbouxStep> why;
    for (const PotentialPart part : parts)
      for (const bool first : {true, false}) {
        auto no = put_darboux(n, x, proof, {first == relation, part});
        if (!no) return std::nullopt;
        const bool other_may_do = no->depends == NoDarbouxStep::Depends::on_statement;
        if (first && (!why || why->why < no->why)) why = std::move(no);
        if (!other_may_do) break;
      }
    return why;
  }
  [[nodiscard]] bool excludes_rational_only() const {
    return std::ranges::any_of(s_.theorem.nodes, [](const NodeResult& n) {
      return !n.node.part.empty() && n.node.part != "all";
    });
  }
  std::optional<NoDarbouxStep> put_darboux(const NodeResult& n, const PartPlace& x,
                                           const CaseProof& proof, const DarbouxSaid& said) {
    try {
      auto found = darboux_members(x, x.given, said, proof);
      if (const auto* no = std::get_if<NoDarbouxStep>(&found)) return *no;
      const std::string id = n.node.id + "-" + std::to_string(++steps_[n.node.id]);
      s_.put_step(id, "darboux",
                  {{"system", json_text(s_.family.name())},
                   {"at", x.values},
                   {"region", json_conditions(x.region)}},
                  std::get<Json::Object>(std::move(found)));
      s_.add_region(id, x.conditions());
      note_theorems(theorems[n.node.id], said);
      return std::nullopt;
    } catch (const OutOfBudget&) {
      s_.budget.check(); // of the whole
      return NoDarbouxStep{NoDarbouxStep::Why::limit};
    }
  }
  static void note_theorems(std::vector<const LiteratureTheorem*>& all, const DarbouxSaid& by) {
    add_once(all, by.relation ? &morales_ramis() : &morales_ramis_simo());
    if (by.part == certify::PotentialPart::highest) add_once(all, &ziglin_highest());
    if (by.part == certify::PotentialPart::lowest) add_once(all, &ziglin_lowest());
  }

  StrataParts& s_;
  std::map<std::string, std::size_t> steps_; ///< of a node
};

} // namespace kov
