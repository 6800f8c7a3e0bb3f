#include "theorem/bundle_place.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "integrability/parameters.hpp"
#include "proof/algebra/arithmetic.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr int proof_depth = 4;

Json over_number(const MPoly& p, const Integer& n) {
  if (n == Integer(1)) return json_text(to_string(p));
  return json_list({json_text(to_string(p)), json_text(to_string(n))});
}

// The polynomial in a ring that has its names.
MPoly in_ring(const MPoly& f, const Ring& ring) {
  return is_zero(f) ? MPoly(ring) : transfer(MFraction(f), ring).num();
}

Condition primitive(const MFraction& f, Sign sign) { return {certify::primitive(f.num()), sign}; }

} // namespace

FamilyWriter::FamilyWriter(const System& s, std::string name,
                           const std::vector<Assumption>& assumed)
    : s_(s), name_(std::move(name)), writer_(s_) {
  const VectorField& v = s_.field;
  if (!v.hamiltonian || !v.poisson || !v.functions.empty() || !v.relations.empty() ||
      !v.constants.empty())
    throw DomainError("the system of " + name_ + " is not given by a Hamiltonian and a bracket");
  writer_.divide(*v.hamiltonian);
  for (const auto& row : *v.poisson)
    for (const MFraction& x : row)
      if (!is_zero(x)) writer_.divide(x);
  writer_.make_ring();
  System real = s_; // as all members of a family are
  real.assumptions = assumed;
  real.domain = {}; // its denominators stand beside the assumptions
  for (const std::size_t i : s_.field.parameters)
    real.real.insert(s_.ring()->name(i));
  for (const Condition& c : assumptions_on(real, s_.ring()).conditions)
    assumptions_.push_back(moved(c));
}

Condition FamilyWriter::moved(const Condition& c) const { return {in_ring(c.p, ring()), c.sign}; }

std::string FamilyWriter::inverse_name(std::size_t k) const {
  return ring()->name(writer_.first_inverse() + k);
}

std::vector<std::string> FamilyWriter::parameters() const {
  const auto& names = ring()->names();
  return {names.begin() + static_cast<long>(writer_.first_inverse() + divisors().size()),
          names.end()};
}

Json FamilyWriter::function(const MFraction& f) {
  const certify::PhaseFunction g = writer_.write(f);
  return over_number(g.p, g.n);
}

Json json_conditions(const std::vector<Condition>& all) {
  std::vector<Json> rows;
  for (const Condition& c : all)
    rows.push_back(Json{Json::Object{{"p", json_text(to_string(c.p))},
                                     {"sign", json_text(certify::to_string(c.sign))}}});
  return json_list(std::move(rows));
}

Json FamilyWriter::json() {
  const VectorField& v = s_.field;
  std::vector<Json> coordinates, inverses, brackets, names;
  for (std::size_t i = 0; i < v.dimension(); ++i)
    coordinates.push_back(json_text(v.name(i)));
  for (std::size_t k = 0; k < divisors().size(); ++k)
    inverses.push_back(
        Json{Json::Object{{"name", json_text(inverse_name(k))},
                          {"of", json_text(to_string(writer_.moved(divisors()[k])))}}});
  for (std::size_t i = 0; i < v.dimension(); ++i)
    for (std::size_t j = i + 1; j < v.dimension(); ++j)
      if (!is_zero((*v.poisson)[i][j]))
        brackets.push_back(
            json_list({json_text(v.name(i)), json_text(v.name(j)), function((*v.poisson)[i][j])}));
  for (const std::string& p : parameters())
    names.push_back(json_text(p));
  Json::Object system{{"coordinates", json_list(std::move(coordinates))}};
  if (!inverses.empty()) system.emplace_back("inverses", json_list(std::move(inverses)));
  system.emplace_back("hamiltonian", function(*v.hamiltonian));
  system.emplace_back("brackets", json_list(std::move(brackets)));
  Json::Object family{{"name", json_text(name_)},
                      {"parameters", json_list(std::move(names))},
                      {"system", Json{std::move(system)}},
                      {"assumptions", json_conditions(assumptions_)}};
  if (s_.lagrangian && is_constant(s_.lagrangian->den()))
    family.emplace_back("lagrangian", lagrangian());
  return Json{std::move(family)};
}

// (L1) to (L3): the Lagrangian has the velocities as names of its own.
Json FamilyWriter::lagrangian() {
  const VectorField& v = s_.field;
  std::vector<Json> velocities;
  for (std::size_t i = 0; i < s_.velocities.size(); ++i)
    velocities.push_back(Json{Json::Object{{"name", json_text(v.ring->name(s_.velocities[i]))},
                                           {"momentum", json_text(v.name(i))},
                                           {"value", function(s_.velocity_values[i])}}});
  std::vector<std::string> names = ring()->names();
  for (const std::size_t w : s_.velocities)
    names.push_back(v.ring->name(w));
  const MFraction& l = *s_.lagrangian;
  return Json{Json::Object{
      {"value", over_number(in_ring(l.num(), make_ring(names)), l.den().coefficient(0))},
      {"velocities", json_list(std::move(velocities))}}};
}

BundleTarget target_of(const FamilyWriter& y, const std::vector<Condition>& region, bool real) {
  BundleTarget t;
  for (std::size_t i = 0; i < y.system().field.dimension(); ++i)
    t.coordinates.push_back(y.system().field.name(i));
  t.parameters = y.parameters();
  for (std::size_t k = 0; k < y.divisors().size(); ++k)
    t.inverses.emplace_back(y.inverse_name(k), in_ring(y.divisors()[k], y.ring()));
  for (const std::string& p : t.parameters)
    if (real) t.asked.push_back({true, Sign::nonzero, MPoly::variable(y.ring(), p)});
  for (const auto* all : {&y.assumptions(), &region})
    for (const Condition& c : *all)
      t.asked.push_back({false, c.sign, c.p});
  return t;
}

certify::Said said_by(const std::string& certificate) {
  constexpr int deepest = 512;
  try {
    return certify::said_by_certificate(
        certify::Node(certify::parse_json(certificate, deepest), "certificate", rationals()));
  } catch (const certify::Refused& no) {
    throw DomainError(no.why);
  }
}

BundleTarget target_of(const certify::Said& said) {
  if (said.kind != certify::FactKind::not_integrable)
    throw DomainError("the certificate does not say \"not integrable\" of all its points");
  const certify::PhaseSystem& s = *said.system;
  BundleTarget t;
  const auto& names = s.ring->names();
  t.coordinates.assign(names.begin(), names.begin() + static_cast<long>(s.dimension));
  t.parameters.assign(names.begin() + static_cast<long>(s.first_parameter()), names.end());
  const std::vector<bool> used = certify::used_names(s);
  for (std::size_t k = 0; k < s.inverses.size(); ++k)
    if (used[s.first_inverse() + k])
      t.inverses.emplace_back(names[s.first_inverse() + k], s.inverses[k]);
  t.asked = said.target->asked;
  return t;
}

std::pair<Json, std::vector<Condition>> at_members(const FamilyWriter& x, const ParameterValues& at,
                                                   const System& base) {
  std::vector<Json> rows;
  std::vector<Condition> equations;
  for (const std::string& p : x.parameters()) {
    if (std::ranges::none_of(at, [&](const auto& v) { return v.first == p; })) continue;
    const MFraction value = transfer(base.values.at(p), x.ring());
    const bool zero = is_zero(value);
    if (!zero && !is_constant(value.den()))
      throw DomainError(p + " is put to a quotient of parameters");
    const MPoly num = zero ? MPoly(x.ring()) : value.num();
    const Integer n = zero ? Integer(1) : value.den().coefficient(0);
    rows.push_back(json_list({json_text(p), over_number(num, n)}));
    equations.push_back({certify::scaled(MPoly::variable(x.ring(), p), n) - num, Sign::zero});
  }
  return {json_list(std::move(rows)), equations};
}

namespace {

class MapWriter {
public:
  MapWriter(const FamilyWriter& x, const ParameterValues& at, const System& base,
            const PlaceMap& map, const std::vector<Condition>& region, const BundleTarget& y,
            const Budget& budget)
      : x_(x), map_(map), y_(y), budget_(budget) {
    for (const auto& [name, value] : at)
      at_[map.ring->index(name)] = transfer(base.values.at(name), map.ring);
    make_names();
    for (const auto* all : {&x.assumptions(), &region})
      for (const Condition& c : *all)
        given_.push_back(primitive(put(MFraction(c.p)), c.sign));
    for (std::size_t k = 0; k < x.divisors().size(); ++k)
      divisors_.push_back(certify::primitive(put(MFraction(x.divisors()[k])).num()));
    for (const auto& [variable, square] : map.roots.all())
      adjoined_.push_back(Json{Json::Object{{"name", json_text(map.ring->name(variable))},
                                            {"square", element(square)}}});
  }

  Json::Object operator()() {
    choose_levels();
    Json::Object values;
    for (const auto* names : {&y_.coordinates, &y_.parameters})
      for (const std::string& name : *names)
        values.emplace_back(name, element(value(name)));
    for (const auto& [name, h] : y_.inverses)
      values.emplace_back(name, element(inverse_of(phi(h)), true));
    Json back = inverse_matrix();
    const MFraction one(map_.ring, Rational(1));
    const MFraction c = map_.roots.reduced(map_.bracket ? *map_.bracket : one);
    const MFraction k = map_.roots.reduced(map_.time / c);
    Json bracket = json_list({element(c), element(one / c)});
    Json energy = json_list({element(k), element(one / k)});
    Json shown_rows = json_list(shown_);
    return {{"adjoined", json_list(adjoined_)}, {"values", Json{std::move(values)}},
            {"back", std::move(back)},          {"bracket", std::move(bracket)},
            {"energy", std::move(energy)},      {"shown", std::move(shown_rows)}};
  }

private:
  // The names of X and the roots, the inverses of X, and v1, v2, ...
  void make_names() {
    auto names = map_.ring->names();
    first_inverse_ = names.size();
    for (std::size_t k = 0; k < x_.divisors().size(); ++k)
      names.push_back(x_.inverse_name(k));
    first_fresh_ = names.size();
    for (std::size_t k = 1; k <= most_fresh; ++k) {
      std::string name = "v" + std::to_string(k);
      while (is_among(name, names))
        name += "_";
      names.push_back(name);
    }
    names_ = make_ring(names);
  }
  // A function of X in the ring of the map, with the values of `at`.
  [[nodiscard]] MFraction put(const MFraction& f) const {
    return at_.empty() ? transfer(f, map_.ring) : substitute(transfer(f, map_.ring), at_);
  }
  [[nodiscard]] MFraction value(const std::string& name) const {
    const auto found = map_.values.find(name);
    if (found != map_.values.end()) return map_.roots.reduced(found->second);
    return levels_.at(name);
  }
  // f of Y with the values put in.
  [[nodiscard]] MFraction phi(const MPoly& f) const {
    MFraction sum(map_.ring, Rational(0));
    for (long t = 0; t < f.length(); ++t) {
      MFraction term(map_.ring, Rational(f.coefficient(t)));
      const auto e = f.exponents(t);
      for (std::size_t i = 0; i < e.size(); ++i)
        if (e[i] > 0) term = term * pow(value(f.ring()->name(i)), static_cast<long>(e[i]));
      sum = sum + term;
    }
    return is_zero(sum) ? sum : map_.roots.reduced(sum);
  }
  static MFraction inverse_of(const MFraction& f) {
    if (is_zero(f)) throw DomainError("a denominator is 0 everywhere");
    return MFraction(f.den(), f.num());
  }

  // ---- what is divided by

  // 1/base as a polynomial in the names; of_x: by an inverse of X if it can be.
  MPoly inverse_name(const MPoly& base, bool of_x) {
    for (std::size_t k = 0; k < divisors_.size(); ++k)
      if (of_x)
        if (const auto rest = divides(base, divisors_[k]))
          return MPoly::variable(names_, first_inverse_ + k) * in_ring(*rest, names_);
    const auto known = std::ranges::find(fresh_, base);
    if (known == fresh_.end()) {
      adjoin(base);
      return MPoly::variable(names_, first_fresh_ + fresh_.size() - 1);
    }
    return MPoly::variable(names_, first_fresh_ + static_cast<std::size_t>(known - fresh_.begin()));
  }
  [[nodiscard]] bool uses_coordinates(const MPoly& f) const {
    const auto used = used_variables(f);
    return std::ranges::any_of(used, [&](std::size_t i) {
      const auto& names = f.ring()->name(i);
      const VectorField& v = x_.system().field;
      for (std::size_t j = 0; j < v.dimension(); ++j)
        if (v.name(j) == names) return true;
      return false;
    });
  }
  void adjoin(const MPoly& base) {
    if (uses_coordinates(base))
      throw DomainError("a denominator of the step is none of the system");
    if (fresh_.size() == most_fresh) throw DomainError("too many denominators");
    const auto [norm, times] = map_.roots.norm_and_factor(base);
    auto proof = shown(map_.ring, given_, {norm, Sign::nonzero}, proof_depth, budget_);
    if (!proof) throw DomainError("it is not shown that " + to_string(norm) + " is not 0");
    fresh_.push_back(base);
    adjoined_.push_back(
        Json{Json::Object{{"name", json_text(names_->name(first_fresh_ + fresh_.size() - 1))},
                          {"inverse", json_text(to_string(base))},
                          {"times", json_text(to_string(times))},
                          {"norm", json_text(to_string(norm))},
                          {"by", *std::move(proof)}}});
  }
  Json element(const MFraction& f, bool of_x = false) {
    if (is_zero(f)) return json_text("0");
    MPoly p = in_ring(f.num(), names_);
    Integer n(1);
    if (is_constant(f.den())) {
      n = f.den().coefficient(0);
    } else {
      const auto [content, factors] = factor(f.den());
      n = content;
      for (const MFactor& d : factors) {
        const MPoly u = inverse_name(d.base, of_x);
        for (long e = 0; e < d.exponent; ++e)
          p = p * u;
      }
    }
    if (sign(n) < 0) return over_number(-p, -n);
    return over_number(p, n);
  }

  // ---- the inverse matrix

  Json inverse_matrix() {
    const std::size_t n = map_.jacobian.size();
    auto a = map_.jacobian;
    const MFraction zero(map_.ring, Rational(0)), one(map_.ring, Rational(1));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        if (is_zero(a[i][j])) a[i][j] = zero;
        a[i].push_back(i == j ? one : zero);
      }
    for (std::size_t k = 0; k < n; ++k) {
      std::size_t i = k;
      while (i < n && is_zero(map_.roots.reduced(a[i][k])))
        ++i;
      if (i == n) throw DomainError("the change of variables is singular");
      std::swap(a[i], a[k]);
      const MFraction p = one / a[k][k];
      for (MFraction& x : a[k])
        x = map_.roots.reduced(x * p);
      for (std::size_t r = 0; r < n; ++r) {
        const MFraction c = a[r][k];
        if (r == k || is_zero(c)) continue;
        for (std::size_t j = 0; j < 2 * n; ++j)
          if (!is_zero(a[k][j])) a[r][j] = map_.roots.reduced(a[r][j] - c * a[k][j]);
      }
    }
    std::vector<Json> rows;
    for (std::size_t i = 0; i < n; ++i) {
      std::vector<Json> row;
      for (std::size_t j = n; j < 2 * n; ++j)
        row.push_back(element(a[i][j]));
      rows.push_back(json_list(std::move(row)));
    }
    return json_list(std::move(rows));
  }

  // ---- what is shown

  // Values of the levels for which everything is shown.
  void choose_levels() {
    std::vector<std::string> open;
    for (const std::string& p : y_.parameters)
      if (!map_.values.contains(p)) open.push_back(p);
    if (open.size() > 1) throw DomainError("more than one level is open");
    std::vector<MFraction> candidates;
    for (const long x : {1L, 2L, 3L, 5L, -1L, -2L, 0L})
      candidates.emplace_back(map_.ring, Rational(x));
    if (open.empty()) return show_all();
    for (const MFraction& x : candidates) {
      levels_[open.front()] = x;
      try {
        return show_all();
      } catch (const DomainError&) {
        if (&x == &candidates.back()) throw;
      }
    }
  }
  void show_all() {
    shown_.clear();
    for (const certify::AskedCondition& a : y_.asked) {
      if (!a.real && a.sign == Sign::zero) {
        if (!is_zero(phi(a.f))) throw DomainError("an equation does not hold");
        continue;
      }
      show(a);
    }
  }
  void show(const certify::AskedCondition& a) {
    if (!a.group.empty()) return show_group(a);
    const MFraction f = phi(a.f);
    const bool square = map_.roots.uses_root(f) && (a.real || a.sign == Sign::nonzero);
    certify::AskedCondition asked = a;
    if (square && a.real) asked = {false, Sign::positive, a.f};
    auto row = shown_row(asked, square ? map_.roots.reduced(f * f) : f);
    if (!row)
      throw DomainError("it is not shown that " + brief(f, 80) +
                        (a.real ? " is real" : std::string(" is ") + certify::to_string(a.sign)));
    if (square) row->emplace_back("square", Json{true});
    shown_.push_back(Json{*std::move(row)});
  }
  // One member if that is enough, else all.
  void show_group(const certify::AskedCondition& a) {
    std::vector<std::vector<std::size_t>> tries;
    std::vector<std::size_t> all;
    for (std::size_t k = 0; k < a.group.size(); ++k) {
      const MFraction f = phi(a.group[k]);
      if (is_zero(f) || map_.roots.uses_root(f)) continue;
      tries.push_back({k});
      all.push_back(k);
    }
    tries.push_back(all);
    for (const auto& chosen : tries)
      if (auto row = group_row(a, chosen, chosen.size() > 1 ? proof_depth : 1)) {
        shown_.push_back(*std::move(row));
        return;
      }
    throw DomainError("it is not shown that not all of a group vanish, such as " +
                      brief(phi(a.group.front()), 80));
  }
  std::optional<Json> group_row(const certify::AskedCondition& a,
                                const std::vector<std::size_t>& chosen, int depth) {
    std::vector<Json> rows;
    auto zeros = given_;
    for (const std::size_t k : chosen) {
      const MFraction f = phi(a.group[k]);
      const MPoly value = f.num() * f.den();
      rows.push_back(json_list({json_text(std::to_string(k)), json_text(to_string(f.den())),
                                json_text(to_string(value))}));
      zeros.push_back({value, Sign::zero});
    }
    auto proof = refutation(map_.ring, zeros, depth, budget_);
    if (!proof) return std::nullopt;
    return Json{Json::Object{{"chosen", json_list(std::move(rows))}, {"by", *std::move(proof)}}};
  }
  std::optional<Json::Object> shown_row(const certify::AskedCondition& a, const MFraction& f) {
    const bool zero = is_zero(f);
    const MPoly over = zero ? MPoly(map_.ring, Integer(1)) : f.den();
    const MPoly value = zero ? MPoly(map_.ring) : f.num() * f.den();
    Condition c{a.real ? over : value, a.real ? Sign::nonzero : a.sign};
    if (c.sign == Sign::nonnegative && !is_constant(over)) c.sign = Sign::positive;
    auto proof = shown(map_.ring, given_, c, proof_depth, budget_);
    if (!proof) return std::nullopt;
    return Json::Object{{"over", json_text(to_string(over))},
                        {"value", json_text(to_string(value))},
                        {"by", *std::move(proof)}};
  }

  static constexpr std::size_t most_fresh = 20;

  const FamilyWriter& x_;
  const PlaceMap& map_;
  const BundleTarget& y_;
  const Budget& budget_;
  Substitution at_;
  std::size_t first_inverse_ = 0, first_fresh_ = 0;
  Ring names_;
  std::vector<Condition> given_;
  std::vector<MPoly> divisors_, fresh_;
  std::map<std::string, MFraction> levels_;
  std::vector<Json> adjoined_, shown_;
};

} // namespace

Json::Object map_members(const FamilyWriter& x, const ParameterValues& at, const System& base,
                         const PlaceMap& map, const std::vector<Condition>& region,
                         const BundleTarget& y, const Budget& budget) {
  return MapWriter(x, at, base, map, region, y, budget)();
}

} // namespace kov
