#include "exact/joined.hpp"
#include "exact/letters.hpp"
#include "exact/lists.hpp"
#include "parameters/statement.hpp"

#include <algorithm>
#include <map>

namespace kov {
namespace {

using Texts = std::vector<std::string>;

// ---- numbers as text

std::string text_of(const MFraction& f) {
  std::string sum = to_string(f), product = to_factored_string(f);
  return product.size() < sum.size() ? product : sum;
}

// sqrt(f) = scale * sqrt(inner)
struct Root {
  Rational scale{1};
  MFraction inner;
};

Root without_squares(const MFraction& f) {
  if (is_zero(f)) return {Rational(1), f};
  const Integer den = factor(f.den()).first;
  const Integer content = factor(f.num()).first * den;
  const Rational scale(square_part(sign(content) < 0 ? -content : content).first, den);
  return {scale, (Rational(1) / (scale * scale)) * f};
}

std::string sqrt_text(const MFraction& f) {
  const std::string text = text_of(f);
  const bool bracketed = text.front() == '(' && text.find(')') + 1 == text.size();
  return "sqrt" + (bracketed ? text : "(" + text + ")");
}

std::string scaled_text(const Rational& c, const std::string& text) {
  std::string s = c.num() == Integer(1) ? text : to_string(c.num()) + "*" + text;
  return c.den() == Integer(1) ? s : s + "/" + to_string(c.den());
}

std::string number_text(const MFraction& square) {
  if (is_zero(square)) return "0";
  if (const auto root = square_root(square)) return text_of(*root);
  const Root root = without_squares(square);
  return scaled_text(root.scale, sqrt_text(root.inner));
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

// Without the numbers that are rational for all parameters, nor constant terms and factors.
Texts rational_texts(const Squares& squares) {
  Texts all;
  for (const MFraction& x : squares) {
    const auto root = square_root(x);
    if (!root) {
      add_once(all, sqrt_text(without_squares(x).inner));
      continue;
    }
    if (is_number(*root)) continue;
    const auto used = used_variables(*root);
    const bool is_moebius =
        used.size() == 1 && degree(root->num(), used[0]) <= 1 && degree(root->den(), used[0]) <= 1;
    add_once(all, is_moebius ? root->ring()->name(used[0]) : number_text(without_squares(x).inner));
  }
  return all;
}

// ---- classes of numbers as text

Rational modulo(const Rational& a, const Rational& step) {
  return a - Rational(floor(a / step)) * step;
}

// Is the number known, or only its square?
enum class About : std::uint8_t { itself, up_to_sign };

std::string row_text(const Residues& c, About number) {
  const Rational a = modulo(c.a, c.step);
  const bool symmetric = number == About::itself || is_integer(Rational(2) * a / c.step);
  const std::string step = c.step == Rational(1) ? "Z" : to_string(c.step) + "*Z";
  return is_zero(a) ? step : (symmetric ? "" : "+-") + to_string(a) + " + " + step;
}

std::string classes_text(const Classes& all, About number) {
  if (all.size() == 1) {
    const Rational a = modulo(all[0].a, all[0].step);
    if (all[0].step == Rational(1) && is_zero(a)) return "an integer";
    if (all[0].step == Rational(2) && is_zero(a)) return "an even integer";
    if (all[0].step == Rational(2) && a == Rational(1)) return "an odd integer";
  }
  Texts rows;
  for (const Residues& c : all)
    rows.push_back(row_text(c, number));
  return "in " + joined(rows, ", ", " or ");
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
  if (negative) rest = -rest;
  const Rational a = modulo(negative ? c : -c, Rational(1)), two(2);
  const bool is_half = is_constant(rest.den()) && rest.den().coefficient(0) == Integer(2);
  return is_half ? Shifted{text_of(two * rest), {two * a, two}}
                 : Shifted{text_of(rest), {a, Rational(1)}};
}

// The numbers that are in the same classes, together.
using ByClasses = std::map<std::string, Texts>;

void add_integral(const std::vector<MFraction>& functions, ByClasses& all) {
  for (const MFraction& h : functions) {
    if (is_number(h)) continue;
    const Shifted s = shifted(h);
    add_once(all[classes_text({s.in}, About::itself)], s.number);
  }
}

void add_number(const MFraction& square, Classes classes, ByClasses& all) {
  const auto functions = integral_somewhere({{square}, classes});
  if (functions && functions->size() == 1) return add_integral(*functions, all);
  if (functions) return add_once(all[to_string(classes)], number_text(square));
  const Root root = without_squares(square);
  for (Residues& c : classes)
    c = {c.a / root.scale, c.step / root.scale};
  std::string text = sqrt_text(root.inner);
  const Rational times = Rational(1) / classes.front().step;
  if (classes.size() == 1 && is_zero(classes.front().a) && is_integer(times)) { // n x in Z
    text = scaled_text(times, text);
    classes = {all_integers};
  }
  add_once(all[to_string(classes)], text);
}

std::string some_is_in(const ByClasses& all, bool holds) {
  return joined(
      all, [&](const auto& x) { return is_in(x.second, x.first, holds); },
      holds ? " or " : " and ");
}

// The same statement about the one number that depends on parameters, if the others are rational.
std::optional<SumIn> without_numbers(const SumIn& s) {
  SumIn one{{}, s.classes};
  for (const MFraction& x : s.squares) {
    const auto root = is_number(x) ? square_root(x) : std::nullopt;
    if (!root) {
      one.squares.push_back(x);
      continue;
    }
    const Rational c = is_zero(x) ? Rational(0) : to_rational(*root);
    Classes classes;
    for (const Residues& r : one.classes)
      for (const Rational& a : {r.a - c, r.a + c}) {
        const Rational rest = modulo(a, r.step);
        add_once(classes, Residues{std::min(rest, r.step - rest), r.step});
      }
    one.classes = std::move(classes);
  }
  return one.squares.size() == 1 ? std::optional(one) : std::nullopt;
}

// ---- one sentence for each statement

std::string words(const AllRational& s, bool holds) {
  const Texts all = rational_texts(s.squares);
  if (all.size() == 1) return all[0] + (holds ? " is rational" : " is irrational");
  return holds ? joined(all, ", ", " and ") + " are rational"
               : "one of " + joined(all) + " is irrational";
}

std::string words_of_several(const SomeIn& s, bool holds) {
  const std::string what = s.classes ? to_string(*s.classes) : "rational";
  const Texts all = number_texts(s.squares), once = each_once(all);
  if (once.size() == 1) return is_in(once, what, holds);
  if (s.count == 2 && all.size() == 3) // of l, l, n these are the equal ones, with n or without it
    for (const std::string& text : once)
      if (std::ranges::count(all, text) == 2) return is_in({text}, what, holds);
  if (s.count == s.squares.size())
    return holds ? joined(once, ", ", " and ") + " are " + what
                 : "not both of " + joined(once, ", ", " and ") + " are " + what;
  return (holds ? "two of " : "at most one of ") + joined(all) + (holds ? " are " : " is ") + what;
}

std::string words(const SomeIn& s, bool holds) {
  if (s.count > 1) return words_of_several(s, holds);
  if (!s.classes) {
    const Texts all = rational_texts(s.squares);
    return all.size() == 1 ? words(AllRational{s.squares}, holds) : is_in(all, "rational", holds);
  }
  ByClasses all;
  for (const MFraction& x : s.squares)
    add_number(x, *s.classes, all);
  const std::string some = some_is_in(all, holds);
  if (!s.or_all_rational) return some;
  const Texts roots = rational_texts(s.squares);
  if (roots.size() == 1)
    return some + (holds ? ", or " : ", and ") + words(AllRational{s.squares}, holds);
  return some + (holds ? ", or " + joined(roots, ", ", " and ") + " are rational"
                       : ", and not all of " + joined(roots) + " are rational");
}

std::string words(const SumIn& s, bool holds) {
  if (s.squares.size() == 1) return words(SomeIn{s.squares, s.classes}, holds);
  if (const auto functions = integral_somewhere(s); functions && s.classes.size() == 1) {
    ByClasses all;
    add_integral(*functions, all);
    return some_is_in(all, holds);
  }
  if (const auto one = without_numbers(s)) return words(*one, holds);
  std::string sum = joined(
      s.squares, [&](const MFraction& x) { return number_text(x); }, " +- ");
  return (holds ? "some " : "no ") + sum + " is " + to_string(s.classes);
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
  return holds ? "(one of " + all + " is an integer, and there is no logarithm)"
               : "(none of " + all + " is an integer, or there is a logarithm)";
}

std::string words_of_rows(const Squares& squares, const Texts& groups, bool holds) {
  return joined(number_texts(squares)) + (holds ? " are in a row for " : " are in no row for ") +
         joined(groups, ", ", " or ") + " of the table of Schwarz and Kimura";
}
std::string words(const InRow& s, bool holds) {
  return words_of_rows(s.squares, {to_string(s.group)}, holds);
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

} // namespace

std::string to_string(const Residues& r) { return row_text(r, About::up_to_sign); }
std::string to_string(const Classes& all) { return classes_text(all, About::up_to_sign); }

std::string to_string(const Statement& s) {
  return std::visit([&](const auto& one) { return words(one, s.holds); }, s.says);
}

std::vector<WithContrary> with_contraries(const std::vector<Statement>& all) {
  std::vector<WithContrary> out;
  const InRow* rows = nullptr; // in none of which the numbers are
  Texts groups;
  for (const Statement& s : all) {
    const auto* row = s.holds ? nullptr : std::get_if<InRow>(&s.says);
    const bool joins = row != nullptr && rows != nullptr && row->squares == rows->squares;
    if (!joins) groups.clear();
    rows = row;
    if (row == nullptr) {
      out.push_back({to_string(s), to_string(negation(s))});
      continue;
    }
    groups.push_back(to_string(row->group));
    if (joins) out.pop_back();
    out.push_back(
        {words_of_rows(row->squares, groups, false), words_of_rows(row->squares, groups, true)});
  }
  return out;
}

} // namespace kov
