#include "theorem/bundle_family.hpp"

#include "certify/equation/facts.hpp"
#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "integrability/parameters.hpp"
#include "integrability/preserved_relations.hpp"
#include "proof/algebra/arithmetic.hpp"

#include <algorithm>

namespace kov {

Json json_conditions(const std::vector<Condition>& all) {
  std::vector<Json> rows;
  for (const Condition& c : all)
    rows.push_back(Json{Json::Object{{"p", json_text(to_string(c.p))},
                                     {"sign", json_text(certify::to_string(c.sign))}}});
  return json_list(std::move(rows));
}

namespace {

System without_levels(System s) {
  const auto levels = level_parameters(s);
  std::erase_if(s.field.parameters, [&](std::size_t i) { return is_among(i, levels); });
  std::erase_if(s.field.parameters,
                [&](std::size_t i) { return s.values.contains(s.ring()->name(i)); });
  return s;
}

} // namespace

System with_real_parameters(System s) {
  for (const std::size_t i : s.field.parameters)
    s.real.insert(s.ring()->name(i));
  s.domain = {};
  return s;
}

BundleFamily::BundleFamily(System s, std::string name)
    : s_(without_levels(std::move(s))), writer_(s_) {
  s_.field = with_preserved_relations(s_.field);
  writer_.divide(s_.field);
  writer_.make_ring();
  family_.name = std::move(name);
  family_.system = writer_.write(s_.field);
  family_.complex.assign(ring()->size(), false);
  for (const std::size_t i : s_.field.parameters)
    family_.complex[ring()->index(s_.ring()->name(i))] = !s_.real.contains(s_.ring()->name(i));
  assume();
}

std::vector<std::string> BundleFamily::parameters() const {
  const auto& names = ring()->names();
  return {names.begin() + static_cast<long>(phase().first_parameter()), names.end()};
}

Condition BundleFamily::moved(const Condition& c) const {
  return {transfer(MFraction(c.p), ring()).num(), c.sign};
}

std::vector<Condition> BundleFamily::moved(const std::vector<Condition>& all) const {
  return mapped<Condition>(all, [&](const Condition& c) { return moved(c); });
}

std::vector<Condition> BundleFamily::known_where(const std::vector<Condition>& region) const {
  auto all = assumptions();
  all.insert(all.end(), region.begin(), region.end());
  return all;
}

Substitution BundleFamily::in_system(const Substitution& put) const {
  Substitution there;
  for (const auto& [i, f] : put)
    there[s_.ring()->index(ring()->name(i))] = transfer(f, s_.ring());
  return there;
}

// Assumes what the file says of these parameters, and that the system has values there.
void BundleFamily::assume() {
  auto& known = family_.assumptions;
  const auto add = [&](const MPoly& p, Sign sign) {
    const auto used = used_variables(p);
    for (const std::size_t i : used)
      if (!is_among(i, s_.field.parameters)) return; // of a level
    const Condition c = moved({p, sign});
    const bool is_positive =
        sign == Sign::nonzero && is_among(Condition{c.p, Sign::positive}, known);
    if (!is_constant(c.p) && !is_among(c, known) && !is_positive) known.push_back(c);
  };
  for (const Assumption& a : s_.assumptions) {
    if (!is_constant(a.value.den())) add(a.value.den(), Sign::nonzero);
    const MPoly p = is_constant(a.value.den()) ? a.value.num() : a.value.num() * a.value.den();
    if (const auto* sign = std::get_if<Sign>(&a.says))
      add(certify::is_ordered(*sign) ? p : a.value.num(), *sign);
  }
  for (const MPoly& p : s_.domain.nonzero())
    add(p, Sign::nonzero);
}

certify::PhaseFunction BundleFamily::written(const MFraction& f) {
  if (is_zero(f)) return {MPoly(ring()), Integer(1)};
  const std::size_t known = writer_.divisors().size();
  PhaseWriter trial = writer_;
  trial.divide(f);
  if (trial.divisors().size() != known) throw DomainError("a denominator that the system has not");
  return writer_.write(f);
}

PartPlace BundleFamily::placed(const Substitution& put, std::vector<Condition> region) const {
  PartPlace x{{&family_, {}, std::move(region)}, {}, put, {}};
  std::vector<Json> rows;
  for (const auto& [i, f] : put) {
    if (!is_constant(f.den()))
      throw DomainError(ring()->name(i) + " is put to a quotient of parameters");
    x.at[i] = {f.num(), f.den().coefficient(0)};
    rows.push_back(json_list({json_text(ring()->name(i)), certify::to_json(x.at[i])}));
  }
  x.values = json_list(std::move(rows));
  for (const auto* all : {&assumptions(), &std::as_const(x.region)})
    for (const Condition& c : *all)
      x.given.push_back({certify::primitive(substitute(c.p, x.put).num()), c.sign});
  return x;
}

PartPlace BundleFamily::placed(const ParameterValues& at, const System& base,
                               std::vector<Condition> region) const {
  Substitution put;
  for (const auto& [name, text] : at) {
    const auto value = base.values.find(name);
    if (value == base.values.end()) throw DomainError(name + " has no value");
    if (!is_among(name, parameters()))
      throw DomainError(name + " is not a parameter of " + this->name());
    put[ring()->index(name)] = transfer(value->second, ring());
  }
  return placed(put, std::move(region));
}

Json::Object BundleFamily::members() const {
  std::vector<Json> names, complex;
  for (const std::string& p : parameters()) {
    names.push_back(json_text(p));
    if (family_.complex[ring()->index(p)]) complex.push_back(json_text(p));
  }
  return {{"name", json_text(name())},
          {"parameters", json_list(std::move(names))},
          {"complex", json_list(std::move(complex))},
          {"system", certify::to_json(phase())},
          {"assumptions", json_conditions(assumptions())}};
}

// (L1) to (L3): the Lagrangian has the velocities as names of its own.
Json BundleFamily::json_with_lagrangian() {
  if (!s_.lagrangian || !is_constant(s_.lagrangian->den())) return json();
  const VectorField& v = s_.field;
  std::vector<Json> velocities;
  std::vector<std::string> names = ring()->names();
  for (std::size_t i = 0; i < s_.velocities.size(); ++i) {
    names.push_back(v.ring->name(s_.velocities[i]));
    velocities.push_back(
        Json{Json::Object{{"name", json_text(names.back())},
                          {"momentum", json_text(v.name(i))},
                          {"value", certify::to_json(written(s_.velocity_values[i]))}}});
  }
  const MFraction l = transfer(*s_.lagrangian, make_ring(names));
  const certify::PhaseFunction value{l.num(), l.den().coefficient(0)};
  auto family = members();
  family.emplace_back("lagrangian",
                      Json{Json::Object{{"value", certify::to_json(value)},
                                        {"velocities", json_list(std::move(velocities))}}});
  return Json{std::move(family)};
}

} // namespace kov
