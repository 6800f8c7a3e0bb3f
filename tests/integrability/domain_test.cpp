// The domain of the parameters is what the formulas need as they are written, however they cancel.

#include "integrability/parameters.hpp"
#include "integrability/specialise.hpp"

#include "exact/error.hpp"
#include "system/assumed_values.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::domain_test {
namespace {

using Texts = std::vector<std::string>;

System with(const std::string& h, const std::string& more = "",
            const ParameterValues& values = {}) {
  return read_system_as_assumed(
      parse_document(
          "[system]\nkind = \"hamiltonian\"\ncoordinates = [\"x\", \"y\"]\n"
          "momenta = [\"p\", \"q\"]\nparameters = [\"a\", \"b\", \"c\"]\nhamiltonian = \"" +
              h + "\"\n" + more,
          "test.toml"),
      values);
}

Texts domain(const System& s) {
  Texts all;
  for (const auto& list : s.domain.lists())
    all.push_back(in_words(list));
  std::sort(all.begin(), all.end());
  return all;
}

TEST(Domain, IsWhatTheFormulasNeed) {
  const std::map<std::string, Texts> known{{"p^2 + a*x^2 + b/2", {}},
                                           {"p^2 + 1/(1 + x^2 + y^2/a^2)", {"a != 0"}},
                                           {"p^2 + a/(a*x)", {"a != 0"}},
                                           {"p^2 + x/a - x/a", {"a != 0"}},
                                           {"p^2 + 1/(a*x + b*y)^2", {"a != 0 or b != 0"}},
                                           {"p^2 + (a*x + b*y)^(-3)", {"a != 0 or b != 0"}},
                                           {"p^2 + 1/(a*x + 1)", {}},
                                           {"p^2 + c/(a*b*x + b^2*y)", {"b != 0"}},
                                           {"p^2 + 1/((a - 1)*x)", {"a - 1 != 0"}},
                                           {"p^2 + 1/(a^2*x + a*b)", {"a != 0"}},
                                           {"p^2 + 1/((a - b)*(x - c))", {"a - b != 0"}},
                                           {"p^2 + log(a*x)", {"a != 0"}},
                                           {"p^2 + log(a*x + b)", {"a != 0 or b != 0"}},
                                           {"p^2 + log(c^2 + x^2 + y^2/a^2)", {"a != 0"}},
                                           {"p^2 + sqrt(a*x^2 + 1)", {}},
                                           {"p^2 + exp(x/a)", {"a != 0"}},
                                           {"p^2 + sqrt(x^2/b + y^2)", {"b != 0"}},
                                           {"p^2 + (x/b)^2/(1/c)", {"b != 0", "c != 0"}}};
  for (const auto& [h, expected] : known)
    EXPECT_EQ(domain(with(h)), expected) << h;
}

TEST(Domain, IsKeptWithValues) {
  EXPECT_EQ(domain(with("p^2 + 1/(a*x + b*y)", "", {{"a", "0"}})), Texts{"b != 0"});
  EXPECT_EQ(domain(with("p^2 + 1/(a*x + b*y)", "", {{"a", "2"}})), Texts{});
  EXPECT_EQ(domain(with("p^2 + x*b", "", {{"b", "1/c"}})), Texts{"c != 0"});
  EXPECT_EQ(domain(with("p^2 + x*b", "[assume]\nconditions = [\"a/b = 1\"]\n")), Texts{"a != 0"});
  EXPECT_EQ(domain(with("p^2 + x*b", "[assume]\nconditions = [\"c/(a - b) > 0\"]\n")),
            Texts{"a - b != 0"});
  // a claim may divide by anything
  EXPECT_EQ(domain(with("p^2 + x^2", "[[integral]]\nname = \"F\"\nvalue = \"p^2/a + x^2/a\"\n")),
            Texts{});
}

TEST(Domain, HasSpecialValues) {
  const System s = with("p^2 + 1/(a*x + b*y)");
  const auto at = [&](const std::vector<std::pair<std::string, long>>& values) {
    Substitution put;
    for (const auto& [name, value] : values)
      put[s.ring()->index(name)] = MFraction(s.ring(), Rational(value));
    return domain(at_values(s, put));
  };
  EXPECT_EQ(at({{"a", 0}}), Texts{"b != 0"});
  EXPECT_EQ(at({{"b", 3}}), Texts{});
  EXPECT_THROW(at({{"a", 0}, {"b", 0}}), DomainError);
}

// A function of a number is what the same file says with the number in it.
TEST(Specialise, AFunctionOfANumberIsANumber) {
  for (const std::string h :
       {"p^2 + sqrt(a*x^2 + 1)", "p^2 + sqrt(a*x^2 + 4)*y", "p^2 + exp(a*x)*y^2",
        "p^2 + cos(a*x)*y", "p^2 + y*sin(a*x) + cos(a*x)", "p^2 + sqrt(1 + sqrt(a*x + 9))",
        "p^2 + (1 + a*x)^(1/3)*y", "p^2 + tan(a*y)*x", "p^2 + cosh(a*x) + x"}) {
    const System s = with(h);
    const System there = at_values(s, {{s.ring()->index("a"), MFraction(s.ring())}});
    const System written = with(h, "", {{"a", "0"}});
    EXPECT_TRUE(there.field.functions.empty()) << h;
    EXPECT_EQ(to_string(*there.field.hamiltonian), to_string(*written.field.hamiltonian)) << h;
    EXPECT_TRUE(there.field.relations.empty()) << h;
  }
  const System s = with("p^2 + log(1 + a*x)*y");
  const System there = at_values(s, {{s.ring()->index("a"), MFraction(s.ring())}});
  EXPECT_EQ(to_string(*there.field.hamiltonian), "p^2");
}

} // namespace
} // namespace kov::domain_test
