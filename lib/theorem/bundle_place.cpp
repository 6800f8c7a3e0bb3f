#include "theorem/bundle_place.hpp"

#include "exact/error.hpp"
#include "exact/linear.hpp"
#include "exact/lists.hpp"
#include "parameters/refutation.hpp"
#include "proof/algebra/arithmetic.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr int proof_depth = 4;

using certify::in_ring;

} // namespace

certify::Said said_by(const std::string& certificate) {
  constexpr int deepest = 512;
  try {
    return certify::said_by_certificate(
        certify::Node(certify::parse_json(certificate, deepest), "certificate", rationals()));
  } catch (const certify::Refused& no) {
    throw DomainError(no.why);
  }
}

namespace {

struct ModuloRoots : FieldArithmetic<MFraction> {
  const Roots& roots;

  [[nodiscard]] bool is_unit(const MFraction& x) const { return !is_zero(x) && !roots.vanishes(x); }
  void divide(std::vector<MFraction>& row, const MFraction& by) const {
    for (MFraction& x : row)
      if (!is_zero(x)) x = roots.reduced(x / by);
  }
  void subtract(MFraction& x, const MFraction& factor, const MFraction& y) const {
    x = roots.reduced(x - factor * y);
  }
};

class MapWriter {
public:
  MapWriter(const BundleFamily& x, const PartPlace& there, const PlaceMap& map,
            const certify::Target& y, const Budget& budget)
      : x_(x), map_(map), y_(y), budget_(budget) {
    for (const Condition& c : there.given)
      given_.push_back({in_ring(c.p, map.ring), c.sign});
    for (const MPoly& d : x.phase().inverses)
      divisors_.push_back(
          in_ring(certify::primitive(substitute(MFraction(d), there.put).num()), map.ring));
    const std::vector<std::string>& names = y.system->ring->names();
    const std::size_t first = y.system->first_parameter();
    for (std::size_t i = 0; i < names.size(); ++i)
      if (i < y.system->dimension || i >= first)
        (i < first ? coordinates_ : parameters_).push_back(names[i]);
    make_names();
    for (const auto& [variable, square] : map.roots.all())
      adjoined_.push_back(Json{Json::Object{{"name", json_text(map.ring->name(variable))},
                                            {"square", element(square)}}});
  }

  Json::Object operator()() {
    choose_levels();
    Json::Object values;
    for (const auto* names : {&coordinates_, &parameters_})
      for (const std::string& name : *names)
        values.emplace_back(name, element(value(name)));
    const certify::PhaseSystem& y = *y_.system;
    const std::vector<bool> used = certify::used_names(y);
    for (std::size_t k = 0; k < y.inverses.size(); ++k)
      if (const std::size_t i = y.first_inverse() + k; used[i])
        values.emplace_back(y.ring->name(i), element(inverse_of(phi(y.inverses[k])), true));
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
    for (std::size_t k = 0; k < divisors_.size(); ++k)
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
  [[nodiscard]] MFraction value(const std::string& name) const {
    const auto found = map_.values.find(name);
    if (found != map_.values.end()) return map_.roots.reduced(found->second);
    return levels_.at(name);
  }
  // f of Y with the values put in.
  [[nodiscard]] MFraction phi(const MPoly& f) const {
    std::map<std::size_t, MFraction> values;
    for (const std::size_t i : used_variables(f))
      values.emplace(i, value(f.ring()->name(i)));
    return map_.roots.reduced(composed(f, values, map_.ring));
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
      const auto j = x_.ring()->find(f.ring()->name(i));
      return j && *j < x_.phase().dimension;
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
    if (sign(n) < 0) return certify::to_json(certify::PhaseFunction{-p, -n});
    return certify::to_json(certify::PhaseFunction{p, n});
  }

  // ---- the inverse matrix

  Json inverse_matrix() {
    const std::size_t n = map_.jacobian.size();
    auto a = map_.jacobian;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        a[i].emplace_back(map_.ring, Rational(i == j ? 1 : 0));
    const auto columns = std::views::iota(std::size_t{0}, n);
    if (row_reduce(a, columns, budget_, ModuloRoots{{}, map_.roots}).size() < n)
      throw DomainError("the change of variables is singular");
    std::vector<Json> rows;
    for (const auto& row : a) {
      std::vector<Json> entries;
      for (std::size_t j = n; j < 2 * n; ++j)
        entries.push_back(element(row[j]));
      rows.push_back(json_list(std::move(entries)));
    }
    return json_list(std::move(rows));
  }

  // ---- what is shown

  // Values of the levels for which everything is shown.
  void choose_levels() {
    std::vector<std::string> open;
    for (const std::string& p : parameters_)
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

  const BundleFamily& x_;
  const PlaceMap& map_;
  const certify::Target& y_;
  const Budget& budget_;
  std::vector<std::string> coordinates_, parameters_; ///< of Y
  std::size_t first_inverse_ = 0, first_fresh_ = 0;
  Ring names_;
  std::vector<Condition> given_;
  std::vector<MPoly> divisors_, fresh_;
  std::map<std::string, MFraction> levels_;
  std::vector<Json> adjoined_, shown_;
};

} // namespace

Json::Object map_members(const BundleFamily& x, const PartPlace& there, const PlaceMap& map,
                         const certify::Target& y, const Budget& budget) {
  return MapWriter(x, there, map, y, budget)();
}

} // namespace kov
