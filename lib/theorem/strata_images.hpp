#pragma once
// Regions that symmetries send into parts that say "not integrable": they are proved as these are.

#include "certify/equation/facts.hpp"
#include "exact/joined.hpp"
#include "theorem/bundle_symmetries.hpp"
#include "theorem/strata_parts.hpp"

namespace kov {

class RegionImages {
public:
  RegionImages(StrataParts& s, BundleSymmetries& symmetries) : s_(s), symmetries_(symmetries) {}

  // The points that symmetries send into a region of a part that says "not integrable": each set of them once, and
  // first that region itself.
  void add(const RegionOfPart& r) {
    auto words = symmetries_.before(r.conditions);
    words.insert(words.begin(), {{}, r.conditions});
    for (auto& w : words)
      if (known_.emplace(key_of(w.conditions), images_.size()).second)
        images_.push_back({r.part, r.region, std::move(w.conditions), std::move(w.letters)});
  }
  // Is a region mapped into earlier ones by symmetries?  It is proved as these are.
  bool put(const std::vector<Condition>& region) {
    for (; added_ < s_.excluded.size(); ++added_)
      add(s_.excluded[added_]);
    const auto same = known_.find(key_of(region));
    if (same != known_.end() && put({images_[same->second]})) return true;
    std::vector<RegionOfPart> some;
    for (const RegionOfPart& x : images_) {
      if (!satisfies_equations(region, x.conditions)) continue;
      some.push_back(x);
      if (implies(region, x.conditions) && put({x})) return true;
    }
    return some.size() > 1 && put(covering(region, std::move(some)));
  }
  // Does x, the image of a region, lie around this one?
  [[nodiscard]] bool sends(const std::vector<Condition>& region, const RegionOfPart& x) const {
    return satisfies_equations(region, x.conditions) && implies(region, x.conditions);
  }
  [[nodiscard]] bool reach(const std::vector<Condition>& region) const {
    return std::ranges::any_of(images_, [&](const RegionOfPart& x) { return sends(region, x); });
  }

private:
  bool put(const std::vector<RegionOfPart>& images) {
    std::vector<RegionOfPart> known;
    for (const RegionOfPart& x : images) {
      const auto word = symmetries_.use(x.word);
      if (!word) return false;
      if (!word->empty()) known.push_back({x.part, x.region, x.conditions, *word});
    }
    s_.regions.insert(s_.regions.end(), known.begin(), known.end());
    return !images.empty();
  }
  // The conditions without their order, and without signs that mean nothing.
  [[nodiscard]] std::string key_of(const std::vector<Condition>& region) const {
    certify::Arithmetic a;
    const std::vector<MPoly> equations = equations_of(region);
    std::set<std::string> all;
    for (const Condition& c : region) {
      const bool is_equation = c.sign == Sign::zero;
      MPoly f =
          certify::primitive(is_equation ? c.p : certify::modulo_equations(c.p, equations, a));
      if (is_stated({f, c.sign}, s_.family.assumptions())) continue;
      if (!certify::is_ordered(c.sign) && !is_zero(f) && sign(f.coefficient(0)) < 0) f = -f;
      all.insert(certify::to_string(c.sign) + (" " + to_string(f)));
    }
    return joined(std::vector(all.begin(), all.end()), std::identity(), ", ");
  }
  static std::vector<MPoly> equations_of(const std::vector<Condition>& region) {
    std::vector<MPoly> equations;
    for (const Condition& c : region)
      if (c.sign == Sign::zero) equations.push_back(c.p);
    return equations;
  }
  static bool is_stated(const Condition& c, const std::vector<Condition>& all) {
    return std::ranges::any_of(all, [&](const Condition& d) {
      return c.sign == d.sign && (c.p == d.p || (!certify::is_ordered(c.sign) && c.p == -d.p));
    });
  }
  // Images that are needed to cover a region together; none: they do not.
  [[nodiscard]] std::vector<RegionOfPart> covering(const std::vector<Condition>& region,
                                                   std::vector<RegionOfPart> images) const {
    if (!s_.is_covered(region, images)) return {};
    for (std::size_t k = 0; k < images.size();) {
      auto fewer = images;
      fewer.erase(fewer.begin() + static_cast<long>(k));
      s_.is_covered(region, fewer) ? void(images = std::move(fewer)) : void(++k);
    }
    return images;
  }
  [[nodiscard]] bool satisfies_equations(const std::vector<Condition>& region,
                                         const std::vector<Condition>& wanted) const {
    const std::vector<MPoly> equations = equations_of(region);
    certify::Arithmetic a;
    return std::ranges::all_of(wanted, [&](const Condition& c) {
      return c.sign != Sign::zero || is_zero(certify::modulo_equations(c.p, equations, a));
    });
  }
  // The equations are satisfied.
  [[nodiscard]] bool implies(const std::vector<Condition>& region,
                             const std::vector<Condition>& wanted) const {
    const auto given = s_.family.known_where(region);
    return std::ranges::all_of(wanted, [&](const Condition& c) {
      return c.sign == Sign::zero || is_stated(c, given) || s_.proof.shown(given, c).has_value();
    });
  }

  StrataParts& s_;
  BundleSymmetries& symmetries_;
  std::vector<RegionOfPart> images_;         ///< the words in the numbers of all symmetries
  std::map<std::string, std::size_t> known_; ///< by their keys
  std::size_t added_ = 0;                    ///< of the regions of the certificate
};

} // namespace kov
