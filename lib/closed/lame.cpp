#include "closed/lame.hpp"

#include "closed/coefficients.hpp"
#include "closed/half.hpp"
#include "closed/number_answers.hpp"
#include "exact/error.hpp"
#include "exact/ideal.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"

#include <algorithm>

namespace kov {
namespace {

NfElem discriminant(const LameParameters<NfElem>& p) {
  return p.g2 * p.g2 * p.g2 - NfElem(27) * p.g3 * p.g3;
}
MFraction discriminant(const LameParameters<MFraction>& p) {
  return p.g2 * p.g2 * p.g2 - Rational(27) * (p.g3 * p.g3);
}

LameIndex classified(const Rational& n) {
  const Integer b = (n + half).den();
  LameIndex index{LameCase::other, n};
  if (b == Integer(1)) index.kind = LameCase::brioschi;
  if (b == Integer(2)) index.kind = LameCase::hermite;
  if (b > Integer(2) && b < Integer(6)) index.kind = LameCase::polyhedral;
  return index;
}

// A rotation of order 5 is in A5 only and one of order 4 in S4 only; in A4 the product of the three
// involutions at e1, e2, e3 has order <= 2, so that A4 does not occur.
bool octahedral_possible(const Rational& n) { return (n + half).den() != Integer(5); }
bool icosahedral_possible(const Rational& n) { return (n + half).den() != Integer(4); }

void check_size(const Rational& n, const Budget& budget) {
  const Rational degree = n * Rational(6);
  if (!fits_long(ceil(degree)))
    throw OutOfBudget("n = " + to_string(n) + " is too large for an explicit condition");
  budget.check_degree(to_long(ceil(degree)));
}

template <class R> bool all_zero(const std::vector<R>& conditions) {
  return std::ranges::all_of(conditions, [](const R& c) { return is_zero(c); });
}

// Primitive, with a positive leading coefficient.
MPoly primitive(const MPoly& f) {
  if (is_zero(f)) return f;
  MPoly product(f.ring(), Integer(1));
  for (const MFactor& factor : factor(f).second)
    product *= pow(factor.base, static_cast<unsigned long>(factor.exponent));
  return product;
}

// The same common zeros with fewer polynomials: multiples of others are left out.
std::vector<MPoly> without_multiples(const std::vector<MFraction>& conditions) {
  std::vector<MPoly> all;
  for (const MFraction& c : conditions)
    if (!is_zero(c)) all.push_back(primitive(c.num()));
  std::ranges::stable_sort(all,
                           [](const MPoly& a, const MPoly& b) { return a.length() < b.length(); });
  std::vector<MPoly> kept;
  for (const MPoly& f : all)
    if (std::ranges::none_of(kept, [&](const MPoly& g) { return !!divides(g, f); }))
      kept.push_back(f);
  return kept;
}

// The ideal off the discriminant, where that is quick (small weights; a Groebner basis has no
// useful bound on its cost).
std::vector<MPoly> simplified(const std::vector<MFraction>& conditions, const MPoly& discriminant,
                              const Rational& n, const Budget& budget) {
  std::vector<MPoly> kept = without_multiples(conditions);
  std::vector<std::size_t> used = used_by_any(kept);
  std::ranges::sort(used);
  const bool small = std::ranges::all_of(kept, [](const MPoly& f) { return f.length() <= 12; });
  if (n > half || kept.size() < 2 || used.size() > 3 || !(small || used.size() == 1)) return kept;
  const Ideal ideal(discriminant.ring(), used, kept, {discriminant}, budget);
  if (ideal.is_unit()) return {MPoly(discriminant.ring(), Integer(1))};
  std::vector<MFraction> basis;
  for (const KPoly& g : ideal.basis())
    basis.insert(basis.begin(), ideal.from_kpoly(g)); // the first variable first
  return without_multiples(basis);
}

// --- numbers ---------------------------------------------------------------------------------

ClosedAnswer hermite_answer(const Rational& n, const LameParameters<NfElem>& p) {
  const NfElem w_squared = lame_hermite(to_long(n.num()), p).w_squared;
  const std::string name = "n = " + to_string(n) + " is an integer";
  if (is_zero(w_squared))
    return ClosedAnswer::of({GroupType::T, Integer(4)},
                            name + " and w^2 = 0: one solution is a Lame function");
  return {std::nullopt, Truth::yes,
          name + " and w^2 is not 0: the group is dihedral, finite or infinite"};
}

ClosedAnswer brioschi_answer(const Rational& n, const LameParameters<NfElem>& p) {
  const long m = to_long((n + half).num());
  const std::string name = "n = " + to_string(n);
  if (m == 0)
    return ClosedAnswer::of({GroupType::SL2, {}}, name + ": there is a logarithm at infinity");
  const std::string q = "Brioschi's determinant Q_" + std::to_string(m);
  if (is_zero(brioschi(m, p)))
    return ClosedAnswer::of({GroupType::D, Integer(2)}, name + " and " + q + " = 0");
  return ClosedAnswer::of({GroupType::SL2, {}}, name + " and " + q + " is not 0");
}

ClosedAnswer polyhedral_answer(const Rational& n, const LameParameters<NfElem>& p,
                               const Budget& budget) {
  const std::string name = "n = " + to_string(n);
  if (octahedral_possible(n) && all_zero(invariant_conditions(n, 8, p, budget)))
    return ClosedAnswer::of({GroupType::S4, {}}, name + " and there is an invariant of degree 8");
  if (icosahedral_possible(n) && all_zero(invariant_conditions(n, 12, p, budget)))
    return ClosedAnswer::of({GroupType::A5, {}}, name + " and there is an invariant of degree 12");
  return ClosedAnswer::of({GroupType::SL2, {}}, name + " and there are no invariants");
}

ClosedAnswer degenerate_answer(const NfElem& alpha, const LameParameters<NfElem>& p) {
  const NfElem square = NfElem(1) + NfElem(4) * alpha; // (2n+1)^2
  if (is_zero(p.g2)) {                                 // f = 4x^3: y_tt = (alpha/t^2 + B) y
    ClosedAnswer a = is_zero(p.b) ? euler_answer(square / NfElem(4))
                                  : ramified_bessel_answer(square / NfElem(4));
    a.reason = "g2 = g3 = 0: y_tt = (n(n+1)/t^2 + B) y; " + a.reason;
    return a;
  }
  ClosedAnswer a = riemann_answer(SquaredExponents{degenerate_exponent_squared(alpha, p),
                                                   NfElem(Rational(1, 4)), square / NfElem(4)});
  a.reason = "g2^3 = 27 g3^2: Riemann's equation; " + a.reason;
  return a;
}

} // namespace

LameIndex lame_index(const Rational& n) { return classified(n < -half ? Rational(-1) - n : n); }

LameIndex lame_index(const NfElem& alpha) {
  const NfElem square = NfElem(1) + NfElem(4) * alpha;
  if (!is_rational(square)) return {};
  const auto root = exact_sqrt(to_rational(square));
  return root ? classified((*root - Rational(1)) * half) : LameIndex{};
}

RationalFunction lame_equation(const NfElem& alpha, const LameParameters<NfElem>& p) {
  const Poly x = Poly::z();
  const Poly f = scale(x * x * x, NfElem(4)) - scale(x, p.g2) - Poly(p.g3);
  const RationalFunction half_log(scale(derivative(f), NfElem(half)), f); // f'/(2f)
  return derivative(half_log) * RationalFunction(half) +
         half_log * half_log * RationalFunction(Rational(1, 4)) +
         RationalFunction(scale(x, alpha) + Poly(p.b), f);
}

ClosedAnswer lame_answer(const NfElem& alpha, const LameParameters<NfElem>& p,
                         const Budget& budget) {
  if (is_zero(discriminant(p))) return degenerate_answer(alpha, p);
  const LameIndex index = lame_index(alpha);
  if (index.kind != LameCase::other) check_size(*index.n, budget);
  switch (index.kind) {
  case LameCase::hermite:
    return hermite_answer(*index.n, p);
  case LameCase::brioschi:
    return brioschi_answer(*index.n, p);
  case LameCase::polyhedral:
    return polyhedral_answer(*index.n, p, budget);
  case LameCase::other:
    break;
  }
  if (!index.n) return ClosedAnswer::of({GroupType::SL2, {}}, "n is irrational");
  return ClosedAnswer::of({GroupType::SL2, {}},
                          "n = " + to_string(*index.n) + " and n + 1/2 has a denominator > 5");
}

bool LameConditions::never() const {
  return std::ranges::any_of(abelian, [](const MPoly& f) { return is_constant(f) && !is_zero(f); });
}

LameConditions lame_conditions(const LameIndex& index, const LameParameters<MFraction>& p,
                               const Budget& budget) {
  LameConditions c;
  c.index = index;
  c.discriminant = discriminant(p).num();
  Ring ring;
  for (const MFraction* f : {&p.b, &p.g2, &p.g3})
    if (f->ring()) ring = f->ring();
  if (!ring) throw InvalidArgument("the parameters of Lame's equation belong to no ring");
  if (is_zero(c.discriminant)) c.discriminant = MPoly(ring);
  const std::vector<MPoly> never{MPoly(ring, Integer(1))};
  if (index.kind != LameCase::other) check_size(*index.n, budget);
  switch (index.kind) {
  case LameCase::hermite:
    if (*index.n <= Rational(max_lame_degree))
      c.reducible = primitive(lame_hermite(to_long(index.n->num()), p).w_squared.num());
    return c;
  case LameCase::brioschi: {
    const long m = to_long((*index.n + half).num());
    c.abelian = m == 0 ? never : without_multiples({brioschi(m, p)});
    return c;
  }
  case LameCase::polyhedral: {
    const Rational& n = *index.n;
    const auto conditions = [&](long m) {
      return simplified(invariant_conditions(n, m, p, budget), c.discriminant, n, budget);
    };
    c.octahedral = octahedral_possible(n) ? conditions(8) : never;
    c.abelian = icosahedral_possible(n) ? conditions(12) : c.octahedral;
    return c;
  }
  case LameCase::other:
    c.abelian = never;
  }
  return c;
}

// With u = x - a: f = 12 a u^2 (1 + u/(3a)), so that s^2 = (alpha a + B)/(12 a) at u = 0, and the
// exponents s, -s differ by 2s; 3a = -9 g3/(2 g2).
template <class R> R degenerate_exponent_squared(const R& alpha, const LameParameters<R>& p) {
  if (is_zero(p.g3)) throw InvalidArgument("g3 = 0 on the degenerate curve: f = 4x^3");
  return scaled(Rational(1, 3), alpha) - scaled(Rational(2, 9), p.b * p.g2) / p.g3;
}

template NfElem degenerate_exponent_squared(const NfElem&, const LameParameters<NfElem>&);
template MFraction degenerate_exponent_squared(const MFraction&, const LameParameters<MFraction>&);

ThirdExponents degenerate_exponents(const LameIndex& index) {
  if (index.n) return abelian_third_exponents(half, *index.n + half);
  // One irrational exponent: reducible ones have the full Borel group, dihedral ones remain.
  return {false, {{half_integers, {nullptr, true}}}};
}

bool contains_root(const ThirdExponents& l, const Rational& square) {
  if (l.all) return true;
  const auto root = exact_sqrt(square);
  return root && contains(l.nu(), *root);
}

std::vector<LameFamily> lame_families() {
  return {{1, 1, "j odd (n an integer): always"},
          {1, 1, "j even, j >= 2 (n half of an odd integer): Brioschi's determinant Q_(j/2) = 0"},
          {2, 3, "3 does not divide j: a finite group, S4 or A5"},
          {1, 2, "j odd: a finite group, S4"},
          {2, 5, "5 does not divide j: a finite group, A5"}};
}

} // namespace kov
