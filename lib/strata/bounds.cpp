#include "strata/bounds.hpp"

#include "exact/error.hpp"

#include <algorithm>
#include <set>

namespace kov::strata {
namespace {

const Rational half(1, 2);

// The least (finite) or greatest (infinity) integer among m/2 + i Delta, |i| <= m/2.
Rational extreme(long m, const Rational& delta, bool at_infinity) {
  for (long i = m / 2;; --i) {
    const Rational value = Rational(m / 2) + Rational(at_infinity ? i : -i) * delta;
    if (is_integer(value)) return value; // at the latest for i = 0
  }
}

// The exponent of Sym^m at the place: least order at a finite one, greatest growth at infinity.
// Unset: no integer.
std::optional<Rational> exponent(const ParametricPlace& p, long m) {
  switch (p.kind) {
  case PlaceKind::ordinary:
    return Rational(m);
  case PlaceKind::simple:
    return Rational(p.at_infinity ? 0 : m);
  case PlaceKind::regular: {
    if (p.exponent != ExponentKind::rational) return Rational(m / 2);
    if (p.log == Truth::yes)
      return Rational(m / 2) + Rational(p.at_infinity ? -m / 2 : m / 2) * p.delta;
    return extreme(m, p.delta, p.at_infinity);
  }
  default: {
    const long order = p.at_infinity ? 4 - p.order : p.order;
    const Rational value(Integer(order) * Integer(m), Integer(4));
    if (!is_integer(value)) return std::nullopt;
    return value;
  }
  }
}

} // namespace

InvariantBound invariant_bound(const Scheme& s, long m) {
  KOV_ENSURE(m >= 2 && m % 2 == 0);
  InvariantBound bound;
  InvariantForm form;
  form.m = m;
  const auto tau = exponent(s.infinity, m);
  if (!tau) return {.no_exponent = s.finite.size()};
  Rational d = *tau;
  for (PlaceIndex i = 0; i < s.finite.size(); ++i) {
    const auto e = exponent(s.finite[i], m);
    if (!e) return {.no_exponent = i};
    d -= *e * Rational(s.finite[i].degree(s.z));
    form.e.push_back(to_long(e->num()));
  }
  bound.degree = to_long(d.num());
  form.degree = bound.degree;
  if (bound.degree >= 0) bound.form = std::move(form);
  return bound;
}

namespace {

// An upper bound of |Re Delta|.
std::optional<Rational> real_part(const ParametricPlace& p,
                                  const std::optional<Rational>& open_square_bound) {
  if (p.exponent == ExponentKind::rational) return p.delta;
  if (p.negative_square) return Rational(0);
  const auto root_above = [](const Rational& square) {
    for (long k = 0; k < 4000; ++k)
      if (Rational(k * k, 64) >= square) return std::optional(Rational(k, 8));
    return std::optional<Rational>();
  };
  if (p.chi.size() == 2 && is_constant(p.chi[0])) return root_above(-to_rational(p.chi[0]));
  if (p.exponent == ExponentKind::open && open_square_bound) return root_above(*open_square_bound);
  return std::nullopt;
}

} // namespace

ExponentialBound exponential_bound(const Scheme& s,
                                   const std::optional<Rational>& open_square_bound) {
  ExponentialBound bound;
  Rational d;
  bool known = true;
  const auto add = [&](const ParametricPlace& p) {
    const Rational n(p.at_infinity ? 1 : p.degree(s.z));
    const Rational side(p.at_infinity ? -1 : 1);
    switch (p.kind) {
    case PlaceKind::ordinary:
      d += Rational(1);
      return;
    case PlaceKind::simple:
      if (!p.at_infinity) d -= n;
      return;
    case PlaceKind::regular: {
      const auto re = real_part(p, open_square_bound);
      if (!re)
        known = false;
      else if (p.log == Truth::yes)
        d -= side * n * (Rational(1) + side * *re) * half;
      else
        d -= side * n * (Rational(1) - side * *re) * half;
      return;
    }
    case PlaceKind::ramified:
      bound.odd_order = true;
      return;
    default:
      known = false;
    }
  };
  add(s.infinity);
  for (const auto& p : s.finite)
    add(p);
  if (known) bound.d = d;
  return bound;
}

namespace {

using Set = std::set<Rational>;

Set sums(const Set& a, const std::vector<Rational>& choices) {
  Set all;
  for (const auto& x : a)
    for (const auto& c : choices)
      all.insert(x + c);
  return all;
}

constexpr std::size_t most_families = 4000;

// Every root chooses; `choices` of a place gives unset when it is not a list of rational numbers.
template <class Choices>
Families families(const Scheme& s, const ParametricPlace* open, const Rational& start,
                  Choices choices) {
  Families f;
  Set all{start};
  const auto add = [&](const ParametricPlace& p) {
    if (&p == open) return true;
    const auto c = choices(p);
    if (!c) return false;
    for (long i = 0; i < p.degree(s.z); ++i) {
      all = sums(all, *c);
      if (all.size() > most_families) return false;
    }
    return true;
  };
  f.complete = add(s.infinity) && std::ranges::all_of(s.finite, add);
  f.fixed.assign(all.begin(), all.end());
  return f;
}

// The possible summands of one root of the place in d.
std::optional<std::vector<Rational>> exponential_choices(const ParametricPlace& p) {
  const Rational side(p.at_infinity ? 1 : -1);
  switch (p.kind) {
  case PlaceKind::ordinary:
    return std::vector<Rational>{Rational(0), Rational(1)};
  case PlaceKind::simple:
    return std::vector<Rational>{Rational(p.at_infinity ? 0 : -1)};
  case PlaceKind::regular: {
    if (p.exponent != ExponentKind::rational) return std::nullopt;
    // alpha = (1 + Delta)/2 finite, growth (1 - Delta)/2 at infinity: the log-free line
    const Rational free = side * (Rational(1) - side * p.delta) * half;
    const Rational other = side * (Rational(1) + side * p.delta) * half;
    if (p.log == Truth::yes) return std::vector<Rational>{free};
    return std::vector<Rational>{free, other};
  }
  default:
    return std::nullopt;
  }
}

} // namespace

Families exponential_families(const Scheme& s, const ParametricPlace& open) {
  const Rational n(open.degree(s.z));
  return families(s, &open, open.at_infinity ? half : -n * half, exponential_choices);
}
Families exponential_families(const Scheme& s) {
  return families(s, nullptr, Rational(0), exponential_choices);
}

Integer common_denominator(const Scheme& s) {
  Integer n(2);
  for (const auto& p : s.finite)
    n = lcm(n, ((Rational(1) + p.delta) * half).den());
  return n;
}

Families product_families(const Scheme& s, const ParametricPlace& open) {
  // exponents of v^2: {2, 2 +- 2 Delta} and Z, order for irregular places
  const Rational n(open.degree(s.z));
  const auto choices = [](const ParametricPlace& p) -> std::optional<std::vector<Rational>> {
    const Rational side(p.at_infinity ? 1 : -1);
    const Rational two(2);
    switch (p.kind) {
    case PlaceKind::ordinary:
      return std::vector<Rational>{Rational(0), two, Rational(4)};
    case PlaceKind::simple:
      return std::vector<Rational>{Rational(p.at_infinity ? 0 : -4)};
    case PlaceKind::regular: {
      if (p.exponent == ExponentKind::irrational) return std::vector<Rational>{side * two};
      if (p.exponent == ExponentKind::open) return std::nullopt;
      if (p.log == Truth::yes) return std::vector<Rational>{side * (two - side * two * p.delta)};
      std::vector<Rational> c{side * two};
      if (is_integer(two * p.delta)) {
        c.push_back(side * (two + two * p.delta));
        c.push_back(side * (two - two * p.delta));
      }
      return c;
    }
    default:
      return std::vector<Rational>{p.at_infinity ? Rational(4 - p.order) : -Rational(p.order)};
    }
  };
  return families(s, &open, open.at_infinity ? Rational(2) : -Rational(2) * n, choices);
}

} // namespace kov::strata
