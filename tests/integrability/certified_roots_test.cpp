// Systems with roots: the way to r(z) has a certificate, whether a root is written or declared, and
// however the derivative of a declared one is written.

#include "certify/system/check.hpp"
#include "integrability/certificate.hpp"
#include "integrability/conclude.hpp"
#include "integrability/way.hpp"
#include "support/checked.hpp"

#include <gmock/gmock.h>

namespace kov::certified_roots_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

struct Studied {
  System system;
  ManifoldReport report;
};

Studied study(const std::string& hamiltonian, const std::string& more = "",
              const std::string& equations = "") {
  const std::string text = "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\n"
                           "momenta = ['px', 'py']\nhamiltonian = '(px^2 + py^2)/2 + " +
                           hamiltonian + "'\n" + more +
                           "[[manifold]]\nname = 'plane'\nequations = ['y = 0', 'py = 0'" +
                           equations + "]\nlevel = ['H = 1']\n";
  Studied s{read_system(parse_document(text, "test.toml")), {}};
  CheckOptions options;
  options.decide.want_certificate = true;
  options.decide.want_solutions = false;
  s.report = test::checked(study::FileStudy(s.system), options);
  return s;
}

// Not integrable, all of it in one certificate that says so.
void expect_a_whole_proof(const Studied& s) {
  EXPECT_EQ(s.report.verdict, Verdict::non_integrable);
  EXPECT_THAT(trusted_steps(s.report), IsEmpty());
  const auto all = certificates(s.system, s.report);
  ASSERT_EQ(all.size(), 1U);
  ASSERT_EQ(all[0].none, "");
  ASSERT_EQ(certify::format_of(all[0].json), "kovacic-system/1");
  const auto verdict = certify::check_way(certify::read_system_certificate(all[0].json));
  const auto* accepted = std::get_if<certify::SystemAccepted>(&verdict);
  ASSERT_NE(accepted, nullptr) << std::get<certify::Rejected>(verdict).why;
  EXPECT_EQ(accepted->trusted, 0U);
  EXPECT_TRUE(accepted->not_integrable);
}

class Written : public testing::TestWithParam<const char*> {};

TEST_P(Written, HasACertificate) { expect_a_whole_proof(study(GetParam())); }

INSTANTIATE_TEST_SUITE_P(
    Roots, Written,
    testing::Values("sqrt(1 + x^2 + 2*y^2)", "-1/sqrt(x^2 + 2*y^2)", "sqrt(x)*(1 + y^2)",
                    "(x^2 + 2*y^2)^(-3/2)", "x^2 + (1 + x^2)^(1/3)*y^2",
                    "x^2 + sqrt(1 + sqrt(1 + x^2))*y^2", "x^2 + sqrt((1 + x^2)/(2 + x^2))*y^2",
                    "x^2 + x^(-3/2)*y^2", "1/sqrt(x^2 + 1) + 1/sqrt(x^2 + y^2 + 1)",
                    "cos(x) + sqrt(2 + cos(x))*y^2", "x^2 + sqrt(x + y)*sqrt(x - y)*y^2",
                    // algebraic constants in one field, beside roots and alone
                    "x^2 + sqrt(3)*x^2*y^2", "x^2 + sqrt(3)*x^2*y^2 + sqrt(2)*y^2",
                    "x^2 + 2^(1/3)*x^2*y^2 + sqrt(2)*y^2",
                    "x^2 + sqrt(3)*x^2*y^2 + sqrt(2)*sqrt(1 + x^2)*y^2"));

// sqrt(a) is a parameter of the strata.
TEST(WrittenOfAParameter, HasACertificate) {
  const Studied s = study("x^2 + sqrt(a)*x^2*y^2", "parameters = ['a']\n");
  EXPECT_THAT(trusted_steps(s.report), IsEmpty());
  const auto all = certificates(s.system, s.report);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].none, "");
  EXPECT_EQ(certify::format_of(all[0].json), "kovacic-system/1");
}

// The derivative of r = sqrt(h) in each form that is right modulo r^2 = h.
TEST(Declared, HasACertificateInEachForm) {
  for (const char* derivative :
       {"{ x = 'x/r', y = '2*y/r' }",
        "{ x = 'x*r/(1 + x^2 + 2*y^2)', y = '2*y*r/(1 + x^2 + 2*y^2)' }",
        "{ x = 'x/r', y = '2*y*r/(1 + x^2 + 2*y^2)' }", "{ x = 'x*r/r^2', y = '2*y*r^3/r^4' }"}) {
    SCOPED_TRACE(derivative);
    expect_a_whole_proof(
        study("r", std::string("relations = ['r^2 = 1 + x^2 + 2*y^2']\n[[system.function]]\n"
                               "name = 'r'\nmeans = 'sqrt(1 + x^2 + 2*y^2)'\nderivative = ") +
                       derivative + "\n"));
  }
}

TEST(Declared, HasACertificateForASineWithAnOddDerivative) {
  for (const char* derivative : {"'c'", "'(1 - s^2)/c'"}) {
    SCOPED_TRACE(derivative);
    expect_a_whole_proof(
        study("c + (2 + s)*y^2",
              std::string("relations = ['s^2 + c^2 = 1']\n[[system.function]]\nname = 's'\n"
                          "means = 'sin(x)'\nderivative = { x = ") +
                  derivative +
                  " }\n[[system.function]]\nname = 'c'\nmeans = 'cos(x)'\n"
                  "derivative = { x = '-s' }\n"));
  }
}

// A gradient that is closed modulo a relation only: there is no rule, which is told; nothing is
// refused, and nothing is lost.
TEST(Declared, WithoutARuleIsAStepOnTrust) {
  // l = arctan(x*y), k = 1 + x^2*y^2
  const Studied s = study("x^2 + x^2*y^2 + y*l",
                          "relations = ['k = 1 + x^2*y^2']\n[[system.function]]\nname = 'k'\n"
                          "derivative = { x = '2*x*y^2', y = '2*x^2*y' }\n"
                          "[[system.function]]\nname = 'l'\n"
                          "derivative = { x = 'y/k', y = 'x/(1 + x^2*y^2)' }\n",
                          ", 'l = 0'");
  EXPECT_EQ(s.report.verdict, Verdict::non_integrable);
  EXPECT_THAT(trusted_steps(s.report), testing::SizeIs(1));
  for (const BlockReport& b : s.report.blocks)
    EXPECT_TRUE(!b.no_way || b.no_way->why != NoWay::Why::refused) << b.no_way->of;
}

// What our own checker refuses is withdrawn, whatever was found.
TEST(Refused, WaysTakeTheAnswerBack) {
  Studied s = study("sqrt(1 + x^2 + 2*y^2)");
  ASSERT_EQ(s.report.verdict, Verdict::non_integrable);
  s.report.blocks[0].no_way = NoWay{NoWay::Why::refused, "S1: a reason"};
  withdraw_refused(s.report.blocks);
  conclude(s.system, {}, s.report);
  EXPECT_EQ(s.report.verdict, Verdict::undecided);
  EXPECT_EQ(statement(s.report), "");
  EXPECT_THAT(reasons(s.report).back(), HasSubstr("our own checker refuses the way from the system "
                                                  "to r(z): S1: a reason"));
}

} // namespace
} // namespace kov::certified_roots_test
