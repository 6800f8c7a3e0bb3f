#include "theorem/strata.hpp"

#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "theorem/bundle_family.hpp"
#include "theorem/prove.hpp"
#include "theorem/setting.hpp"

#include <algorithm>

namespace kov {
std::vector<Assumptions> regions_of(const NodeResult& n) {
  return n.regions.empty() ? std::vector<Assumptions>{n.region} : n.regions;
}

namespace {

void add_set(const std::string& text, std::vector<std::string>& all) { add_once(all, text); }

// Each set that the sentence leaves out is named.
std::string statement_of_strata(const std::vector<IntegralClass>& excluded,
                                const std::vector<std::string>& integrable,
                                const std::vector<std::string>& open) {
  if (excluded.empty())
    return " is integrable" +
           (open.empty() ? std::string()
                         : " where " + joined(integrable, ", or ") + "; nothing is said elsewhere");
  std::string text = " is not integrable with " + first_integrals(excluded);
  if (!integrable.empty())
    text += ", except in these cases, where it is: " + joined(integrable, ", or ");
  if (!open.empty())
    text += std::string(integrable.empty() ? ", except" : ", and except") +
            " in these cases, of which nothing is said: " + joined(open, ", or ");
  return text;
}

} // namespace

void prove_cover_of_strata(NodeResult& n, const TheoremResult& result, const std::string& directory,
                           const std::stop_token& stop) {
  const BundleFamily whole(system_of(result.theorem, directory), result.theorem.system);
  Budget budget;
  budget.stop = stop;
  budget.give(2e9);
  std::vector<RegionOfPart> regions;
  std::vector<std::string> integrable, open;
  n.excluded.clear();
  for (std::size_t k = 0; k < n.node.needs.size(); ++k) {
    const NodeResult& part = *node_with(result, n.node.needs[k]);
    if (part.node.kind != NodeKind::open_part &&
        (part.says == Conclusion::none ||
         (part.status != NodeStatus::proved && part.status != NodeStatus::trusted)))
      continue;
    n.excluded.insert(n.excluded.end(), part.excluded.begin(), part.excluded.end());
    for (const Assumptions& r : regions_of(part)) {
      RegionOfPart one{k, std::nullopt, {}};
      for (const Condition& c : r.conditions)
        one.conditions.push_back(whole.moved(c));
      regions.push_back(std::move(one));
      const std::string text = r.conditions.empty() ? "all parameters" : to_string(r.conditions);
      if (part.says == Conclusion::has_integral) add_set("(" + text + ")", integrable);
      if (part.node.kind == NodeKind::open_part) add_set("(" + text + ")", open);
    }
  }
  std::vector<Condition> gap;
  const auto tree =
      tree_of_regions(whole.proof(budget), whole.assumptions(), regions, budget, &gap);
  if (!tree) {
    n.status = NodeStatus::open;
    n.summary = "it was not shown that the steps cover the parameters: what of " +
                (gap.empty() ? std::string("all of them") : to_string(gap)) + "?";
    return;
  }
  if (integrable.empty() && n.excluded.empty()) {
    n.status = NodeStatus::open;
    n.summary = "no step says anything of the parameters";
    return;
  }
  n.status = NodeStatus::proved;
  n.excluded = at_once(n.excluded);
  n.checks.push_back({"the strata of the steps cover the parameters", true});
  n.summary =
      "the strata of " + std::to_string(n.node.needs.size()) + " steps cover the parameters";
  if (!open.empty()) n.summary += ", and nothing is said of " + joined(open, ", or ");
  n.says = n.excluded.empty() ? Conclusion::has_integral : Conclusion::not_integrable;
  n.statement = assumptions_of(whole.system()) + "The system" +
                statement_of_strata(n.excluded, integrable, open);
}

} // namespace kov
