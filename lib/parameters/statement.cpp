#include "parameters/statement.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"

#include <algorithm>

namespace kov {

bool contains(const Residues& r, const Rational& x) {
  return is_integer((x - r.a) / r.step) || is_integer((x + r.a) / r.step);
}
bool contains(const Classes& all, const Rational& x) {
  return std::ranges::any_of(all, [&](const Residues& r) { return contains(r, x); });
}

const Squares& squares_of(const Assertion& s) {
  return std::visit([](const auto& one) -> const Squares& { return one.squares; }, s);
}
Squares& squares_of(Assertion& s) {
  return std::visit([](auto& one) -> Squares& { return one.squares; }, s);
}

bool is_number(const MFraction& f) { return is_zero(f) || is_constant(f); }

std::optional<std::vector<MFraction>> integral_somewhere(const SumIn& s) {
  Ring ring;
  for (const MFraction& x : s.squares)
    if (x.ring()) ring = x.ring();
  std::vector<MFraction> sums;
  for (const MFraction& x : s.squares) {
    const auto root = square_root(x);
    if (!root) return std::nullopt;
    std::vector<MFraction> more;
    for (const MFraction& sum : sums) {
      more.push_back(sum + *root);
      if (!is_zero(*root)) more.push_back(sum - *root);
    }
    if (sums.empty()) more.push_back(*root);
    sums = std::move(more);
  }
  std::vector<MFraction> all;
  for (const MFraction& sum : sums)
    for (const Residues& c : s.classes) {
      const Rational step = Rational(1) / c.step;
      all.push_back(step * (sum - MFraction(ring, c.a)));
      if (!is_integer(Rational(2) * c.a * step)) all.push_back(step * (sum + MFraction(ring, c.a)));
    }
  return all;
}

namespace {

bool contains(const Residues& r, const Residues& smaller) {
  return is_integer(smaller.step / r.step) && kov::contains(r, smaller.a);
}

// a in [0, step/2], as a + step Z and -a + step Z are one.
Residues reduced(const Residues& r) {
  const Rational step = sign(r.step) < 0 ? -r.step : r.step;
  Rational a = r.a - Rational(floor(r.a / step)) * step;
  if (a + a > step) a = step - a;
  return {a, step};
}

void add(Classes& all, const Residues& r) {
  if (std::ranges::any_of(all, [&](const Residues& x) { return contains(x, r); })) return;
  std::erase_if(all, [&](const Residues& x) { return contains(r, x); });
  all.push_back(r);
}

// a + step Z and a + step/2 + step Z are a + (step/2) Z.
Classes in_few_rows(Classes all) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Rational half = all[i].step * Rational(1, 2);
    const Residues partner = reduced({all[i].a + half, all[i].step});
    if (std::ranges::none_of(all, [&](const Residues& x) { return contains(x, partner); }))
      continue;
    add(all, reduced({all[i].a, half}));
    i = static_cast<std::size_t>(-1); // from the beginning: there are fewer now
  }
  std::ranges::sort(all, [](const Residues& a, const Residues& b) {
    return a.step != b.step ? b.step < a.step : a.a < b.a;
  });
  return all;
}

} // namespace

Classes simplified(const Classes& classes) {
  Classes all;
  for (const Residues& r : classes)
    add(all, reduced(r));
  return in_few_rows(std::move(all));
}

// ---- what follows

Statement negation(Statement s) {
  s.holds = !s.holds;
  return s;
}

namespace {

// Some number is in classes: unset where more is said.
std::optional<SomeIn> some_number(const Assertion& s) {
  if (const auto* some = std::get_if<SomeIn>(&s))
    return some->count == 1 ? std::optional(*some) : std::nullopt;
  if (squares_of(s).size() != 1) return std::nullopt;
  if (const auto* sum = std::get_if<SumIn>(&s)) return SomeIn{sum->squares, sum->classes};
  if (const auto* all = std::get_if<AllRational>(&s)) return SomeIn{all->squares};
  return std::nullopt;
}

// The differences of b are this number times those of a, one for one.
std::optional<Rational> scale(const SomeIn& a, const SomeIn& b) {
  if (a.squares == b.squares) return Rational(1);
  if (a.squares.size() != b.squares.size()) return std::nullopt;
  std::optional<Rational> all;
  for (std::size_t i = 0; i < a.squares.size(); ++i) {
    if (is_zero(a.squares[i]) || is_zero(b.squares[i])) return std::nullopt;
    const MFraction ratio = b.squares[i] / a.squares[i];
    const auto root = is_constant(ratio) ? exact_sqrt(to_rational(ratio)) : std::nullopt;
    if (!root || (all && !(*all == *root))) return std::nullopt;
    all = root;
  }
  return all;
}

} // namespace

std::optional<SomeIn> one_number(const Statement& s) {
  auto some = s.holds ? some_number(s.says) : std::nullopt;
  if (some && (some->squares.size() != 1 || some->or_all_rational)) return std::nullopt;
  return some;
}

bool implies(const Statement& a, const Statement& b) {
  if (a == b) return true;
  if (!a.holds || !b.holds) return false;
  const auto smaller = some_number(a.says), larger = some_number(b.says);
  if (!smaller || !larger || smaller->or_all_rational) return false;
  const auto by = scale(*smaller, *larger);
  if (!by) return false;
  if (!smaller->classes || !larger->classes) return !larger->classes;
  return std::ranges::all_of(*smaller->classes, [&](const Residues& x) {
    const Residues scaled{x.a * *by, x.step * *by};
    return std::ranges::any_of(*larger->classes,
                               [&](const Residues& r) { return contains(r, scaled); });
  });
}

// ---- two statements on one parameter

namespace {

constexpr long most_in_classes = 200000;

Rational at(const std::vector<Rational>& p, const Rational& x) {
  Rational sum(0);
  for (std::size_t i = p.size(); i-- > 0;)
    sum = sum * x + p[i];
  return sum;
}

std::vector<Rational> univariate(const MPoly& f, std::size_t x) {
  std::vector<Rational> all;
  for (const MPoly& c : coefficients(f, x))
    all.push_back(is_zero(c) ? Rational(0) : to_rational(MFraction(c)));
  return all;
}

} // namespace

// f is solved for a parameter, or the power of one, that it contains to degree 1.
std::optional<Univariate> in_terms_of(const MFraction& first, const MFraction& second) {
  MFraction f = first, g = second;
  for (const std::size_t t : used_variables(f))
    if (const std::size_t k = common_power({f, g}, t); k > 1)
      f = in_power(f, t, k), g = in_power(g, t, k);
  const Rational zero_number(0), one(1);
  if (const MFraction product = f * g; is_constant(product)) // (a/c)^2 and (c/a)^2
    return Univariate{{to_rational(product)}, {zero_number, one}};
  if (const MFraction sum = f + g; !is_zero(sum) && is_constant(sum))
    return Univariate{{to_rational(sum), -one}, {one}};
  auto names = f.ring()->names();
  names.emplace_back("value of the square");
  const Ring ring = make_ring(names);
  const std::size_t x = names.size() - 1;
  const MFraction value = MFraction::variable(ring, x);
  const MFraction here = transfer(f, ring);
  const MFraction zero(ring);
  for (const std::size_t t : used_variables(here)) {
    const MFraction equation = MFraction(here.num()) - value * MFraction(here.den());
    const MFraction slope = derivative(equation, t);
    if (is_zero(slope) || uses(slope, t)) continue;
    const MFraction solved = -(substitute(equation, {{t, zero}}) / slope);
    MFraction result;
    try {
      result = substitute(transfer(g, ring), {{t, solved}});
    } catch (const DomainError&) {
      continue;
    }
    if (is_zero(result) || used_variables(result) != std::vector{x}) continue;
    return Univariate{univariate(result.num(), x), univariate(result.den(), x)};
  }
  return std::nullopt;
}

namespace {

// All real zeros have a smaller absolute value (Cauchy).
Rational bound_of_zeros(std::vector<Rational> p) {
  while (!p.empty() && is_zero(p.back()))
    p.pop_back();
  Rational largest(0);
  for (const Rational& c : p) {
    const Rational ratio = c / p.back();
    largest = std::max(largest, sign(ratio) < 0 ? -ratio : ratio);
  }
  return largest + Rational(1);
}

// How far the squares of (1/N) Z other than `limit` itself are from it, at least.
std::optional<Rational> distance(const Rational& limit, const Integer& n) {
  if (sign(limit) < 0) return -limit;
  std::optional<Rational> least;
  for (long j = 0; j <= most_in_classes; ++j) {
    const Rational root = Rational(Integer(j)) / Rational(n);
    const Rational square = root * root;
    if (!(square == limit)) {
      const Rational d = square < limit ? limit - square : square - limit;
      least = least ? std::min(*least, d) : d;
      if (limit < square) return least;
    }
  }
  return std::nullopt;
}

std::vector<Rational> plus_multiple(std::vector<Rational> a, const Rational& c,
                                    const std::vector<Rational>& b) {
  a.resize(std::max(a.size(), b.size()), Rational(0));
  for (std::size_t i = 0; i < b.size(); ++i)
    a[i] = a[i] + c * b[i];
  return a;
}

// F(x) is not a square of one of the classes for x at or beyond this; unset: F grows, or its limit is
// finite and the classes are all of Q.
std::optional<Rational> bound(const Univariate& f, const std::optional<Classes>& classes) {
  if (f.num.size() > f.den.size()) {
    if (sign(f.num.back()) == sign(f.den.back())) return std::nullopt;
    return std::max(bound_of_zeros(f.num), bound_of_zeros(f.den)); // negative from there on
  }
  if (!classes) return std::nullopt;
  const Integer n = denominator(*classes);
  const Rational limit = f.num.size() < f.den.size() ? Rational(0) : f.num.back() / f.den.back();
  const auto gap = distance(limit, n);
  if (!gap) return std::nullopt;
  // F - limit = rest/den: beyond all zeros of rest, den and gap den +- rest it is not 0 and < gap
  const auto rest = plus_multiple(f.num, -limit, f.den);
  std::vector<Rational> scaled = plus_multiple({}, *gap, f.den);
  return std::max({bound_of_zeros(rest), bound_of_zeros(f.den),
                   bound_of_zeros(plus_multiple(scaled, Rational(1), rest)),
                   bound_of_zeros(plus_multiple(scaled, Rational(-1), rest))});
}

// From here on |F(x)| is in (1/n) Z for no x, |x| at least this; unset: F has no finite limit.
std::optional<Rational> bound_of_numbers(const Univariate& f, const Integer& n) {
  if (f.num.size() > f.den.size()) return std::nullopt;
  const Rational limit = f.num.size() < f.den.size() ? Rational(0) : f.num.back() / f.den.back();
  const Rational scaled = Rational(n) * limit;
  const Rational one(1);
  const Rational part = scaled - Rational(floor(scaled)); // of the limit that is in none
  const Rational gap = (is_zero(part) ? one : std::min(part, one - part)) / Rational(n);
  const auto rest = plus_multiple(f.num, -limit, f.den);
  if (std::ranges::all_of(rest, [](const Rational& c) { return is_zero(c); }))
    return std::nullopt; // F is constant
  const auto wide = plus_multiple({}, gap, f.den);
  return std::max({bound_of_zeros(rest), bound_of_zeros(f.den),
                   bound_of_zeros(plus_multiple(wide, one, rest)),
                   bound_of_zeros(plus_multiple(wide, -one, rest))});
}

// The same for Delta2 = F(Delta1) where both are functions of the parameters.
std::optional<CommonValues> values_by_roots(const SomeIn& a, const SomeIn& b) {
  const auto x = square_root(a.squares.front()), y = square_root(b.squares.front());
  if (!a.classes || !b.classes || !x || !y) return std::nullopt;
  const auto f = in_terms_of(*x, *y);
  if (!f) return std::nullopt;
  const auto from = bound_of_numbers(*f, denominator(*b.classes));
  if (!from) return std::nullopt;
  CommonValues all{a.squares.front(), {}};
  const Integer n = denominator(*a.classes);
  for (long j = 0;; ++j) {
    if (j > most_in_classes) return std::nullopt;
    const Rational root = Rational(Integer(j)) / Rational(n);
    if (*from < root) return all;
    if (!kov::contains(*a.classes, root)) continue;
    const auto is_common = [&](const Rational& value) {
      const Rational den = at(f->den, value);
      return !is_zero(den) && kov::contains(*b.classes, at(f->num, value) / den);
    };
    if (is_common(root) || is_common(-root)) all.values.push_back(root * root);
  }
}

std::optional<CommonValues> values_by(const SomeIn& a, const SomeIn& b) {
  if (auto values = values_by_roots(a, b)) return values;
  if (!a.classes) return std::nullopt;
  const auto f = in_terms_of(a.squares.front(), b.squares.front());
  if (!f) return std::nullopt;
  const auto from = bound(*f, b.classes);
  if (!from) return std::nullopt;
  CommonValues all{a.squares.front(), {}};
  const Integer n = denominator(*a.classes);
  for (long j = 0;; ++j) {
    if (j > most_in_classes) return std::nullopt;
    const Rational root = Rational(Integer(j)) / Rational(n);
    const Rational square = root * root;
    if (*from < square) return all;
    if (!kov::contains(*a.classes, root) || is_zero(at(f->den, square))) continue;
    const auto other = exact_sqrt(at(f->num, square) / at(f->den, square));
    if (other && (!b.classes || kov::contains(*b.classes, *other))) all.values.push_back(square);
  }
}

} // namespace

std::optional<CommonValues> common_values(const Statement& a, const Statement& b) {
  const auto x = one_number(a), y = one_number(b);
  if (!x || !y) return std::nullopt;
  if (auto values = values_by(*x, *y)) return values;
  return values_by(*y, *x);
}

Integer denominator(const Classes& classes) {
  Integer n(1);
  for (const Residues& r : classes)
    n = lcm(lcm(n, r.a.den()), r.step.den());
  return n;
}

std::vector<Rational> squares_in(const Classes& classes, long bound) {
  const Integer n = denominator(classes);
  std::vector<Rational> all;
  for (long j = 0; j <= most_in_classes; ++j) {
    const Rational root = Rational(Integer(j)) / Rational(n);
    if (Rational(bound) < root) return all;
    if (contains(classes, root)) all.push_back(root * root);
  }
  throw OutOfBudget("too many special values of an exponent difference");
}

} // namespace kov
