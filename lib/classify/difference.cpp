#include "classify/difference.hpp"

#include "special/arithmetic.hpp"

#include <algorithm>

namespace kov {
namespace {

using Kind = DifferenceCondition::Kind;

bool is_special(Kind kind, const Rational& square) {
  const auto root = exact_sqrt(square);
  if (!root) return false;
  switch (kind) {
  case Kind::rational:
    return true;
  case Kind::integer:
    return is_integer(*root);
  case Kind::half_integer:
    return is_integer(Rational(2) * *root);
  case Kind::odd_half:
    return is_integer(*root - Rational(1, 2));
  }
  return true;
}

// f as a function on the set, where its denominator does not vanish identically.
std::optional<MFraction> restricted(const MFraction& f, const ParameterSet& where) {
  const MFraction den = where.restrict(f.den());
  if (is_zero(den)) return std::nullopt;
  return where.restrict(f.num()) / den;
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
      left.squares.push_back(*here);
      continue;
    }
    const Rational value = is_zero(*here) ? Rational(0) : to_rational(*here);
    if (is_special(c.kind, value)) return with_sign(true, c.holds);
    if (!exact_sqrt(value)) left.or_all_rational = false;
  }
  if (left.squares.empty()) return with_sign(left.or_all_rational, c.holds);
  return left;
}

namespace {

// Each is the other one times the square of a rational number.
bool same_up_to_squares(const std::vector<MFraction>& a, const std::vector<MFraction>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const MFraction& x, const MFraction& y) {
                      if (is_zero(x) || is_zero(y)) return is_zero(x) && is_zero(y);
                      const MFraction ratio = x / y;
                      return is_constant(ratio) && exact_sqrt(to_rational(ratio)).has_value();
                    });
}

} // namespace

bool implies(const DifferenceCondition& a, const DifferenceCondition& b) {
  if (a == b) return true;
  if (!a.holds || !b.holds || a.or_all_rational) return false;
  if (b.kind == Kind::rational && same_up_to_squares(a.squares, b.squares)) return true;
  if (a.squares != b.squares) return false;
  const auto strength = [](Kind kind) {
    return kind == Kind::rational ? 0 : kind == Kind::half_integer ? 1 : 2;
  };
  return a.kind == b.kind || strength(a.kind) > strength(b.kind);
}

namespace {

/// What one statement says of one difference.
struct Special {
  MFraction square;
  Kind kind;
};

// a + step Z and -a + step Z lie in it.
Kind kind_of(const Rational& a, const Rational& step) {
  if (is_integer(step) && is_integer(a)) return Kind::integer;
  if (is_integer(step) && is_integer(a - Rational(1, 2))) return Kind::odd_half;
  const Rational two(2);
  return is_integer(two * step) && is_integer(two * a) ? Kind::half_integer : Kind::rational;
}

// The smallest kind with both.
Kind join(Kind a, Kind b) {
  if (a == b) return a;
  return a == Kind::rational || b == Kind::rational ? Kind::rational : Kind::half_integer;
}

// The only one that is no number, and the sums of the others with both signs; unset: there are
// more, or a number is irrational.
struct OneOpen {
  MFraction square;
  std::vector<Rational> sums{Rational(0)};
};
std::optional<OneOpen> one_open(const Squares& squares) {
  std::optional<MFraction> open;
  std::vector<Rational> sums{Rational(0)};
  for (const MFraction& square : squares) {
    if (!is_zero(square) && !is_constant(square)) {
      if (open) return std::nullopt;
      open = square;
      continue;
    }
    const auto root = exact_sqrt(is_zero(square) ? Rational(0) : to_rational(square));
    if (!root) return std::nullopt;
    std::vector<Rational> more;
    for (const Rational& x : sums) {
      more.push_back(x + *root);
      more.push_back(x - *root);
    }
    sums = std::move(more);
  }
  if (!open) return std::nullopt;
  return OneOpen{*std::move(open), std::move(sums)};
}

std::optional<Special> said_by(const SumIn& s) {
  const auto one = one_open(s.squares);
  if (!one || s.classes.empty()) return std::nullopt;
  std::optional<Kind> kind;
  for (const Residues& r : s.classes)
    for (const Rational& x : one->sums) {
      const Kind here = kind_of(r.a + x, r.step);
      kind = kind ? join(*kind, here) : here;
    }
  return Special{one->square, *kind};
}

struct WhatItSays {
  std::vector<Special> operator()(const SumIn& s) const {
    const auto one = said_by(s);
    return one ? std::vector{*one} : std::vector<Special>{};
  }
  std::vector<Special> operator()(const AllRational& s) const { return all_rational(s.squares); }
  std::vector<Special> operator()(const InRow& s) const { return all_rational(s.squares); }
  std::vector<Special> operator()(const InHalves& s) const {
    if (s.count < s.squares.size()) return {}; // which of them is not known
    std::vector<Special> all;
    for (const MFraction& square : s.squares)
      all.push_back({square, Kind::odd_half});
    return all;
  }
  template <class Other> std::vector<Special> operator()(const Other&) const { return {}; }

private:
  static std::vector<Special> all_rational(const Squares& squares) {
    std::vector<Special> all;
    for (const MFraction& square : squares)
      all.push_back({square, Kind::rational});
    return all;
  }
};

std::vector<Special> said_by(const std::vector<ArithmeticCondition>& part) {
  std::vector<Special> all;
  for (const ArithmeticCondition& c : part)
    if (c.holds)
      for (Special& one : std::visit(WhatItSays{}, c.statement))
        all.push_back(std::move(one));
  return all;
}

} // namespace

std::optional<DifferenceCondition>
necessary_condition(const std::vector<std::vector<ArithmeticCondition>>& parts) {
  if (parts.empty()) return std::nullopt;
  std::vector<Special> common = said_by(parts.front());
  std::erase_if(common,
                [](const Special& c) { return is_zero(c.square) || is_constant(c.square); });
  for (const auto& part : parts) {
    const auto here = said_by(part);
    std::vector<Special> both;
    for (const Special& c : common)
      for (const Special& x : here)
        if (x.square == c.square) both.push_back({c.square, join(c.kind, x.kind)});
    common = std::move(both);
  }
  if (common.empty()) return std::nullopt;
  const auto strongest =
      std::max_element(common.begin(), common.end(), [](const Special& a, const Special& b) {
        return (a.kind == Kind::rational) > (b.kind == Kind::rational);
      });
  return DifferenceCondition{strongest->kind, {strongest->square}};
}

DifferenceCondition negation(DifferenceCondition c) {
  c.holds = !c.holds;
  return c;
}

namespace {

std::string root(const MFraction& square) {
  if (const auto exact = square_root(square)) return to_factored_string(*exact);
  return "sqrt(" + to_factored_string(square) + ")";
}

std::string subject(Kind kind, const MFraction& square) {
  const std::string text = root(square);
  const bool sum = text.find_first_of("+-", 1) != std::string::npos && !text.starts_with("sqrt(");
  switch (kind) {
  case Kind::half_integer:
    return "2*" + (sum ? "(" + text + ")" : text);
  case Kind::odd_half:
    return text + " - 1/2";
  default:
    return text;
  }
}

std::string listed(const std::vector<std::string>& all, const std::string& last) {
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i)
    text += (i == 0 ? "" : i + 1 == all.size() ? last : ", ") + all[i];
  return text;
}

} // namespace

std::string to_string(const DifferenceCondition& c) {
  std::vector<std::string> subjects, roots;
  for (const MFraction& square : c.squares) {
    subjects.push_back(subject(c.kind, square));
    roots.push_back(root(square));
  }
  const std::string what = c.kind == Kind::rational ? "rational" : "an integer";
  if (c.holds)
    return listed(subjects, " or ") + " is " + what +
           (c.or_all_rational ? ", or " + listed(roots, " and ") +
                                    (roots.size() > 1 ? " are rational" : " is rational")
                              : "");
  if (subjects.size() == 1 && !c.or_all_rational) return subjects[0] + " is not " + what;
  return "none of " + listed(subjects, ", ") + " is " + what +
         (c.or_all_rational ? ", and not all of " + listed(roots, ", ") + " are rational" : "");
}

} // namespace kov
