// A system at special values of its parameters.

#include "integrability/specialise.hpp"

#include "exact/error.hpp"
#include "integrability/eigenvalue.hpp"
#include "system/read_system.hpp"

#include <gtest/gtest.h>

#include <string>

namespace kov::specialise_test {
namespace {

// r^2 = x^2 + a y^2: at a = 0 it is r = x or r = -x, which are two systems.
TEST(SpecialValues, WhereRelationsFallApart) {
  const System s = read_system(parse_document(
      "system = {kind = 'hamiltonian', coordinates = ['x', 'y'], momenta = ['u', 'v'], "
      "parameters = ['a'], hamiltonian = '(u^2+v^2)/2 - 1/r', relations = ['r^2 = x^2 + a*y^2'], "
      "function = [{name = 'r', means = 'sqrt(x^2 + a*y^2)', "
      "derivative = {x = 'x/r', y = 'a*y/r'}}]}",
      "file.toml"));
  const auto at = [&](long a) {
    return at_values(s, {{s.ring()->index("a"), MFraction(s.ring(), Rational(a))}});
  };
  EXPECT_TRUE(at(4).field.parameters.empty());
  EXPECT_THROW(static_cast<void>(at(0)), DomainError);
}

// s^2 = a, with s in the place of a: nothing says what s is, though there is sqrt(x^2 + s^2 y^2).
TEST(SpecialValues, AConstantThatARootContainsIsFree) {
  for (const char* potential : {"-1/sqrt(x^2 + a*y^2)", "a*x^2*y^2"}) {
    const System s = read_system(parse_document(
        "system = {kind = 'hamiltonian', coordinates = ['x', 'y'], momenta = ['u', 'v'], "
        "parameters = ['a'], constants = ['s'], relations = ['s^2 = a'], hamiltonian = "
        "'(u^2 + v^2)/2 + " +
            std::string(potential) + "'}",
        "file.toml"));
    const MFraction root = MFraction::variable(s.ring(), "s");
    const System there = at_values(s, {{s.ring()->index("a"), root * root}});
    EXPECT_TRUE(there.field.constants.empty()) << potential;
    EXPECT_EQ(there.field.parameters, std::vector{s.ring()->index("s")}) << potential;
  }
}

// k^2 = a and l^2 = a + 2 are adjoined: what has a value, or is free, is none of the adjoined any more.
TEST(SpecialValues, AdjoinedConstantsThatAreGone) {
  const System s = read_system(parse_document(
      "system = {kind = 'hamiltonian', coordinates = ['x'], momenta = ['u'], parameters = ['a'], "
      "hamiltonian = 'u^2/2 + a*x^4'}",
      "file.toml"));
  const MPoly a = MPoly::variable(s.ring(), "a");
  const System one = with_square_root(s, a, "");
  const System two = with_square_root(
      one, transfer(MFraction(a), one.ring()).num() + MPoly(one.ring(), Integer(2)), "");
  ASSERT_EQ(two.adjoined.size(), 2U);
  const std::size_t k = two.field.constants[0], l = two.field.constants[1];
  const MFraction root = MFraction::variable(one.ring(), k), zero(two.ring());
  EXPECT_TRUE(
      at_values(one, {{one.ring()->index("a"), root * root}}).adjoined.empty()); // k is free
  const auto left = [&](const Substitution& values) { return at_values(two, values).adjoined; };
  EXPECT_EQ(left({}), two.adjoined);
  EXPECT_EQ(left({{two.ring()->index("a"), zero}, {k, zero}}), std::vector{two.adjoined[1]});
  EXPECT_EQ(left({{two.ring()->index("a"), MFraction(two.ring(), Rational(-2))}, {l, zero}}),
            std::vector{two.adjoined[0]});
}

// k^2 = a says that k is 0 where a is.
TEST(SpecialValues, AConstantThatHasToBeZero) {
  const System s = read_system(parse_document(
      "system = {kind = 'hamiltonian', coordinates = ['x'], momenta = ['u'], parameters = ['a', "
      "'b'], "
      "constants = ['k'], relations = ['k^2 = 2*a*b'], hamiltonian = 'u^2/2 + (a + b + k)*x^4'}",
      "file.toml"));
  const MFraction zero(s.ring());
  const System there = at_values(s, {{s.ring()->index("a"), zero}});
  EXPECT_TRUE(there.field.constants.empty());
  EXPECT_TRUE(there.field.relations.empty());
  EXPECT_EQ(there.field.parameters, std::vector{s.ring()->index("b")});
  EXPECT_EQ(to_string(*there.field.hamiltonian), "(2*x^4*b + u^2)/2");
  EXPECT_THROW(
      static_cast<void>(at_values(s, {{s.ring()->index("a"), MFraction(s.ring(), Rational(2))},
                                      {s.ring()->index("b"), MFraction(s.ring(), Rational(1))}})),
      DomainError); // k = 2 and k = -2
}

} // namespace
} // namespace kov::specialise_test
