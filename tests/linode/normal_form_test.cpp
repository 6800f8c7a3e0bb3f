#include "linode/normal_form.hpp"

#include "exact/fields.hpp"
#include "linode/series.hpp"

#include <gtest/gtest.h>

namespace kov::normal_form_test {
namespace {

using namespace testing;

class NormalFormLaws : public OverFields {
protected:
  // poles away from 0, where the series are taken
  [[nodiscard]] RationalFunction regular_at_zero() {
    return {poly(2), z() * z() * z() + Poly(nonzero())};
  }
  [[nodiscard]] static RationalFunction quarter(const RationalFunction& f) {
    return f * RationalFunction(Rational(1, 4));
  }
};

// u = exp(1/2 int p) y maps the solutions of y'' + p y' + q y = 0 to those of u'' = r u; the same
// factor for both solutions, so that their ratio stays.
TEST_P(NormalFormLaws, RatiosOfSolutionsStay) {
  constexpr long n = 9;
  for (int i = 0; i < 3; ++i) {
    const RationalFunction p = regular_at_zero();
    const RationalFunction q = regular_at_zero();
    const NormalForm form = normal_form(p, q);
    EXPECT_EQ(form.p, p);
    const Poly ps = series_at(p, NfElem(0), n);
    const Poly qs = series_at(q, NfElem(0), n);
    const Poly rs = series_at(form.r, NfElem(0), n);
    const Poly factor = exponential_series(scale(integral_series(ps), NfElem(Rational(1, 2))), n);
    std::vector<Poly> y, u;
    for (const auto& [a, b] : {std::pair(1, 0), {0, 1}}) {
      y.push_back(solution_series(ps, qs, NfElem(a), NfElem(b), n));
      const NfElem slope = NfElem(b) + NfElem(a) * ps.coeff(0) / NfElem(2);
      u.push_back(solution_series(Poly(0), -rs, NfElem(a), slope, n));
      EXPECT_EQ(truncate(y.back() * factor, n), u.back());
    }
    EXPECT_EQ(truncate(y[0] * u[1], n), truncate(y[1] * u[0], n));
  }
}

// y = g w changes p and q, and not r.
TEST_P(NormalFormLaws, RationalFactorsDoNotChangeTheNormalForm) {
  for (int i = 0; i < 5; ++i) {
    const RationalFunction p = function(2);
    const RationalFunction q = function(2);
    const RationalFunction g = RationalFunction(monic_poly(2)) / RationalFunction(monic_poly(1));
    const RationalFunction h = derivative(g) / g;
    const RationalFunction two(2);
    const NormalForm other = normal_form(p + two * h, q + p * h + derivative(derivative(g)) / g);
    EXPECT_EQ(other.r, normal_form(p, q).r);
  }
}

// omega = y'/y solves omega' + omega^2 + p omega + q = 0 exactly when omega + p/2 solves Riccati's
// equation of the normal form.
TEST_P(NormalFormLaws, RiccatiEquationsCorrespond) {
  for (int i = 0; i < 5; ++i) {
    const RationalFunction p = function(2);
    const RationalFunction omega = function(2);
    const RationalFunction q = -(derivative(omega) + omega * omega + p * omega);
    const RationalFunction moved = omega + p * RationalFunction(Rational(1, 2));
    EXPECT_EQ(derivative(moved) + moved * moved, normal_form(p, q).r);
  }
}

TEST_P(NormalFormLaws, NormalFormsStay) {
  const RationalFunction r = function(3);
  EXPECT_EQ(normal_form(RationalFunction{Poly(k)}, -r).r, r);
}

KOV_OVER_ALL_FIELDS(NormalFormLaws);

} // namespace
} // namespace kov::normal_form_test
