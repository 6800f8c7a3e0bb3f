// Build r from a chosen answer; the solver must find that answer.  Seeds are fixed and printed.

#include "kovacic/reader.hpp"
#include "kovacic/solve.hpp"
#include "support/equations.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kov::kovacic::roundtrip_test {
namespace {

using testing::from_omega;
using testing::from_square;
using testing::pull_back;
using testing::riemann;

class RoundTrip : public ::testing::TestWithParam<unsigned> {
protected:
  std::mt19937 gen_{GetParam()};
  Field k_ = rationals();

  void SetUp() override {
    const std::vector<std::vector<Integer>> fields{
        {0, 1}, {0, 1}, {1, 0, 1}, {-5, 0, 1}, {-1, -1, 0, 1}};
    const auto& m = fields[GetParam() % fields.size()];
    if (m.size() > 2) k_ = make_field(m, "a");
  }
  long uniform(long a, long b) { return std::uniform_int_distribution<long>(a, b)(gen_); }
  NfElem constant() {
    NfElem c(Rational(uniform(-4, 4), uniform(1, 3)), k_);
    if (!k_->is_rational() && uniform(0, 1) == 1)
      c += NfElem::generator(k_) * NfElem(Rational(uniform(-2, 2), 1));
    return c;
  }
  Poly poly(long max_degree) {
    std::vector<NfElem> c;
    for (long i = uniform(0, max_degree); i >= 0; --i)
      c.push_back(constant());
    const Poly f = Poly::from_coefficients(c);
    return is_zero(f) ? Poly(Rational(1)) : f;
  }
  Poly place() { return monic(Poly::monomial(NfElem(1), uniform(1, 3)) + poly(2) + Poly(11)); }
};

// y'/y with a given omega: poles of every kind, residues of every kind.
TEST_P(RoundTrip, Reducible) {
  RationalFunction omega;
  for (long i = uniform(1, 3); i > 0; --i) {
    const Poly q = place();
    if (degree(q) < 1) continue;
    switch (uniform(0, 3)) {
    case 0: // rational residue
      omega += RationalFunction(
          scale(derivative(q), NfElem(Rational(uniform(-5, 5), uniform(1, 4)))), q);
      break;
    case 1: // a residue in the residue field
      omega += RationalFunction(poly(degree(q) - 1), q);
      break;
    case 2: // irregular
      omega += RationalFunction(poly(1), q * q);
      break;
    default: // apparent singularities
      omega += RationalFunction(derivative(q), q);
    }
  }
  if (uniform(0, 1) == 1) omega += RationalFunction(poly(2));
  const RationalFunction r = from_omega(omega);
  SCOPED_TRACE("seed " + std::to_string(GetParam()) + ", omega = " + to_string(omega));
  const Outcome outcome = solve(r);
  ASSERT_EQ(case_of(outcome), 1);
  if (const auto* line = std::get_if<Exponential>(&outcome)) {
    EXPECT_EQ(line->omega, omega);
  } else {
    const auto& pair = std::get<ExponentialPair>(outcome);
    const RationalFunction w = RationalFunction(2) * pair.v * omega - derivative(pair.v);
    EXPECT_TRUE(pair.every_line || w * w == RationalFunction(Poly(pair.w_squared)));
  }
}

// y1 y2 = sqrt(f): case 2, unless f is a square or the group is small.
TEST_P(RoundTrip, Imprimitive) {
  RationalFunction f(Rational(1));
  for (long i = uniform(1, 2); i > 0; --i)
    f *= pow(RationalFunction(place()), uniform(0, 2) == 0 ? 3 : 1);
  if (uniform(0, 1) == 1) f *= RationalFunction(Poly::z()) + RationalFunction(Poly(constant()));
  const Poly apparent = place();
  f *= RationalFunction(apparent * apparent);
  const NfElem w = NfElem(uniform(1, 9));
  const RationalFunction r = from_square(f, w);
  SCOPED_TRACE("seed " + std::to_string(GetParam()) + ", f = " + to_string(f));
  const Outcome outcome = solve(r);
  ASSERT_TRUE(case_of(outcome) == 1 || case_of(outcome) == 2);
  const auto* found = std::get_if<kovacic::Imprimitive>(&outcome);
  if (found == nullptr) return; // a cyclic group
  const RationalFunction phi = derivative(f) / (RationalFunction(2) * f);
  EXPECT_EQ(found->phi, phi);
}

// Standard equations at a random rational function: the group stays, its field may not.
TEST_P(RoundTrip, Primitive) {
  const long kind = uniform(0, 2);
  const std::vector<RationalFunction> standard{
      riemann(NfElem(Rational(1, 4)), NfElem(Rational(1, 9)), NfElem(Rational(1, 9))),
      riemann(NfElem(Rational(1, 4)), NfElem(Rational(1, 9)), NfElem(Rational(1, 16))),
      riemann(NfElem(Rational(1, 4)), NfElem(Rational(1, 9)), NfElem(Rational(1, 25)))};
  const std::vector<kovacic::Primitive> groups{kovacic::Primitive::tetrahedral,
                                               kovacic::Primitive::octahedral,
                                               kovacic::Primitive::icosahedral};
  Poly num = poly(2) * Poly::z() + Poly(constant());
  const Poly den = uniform(0, 1) == 1 ? poly(1) : Poly(Rational(1));
  const RationalFunction f(num, den);
  if (is_zero(derivative(f))) return;
  SCOPED_TRACE("seed " + std::to_string(GetParam()) + ", f = " + to_string(f));
  const Outcome outcome = solve(pull_back(standard[static_cast<std::size_t>(kind)], f));
  const auto* found = std::get_if<Algebraic>(&outcome);
  ASSERT_NE(found, nullptr) << outcome.index();
  EXPECT_EQ(found->group, groups[static_cast<std::size_t>(kind)]);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RoundTrip, ::testing::Range(1u, 41u));

} // namespace
} // namespace kov::kovacic::roundtrip_test
