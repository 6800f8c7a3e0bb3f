#include "study/difference.hpp"

#include "closed/arithmetic.hpp"
#include "exact/error.hpp"
#include "exact/factor.hpp"
#include "exact/finite_algebra.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"

#include <algorithm>
#include <set>

namespace kov {
namespace {

using Kind = DifferenceCondition::Kind;

// Q itself for Kind::rational.
std::optional<std::vector<Residues>> residues(const DifferenceCondition& c) {
  const Rational zero(0), half(1, 2), one(1);
  switch (c.kind) {
  case Kind::rational:
    return std::nullopt;
  case Kind::integer:
    return std::vector{Residues{zero, one}};
  case Kind::half_integer:
    return std::vector{Residues{zero, half}};
  case Kind::odd_half:
    return std::vector{Residues{half, one}};
  case Kind::classes:
    break;
  }
  return c.classes;
}

bool contains(const Residues& r, const Rational& x) {
  return is_integer((x - r.a) / r.step) || is_integer((x + r.a) / r.step);
}
bool contains(const Residues& r, const Residues& smaller) {
  return is_integer(smaller.step / r.step) && contains(r, smaller.a);
}
bool contains(const std::vector<Residues>& all, const Rational& x) {
  return std::ranges::any_of(all, [&](const Residues& r) { return contains(r, x); });
}

bool is_special(const DifferenceCondition& c, const Rational& square) {
  const auto root = exact_sqrt(square);
  if (!root) return false;
  const auto classes = residues(c);
  return !classes || contains(*classes, *root);
}

// f as a function on the set, where its denominator does not vanish identically.
std::optional<MFraction> restricted(const MFraction& f, const ParameterSet& where) {
  const MFraction den = where.restrict(f.den());
  if (is_zero(den)) return std::nullopt;
  return where.restrict(f.num()) / den;
}

// The rational numbers among the values of f, and perhaps some more, where the equations of the set
// leave finitely many values to all that f uses; unset: they do not, or no limit suffices.
std::optional<std::vector<Rational>> rational_values(const MFraction& f,
                                                     const ParameterSet& where) {
  constexpr long most_points = 24;
  const auto equations = where.equations();
  std::set<std::size_t> used;
  for (const MPoly& p : equations)
    for (const std::size_t i : used_variables(p))
      used.insert(i);
  for (const MPoly& part : {f.num(), f.den()})
    for (const std::size_t i : used_variables(part))
      if (!used.contains(i)) return std::nullopt;
  try {
    const Ideal points(f.ring(), {used.begin(), used.end()}, equations);
    if (points.dimension() != 0) return std::nullopt;
    const FiniteAlgebra algebra(points, most_points);
    const auto element = algebra.evaluate(f);
    if (!element) return std::nullopt;
    std::vector<NfElem> coefficients;
    for (const MFraction& c : algebra.minimal_polynomial(*element))
      coefficients.emplace_back(to_rational(c));
    std::vector<Rational> values;
    for (const Factor& factor : irreducible_factors(Poly::from_coefficients(coefficients)))
      if (degree(factor.base) == 1) values.push_back(to_rational(-factor.base.coeff(0)));
    return values;
  } catch (const InvalidArgument&) { // more points than that
    return std::nullopt;
  } catch (const OutOfBudget&) {
    return std::nullopt;
  }
}

std::variant<bool, DifferenceCondition> with_sign(bool satisfied, bool holds) {
  return satisfied == holds;
}

} // namespace

std::variant<bool, DifferenceCondition> on_set(const DifferenceCondition& c,
                                               const ParameterSet& where) {
  DifferenceCondition left = c;
  left.squares.clear();
  for (const MFraction& square : c.squares) {
    const auto here = restricted(square, where);
    if (!here) return c;
    if (!is_zero(*here) && !is_constant(*here)) {
      const auto values = rational_values(*here, where);
      const auto special = [&](const Rational& value) { return is_special(c, value); };
      const auto root = [](const Rational& value) { return exact_sqrt(value).has_value(); };
      if (!values || std::ranges::any_of(*values, special) ||
          (c.or_all_rational && std::ranges::any_of(*values, root)))
        left.squares.push_back(*here);
      else
        left.or_all_rational = false;
      continue;
    }
    const Rational value = is_zero(*here) ? Rational(0) : to_rational(*here);
    if (is_special(c, value)) return with_sign(true, c.holds);
    if (!exact_sqrt(value)) left.or_all_rational = false;
  }
  if (left.squares.empty()) return with_sign(left.or_all_rational, c.holds);
  return left;
}

namespace {

// The differences of b are this number times those of a, one for one.
std::optional<Rational> scale(const DifferenceCondition& a, const DifferenceCondition& b) {
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

bool implies(const DifferenceCondition& a, const DifferenceCondition& b) {
  if (a == b) return true;
  if (!a.holds || !b.holds || a.or_all_rational) return false;
  const auto by = scale(a, b);
  if (!by) return false;
  const auto smaller = residues(a);
  const auto larger = residues(b);
  if (!smaller || !larger) return !larger;
  return std::ranges::all_of(*smaller, [&](const Residues& x) {
    const Residues scaled{x.a * *by, x.step * *by};
    return std::ranges::any_of(*larger, [&](const Residues& r) { return contains(r, scaled); });
  });
}

namespace {

// a in [0, step/2], as a + step Z and -a + step Z are one.
Residues reduced(const Residues& r) {
  const Rational step = sign(r.step) < 0 ? -r.step : r.step;
  Rational a = r.a - Rational(floor(r.a / step)) * step;
  if (a + a > step) a = step - a;
  return {a, step};
}

void add(std::vector<Residues>& all, const Residues& r) {
  if (std::ranges::any_of(all, [&](const Residues& x) { return contains(x, r); })) return;
  std::erase_if(all, [&](const Residues& x) { return contains(r, x); });
  all.push_back(r);
}

// a + step Z and a + step/2 + step Z are a + (step/2) Z.
std::vector<Residues> in_few_rows(std::vector<Residues> all) {
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

std::vector<Residues> simplified(const std::vector<Residues>& classes) {
  std::vector<Residues> all;
  for (const Residues& r : classes)
    add(all, reduced(r));
  return in_few_rows(std::move(all));
}

DifferenceCondition condition(const MFraction& square, const std::vector<Residues>& classes) {
  for (const Kind kind : {Kind::integer, Kind::half_integer, Kind::odd_half})
    if (DifferenceCondition c{kind, {square}}; residues(c) == classes) return c;
  DifferenceCondition c{Kind::classes, {square}};
  c.classes = classes;
  return c;
}

/// The statement that one difference is special.
struct SpecialDifference {
  MFraction square;
  std::optional<std::vector<Residues>> classes; ///< unset: it is rational
};

bool is_number(const MFraction& f) { return is_zero(f) || is_constant(f); }

/// x + c1 Delta, up to sign, for all signs in a sum of Delta, taken `times` times, and numbers.
struct OneOpenDifference {
  MFraction square;
  long times = 0;
  std::vector<Rational> sums{Rational(0)}; ///< of the numbers
};
// Unset: there are other differences, or a number is irrational.
std::optional<OneOpenDifference> one_open(const Squares& squares) {
  OneOpenDifference one;
  for (const MFraction& square : squares) {
    if (!is_number(square)) {
      if (one.times > 0 && !(one.square == square)) return std::nullopt;
      one.square = square;
      ++one.times;
      continue;
    }
    const auto root = exact_sqrt(is_zero(square) ? Rational(0) : to_rational(square));
    if (!root) return std::nullopt;
    std::vector<Rational> more;
    for (const Rational& x : one.sums) {
      more.push_back(x + *root);
      more.push_back(x - *root);
    }
    one.sums = std::move(more);
  }
  if (one.times == 0) return std::nullopt;
  return one;
}

// x + c Delta in r for some sum x of the numbers; for c = 0 this may say nothing of Delta.
std::optional<SpecialDifference> said_by(const SumIn& s) {
  const auto one = one_open(s.squares);
  if (!one) return std::nullopt;
  std::vector<Residues> classes;
  for (long c = one->times; c >= 0; c -= 2)
    for (const Residues& r : s.classes)
      for (const Rational& x : one->sums) {
        if (c == 0 && contains(r, x)) return std::nullopt;
        if (c == 0) continue;
        const Rational by = Rational(1, c);
        for (const Rational& a : {r.a - x, -(r.a + x)})
          classes.push_back({a * by, r.step * by});
      }
  return SpecialDifference{one->square, simplified(classes)};
}

// All entries of the rows for A4, S4, A5 are in (1/6)Z, (1/12)Z, (1/30)Z.
Residues entries(GroupType group) {
  return {Rational(0), Rational(1, group == GroupType::A4 ? 6 : group == GroupType::S4 ? 12 : 30)};
}

// Set if all that is open is one difference: the rows matter up to sign and modulo 2.
std::optional<SpecialDifference> said_by(const InRow& s) {
  const auto one = one_open(s.squares);
  if (!one) return std::nullopt;
  std::vector<Residues> classes;
  for (long d = 2; d <= 5; ++d)
    for (long j = 0; j <= d; ++j) {
      const Rational nu(j, d);
      const auto at = [&](const MFraction& f) {
        return NfElem(f == one->square ? nu * nu : is_zero(f) ? Rational(0) : to_rational(f));
      };
      if (is_so({s, true}, at)) classes.push_back({nu, Rational(2)});
    }
  return SpecialDifference{one->square, simplified(classes)};
}

struct WhatItSays {
  std::vector<SpecialDifference> operator()(const SumIn& s) const {
    const auto one = said_by(s);
    return one ? std::vector{*one} : std::vector<SpecialDifference>{};
  }
  std::vector<SpecialDifference> operator()(const AllRational& s) const {
    return all(s.squares, {});
  }
  std::vector<SpecialDifference> operator()(const InRow& s) const {
    if (const auto one = said_by(s)) return {*one};
    return all(s.squares, std::vector{entries(s.group)});
  }
  std::vector<SpecialDifference> operator()(const Separated& s) const {
    return all(s.squares, std::vector{Residues{Rational(0), Rational(1)}});
  }
  std::vector<SpecialDifference> operator()(const SeparatedPair& s) const {
    return all({s.squares.front()}, std::vector{Residues{Rational(0), Rational(1)}});
  }
  std::vector<SpecialDifference> operator()(const InHalves& s) const {
    if (s.count < s.squares.size()) return {}; // which of them is not known
    return all(s.squares, std::vector{Residues{Rational(1, 2), Rational(1)}});
  }
  template <class Other> std::vector<SpecialDifference> operator()(const Other&) const {
    return {};
  }

private:
  static std::vector<SpecialDifference> all(const Squares& squares,
                                            const std::optional<std::vector<Residues>>& classes) {
    std::vector<SpecialDifference> each;
    for (const MFraction& square : squares)
      each.push_back({square, classes});
    return each;
  }
};

// Each difference once; a finite union of classes rather than Q.
std::vector<SpecialDifference> said_by(const std::vector<ArithmeticCondition>& part) {
  std::vector<SpecialDifference> each;
  for (const ArithmeticCondition& c : part) {
    if (!c.holds) continue;
    for (SpecialDifference& one : std::visit(WhatItSays{}, c.statement)) {
      const auto known = std::ranges::find_if(
          each, [&](const SpecialDifference& x) { return x.square == one.square; });
      if (known == each.end())
        each.push_back(std::move(one));
      else if (!known->classes)
        *known = std::move(one);
    }
  }
  return each;
}

// The smallest set with both.
SpecialDifference united(const SpecialDifference& a, const SpecialDifference& b) {
  if (!a.classes || !b.classes) return {a.square, std::nullopt};
  std::vector<Residues> both = *a.classes;
  both.insert(both.end(), b.classes->begin(), b.classes->end());
  return {a.square, simplified(both)};
}

} // namespace

std::optional<DifferenceCondition>
necessary_condition(const std::vector<std::vector<ArithmeticCondition>>& parts) {
  if (parts.empty()) return std::nullopt;
  std::vector<SpecialDifference> common = said_by(parts.front());
  std::erase_if(common, [](const SpecialDifference& c) { return is_number(c.square); });
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const auto here = said_by(parts[i]);
    std::vector<SpecialDifference> both;
    for (const SpecialDifference& c : common)
      for (const SpecialDifference& x : here)
        if (x.square == c.square) both.push_back(united(c, x));
    common = std::move(both);
  }
  if (common.empty()) return std::nullopt;
  const auto discrete = std::ranges::find_if(
      common, [](const SpecialDifference& c) { return c.classes.has_value(); });
  if (discrete == common.end()) return DifferenceCondition{Kind::rational, {common.front().square}};
  if (discrete->classes->empty()) return std::nullopt; // no part has a point
  return condition(discrete->square, *discrete->classes);
}

// ---- two conditions on one parameter

namespace {

constexpr long most_in_classes = 200000;

/// A rational function of one variable over Q.
struct Univariate {
  std::vector<Rational> num, den; ///< ascending, without common factor
};

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

// g as a function of f, if it is one: f is solved for a parameter that it contains to degree 1.
std::optional<Univariate> in_terms_of(const MFraction& f, const MFraction& g) {
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

// N with all classes in (1/N) Z.
Integer denominator(const std::vector<Residues>& classes) {
  Integer n(1);
  for (const Residues& r : classes)
    n = lcm(lcm(n, r.a.den()), r.step.den());
  return n;
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
std::optional<Rational> bound(const Univariate& f,
                              const std::optional<std::vector<Residues>>& classes) {
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
std::optional<CommonValues> values_by_roots(const DifferenceCondition& a,
                                            const DifferenceCondition& b) {
  const auto first = residues(a), second = residues(b);
  const auto x = square_root(a.squares.front()), y = square_root(b.squares.front());
  if (!first || !second || !x || !y) return std::nullopt;
  const auto f = in_terms_of(*x, *y);
  if (!f) return std::nullopt;
  const auto from = bound_of_numbers(*f, denominator(*second));
  if (!from) return std::nullopt;
  CommonValues all{a.squares.front(), {}};
  const Integer n = denominator(*first);
  for (long j = 0;; ++j) {
    if (j > most_in_classes) return std::nullopt;
    const Rational root = Rational(Integer(j)) / Rational(n);
    if (*from < root) return all;
    if (!contains(*first, root)) continue;
    const auto is_common = [&](const Rational& value) {
      const Rational den = at(f->den, value);
      return !is_zero(den) && contains(*second, at(f->num, value) / den);
    };
    if (is_common(root) || is_common(-root)) all.values.push_back(root * root);
  }
}

std::optional<CommonValues> values_by(const DifferenceCondition& a, const DifferenceCondition& b) {
  if (auto values = values_by_roots(a, b)) return values;
  const auto first = residues(a);
  if (!first) return std::nullopt;
  const auto f = in_terms_of(a.squares.front(), b.squares.front());
  if (!f) return std::nullopt;
  const auto from = bound(*f, residues(b));
  if (!from) return std::nullopt;
  CommonValues all{a.squares.front(), {}};
  const Integer n = denominator(*first);
  for (long j = 0;; ++j) {
    if (j > most_in_classes) return std::nullopt;
    const Rational root = Rational(Integer(j)) / Rational(n);
    const Rational square = root * root;
    if (*from < square) return all;
    if (!contains(*first, root) || is_zero(at(f->den, square))) continue;
    if (is_special(b, at(f->num, square) / at(f->den, square))) all.values.push_back(square);
  }
}

} // namespace

std::optional<CommonValues> common_values(const DifferenceCondition& a,
                                          const DifferenceCondition& b) {
  for (const DifferenceCondition* c : {&a, &b})
    if (!c->holds || c->or_all_rational || c->squares.size() != 1) return std::nullopt;
  if (auto values = values_by(a, b)) return values;
  return values_by(b, a);
}

Integer denominator(const DifferenceCondition& c) {
  const auto classes = residues(c);
  KOV_ENSURE(classes);
  return denominator(*classes);
}

std::vector<Rational> special_squares(const DifferenceCondition& c, long bound) {
  const auto classes = residues(c);
  KOV_ENSURE(classes);
  const Integer n = denominator(*classes);
  std::vector<Rational> all;
  for (long j = 0; j <= most_in_classes; ++j) {
    const Rational root = Rational(Integer(j)) / Rational(n);
    if (Rational(bound) < root) return all;
    if (contains(*classes, root)) all.push_back(root * root);
  }
  throw OutOfBudget("too many special values of an exponent difference");
}

DifferenceCondition negation(DifferenceCondition c) {
  c.holds = !c.holds;
  return c;
}

namespace {

std::string root(const MFraction& square) {
  if (const auto exact = square_root(square)) return to_factored_string(*exact);
  const std::string text = to_factored_string(square);
  const bool bracketed = text.front() == '(' && text.find(')') + 1 == text.size();
  return "sqrt" + (bracketed ? text : "(" + text + ")");
}

// Without the square of a number as a factor: rational where the other is.
MFraction without_squares(const MFraction& f) {
  if (is_zero(f)) return f;
  const Integer den = factor(f.den()).first;
  const Integer product = factor(f.num()).first * den;
  const Rational root(square_part(product).first, den);
  return MFraction(f.ring(), Rational(1) / (root * root)) * f;
}

std::string rational_root(const MFraction& square) { return root(without_squares(square)); }

// "2*sqrt(a)", but "sqrt(4*a + 1)" for (4*a + 1)/4.
std::string twice_root(const MFraction& square) {
  const MFraction four = MFraction(square.ring(), Rational(4)) * square;
  const bool shorter =
      square_root(square) || is_integer(Rational(factor(square.den()).first, Integer(4)));
  return shorter ? root(four) : "2*" + root(square);
}

std::string subject(Kind kind, const MFraction& square) {
  switch (kind) {
  case Kind::rational:
    return rational_root(square);
  case Kind::half_integer:
    return twice_root(square);
  case Kind::odd_half:
    return root(square) + " - 1/2";
  default:
    return root(square);
  }
}

std::string class_text(const Residues& r) {
  const std::string step = r.step == Rational(1) ? "Z" : to_string(r.step) + "*Z";
  if (is_zero(r.a)) return step;
  return (r.a + r.a == r.step ? "" : "+-") + to_string(r.a) + " + " + step;
}

// One difference in classes.
std::string in_classes(const DifferenceCondition& c) {
  std::vector<std::string> sets;
  for (const Residues& r : c.classes)
    sets.push_back(class_text(r));
  return root(c.squares.front()) + (c.holds ? " is in " : " is not in ") +
         joined(sets, ", ", " or ");
}

} // namespace

std::string to_string(const DifferenceCondition& c) {
  if (c.kind == Kind::classes) return in_classes(c);
  std::vector<std::string> subjects, roots; // each once
  const auto add = [](std::vector<std::string>& all, std::string text) {
    add_once(all, std::move(text));
  };
  for (const MFraction& square : c.squares) {
    add(subjects, subject(c.kind, square));
    add(roots, rational_root(square));
  }
  const std::string what = c.kind == Kind::rational ? "rational" : "an integer";
  if (c.holds)
    return joined(subjects, ", ", " or ") + " is " + what +
           (c.or_all_rational ? ", or " + joined(roots, ", ", " and ") +
                                    (roots.size() > 1 ? " are rational" : " is rational")
                              : "");
  if (subjects.size() == 1 && !c.or_all_rational) return subjects[0] + " is not " + what;
  return "none of " + joined(subjects) + " is " + what +
         (c.or_all_rational ? ", and not all of " + joined(roots) + " are rational" : "");
}

} // namespace kov
