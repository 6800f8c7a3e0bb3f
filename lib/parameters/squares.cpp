#include "parameters/squares.hpp"

#include <algorithm>

namespace kov {
namespace {

using SquareTerms = std::vector<SquareTerm>;

constexpr int most_squares_deep = 4;
constexpr long most_terms_squared = 60;

void add(SquareTerms& all, const SquareTerms& more, const Rational& c, const MPoly& times) {
  for (const SquareTerm& s : more)
    all.push_back({c * s.c, times * s.q});
}

// Terms with even exponents and positive coefficients.
std::optional<SquareTerms> squares_of_monomials(const MPoly& p) {
  SquareTerms all;
  for (long t = 0; t < p.length(); ++t) {
    auto e = p.exponents(t);
    if (sign(p.coefficient(t)) < 0 ||
        std::ranges::any_of(e, [](unsigned long n) { return n % 2 != 0; }))
      return std::nullopt;
    for (unsigned long& n : e)
      n /= 2;
    all.push_back({Rational(p.coefficient(t)), MPoly::term(p.ring(), Integer(1), e)});
  }
  return all;
}

/// f = a X^2 + b X + c, X a power of a variable, and 4 a c - b^2.
struct QuadraticInPower {
  MPoly x, a, b, c, rest;
};
std::vector<QuadraticInPower> quadratics(const MPoly& f) {
  std::vector<QuadraticInPower> all;
  for (const std::size_t i : used_variables(f)) {
    const auto line = coefficients(f, i);
    const std::size_t top = line.size() - 1;
    bool is_quadratic = top % 2 == 0;
    for (std::size_t k = 1; k < top && is_quadratic; ++k)
      is_quadratic = k == top / 2 || is_zero(line[k]);
    if (!is_quadratic) continue;
    std::vector<unsigned long> e(f.ring()->size(), 0);
    e[i] = top / 2;
    const MPoly &a = line[top], &b = line[top / 2], &c = line[0];
    all.push_back({MPoly::term(f.ring(), Integer(1), e), a, b, c,
                   MPoly(f.ring(), Integer(4)) * a * c - b * b});
  }
  return all;
}

bool is_positive_number(const MPoly& p) {
  return !is_zero(p) && is_constant(p) && sign(p.coefficient(0)) > 0;
}

// 4 a p = (2 a X + b)^2 + rest, 4 c p = (b X + 2 c)^2 + rest X^2.
std::optional<SquareTerms> squares_of(const MPoly& p, int depth) {
  if (is_zero(p)) return SquareTerms{};
  if (auto all = squares_of_monomials(p)) return all;
  if (depth == 0 || p.length() > most_terms_squared) return std::nullopt;
  const MPoly two(p.ring(), Integer(2)), one(p.ring(), Integer(1));
  for (const QuadraticInPower& f : quadratics(p))
    for (const bool first : {true, false}) {
      const MPoly& pivot = first ? f.a : f.c;
      if (!is_positive_number(pivot)) continue;
      const auto rest = squares_of(f.rest, depth - 1);
      if (!rest) continue;
      const Rational c = Rational(1) / Rational(Integer(4) * pivot.coefficient(0));
      SquareTerms all{{c, first ? two * f.a * f.x + f.b : f.b * f.x + two * f.c}};
      add(all, *rest, c, first ? one : f.x);
      return all;
    }
  return std::nullopt;
}

// The squares of p, with a number among them.
std::optional<SquareTerms> strict_squares_of(const MPoly& p) {
  if (is_zero(p)) return std::nullopt;
  const std::vector<unsigned long> none(p.ring()->size(), 0);
  const MPoly one(p.ring(), Integer(1));
  for (long t = 0; t < p.length(); ++t) {
    if (p.exponents(t) != none || sign(p.coefficient(t)) <= 0) continue;
    for (const long part : {1L, 2L, 16L, 256L}) {
      const MPoly left = MPoly(p.ring(), Integer(part)) * p - MPoly(p.ring(), p.coefficient(t));
      const auto squares = squares_of(left, most_squares_deep);
      if (!squares) continue;
      SquareTerms all{{Rational(p.coefficient(t)) / Rational(part), one}};
      add(all, *squares, Rational(1) / Rational(part), one);
      return all;
    }
  }
  return std::nullopt;
}

} // namespace

std::optional<NoRealZero> no_real_zero(const MPoly& f) {
  if (f.length() > most_terms_squared) return std::nullopt;
  const MPoly one(f.ring(), Integer(1)), two(f.ring(), Integer(2));
  if (auto all = strict_squares_of(f)) return NoRealZero{*std::move(all), -one};
  if (auto all = strict_squares_of(-f)) return NoRealZero{*std::move(all), one};
  for (const QuadraticInPower& g : quadratics(f))
    if (auto all = strict_squares_of(g.rest)) {
      all->push_back({Rational(1), two * g.a * g.x + g.b});
      return NoRealZero{*std::move(all), MPoly(f.ring(), Integer(-4)) * g.a};
    }
  return std::nullopt;
}

} // namespace kov
