#include "exact/number_field.hpp"

#include "exact/error.hpp"
#include "exact/fields.hpp"
#include "exact/laws.hpp"
#include "exact/read_back.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using namespace testing;

class NumberFieldLaws : public OverFields {
protected:
  // The matrix of x -> a x in the powers of the generator, over Q.
  std::vector<std::vector<Rational>> multiplication(const NfElem& a) const {
    const auto d = static_cast<std::size_t>(k->degree());
    std::vector m(d, std::vector<Rational>(d));
    NfElem column = a;
    for (std::size_t j = 0; j < d; ++j, column *= NfElem::generator(k))
      for (std::size_t i = 0; i < d; ++i)
        m[i][j] = column.coeff(static_cast<long>(i));
    return m;
  }
};

// By expansion along the first column: slow, and of another kind than the library's resultants.
Rational determinant(const std::vector<std::vector<Rational>>& m) {
  if (m.empty()) return 1;
  Rational sum;
  for (std::size_t i = 0; i < m.size(); ++i) {
    std::vector<std::vector<Rational>> minor;
    for (std::size_t r = 0; r < m.size(); ++r)
      if (r != i) minor.emplace_back(m[r].begin() + 1, m[r].end());
    const Rational term = m[i][0] * determinant(minor);
    sum += i % 2 == 0 ? term : -term;
  }
  return sum;
}

TEST_P(NumberFieldLaws, Field) {
  const NfElem zero(k);
  const NfElem one(Rational(1), k);
  for (int i = 0; i < 30; ++i) {
    SCOPED_TRACE(i);
    const NfElem a = element();
    const NfElem b = nonzero();
    const NfElem c = nonzero();
    ring_laws(a, b, c, zero, one);
    field_laws(a, b, c, one);
    domain_laws(a, b);
    value_laws(a, b);
    aliasing_laws(a);
    EXPECT_EQ(inverse(inverse(b)), b);
    EXPECT_TRUE(is_one(b * inverse(b)));
  }
  power_laws(element(), one);
  EXPECT_THROW((void)inverse(zero), DomainError);
  EXPECT_THROW(one / zero, DomainError);
}

TEST_P(NumberFieldLaws, TheGeneratorIsARootOfItsMinimalPolynomial) {
  const auto m = k->minpoly_coefficients();
  NfElem value(k);
  for (std::size_t i = m.size(); i-- > 0;)
    value = value * NfElem::generator(k) + NfElem(Rational(m[i]));
  EXPECT_TRUE(is_zero(value));
  EXPECT_EQ(static_cast<long>(m.size()), k->degree() + 1);
}

TEST_P(NumberFieldLaws, RationalNumbersAreASubfield) {
  for (int i = 0; i < 20; ++i) {
    const Rational p = rational();
    const Rational q = rational();
    EXPECT_EQ(to_rational(NfElem(p, k) * NfElem(q, k)), p * q);
    EXPECT_EQ(NfElem(p, k) + NfElem(q), NfElem(p + q));
    EXPECT_EQ(coerce(NfElem(p), k).field(), k);
    const NfElem a = element();
    EXPECT_EQ(is_rational(a), a == NfElem(a.coeff(0)));
    EXPECT_EQ((NfElem(p) * a).field(), k); // Q acts from both sides
    EXPECT_EQ(NfElem(p) * a, a * NfElem(p, k));
  }
}

// N(a) and Tr(a) are coefficients of the characteristic polynomial of x -> a x, which is the norm
// of z - a.
TEST_P(NumberFieldLaws, NormAndTraceAreThoseOfTheMultiplicationMap) {
  for (int i = 0; i < 6; ++i) {
    SCOPED_TRACE(i);
    const NfElem a = element();
    const NfElem b = element();
    const auto norm_of = [&](const NfElem& x) {
      return to_rational(norm(coerce(Poly(x), k)).coeff(0));
    };
    EXPECT_EQ(norm_of(a), determinant(multiplication(a)));
    EXPECT_EQ(norm_of(a * b), norm_of(a) * norm_of(b));
    const Poly characteristic = norm(z() - Poly(a));
    ASSERT_EQ(degree(characteristic), k->degree());
    EXPECT_TRUE(is_one(lead(characteristic)));
    Rational trace;
    const auto m = multiplication(a);
    for (std::size_t j = 0; j < m.size(); ++j)
      trace += m[j][j];
    EXPECT_EQ(to_rational(characteristic.coeff(k->degree() - 1)), -trace);
    EXPECT_TRUE(is_zero(evaluate(coerce(characteristic, k), a))); // Cayley-Hamilton
  }
}

TEST_P(NumberFieldLaws, SquareRoots) {
  for (int i = 0; i < 6; ++i) {
    const NfElem a = nonzero();
    const auto root = exact_sqrt(a * a);
    ASSERT_TRUE(root);
    EXPECT_TRUE(*root == a || *root == -a);
    EXPECT_EQ(root->field(), k);
    // 43 is inert or not, but never a square: no field of the list contains its root
    EXPECT_FALSE(exact_sqrt(a * a * NfElem(43)));
  }
  EXPECT_TRUE(is_zero(*exact_sqrt(NfElem(k))));
}

// The embedding is a homomorphism: enclosures of the two sides meet, and those of different
// numbers are told apart with enough bits.
TEST_P(NumberFieldLaws, EmbeddingIsARingMap) {
  for (int i = 0; i < 8; ++i) {
    const NfElem a = element();
    const NfElem b = element();
    ComplexBall sum;
    ComplexBall product;
    acb_add(sum.raw(), embed(a, 80).raw(), embed(b, 80).raw(), 80);
    acb_mul(product.raw(), embed(a, 80).raw(), embed(b, 80).raw(), 80);
    EXPECT_TRUE(acb_overlaps(sum.raw(), embed(a + b, 80).raw()));
    EXPECT_TRUE(acb_overlaps(product.raw(), embed(a * b, 80).raw()));
    EXPECT_EQ(acb_overlaps(embed(a, 200).raw(), embed(b, 200).raw()) != 0, a == b);
    EXPECT_GT(acb_rel_accuracy_bits(embed(a + NfElem(1000), 200).raw()), 150);
  }
  ComplexBall value; // of the minimal polynomial at the generator
  arb_fmpz_poly_evaluate_acb(value.raw(), k->minpoly(), k->generator(100).raw(), 100);
  EXPECT_TRUE(acb_contains_zero(value.raw()));
}

TEST_P(NumberFieldLaws, TextAndBack) {
  if (k->is_rational()) return;
  const NfElem letter = NfElem::generator(k) / NfElem(Rational(k->scale()));
  ReadBack<NfElem> read({{k->letter(), letter}},
                        [](const Integer& n, const NfElem&) { return NfElem(Rational(n)); });
  for (int i = 0; i < 40; ++i) {
    const NfElem a = element();
    EXPECT_EQ(read(to_string(a)), a) << to_string(a);
    NfElem shown(k);
    const auto c = shown_coefficients(a);
    for (std::size_t j = 0; j < c.size(); ++j)
      shown += NfElem(c[j]) * pow(letter, j);
    EXPECT_EQ(shown, a);
  }
}

TEST_P(NumberFieldLaws, ReductionInBlocksIsReductionOfEachBlock) {
  const long d = k->degree();
  fmpz_poly_t flat;
  fmpz_poly_init(flat);
  std::vector<NfElem> expected;
  for (long block = 0; block < 3; ++block) {
    NfElem value(k);
    for (long i = 0; i < 2 * d - 1; ++i) {
      const long c = number(-50, 50);
      fmpz_poly_set_coeff_si(flat, block * (2 * d - 1) + i, c);
      value += NfElem(c) * pow(NfElem::generator(k), static_cast<unsigned long>(d == 1 ? 0 : i));
    }
    expected.push_back(value);
  }
  reduce_blocks(flat, *k);
  for (long block = 0; block < 3; ++block)
    for (long i = 0; i < 2 * d - 1; ++i) {
      Integer c;
      fmpz_poly_get_coeff_fmpz(c.raw(), flat, block * (2 * d - 1) + i);
      EXPECT_EQ(Rational(c), expected[static_cast<std::size_t>(block)].coeff(i));
    }
  fmpz_poly_clear(flat);
}

KOV_OVER_ALL_FIELDS(NumberFieldLaws);

TEST(NumberFields, TwoFieldsDoNotMix) {
  const Field k = make_field({-2, 0, 1}, "s");
  const Field l = make_field({-3, 0, 1}, "t");
  EXPECT_THROW(NfElem::generator(k) + NfElem::generator(l), InvalidArgument);
  EXPECT_EQ(common_field(k, rationals()), k);
  EXPECT_EQ(common_field(rationals(), l), l);
  EXPECT_THROW((void)coerce(NfElem::generator(k), l), InternalError);
  // sqrt(2) is not sqrt(3), although both are "the generator"; rational numbers are the same
  // anywhere
  EXPECT_FALSE(NfElem::generator(k) == NfElem::generator(l));
  EXPECT_EQ(NfElem(Rational(1, 2), k), NfElem(Rational(1, 2), l));
}

TEST(NumberFields, BadMinimalPolynomialsAreRefused) {
  EXPECT_THROW((void)make_field({5}, "a"), InvalidArgument);
  EXPECT_THROW((void)make_field({}, "a"), InvalidArgument);
  EXPECT_THROW((void)make_field({1, 0, 2}, "a"), InvalidArgument);
}

TEST(NumberFields, TheChosenRootDecidesTheEmbedding) {
  for (int root = 0; root < 3; ++root) { // x^3 - 2: one real root, two conjugate ones
    const Field k = make_field({-2, 0, 0, 1}, "a", root);
    const ComplexBall a = embed(NfElem::generator(k), 100);
    ComplexBall cube;
    acb_pow_ui(cube.raw(), a.raw(), 3, 100);
    EXPECT_TRUE(arb_contains_si(acb_realref(cube.raw()), 2));
    for (int other = 0; other < root; ++other)
      EXPECT_FALSE(
          acb_overlaps(a.raw(), make_field({-2, 0, 0, 1}, "a", other)->generator(100).raw()));
  }
}

TEST(NumberFields, TextsShowTheLetterAndNotTheGenerator) {
  const Field k = make_field({-6, 0, 1}, "a", 0, Integer(2)); // a with 2 a^2 = 3
  const NfElem a = NfElem::generator(k) / NfElem(2);
  EXPECT_EQ(to_string(a), "a");
  EXPECT_EQ(k->name(), "(2*a)");
  const Poly z = Poly::z();
  EXPECT_EQ(to_string(RationalFunction(Poly(a), z * z), "z"), "a/z^2");
  EXPECT_EQ(to_string(RationalFunction(Poly(a) + z, scale(z * z, NfElem(3))), "z"),
            "(z + a)/(3*z^2)");
  EXPECT_EQ(to_string(Poly(a * NfElem(Rational(1, 2)) + NfElem(1)), "z"), "1/2*a + 1");
}

} // namespace
} // namespace kov
