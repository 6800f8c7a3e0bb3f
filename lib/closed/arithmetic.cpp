#include "closed/arithmetic.hpp"

#include "closed/kimura.hpp"
#include "closed/lame.hpp"
#include "closed/riemann.hpp"
#include "exact/error.hpp"

#include <algorithm>
#include <array>

namespace kov {
namespace {

using Roots = std::vector<std::optional<Rational>>; // unset: irrational

struct Point {
  Point(const Squares& all, const ValueAt& value) {
    for (const MFraction& s : all) {
      squares.push_back(is_zero(s) ? NfElem(0) : value(s));
      const NfElem& v = squares.back();
      roots.push_back(is_rational(v) ? exact_sqrt(to_rational(v)) : std::nullopt);
    }
    if (const auto& x = squares; x.size() == 3)
      e = {x[0] + x[1] + x[2], x[0] * x[1] + x[0] * x[2] + x[1] * x[2], x[0] * x[1] * x[2]};
  }
  Point(Roots known, const Poly& three)
      : roots(std::move(known)), e{-three.coeff(2), three.coeff(1), -three.coeff(0)} {}

  [[nodiscard]] bool rational() const {
    return std::ranges::all_of(roots, [](const auto& x) { return x.has_value(); });
  }

  std::vector<NfElem> squares; ///< none where they are given by e alone
  Roots roots;
  std::array<NfElem, 3> e; ///< of three: their elementary symmetric functions
};

// x1 +- x2 +- ..., all rational
std::vector<Rational> signed_sums(const Roots& roots) {
  std::vector<Rational> sums{Rational(0)};
  for (const auto& x : roots) {
    std::vector<Rational> more;
    for (const Rational& s : sums) {
      more.push_back(s + *x);
      more.push_back(s - *x);
    }
    sums = std::move(more);
  }
  return sums;
}

bool at(const SumIn& s, const Point& p) {
  if (p.rational()) {
    const auto sums = signed_sums(p.roots);
    return std::ranges::any_of(sums, [&](const Rational& v) { return contains(s.classes, v); });
  }
  if (s.squares.size() == 1) return false;
  if (s.squares.size() == 3) {
    KOV_ENSURE(s.classes.size() == 1 && s.classes[0].a == Rational(1) &&
               s.classes[0].step == Rational(2));
    return !odd_relations(p.e[0], p.e[1], p.e[2]).empty();
  }
  Integer scale(1);
  for (const Residues& c : s.classes)
    scale = lcm(scale, lcm(c.a.den(), c.step.den()));
  const NfElem square{Rational(scale * scale)};
  const auto sums = integer_sums(square * (p.squares[0] + p.squares[1]),
                                 square * square * p.squares[0] * p.squares[1]);
  return std::ranges::any_of(
      sums, [&](const Integer& v) { return contains(s.classes, Rational(v, scale)); });
}

bool at(const AllRational&, const Point& p) { return p.rational(); }

bool at(const SomeIn& s, const Point& p) {
  if (s.or_all_rational && p.rational()) return true;
  return std::ranges::count_if(p.roots, [&](const auto& x) {
           return x && (!s.classes || contains(*s.classes, *x));
         }) >= static_cast<long>(s.count);
}

// Is s, or -s, one of N-1, N-3, ..., 1-N?
bool among(const Rational& s, const Rational& n) {
  return is_integer(s) && abs(s) < n && is_integer((n - Rational(1) - s) * Rational(1, 2));
}

bool natural(const std::optional<Rational>& x) { return x && is_integer(*x) && sign(*x) > 0; }

bool at(const Separated&, const Point& p) {
  return natural(p.roots[0]) && p.roots[1] && among(*p.roots[1], *p.roots[0]);
}

bool at(const SeparatedPair&, const Point& p) {
  if (!natural(p.roots[0])) return false;
  const auto sums = integer_sums(p.squares[1], p.squares[2]);
  return std::ranges::any_of(sums,
                             [&](const Integer& s) { return among(Rational(s), *p.roots[0]); });
}

bool without_logarithm(const Point& p, std::size_t i) {
  if (!natural(p.roots[i])) return false;
  const std::size_t j = (i + 1) % 3;
  const std::size_t k = (i + 2) % 3;
  const Rational n = *p.roots[i];
  if (p.roots[j] && p.roots[k])
    return among(*p.roots[j] + *p.roots[k], n) || among(*p.roots[j] - *p.roots[k], n);
  const NfElem square(n * n);
  const auto sums = integer_sums(p.e[0] - square, p.e[2] / square);
  return std::ranges::any_of(sums, [&](const Integer& s) { return among(Rational(s), n); });
}

bool at(const WithoutLogarithm&, const Point& p) {
  bool some = false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!p.roots[i] || !is_integer(*p.roots[i])) continue;
    if (!without_logarithm(p, i)) return false;
    some = true;
  }
  return some;
}

bool at(const InRow& s, const Point& p) {
  if (!p.rational()) return false;
  const SchwarzClass* row = schwarz_class({*p.roots[0], *p.roots[1], *p.roots[2]});
  return row != nullptr && row->group == s.group;
}

bool at(const LameIsFinite&, const Point& p) {
  const auto& x = p.squares;
  const NfElem alpha = (x[0] - NfElem(1)) * NfElem(Rational(1, 4));
  return lame_answer(alpha, {x[1], x[2], x[3]}).abelian == Truth::yes;
}

} // namespace

bool is_so_of_three(const Assertion& s, const Poly& squares) {
  Roots roots;
  for (const Rational& square : rational_roots(squares)) // the others are irrational
    roots.push_back(exact_sqrt(square));
  roots.resize(3);
  return std::visit([&](const auto& one) { return at(one, Point(roots, squares)); }, s);
}

bool is_so(const Statement& s, const ValueAt& value) {
  return std::visit([&](const auto& x) { return at(x, Point(x.squares, value)) == s.holds; },
                    s.says);
}

} // namespace kov
