#pragma once
// The classical criteria, each told once, for numbers and for parameters.  An equation is given by the
// squares of its numbers; an Asker says what holds of them and is told the answers:
//
//   split(statement, yes, no)         calls yes() where it holds, and no() where it does not
//   known(statement)                  yes, no: wherever this is asked
//   root(square)                      the rational number >= 0 with this square, if it is one number
//   varies(square)                    it depends on parameters
//   add(group type, order, reason),
//   add(abelian, bound, reason)       the answer where this is called
//
// Source  [Kimura1969], [MartinetRamis1989] 3.3; docs/theory/kimura.md, confluent.md, strata.md 10

#include "closed/classical.hpp"
#include "closed/coefficients.hpp"
#include "closed/kimura.hpp"
#include "closed/parts.hpp"
#include "exact/lists.hpp"

#include <algorithm>
#include <array>

namespace kov::strata {

/// The order of y^k, y = z^((1+l)/2).
[[nodiscard]] inline Integer radical_order(const Rational& l) {
  return ((Rational(1) + l) * Rational(1, 2)).den();
}

/// y'' = (l^2-1)/(4 x^2) y.
template <class Asker> void euler_criterion(Asker& asker, const MFraction& square) {
  const auto l = asker.root(square);
  if (l && is_zero(*l))
    return asker.add(GroupType::T, Integer(2), "sqrt(z) and sqrt(z) log(z) are the solutions");
  asker.split(
      AllRational{{square}},
      [&] {
        asker.add(GroupType::cyclic, l ? std::optional(radical_order(*l)) : std::nullopt,
                  "two powers of z, with rational exponents, are the solutions");
      },
      [&] {
        asker.add(GroupType::Gm, {},
                  "two powers of z, with irrational exponents, are the solutions");
      });
}

/// Riemann's equation; always determined.
template <class Asker> class RiemannCriterion {
public:
  RiemannCriterion(Squares squares, Asker& asker) : s_(std::move(squares)), asker_(asker) {
    std::stable_partition(s_.begin(), s_.end(),
                          [&](const MFraction& x) { return asker.root(x).has_value(); });
    for (const MFraction& x : s_) {
      if (const auto root = asker.root(x))
        numbers_.push_back(*root);
      else if (asker.varies(x))
        open_.push_back(x);
    }
  }

  void run() {
    asker_.split(
        SumIn{s_, {odd_integers}}, [&] { reducible(); }, [&] { irreducible(); });
  }
  [[nodiscard]] const Squares& squares() const { return s_; }

private:
  // l and m rational: so is n, and the order of y^k is that of (1+l)/2, (1+m)/2
  // (strata.md 10.2).
  void reducible() {
    const auto rational = std::ranges::count_if(
        s_, [&](const MFraction& x) { return asker_.known(AllRational{{x}}) == Truth::yes; });
    if (numbers_.size() < 2 && rational >= 2)
      return diagonal_or_not(GroupType::cyclic, GroupType::T);
    if (numbers_.size() < 2)
      return asker_.split(
          AllRational{s_}, [&] { diagonal_or_not(GroupType::cyclic, GroupType::T); },
          [&] { diagonal_or_not(GroupType::Gm, GroupType::Borel); });
    diagonal_or_not(GroupType::cyclic, GroupType::T,
                    lcm(radical_order(numbers_[0]), radical_order(numbers_[1])));
  }
  void diagonal_or_not(GroupType diagonal, GroupType other, const std::optional<Integer>& n = {}) {
    asker_.split(
        WithoutLogarithm{s_},
        [&] {
          asker_.add(
              diagonal, n,
              "some l +- m +- n is an odd integer; all solutions are sums of two exponential ones");
        },
        [&] {
          asker_.add(other, n,
                     "some l +- m +- n is an odd integer; there is one exponential solution only");
        });
  }

  void irreducible() {
    const auto halves = static_cast<std::size_t>(
        std::ranges::count_if(numbers_, [](const Rational& x) { return x.den() == Integer(2); }));
    if (halves >= 2) return dihedral(halves);
    if (halves + open_.size() < 2) return row(0);
    asker_.split(
        SomeIn{open_, Classes{half_integers}, false, 2 - halves}, [&] { dihedral(halves); },
        [&] { row(0); });
  }

  // The third place, beside two in 1/2 + Z, is rational or not.
  void dihedral(std::size_t halves) {
    constexpr const char* rational =
        "two exponent differences are in 1/2 + Z, and the third is rational";
    constexpr const char* irrational =
        "two exponent differences are in 1/2 + Z, and the third is irrational";
    if (halves == 1 && open_.size() == 1) { // the open one is in 1/2 + Z
      if (numbers_.size() < 2) return asker_.add(GroupType::Dinf, {}, irrational);
      const bool first = numbers_[0].den() == Integer(2);
      return asker_.add(GroupType::D, numbers_[first ? 1 : 0].den(), rational);
    }
    std::optional<Integer> order;
    if (numbers_.size() == 3)
      order = std::max({numbers_[0].den(), numbers_[1].den(), numbers_[2].den()});
    asker_.split(
        AllRational{s_}, [&] { asker_.add(GroupType::D, order, rational); },
        [&] { asker_.add(GroupType::Dinf, {}, irrational); });
  }

  void row(std::size_t i) {
    static constexpr std::array types{GroupType::A4, GroupType::S4, GroupType::A5};
    if (i == types.size())
      return asker_.add(GroupType::SL2, {},
                        "no l +- m +- n is an odd integer and the exponent differences are in no "
                        "row of the tables of Schwarz and Kimura");
    const auto there = [&] {
      asker_.add(types[i], {},
                 "no l +- m +- n is an odd integer; the exponent differences are in a row of the "
                 "table of Schwarz");
    };
    const auto next = [&] { row(i + 1); };
    if (numbers_.size() < 2 || open_.size() != 1)
      return asker_.split(InRow{s_, types[i]}, there, next);
    const auto classes = thirds(types[i]);
    if (classes.empty()) return next();
    asker_.split(SumIn{{open_[0]}, classes}, there, next);
  }

  // The third exponents of the rows with the first two; they matter up to sign
  // and modulo 2.
  [[nodiscard]] std::vector<Residues> thirds(GroupType type) const {
    std::vector<Rational> found;
    for (long d = 2; d <= 5; ++d)
      for (long j = 1; j < d; ++j) {
        const Rational x(j, d);
        const SchwarzClass* c = schwarz_class({numbers_[0], numbers_[1], x});
        if (x.den() == Integer(d) && c != nullptr && c->group == type) found.push_back(x);
      }
    std::vector<Residues> classes;
    for (const Rational& x : found) {
      const Rational other = Rational(1) - x;
      const bool both = is_among(other, found);
      if (both && other < x) continue;
      classes.push_back({x, Rational(both ? 1 : 2)});
    }
    return classes;
  }

  Squares s_; ///< rational numbers first
  Asker& asker_;
  std::vector<Rational> numbers_;
  Squares open_; ///< those that depend on parameters
};

/// y'' = (b/x + (m^2-1)/(4x^2)) y, b != 0: order m in sqrt(x).
template <class Asker> void ramified_bessel_criterion(Asker& asker, const MFraction& m) {
  asker.split(
      SumIn{{m}, {half_integers}},
      [&] { asker.add(GroupType::Dinf, {}, "the order of Bessel's equation is in 1/2 + Z"); },
      [&] { asker.add(GroupType::SL2, {}, "the order of Bessel's equation is not in 1/2 + Z"); });
}

/// y'' = (1/4 - k/x + (m^2 - 1/4)/x^2) y; Bessel is k = 0.
/// Reducible <=> some +-k +- m is in 1/2 + N; diagonal <=> of k + m - 1/2 and k - m - 1/2 one is in
/// {0, 1, 2, ...} and the other in {-1, -2, ...}.
template <class Asker>
void whittaker_criterion(Asker& asker, const MFraction& k, const MFraction& m) {
  const auto gm = [&] {
    asker.add(GroupType::Gm, {},
              "of k + m - 1/2 and k - m - 1/2 one is a natural number and one a negative integer "
              "(Martinet and Ramis): both exponentials occur");
  };
  const auto sl2 = [&] { asker.add(GroupType::SL2, {}, "no k +- m is half of an odd integer"); };
  if (const auto zero = asker.root(k); zero && is_zero(*zero))
    return asker.split(SumIn{{m}, {half_integers}}, gm, sl2);
  const auto reducible = [&] {
    asker.split(Separated{{Rational(4) * m, Rational(4) * k}}, gm, [&] {
      asker.add(GroupType::Borel, {},
                "some k +- m is half of an odd integer, and k + m - 1/2, k - m - 1/2 are not a "
                "natural number and a negative integer (Martinet and Ramis)");
    });
  };
  asker.split(SumIn{{k, m}, {half_integers}}, reducible, sl2);
}

/// y'' = (u q(x)^2 + b x^(nu-1) + ...) y, q monic of degree nu = degree/2, e = b^2/u (Weber: a^2); of
/// odd degree e is not looked at.
template <class Asker> void polynomial_criterion(Asker& asker, long degree, const MFraction& e) {
  if (degree == 0)
    return asker.add(GroupType::Gm, {}, "two exponential functions are the solutions");
  if (degree == 1) return asker.add(GroupType::SL2, {}, words_of(Classical::airy).sl2);
  if (degree % 2 == 1)
    return asker.add(GroupType::SL2, {},
                     "r is a polynomial of odd degree: no exponential solution, and the identity "
                     "component is not abelian");
  const auto one = [&] {
    if (degree == 2)
      return asker.add(GroupType::Borel, {}, "a is an odd integer: one exponential solution");
    asker.add(Truth::no, GroupBound::SL2_or_Borel,
              "r is a polynomial, not constant: an invariant of degree 4 would have no poles and "
              "decrease at infinity");
  };
  asker.split(SumIn{{e}, {{Rational(degree / 2), Rational(2)}}}, one, [&] {
    asker.add(
        GroupType::SL2, {},
        degree == 2
            ? "a is not an odd integer"
            : "r is a polynomial, and the exponents at infinity leave no exponential solution");
  });
}

/// r = u q(x)^2 + b x^(nu-1) + ..., q monic of degree nu: b^2/u.  c ascending, of even degree.
/// Example exponent_squared(std::vector{a, a - a, one})  // -> a^2
template <class R> [[nodiscard]] R exponent_squared(const std::vector<R>& c) {
  const std::size_t nu = (c.size() - 1) / 2;
  const R& u = c.back();
  const R zero = u - u;
  std::vector<R> q(nu + 1, zero); // descending
  q[0] = u / u;
  const auto product = [&](std::size_t k) { // of q and q at x^(2 nu - k), without q_0 q_k
    R sum = zero;
    for (std::size_t i = 1; i < k; ++i)
      if (i <= nu && k - i <= nu) sum += q[i] * q[k - i];
    return sum;
  };
  for (std::size_t k = 1; k <= nu; ++k)
    q[k] = scaled(Rational(1, 2), c[2 * nu - k] / u - product(k));
  const R b = c[nu - 1] - u * product(nu + 1);
  return b * b / u;
}

} // namespace kov::strata
