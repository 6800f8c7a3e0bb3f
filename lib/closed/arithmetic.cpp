#include "closed/arithmetic.hpp"

#include "closed/kimura.hpp"
#include "closed/lame.hpp"
#include "closed/riemann.hpp"
#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/letters.hpp"
#include "exact/lists.hpp"
#include "exact/overloaded.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace kov {
namespace {

using Texts = std::vector<std::string>;

// ---- numbers as text

// sqrt(f) = scale * sqrt(inner)
struct Root {
  Rational scale{1};
  MFraction inner;
};

Root without_squares(const MFraction& f) {
  Root root{Rational(1), f};
  if (is_zero(f) || !is_constant(f.den())) return root;
  const Integer den = f.den().coefficient(0);
  const Integer content = factor(f.num()).first * den;
  root.scale = Rational(square_part(sign(content) < 0 ? -content : content).first, den);
  root.inner = (Rational(1) / (root.scale * root.scale)) * f;
  return root;
}

std::string scaled_text(const Rational& c, const std::string& text) {
  std::string s = c.num() == Integer(1) ? text : to_string(c.num()) + "*" + text;
  return c.den() == Integer(1) ? s : s + "/" + to_string(c.den());
}

std::string number_text(const MFraction& square) {
  if (is_zero(square)) return "0";
  if (const auto root = square_root(square)) return to_string(*root);
  const Root root = without_squares(square);
  return scaled_text(root.scale, "sqrt(" + to_string(root.inner) + ")");
}

// One text for each number: equal ones count as often as they occur.
Texts number_texts(const Squares& squares) {
  Texts all;
  for (const MFraction& s : squares)
    all.push_back(number_text(s));
  return all;
}

Texts each_once(const Texts& texts) {
  Texts all;
  for (const std::string& t : texts)
    add_once(all, t);
  return all;
}

// ---- classes of numbers as text

Rational modulo_one(const Rational& a) { return a - Rational(floor(a)); }

// Is the number known, or only its square?
enum class Known : std::uint8_t { itself, up_to_sign };

// "an odd integer", "in 1/2 + Z": after "is" or "is not"
std::string class_text(const Residues& c, Known number) {
  const Rational a = c.a - Rational(floor(c.a / c.step)) * c.step;
  const bool symmetric = number == Known::itself || is_integer(Rational(2) * a / c.step);
  if (c.step == Rational(1) && is_zero(a)) return "an integer";
  if (c.step == Rational(2) && is_zero(a)) return "an even integer";
  if (c.step == Rational(2) && a == Rational(1)) return "an odd integer";
  const std::string step = c.step == Rational(1) ? "Z" : to_string(c.step) + "*Z";
  if (is_zero(a)) return "in " + step;
  return "in " + std::string(symmetric ? "" : "+-") + to_string(a) + " + " + step;
}

std::string is_in(const Texts& all, const std::string& what, bool holds) {
  if (holds) return joined(all, ", ", " or ") + " is " + what;
  if (all.size() > 1) return "none of " + joined(all) + " is " + what;
  return all[0] + " is not " + what;
}

// Beside the names in the numbers that a sentence is about.
FreshLetters letters_for(const Squares& squares) {
  for (const MFraction& s : squares)
    if (s.ring()) return FreshLetters(s.ring());
  return FreshLetters();
}

std::string step_text(const Residues& c, const std::string& p) {
  const std::string step = c.step == Rational(1) ? p : to_string(c.step) + "*" + p;
  return is_zero(c.a) ? step : "+-" + to_string(c.a) + " + " + step;
}

// Several classes: "+-1/6 + 2*p, +-5/6 + 2*p (p an integer)", after "one of" or "none of"
std::string classes_text(const SumIn& s) {
  const std::string p = letters_for(s.squares)("p");
  Texts steps;
  for (const Residues& c : s.classes)
    steps.push_back(step_text(c, p));
  return joined(steps) + " (" + p + " an integer)";
}

std::string is_in_one(const std::string& number, const SumIn& s, bool holds) {
  if (s.classes.size() == 1)
    return is_in({number}, class_text(s.classes[0], Known::up_to_sign), holds);
  return number + (holds ? " is one of " : " is none of ") + classes_text(s);
}

// h is an integer exactly where `number` is in a class: in a + Z, 0 <= a < 1, or twice that.
struct Shifted {
  std::string number;
  Residues in;
};
Shifted shifted(const MFraction& h) {
  MFraction rest = h;
  Rational c(0);
  if (is_constant(h.den())) {
    const MPoly num = h.num();
    for (long i = 0; i < num.length(); ++i) {
      const auto e = num.exponents(i);
      if (std::ranges::any_of(e, [](unsigned long n) { return n > 0; })) continue;
      c = Rational(num.coefficient(i)) / Rational(h.den().coefficient(0));
      rest = h - MFraction(h.ring(), c);
    }
  }
  const bool negative = !is_zero(rest) && sign(rest.num().coefficient(0)) < 0;
  const Rational a = modulo_one(negative ? c : -c);
  if (negative) rest = -rest;
  const Rational two(2);
  const bool is_half = is_constant(rest.den()) && rest.den().coefficient(0) == Integer(2);
  return is_half ? Shifted{to_string(two * rest), {two * a, two}}
                 : Shifted{to_string(rest), {a, Rational(1)}};
}

// The functions of which one is an integer, those with one fractional part together.
std::string one_is_integral(const std::vector<MFraction>& all, bool holds) {
  std::map<std::pair<Rational, Rational>, Texts> by_class;
  for (const MFraction& h : all) {
    if (is_zero(h) || is_constant(h)) continue;
    const Shifted s = shifted(h);
    Texts& texts = by_class[{s.in.step, s.in.a}];
    add_once(texts, s.number);
  }
  const auto one = [&](const auto& x) {
    const auto& [step, a] = x.first;
    return is_in(x.second, class_text({a, step}, Known::itself), holds);
  };
  return joined(by_class, one, holds ? " or " : " and ");
}

// The same statement about the one number that depends on parameters, if the others are rational.
std::optional<SumIn> without_numbers(const SumIn& s) {
  SumIn one{{}, s.classes};
  for (const MFraction& x : s.squares) {
    const bool number = is_zero(x) || is_constant(x);
    const auto root = number ? square_root(x) : std::nullopt;
    if (!root) {
      one.squares.push_back(x);
      continue;
    }
    const Rational c = is_zero(x) ? Rational(0) : to_rational(*root);
    std::vector<Residues> classes;
    for (const Residues& r : one.classes)
      for (const Rational& a : {r.a - c, r.a + c}) {
        const Rational rest = a - Rational(floor(a / r.step)) * r.step;
        const Rational folded = std::min(rest, r.step - rest);
        if (std::ranges::none_of(classes, [&](const Residues& old) {
              return old.a == folded && old.step == r.step;
            }))
          classes.push_back({folded, r.step});
      }
    one.classes = std::move(classes);
  }
  return one.squares.size() == 1 ? std::optional(one) : std::nullopt;
}

// ---- one sentence for each statement

std::string words(const SumIn& s, bool holds) {
  if (const auto functions = integral_somewhere(s); functions && s.classes.size() == 1)
    return one_is_integral(*functions, holds);
  if (s.squares.size() > 1)
    if (const auto one = without_numbers(s)) return words(*one, holds);
  if (s.squares.size() == 1) {
    if (const auto root = square_root(s.squares[0])) return is_in_one(to_string(*root), s, holds);
    const Root root = without_squares(s.squares[0]);
    SumIn inner = s;
    for (Residues& c : inner.classes)
      c = {c.a / root.scale, c.step / root.scale};
    return is_in_one("sqrt(" + to_string(root.inner) + ")", inner, holds);
  }
  std::string sum = joined(
      s.squares, [&](const MFraction& x) { return number_text(x); }, " +- ");
  const bool one = s.classes.size() == 1;
  return (holds ? "some " : "no ") + sum + " is " +
         (one ? class_text(s.classes[0], Known::up_to_sign) : "one of " + classes_text(s));
}

// Without the numbers that are rational for all parameters, nor constant terms and factors.
std::string words(const AllRational& s, bool holds) {
  Texts all;
  for (const MFraction& x : s.squares) {
    std::string text = number_text(x);
    if (const auto root = square_root(x)) {
      if (is_zero(*root) || is_constant(*root)) continue;
      const auto used = used_variables(*root);
      if (used.size() == 1 && degree(root->num(), used[0]) <= 1 &&
          degree(root->den(), used[0]) <= 1)
        text = root->ring()->name(used[0]); // a Moebius function of it
    }
    add_once(all, text);
  }
  if (all.size() == 1) return all[0] + (holds ? " is rational" : " is irrational");
  return holds ? joined(all, ", ", " and ") + " are rational"
               : "one of " + joined(all) + " is irrational";
}

std::string words(const InHalves& s, bool holds) {
  const std::string half = "in 1/2 + Z";
  const Texts all = number_texts(s.squares), once = each_once(all);
  if (s.count == 1) {
    std::vector<MFraction> shifts;
    for (const MFraction& x : s.squares)
      if (const auto root = square_root(x))
        shifts.push_back(*root - MFraction(x.ring(), Rational(1, 2)));
    if (shifts.size() == s.squares.size()) return one_is_integral(shifts, holds);
    return is_in(once, half, holds);
  }
  if (once.size() == 1) return is_in(once, half, holds);
  if (s.count == s.squares.size())
    return holds ? joined(once, ", ", " and ") + " are " + half
                 : "not both of " + joined(once, ", ", " and ") + " are " + half;
  return (holds ? "two of " : "at most one of ") + joined(all) + (holds ? " are " : " is ") + half;
}

std::string words(const Separated& s, bool holds) {
  const FreshLetters letter = letters_for(s.squares);
  return "+-(" + number_text(s.squares[0]) + ") is " + (holds ? "a" : "not a") +
         " natural number " + letter("N") + " with " + number_text(s.squares[1]) +
         letter.in(" among N - 1, N - 3, ..., 1 - N");
}

std::string words(const SeparatedPair& s, bool holds) {
  const FreshLetters letter = letters_for(s.squares);
  const auto text = [](const MFraction& f) { return is_zero(f) ? std::string("0") : to_string(f); };
  return "+-(" + number_text(s.squares[0]) + ") is " + (holds ? "a" : "not a") +
         " natural number " + letter("N") +
         letter.in(" with +-d1 +- d2 among N - 1, N - 3, ..., 1 - N, where d1^2 + d2^2 = ") +
         text(s.squares[1]) + letter.in(", d1^2*d2^2 = ") + text(s.squares[2]);
}

std::string words(const WithoutLogarithm& s, bool holds) {
  const std::string all = joined(number_texts(s.squares));
  return holds ? "one of " + all + " is an integer, and there is no logarithm"
               : "none of " + all + " is an integer, or there is a logarithm";
}

std::string words(const InRow& s, bool holds) {
  return joined(number_texts(s.squares)) + (holds ? " are" : " are not") + " in a row for " +
         to_string(s.group) + " of the table of Schwarz and Kimura";
}

std::string words(const LameIsFinite& s, bool holds) {
  const Rational quarter(1, 4);
  const std::string index = number_text(quarter * s.squares[0]);
  const auto value = [&](std::size_t i) {
    return is_zero(s.squares[i]) ? std::string("0") : to_string(s.squares[i]);
  };
  const FreshLetters letter = letters_for(s.squares);
  if (s.half)
    return "Q_" + letter("m") + "(" + value(1) + ", " + value(2) + ", " + value(3) + ") " +
           (holds ? "= 0" : "!= 0") + ", Brioschi's determinant for " + letter("m") + " = |" +
           index + "|";
  return "the polynomials of 'kovacic lame' for " + letter("n") + " + 1/2 = " + index +
         (holds ? " vanish" : " do not all vanish") + " at " + letter("B") + " = " + value(1) +
         ", " + letter("g2") + " = " + value(2) + ", " + letter("g3") + " = " + value(3);
}

// ---- at one point

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

bool contains(const std::vector<Residues>& classes, const Rational& v) {
  return std::ranges::any_of(classes, [&](const Residues& c) {
    return is_integer((v - c.a) / c.step) || is_integer((v + c.a) / c.step);
  });
}

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

bool at(const InHalves& s, const Point& p) {
  return std::ranges::count_if(p.roots, [](const auto& x) {
           return x && x->den() == Integer(2);
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

std::string to_string(const ArithmeticCondition& c) {
  return std::visit([&](const auto& s) { return words(s, c.holds); }, c.statement);
}

bool is_so_of_three(const ArithmeticStatement& s, const Poly& squares) {
  Roots roots;
  for (const Rational& square : rational_roots(squares)) // the others are irrational
    roots.push_back(exact_sqrt(square));
  roots.resize(3);
  return std::visit([&](const auto& one) { return at(one, Point(roots, squares)); }, s);
}

bool is_so(const ArithmeticCondition& c, const ValueAt& value) {
  return std::visit([&](const auto& s) { return at(s, Point(s.squares, value)) == c.holds; },
                    c.statement);
}

} // namespace kov
