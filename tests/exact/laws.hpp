#pragma once
// The axioms, each stated once: a suite hands them three random elements of its type.

#include <gtest/gtest.h>

#include <utility>

namespace kov::testing {

/// A commutative ring with the given neutral elements.
template <class T> void ring_laws(const T& a, const T& b, const T& c, const T& zero, const T& one) {
  EXPECT_EQ(a + b, b + a);
  EXPECT_EQ((a + b) + c, a + (b + c));
  EXPECT_EQ(a + zero, a);
  EXPECT_EQ(a - b, a + (-b));
  EXPECT_EQ(a - a, zero);
  EXPECT_EQ(-(-a), a);
  EXPECT_EQ(a * b, b * a);
  EXPECT_EQ((a * b) * c, a * (b * c));
  EXPECT_EQ(a * (b + c), a * b + a * c);
  EXPECT_EQ(a * one, a);
  EXPECT_EQ(a * zero, zero);
  EXPECT_EQ((-a) * b, -(a * b));
}

/// No zero divisors.
template <class T> void domain_laws(const T& a, const T& b) {
  EXPECT_EQ(is_zero(a * b), is_zero(a) || is_zero(b));
}

/// What a field adds.  Requires b, c not 0.
template <class T> void field_laws(const T& a, const T& b, const T& c, const T& one) {
  EXPECT_EQ((a / b) * b, a);
  EXPECT_EQ(b / b, one);
  EXPECT_EQ(a / b / c, a / (b * c));
  EXPECT_EQ(one / (one / b), b);
  EXPECT_EQ((a / b) + (a / c), a * (b + c) / (b * c));
}

/// Powers, against repeated multiplication.
template <class T> void power_laws(const T& a, const T& one) {
  T product = one;
  for (unsigned e = 0; e < 6; ++e, product = product * a)
    EXPECT_EQ(pow(a, e), product) << "exponent " << e;
  EXPECT_EQ(pow(pow(a, 2), 3), pow(a, 6));
  EXPECT_EQ(pow(a, 3) * pow(a, 4), pow(a, 7));
}

/// A derivation d.
template <class T, class D> void derivation_laws(const T& a, const T& b, D d) {
  EXPECT_EQ(d(a + b), d(a) + d(b));
  EXPECT_EQ(d(a * b), d(a) * b + a * d(b));
}

/// Copies are independent, assignment may alias, and what was moved from can be used again.
template <class T> void value_laws(const T& a, const T& b) {
  T x = a;
  T y = x;
  x = b;
  EXPECT_EQ(y, a);
  EXPECT_EQ(x, b);
  std::swap(x, y);
  EXPECT_EQ(x, a);
  EXPECT_EQ(y, b);
  T& alias = x;
  x = alias;
  EXPECT_EQ(x, a);
  T taken = std::move(x);
  EXPECT_EQ(taken, a);
  x = b; // NOLINT: a moved-from value may be assigned
  EXPECT_EQ(x, b);
  x = std::move(taken);
  EXPECT_EQ(x, a);
}

/// Operands that are the target.
template <class T> void aliasing_laws(const T& a) {
  T x = a;
  x += x;
  EXPECT_EQ(x, a + a);
  x = a;
  x *= x;
  EXPECT_EQ(x, a * a);
  x = a;
  x -= x;
  EXPECT_TRUE(is_zero(x));
  x = a;
  x = x * x + x;
  EXPECT_EQ(x, a * a + a);
}

/// compare() is a total order of which == is the equality.
template <class T> void order_laws(const T& a, const T& b, const T& c) {
  const auto sign = [](int n) { return (n > 0) - (n < 0); };
  EXPECT_EQ(sign(compare(a, b)), -sign(compare(b, a)));
  EXPECT_EQ(compare(a, b) == 0, a == b);
  EXPECT_EQ(compare(a, a), 0);
  if (compare(a, b) <= 0 && compare(b, c) <= 0) {
    EXPECT_LE(compare(a, c), 0);
  }
}

} // namespace kov::testing
