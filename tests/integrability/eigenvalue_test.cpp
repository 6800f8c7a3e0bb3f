// Variations that fall apart over an eigenvalue that is not a function of the parameters.

#include "integrability/eigenvalue.hpp"
#include "study/study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::eigenvalue_test {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

System with_roots(const std::string& text) {
  return with_eigenvalues(read_system(parse_document(text, "test.toml")), {});
}

// All manifolds of the system with its eigenvalues.
std::vector<ManifoldReport> run(const std::string& text) {
  std::vector<ManifoldReport> all;
  for (study::CurveStudy& m : study::study(parse_document(text, "test.toml"), {}).manifolds)
    all.push_back(std::move(m.first));
  return all;
}

std::string natural(const std::string& coordinates, const std::string& momenta,
                    const std::string& hamiltonian, const std::string& parameters = "") {
  return "[system]\nkind = 'hamiltonian'\ncoordinates = [" + coordinates + "]\nmomenta = [" +
         momenta + "]\nparameters = [" + parameters + "]\nhamiltonian = '" + hamiltonian + "'\n";
}

// Along the third axis of p^2/2 + z^4/4 + z^2 (a quadratic form) + ...
std::string axis(const std::string& form, const std::string& more = "",
                 const std::string& parameters = "") {
  return natural("'x', 'y', 'z'", "'u', 'v', 'w'",
                 "(u^2 + v^2 + w^2)/2 + z^4/4 + z^2*(" + form + ")" + more, parameters) +
         "[[manifold]]\nname = 'axis'\nequations = ['x = 0', 'y = 0', 'u = 0', 'v = 0']\n"
         "level = ['H = 1']\n";
}

const char* const ring_of_three =
    "(u^2 + v^2 + w^2)/2 + (x^4 + y^4 + z^4)/4 + a*((x - y)^4 + (y - z)^4 + (z - x)^4)/4";

TEST(Eigenvalue, OfThreeParticlesOnARing) {
  const std::string text = natural("'x', 'y', 'z'", "'u', 'v', 'w'", ring_of_three, "'a'") +
                           "[set]\na = 2\n"
                           "[[manifold]]\nname = 'm'\nequations = ['x = 0', 'y + z = 0', 'u = 0', "
                           "'v + w = 0']\nlevel = ['H = 1']\n"
                           "[[manifold]]\nname = 'n'\nequations = ['y = 0', 'x + z = 0', 'v = 0', "
                           "'u + w = 0']\nlevel = ['H = 1']\n";
  EXPECT_THAT(with_roots(text).adjoined, SizeIs(1)); // the second needs no other one
  for (const ManifoldReport& m : run(text)) {
    EXPECT_EQ(m.verdict, Verdict::non_integrable) << m.name;
    EXPECT_THAT(m.blocks, SizeIs(2));
  }
}

TEST(Eigenvalue, RationalOnesAreNotAdjoined) {
  EXPECT_THAT(with_roots(axis("5*x^2 + 2*y^2")).adjoined, SizeIs(0));
  EXPECT_THAT(with_roots(axis("7/2*x^2 + 3*x*y + 7/2*y^2")).adjoined, SizeIs(0));
  EXPECT_THAT(with_roots(axis("x^2 + x*y")).adjoined, SizeIs(1));
}

// What a form with the eigenvalues p and q says, a form with the eigenvalues p + q sqrt(d) does as
// well: 2 lambda is to be n (n - 1)/2 with a natural number n, or of the other kinds.
TEST(Eigenvalue, IsDecidedOverItsField) {
  for (const char* form : {"x^2 + x*y", "x^2 + 2*x*y - y^2", "3*x^2 + x*y - 2*y^2"}) {
    const auto m = run(axis(form)).at(0);
    EXPECT_EQ(m.verdict, Verdict::non_integrable) << form;
  }
}

// Garnier's system: integrable with any quadratic form.
TEST(Eigenvalue, NoFalseAlarm) {
  for (const char* form : {"x^2 + x*y", "x^2 + 3*x*y - 5*y^2", "x*y + y^2"}) {
    const auto m = run(axis("(x^2 + y^2)/2", " + (x^2 + y^2)^2/4 + " + std::string(form))).at(0);
    EXPECT_NE(m.verdict, Verdict::non_integrable) << form;
    EXPECT_THAT(m.blocks, SizeIs(2)) << form;
  }
}

TEST(Eigenvalue, OfDegreeThree) {
  const std::string text =
      natural("'x', 'y', 's', 'z'", "'u', 'v', 't', 'w'",
              "(u^2 + v^2 + t^2 + w^2)/2 + z^4/4 + z^2*(x^2 + x*y + y*s + 3*s^2)") +
      "[[manifold]]\nname = 'axis'\nequations = ['x = 0', 'y = 0', 's = 0', 'u = 0', 'v = 0', 't = "
      "0']\nlevel = ['H = 1']\n";
  EXPECT_THAT(with_roots(text).adjoined, testing::ElementsAre(HasSubstr("lambda^3")));
  EXPECT_EQ(run(text).at(0).verdict, Verdict::non_integrable);
}

// The root exists for all parameters: the polynomial has the leading coefficient 1.
TEST(Eigenvalue, IsIntegralOverTheParameters) {
  for (const char* form : {"a*x^2 + x*y", "x^2/a + x*y", "a*x^2 + (a^2 - 1)*x*y + y^2/(a + 3)"}) {
    const System s = with_roots(axis(form, "", "'a'"));
    ASSERT_THAT(s.adjoined, SizeIs(1)) << form;
    const std::size_t lambda = s.field.constants.back();
    EXPECT_TRUE(is_constant(coefficients(s.field.relations.back(), lambda).back())) << form;
  }
}

std::string with_two_roots(std::string text) {
  text.insert(text.find("hamiltonian ="),
              "constants = ['s', 't']\nrelations = ['s^2 = 2', 't^2 = 5']\n");
  return text;
}

// The eigenvalues are in Q(sqrt(10)), which the constants of the file contain: a root of their polynomial
// is not a new constant, and no quadratic constant gives it by itself.
TEST(Eigenvalue, NotAdjoinedWhereTheConstantsContainIt) {
  EXPECT_THAT(with_roots(with_two_roots(axis("x^2 + 3*x*y"))).adjoined, SizeIs(0));
  EXPECT_THAT(with_roots(axis("x^2 + 3*x*y")).adjoined, SizeIs(1));
}

// They are (1 +- sqrt(5))/2, (3 +- 2 sqrt(2))/2.
TEST(Eigenvalue, ByOneOfTwoConstants) {
  for (const char* form : {"x^2 + 2*x*y", "5/2*x^2 + 2*x*y + 1/2*y^2"}) {
    const std::string text = with_two_roots(axis(form));
    EXPECT_THAT(with_roots(text).adjoined, SizeIs(0)) << form;
    const ManifoldReport m = run(text).at(0);
    EXPECT_THAT(m.blocks, SizeIs(2)) << form;
    EXPECT_EQ(m.verdict, Verdict::non_integrable) << form;
  }
}

} // namespace
} // namespace kov::eigenvalue_test
