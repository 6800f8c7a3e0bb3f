// The criteria of classical.hpp, from numbers that are known by their squares.

#include "certify/strata/classical.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

const Rational half(1, 2);

std::string text(const Fraction& f) {
  return "(" + to_string(f.num) + ")/(" + to_string(f.den) + ")";
}

// No letter for the root, which might be the name of a parameter.
std::string root_text(const SquaredNumber& x) { return "sqrt(" + text(x.square) + ")"; }

// By their numbers in the leaf: each root of a place has the difference of the place.
std::vector<std::size_t> three_differences(const ByClassical& leaf, std::size_t z = 0) {
  std::vector<std::size_t> three;
  for (std::size_t i = 0; i < leaf.numbers.size(); ++i)
    for (long k = i < leaf.factors.size() ? degree(leaf.factors[i], z) : 1; k > 0; --k)
      three.push_back(i);
  return three;
}

} // namespace

bool is_classical_rule(const std::string& name) {
  return name == "whittaker" || name == "bessel" || name == "riemann" || name == "lame";
}

std::string criterion(const ByClassical& leaf) {
  const auto& x = leaf.numbers;
  const std::string last = root_text(x.back());
  if (leaf.family == "lame") return last + " is an odd integer or the group is finite";
  if (leaf.family == "whittaker" && !is_zero(x[0].square.num)) {
    const std::string first = root_text(x[0]);
    return first + " + " + last + " - 1/2 and " + first + " - " + last +
           " - 1/2 are integers, one >= 0 and one < 0";
  }
  if (leaf.family != "riemann") return last + " + 1/2 is an integer";
  std::string squares;
  for (const std::size_t i : three_differences(leaf))
    squares += (squares.empty() ? "" : ", ") + text(x[i].square);
  return "two exponent differences are halves of odd integers, or they are in the table of Schwarz "
         "and Kimura, or a sum of the three with signs is an odd integer and (all are rational, or "
         "one is an integer and there is no logarithm); their squares: " +
         squares;
}

Fraction shifted(const Fraction& f, const Rational& c, Arithmetic& a) {
  return {a.plus(scaled(f.num, c.den()), scaled(f.den, c.num())), scaled(f.den, c.den())};
}

namespace {

// A number of the leaf: a root that is a function, or known to be irrational everywhere.
struct LeafRoot {
  std::optional<Fraction> root;
  std::optional<Rational> constant; ///< the root, if it is one
  bool irrational = false;

  explicit LeafRoot(const SquaredNumber& x) : root(x.root) {
    const auto square = constant_value(x.square);
    if (square) {
      if (kov::sign(*square) >= 0) constant = exact_sqrt(*square);
      irrational = !constant;
    }
    if (!constant) return;
    const MPoly one(x.square.den.ring(), Integer(1));
    root = Fraction{scaled(one, constant->num()), scaled(one, constant->den())};
  }
};

class Criterion {
public:
  Criterion(const ByClassical& leaf, const ParameterFacts& facts, Arithmetic& a)
      : leaf_(leaf), facts_(facts), a_(a) {
    for (const SquaredNumber& x : leaf.numbers)
      numbers_.emplace_back(x);
  }

  Truth operator()() {
    if (leaf_.family == "bessel") return in_halves(numbers_[0]);
    if (leaf_.family == "whittaker") return whittaker(numbers_[0], numbers_[1]);
    if (leaf_.family == "lame") return lame(numbers_.back());
    return riemann();
  }

private:
  Truth integral(const Fraction& f) const {
    if (const auto c = constant_value(f)) return truth(is_integer(*c));
    return facts_.integral(f);
  }
  // x + shift
  Truth integral(const LeafRoot& x, const Rational& shift) const {
    if (x.irrational) return Truth::no;
    return x.root ? integral(shifted(*x.root, shift, a_)) : Truth::unknown;
  }
  Truth in_halves(const LeafRoot& x) const { return integral(x, -half); }
  // c x
  Truth multiple(const LeafRoot& x, const Rational& c) const {
    if (x.irrational) return Truth::no;
    return x.root ? integral(times(c, *x.root)) : Truth::unknown;
  }
  static Fraction times(const Rational& c, const Fraction& f) {
    return {scaled(f.num, c.num()), scaled(f.den, c.den())};
  }

  // P = k + m - 1/2, Q = k - m - 1/2: 2m = P - Q and 2k = P + Q + 1 are integers if P and Q are.
  Truth whittaker(const LeafRoot& k, const LeafRoot& m) const {
    if (is_zero(leaf_.numbers[0].square.num)) return in_halves(m);
    for (const LeafRoot* x : {&k, &m})
      if (multiple(*x, Rational(2)) == Truth::no) return Truth::no;
    if (!k.root || !m.root) return Truth::unknown;
    const Fraction P = shifted(combined(*k.root, Rational(1), *m.root, a_), -half, a_);
    const Fraction Q = shifted(combined(*k.root, Rational(-1), *m.root, a_), -half, a_);
    if (integral(P) == Truth::no || integral(Q) == Truth::no) return Truth::no;
    const Truth p = natural(P);
    const Truth q = p != Truth::unknown ? natural(Q) : Truth::unknown;
    return q != Truth::unknown ? truth(p != q) : Truth::unknown;
  }
  // Is the integer f >= 0, that is > -1, or < 0?  Unknown: not known, or f may be none.
  Truth natural(const Fraction& f) const {
    if (integral(f) != Truth::yes) return Truth::unknown;
    if (const auto c = constant_value(f)) return truth(sign(*c) >= 0);
    if (!is_constant(f.den)) return Truth::unknown;
    const Integer side(sign(f.den.coefficient(0)));
    if (positive(shifted({scaled(f.num, side), scaled(f.den, side)}, Rational(1), a_).num))
      return Truth::yes;
    return positive(scaled(f.num, -side)) ? Truth::no : Truth::unknown;
  }
  bool positive(const MPoly& p) const { return !is_zero(p) && facts_.positive(p); }

  // x = 2n + 1; a finite group has x in 2Z, (2/3)Z, (1/2)Z or (2/5)Z.
  Truth lame(const LeafRoot& x) const {
    if (!x.irrational && x.root &&
        integral(times(half, shifted(*x.root, Rational(-1), a_))) == Truth::yes)
      return Truth::yes;
    if (multiple(x, Rational(30)) == Truth::no) return Truth::no;
    if (!x.constant) return Truth::unknown;
    for (const Rational& c : {Rational(1), Rational(3, 2), Rational(2), Rational(5, 2)})
      if (is_integer(c * *x.constant)) return Truth::unknown;
    return Truth::no;
  }

  Truth riemann() const {
    std::vector<const LeafRoot*> three;
    for (const std::size_t i : three_differences(leaf_, facts_.z))
      three.push_back(&numbers_[i]);
    const auto count = [&](const auto& property) {
      return std::ranges::count_if(three, [&](const LeafRoot* x) { return property(*x); });
    };
    if (count([&](const LeafRoot& x) { return in_halves(x) == Truth::yes; }) >= 2)
      return Truth::yes;
    for (std::size_t i = 0; i < three.size(); ++i)
      if (trivial(three, i)) return Truth::yes;
    const Truth reducible = odd_sum(three);
    if (reducible == Truth::yes && count([&](const LeafRoot& x) { return rational(x); }) >= 2)
      return Truth::yes;
    const bool dihedral = count([&](const LeafRoot& x) { return in_halves(x) != Truth::no; }) >= 2;
    const bool polyhedral = count([&](const LeafRoot& x) { return in_no_row(x); }) == 0;
    return reducible == Truth::no && !dihedral && !polyhedral ? Truth::no : Truth::unknown;
  }
  // The difference at place i is a natural number N, and the sum or the difference of the other two
  // is one of N-1, N-3, ..., 1-N: the local monodromy is 1 or -1.
  [[nodiscard]] bool trivial(const std::vector<const LeafRoot*>& x, std::size_t i) const {
    const auto& n = x[i]->constant;
    const LeafRoot& l = *x[(i + 1) % 3];
    const LeafRoot& m = *x[(i + 2) % 3];
    if (!n || !is_integer(*n) || !l.root || !m.root) return false;
    for (const long s : {1L, -1L}) {
      const auto c = constant_value(combined(*l.root, Rational(s), *m.root, a_));
      if (c && abs(*c) < *n && is_integer(half * (*n - Rational(1) - *c))) return true;
    }
    return false;
  }
  Truth odd_sum(const std::vector<const LeafRoot*>& x) const {
    if (!std::ranges::all_of(x, [](const LeafRoot* one) { return one->root.has_value(); }))
      return Truth::unknown;
    bool never = true;
    for (const long s : {1L, -1L})
      for (const long t : {1L, -1L}) {
        const Fraction two = combined(*x[0]->root, Rational(s), *x[1]->root, a_);
        const Fraction sum = combined(two, Rational(t), *x[2]->root, a_);
        const Truth odd = integral(times(half, shifted(sum, Rational(-1), a_)));
        if (odd == Truth::yes) return odd;
        never = never && odd == Truth::no;
      }
    return never ? Truth::no : Truth::unknown;
  }
  [[nodiscard]] bool rational(const LeafRoot& x) const {
    return x.root && facts_.is_rational(x.root->num) && facts_.is_rational(x.root->den);
  }
  // A row has no integers, and denominators up to 5 only.
  [[nodiscard]] bool in_no_row(const LeafRoot& x) const {
    if (x.irrational || integral(x, Rational(0)) == Truth::yes) return true;
    return multiple(x, Rational(60)) == Truth::no;
  }

  const ByClassical& leaf_;
  const ParameterFacts& facts_;
  Arithmetic& a_;
  std::vector<LeafRoot> numbers_;
};

} // namespace

Truth criterion_holds(const ByClassical& leaf, const ParameterFacts& facts, Arithmetic& a) {
  return Criterion(leaf, facts, a)();
}

std::optional<OneDifference> one_difference(const ByClassical& leaf, Arithmetic& a) {
  if (leaf.family != "riemann") return std::nullopt;
  OneDifference d;
  for (const std::size_t i : three_differences(leaf)) {
    const Fraction& square = leaf.numbers[i].square;
    const LeafRoot x(leaf.numbers[i]);
    if (x.irrational) return std::nullopt;
    if (x.constant) {
      d.known.push_back(*x.constant);
      continue;
    }
    if (d.times++ == 0) d.square = square;
    if (a.times(square.num, d.square.den) != a.times(d.square.num, square.den)) return std::nullopt;
  }
  return d.times > 0 ? std::optional(std::move(d)) : std::nullopt;
}

} // namespace kov::certify
