#include "closed/statement.hpp"
#include "exact/lists.hpp"

#include <algorithm>

namespace kov::strata {

std::optional<Rational> constant_value(const MFraction& f) {
  if (is_zero(f)) return Rational(0);
  return is_constant(f) ? std::optional(to_rational(f)) : std::nullopt;
}

std::optional<Rational> constant_root(const MFraction& square) {
  if (is_zero(square)) return Rational(0);
  return is_constant(square) ? exact_sqrt(to_rational(square)) : std::nullopt;
}

bool is_plainly_nonzero(const MPoly& p, const ParametrisedSet& region) {
  if (is_zero(p)) return false;
  const auto& path = region.path();
  const auto parts = irreducible_parts(p);
  return std::ranges::all_of(parts, [&](const MPoly& f) {
    return is_among(Condition{f, Sign::nonzero}, path) || region.implies_nonzero(f) ||
           region.exact_sign_of(f) != 0;
  });
}

namespace {

class KnownOnRegion {
public:
  explicit KnownOnRegion(const ParametrisedSet& region) : region_(region) {}

  [[nodiscard]] Truth operator()(const SumIn& s) const {
    const auto one = integral_somewhere(s);
    if (!one) return s.squares.size() == 1 && is_number(s.squares[0]) ? Truth::no : Truth::unknown;
    bool never = true;
    for (const MFraction& h : *one) {
      const Truth t = region_.is_integral(h);
      if (t == Truth::yes) return Truth::yes;
      never = never && t == Truth::no;
    }
    return never ? Truth::no : Truth::unknown;
  }

  [[nodiscard]] Truth operator()(const AllRational& s) const {
    bool all = true;
    for (const MFraction& x : s.squares) {
      const Truth t = rational(x);
      if (t == Truth::no) return Truth::no;
      all = all && t == Truth::yes;
    }
    return all ? Truth::yes : Truth::unknown;
  }

  [[nodiscard]] Truth operator()(const SomeIn& s) const {
    if (s.or_all_rational && (*this)(AllRational{s.squares}) != Truth::no) return Truth::unknown;
    std::size_t certain = 0;
    std::size_t possible = 0;
    for (const MFraction& x : s.squares) {
      const Truth t = s.classes ? (*this)(SumIn{{x}, *s.classes}) : rational(x);
      certain += t == Truth::yes ? 1 : 0;
      possible += t == Truth::no ? 0 : 1;
    }
    return certain >= s.count ? Truth::yes : possible < s.count ? Truth::no : Truth::unknown;
  }

  [[nodiscard]] Truth operator()(const Separated& s) const {
    if (natural(s.squares[0]) == Truth::no || integral(s.squares[1]) == Truth::no) return Truth::no;
    if (const Truth t = separated_by_signs(s); t != Truth::unknown) return t;
    const auto n = constant_root(s.squares[0]);
    if (!n || *n > Rational(20)) return Truth::unknown;
    for (Rational v = *n - Rational(1); sign(v) >= 0; v = v - Rational(2))
      if (may_be(s.squares[1], v * v)) return Truth::unknown;
    return Truth::no;
  }

  // separated.hpp knows more: why the numbers are not rational.
  [[nodiscard]] Truth operator()(const SeparatedPair& s) const {
    return natural(s.squares[0]) == Truth::no ? Truth::no : Truth::unknown;
  }

  [[nodiscard]] Truth operator()(const WithoutLogarithm& s) const {
    const auto any = [&](auto property) { return std::ranges::any_of(s.squares, property); };
    const bool some = any([&](const MFraction& x) { return natural(x) != Truth::no; });
    return !some || any([](const MFraction& x) { return is_zero(x); }) ? Truth::no : Truth::unknown;
  }

  // No row has an integer, or a denominator above 5.
  [[nodiscard]] Truth operator()(const InRow& s) const {
    const bool never = std::ranges::any_of(s.squares, [&](const MFraction& x) {
      if (integral(x) == Truth::yes || rational(x) == Truth::no) return true;
      if (const auto f = square_root(x); f && !is_number(*f))
        return region_.is_integral(Rational(60) * *f) == Truth::no;
      const auto root = constant_root(x);
      return root && root->den() > Integer(5);
    });
    return never ? Truth::no : Truth::unknown;
  }

  [[nodiscard]] Truth operator()(const LameIsFinite&) const { return Truth::unknown; }

private:
  // With N and x the roots of the squares: N + x and N - x, odd integers, have the same sign.
  [[nodiscard]] Truth separated_by_signs(const Separated& s) const {
    const auto n = square_root(s.squares[0]);
    const auto x = square_root(s.squares[1]);
    if (!n || !x) return Truth::unknown;
    const int left = sign_of_odd(*n + *x);
    const int right = left != 0 ? sign_of_odd(*n - *x) : 0;
    return right != 0 ? truth(left == right) : Truth::unknown;
  }
  // 0: not known, or no odd integer.  It is positive if it is > -1, and negative if it is < 1.
  [[nodiscard]] int sign_of_odd(const MFraction& f) const {
    const MFraction one(region_.ring(), Rational(1));
    if (is_zero(f) || region_.is_integral(Rational(1, 2) * (f - one)) != Truth::yes) return 0;
    if (is_constant(f)) return sign(to_rational(f));
    if (!is_constant(f.den())) return 0;
    const int den = sign(f.den().coefficient(0));
    for (const int positive : {1, -1}) {
      const MFraction g = f + Rational(positive) * one;
      if (!is_zero(g) && den * region_.exact_sign_of(g.num()) == positive) return positive;
    }
    return 0;
  }
  [[nodiscard]] bool may_be(const MFraction& f, const Rational& value) const {
    const MFraction difference = f - MFraction(region_.ring(), value);
    return is_zero(difference) || !is_plainly_nonzero(difference.num(), region_);
  }
  [[nodiscard]] Truth integral(const MFraction& square) const {
    return (*this)(SumIn{{square}, {all_integers}});
  }
  [[nodiscard]] Truth natural(const MFraction& square) const { // up to sign; not 0
    return is_zero(square) ? Truth::no : integral(square);
  }
  [[nodiscard]] Truth rational(const MFraction& square) const {
    if (is_number(square)) return constant_root(square) ? Truth::yes : Truth::no;
    const auto root = square_root(square);
    if (!root) return Truth::unknown;
    const auto used = used_variables(*root);
    const bool declared =
        std::ranges::all_of(used, [&](std::size_t i) { return region_.is_rational(i); });
    return declared || region_.is_integral(*root) == Truth::yes ||
                   region_.is_integral(Rational(2) * *root) == Truth::yes
               ? Truth::yes
               : Truth::unknown;
  }

  const ParametrisedSet& region_;
};

} // namespace

Truth holds_on(const Assertion& s, const ParametrisedSet& region) {
  const Squares& all = squares_of(s);
  if (!std::ranges::all_of(all, is_number)) return std::visit(KnownOnRegion(region), s);
  const auto value = [](const MFraction& f) {
    return NfElem(is_zero(f) ? Rational(0) : to_rational(f));
  };
  return truth(is_so({s}, value));
}

} // namespace kov::strata
