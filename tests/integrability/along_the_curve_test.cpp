// What couples a normal unknown to the curve, for fields without a bracket.

#include "integrability/along_the_curve.hpp"
#include "integrability/check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::along_the_curve_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

System field(const std::string& coordinates, const std::string& components,
             const std::string& parameters = "") {
  return read_system(parse_document("[system]\nkind = 'vector-field'\ncoordinates = [" +
                                        coordinates + "]\nparameters = [" + parameters +
                                        "]\n[system.field]\n" + components,
                                    "test.toml"));
}

ManifoldSpec set(const System& s, const std::vector<std::string>& zero) {
  ManifoldSpec m;
  m.name = "curve";
  for (const std::string& name : zero)
    m.equations.push_back({formula(s, name), name + " = 0"});
  return m;
}

ManifoldReport study(const System& s, const std::vector<std::string>& zero) {
  CheckOptions options;
  options.along_the_curve = true;
  return check_manifold(s, set(s, zero), decide_claims(s, {}), options);
}

const char* const volterra = "x = 'x*(y - z + a)'\ny = 'y*(z - x + b)'\nz = 'z*(x - y + c)'\n";

// Abelian exactly where the integral of z^(a/c - 1) exp(-z/c) is elementary: for a/c = 1, 2, ...
TEST(AlongTheCurve, IncompleteGammaFunctions) {
  for (const char* ratio : {"1", "2", "3"}) {
    const System s = read_system(
        parse_document("[system]\nkind = 'vector-field'\ncoordinates = ['x', 'z']\n[system.field]\n"
                       "x = 'x*(" +
                           std::string(ratio) + " - z)'\nz = 'z*(x + 1)'\n",
                       "test.toml"));
    EXPECT_NE(study(s, {"x"}).verdict, Verdict::non_integrable) << ratio;
  }
  for (const char* ratio : {"0", "-1", "1/2", "-2", "5/3"}) {
    const System s = read_system(
        parse_document("[system]\nkind = 'vector-field'\ncoordinates = ['x', 'z']\n[system.field]\n"
                       "x = 'x*(" +
                           std::string(ratio) + " - z)'\nz = 'z*(x + 1)'\n",
                       "test.toml"));
    EXPECT_EQ(study(s, {"x"}).verdict, Verdict::non_integrable) << ratio;
  }
}
// x' = 0, z' = z + x z: the coupling is there, and the field integrable.
TEST(AlongTheCurve, IntegrableFieldsStayOpen) {
  const System product = field("'x', 'z'", "x = '0'\nz = 'z*(1 + x)'\n");
  EXPECT_NE(study(product, {"x"}).verdict, Verdict::non_integrable);
  const System linear = field("'x', 'y'", "x = '2*x'\ny = 'x + y'\n");
  EXPECT_NE(study(linear, {"x"}).verdict, Verdict::non_integrable);
  const System projective =
      field("'x', 'y', 'z'",
            "x = 'x*(x + 2*y + 3*z)'\ny = 'y*(x + 2*y + 3*z)'\nz = 'z*(x + 2*y + 3*z)'\n");
  EXPECT_NE(study(projective, {"x", "y"}).verdict, Verdict::non_integrable);
  // a rational integral and a rational commuting field
  const System may_leonard =
      field("'x', 'y', 'z'", "x = 'x*(1 - x - 3*y + z)'\ny = 'y*(1 + x - y - 3*z)'\n"
                             "z = 'z*(1 - 3*x + y - z)'\n");
  EXPECT_NE(study(may_leonard, {"x", "y"}).verdict, Verdict::non_integrable);
}
TEST(AlongTheCurve, PairsAreSubsystems) {
  const System s = field("'x', 'y', 'z'", volterra, "'a', 'b', 'c'");
  const auto pairs = [](const System& of, const std::vector<std::string>& zero) {
    ManifoldReport r;
    r.manifold = std::get<InvariantManifold>(prove_invariant(of.field, set(of, zero)));
    r.normal = normal_system(of.field, *r.manifold, {});
    const auto e = extended_system(of, r);
    return e ? pairs_with_the_curve(*e, *r.manifold) : std::vector<std::vector<std::size_t>>{};
  };
  EXPECT_THAT(pairs(s, {"x", "y"}), ElementsAre(ElementsAre(0, 2), ElementsAre(1, 2)));
  // y' contains x: y = 0 is not a subsystem without x = 0, and x alone is none with z
  const System chain = field("'x', 'y', 'z'", "x = 'x*z'\ny = 'x + y*z'\nz = 'z + x + y'\n");
  EXPECT_THAT(pairs(chain, {"x", "y"}), ElementsAre(ElementsAre(1, 2)));
  const System not_coupled = field("'x', 'z'", "x = 'x*z'\nz = 'z + x^2'\n");
  EXPECT_THAT(pairs(not_coupled, {"x"}), IsEmpty());
}
TEST(AlongTheCurve, NothingIsSaidUnlessItIsAsked) {
  const System s = field("'x', 'z'", "x = 'x*(1/2 - z)'\nz = 'z*(x + 1)'\n");
  EXPECT_NE(check_manifold(s, set(s, {"x"}), {}, {}).verdict, Verdict::non_integrable);
}

} // namespace
} // namespace kov::along_the_curve_test
