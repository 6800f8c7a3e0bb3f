// Changes of variable z -> c z + d and z -> (a z + b)/(c z + d), over Q and over number fields:
// the group of the moved equation is that of the equation, and the judge accepts its certificate.

#include "certify/equation/check.hpp"
#include "corpus.hpp"
#include "support/equations.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using test::Random;
using namespace testing;

// Random numbers, polynomials and maps over a field.
struct Source {
  Random& random;
  Field field;

  [[nodiscard]] Rational rational(long size, long denominator = 1) {
    return {random.between(-size, size), random.between(1, denominator)};
  }
  [[nodiscard]] Rational unit(long size, long denominator = 1) {
    const Rational q = rational(size, denominator);
    return sign(q) == 0 ? Rational(1) : q;
  }
  [[nodiscard]] NfElem element(long size, long denominator = 1) {
    NfElem c(rational(size, denominator), field);
    if (!field->is_rational() && random.once_in(2))
      c += NfElem(rational(size, denominator)) * NfElem::generator(field);
    return c;
  }
  [[nodiscard]] NfElem element_unit(long size, long denominator = 1) {
    NfElem c = element(size, denominator);
    return is_zero(c) ? NfElem(1) : c;
  }
  [[nodiscard]] Poly line(long size, long denominator = 1) {
    return Poly::z() - Poly(element(size, denominator));
  }
  [[nodiscard]] Poly polynomial(long degree) {
    std::vector<NfElem> c;
    for (long i = 0; i < degree; ++i)
      c.push_back(element(6));
    c.emplace_back(1);
    return Poly::from_coefficients(c);
  }
  [[nodiscard]] Poly squarefree(long degree) {
    for (;;)
      if (Poly f = polynomial(degree); kov::degree(gcd(f, derivative(f))) == 0) return f;
  }
  /// By which every small prime, a square or a long number is lost.
  [[nodiscard]] Rational scale() {
    static const std::vector<Rational> scales{Rational(9699690),
                                              Rational(1, 9699690),
                                              Rational(44100),
                                              Rational(1, 1048576),
                                              Rational(1000000000000000003),
                                              Rational(Integer(7), pow(Integer(10), 24))};
    return random.one_of(scales);
  }
  [[nodiscard]] RationalFunction map(bool affine) {
    for (;;) {
      const NfElem a = element(30, 12) * NfElem(random.once_in(4) ? scale() : Rational(1));
      const NfElem b = element(30, 12);
      const NfElem c = affine ? NfElem(0) : element(30, 12);
      const NfElem d = affine ? NfElem(1) : element(30, 12);
      if (!is_zero(a * d - b * c))
        return {Poly::from_coefficients({b, a}), Poly::from_coefficients({d, c})};
    }
  }
};

NfElem square(const Rational& q) { return NfElem(q * q); }

// --- equations of every group --------------------------------------------------------------------

RationalFunction odd_polynomial(Source& s) { return RationalFunction(s.polynomial(3)); }

RationalFunction weber(Source& s) { // SL(2) or Borel
  return RationalFunction(Poly::z() * Poly::z() + Poly(s.rational(6)));
}

RationalFunction with_logarithms(Source& s) {
  return RationalFunction(s.polynomial(2), s.squarefree(3));
}

RationalFunction some_riemann(Source& s) {
  return riemann(square(s.rational(7, 6)), square(s.rational(7, 6)), square(s.rational(7, 6)));
}

RationalFunction one_line(Source& s) { // Borel, additive or diagonal
  RationalFunction omega;
  for (int i = 0; i < 2; ++i)
    omega += RationalFunction(Poly(s.rational(5, 6)), s.line(5));
  if (s.random.once_in(2)) omega += RationalFunction(Poly(s.element_unit(3)));
  return from_omega(omega);
}

RationalFunction two_lines(Source& s) { // diagonal
  const Poly v = s.squarefree(2);
  return from_square(RationalFunction(v * v), s.element_unit(6, 5));
}

RationalFunction euler(Source& s) { // cyclic or additive
  const Rational delta = s.rational(12, 8);
  return {Poly((delta * delta - Rational(1)) * Rational(1, 4)), pow(s.line(5), 2)};
}

RationalFunction primitive(Source& s) {
  const Rational half(1, 2);
  const Rational third(1, 3);
  using Triple = std::array<Rational, 3>;
  const std::vector<Triple> known{{half, third, third},
                                  {half, third, Rational(1, 4)},
                                  {half, third, Rational(1, 5)},
                                  {half, Rational(2, 5), third},
                                  {third + third, third, Rational(1, 5)}};
  Triple delta = s.random.one_of(known);
  for (Rational& d : delta)
    d += Rational(2 * s.random.between(0, 1));
  return riemann(square(delta[0]), square(delta[1]), square(delta[2]));
}

RationalFunction dihedral(Source& s) {
  const NfElem quarter(Rational(1, 4));
  return riemann(quarter, quarter, square(s.unit(9, 7)));
}

// Branched over the preimages of two points: genus 0 to 2.
RationalFunction dihedral_on_a_curve(Source& s) {
  return pull_back(dihedral(s), RationalFunction(s.polynomial(s.random.between(2, 3))));
}

RationalFunction irregular_dihedral(Source& s) {
  return from_square(RationalFunction(s.squarefree(s.random.between(1, 2))), s.element_unit(5, 3));
}

RationalFunction without_poles(Source& s) { // of w dz/v: infinite dihedral
  return from_square(RationalFunction(s.squarefree(s.random.between(3, 5))), s.element_unit(30));
}

// w dz/v has residues rho and -rho at the two points over a.
RationalFunction two_points(Source& s) {
  for (;;) {
    const Poly f = s.squarefree(s.random.between(3, 4));
    const NfElem a = s.element(6, 3);
    const Poly line = Poly::z() - Poly(a);
    const NfElem there = evaluate(f, a);
    if (!is_zero(there))
      return from_square(RationalFunction(line * line * f), there * square(s.unit(3, 4)));
  }
}

RationalFunction lame_one(Source& s) { // n = 1: infinite dihedral, or additive
  for (;;) {
    const NfElem g2 = s.element(30);
    const NfElem g3 = s.element(30);
    if (!is_zero(pow(g2, 3) - NfElem(27) * g3 * g3))
      return lame(NfElem(2), s.element(12, 2), g2, g3);
  }
}

// u^n = h = (s + l)/(s - l) on s^2 = l^2 + c t^N, t = z - a: the zeros of h are a divisor of order N,
// and dh/h = (2 t l' - N l) dz/(t s).
RationalFunction torsion_points(Source& s) {
  for (;;) {
    const long N = s.random.between(3, 5);
    const Poly l = scale(s.polynomial(s.random.between(1, N / 2)), s.element_unit(3));
    const Poly t = s.line(4);
    const Poly f = l * l + scale(pow(t, static_cast<unsigned long>(N)), s.element_unit(5));
    const Poly top = scale(t * derivative(l), NfElem(2)) - scale(l, NfElem(N));
    if (degree(gcd(f, derivative(f) * top * t)) > 0 || is_zero(top)) continue;
    return from_square(RationalFunction(t * t * f, top * top),
                       square(Rational(1, s.random.between(1, 8))));
  }
}

RationalFunction of_the_corpus(Source& s) {
  static const std::vector<RationalFunction> all = [] {
    std::vector<RationalFunction> equations;
    for (const char* file : {"pitfalls.jsonl", "public.jsonl"})
      for (const Json& entry : corpus(file))
        equations.push_back(equation_of(entry).r);
    return equations;
  }();
  const RationalFunction& r = s.random.one_of(all);
  if (!r.field()->is_rational()) s.field = r.field();
  return r;
}

using Kind = RationalFunction (*)(Source&);

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      odd_polynomial,     weber,      with_logarithms, some_riemann, one_line,
      two_lines,          euler,      primitive,       dihedral,     dihedral_on_a_curve,
      irregular_dihedral, two_points, without_poles,   lame_one,     torsion_points,
      of_the_corpus};
  return all;
}

// --- the comparison ------------------------------------------------------------------------------

void expect_the_same_with_a_certificate(const RationalFunction& r, const RationalFunction& f) {
  const RationalFunction moved = pull_back(r, f);
  SCOPED_TRACE(to_string(r) + " at " + to_string(f) + "\nis " + to_string(moved));
  Options options;
  options.want_certificate = true;
  options.want_solutions = false;
  const Decision d = decide({.r = moved, .p = RationalFunction()}, options);
  EXPECT_EQ(d.group ? corpus_name(*d.group) : reason(d), group_of(r));
  ASSERT_FALSE(d.certificate.empty()) << d.no_certificate;
  const auto verdict = certify::check(certify::read_certificate(d.certificate));
  EXPECT_TRUE(std::holds_alternative<certify::Accepted>(verdict));
}

Field number_field(Random& random) {
  static const std::vector<Field> fields{make_field({-2, 0, 1}, "s"), make_field({1, 0, 1}, "s"),
                                         make_field({5, 1, 1}, "s"),
                                         make_field({-2, 0, 0, 1}, "s")};
  return random.one_of(fields);
}

// One equation of every kind.
void move_all(Random& random, const Field& field, bool affine) {
  for (const Kind make : kinds()) {
    Source s{random, field};
    const RationalFunction r = make(s);
    expect_the_same_with_a_certificate(r, s.map(affine));
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(ChangesOfVariable, ScaleAndShift) {
  test::random_rounds(20, [](Random& random) { move_all(random, rationals(), true); });
}

TEST(ChangesOfVariable, Moebius) {
  test::random_rounds(12, [](Random& random) { move_all(random, rationals(), false); });
}

TEST(ChangesOfVariable, ScaleAndShiftOverANumberField) {
  test::random_rounds(6, [](Random& random) { move_all(random, number_field(random), true); });
}

TEST(ChangesOfVariable, MoebiusOverANumberField) {
  test::random_rounds(4, [](Random& random) { move_all(random, number_field(random), false); });
}

// Elliptic and hyperelliptic curves, two divisor classes: the primes of their certificates are those that the checkers take.
TEST(ChangesOfVariable, InfiniteDihedralGroups) {
  test::random_rounds(60, [](Random& random) {
    Source s{random, random.once_in(4) ? number_field(random) : rationals()};
    const RationalFunction r = random.once_in(2) ? two_points(s) : lame_one(s);
    expect_the_same_with_a_certificate(r, s.map(random.once_in(2)));
  });
}

} // namespace
} // namespace kov
