#pragma once
// The end of a cover, when its parts with certificates are put: steps on trust, what is open, and the cover itself.

#include "theorem/strata_images.hpp"

namespace kov {

class CoverOfParts {
public:
  /// none: symmetries are not used
  CoverOfParts(StrataParts& s, bool none)
      : s_(s), symmetries_(s.family, s.budget), images_(s, symmetries_) {
    if (none) symmetries_.clear();
  }
  [[nodiscard]] bool has_symmetries() const { return !symmetries_.steps().empty(); }

  void look_for_rotations(const NodeResult& n) {
    for (const auto& region : regions(n))
      symmetries_.look_for_rotations(region);
  }
  /// Symmetries send all of it into parts that say "not integrable".
  [[nodiscard]] bool put_image(const NodeResult& n) {
    return n.says == Conclusion::not_integrable &&
           std::ranges::all_of(regions(n), [&](const auto& region) { return images_.put(region); });
  }
  void put_open(const NodeResult& n) { put_region(n, open_); }
  /// Darboux points have been looked at: what they leave may lie in other parts.
  void put_what_is_left(const NodeResult& n, const std::string& why) {
    put_trusted(n, why);
    looked_at_.insert(n.node.id);
  }
  void put_trusted(const NodeResult& n, const std::string& why) {
    const bool integrable = n.says == Conclusion::has_integral;
    std::string step = n.node.step.empty() ? n.summary : n.node.step;
    if (n.excluded.size() > 1) throw DomainError("a step on trust with several classes");
    const IntegralClass integrals = n.excluded.empty() ? IntegralClass{} : n.excluded.front();
    if (!why.empty() && (!n.on_trust || !n.node.darboux.empty()))
      step += " [no certificate: " + why + "]";
    step = one_line_of(step);
    for (Group& g : trusted_)
      if (g.step == step && g.integrable == integrable && g.on_trust == n.on_trust &&
          g.integrals == integrals)
        return put_region(n, g);
    trusted_.push_back({n.node.id, step, integrable, n.on_trust, integrals, {}});
    put_region(n, trusted_.back());
  }
  void put_groups() {
    drop_what_is_covered();
    put_images_last();
    for (const Group& g : trusted_)
      put_group(g);
    if (open_.regions.empty()) return;
    s_.put_step("open", "open",
                {{"system", json_text(s_.family.name())}, {"regions", put_regions(open_)}});
    s_.parts.emplace_back("open");
  }
  void put_cover(const NodeResult& root) {
    auto tree = tree_of_regions(s_.proof, s_.family.assumptions(), s_.regions, s_.budget);
    if (!tree) throw DomainError("the cover of the parameters was not found");
    s_.put_cover(root.node.id, symmetries_.steps(), *std::move(tree));
  }

private:
  static std::string one_line_of(std::string s) {
    for (char& c : s)
      if (c < ' ' || c > '~') c = '?';
    constexpr std::size_t longest = 3000;
    return s.substr(0, longest);
  }
  struct Group {
    std::string id, step;
    bool integrable = false, on_trust = false; ///< as the node itself
    IntegralClass integrals;
    std::vector<std::vector<Condition>> regions;
  };
  [[nodiscard]] std::vector<std::vector<Condition>> regions(const NodeResult& n) const {
    return mapped<std::vector<Condition>>(
        regions_of(n), [&](const Assumptions& r) { return s_.family.moved(r.conditions); });
  }
  void put_region(const NodeResult& n, Group& g) const {
    std::ranges::move(regions(n), std::back_inserter(g.regions));
  }
  // A part of a region that Darboux points leave may lie in other strata.
  void drop_what_is_covered() {
    for (Group& g : trusted_) {
      if (!looked_at_.contains(g.id)) continue;
      for (std::size_t k = 0; k < g.regions.size();)
        if (is_covered(g, k))
          g.regions.erase(g.regions.begin() + static_cast<long>(k));
        else
          ++k;
    }
    std::erase_if(trusted_, [](const Group& g) { return g.regions.empty(); });
  }
  [[nodiscard]] bool is_covered(const Group& without, std::size_t k) const {
    auto others = s_.regions;
    const auto add = [&](const Group& g) {
      for (std::size_t i = 0; i < g.regions.size(); ++i)
        if (&g != &without || i != k) others.push_back({0, i, g.regions[i]});
    };
    for (const Group& g : trusted_)
      add(g);
    add(open_);
    return s_.is_covered(without.regions[k], others);
  }
  // First come groups into which, and into what is proved, symmetries send all others.
  void put_images_last() {
    using Numbers = std::set<std::size_t>;
    std::vector<RegionOfPart> images; // of the regions of the group with the number `part`
    for (std::size_t n = 0; n < trusted_.size(); ++n)
      for (const auto& region : trusted_[n].regions)
        if (!trusted_[n].integrable)
          for (auto& w : symmetries_.before(region))
            images.push_back({n, std::nullopt, std::move(w.conditions), std::move(w.letters)});
    // Groups around each region that is not sent into what is proved.
    std::vector<std::vector<Numbers>> into(trusted_.size());
    for (std::size_t n = 0; n < trusted_.size(); ++n)
      for (const auto& region : trusted_[n].regions) {
        if (images_.reach(region)) continue;
        Numbers& all = into[n].emplace_back();
        for (const RegionOfPart& x : images)
          if (x.part != n && !all.contains(x.part) && images_.sends(region, x)) all.insert(x.part);
      }
    Numbers last;
    const auto is_sent = [&](std::size_t n) {
      return !trusted_[n].integrable && std::ranges::all_of(into[n], [&](const Numbers& all) {
        return !std::ranges::includes(last, all);
      });
    };
    for (std::size_t n = trusted_.size(); n-- > 0;) {
      last.insert(n);
      if (!std::ranges::all_of(last, is_sent)) last.erase(n);
    }
    std::vector<Group> ordered;
    for (const bool in_last : {false, true})
      for (std::size_t n = 0; n < trusted_.size(); ++n)
        if (last.contains(n) == in_last) ordered.push_back(trusted_[n]);
    trusted_ = std::move(ordered);
  }
  void put_group(Group g) {
    if (!g.integrable)
      for (std::size_t k = 0; k < g.regions.size();) {
        if (images_.put(g.regions[k])) {
          g.regions.erase(g.regions.begin() + static_cast<long>(k));
          continue;
        }
        images_.add({s_.parts.size(), k, g.regions[k]});
        ++k;
      }
    if (g.regions.empty()) return;
    Json::Object members{{"system", json_text(s_.family.name())},
                         {"says", json_text(g.integrable ? "integrable" : "not integrable")},
                         {"step", json_text(g.step)},
                         {"regions", put_regions(g)}};
    if (!g.integrable) members.emplace_back("class", json_class(g.integrals));
    s_.on_trust.emplace_back(g.id, Trusted{Trusted::Step::by_author, g.step});
    s_.put_step(g.id, "trusted", std::move(members));
    s_.parts.push_back(g.id);
  }
  Json put_regions(const Group& g) {
    std::vector<Json> rows;
    for (std::size_t k = 0; k < g.regions.size(); ++k) {
      rows.push_back(json_conditions(g.regions[k]));
      s_.regions.push_back({s_.parts.size(), k, g.regions[k]});
    }
    return json_list(std::move(rows));
  }

  StrataParts& s_;
  BundleSymmetries symmetries_;
  RegionImages images_;
  std::vector<Group> trusted_;
  std::set<std::string> looked_at_;
  Group open_;
};

} // namespace kov
