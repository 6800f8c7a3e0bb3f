#include "theorem/bundle_rules.hpp"

#include "certify/theorem/computed.hpp"
#include "exact/error.hpp"
#include "parameters/refutation.hpp"
#include "proof/algebra/arithmetic.hpp"

namespace kov {
namespace {

constexpr int splitting_depth = 40;
constexpr int depth_of_units = 3;

// H1 = first/(2 (A B C)^power)
void put_perturbation(certify::SplittingData& d, const EulerPerturbation& p,
                      const BundleFamily& y) {
  MFraction f = Rational(2) * transfer(p.first, y.ring());
  MPoly abc(y.ring(), Integer(1));
  for (const std::size_t i : d.moments)
    abc = abc * MPoly::variable(y.ring(), i);
  d.order = static_cast<unsigned long>(p.order);
  for (d.power = 1; d.power <= 12; ++d.power) {
    f = f * MFraction(abc);
    if (is_constant(f.den())) break;
  }
  if (!is_constant(f.den()) || !(f.den().coefficient(0) == Integer(1)))
    throw DomainError("the perturbation is not a polynomial over a power of the moments");
  d.first = f.num();
}

Json splitting_proof(const BundleFamily& y, const certify::SplittingData& d, const Budget& budget) {
  certify::Arithmetic a;
  const certify::Family& family = y.family();
  const Ring ring = certify::splitting_ring(family);
  auto proof =
      refutation(ring, certify::splitting_conditions(family, d, ring, a), splitting_depth, budget);
  if (!proof) throw DomainError("it is not shown that a sum of residues is not 0");
  return *std::move(proof);
}

/// The whole system beside its lowest order: the members of that step.
class LowestOrder {
public:
  LowestOrder(const BundleFamily& whole, const BundleFamily& low, const Weights& weights,
              const Budget& budget)
      : whole_(whole), low_(low), weights_(weights), budget_(budget) {}

  Json::Object operator()() const {
    std::vector<Json> weights, orders, units;
    for (const std::size_t i : whole_.system().field.coordinates)
      weights.push_back(json_text(std::to_string(weights_.at(i))));
    for (std::size_t k = 0; k < whole_.divisors().size(); ++k)
      orders.push_back(order_of(k));
    for (const MPoly& h : low_.divisors())
      units.push_back(shown_unit(h));
    const MFraction& h = *low_.system().field.hamiltonian;
    return {{"system", json_text(whole_.name())},
            {"weights", json_list(std::move(weights))},
            {"degree", json_text(std::to_string(weight_of(h.num())))},
            {"units", json_list(std::move(units))},
            {"orders", json_list(std::move(orders))}};
  }

private:
  [[nodiscard]] std::optional<Json> shown_nonzero(const MPoly& f) const {
    return shown(whole_.ring(), whole_.assumptions(), {f, Sign::nonzero}, depth_of_units, budget_);
  }
  // A denominator of the lowest-order system.
  [[nodiscard]] Json shown_unit(const MPoly& h) const {
    const MPoly ours = certify::primitive(transfer(MFraction(h), whole_.ring()).num());
    auto proof = shown_nonzero(ours);
    if (!proof) throw DomainError("it is not shown that " + to_string(ours) + " is not 0");
    return *std::move(proof);
  }
  // The weight of the first term; the checker looks at all of them.
  [[nodiscard]] long weight_of(const MPoly& f) const {
    const System &low = low_.system(), &s = whole_.system();
    long sum = 0;
    const auto e = f.exponents(0);
    for (std::size_t j = 0; j < low.field.dimension(); ++j)
      sum += weights_.at(*s.ring()->find(low.field.name(j))) *
             static_cast<long>(e[low.field.coordinates[j]]);
    return sum;
  }
  [[nodiscard]] Json order_of(std::size_t k) const {
    const MPoly low = lowest_part(whole_.divisors()[k], weights_);
    std::map<std::vector<unsigned long>, MPoly> parts;
    long order = 0;
    for (long t = 0; t < low.length(); ++t) {
      auto rest = low.exponents(t);
      std::vector<unsigned long> monomial;
      order = 0;
      for (const std::size_t i : whole_.system().field.coordinates) {
        order += weights_.at(i) * static_cast<long>(rest[i]);
        monomial.push_back(std::exchange(rest[i], 0));
      }
      MPoly& sum = parts.try_emplace(monomial, MPoly(low.ring())).first->second;
      sum = sum + MPoly::term(low.ring(), low.coefficient(t), rest);
    }
    for (const auto& [monomial, part] : parts) {
      const Condition c = whole_.moved({part, Sign::nonzero});
      auto proof = shown_nonzero(c.p);
      if (!proof) continue;
      return Json{Json::Object{{"inverse", json_text(whole_.inverse_name(k))},
                               {"order", json_text(std::to_string(order))},
                               {"part", json_text(to_string(c.p))},
                               {"by", *std::move(proof)}}};
    }
    throw DomainError("the lowest order of a denominator may be another one somewhere");
  }

  const BundleFamily &whole_, &low_;
  const Weights& weights_;
  const Budget& budget_;
};

} // namespace

Json::Object splitting_members(const BundleFamily& y, const EulerPerturbation& p,
                               const std::vector<std::string>& small,
                               const std::vector<Condition>& region, const Budget& budget) {
  certify::SplittingData d;
  std::vector<Json> moments, names;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto used = used_variables(p.inverse_inertia[k]);
    if (used.size() != 1 || k >= small.size())
      throw DomainError("the moments of inertia are not parameters");
    const std::string name = p.inverse_inertia[k].ring()->name(used.front());
    moments.push_back(json_text(name));
    names.push_back(json_text(small[k]));
    d.moments[k] = y.ring()->index(name);
    d.small[k] = y.ring()->index(small[k]);
  }
  put_perturbation(d, p, y);
  d.region = region;
  return {{"system", json_text(y.name())},          {"moments", json_list(std::move(moments))},
          {"small", json_list(std::move(names))},   {"order", json_text(std::to_string(d.order))},
          {"first", json_text(to_string(d.first))}, {"power", json_text(std::to_string(d.power))},
          {"region", json_conditions(region)},      {"proof", splitting_proof(y, d, budget)}};
}

Json::Object lowest_order_members(const BundleFamily& whole, const BundleFamily& low,
                                  const Weights& weights, const Budget& budget) {
  return LowestOrder(whole, low, weights, budget)();
}

PlaceMap identity_map(const System& s) {
  const std::size_t n = s.field.dimension();
  const MFraction zero(s.ring(), Rational(0)), one(s.ring(), Rational(1));
  PlaceMap map{s.ring(), Roots(), {}, {}, one, one};
  for (std::size_t i = 0; i < s.ring()->size(); ++i)
    map.values.emplace(s.ring()->name(i), MFraction::variable(s.ring(), i));
  for (const auto& [name, value] : s.values)
    map.values.insert_or_assign(name, transfer(value, s.ring()));
  map.jacobian.assign(n, std::vector<MFraction>(n, zero));
  for (std::size_t i = 0; i < n; ++i)
    map.jacobian[i][i] = one;
  return map;
}

} // namespace kov
