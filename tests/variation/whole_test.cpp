// What of the variational equations the blocks of the normal part leave out.

#include "variation/whole.hpp"

#include "symbol/document.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace kov {
namespace {

using testing::HasSubstr;

/// The whole normal part looked at as one block, after H and the Casimirs of the file.
std::string missing(const std::string& text) {
  const System s = read_system(parse_document(text, "test.toml"));
  const auto proved = prove_invariant(s.field, s.manifolds.at(0));
  if (const auto* failure = std::get_if<ManifoldFailure>(&proved)) return failure->message;
  const auto& m = std::get<InvariantManifold>(proved);
  std::vector<SystemClaim> integrals = s.claims;
  if (s.field.hamiltonian) {
    integrals.emplace_back();
    integrals.back().name = "H";
    integrals.back().value = *s.field.hamiltonian;
  }
  const NormalSystem n = normal_system(s.field, m, integrals);
  const ReducedSystem r = reduce_by_integrals(s.field, m, n, {});
  std::vector<std::size_t> all(r.system.names.size());
  std::iota(all.begin(), all.end(), 0U);
  return whole_variation(s.field, m, n, r, {all}).missing;
}

std::string canonical(const std::string& h, const std::string& equations) {
  return "[system]\nkind = \"hamiltonian\"\ncoordinates = [\"q1\", \"q2\"]\n"
         "momenta = [\"p1\", \"p2\"]\nparameters = [\"h\"]\nhamiltonian = \"" +
         h + "\"\n[[manifold]]\nname = \"m\"\nequations = [" + equations + "]\nlevel = \"H = h\"\n";
}

TEST(WholeVariation, ASymplecticPlaneHasAComplement) {
  const std::string h = "(p1^2 + p2^2)/2 + q1^3 + q1*q2^2";
  EXPECT_EQ(missing(canonical(h, "\"q2 = 0\", \"p2 = 0\"")), "");
  // however its equations are written: the brackets decide, not the coordinates
  EXPECT_EQ(missing(canonical(h, "\"q2 + 2*p2 = 0\", \"p2 - 3*q2 = 0\"")), "");
}

TEST(WholeVariation, ALagrangianPlaneHasNone) {
  // q1' = p1 = 0 and p2' = -q1^2 = 0 on it
  EXPECT_THAT(missing("[system]\nkind = \"hamiltonian\"\ncoordinates = [\"a\", \"b\"]\n"
                      "momenta = [\"A\", \"B\"]\nparameters = [\"c\"]\n"
                      "hamiltonian = \"A*B + a*b^3 + a^2*A\"\n[[manifold]]\nname = \"m\"\n"
                      "equations = [\"a = 0\", \"B = 0\"]\nlevel = \"A^2/2 + b^4/4 = c\"\n"),
              HasSubstr("not studied: the coupling"));
}

std::string field(const std::string& x, const std::string& y, const std::string& w) {
  return "[system]\nkind = \"vector-field\"\ncoordinates = [\"x\", \"y\", \"w\"]\n"
         "[system.field]\nx = \"" +
         x + "\"\ny = \"" + y + "\"\nw = \"" + w +
         "\"\n[[manifold]]\nname = \"m\"\nequations = [\"y = 0\", \"w = 0\"]\n";
}

TEST(WholeVariation, TheFieldAlongTheCurveMayDependOnTheNormalDirections) {
  EXPECT_EQ(missing(field("1", "w", "x*y")), "");
  EXPECT_EQ(missing(field("1 + y^2", "w", "x*y")), ""); // not to the first order
  EXPECT_THAT(missing(field("1 + y", "w", "x*y")), HasSubstr("along the manifold"));
  EXPECT_THAT(missing(field("1 + x*w", "w", "x*y")), HasSubstr("along the manifold"));
}

/// A random symplectic change q = A x, p = A^-T y + S x of three degrees of freedom, A unipotent.
class SymplecticChange {
public:
  explicit SymplecticChange(unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_int_distribution<int> number(-2, 2);
    const int a = number(generator), b = number(generator), c = number(generator);
    const std::string x[] = {"x1", "x2", "x3"};
    q = {"x1 + (" + text(a) + ")*x2 + (" + text(b) + ")*x3", "x2 + (" + text(c) + ")*x3", "x3"};
    p = {"y1", "y2 - (" + text(a) + ")*y1",
         "y3 - (" + text(c) + ")*(y2 - (" + text(a) + ")*y1) - (" + text(b) + ")*y1"};
    for (std::size_t i = 0; i < 3; ++i) { // p += grad of a quadratic form of q
      const int s = number(generator);
      p[i] = "(" + p[i] + " + (" + text(s) + ")*(" + q[i] + "))";
      q[i] = "(" + q[i] + ")";
    }
  }
  std::vector<std::string> q, p;

private:
  static std::string text(int i) { return std::to_string(i); }
};

TEST(WholeVariation, ASymplecticChangeOfVariablesChangesNothing) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const SymplecticChange f(seed);
    const std::string h = f.p[0] + "^2/2 + " + f.p[1] + "*" + f.p[2] + " + " + f.q[0] + "^4/4 + " +
                          f.q[0] + "^2*" + f.q[1] + "*" + f.q[2];
    EXPECT_EQ(missing("[system]\nkind = \"hamiltonian\"\ncoordinates = [\"x1\", \"x2\", \"x3\"]\n"
                      "momenta = [\"y1\", \"y2\", \"y3\"]\nparameters = [\"h\"]\nhamiltonian = \"" +
                      h + "\"\n[[manifold]]\nname = \"m\"\nequations = [\"" + f.q[1] +
                      " = 0\", \"" + f.q[2] + " = 0\", \"" + f.p[1] + " = 0\", \"" + f.p[2] +
                      " = 0\"]\nlevel = \"H = h\"\n"),
              "")
        << seed << ": " << h;
  }
}

} // namespace
} // namespace kov
