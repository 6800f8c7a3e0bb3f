#pragma once
// Parts whose curves were studied at another scale, where some parameters are 1, in other variables, or in the system
// of lowest order: they are proved there, and carried over.

#include "canonical/change.hpp"
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

/// y = x times powers of the parameters that become 1, or of square roots of them.
/// Errors  DomainError: other roots
inline PlaceMap scale_map(const System& s, const std::vector<std::size_t>& ones) {
  Matrix weights = scalings(s);
  if (row_reduce(weights, ones) != ones) throw DomainError("no change of scale");
  const auto weight = [&](std::size_t k, std::size_t i) {
    return is_zero(weights[k][i]) ? Rational(0) : to_rational(weights[k][i]);
  };
  auto names = s.ring()->names();
  std::vector<std::size_t> units = ones; // or their roots
  for (std::size_t k = 0; k < ones.size(); ++k)
    for (std::size_t i = 0; i < weights[k].size() && units[k] == ones[k]; ++i) {
      if (is_integer(weight(k, i))) continue;
      units[k] = names.size();
      names.push_back("root_of_" + s.ring()->name(ones[k]));
    }
  const Ring ring = make_ring(names);
  // A product of powers of units, by the weights at this place; or 1/it.
  const auto power = [&](std::size_t i, long sign) {
    MFraction all(ring, Rational(1));
    for (std::size_t k = 0; k < ones.size(); ++k) {
      const Rational e = weight(k, i) * Rational(units[k] == ones[k] ? sign : 2 * sign);
      if (!is_integer(e)) throw DomainError("a change of scale with other roots");
      all *= pow(MFraction::variable(ring, units[k]), to_long(e.num()));
    }
    return all;
  };
  std::vector<Roots::Root> roots;
  for (std::size_t k = 0; k < ones.size(); ++k)
    if (units[k] != ones[k]) roots.emplace_back(units[k], MFraction::variable(ring, ones[k]));
  const std::size_t n = s.field.dimension(), time = s.ring()->size();
  PlaceMap map{ring, Roots(roots), {}, {}, power(time + 1, 1), power(time, 1)};
  for (const auto* all : {&s.field.coordinates, &s.field.parameters})
    for (const std::size_t i : *all)
      map.values.emplace(s.ring()->name(i), MFraction::variable(ring, i) * power(i, -1));
  map.jacobian.assign(n, std::vector<MFraction>(n, MFraction(ring, Rational(0))));
  for (std::size_t i = 0; i < n; ++i)
    map.jacobian[i][i] = power(s.field.coordinates[i], -1);
  return map;
}

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
    const CanonicalChange* change = n.node.found.change.get();
    const auto there = change ? in_new_variables(*change, whole, of) : scaled(base);
    if (!there) return false;
    System at_one = change ? there->system : at_values(base, there->values);
    // divided by a unit, "nonnegative" is not shown
    std::erase_if(at_one.assumptions, [](const Assumption& a) { return a.is(Sign::nonnegative); });
    StrataParts sub(of, at_one, name_of(*there, whole, of));
    NodeResult m = n;
    m.node.id += "-scale-" + std::to_string(++count_);
    m.node.found.change.reset();
    m.regions = {region_at_one(*there, whole, sub)};
    for (const auto& study : n.node.found.special)
      for (const NamedCertificate& c : study->certificates())
        if (!c.json.empty()) m.certificates.push_back(c.json);
    if (!tried<DomainError, certify::Refused>(
            [&] { CaseParts{sub}(m, sub.solved(m.regions.front())); }) &&
        CommonParts{sub}(m) && (!change || ScaledParts{sub}(m)))
      return false;
    const PlaceMap map = change ? map_of(*change, base) : scale_map(base, there->ones);
    std::vector<std::pair<std::string, PartPlace>> places;
    for (std::size_t k = 0; k < sub.parts.size(); ++k) {
      const PartPlace x = of.solved(before(*there, r, of, sub.regions[k].conditions));
      const auto target = certify::target_of(sub.family.family(), sub.regions[k].conditions, true);
      const std::string id = sub.parts[k] + "-place";
      sub.put_place(id, sub.parts[k], of.family, x, at(map, x, of), target);
      places.emplace_back(id, x);
    }
    s_.take(sub);
    for (const auto& [id, x] : places)
      &of == &s_ ? s_.add_region(id, x.conditions()) : put_lowest_order(id, x.conditions());
    return true;
  }
  // At scale 1, as all parameters stay the same.   Unset: functions have no place by values
  static std::optional<ScaledSystem>
  in_new_variables(const CanonicalChange& change, const PartPlace& whole, const StrataParts& of) {
    if (!of.family.family().is_plain()) return std::nullopt;
    Substitution put;
    for (const auto& [i, f] : of.family.in_system(whole.put))
      put[change.system.ring()->index(of.family.system().ring()->name(i))] =
          is_zero(f) ? MFraction(change.system.ring()) : transfer(f, change.system.ring());
    return ScaledSystem{{}, {}, {}, at_values(change.system, put)};
  }
  static PlaceMap map_of(const CanonicalChange& change, const System& base) {
    PlaceMap map = identity_map(base);
    const VectorField &now = change.system.field, &old = base.field;
    for (std::size_t i = 0; i < old.dimension(); ++i) {
      const MFraction y = transfer(change.variables[i], base.ring());
      map.values[now.name(i)] = y;
      for (std::size_t j = 0; j < old.dimension(); ++j)
        map.jacobian[i][j] = derivative(y, old.coordinates[j]);
    }
    return map;
  }
  // The same where more parameters have values.
  static PlaceMap at(PlaceMap map, const PartPlace& x, const StrataParts& of) {
    Substitution put;
    for (const auto& [i, f] : x.put)
      put[map.ring->index(of.family.ring()->name(i))] = transfer(f, map.ring);
    for (auto& [name, f] : map.values)
      f = substitute(f, put);
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
    s_.put_step(of + "-order", "lowest-order", {{"of", json_text(of)}}, order_);
    s_.add_region(of + "-order", s_.family.moved(there));
  }

  // ---- the system at scale 1

  static std::string name_of(const ScaledSystem& there, const PartPlace& whole,
                             const StrataParts& of) {
    std::string name = of.family.name();
    for (const auto& [i, value] : whole.put)
      name += ", " + of.family.ring()->name(i) + " = " + to_string(value);
    if (there.ones.empty()) name += ", in other variables";
    for (const std::size_t i : there.ones)
      name += ", " + there.system.ring()->name(i) + " = 1";
    return name;
  }
  static Assumptions region_at_one(const ScaledSystem& there, const PartPlace& whole,
                                   const StrataParts& sub) {
    Assumptions all;
    for (const Condition& c : whole.region) {
      const MFraction f =
          substitute(transfer(substitute(c.p, whole.put), there.system.ring()), there.values);
      const MPoly p = f.num();
      if (is_zero(p) || !is_constant(p)) all.conditions.push_back(sub.family.moved({p, c.sign}));
    }
    return all;
  }
  // Conditions at scale 1, and what was known of the place.
  static Assumptions before(const ScaledSystem& there, const Assumptions& r, const StrataParts& of,
                            const std::vector<Condition>& conditions) {
    Assumptions all;
    all.conditions = of.family.moved(r.conditions);
    for (const Condition& c : conditions) {
      const MFraction f = substitute(transfer(c.p, there.system.ring()), there.back);
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
