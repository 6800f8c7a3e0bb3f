#pragma once
// Parts that two curves exclude together: their exponent differences are special at once at finitely many
// values only (docs/theory/theorem_certificates.md 17).

#include "certify/theorem/computed.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "parameters/statement.hpp"
#include "study/study.hpp"
#include "theorem/strata_levels.hpp"

#include <list>

namespace kov {

class CommonParts {
public:
  explicit CommonParts(StrataParts& s) : s_(s), asked_(s) {}

  /// The regions that are not covered then; nothing: all of them are.
  std::optional<NodeResult> operator()(const NodeResult& n) {
    node_ = &n;
    read();
    find();
    NodeResult left = n;
    left.regions.clear();
    std::vector<std::vector<Condition>> covered;
    for (const Assumptions& r : regions_of(n)) {
      auto there = s_.family.moved(r.conditions);
      if (!parts_.empty() && s_.is_covered(there, regions()))
        covered.push_back(std::move(there));
      else
        left.regions.push_back(r);
    }
    const auto are_enough = [&] {
      return std::ranges::all_of(
          covered, [&](const auto& there) { return s_.is_covered(there, regions()); });
    };
    for (std::size_t k = parts_.size(); k-- > 0;) {
      const Part part = std::move(parts_[k]);
      parts_.erase(parts_.begin() + static_cast<long>(k));
      if (!are_enough()) parts_.insert(parts_.begin() + static_cast<long>(k), part);
    }
    for (const Part& part : parts_)
      put(part);
    return left.regions.empty() ? std::nullopt : std::optional(left);
  }

private:
  using Values = certify::ValuesOfDifferences;
  using Difference = certify::ExponentDifference;

  /// A leaf that says "abelian exactly where".
  struct LeafAlong {
    const std::string* certificate;
    std::size_t leaf;
    certify::Target asked;
    Difference difference; ///< in the ring of the family
  };
  /// Points at which not both are special.
  struct Part {
    const LeafAlong *first, *second;
    Values f;
    PartPlace at;      ///< of the step
    PartPlace without; ///< the common values
    std::vector<Json> shown, levels;
    std::optional<Json> by;
  };
  void read() {
    curves_.clear();
    for (const auto& study : node_->node.found.special)
      for (const NamedCertificate& c : study->certificates())
        if (!c.json.empty()) tried<Error>([&] { read(c.json); });
  }
  void read(const std::string& json) {
    const certify::Said& said = said_.emplace_back(said_by(json));
    if (!said.there.text.empty()) return; // functions may have other values along another curve
    for (std::size_t k = 0; k < said.criteria.size(); ++k)
      try {
        if (auto d = said.criteria[k].difference) {
          for (MPoly* f : {&d->square.num, &d->square.den})
            *f = s_.family.moved({*f, Sign::zero}).p;
          curves_.push_back(
              {&json, k, certify::target_of(said, said.criteria[k]), Difference(*std::move(d))});
        }
      } catch (const certify::Refused&) { // nothing follows of it
        continue;
      }
  }

  void find() {
    constexpr std::size_t most = 8;
    parts_.clear();
    const std::size_t n = std::min(curves_.size(), most);
    std::vector<std::vector<Condition>> sets;
    for (const Assumptions& r : regions_of(*node_))
      add_once(sets, equations_of(r.conditions));
    std::vector<PartPlace> places{s_.family.placed(Substitution(), {})};
    for (const auto& equations : sets) // a curve may be of the system with these values
      if (!equations.empty()) places.push_back(s_.solved({equations, {}, {}, {}}));
    for (const PartPlace& x : places)
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j)
          if (!find(curves_[i], curves_[j], x)) find(curves_[j], curves_[i], x);
    // One difference may be a number where equations hold, or where the rule has divided.
    for (const Part& part : parts_)
      for (const Condition& c : part.at.region)
        if (c.sign == Sign::nonzero) {
          auto equations = equations_of(part.at.conditions());
          equations.push_back({c.p, Sign::zero});
          add_once(sets, std::move(equations));
        }
    for (const auto& equations : sets)
      for (std::size_t i = 0; i < n; ++i)
        if (find(curves_[i], curves_[i], s_.family.placed(Substitution(), equations))) break;
  }
  [[nodiscard]] std::vector<Condition> equations_of(const std::vector<Condition>& all) const {
    std::vector<Condition> equations;
    for (const Condition& c : all)
      if (c.sign == Sign::zero) equations.push_back(s_.family.moved(c));
    return equations;
  }
  bool find(const LeafAlong& first, const LeafAlong& second, const PartPlace& x) {
    for (const LeafAlong* c : {&first, &second}) // the rule computes with parameters without values
      for (const auto& [i, value] : x.put)
        if (uses(c->difference.square().num, i) || uses(c->difference.square().den, i))
          return false;
    for (const PartPlace& one : asked_.where_asked(first.asked, at_levels(first, x)))
      for (const PartPlace& there : asked_.where_asked(second.asked, at_levels(second, one)))
        try {
          auto f = function(first.difference, second.difference, there);
          if (f && find(first, second, there, *std::move(f))) return true;
        } catch (const certify::Refused&) {
          continue;
        } catch (const DomainError&) {
          continue;
        }
    return false;
  }
  bool find(const LeafAlong& first, const LeafAlong& second, const PartPlace& x, Values f) {
    certify::Arithmetic a;
    const MPoly off = certify::off_function(first.difference, second.difference, f, a);
    std::optional<Json> by;
    if (!is_zero(off) && !(by = s_.proof.shown(x.given, {off, Sign::zero}))) return false;
    const PartPlace one = at_levels(first, x), other = at_levels(second, x);
    auto region = x.region;
    for (const Condition& c : certify::no_common_values(first.difference, second.difference, f))
      region.push_back(c);
    parts_.push_back({&first,
                      &second,
                      std::move(f),
                      x,
                      s_.family.placed(x.put, std::move(region)),
                      {json_list(asked_.shown_of(first.asked, one)),
                       json_list(asked_.shown_of(second.asked, other))},
                      {asked_.level_rows(one), asked_.level_rows(other)},
                      std::move(by)});
    return true;
  }
  [[nodiscard]] PartPlace at_levels(const LeafAlong& c, PartPlace x) const {
    x.levels = asked_.levels_of(c.asked);
    return x;
  }
  [[nodiscard]] std::vector<RegionOfPart> regions() const {
    auto all = s_.regions;
    for (const Part& part : parts_)
      all.push_back({0, std::nullopt, part.without.conditions()});
    return all;
  }

  void put(const Part& part) {
    const Json one = json_text(step_of(*part.first)), other = json_text(step_of(*part.second));
    Json::Object members{
        {"system", json_text(s_.family.name())},
        {"of", json_list({one, other})},
        {"leaves", json_list({json_text(std::to_string(part.first->leaf)),
                              json_text(std::to_string(part.second->leaf))})},
        {"at", part.at.values},
        {"region", json_conditions(part.at.region)},
        {"shown", json_list(part.shown)},
        {"levels", json_list(part.levels)},
        {"function", Json{Json::Object{{"num", json_text(to_string(part.f.A, "x"))},
                                       {"den", json_text(to_string(part.f.B, "x"))}}}},
        {"bound", json_text(std::to_string(part.f.bound))},
        {"gap", json_text(part.f.gap ? to_string(*part.f.gap) : "negative")}};
    if (part.by) members.emplace_back("by", *part.by);
    const std::string id = node_->node.id + "-common-" + std::to_string(++steps_);
    s_.put_step(id, "common-values", std::move(members));
    s_.add_region(id, part.without.conditions());
  }
  std::string step_of(const LeafAlong& c) {
    const auto [known, is_new] =
        certificates_.try_emplace(*c.certificate, certificate_step(node_->node.id) + "-common-" +
                                                      std::to_string(certificates_.size() + 1));
    if (is_new)
      s_.put_step(known->second, "certificate",
                  {{"certificate", certify::parse_json(*c.certificate, 512)}});
    return known->second;
  }

  // Delta2^2 as a function of Delta1^2 there, with a bound.
  [[nodiscard]] static std::optional<Values>
  function(const Difference& first, const Difference& second, const PartPlace& x) {
    const auto fraction = [](const certify::Fraction& f) {
      return MFraction(f.num) / MFraction(f.den);
    };
    Values f;
    if (&first == &second) {
      const auto value = constant_there(fraction(first.square()), x);
      if (!value) return std::nullopt;
      const Poly num(Rational(value->num())), den(Rational(value->den()));
      f = {2 * num - den * Poly::z(),
           den}; // 2 q - x is q where x is q, and negative where x is large
    } else {
      const auto g = in_terms_of(fraction(first.square()), fraction(second.square()));
      if (!g) return std::nullopt;
      Integer common(1);
      for (const auto* all : {&g->num, &g->den})
        for (const Rational& c : *all)
          common = lcm(common, c.den());
      const auto integral = [&](const std::vector<Rational>& all) {
        Poly p;
        for (std::size_t i = 0; i < all.size(); ++i)
          p.set_coeff(static_cast<long>(i), NfElem(all[i] * Rational(common)));
        return p;
      };
      f = {integral(g->num), integral(g->den)};
    }
    return bounded(first, second, std::move(f));
  }
  [[nodiscard]] static std::optional<Rational> constant_there(const MFraction& f,
                                                              const PartPlace& x) {
    Substitution put;
    for (const Condition& c : x.region) {
      const MFraction g = substitute(MFraction(c.p), put);
      if (c.sign != Sign::zero || is_zero(g)) continue;
      const auto used = used_variables(g.num());
      const auto i = std::ranges::find_if(used, [&](auto v) { return degree(g.num(), v) == 1; });
      if (i != used.end()) StrataParts::put_in(put, *i, g.num());
    }
    const MFraction there = is_zero(f) ? f : substitute(f, put);
    if (is_zero(there)) return Rational(0);
    return is_constant(there) ? std::optional(to_rational(there)) : std::nullopt;
  }
  [[nodiscard]] static std::optional<Values> bounded(const Difference& first,
                                                     const Difference& second, Values f) {
    constexpr long most = 20000;
    std::vector<std::optional<Integer>> gaps{std::nullopt};
    if (degree(f.A) <= degree(f.B)) {
      const Rational limit =
          degree(f.A) < degree(f.B) ? Rational(0) : lead(f.A).coeff(0) / lead(f.B).coeff(0);
      const Integer square = floor(limit * Rational(second.N() * second.N()));
      if (sign(square) >= 0) {
        Integer root;
        fmpz_sqrt(root.raw(), square.raw());
        gaps = {root};
        if (sign(root) > 0) gaps.emplace_back(root - Integer(1));
      }
    }
    for (f.bound = 0; f.bound <= most; f.bound += 1 + f.bound / 8)
      for (const auto& gap : gaps) {
        f.gap = gap;
        if (certify::shows_bound(first, second, f)) return f;
      }
    return std::nullopt;
  }
  StrataParts& s_;
  AskedThere asked_;
  std::list<certify::Said> said_;
  std::vector<LeafAlong> curves_;
  const NodeResult* node_ = nullptr;
  std::vector<Part> parts_;
  std::map<std::string, std::string> certificates_; ///< by their texts, the ids of their steps
  std::size_t steps_ = 0;
};

} // namespace kov
