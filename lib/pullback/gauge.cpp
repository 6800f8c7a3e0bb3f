#include "pullback/gauge.hpp"

#include "pullback/kernel.hpp"

#include <algorithm>
#include <array>

namespace kov::pullback {
namespace {

constexpr long largest_shift = 64;
constexpr std::size_t most_open_places = 5;
constexpr long most_unknowns = 400;

// Least orders at one place, of sqrt(g) b and sqrt(g) a, twice, by whether g has odd order there.
struct Orders {
  long b = 0, a = 0;
};
struct Match {
  Poly place;
  bool at_infinity = false;
  std::array<std::optional<Orders>, 2> of_parity;
};

enum class Kind : std::uint8_t { regular, irregular, ramified };

Kind kind_of(const Singularity& s) {
  if (s.kind == PlaceKind::irregular) return Kind::irregular;
  return s.kind == PlaceKind::ramified ? Kind::ramified : Kind::regular;
}

void allow(Match& m, long shift, Orders twice) {
  auto& known = m.of_parity[static_cast<std::size_t>(shift % 2)];
  if (!known) known = twice;
  known->b = std::min(known->b, twice.b);
  known->a = std::min(known->a, twice.a);
}

// The shifts s = |D - D1|, |D + D1| that are integers: s^4 - 2 (D^2 + D1^2) s^2 + (D^2 - D1^2)^2 = 0.
void match_regular(Match& m, const Singularity& e, const Singularity& l) {
  if ((e.log == Truth::yes && l.log == Truth::no) || (e.log == Truth::no && l.log == Truth::yes))
    return;
  const Poly sum = e.delta_squared + l.delta_squared;
  const Poly difference = e.delta_squared - l.delta_squared;
  const Poly last = m.at_infinity ? difference * difference : difference * difference % m.place;
  for (long s = 0; s <= largest_shift; ++s)
    if (is_zero(Poly(s * s * s * s) - scale(sum, NfElem(2 * s * s)) + last))
      allow(m, s, m.at_infinity ? Orders{-2 - s, -s} : Orders{2 - s, -s});
}

// Equal exponential parts, and residues that differ by integers: s^2 u = (beta - beta1)^2.
void match_irregular(Match& m, const Singularity& e, const Singularity& l) {
  if (e.order != l.order || !(e.leading == l.leading) || e.sqrt_tail != l.sqrt_tail) return;
  const Poly difference = e.beta - l.beta;
  const Poly square = m.at_infinity ? difference * difference : difference * difference % m.place;
  for (long s = 0; s <= largest_shift; ++s)
    if (scale(e.leading, NfElem(s * s)) == square) allow(m, s, {2 * e.nu() - s, -s});
}

Match match(const Singularity& e, const Singularity& l) {
  Match m{e.place, e.at_infinity, {}};
  if (kind_of(e) != kind_of(l)) return m;
  if (kind_of(e) == Kind::regular) {
    match_regular(m, e, l);
  } else if (kind_of(e) == Kind::irregular) {
    match_irregular(m, e, l);
  } else if (e.order == l.order) { // exponents in Z/2 or in Z/2 + 1/4, for both
    const long order = m.at_infinity ? -e.order : e.order;
    m.of_parity = {Orders{order, 0}, Orders{order, 0}};
  }
  return m;
}

Singularity ordinary(const Poly& place) {
  Singularity s;
  s.place = place;
  s.delta = Rational(1);
  return s;
}

const Singularity* find(const std::vector<Singularity>& all, const Poly& place) {
  const auto it = std::ranges::find_if(all, [&](const auto& s) { return s.place == place; });
  return it == all.end() ? nullptr : &*it;
}

// Infinity comes last.  Nothing where a place excludes a gauge.
std::optional<std::vector<Match>> matches(const Singularities& s, const Singularities& s1) {
  std::vector<Match> all;
  const auto add = [&](const Singularity& e, const Singularity& l) {
    all.push_back(match(e, l));
    return all.back().of_parity[0] || all.back().of_parity[1];
  };
  for (const Singularity& e : s.finite) {
    const Singularity* l = find(s1.finite, e.place);
    if (!add(e, l != nullptr ? *l : ordinary(e.place))) return std::nullopt;
  }
  for (const Singularity& l : s1.finite)
    if (find(s.finite, l.place) == nullptr && !add(ordinary(l.place), l)) return std::nullopt;
  if (!add(s.infinity, s1.infinity)) return std::nullopt;
  return all;
}

// The next larger half of an integer is one.
long half_up(long twice) { return twice >= 0 ? (twice + 1) / 2 : -(-twice / 2); }
long half_down(long twice) { return -half_up(-twice); }

// sqrt(g) and the outer parts of a = m P, b = n Q with degrees of P and Q.
struct OuterParts {
  Poly g = Poly(1);
  RationalFunction m = 1, n = 1;
  long deg_a = -1, deg_b = -1;
};

std::optional<OuterParts> frame(const std::vector<Match>& all, unsigned long odd) {
  OuterParts f;
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const long parity = static_cast<long>(odd >> i & 1);
    const auto& orders = all[i].of_parity[static_cast<std::size_t>(parity)];
    if (!orders) return std::nullopt;
    if (parity == 1) f.g *= all[i].place;
    f.m = f.m * pow(RationalFunction(all[i].place), half_up(orders->a - parity));
    f.n = f.n * pow(RationalFunction(all[i].place), half_up(orders->b - parity));
  }
  const auto& last = all.back().of_parity[static_cast<std::size_t>(degree(f.g) % 2)];
  if (!last) return std::nullopt;
  const auto room = [&](long twice, const RationalFunction& outer) {
    return half_down(-twice - degree(f.g)) - (degree(outer.num()) - degree(outer.den()));
  };
  f.deg_a = room(last->a, f.m);
  f.deg_b = room(last->b, f.n);
  return f;
}

// P -> sum_k c_k P^(k).
using Operator = std::array<RationalFunction, 3>;

Operator times(const RationalFunction& factor, Operator op) {
  for (RationalFunction& c : op)
    c = factor * c;
  return op;
}

// With h the logarithmic derivative of what stands before P.
Operator first(const RationalFunction& h) { return {h, 1, 0}; }
Operator second(const RationalFunction& h) {
  return {derivative(h) + h * h, h * RationalFunction(2), 1};
}
Operator sum(Operator a, const Operator& b) {
  for (std::size_t i = 0; i < 3; ++i)
    a[i] += b[i];
  return a;
}

RationalFunction logarithmic(const RationalFunction& f) { return derivative(f) / f; }

// The two identities of the header, as operators on P and on Q.
struct GaugeIdentities {
  std::array<Operator, 2> on_a, on_b;
};

GaugeIdentities system_of(const RationalFunction& r, const RationalFunction& r1,
                          const OuterParts& f) {
  const RationalFunction root =
      logarithmic(RationalFunction(f.g)) * RationalFunction(Rational(1, 2));
  const RationalFunction ha = root + logarithmic(f.m);
  const RationalFunction hb = root + logarithmic(f.n);
  const RationalFunction difference = r1 - r;
  const Operator identity{1, 0, 0};
  GaugeIdentities s;
  s.on_a[0] = times(f.m * RationalFunction(2), first(ha));
  s.on_b[0] = times(f.n, sum(second(hb), times(difference, identity)));
  s.on_a[1] = times(f.m, sum(second(ha), times(difference, identity)));
  s.on_b[1] =
      times(f.n, sum(times(r1 * RationalFunction(2), first(hb)), times(derivative(r1), identity)));
  return s;
}

using Polynomials = std::array<Poly, 3>;

Polynomials cleared(const Operator& op, const Poly& den) {
  Polynomials found;
  for (std::size_t i = 0; i < 3; ++i)
    found[i] = op[i].num() * exact_div(den, op[i].den());
  return found;
}

Poly image(const Polynomials& op, long j) {
  Poly found = shift_left(op[0], j);
  if (j >= 1) found += scale(shift_left(op[1], j - 1), NfElem(j));
  if (j >= 2) found += scale(shift_left(op[2], j - 2), NfElem(j * (j - 1)));
  return found;
}

// One row for each power of z in each identity.
void add_rows(std::vector<Row>& rows, const Operator& on_a, const Operator& on_b,
              const OuterParts& f) {
  Poly den(1);
  for (const Operator* op : {&on_a, &on_b})
    for (const RationalFunction& c : *op)
      den = lcm(den, c.den());
  const Polynomials a = cleared(on_a, den);
  const Polynomials b = cleared(on_b, den);
  std::vector<Poly> columns;
  for (long j = 0; j <= f.deg_a; ++j)
    columns.push_back(image(a, j));
  for (long j = 0; j <= f.deg_b; ++j)
    columns.push_back(image(b, j));
  long top = -1;
  for (const Poly& c : columns)
    top = std::max(top, degree(c));
  for (long i = 0; i <= top; ++i) {
    Row& row = rows.emplace_back();
    for (const Poly& c : columns)
      row.push_back(c.coeff(i));
  }
}

Poly polynomial(const Row& x, long from, long deg) {
  Poly p(0);
  for (long j = 0; j <= deg; ++j)
    p += Poly::monomial(x[static_cast<std::size_t>(from + j)], j);
  return p;
}

std::optional<Gauge> solve(const RationalFunction& r, const RationalFunction& r1, OuterParts f,
                           const Budget& budget) {
  f.deg_a = std::max(f.deg_a, -1L);
  f.deg_b = std::max(f.deg_b, -1L);
  const long unknowns = f.deg_a + f.deg_b + 2;
  if (unknowns == 0 || unknowns > most_unknowns) return std::nullopt;
  const GaugeIdentities s = system_of(r, r1, f);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < 2; ++i)
    add_rows(rows, s.on_a[i], s.on_b[i], f);
  const auto found = kernel(rows, static_cast<std::size_t>(unknowns), budget);
  if (found.empty()) return std::nullopt;
  const Row& x = found.front();
  return Gauge{f.g, f.m * RationalFunction(polynomial(x, 0, f.deg_a)),
               f.n * RationalFunction(polynomial(x, f.deg_a + 1, f.deg_b))};
}

} // namespace

std::optional<Gauge> find_gauge(const Singularities& s, const Singularities& s1,
                                const Budget& budget) {
  const auto all = matches(s, s1);
  if (!all) return std::nullopt;
  std::vector<std::size_t> open;
  unsigned long odd = 0;
  for (std::size_t i = 0; i + 1 < all->size(); ++i) {
    const Match& m = (*all)[i];
    if (m.of_parity[0] && m.of_parity[1]) open.push_back(i);
    if (!m.of_parity[0]) odd |= 1UL << i;
  }
  if (open.size() > most_open_places || all->size() > 60) return std::nullopt;
  for (unsigned long choice = 0; choice < 1UL << open.size(); ++choice) {
    budget.check();
    unsigned long here = odd;
    for (std::size_t i = 0; i < open.size(); ++i)
      if ((choice >> i & 1) != 0) here |= 1UL << open[i];
    const auto f = frame(*all, here);
    if (!f) continue;
    if (auto found = solve(s.r, s1.r, *f, budget)) return found;
  }
  return std::nullopt;
}

} // namespace kov::pullback
