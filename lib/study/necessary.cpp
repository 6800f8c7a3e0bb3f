#include "study/necessary.hpp"

#include "closed/arithmetic.hpp"

#include <algorithm>

namespace kov {
namespace {

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
std::optional<SomeIn> said_by(const SumIn& s) {
  const auto one = one_open(s.squares);
  if (!one) return std::nullopt;
  Classes classes;
  for (long c = one->times; c >= 0; c -= 2)
    for (const Residues& r : s.classes)
      for (const Rational& x : one->sums) {
        if (c == 0 && contains(r, x)) return std::nullopt;
        if (c == 0) continue;
        const Rational by = Rational(1, c);
        for (const Rational& a : {r.a - x, -(r.a + x)})
          classes.push_back({a * by, r.step * by});
      }
  return SomeIn{{one->square}, simplified(classes)};
}

// All entries of the rows for A4, S4, A5 are in (1/6)Z, (1/12)Z, (1/30)Z.
Residues entries(GroupType group) {
  return {Rational(0), Rational(1, group == GroupType::A4 ? 6 : group == GroupType::S4 ? 12 : 30)};
}

// Set if all that is open is one difference: the rows matter up to sign and modulo 2.
std::optional<SomeIn> said_by(const InRow& s) {
  const auto one = one_open(s.squares);
  if (!one) return std::nullopt;
  Classes classes;
  for (long d = 2; d <= 5; ++d)
    for (long j = 0; j <= d; ++j) {
      const Rational nu(j, d);
      const auto at = [&](const MFraction& f) {
        return NfElem(f == one->square ? nu * nu : is_zero(f) ? Rational(0) : to_rational(f));
      };
      if (is_so({s, true}, at)) classes.push_back({nu, Rational(2)});
    }
  return SomeIn{{one->square}, simplified(classes)};
}

struct WhatItSays {
  std::vector<SomeIn> operator()(const SumIn& s) const {
    const auto one = said_by(s);
    return one ? std::vector{*one} : std::vector<SomeIn>{};
  }
  std::vector<SomeIn> operator()(const AllRational& s) const { return all(s.squares, {}); }
  std::vector<SomeIn> operator()(const InRow& s) const {
    if (const auto one = said_by(s)) return {*one};
    return all(s.squares, Classes{entries(s.group)});
  }
  std::vector<SomeIn> operator()(const Separated& s) const {
    return all(s.squares, Classes{all_integers});
  }
  std::vector<SomeIn> operator()(const SeparatedPair& s) const {
    return all({s.squares.front()}, Classes{all_integers});
  }
  std::vector<SomeIn> operator()(const SomeIn& s) const {
    if (s.count < s.squares.size() || s.or_all_rational) return {}; // which of them is not known
    return all(s.squares, s.classes);
  }
  template <class Other> std::vector<SomeIn> operator()(const Other&) const { return {}; }

private:
  static std::vector<SomeIn> all(const Squares& squares, const std::optional<Classes>& classes) {
    std::vector<SomeIn> each;
    for (const MFraction& square : squares)
      each.push_back({{square}, classes});
    return each;
  }
};

// Each difference once; a finite union of classes rather than Q.
std::vector<SomeIn> said_by(const std::vector<Statement>& part) {
  std::vector<SomeIn> each;
  for (const Statement& c : part) {
    if (!c.holds) continue;
    for (SomeIn& one : std::visit(WhatItSays{}, c.says)) {
      const auto known =
          std::ranges::find_if(each, [&](const SomeIn& x) { return x.squares == one.squares; });
      if (known == each.end())
        each.push_back(std::move(one));
      else if (!known->classes)
        *known = std::move(one);
    }
  }
  return each;
}

// The smallest set with both.
SomeIn united(const SomeIn& a, const SomeIn& b) {
  if (!a.classes || !b.classes) return {a.squares};
  Classes both = *a.classes;
  both.insert(both.end(), b.classes->begin(), b.classes->end());
  return {a.squares, simplified(both)};
}

} // namespace

std::optional<SomeIn> necessary_condition(const std::vector<std::vector<Statement>>& parts) {
  if (parts.empty()) return std::nullopt;
  std::vector<SomeIn> common = said_by(parts.front());
  std::erase_if(common, [](const SomeIn& c) { return is_number(c.squares.front()); });
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const auto here = said_by(parts[i]);
    std::vector<SomeIn> both;
    for (const SomeIn& c : common)
      for (const SomeIn& x : here)
        if (x.squares == c.squares) both.push_back(united(c, x));
    common = std::move(both);
  }
  if (common.empty()) return std::nullopt;
  const auto discrete =
      std::ranges::find_if(common, [](const SomeIn& c) { return c.classes.has_value(); });
  if (discrete == common.end()) return common.front();
  if (discrete->classes->empty()) return std::nullopt; // no part has a point
  return *discrete;
}

} // namespace kov
