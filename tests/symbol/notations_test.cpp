// Equations as other programs write them are the same tree as our own notation.

#include "symbol/notations.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov {
namespace {

using testing::HasSubstr;
using testing::Values;

using Kind = Expression::Kind;

// diff(f, x, x), diff(f, x, 2): the order; 0 for anything else.
long order_of_call(const Expression& e) {
  if (e.kind() != Kind::call || e.name() != "diff") return 0;
  long order = 0;
  for (std::size_t i = 1; i < e.operands().size(); ++i)
    order += e.operand(i).kind() == Kind::number ? to_long(e.operand(i).number()) - 1 : 1;
  return order;
}

// The shape and the names of a tree; two trees with one shape are one formula.
std::string shape(const Expression& e) {
  if (const long here = order_of_call(e); here > 0) {
    const long below = order_of_call(e.operand(0));
    const Expression& f = below > 0 ? e.operand(0).operand(0) : e.operand(0);
    return "(d" + std::to_string(here + below) + " " + shape(f) + ")";
  }
  static const std::vector<std::string> names = {"number", "decimal", "name", "+", "-", "*",
                                                 "/",      "^",       "call", "d", "="};
  if (e.kind() == Kind::number) return to_string(e.number());
  if (e.kind() == Kind::name) return e.name();
  std::string text = "(" + names.at(static_cast<std::size_t>(e.kind()));
  if (e.kind() == Kind::call || e.kind() == Kind::decimal) text += " " + e.name();
  if (e.kind() == Kind::derivative) text += std::to_string(e.order());
  for (const Expression& x : e.operands())
    text += " " + shape(x);
  return text + ")";
}

std::string shape_of(const std::string& text) { return shape(parse_ode(text, "-e")); }

std::string complaint(const std::string& text) {
  try {
    return "no complaint: " + shape_of(text);
  } catch (const InputError& e) {
    return e.message() + " / " + e.hint();
  }
}

struct Same {
  const char* name;
  const char* ours;
  std::vector<const char*> theirs;
};

void PrintTo(const Same& s, std::ostream* out) { *out << s.name; }

class Notation : public testing::TestWithParam<Same> {};

TEST_P(Notation, IsTheTreeOfOurOwn) {
  const std::string ours = shape_of(GetParam().ours);
  for (const char* text : GetParam().theirs)
    EXPECT_EQ(shape_of(text), ours) << text;
}

INSTANTIATE_TEST_SUITE_P(
    OfOtherPrograms, Notation,
    Values(Same{"Maple",
                "y''(x) = x*y(x)",
                {"diff(y(x), x, x) = x*y(x)", "diff(y(x), x$2) = x*y(x);",
                 "diff(diff(y(x), x), x) = x*y(x)", "(D@@2)(y)(x) = x*y(x)", "D(D(y))(x) = x*y(x)",
                 "Diff(y(x), x, x) = x*y(x)"}},
           Same{"Mathematica",
                "y''(x) = x*y(x)",
                {"y''[x] == x y[x]", "D[y[x], {x, 2}] == x*y[x]", "D[y[x], x, x] == x y[x]",
                 "Derivative[2][y][x] == x y[x]"}},
           Same{"Maxima", "y'' = x*y", {"'diff(y, x, 2) = x*y;", "'diff(y, x, 2) = x*y$"}},
           Same{"SymPy",
                "y''(x) = x*y(x)",
                {"Eq(Derivative(y(x), (x, 2)), x*y(x))", "Eq(y(x).diff(x, 2), x*y(x))",
                 "Eq(y(x).diff(x).diff(x), x*y(x))", "y(x).diff(x, x) == x*y(x)"}},
           Same{"Sage", "y''(x) = x*y(x)", {"derivative(y(x), x, 2) == x*y(x)"}},
           Same{"FirstOrder",
                "y'(x) = 1/4*y(x)",
                {"D[y[x], x] == 1/4 y[x]", "diff(y(x), x) = 1/4*y(x)", "D(y)(x) = 1/4*y(x)"}}),
    [](const auto& one) { return std::string(one.param.name); });

TEST(Notation, ConstantsOfOtherProgramsAreOurs) {
  EXPECT_EQ(shape_of("'diff(y, x, 2) = %i*y"), shape_of("y'' = I*y"));
  EXPECT_EQ(shape_of("y''[x] == Sqrt[2] y[x]"), shape_of("y''(x) = sqrt(2)*y(x)"));
}

// (Dx - a)(Dx + a) y = y'' + a' y - a^2 y: a product of operators is their composition.
TEST(Notation, OperatorsAreComposed) {
  EXPECT_THAT(shape_of("(Dx - x)*(Dx + x)"), testing::Not(HasSubstr("Dx")));
  EXPECT_NE(shape_of("(Dx - x)*(Dx + x)"), shape_of("(Dx + x)*(Dx - x)"));
  EXPECT_EQ(shape_of("Dx^2"), shape_of("Dx*Dx"));
  EXPECT_EQ(shape_of("(Dx + 1/x)^2"), shape_of("(Dx + 1/x)*(Dx + 1/x)"));
}

TEST(Notation, WhatIsNoEquationIsRefusedWithItsPlace) {
  for (const auto& [text, words] : std::vector<std::pair<const char*, const char*>>{
           {"y''[x] == x y(x)", "["},
           {"y''[x] == {x} y[x]", "{"},
           {"diff(y(x), x$99) = y(x)", "'$'"},
           {"'diff(y, x, 2) = %pi*y", "'%'"},
           {"Eq(Derivative(y(x), (x, 2)), y(x)", "never closed"},
           {"y'' === y", "single ="},
           {"Dx^2/x - 1/Dx", "not an operator"},
           {"Dx^99 - 1", "exponent"},
           {"(D@@x)(y)(x) = 0", "'@'"},
           {"Derivative[a][y][x] == 0", "products are written out"}})
    EXPECT_THAT(complaint(text),
                testing::AllOf(HasSubstr(words), testing::Not(HasSubstr("no complaint"))))
        << text;
}

} // namespace
} // namespace kov
