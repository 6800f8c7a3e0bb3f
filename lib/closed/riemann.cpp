#include "closed/riemann.hpp"

#include "closed/half.hpp"
#include "closed/kimura.hpp"
#include "exact/error.hpp"
#include "exact/factor.hpp"

#include <algorithm>

namespace kov {
namespace {

// The roots in Q of f over K, with multiplicity: common roots of the coordinates of f in a basis of
// K, so that nothing is factored over K.
std::vector<Rational> rational_roots(const Poly& f) {
  Poly common(0);
  for (long j = 0; j < f.field()->degree(); ++j) {
    std::vector<NfElem> coordinate;
    for (long i = 0; i <= degree(f); ++i)
      coordinate.emplace_back(f.coeff(i).coeff(j));
    common = gcd(common, Poly::from_coefficients(coordinate));
  }
  std::vector<Rational> roots;
  for (const Factor& factor : irreducible_factors(common))
    if (degree(factor.base) == 1)
      for (long i = 0; i < factor.exponent; ++i)
        roots.push_back(to_rational(-factor.base.coeff(0)));
  return roots;
}

// The natural numbers s with f(s^2) = 0.
std::vector<Integer> natural_roots(const Poly& f) {
  std::vector<Integer> roots;
  for (const Rational& root : rational_roots(f))
    if (const auto s = exact_sqrt(root); s && is_integer(*s)) roots.push_back(s->num());
  std::ranges::sort(roots);
  return roots;
}

std::optional<Rational> rational_exponent(const NfElem& square) {
  return is_rational(square) ? exact_sqrt(to_rational(square)) : std::nullopt;
}

bool is_known_half_integer(const std::optional<Rational>& q) { return q && q->den() == Integer(2); }

bool contains_up_to(const std::vector<Integer>& sums, const Integer& n) {
  // |s| <= N - 1 and s = N - 1 modulo 2: one of N-1, N-3, ..., -(N-1)
  return std::ranges::any_of(sums, [&](const Integer& s) {
    return s < n && is_integer(Rational(n - Integer(1) - s, Integer(2)));
  });
}

class Riemann {
public:
  explicit Riemann(const Poly& squares)
      : e1_(-squares.coeff(2)), e2_(squares.coeff(1)), e3_(-squares.coeff(0)) {
    for (const Rational& square : rational_roots(squares)) // the others are irrational
      exponents_.push_back(exact_sqrt(square));
    exponents_.resize(3);
  }
  explicit Riemann(const SquaredExponents& s)
      : e1_(s[0] + s[1] + s[2]), e2_(s[0] * s[1] + s[0] * s[2] + s[1] * s[2]),
        e3_(s[0] * s[1] * s[2]), exponents_{rational_exponent(s[0]), rational_exponent(s[1]),
                                            rational_exponent(s[2])} {}

  ClosedAnswer answer() const {
    if (const auto odd = odd_relation())
      return reducible("l +- m +- n = " + to_string(*odd) + " is an odd integer");
    if (std::ranges::count_if(exponents_, is_known_half_integer) >= 2) return dihedral();
    if (all_rational())
      if (const SchwarzClass* row = schwarz_class({*exponents_[0], *exponents_[1], *exponents_[2]}))
        return ClosedAnswer::of({row->group, {}},
                                "no l +- m +- n is an odd integer; the exponent differences are in "
                                "the row (" +
                                    to_string(row->exponents[0]) + ", " +
                                    to_string(row->exponents[1]) + ", " +
                                    to_string(row->exponents[2]) + ") of the table of Schwarz");
    return ClosedAnswer::of({GroupType::SL2, {}},
                            "no l +- m +- n is an odd integer and the exponent differences are in "
                            "no row of the tables of Schwarz and Kimura");
  }

private:
  [[nodiscard]] bool all_rational() const {
    return std::ranges::all_of(exponents_, [](const auto& e) { return !!e; });
  }

  // Sums of rational numbers need no factorisation.
  [[nodiscard]] std::optional<Integer> odd_relation() const {
    if (!all_rational()) {
      const auto odd = odd_relations(e1_, e2_, e3_);
      return odd.empty() ? std::nullopt : std::optional(odd.front());
    }
    for (const Rational& sum : sums(*exponents_[0], *exponents_[1]))
      for (const Rational& k : sums(sum, *exponents_[2]))
        if (is_integer(k) && !is_integer(k * half)) return k.num();
    return std::nullopt;
  }
  [[nodiscard]] static std::array<Rational, 2> sums(const Rational& a, const Rational& b) {
    return {abs(a + b), abs(a - b)};
  }

  // Is the local monodromy at place i plus or minus 1?  The exponent difference is N >= 1 and there
  // is no logarithm: one of m + n, m - n is among N-1, N-3, ..., -(N-1).
  [[nodiscard]] bool is_trivial(std::size_t i) const {
    const auto& n = exponents_[i];
    if (!n || !is_integer(*n) || is_zero(*n)) return false;
    if (!all_rational()) {
      const NfElem a(*n * *n);
      return contains_up_to(integer_sums(e1_ - a, e3_ / a), n->num());
    }
    std::vector<Integer> integers;
    for (const Rational& s : sums(*exponents_[(i + 1) % 3], *exponents_[(i + 2) % 3]))
      if (is_integer(s)) integers.push_back(s.num());
    return contains_up_to(integers, n->num());
  }
  [[nodiscard]] bool has_logarithm(std::size_t i) const {
    return exponents_[i] && is_integer(*exponents_[i]) && !is_trivial(i);
  }

  // A reducible group is diagonal exactly when one place is trivial and no place has a logarithm.
  [[nodiscard]] ClosedAnswer reducible(std::string reason) const {
    bool diagonal = is_trivial(0) || is_trivial(1) || is_trivial(2);
    for (std::size_t i = 0; i < 3; ++i)
      diagonal = diagonal && !has_logarithm(i);
    reason += diagonal ? "; all solutions are sums of two exponential ones"
                       : "; there is one exponential solution only";
    if (!all_rational())
      return ClosedAnswer::of({diagonal ? GroupType::Gm : GroupType::Borel, {}},
                              reason + "; an exponent difference is irrational");
    Integer m(1);
    for (const auto& e : exponents_)
      m = lcm(m, ((Rational(1) + *e) * half).den());
    return ClosedAnswer::of({diagonal ? GroupType::cyclic : GroupType::T, m},
                            reason + "; its radical order is " + to_string(m));
  }

  // The third place rotates by its exponent difference.
  [[nodiscard]] ClosedAnswer dihedral() const {
    std::vector<std::optional<Rational>> rest = exponents_;
    for (int i = 0; i < 2; ++i)
      rest.erase(std::ranges::find_if(rest, is_known_half_integer));
    const std::string reason = "two exponent differences are in 1/2 + Z, and the third is ";
    if (!rest.front()) return ClosedAnswer::of({GroupType::Dinf, {}}, reason + "irrational");
    return ClosedAnswer::of({GroupType::D, rest.front()->den()}, reason + to_string(*rest.front()));
  }

  NfElem e1_, e2_, e3_;
  std::vector<std::optional<Rational>> exponents_; ///< unset: irrational
};

} // namespace

// The product of (sqrt T +- l +- m +- n) over all signs is
// (sum x_i^2 - 2 sum x_i x_j)^2 - 64 T l^2 m^2 n^2 in x = (T, l^2, m^2, n^2).
std::vector<Integer> odd_relations(const NfElem& e1, const NfElem& e2, const NfElem& e3) {
  const Poly t = Poly::z();
  const Poly sum = t + Poly(e1);
  const Poly pairs = scale(t, e1) + Poly(e2);
  const Poly inner = sum * sum - scale(pairs, NfElem(4));
  std::vector<Integer> odd;
  for (const Integer& k : natural_roots(inner * inner - scale(t, NfElem(64) * e3)))
    if (!is_integer(Rational(k, Integer(2)))) odd.push_back(k);
  return odd;
}

std::vector<Integer> integer_sums(const NfElem& sum, const NfElem& product) {
  const Poly t = Poly::z();
  const NfElem difference_squared = sum * sum - NfElem(4) * product; // (l^2 - m^2)^2
  return natural_roots(t * t - scale(t, NfElem(2) * sum) + Poly(difference_squared));
}

RationalFunction riemann_equation(const SquaredExponents& s) {
  const Poly z = Poly::z();
  const Poly one(1);
  const auto quarter = [](const NfElem& c) { return Poly(c / NfElem(4)); };
  const Poly w = z - one;
  const Poly num = quarter(s[0] - NfElem(1)) * w * w + quarter(s[1] - NfElem(1)) * z * z +
                   quarter(NfElem(1) - s[0] - s[1] + s[2]) * z * w;
  return {num, z * z * w * w};
}

ClosedAnswer riemann_answer(const Poly& squares) { return Riemann(squares).answer(); }

ClosedAnswer riemann_answer(const SquaredExponents& s) { return Riemann(s).answer(); }

// y = z^((1 +- l)/2).
ClosedAnswer euler_answer(const NfElem& square) {
  const auto l = rational_exponent(square);
  if (!l)
    return ClosedAnswer::of({GroupType::Gm, {}},
                            "two powers of z, with irrational exponents, are the solutions");
  const Integer m = ((Rational(1) + *l) * half).den();
  if (is_zero(*l))
    return ClosedAnswer::of({GroupType::T, m}, "sqrt(z) and sqrt(z) log(z) are the solutions");
  return ClosedAnswer::of({GroupType::cyclic, m},
                          "two powers of z, with rational exponents, are the solutions");
}

} // namespace kov
