// The variational equation along a phase curve of genus one: what is known of every such matrix.

#include "integrability/check.hpp"
#include "integrability/variational_monodromy.hpp"

#include <gtest/gtest.h>

#include <random>
#include <tuple>

namespace kov {
namespace {

namespace mo = monodromy;

EllipticVariation variation_of(const std::string& hamiltonian) {
  const System s = read_system(parse_document(R"t([system]
kind = "hamiltonian"
coordinates = ["q1", "q2"]
momenta = ["p1", "p2"]
hamiltonian = ")t" + hamiltonian + R"t("
[[manifold]]
name = "plane"
equations = ["q1 = 0", "p1 = 0"]
level = "H = 1"
)t",
                                              "test.toml"));
  const auto proved = prove_invariant(s.field, s.manifolds.front());
  const auto& m = std::get<InvariantManifold>(proved);
  return elliptic_variation(s, m, variational_equations(s.field, m));
}

// M^T J M = J in the order q1, q2, p1, p2.
void expect_symplectic(const mo::BallMatrix& m, long bits) {
  mo::BallMatrix j(4), transposed(4);
  for (long i = 0; i < 2; ++i) {
    acb_set_si(j.entry(i, i + 2), 1);
    acb_set_si(j.entry(i + 2, i), -1);
  }
  acb_mat_transpose(transposed.raw(), m.raw());
  EXPECT_TRUE(overlap(multiply(transposed, multiply(j, m, bits), bits), j));
}

// (0, q2', 0, p2') at the base: periodic along the curve.  p2' = (dF/dz)/2.
void expect_tangent(const mo::BallMatrix& m, const mo::EllipticMonodromy& e, const Poly& f) {
  ComplexBall force = evaluate(derivative(f), exact(e.base), e.bits);
  acb_mul_2exp_si(force.raw(), force.raw(), -1);
  for (long i = 0; i < 4; ++i) {
    ComplexBall sum, expected;
    acb_mul(sum.raw(), m.entry(i, 1), e.speed.raw(), e.bits);
    acb_addmul(sum.raw(), m.entry(i, 3), force.raw(), e.bits);
    if (i == 1) expected = e.speed;
    if (i == 3) expected = force;
    EXPECT_TRUE(acb_overlaps(sum.raw(), expected.raw()) != 0) << i;
  }
}

std::string number(std::mt19937& generator) {
  return "(" + std::to_string(std::uniform_int_distribution<int>(1, 9)(generator)) + "/" +
         std::to_string(std::uniform_int_distribution<int>(1, 9)(generator)) + ")";
}

// Terms that couple by w: q1*p1*p2 keeps the two parts by the sign of w, q1^2*p2 mixes them.
TEST(EllipticVariation, IsSymplecticAndKeepsTheTangent) {
  std::mt19937 generator(22);
  for (const std::string more : {"", "q1*p1*p2", "q1^2*p2"})
    for (const std::string potential : {"q2^3", "q2^4"}) {
      const std::string h = "(p1^2+p2^2)/2 + " + number(generator) + "*" + potential + " + " +
                            number(generator) + "*q2^2 + " + number(generator) + "*q1^2*q2 + " +
                            number(generator) + "*" + (more.empty() ? "q1^2" : more);
      const EllipticVariation v = variation_of(h);
      const mo::EllipticMonodromy e = mo::elliptic_monodromy(v.system, {8, {}, {}});
      for (const mo::LoopMatrix& l : mo::elements(e).loops) {
        expect_symplectic(l.matrix, e.bits);
        expect_tangent(l.matrix, e, v.system.f);
      }
    }
}

TEST(EllipticVariation, OtherCurvesAreTold) {
  for (const std::string potential : {"q2^2", "q2^5", "(q2^2-1)^2+1"}) // genus 0, 2 and 0
    EXPECT_THROW(std::ignore = variation_of("(p1^2+p2^2)/2 + q1^2*q2 + " + potential),
                 InvalidArgument)
        << potential;
}

} // namespace
} // namespace kov
