// Integrals made of Darboux polynomials, and commuting fields: known ones, without a hint.

#include "integrals/darboux.hpp"
#include "integrals/find.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace kov {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Components = std::vector<std::pair<std::string, std::string>>;

System field(const Components& components, const std::string& parameters = "",
             const std::string& more = "") {
  std::string names;
  std::string formulas;
  for (const auto& [x, formula] : components) {
    names += "'" + x + "', ";
    formulas += x + " = '" + formula + "'\n";
  }
  return read_system(parse_document("[system]\nkind = 'vector-field'\ncoordinates = [" + names +
                                        "]\nparameters = [" + parameters + "]\n[system.field]\n" +
                                        formulas + more,
                                    "test.toml"));
}

IntegralSearch integrable(const System& s, long degree = 2) {
  return find_integrals(s, {.degree = degree, .until_integrable = true});
}

std::vector<IntegralsOfSet> all_sets(const IntegralSearch& search) {
  auto all = search.sets;
  if (search.elsewhere) all.push_back(*search.elsewhere);
  return all;
}

/// The sets on which the system is integrable: equations, integrals and commuting fields.
std::vector<std::string> answers(const System& s, const IntegralSearch& search) {
  std::vector<std::string> all;
  for (const IntegralsOfSet& set : all_sets(search)) {
    if (!set.integrable(s.field)) continue;
    std::string text;
    for (const MPoly& f : set.equations)
      text += to_string(f) + " = 0, ";
    for (const FoundIntegral& f : set.integrals)
      text += to_string(f) + "; ";
    for (const auto& y : set.fields)
      text += field_text(s.field, y) + "; ";
    all.push_back(text);
  }
  return all;
}

TEST(Darboux, PredatorAndPrey) {
  const System s = field({{"x", "x*(a - b*y)"}, {"y", "y*(d*x - c)"}}, "'a', 'b', 'c', 'd'",
                         "[assume]\na = 'nonzero'\nb = 'nonzero'\nc = 'nonzero'\nd = 'nonzero'\n");
  EXPECT_THAT(answers(s, integrable(s)), Contains("x*d + y*b - c*log(x) - a*log(y); "));
}

TEST(Darboux, EpidemicAtAllParameters) {
  const System s = field({{"x", "-b*x*y"}, {"y", "b*x*y - c*y"}}, "'b', 'c'");
  const auto found = integrable(s);
  EXPECT_THAT(answers(s, found), Contains("x*b + y*b - c*log(x); "));
  for (const IntegralsOfSet& set : all_sets(found))
    EXPECT_TRUE(set.integrable(s.field)) << testing::PrintToString(set.integrals.size());
}

// Llibre, Zhang 2002.
TEST(Darboux, Roessler) {
  const System s =
      field({{"x", "-y - z"}, {"y", "x + a*y"}, {"z", "b - c*z + x*z"}}, "'a', 'b', 'c'");
  EXPECT_THAT(answers(s, integrable(s)),
              ElementsAre("c = 0, b = 0, a = 0, x^2 + y^2 + 2*z; y - log(z); "));
}

TEST(Darboux, RikitakeWithoutFriction) {
  const System s = field({{"x", "y*z"}, {"y", "x*z"}, {"z", "1 - x*y"}});
  EXPECT_THAT(answers(s, integrable(s)), ElementsAre("x^2 - y^2; x^2 + z^2 - 2*log(x + y); "));
}

// Leach, Miritzis 2006: x*y*z/(x + y + z)^3 for a + b = 2.
TEST(Darboux, MayLeonard) {
  const System s = field({{"x", "x*(1 - x - a*y - b*z)"},
                          {"y", "y*(1 - b*x - y - a*z)"},
                          {"z", "z*(1 - a*x - b*y - z)"}},
                         "'a', 'b'", "[assume]\nconditions = ['a + b = 2', 'b != 1']\n");
  const auto all = answers(s, integrable(s));
  EXPECT_EQ(all.size(), all_sets(integrable(s)).size());
  for (const std::string& answer : all)
    EXPECT_THAT(answer, AllOf(HasSubstr("(x + y + z)^3/(z*y*x); "), HasSubstr("d/dx")));
}

// Moulin Ollagnier 2001: A*B*C + 1 = 0.
TEST(Darboux, LotkaVolterraInSpace) {
  const System s =
      field({{"x", "x*(C*y + z)"}, {"y", "y*(A*z + x)"}, {"z", "z*(B*x + y)"}}, "'A', 'B', 'C'",
            "[assume]\nconditions = ['A*B*C + 1 = 0', 'A != -1', 'A != -1/2', "
            "'A != -2', 'A != 1', 'C^2 != 1', 'C^2 != 4', '4*C^2 != 1']\n");
  EXPECT_THAT(answers(s, integrable(s, 1)),
              Contains("A*B*C + 1 = 0, x*A*B + y - z*A; -A*log(x) + log(y) + A*C*log(z); "));
}

TEST(CommutingFields, NoseHooverWithoutBath) {
  const System s = field({{"x", "y"}, {"y", "-x - y*z"}, {"z", "a*(y^2 - 1)"}}, "'a'");
  EXPECT_THAT(answers(s, integrable(s)), ElementsAre("a = 0, z; x*d/dx + y*d/dy; "));
}

// Kozlov's case has a rotation.
TEST(CommutingFields, Suslov) {
  const System s =
      field({{"p", "g2"}, {"q", "-g1/m"}, {"g1", "-g3*q"}, {"g2", "g3*p"}, {"g3", "g1*q - g2*p"}},
            "'m'", "[assume]\nm = 'positive'\n");
  EXPECT_THAT(answers(s, integrable(s)),
              ElementsAre("m - 1 = 0, p*g1 + q*g2; g1^2 + g2^2 + g3^2; p^2 + q^2 + 2*g3; "
                          "-q*d/dp + p*d/dq - g2*d/dg1 + g1*d/dg2; "));
}

// A linear field commutes with x d/dx + ..., and all that commutes with it has to do so mutually.
TEST(CommutingFields, OfALinearField) {
  const System s = field({{"x", "x + y"}, {"y", "-x + y + z"}, {"z", "3*z + x"}});
  const auto found = integrable(s);
  const auto sets = all_sets(found);
  ASSERT_EQ(sets.size(), 1);
  EXPECT_TRUE(sets.front().integrable(s.field));
  const auto& fields = sets.front().fields;
  for (const auto& y : fields)
    for (const auto& z : fields)
      for (const MFraction& f : commutator(s.field, y, z))
        EXPECT_TRUE(is_zero(f));
}

// Lorenz has no integral, and nothing that commutes, for most parameters.
TEST(CommutingFields, NoneIsInvented) {
  const System s = field({{"x", "10*(y - x)"}, {"y", "28*x - y - x*z"}, {"z", "x*y - 8/3*z"}});
  const auto found = integrable(s);
  EXPECT_THAT(answers(s, found), IsEmpty());
}

// A Darboux polynomial that is 0 for some parameters has no logarithm there.
TEST(Darboux, PolynomialsThatVanish) {
  const System s = field({{"x", "b + x*(a*x + b*y)"}, {"y", "-a + y*(a*x + b*y)"}}, "'a', 'b'");
  for (const IntegralsOfSet& set : all_sets(integrable(s))) {
    Set where(s.ring(), s.field.parameters);
    for (const MPoly& f : set.equations)
      where = where.where_zero(f);
    for (const FoundIntegral& i : set.integrals) {
      for (const LogarithmicTerm& t : i.logarithms)
        EXPECT_FALSE(is_zero(where.restrict(t.of)));
      EXPECT_FALSE(is_zero(where.restrict(i.value.den())));
    }
  }
}

// A cofactor that is a quotient has no value where its denominator is 0: a line through the origin
// that is invariant for other parameters is taken for none there.
TEST(Darboux, LinearFieldsOfThePlane) {
  const Components all[] = {{{"x", "y - x"}, {"y", "b*x + a*y"}},
                            {{"x", "a*x + b*y"}, {"y", "c*x + d*y"}},
                            {{"x", "a*x + y"}, {"y", "a*b*x - y"}}};
  for (const Components& components : all) {
    const System s = field(components, "'a', 'b', 'c', 'd'");
    EXPECT_FALSE(answers(s, integrable(s)).empty());
  }
}

// f1 f2 rot(g + l1 log f1 + l2 log f2), with random lines, numbers and g.
TEST(Darboux, RandomFieldsOfThePlane) {
  std::mt19937 random(7);
  const auto number = [&] { return std::to_string(std::uniform_int_distribution(1, 5)(random)); };
  const auto line = [&] { return "(" + number() + "*x - " + number() + "*y + " + number() + ")"; };
  for (int i = 0; i < 12; ++i) {
    const System parts = field({{"x", line()}, {"y", line()}});
    const MFraction f1 = parts.field.components[0];
    const MFraction f2 = parts.field.components[1];
    const MFraction x = MFraction::variable(parts.ring(), "x");
    const FoundIntegral made{.value = Rational(i % 3) * x * x - MFraction(f2) * MFraction(f1) + x,
                             .logarithms = {{Rational(1 + i % 5) * (x / x), f1.num()},
                                            {Rational(-2 - i % 4, 3) * (x / x), f2.num()}}};
    const auto d = gradient(parts.field, made);
    const System s = field({{"x", to_string(d[1] * f1 * f2)}, {"y", to_string(-(d[0] * f1 * f2))}});
    EXPECT_EQ(answers(s, integrable(s, 1)).size(), 1) << to_string(made);
  }
}

// Nothing is expanded that fills the memory.
TEST(Darboux, ImmenseDegrees) {
  const System s = field({{"x", "(x + y + z)^2 + x^60*y^3"},
                          {"y", "z^55 - x*w"},
                          {"z", "w^70 + y*v"},
                          {"w", "x*v^40"},
                          {"v", "x + y^66"}});
  const PhaseSpace p(s);
  const Set all(s.ring(), {});
  EXPECT_TRUE(darboux_polynomials(p, *polynomial_field(p), all, Budget::of_seconds(20)).size() < 6);
}

// A rational field has the integrals of its polynomial multiples; commuting fields it has not.
TEST(Darboux, RationalFields) {
  const auto of = [](const Components& components, const std::string& parameters = "") {
    const System s = field(components, parameters);
    return answers(s, integrable(s));
  };
  EXPECT_THAT(of({{"x", "v"}, {"v", "1/x"}}), ElementsAre("v^2 - 2*log(x); "));
  EXPECT_EQ(of({{"x", "v"}, {"v", "-1/(x - 2)"}}).size(), 1);
  EXPECT_EQ(of({{"x", "v/(x + y)"}, {"y", "x/(x + y)"}, {"v", "0"}}).size(), 1);
  // with a parameter: also where it is 0
  const System s = field({{"x", "v"}, {"v", "a/x + b*x"}}, "'a', 'b'");
  for (const IntegralsOfSet& set : all_sets(integrable(s)))
    EXPECT_TRUE(set.integrable(s.field));
  // an integral of the multiple by x, and a field that commutes with that alone
  const System multiple = field({{"x", "y/x"}, {"y", "(2*y + x^3)/x"}});
  for (const IntegralsOfSet& set : all_sets(integrable(multiple)))
    for (const auto& y : set.fields)
      for (const MFraction& f : commutator(multiple.field, multiple.field.components, y))
        EXPECT_TRUE(is_zero(f));
}

} // namespace
} // namespace kov
