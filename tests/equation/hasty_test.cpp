// Equations that are typed in haste (hasty.txt) are read as they are meant, or asked back, at every door: never is another
// equation answered.

#include "equation/parametric_equation.hpp"
#include "equation/understood.hpp"
#include "support/source_dir.hpp"
#include "symbol/notations.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace kov {
namespace {

struct HastyEquation {
  bool must_be_read = false;
  std::string typed, meant;
  EquationText declared;
};

std::string trimmed(const std::string& s) {
  const auto begin = s.find_first_not_of(' '), end = s.find_last_not_of(' ');
  return begin == std::string::npos ? "" : s.substr(begin, end - begin + 1);
}

std::vector<std::string> split_at(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, at);)
    parts.push_back(trimmed(part));
  return parts;
}

std::vector<HastyEquation> hasty_equations() {
  std::ifstream in(test::in_source("/tests/equation/hasty.txt"));
  std::vector<HastyEquation> all;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    const auto parts = split_at(line, ';');
    HastyEquation e{parts.at(0) == "=", parts.at(1), parts.at(2), {}};
    for (std::size_t i = 3; i < parts.size(); ++i) {
      const std::string words = trimmed(parts[i].substr(1));
      if (parts[i][0] == 'p') e.declared.parameters = split_at(words, ',');
      if (parts[i][0] == 'v') e.declared.variable = words;
      if (parts[i][0] == 'u') e.declared.unknown = words;
    }
    all.push_back(e);
  }
  return all;
}

// Two texts are one equation where this is equal.
std::string coefficients_of(const EquationText& text) {
  try {
    const GivenEquation e = read_equation(text);
    return e.variable + ": " + to_string(e.p, e.variable) + ", " + to_string(e.q, e.variable);
  } catch (const FreeParameters&) {
    const ParametricEquation e = read_parametric_equation(text);
    return e.variable + ": " + to_string(e.question.r) + ", " + to_string(e.gauge);
  }
}

std::string asked_or(const std::function<std::string()>& read) {
  try {
    return read();
  } catch (const InputError&) {
    return "asked";
  }
}

std::string by_command_line(const std::string& ode, const EquationText& declared) {
  const Understood u = understood(ode, "-e", declared);
  return coefficients_of(u.text) + " = " + u.right_side.value_or("0");
}

std::string by_strict_door(const std::string& ode, EquationText declared, bool infer) {
  declared.ode = parse_ode(ode, "ode");
  declared.infer_variable = infer;
  return coefficients_of(declared) + " = 0";
}

std::string by_spectrum(const std::string& ode, EquationText declared) {
  Understood u = understood(ode, "-e", declared);
  take_all_parameters(u.text);
  return coefficients_of(u.text) + " = " + u.right_side.value_or("0");
}

TEST(Hasty, EveryDoorReadsWhatIsMeantOrAsks) {
  const auto all = hasty_equations();
  EXPECT_GE(all.size(), 200U);
  for (const HastyEquation& e : all) {
    SCOPED_TRACE(e.typed);
    std::string meant = "asked"; // also where the right coefficients are out of reach
    if (e.meant != "-") meant = asked_or([&] { return by_command_line(e.meant, e.declared); });
    if (e.must_be_read) EXPECT_NE(meant, "asked");
    const std::string read = asked_or([&] { return by_command_line(e.typed, e.declared); });
    if (e.must_be_read || read != "asked") EXPECT_EQ(read, meant);
    for (const bool infer : {true, false}) {
      const std::string strict =
          asked_or([&] { return by_strict_door(e.typed, e.declared, infer); });
      if (strict != "asked") EXPECT_EQ(strict, meant) << (infer ? "Python" : "batch");
    }
    if (meant == "asked") continue;
    const std::string in_spectrum = asked_or([&] { return by_spectrum(e.typed, e.declared); });
    if (in_spectrum != "asked")
      EXPECT_EQ(in_spectrum, asked_or([&] { return by_spectrum(e.meant, e.declared); }))
          << "spectrum";
  }
}

// The message names what was typed, and its way out is a command that is read.
TEST(Hasty, TheQuestionShowsBothWaysOut) {
  const EquationText nothing;
  for (const auto& [typed, message, hint] :
       std::vector<std::tuple<const char*, const char*, const char*>>{
           {"y''=yx", "yx is read as one name", "write y''=y*x"},
           {"y'' = sin2x*y", "sin2x is read as one name", "write y'' = sin(2*x)*y"},
           {"y''=pi*y", "pi is a constant", "--parameter pi"},
           {"y''=e^2*y", "e is a constant", "exp(x)"},
           {"y''=2i y", "unknown name 'i'", "the imaginary unit is I"},
           {"y''=i x y", "unknown name 'i'", "the imaginary unit is I"},
           {"y_xx=x*y", "no derivative of an unknown function appears", "with primes"},
           {"x''=x y", "is y the variable, or a constant?", "--variable y"},
           {"(x t)''=x", "which function is differentiated here?", "--unknown NAME"},
           {"y''=(x]y", "']' does not close '('", "column 5"}})
    try {
      FAIL() << typed << ": " << by_command_line(typed, nothing);
    } catch (const InputError& e) {
      EXPECT_EQ(e.message().substr(0, std::string(message).size()), message) << typed;
      EXPECT_THAT(e.hint(), testing::HasSubstr(hint)) << typed;
    }
  EXPECT_THROW((void)by_command_line("y''=x*y", EquationText{.unknown = "u"}), InputError);
}

} // namespace
} // namespace kov
