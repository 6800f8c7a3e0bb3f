// The list of integrable cases and the Hess-Appelrot case, where more than "proved" can be said.

#include "sliding_top.hpp"
#include "support/source_dir.hpp"

namespace kov::lemmas {
namespace {

System classic(const std::string& file) {
  return read_system(test::in_source("/cases/classics/") + file);
}

TEST(IntegrableCases,
     GoryachevChaplyginHoldsOnF2) { // the print says F_1 = 0; exactly -m g L1 M2 F2
  const System s = classic("heavy_top_goryachev_chaplygin.toml");
  const MFraction f3 = formula(s, "M3*(M1^2 + M2^2) - L1*A*M1*Gamma3");
  EXPECT_TRUE(equal(lie_derivative(s.field, f3), formula(s, "-L1*M2*F2")));
}

TEST(IntegrableCases, KovalevskayaNeedsItsRatio) {
  const System s = read_system(test::in_source("/cases/classics/heavy_top.toml"),
                               {{"B", "A"}, {"L2", "0"}, {"L3", "0"}});
  const MFraction f3 = formula(s, "((M1^2-M2^2)/2 - L1*A*Gamma1)^2 + (M1*M2 - L1*A*Gamma2)^2");
  const MFraction derivative = lie_derivative(s.field, f3);
  EXPECT_FALSE(is_zero(derivative));
  EXPECT_TRUE(is_zero(substitute(derivative, {{s.ring()->index("C"), formula(s, "A/2")}})));
}

TEST(IntegrableCases, HessAppelrotPolynomialIsTheProjectionOnL) { // G is proportional to L . M
  const System s = sliding_top("hess_appelrot.toml");
  EXPECT_TRUE(equal(formula(s, "L1*M1 + L3*M3"), formula(s, "k*(u*M1 - v*M3)")));
}

TEST(IntegrableCases, BothSignsOfHessAppelrot) {
  for (const char* sign : {"1", "-1"}) {
    const System s = sliding_top("hess_appelrot.toml", {{"sign", sign}});
    for (const auto& claim : s.claims)
      EXPECT_EQ(check_claim(s, claim).proved, claim.holds) << claim.name << ", sign " << sign;
  }
}

} // namespace
} // namespace kov::lemmas
