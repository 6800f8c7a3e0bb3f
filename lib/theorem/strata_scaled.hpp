#pragma once
// Parts whose curves were studied at another scale, where some parameters are 1, or in the system of lowest order:
// they are proved there, and carried over.

#include "exact/linear.hpp"
#include "integrability/specialise.hpp"
#include "moves/leading.hpp"
#include "moves/scale.hpp"
#include "moves/scalings.hpp"
#include "study/study.hpp"
#include "theorem/bundle_rules.hpp"
#include "theorem/strata_cases.hpp"
#include "theorem/strata_common.hpp"

namespace kov {

/// y = x times powers of the parameters that become 1, or of roots of them.
class ScaleMap {
public:
  /// Errors  DomainError: other roots than square roots
  ScaleMap(const System& s, const std::vector<std::size_t>& ones) : s_(s), weights_(scalings(s)) {
    if (row_reduce(weights_, ones) != ones) throw DomainError("no change of scale");
    auto names = s.ring()->names();
    for (const std::size_t i : ones) {
      units_.push_back({i, i});
      if (has_integers(weights_[units_.size() - 1])) continue;
      units_.back().root = names.size();
      names.push_back("root_of_" + s.ring()->name(i));
    }
    ring_ = make_ring(names);
  }

  [[nodiscard]] PlaceMap operator()() const {
    std::vector<Roots::Root> roots;
    for (const Unit& u : units_)
      if (u.root != u.one) roots.emplace_back(u.root, MFraction::variable(ring_, u.one));
    const std::size_t n = s_.field.dimension(), time = s_.ring()->size();
    PlaceMap map{ring_, Roots(roots), {}, {}, power(time + 1, 1), power(time, 1)};
    for (const auto* all : {&s_.field.coordinates, &s_.field.parameters})
      for (const std::size_t i : *all)
        map.values.emplace(s_.ring()->name(i), MFraction::variable(ring_, i) * power(i, -1));
    map.jacobian.assign(n, std::vector<MFraction>(n, MFraction(ring_, Rational(0))));
    for (std::size_t i = 0; i < n; ++i)
      map.jacobian[i][i] = power(s_.field.coordinates[i], -1);
    return map;
  }

private:
  struct Unit {
    std::size_t one, root; ///< the same where no root is needed
  };
  [[nodiscard]] Rational weight(std::size_t k, std::size_t i) const {
    return is_zero(weights_[k][i]) ? Rational(0) : to_rational(weights_[k][i]);
  }
  static bool has_integers(const std::vector<MFraction>& row) {
    return std::ranges::all_of(
        row, [](const MFraction& w) { return is_zero(w) || is_integer(to_rational(w)); });
  }
  // A product of powers of units, by the weights at this place; or 1/it.
  [[nodiscard]] MFraction power(std::size_t i, long sign) const {
    MFraction all(ring_, Rational(1));
    for (std::size_t k = 0; k < units_.size(); ++k) {
      const Unit& u = units_[k];
      const Rational e = weight(k, i) * Rational(u.root == u.one ? sign : 2 * sign);
      if (!is_integer(e)) throw DomainError("a change of scale with other roots");
      all *= pow(MFraction::variable(ring_, u.root), to_long(e.num()));
    }
    return all;
  }

  const System& s_;
  Matrix weights_;
  std::vector<Unit> units_;
  Ring ring_;
};

class ScaledParts {
public:
  explicit ScaledParts(StrataParts& s) : s_(s) {}

  /// The regions that are not covered then; nothing: all of them are.
  std::optional<NodeResult> operator()(const NodeResult& n) {
    NodeResult left = n;
    left.regions.clear();
    StrataParts* of = n.node.found.lowest ? lowest(*n.node.found.lowest) : &s_;
    for (const Assumptions& r : regions_of(n))
      if (of == nullptr ||
          !tried<DomainError, InvalidArgument, certify::Refused>([&] { return put(n, r, *of); }))
        left.regions.push_back(r);
    return left.regions.empty() ? std::nullopt : std::optional(left);
  }

private:
  bool put(const NodeResult& n, const Assumptions& r, StrataParts& of) {
    const PartPlace whole = of.solved(r);
    const System base = at_values(of.family.system(), of.family.in_system(whole.put));
    const auto there = scaled(base);
    if (!there) return false;
    System at_one = at_values(base, there->values);
    // divided by a unit, "nonnegative" is not shown
    std::erase_if(at_one.assumptions, [](const Assumption& a) { return a.is(Sign::nonnegative); });
    StrataParts sub(of, at_one, name_of(*there, whole, of));
    NodeResult m = n;
    m.node.id += "-scale-" + std::to_string(++count_);
    m.regions = {region_at_one(*there, whole, of, sub)};
    for (const auto& study : n.node.found.special)
      for (const NamedCertificate& c : study->certificates())
        if (!c.json.empty()) m.certificates.push_back(c.json);
    if (!tried<DomainError, certify::Refused>(
            [&] { CaseParts{sub}(m, sub.solved(m.regions.front())); }) &&
        CommonParts{sub}(m))
      return false;
    const PlaceMap map = ScaleMap(base, there->ones)();
    std::vector<std::pair<std::string, PartPlace>> places;
    for (std::size_t k = 0; k < sub.parts.size(); ++k) {
      const PartPlace x = of.solved(before(*there, r, of, sub.regions[k].conditions));
      const auto target = certify::target_of(sub.family.family(), sub.regions[k].conditions, true);
      Json::Object members{{"of", json_text(sub.parts[k])},
                           {"system", json_text(of.family.name())},
                           {"at", x.values},
                           {"region", json_conditions(x.region)}};
      for (auto& one : map_members(of.family, x, at(map, x, of), target, s_.budget))
        members.push_back(std::move(one));
      sub.put_step(sub.parts[k] + "-place", "place", std::move(members));
      places.emplace_back(sub.parts[k] + "-place", x);
    }
    s_.take(sub);
    for (const auto& [id, x] : places)
      &of == &s_ ? s_.add_region(id, x.conditions()) : put_lowest_order(id, x.conditions());
    return true;
  }
  // The same where more parameters have values.
  static PlaceMap at(PlaceMap map, const PartPlace& x, const StrataParts& of) {
    Substitution put;
    for (const auto& [i, f] : x.put)
      put[map.ring->index(of.family.ring()->name(i))] =
          is_zero(f) ? MFraction(map.ring) : transfer(f, map.ring);
    for (auto& [name, f] : map.values)
      f = put_in(f, put);
    return map;
  }

  // ---- the system of lowest order

  // Unset: it is another one somewhere, or of other weights.
  StrataParts* lowest(const std::pair<long, long>& weights) {
    if (!low_ && !has_no_low_)
      has_no_low_ = !tried<DomainError>([&] {
        const auto part = leading_part(s_.family.system());
        if (!part || weights != std::pair(part->of_momentum, part->of_gamma))
          throw DomainError("other weights");
        low_.emplace(s_, part->system, s_.family.name() + ", lowest order");
        Weights all;
        const auto& x = s_.family.system().field.coordinates;
        for (std::size_t k = 0; k < x.size(); ++k)
          all[x[k]] = k < 3 ? weights.first : weights.second;
        order_ = lowest_order_members(s_.family, low_->family, all, s_.budget);
      });
    return has_no_low_ ? nullptr : &*low_;
  }
  void put_lowest_order(const std::string& of, const std::vector<Condition>& there) {
    s_.take(*low_);
    Json::Object members{{"of", json_text(of)}};
    members.insert(members.end(), order_.begin(), order_.end());
    s_.put_step(of + "-order", "lowest-order", std::move(members));
    std::vector<Condition> here;
    for (const Condition& c : there)
      here.push_back(s_.family.moved(c));
    s_.add_region(of + "-order", std::move(here));
  }

  // ---- the system at scale 1

  static std::string name_of(const ScaledSystem& there, const PartPlace& whole,
                             const StrataParts& of) {
    std::string name = of.family.name();
    for (const auto& [i, value] : whole.put)
      name += ", " + of.family.ring()->name(i) + " = " + to_string(value);
    for (const std::size_t i : there.ones)
      name += ", " + there.system.ring()->name(i) + " = 1";
    return name;
  }
  static MFraction put_in(const MFraction& f, const Substitution& values) {
    return is_zero(f) ? f : substitute(f, values);
  }
  static Assumptions region_at_one(const ScaledSystem& there, const PartPlace& whole,
                                   const StrataParts& of, const StrataParts& sub) {
    Assumptions all;
    for (const Condition& c : whole.region) {
      MFraction f = put_in(MFraction(c.p), whole.put);
      if (!is_zero(f)) f = put_in(transfer(f, there.system.ring()), there.values);
      const MPoly p = is_zero(f) ? MPoly(of.family.ring()) : f.num();
      if (is_zero(p) || !is_constant(p)) all.conditions.push_back(sub.family.moved({p, c.sign}));
    }
    return all;
  }
  // Conditions at scale 1, and what was known of the place.
  static Assumptions before(const ScaledSystem& there, const Assumptions& r, const StrataParts& of,
                            const std::vector<Condition>& conditions) {
    Assumptions all;
    for (const Condition& c : r.conditions)
      all.conditions.push_back(of.family.moved(c));
    for (const Condition& c : conditions) {
      const MFraction f = put_in(transfer(MFraction(c.p), there.system.ring()), there.back);
      const MPoly p = certify::is_ordered(c.sign) ? f.num() * f.den() : f.num();
      add_once(all.conditions, of.family.moved({p, c.sign}));
    }
    return all;
  }

  StrataParts& s_;
  std::optional<StrataParts> low_;
  bool has_no_low_ = false;
  Json::Object order_; ///< of the step "lowest-order"
  std::size_t count_ = 0;
};

} // namespace kov
