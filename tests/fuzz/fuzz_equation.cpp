// Any bytes as an equation: every input ends in a result, "undecided", or one clear error.
//
// The first byte chooses what the rest is: r, a whole equation, minpoly and r, p and q, or a file.
// Properties checked on the way: printed functions read back as the same function, and the solver
// throws nothing but InternalError (which is a finding, as is a sanitizer report or a hang).

#include "decide/decide.hpp"
#include "equation/equation_file.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

using namespace kov;

Budget small_budget() {
  Budget b = Budget::of_seconds(0.5);
  b.max_degree = 60;
  b.max_families = 2000;
  return b;
}

std::optional<Expression> formula(const std::string& text, const char* name,
                                  bool equation = false) {
  return parse_expression(text, name, equation);
}

EquationText text_of(char form, const std::string& text) {
  const auto line = text.find('\n');
  const std::string first = text.substr(0, line);
  const std::string rest = line == std::string::npos ? std::string() : text.substr(line + 1);
  EquationText e;
  switch (form) {
  case 'e':
    e.ode = formula(text, "-e", true);
    break;
  case 'm':
    e.minpoly = formula(first, "minpoly");
    e.r = formula(rest, "r");
    break;
  case 'p':
    e.p = formula(first, "p");
    e.q = formula(rest, "q");
    break;
  case 't':
    return read_equation_file(parse_document(text, "f.toml")).asked.text;
  default:
    e.r = formula(text, "-r");
  }
  return e;
}

void check_round_trip(const GivenEquation& e) {
  if (!e.constant.empty() && e.constant.find('(') == std::string::npos && e.constant != "I") return;
  EquationText again;
  const std::string printed = to_string(e.normal_form.r, e.variable);
  again.r = parse_expression(printed, "again");
  again.variable = e.variable;
  const GivenEquation back = read_equation(again, {});
  const std::string reprinted = to_string(back.normal_form.r, e.variable);
  if (printed == reprinted) return;
  std::fprintf(stderr, "printed %s\nreread  %s\n", printed.c_str(), reprinted.c_str());
  std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2 || size > 4000) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    const Budget budget = small_budget();
    const GivenEquation e = read_equation(text_of(static_cast<char>(data[0]), text), budget);
    check_round_trip(e);
    Options options;
    options.budget = small_budget();
    options.variable = e.variable;
    const Decision d = decide(e.normal_form, options);
    if (!d.group && !d.undecided) std::abort(); // neither an answer nor a reason
  } catch (const InputError& e) {
    if (render(e).empty()) std::abort();
  } catch (const InternalError&) {
    throw;
  } catch (const Error&) { // limits, free parameters
  }
  return 0;
}
