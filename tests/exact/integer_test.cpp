#include "exact/integer.hpp"

#include "exact/error.hpp"
#include "exact/laws.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kov {
namespace {

using testing::aliasing_laws;
using testing::domain_laws;
using testing::field_laws;
using testing::power_laws;
using testing::ring_laws;
using testing::value_laws;

// Both sides of the machine word, where FLINT changes its representation.
std::vector<Integer> integers() {
  std::vector<Integer> all{0, 1, -1, 2, -7, 360, 1000003};
  const Integer word = pow(Integer(2), 62);
  for (const Integer& n : {word, word - Integer(1), word + Integer(1), pow(Integer(10), 40)}) {
    all.push_back(n);
    all.push_back(-n);
  }
  return all;
}

std::vector<Rational> rationals_of_all_sizes() {
  std::vector<Rational> all;
  std::mt19937 gen(5);
  for (const Integer& n : integers())
    all.emplace_back(n, Integer(1 + static_cast<long>(gen() % 50)));
  all.emplace_back(Integer(3), pow(Integer(7), 60));
  return all;
}

TEST(IntegerLaws, CommutativeRingWithoutZeroDivisors) {
  for (const Integer& a : integers())
    for (const Integer& b : integers()) {
      ring_laws(a, b, a * b + Integer(5), Integer(0), Integer(1));
      domain_laws(a, b);
      value_laws(a, b);
    }
}

TEST(IntegerLaws, PowersAndOperandsThatAreTheTarget) {
  for (const Integer& a : integers()) {
    power_laws(a, Integer(1));
    aliasing_laws(a);
  }
}

TEST(IntegerLaws, OrderIsThatOfTheSignOfTheDifference) {
  for (const Integer& a : integers())
    for (const Integer& b : integers()) {
      EXPECT_EQ(a < b, sign(a - b) < 0);
      EXPECT_EQ(a == b, is_zero(a - b));
      EXPECT_EQ(a >= b, !(a < b));
    }
}

// Euclid, without the library's gcd.
Integer euclid(Integer a, Integer b) {
  while (!is_zero(b)) {
    const Integer r = a - floor_div(a, b) * b;
    a = b;
    b = r;
  }
  return sign(a) < 0 ? -a : a;
}

TEST(IntegerLaws, GcdAndLcmAgainstEuclid) {
  for (const Integer& a : integers())
    for (const Integer& b : integers()) {
      const Integer scaled = a * Integer(84);
      EXPECT_EQ(gcd(scaled, b), euclid(scaled, b));
      EXPECT_GE(sign(lcm(a, b)), 0);
      const Integer product = a * b;
      EXPECT_EQ(gcd(a, b) * lcm(a, b), sign(product) < 0 ? -product : product);
    }
}

TEST(IntegerLaws, DivisionRoundsDown) {
  for (const Integer& a : integers())
    for (const Integer& b : integers()) {
      if (is_zero(b)) continue;
      const Integer r = a - floor_div(a, b) * b; // has the sign of b
      EXPECT_TRUE(is_zero(r) || sign(r) == sign(b));
      EXPECT_LT(sign(r) < 0 ? -r : r, sign(b) < 0 ? -b : b);
      EXPECT_EQ(exact_div(a * b, b), a);
    }
}

TEST(IntegerLaws, SquareRootsAreExact) {
  for (const Integer& a : integers()) {
    const Integer size = sign(a) < 0 ? -a : a;
    EXPECT_EQ(exact_sqrt(a * a), size);
    EXPECT_FALSE(exact_sqrt(a * a + Integer(1)) && !is_zero(a));
    EXPECT_FALSE(exact_sqrt(-(a * a) - Integer(1)));
  }
}

TEST(IntegerLaws, SquarePartMultipliesBackAndLeavesNoSquare) {
  const struct {
    long d, s, n;
  } table[] = {{1, 1, 1},
               {-1, 1, -1},
               {8, 2, 2},
               {-12, 2, -3},
               {36, 6, 1},
               {-49, 7, -1},
               {2 * 9973, 1, 19946},
               {5 * 10007L * 10007L, 10007, 5},
               {720, 12, 5}};
  for (const auto& [d, s, n] : table)
    EXPECT_EQ(square_part(Integer(d)), std::pair(Integer(s), Integer(n))) << d;
  for (long d = -400; d <= 400; ++d) {
    if (d == 0) continue;
    const auto [s, n] = square_part(Integer(d));
    EXPECT_EQ(s * s * n, Integer(d));
    EXPECT_EQ(sign(s), 1);
    for (long p = 2; p * p <= 400; ++p)
      EXPECT_NE(to_long(n) % (p * p), 0) << d;
  }
  // a high power at once, not one square after the other
  const auto [s, n] = square_part(pow(Integer(40001), 200001) * Integer(3));
  EXPECT_EQ(n, Integer(3 * 40001L)); // 13 * 17 * 181, each to an odd power
  EXPECT_EQ(s, pow(Integer(40001), 100000));
}

TEST(IntegerLaws, MachineWordsAndBack) {
  for (const long n : {0L, 1L, -1L, 4611686018427387903L, 4611686018427387904L,
                       std::numeric_limits<long>::max(), std::numeric_limits<long>::min()}) {
    EXPECT_TRUE(fits_long(Integer(n)));
    EXPECT_EQ(to_long(Integer(n)), n);
    EXPECT_EQ(to_string(Integer(n)), std::to_string(n));
  }
  const Integer large = Integer(std::numeric_limits<unsigned long>::max());
  EXPECT_EQ(to_string(large), "18446744073709551615");
  EXPECT_FALSE(fits_long(large));
  EXPECT_THROW((void)to_long(large), InternalError);
}

TEST(IntegerLaws, TextAndBack) {
  for (const Integer& a : integers())
    EXPECT_EQ(Integer::parse(to_string(a)), a);
  EXPECT_EQ(Integer::parse("-007"), Integer(-7));
  for (const std::string text : {"", "-", "1-", "--1", "1.0", "0x10", "1e3", "12a", " 1", "1 ",
                                 "1 2", "1\n", "\t1", "1,000"})
    EXPECT_THROW((void)Integer::parse(text), InvalidArgument) << "'" << text << "'";
  EXPECT_THROW((void)Integer::parse(std::string_view("1\0002", 3)), InvalidArgument);
}

TEST(RationalLaws, Field) {
  const auto all = rationals_of_all_sizes();
  for (const Rational& a : all)
    for (const Rational& b : all) {
      const Rational c = a * b - Rational(1, 3);
      ring_laws(a, b, c, Rational(0), Rational(1));
      domain_laws(a, b);
      value_laws(a, b);
      if (!is_zero(b) && !is_zero(c)) field_laws(a, b, c, Rational(1));
    }
  for (const Rational& a : all)
    aliasing_laws(a);
}

TEST(RationalLaws, CanonicalForm) {
  for (const Rational& a : rationals_of_all_sizes())
    for (const long c : {1L, -1L, 12L, -35L}) {
      const Rational same(a.num() * Integer(c), a.den() * Integer(c));
      EXPECT_EQ(same, a);
      EXPECT_EQ(sign(same.den()), 1);
      EXPECT_EQ(gcd(same.num(), same.den()), Integer(1));
      EXPECT_EQ(is_integer(a), same.den() == Integer(1));
    }
  EXPECT_THROW(Rational(Integer(1), Integer(0)), DomainError);
  EXPECT_THROW(Rational(1) / Rational(0), DomainError);
}

TEST(RationalLaws, OrderIsCompatibleWithTheOperations) {
  const auto all = rationals_of_all_sizes();
  for (const Rational& a : all)
    for (const Rational& b : all) {
      EXPECT_EQ(a < b, sign(a - b) < 0);
      EXPECT_EQ(a < b, a + Rational(5, 7) < b + Rational(5, 7));
      EXPECT_EQ(a < b, -b < -a);
      EXPECT_LE(abs(a + b), abs(a) + abs(b));
      EXPECT_EQ(abs(a * b), abs(a) * abs(b));
    }
}

TEST(RationalLaws, FloorAndCeiling) {
  for (const Rational& a : rationals_of_all_sizes()) {
    EXPECT_LE(Rational(floor(a)), a);
    EXPECT_LT(a, Rational(floor(a) + Integer(1)));
    EXPECT_EQ(ceil(a), is_integer(a) ? a.num() : floor(a) + Integer(1));
    EXPECT_EQ(floor(a + Rational(3)), floor(a) + Integer(3));
  }
}

TEST(RationalLaws, SquareRootsAreExact) {
  for (const Rational& a : rationals_of_all_sizes()) {
    EXPECT_EQ(exact_sqrt(a * a), abs(a));
    if (is_zero(a)) continue;
    EXPECT_FALSE(exact_sqrt(a * a * Rational(2)));
    EXPECT_FALSE(exact_sqrt(-(a * a)));
  }
}

TEST(RationalLaws, TextAndBack) {
  for (const Rational& a : rationals_of_all_sizes())
    EXPECT_EQ(Rational::parse(to_string(a)), a);
  EXPECT_EQ(Rational::parse("6/-4"), Rational(-3, 2));
  for (const char* text : {"", "/", "1/", "/2", "1/2/3", "1 /2", "1/ 2", "0.5"})
    EXPECT_THROW((void)Rational::parse(text), InvalidArgument) << text;
  EXPECT_THROW((void)Rational::parse("1/0"), DomainError);
}

} // namespace
} // namespace kov
