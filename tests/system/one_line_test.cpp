// A system from one formula: which letters move is guessed from how people call them.

#include "system/one_line.hpp"

#include "symbol/document.hpp"
#include "symbol/input_error.hpp"
#include "system/read_system.hpp"

#include <gmock/gmock.h>

namespace kov::one_line_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Case {
  const char* formula;
  Mechanics kind;
  std::vector<std::string> coordinates, rates, parameters;
};

constexpr auto H = Mechanics::hamiltonian, L = Mechanics::lagrangian;

const std::vector<Case> cases = {
    {"(p1^2 + p2^2)/2 + q1^2*q2 + b*q2^3/3", H, {"q1", "q2"}, {"p1", "p2"}, {"b"}},
    {"(p_x^2 + p_y^2)/2 + a*x^2*y^2", H, {"x", "y"}, {"p_x", "p_y"}, {"a"}},
    {"(px^2 + py^2 + pz^2)/2 - mu/sqrt(x^2 + y^2 + z^2)",
     H,
     {"x", "y", "z"},
     {"px", "py", "pz"},
     {"mu"}},
    {"(p1^2 + p2^2)/2 + x^2*y", H, {"x", "y"}, {"p1", "p2"}, {}},
    {"(p1^2 + p2^2 + p3^2)/2 + g/(x1-x2)^2 + g/(x2-x3)^2",
     H,
     {"x1", "x2", "x3"},
     {"p1", "p2", "p3"},
     {"g"}},
    {"p^2/(2*m) + k*x^2/2", H, {"x"}, {"p"}, {"k", "m"}},
    {"p^2/2 - cos(q)", H, {"q"}, {"p"}, {}},
    {"p^2/2 - cos(theta)", H, {"theta"}, {"p"}, {}},
    {"pr^2/2 + pphi^2/(2*r^2) - 1/r", H, {"phi", "r"}, {"pphi", "pr"}, {}}, // phi is cyclic
    {"p1^2/2 + p2^2/2 + q1^4", H, {"q1", "q2"}, {"p1", "p2"}, {}},          // q2 is cyclic
    {"(p10^2 + p2^2)/2 + q2*q10", H, {"q2", "q10"}, {"p2", "p10"}, {}},
    {"psi*x^2 + px^2/2 + phi*x + p0*x", H, {"x"}, {"px"}, {"p0", "phi", "psi"}},
    {"I^2/2 + cos(theta)", H, {"theta"}, {"I"}, {}},
    {"I1^2/2 + I2^2/2 + cos(th1 - th2)", H, {"th1", "th2"}, {"I1", "I2"}, {}},
    {"J^2/2 + p^2/2 + cos(q) + cos(phi)", H, {"phi", "q"}, {"J", "p"}, {}},
    {"L^2/2 - cos(theta)", H, {"theta"}, {"L"}, {}},
    {"p_theta^2/(2*I) + M*cos(theta)", H, {"theta"}, {"p_theta"}, {"I", "M"}},
    {"p^2/(2*L^2) + J2*cos(theta)", H, {"theta"}, {"p"}, {"J2", "L"}},
    {"m*xdot^2/2 - m*g*x", L, {"x"}, {"xdot"}, {"g", "m"}},
    {"(x'^2 + y'^2)/2 - x^2*y", L, {"x", "y"}, {"x_dot", "y_dot"}, {}},
    {"(vx^2 + vy^2)/2 - k*x*y", L, {"x", "y"}, {"vx", "vy"}, {"k"}},
    {"(r_dot^2 + r^2*phi_dot^2)/2 + 1/r", L, {"phi", "r"}, {"phi_dot", "r_dot"}, {}},
};

TEST(OneLine, LettersAreRead) {
  for (const Case& c : cases) {
    const Letters found = letters_of(c.formula, c.kind);
    EXPECT_EQ(found.coordinates, c.coordinates) << c.formula;
    EXPECT_EQ(found.rates, c.rates) << c.formula;
    EXPECT_EQ(found.parameters, c.parameters) << c.formula;
    const System s = read_system(parse_document(system_text(c.formula, c.kind, found), "-H"));
    EXPECT_EQ(s.field.coordinates.size(), 2 * c.coordinates.size()) << c.formula;
  }
}

TEST(OneLine, WhatIsGivenIsNotGuessed) {
  const Letters found = letters_of("(u^2 + v^2)/2 + p1*x*y", H, {{"x", "y"}, {"u", "v"}, {}});
  EXPECT_THAT(found.coordinates, ElementsAre("x", "y"));
  EXPECT_THAT(found.rates, ElementsAre("u", "v"));
  EXPECT_THAT(found.parameters, ElementsAre("p1"));
  EXPECT_THAT(letters_of("p^2/2 + t*q", H, {{}, {}, {"t"}}).parameters, ElementsAre("t"));
  EXPECT_THAT(letters_of("p1^2/2 + p2*q1", H, {{}, {}, {"p2"}}).coordinates, ElementsAre("q1"));
}

// Products and powers whose signs are missing are not parameters.
TEST(OneLine, NamesThatRunTogetherAreAskedBack) {
  for (const auto& [formula, product] :
       std::vector<std::pair<std::string, std::string>>{{"(px^2 + py^2)/2 + x2y", "x^2*y"},
                                                        {"(px^2 + py^2)/2 + y3/3", "y^3"},
                                                        {"(px^2 + py^2)/2 + x^2 + axy", "a*x*y"},
                                                        {"(px^2 + py^2)/2 + Ax^2", "A*x"},
                                                        {"p^2/2 + kx^2/2", "k*x"},
                                                        {"p^2/2 - cosq", "cos(q)"},
                                                        {"px^2/2 + px3 + x", "px^3"}})
    try {
      (void)letters_of(formula, H);
      ADD_FAILURE() << formula;
    } catch (const InputError& e) {
      EXPECT_THAT(e.message(), testing::EndsWith(" one name, or " + product + "?")) << formula;
    }
  for (const char* formula : {"px^2/2 + x0*x + mu*x^2 + Lz", "pu^2/2 + mu*u + eps*u^2",
                              "p^2/2 + omega_c*q + eps*q^3 + q0", "pz^2/2 + mass*z"})
    EXPECT_NO_THROW((void)letters_of(formula, H)) << formula;
  EXPECT_THAT(letters_of("p^2/2 + kx^2/2", H, {{}, {}, {"kx"}}).parameters, ElementsAre("kx"));
}

TEST(OneLine, WhatIsNotClearIsAskedBack) {
  for (const char* formula : {"a*x", "p^2/2 + t*q", "x^2 + y^2", "p^2/2 + 2q", "p^2/2 +"})
    EXPECT_THROW(static_cast<void>(letters_of(formula, H)), InputError) << formula;
  EXPECT_THROW(static_cast<void>(letters_of("p^2 + a*q", H, {{}, {}, {"b"}})), InputError);
  EXPECT_THROW(static_cast<void>(letters_of("u^2 + x^2", H, {{"x"}, {}, {}})), InputError);
  EXPECT_THROW(static_cast<void>(letters_of("u^2 + x^2", H, {{"x"}, {"x"}, {}})), InputError);
  EXPECT_THROW(static_cast<void>(letters_of("u^2 + x^2", H, {{"x"}, {"u", "v"}, {}})), InputError);
}

// x^2y is x^2*y where no function is looked for; e^2x may be e^(2x).  r beside x and y is hardly a parameter.
TEST(OneLine, PowersAndRadii) {
  EXPECT_EQ(read_one_line("(px^2 + py^2)/2 + x^2y", H).formula, "(px^2 + py^2)/2 + x^2*y");
  EXPECT_EQ(read_one_line("p^2/2 + a q^2b", H).formula, "p^2/2 + a*q^2*b");
  EXPECT_THROW(static_cast<void>(read_one_line("p^2/2 + e^2q", H)), InputError);
  EXPECT_THROW(static_cast<void>(letters_of("(px^2 + py^2)/2 - 1/r", H)), InputError);
  EXPECT_THAT(letters_of("(px^2 + py^2)/2 - x/r", H, {{}, {}, {"r"}}).parameters, ElementsAre("r"));
  EXPECT_THAT(letters_of("pr^2/2 - 1/r", H).coordinates, ElementsAre("r"));
}

TEST(OneLine, SentencesAreParted) {
  const std::string parted = assume_table({"a > 0", "b > 0", "n integer"});
  EXPECT_EQ(assume_table({"a > 0,b > 0", "n integer"}), parted);
}

} // namespace
} // namespace kov::one_line_test
