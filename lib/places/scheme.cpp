#include "places/scheme.hpp"

#include "exact/error.hpp"
#include "exact/finite_algebra.hpp"
#include "places/irrational.hpp"

#include <algorithm>

namespace kov::strata {
namespace {

using Element = FiniteAlgebra::Element;

// The events that change the set of poles: content of den(r), leading coefficients, discriminants,
// resultants.
std::optional<Needs> merging(const std::vector<MPoly>& places, std::size_t z,
                             const ParametrisedSet& region) {
  using enum Event::Kind;
  const auto need = [&](const MPoly& event, Event::Kind why) -> std::optional<Needs> {
    if (auto p = region.doubtful_factor(event)) return Needs{*std::move(p), {why}};
    return std::nullopt;
  };
  for (const auto& q : places)
    if (auto n = need(coefficients(q, z).back(), pole_to_infinity)) return n;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (degree(places[i], z) > 1)
      if (auto n = need(discriminant(places[i], z), poles_meet)) return n;
    for (std::size_t j = 0; j < i; ++j)
      if (auto n = need(resultant(places[i], places[j], z), poles_meet)) return n;
  }
  return std::nullopt;
}

// r near one place, in the residue field Q(parameters)[c]/q.
class Local {
public:
  Local(const MFraction& r, std::size_t z, const MPoly& q, const ParametrisedSet& region)
      : num_(r.num()), den_(r.den()), z_(z), q_(q), region_(region),
        field_(Ideal(q.ring(), {z}, {q})) {}

  /// f^(k)(c)/k!
  [[nodiscard]] Element taylor(const MPoly& f, long k) const {
    MPoly g = f;
    Integer factorial(1);
    for (long i = 1; i <= k; ++i) {
      g = derivative(g, z_);
      factorial *= Integer(i);
    }
    return *field_.evaluate(Rational(Integer(1), factorial) * MFraction(g));
  }

  /// 1 + 4 num(c)/(den''(c)/2)
  [[nodiscard]] Element delta_squared() const {
    const auto unit = field_.invert(taylor(den_, 2));
    KOV_ENSURE(unit); // a double root of den
    const MFraction four(field_.ring(), Rational(4));
    return field_.constant(MFraction(field_.ring(), Rational(1))) +
           scale(field_.multiply(taylor(num_, 0), *unit), four);
  }
  [[nodiscard]] std::vector<MFraction> minimal_polynomial(const Element& e) const {
    return field_.minimal_polynomial(e);
  }

  /// The obstruction to a solution without logarithm: linode/logarithm.hpp.
  [[nodiscard]] Element log_defect(long N) const {
    const Element unit = *field_.invert(taylor(den_, 2));
    std::vector<Element> u{field_.constant(MFraction(field_.ring(), Rational(1)))};
    for (long k = 1; k <= N; ++k) {
      Element sum = field_.zero();
      for (long j = 1; j <= k; ++j) {
        const long s = 2 * (k - j) - N;
        const MFraction weight(field_.ring(), Rational(s * s - 1, 4));
        const Element c = taylor(num_, j) - scale(taylor(den_, j + 2), weight);
        sum = sum + field_.multiply(c, u[static_cast<std::size_t>(k - j)]);
      }
      if (k == N) return sum;
      const MFraction over(field_.ring(), Rational(1, k * (k - N)));
      u.push_back(scale(field_.multiply(sum, unit), over));
    }
    throw InternalError("log_defect: N >= 1");
  }

  /// Zero at a root of q only where this vanishes.
  [[nodiscard]] MPoly norm(const Element& e) const {
    const MFraction f = field_.lift(e);
    return uses(f, z_) ? resultant(q_, f.num(), z_) : f.num();
  }
  /// A denominator that is not known to be nonzero.
  [[nodiscard]] std::optional<MPoly> doubtful_denominator(const Element& e) const {
    for (const auto& c : e)
      if (c.ring() && !is_zero(c))
        if (auto p = region_.doubtful_factor(c.den())) return p;
    return std::nullopt;
  }

private:
  MPoly num_, den_;
  std::size_t z_;
  MPoly q_;
  const ParametrisedSet& region_;
  FiniteAlgebra field_;
};

// t^-4 r(1/t), written in z.
MFraction at_infinity(const MFraction& r, std::size_t z) {
  const MFraction t = MFraction::variable(r.ring(), z);
  return substitute(r, {{z, MFraction(t.ring(), Rational(1)) / t}}) / pow(t, 4);
}

// Discriminants and resultants of larger equations cannot be interrupted.
constexpr long most_numerator_terms = 500;

constexpr long max_log_order = 40; // above: the question of a logarithm stays open

class SchemeBuilder {
public:
  SchemeBuilder(const MFraction& r, std::size_t z, const ParametrisedSet& region,
                const Budget& budget)
      : region_(region), budget_(budget) {
    scheme_.r = r;
    scheme_.z = z;
  }

  std::variant<Scheme, Needs> build() {
    if (scheme_.r.num().length() > most_numerator_terms)
      throw OutOfBudget("r has " + std::to_string(scheme_.r.num().length()) +
                        " terms in its numerator, the limit is " +
                        std::to_string(most_numerator_terms));
    const auto [content, factors] = factor(scheme_.r.den());
    std::vector<MPoly> places;
    for (const auto& f : factors) {
      if (uses(f.base, scheme_.z)) {
        places.push_back(f.base);
      } else if (auto p = region_.doubtful_factor(f.base)) {
        return Needs{*std::move(p), {Event::Kind::no_value}};
      }
    }
    if (auto n = merging(places, scheme_.z, region_)) return *n;
    for (const auto& f : factors) {
      if (!uses(f.base, scheme_.z)) continue;
      ParametricPlace p;
      p.q = f.base;
      p.order = f.exponent;
      if (auto n = finish(p, scheme_.r)) return *n;
      scheme_.finite.push_back(std::move(p));
    }
    if (auto n = infinity()) return *n;
    return scheme_;
  }

private:
  std::optional<Needs> infinity() {
    const std::size_t z = scheme_.z;
    ParametricPlace& p = scheme_.infinity;
    p.at_infinity = true;
    p.q = MPoly::variable(scheme_.r.ring(), z);
    const MPoly num = scheme_.r.num();
    const MPoly den = scheme_.r.den();
    p.order = 4 - (degree(den, z) - degree(num, z));
    if (p.order <= 0) return std::nullopt; // an ordinary point, also where num drops
    if (auto n = lower_order(p, coefficients(num, z).back())) return n;
    return finish(p, at_infinity(scheme_.r, z));
  }

  // Orders 1 and >= 3 must be exact: `top` is the coefficient that makes them so.
  std::optional<Needs> lower_order(const ParametricPlace& p, const MPoly& top) const {
    if (p.order == 2) return std::nullopt;
    if (auto d = region_.doubtful_factor(top))
      return Needs{*std::move(d), {Event::Kind::order_drops, name_of(p, scheme_.z)}};
    return std::nullopt;
  }

  std::optional<Needs> finish(ParametricPlace& p, const MFraction& r) const {
    budget_.check();
    if (!p.at_infinity && p.order != 2)
      if (auto n = lower_order(p, resultant(p.q, r.num(), scheme_.z))) return n;
    if (p.order == 1) {
      p.kind = PlaceKind::simple;
      p.log = Truth::yes;
      return std::nullopt;
    }
    if (p.order > 2) {
      p.kind = p.order % 2 == 0 ? PlaceKind::irregular : PlaceKind::ramified;
      return std::nullopt;
    }
    p.kind = PlaceKind::regular;
    return regular(p, Local(r, scheme_.z, p.q, region_));
  }

  std::optional<Needs> regular(ParametricPlace& p, const Local& local) const {
    const Element square = local.delta_squared();
    if (auto d = local.doubtful_denominator(square))
      return Needs{*std::move(d), {Event::Kind::exponents_change, name_of(p, scheme_.z)}};
    p.chi = local.minimal_polynomial(square);
    for (const auto& c : p.chi)
      if (c.ring() && !is_zero(c))
        if (auto d = region_.doubtful_factor(c.den()))
          return Needs{*std::move(d), {Event::Kind::exponents_change, name_of(p, scheme_.z)}};
    eliminate_relations(p.chi, region_);
    if (auto n = classify_exponent(p, region_)) return n;
    if (p.exponent == ExponentKind::rational && is_integer(p.delta)) logarithm(p, local);
    return std::nullopt;
  }

  void logarithm(ParametricPlace& p, const Local& local) const {
    if (p.delta == Rational(0)) {
      p.log = Truth::yes;
      return;
    }
    p.log = Truth::unknown;
    if (p.delta > Rational(max_log_order)) return;
    const Element defect = local.log_defect(to_long(p.delta.num()));
    if (is_zero(defect)) {
      p.log = local.doubtful_denominator(defect) ? Truth::unknown : Truth::no;
      return;
    }
    MPoly norm = local.norm(defect);
    const auto doubt = region_.doubtful_factor(norm);
    if (doubt) {
      p.log_norm = doubt;
    } else if (!is_zero(norm)) {
      p.log = Truth::yes;
      p.log_norm = std::move(norm);
    }
  }

  const ParametrisedSet& region_;
  const Budget& budget_;
  Scheme scheme_;
};

} // namespace

std::variant<Scheme, Needs> scheme(const MFraction& r, std::size_t z, const ParametrisedSet& region,
                                   const Budget& budget) {
  return SchemeBuilder(r, z, region, budget).build();
}

PlaceName name_of(const ParametricPlace& p, std::size_t z) { return {p.q, p.at_infinity, z}; }

} // namespace kov::strata
