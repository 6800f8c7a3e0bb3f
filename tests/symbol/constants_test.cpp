#include "symbol/rational_form.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

struct Read {
  Constants constants;
  RationalFunction value;
};

Read read(const std::string& text, Constants constants = Constants()) {
  const Expression e = parse_expression(text, "-r");
  constants.gather(std::span(&e, 1));
  RationalFunction f =
      rational_function(e, {.variable = "z", .constants = &constants, .budget = {}});
  return {std::move(constants), std::move(f)};
}

std::string complaint(const std::string& text) {
  try {
    return to_string(read(text).value);
  } catch (const InputError& e) {
    return render(e);
  } catch (const OutOfBudget& e) {
    return e.what();
  }
}

TEST(RationalForm, Values) {
  const struct {
    const char* text;
    const char* value;
  } table[] = {
      {"z", "z"},
      {"(z^2-1)/(2*(z-1))", "(z + 1)/2"},
      {"-3/(16*z^2)", "-3/(16*z^2)"},
      {"-z^2", "-z^2"},
      {"2^3^2", "512"},
      {"2**-2", "1/4"},
      {"z^-2*z^3", "z"},
      {"(1+z)^3 - z^3 - 1", "3*z^2 + 3*z"},
      {"1/z + 1/(z-1) - 1/(z^2-z)", "2/z"},
      {"z^(4/2)", "z^2"},
      {"(z+1)^0", "1"},
      {"I^2", "-1"},
      {"I*z", "I*z"},
      {"sqrt(4)*z", "2*z"},
      {"sqrt(8)", "2*sqrt(2)"},
      {"1/sqrt(2)", "sqrt(2)/2"},
      {"sqrt(-4)", "2*I"},
      {"(1+sqrt(5))/2", "(sqrt(5) + 1)/2"},
      {"2^(1/2)", "sqrt(2)"},
      {"4^(-1/2)", "1/2"},
      {"8^(2/3)", "4"},
      {"root(x^3-2, 1.26)^3", "2"},
      {"root(x^3-2, 1.26)*z", "root(x^3-2,1.26)*z"},
      {"root(x^2-x-1, 1.6)", "(sqrt(5) + 1)/2"},
      {"root(x^4-1, -0.1+0.9*I)", "I"},
      {"root(3*x-2)", "2/3"},
      {"root(2*x^3-1, 0.8)", "root(2*x^3-1,0.8)"},
  };
  for (const auto& [text, value] : table)
    EXPECT_EQ(complaint(text), value) << text;
}

// Each expression is zero, and says so exactly.
TEST(Constants, ZerosAreRecognised) {
  for (const char* text : {
           "sqrt(2)*sqrt(3)-sqrt(6)",
           "sqrt(2+sqrt(3))-(sqrt(6)+sqrt(2))/2",
           "sqrt(5+2*sqrt(6))-sqrt(2)-sqrt(3)",
           "root(x^3-2,1.26)^2*root(x^3-2,1.26)-2",
           "root(x^3-2,-0.63+1.09*I)-root(x^3-2,1.26)*(-1+sqrt(-3))/2",
           "root(x^3-2,1.26)+root(x^3-2,-0.6+1.1*I)+root(x^3-2,-0.6-1.1*I)",
           "sqrt(-1)-I",
           "sqrt(root(x^3-2,1.26))^6-2",
           "root(x^2-2,1.4)*root(a^2-2,1.4)-2",
           "sqrt(I)-(1+I)/sqrt(2)",
           "sqrt(-I)-(1-I)/sqrt(2)",
           "sqrt(-2)-I*sqrt(2)",
           "(-8)^(1/3)-1-sqrt(-3)",
           "2^(1/3)*4^(1/3)-2",
           "root(x^5-x-1,1.17)^5-root(x^5-x-1,1.17)-1",
           "sqrt(2)*sqrt(3)*sqrt(5)-sqrt(30)",
           "root(x^4-10*x^2+1,3.1)-sqrt(2)-sqrt(3)",
           "root(x^4-10*x^2+1,-0.3)-sqrt(2)+sqrt(3)",
           "I*sqrt(2)*root(x^3-2,1.26)-root(x^6+32,1.8*I)",
       })
    EXPECT_EQ(complaint(text), "0") << text;
}

TEST(Constants, NonZerosStayNonZero) {
  for (const char* text : {"sqrt(2)*sqrt(3)+sqrt(6)", "sqrt(2)-root(x^2-2,-1.4)",
                           "root(x^3-2,1.26)-root(x^3-2,-0.63+1.09*I)"})
    EXPECT_NE(complaint(text), "0") << text;
}

TEST(Constants, FieldsAndTheirNames) {
  const struct {
    const char* text;
    long degree;
    const char* name;
    const char* definition;
  } table[] = {
      {"z", 1, "", ""},
      {"sqrt(9)", 1, "", ""},
      {"I", 2, "I", "root(x^2 + 1, 1.00000000*I)"},
      {"sqrt(12)", 2, "sqrt(3)", "root(x^2 - 3, 1.73205081)"},
      {"sqrt(-12)", 2, "sqrt(-3)", "root(x^2 + 3, 1.73205081*I)"},
      {"root(x^3-2, 1.26)", 3, "root(x^3-2,1.26)", "root(x^3 - 2, 1.25992105)"},
      {"sqrt(2+sqrt(3))", 4, "sqrt(2+sqrt(3))", "root(x^4 - 4*x^2 + 1, 1.93185165)"},
      {"sqrt(2)+I", 4, "a", ""},
      {"sqrt(2)+sqrt(3)+sqrt(6)", 4, "a", ""},
      {"sqrt(2)*root(x^3-2,1.26)", 6, "a", ""},
      {"root(x^3-2,1.26)+root(x^3-2,-0.6+1.1*I)", 6, "a", ""},
  };
  for (const auto& [text, degree, name, definition] : table) {
    const Read r = read(text);
    EXPECT_EQ(r.constants.field()->degree(), degree) << text;
    EXPECT_EQ(r.constants.field()->name(), name) << text;
    if (*definition != '\0') {
      EXPECT_EQ(r.constants.definition(), definition) << text;
    }
  }
}

TEST(Constants, PrintedValuesReadBack) {
  for (const char* text : {"I*z/(z^2+2*I)", "sqrt(2)*z+1/(3*z-sqrt(2))", "sqrt(2+sqrt(3))/z^3",
                           "root(2*x^3-1,0.8)^2*z-1/root(2*x^3-1,0.8)", "(2^(1/3))^2*z",
                           "2^(41/3)*z", "(1+2)^(2/3)*z^2+z", "z*(2*sqrt(2))^(-1/3)"}) {
    const Read once = read(text);
    const std::string printed = to_string(once.value);
    const Read twice = read(printed);
    EXPECT_EQ(to_string(twice.value), printed) << text;
    EXPECT_EQ(twice.constants.field()->minpoly_coefficients(),
              once.constants.field()->minpoly_coefficients());
  }
  // a generator with a letter is read back through its definition
  const Read r = read("(sqrt(2)+I)*z");
  const std::string again = to_string(r.value);
  Constants c;
  c.define_value("a", parse_expression(r.constants.definition(), "constants"));
  const Read back = read(again + " - (sqrt(2)+I)*z", c);
  EXPECT_TRUE(is_zero(back.value));
}

TEST(Constants, NamedGenerator) {
  Constants c;
  c.define_root("a", parse_expression("a^2 - a - 1", "--minpoly"));
  EXPECT_EQ(to_string(read("(a^3+z)/a", c).value), "(a - 1)*z + (a + 1)");
  Constants half;
  half.define_root("a", parse_expression("2*a^2 - 1", "--minpoly"));
  EXPECT_EQ(to_string(read("a^2*z", half).value), "z/2");
  EXPECT_EQ(to_string(read("a*z", half).value), "a*z");
  Constants linear;
  linear.define_root("a", parse_expression("3*a - 2", "--minpoly"));
  EXPECT_EQ(to_string(read("a*z", linear).value), "2*z/3");
  // together with other constants: of the real roots the largest
  Constants mixed;
  mixed.define_root("a", parse_expression("a^2 - 2", "--minpoly"));
  EXPECT_EQ(to_string(read("a - sqrt(2)", mixed).value), "0");
  EXPECT_EQ(to_string(read("a*I - sqrt(-2)", mixed).value), "0");
}

std::string minpoly_complaint(const std::string& text) {
  try {
    Constants c;
    c.define_root("a", parse_expression(text, "--minpoly"));
    return "accepted";
  } catch (const InputError& e) {
    return e.message() + " | " + e.hint();
  }
}

TEST(Constants, BadMinimalPolynomials) {
  EXPECT_EQ(minpoly_complaint("a^2 - 1"),
            "the minimal polynomial of 'a' is reducible | it is a multiple of (a - 1)*(a + 1); "
            "write one of its factors");
  EXPECT_EQ(minpoly_complaint("(a^2+1)^2"),
            "the minimal polynomial of 'a' is reducible | it is a multiple of (a^2 + 1)^2; write "
            "one of its factors");
  EXPECT_NE(minpoly_complaint("7").find("is constant"), std::string::npos);
  EXPECT_NE(minpoly_complaint("b^2-2").find("unknown name 'b'"), std::string::npos);
  EXPECT_NE(minpoly_complaint("1/a").find("not a polynomial"), std::string::npos);
  EXPECT_NE(minpoly_complaint("a^30-2").find("larger than the limit"), std::string::npos);
}

TEST(RationalForm, Errors) {
  const struct {
    const char* text;
    const char* says;
  } table[] = {
      {"1/0", "division by zero"},
      {"1/(z-z)", "division by zero"},
      {"0^-1", "division by zero"},
      {"1/(sqrt(2)*sqrt(3)-sqrt(6))", "division by zero"},
      {"x", "unknown name 'x'"},
      {"Z", "did you mean z?"},
      {"Pi", "constants are algebraic numbers"},
      {"i*z", "the imaginary unit is I"},
      {"z^z", "the exponent is not an integer"},
      {"z^(1/2)", "'z' is not a constant, so this root is not a rational function"},
      {"sqrt(z)", "'z' is not a constant, so this root is not a rational function"},
      {"z^I", "the exponent is not an integer"},
      {"sin(z)", "'sin' is not a rational function"},
      {"squrt(2)", "did you mean sqrt?"},
      {"z(z+1)", "products are written out: z*(...)"},
      {"sqrt(1,2)", "sqrt has one argument"},
      {"root(x^2-2)", "which of the 2 roots is meant"},
      {"root(x^2-2, 0)", "two roots are equally near"},
      {"root(5, 1)", "this polynomial is constant"},
      {"root(x*y, 1)", "a polynomial in one variable is expected"},
      {"root(x^2-2, z)", "this is not an approximation"},
      {"z'", "a derivative does not belong here"},
      {"diff(z,z)", "a derivative does not belong here"},
      {"sqrt(2)+sqrt(3)+sqrt(5)+sqrt(7)+sqrt(11)", "the number field has degree 32"},
      {"2^(1/1000)", "this root may have a degree above 200"},
  };
  for (const auto& [text, says] : table)
    EXPECT_NE(complaint(text).find(says), std::string::npos) << text << "\n" << complaint(text);
}

TEST(RationalForm, HostileSizesEndInALimit) {
  for (const char* text : {
           "z^1000000000",
           "(z+1)^(10^9)",
           "2^(10^12)",
           "2^(10^30)",
           "z^(10^30)",
           "(z+1)^100000",
           "((z+1)^10000)^10",
           "(2^(10^9)+z)^10",
           "1/(z+3)^1000000",
           "10^10^10^10",
           "(1/3)^(10^11)",
           "z^90000*z^90000",
           "z^-1000000",
           "(I+1)^(10^12)",
       })
    EXPECT_NE(complaint(text).find("limit"), std::string::npos) << text;
  EXPECT_EQ(complaint("1^(10^30)"), "1");
  EXPECT_EQ(complaint("(-1)^(10^30+1)"), "-1");
  EXPECT_EQ(complaint("0^(10^30)"), "0");
  EXPECT_EQ(complaint("z^99999"), "z^99999");
}

} // namespace
} // namespace kov
