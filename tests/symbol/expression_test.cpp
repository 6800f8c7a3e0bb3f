#include "symbol/expression.hpp"

#include "symbol/suggest.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using Kind = Expression::Kind;

// The tree as text with every grouping written out.
std::string shape(const Expression& e) {
  const auto list = [&](const char* separator) {
    std::string s;
    for (const Expression& x : e.operands())
      s += (s.empty() ? "" : separator) + shape(x);
    return "(" + s + ")";
  };
  switch (e.kind()) {
  case Kind::number:
    return to_string(e.number());
  case Kind::decimal:
  case Kind::name:
    return e.name();
  case Kind::sum:
    return list(" + ");
  case Kind::negate:
    return "(-" + shape(e.operand(0)) + ")";
  case Kind::product:
    return list("*");
  case Kind::quotient:
    return list("/");
  case Kind::power:
    return list("^");
  case Kind::call:
    return e.name() + list(", ");
  case Kind::derivative:
    return "D" + std::to_string(e.order()) + "(" + shape(e.operand(0)) + ")";
  case Kind::equation:
    return list(" = ");
  }
  return "?";
}

std::string shape(const std::string& text) { return shape(parse_expression(text, "-e", true)); }

TEST(Expression, Precedence) {
  const struct {
    const char* text;
    const char* tree;
  } table[] = {
      {"1+2*3", "(1 + (2*3))"},
      {"a-b-c", "(a + (-b) + (-c))"},
      {"a-(b-c)", "(a + (-(b + (-c))))"},
      {"a*b/c*d", "(((a*b)/c)*d)"},
      {"a/b/c", "((a/b)/c)"},
      {"2^3^2", "(2^(3^2))"},
      {"2**3**2", "(2^(3^2))"},
      {"-a^2", "(-(a^2))"},
      {"-a*b", "((-a)*b)"},
      {"2*-a^2", "(2*(-(a^2)))"},
      {"2^-3^2", "(2^(-(3^2)))"},
      {"2^-b*c", "((2^(-b))*c)"},
      {"--a", "(-(-a))"},
      {"+a - +b", "(a + (-b))"},
      {"1/2*z", "((1/2)*z)"},
      {"1/z^2", "(1/(z^2))"},
      {"(a+b)^2", "((a + b)^2)"},
      {"y''+p*y'", "(D2(y) + (p*D1(y)))"},
      {"y'^2", "(D1(y)^2)"},
      {"-y''", "(-D2(y))"},
      {"y''(z) = z*y(z)", "(D2(y(z)) = (z*y(z)))"},
      {"(z*y')' = 0", "(D1((z*D1(y))) = 0)"},
      {"diff(y, z, 2) = r*y", "(diff(y, z, 2) = (r*y))"},
      {"sqrt(2+sqrt(3))", "sqrt((2 + sqrt(3)))"},
      {"root(x^3-2, 1.26)+1", "(root(((x^3) + (-2)), 1.26) + 1)"},
      {" 00012 \n + z_1 ", "(12 + z_1)"},
  };
  for (const auto& [text, tree] : table)
    EXPECT_EQ(shape(text), tree) << text;
}

// The message with its caret, as a person sees it.
std::string complaint(const std::string& text, bool equation = true) {
  try {
    return shape(parse_expression(text, "-e", equation));
  } catch (const InputError& e) {
    return render(e);
  }
}

TEST(Expression, ErrorsHavePlaceCaretAndHint) {
  EXPECT_EQ(complaint("z + 0.5"),
            "-e:1:5: error: decimal number '0.5': only exact numbers are accepted\n"
            "    1 | z + 0.5\n"
            "      |     ^~~\n"
            "  note: write 1/2\n");
  EXPECT_EQ(complaint("1e3"),
            "-e:1:1: error: decimal number '1e3': only exact numbers are accepted\n"
            "    1 | 1e3\n"
            "      | ^~~\n"
            "  note: write 1000\n");
  EXPECT_EQ(complaint("2z"), "-e:1:2: error: a '*' is missing before 'z'\n"
                             "    1 | 2z\n"
                             "      |  ^\n"
                             "  note: products are written out: 2*z\n");
  EXPECT_EQ(complaint("(z+1)(z-1)"), "-e:1:6: error: a '*' is missing before '('\n"
                                     "    1 | (z+1)(z-1)\n"
                                     "      |      ^\n"
                                     "  note: products are written out: (z+1)*(...)\n");
  EXPECT_EQ(complaint("(z + 1"), "-e:1:1: error: this parenthesis is never closed\n"
                                 "    1 | (z + 1\n"
                                 "      | ^\n"
                                 "  note: a ')' is missing\n");
  EXPECT_EQ(complaint("z+\n1)"), "-e:2:2: error: this ')' closes nothing\n"
                                 "    2 | 1)\n"
                                 "      |  ^\n");
  EXPECT_EQ(complaint("z*"), "-e:1:3: error: the formula ends where a term is expected\n"
                             "    1 | z*\n"
                             "      |   ^\n");
  EXPECT_EQ(complaint("z \xE2\x88\x92 1"), "-e:1:3: error: unexpected character '\xE2\x88\x92'\n"
                                           "    1 | z \xE2\x88\x92 1\n"
                                           "      |   ^\n"
                                           "  note: write the ASCII sign -\n");
}

TEST(Expression, EveryMistakeHasAName) {
  const struct {
    const char* text;
    const char* says;
  } table[] = {
      {"", "a formula is missing"},
      {"  ", "a formula is missing"},
      {"*z", "a term is missing before '*'"},
      {"()", "a term is missing before ')'"},
      {"sqrt()", "'sqrt' has no argument"},
      {"root(x,)", "a term is missing before ')'"},
      {"z,1", "unexpected ','"},
      {"a=b=c", "a second '='"},
      {"a==b", "unexpected '=='"},
      {"(a=b)", "=' does not belong here"},
      {"1.5e-3", "write 3/2000"},
      {".5", "write 1/2"},
      {"5.", "write 5"},
      {"1e999999", "write it as a fraction of integers"},
      {"z % 2", "unexpected character '%'"},
      {"[z]", "use parentheses ( )"},
      {"y\"", "two primes"},
      {"z\xFF", "unexpected byte 0xff"},
  };
  for (const auto& [text, says] : table)
    EXPECT_NE(complaint(text, text != std::string("(a=b)")).find(says), std::string::npos)
        << text << "\n"
        << complaint(text);
  EXPECT_NE(complaint(std::string("z\0z", 3)).find("unexpected byte 0x00"), std::string::npos);
  EXPECT_NE(complaint("z = 1", false).find("does not belong"), std::string::npos);
}

TEST(Expression, HostileNestingIsRefused) {
  for (const std::string open : {"(", "-", "2^", "sqrt(", "2/("}) {
    std::string text;
    for (int i = 0; i < 100000; ++i)
      text += open;
    EXPECT_NE(complaint(text + "z").find("nested more than 400 deep"), std::string::npos) << open;
  }
  std::string quotients = "z";
  for (int i = 0; i < 100000; ++i)
    quotients += "/z";
  EXPECT_NE(complaint(quotients).find("nested more than"), std::string::npos);
  std::string sum = "z";
  for (int i = 0; i < 100000; ++i)
    sum += "+z";
  EXPECT_EQ(parse_expression(sum, "-e").operands().size(), 100001U);
  EXPECT_NE(complaint(std::string(5U << 20, 'z')).find("too long"), std::string::npos);
}

TEST(Expression, LongLinesAreCutAroundTheCaret) {
  const std::string text = std::string(5000, 'a') + " + 0.5 + " + std::string(5000, 'b');
  const std::string message = complaint(text);
  EXPECT_LT(message.size(), 600U);
  EXPECT_NE(message.find("0.5"), std::string::npos);
}

TEST(Suggest, NearestName) {
  const std::vector<std::string> names{"variable", "minpoly", "r", "p", "q", "ode"};
  EXPECT_EQ(nearest("varible", names), "variable");
  EXPECT_EQ(nearest("minploy", names), "minpoly");
  EXPECT_EQ(nearest("ODE", names), "ode");
  EXPECT_EQ(nearest("s", names), std::nullopt);
  EXPECT_EQ(nearest("whatever", names), std::nullopt);
}

} // namespace
} // namespace kov
