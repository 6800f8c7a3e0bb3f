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

bool implies(const DifferenceCondition& a, const DifferenceCondition& b) {
  if (a == b) return true;
  if (!a.holds || !b.holds || a.or_all_rational || a.squares != b.squares) return false;
  const auto strength = [](Kind kind) {
    return kind == Kind::rational ? 0 : kind == Kind::half_integer ? 1 : 2;
  };
  return a.kind == b.kind || strength(a.kind) > strength(b.kind);
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
