// A theorem about strata of complex parameters as one certificate: theorem_certificates.md 11 to 16.

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "theorem/prove.hpp"
#include "theorem/setting.hpp"
#include "theorem/strata_cases.hpp"
#include "theorem/strata_common.hpp"
#include "theorem/strata_cover.hpp"
#include "theorem/strata_darboux.hpp"
#include "theorem/strata_integrable.hpp"
#include "theorem/strata_scaled.hpp"
#include "theorem/strata_splitting.hpp"

#include <algorithm>
#include <utility>

namespace kov {
namespace {

class StrataBundle {
public:
  StrataBundle(TheoremResult& t, std::string directory,
               const std::map<std::string, std::string>& refused, const ProveOptions& options)
      : t_(t), refused_(refused), options_(options),
        s_(t, std::move(directory), options.decide.budget), darboux_(s_), common_(s_), case_(s_),
        scaled_(s_), splitting_(s_), integrable_(s_), cover_(s_, refused.contains(all_symmetries)) {
  }

  [[nodiscard]] bool has_symmetries() const { return cover_.has_symmetries(); }

  TheoremBundle operator()() {
    const NodeResult& root = cover_of_all(t_);
    certify::Arithmetic a;
    const Json family = s_.family.json();
    static_cast<void>(
        certify::read_family(certify::Node(family, s_.family.name(), rationals()), a));
    for (const NodeResult& n : t_.nodes)
      if (n.on_trust) cover_.look_for_rotations(n);
    std::vector<NodeResult*> carried; // into the others
    for (NodeResult& n : t_.nodes)
      if (is_among(n.node.id, root.node.needs))
        n.node.found.carried ? carried.push_back(&n) : put_part(n);
    for (NodeResult* n : carried)
      put_part(*n);
    cover_.put_groups();
    if (std::ranges::all_of(s_.parts, [](const auto& id) { return id == "open"; }))
      throw DomainError(
          "it would say nothing: what is proved has conditions that no polynomial says");
    cover_.put_cover(root);
    return {.json = s_.text(&BundleFamily::json),
            .on_trust = std::move(s_.on_trust),
            .carried = std::move(carried_),
            .by_points = std::move(darboux_.theorems)};
  }

private:
  void put_part(NodeResult& n) {
    if (n.node.kind == NodeKind::open_part) return cover_.put_open(n);
    if (n.says == Conclusion::none) return;
    if (!n.on_trust && !refused_.contains(n.node.id)) {
      const auto why = not_put(n);
      if (!why || cover_.put_image(n) || !scaled_(n)) return;
      if (n.node.found.studies.empty() && !n.node.found.carried) return cover_.put_trusted(n, *why);
      study_again(n, s_.directory, options_);
      return put_part(n);
    }
    const auto no = refused_.find(n.node.id);
    const std::string why = no == refused_.end() ? "" : no->second;
    if (n.says == Conclusion::not_integrable && no == refused_.end()) return put_special(n);
    cover_.put_trusted(n, why);
  }

  // Why there is no step for it, if there is none.
  std::optional<std::string> not_put(const NodeResult& n) {
    try {
      if (n.node.found.change) throw DomainError("it is about the system in other variables");
      n.says == Conclusion::has_integral ? integrable_(n) : case_(n, s_.place_of(n));
      return std::nullopt;
    } catch (const DomainError& why) {
      return why.what();
    } catch (const InvalidArgument& why) {
      return why.what();
    } catch (const certify::Refused& why) {
      return why.why;
    }
  }

  void put_special(const NodeResult& n) {
    if (n.node.found.splitting) {
      tried<DomainError, certify::Refused>([&] { splitting_(n); });
      if (cover_.put_image(n)) return carried_.push_back(n.node.id);
    }
    std::string why;
    auto left = scaled_(n);
    if (left) left = common_(*left);
    if (!left || left->regions.size() < regions_of(n).size())
      add_once(darboux_.theorems[n.node.id], &morales_ramis());
    if (left) left = darboux_(*left, why);
    if (left) left = common_(*left); // they may leave values of parameters
    left ? cover_.put_what_is_left(*left, why) : carried_.push_back(n.node.id);
  }

  TheoremResult& t_;
  const std::map<std::string, std::string>& refused_;
  const ProveOptions& options_;
  StrataParts s_;
  DarbouxParts darboux_;
  CommonParts common_;
  CaseParts case_;
  ScaledParts scaled_;
  SplittingParts splitting_;
  IntegrableParts integrable_;
  CoverOfParts cover_;
  std::vector<std::string> carried_;
};

} // namespace

TheoremBundle bundle_of_strata(TheoremResult& t, const std::string& directory,
                               const std::map<std::string, std::string>& refused,
                               const ProveOptions& options) {
  StrataBundle bundle(t, directory, refused, options);
  try {
    return bundle();
  } catch (const DomainError&) {
    if (!bundle.has_symmetries()) throw;
  }
  auto none = refused;
  none.emplace(all_symmetries, "the cover");
  return StrataBundle(t, directory, none, options)();
}

} // namespace kov
