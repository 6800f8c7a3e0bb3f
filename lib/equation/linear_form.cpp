#include "equation/linear_form.hpp"

#include "symbol/suggest.hpp"

#include <algorithm>
#include <set>

namespace kov {
namespace {

using Kind = Expression::Kind;

// y, or y(z) where y is not a function that formulas know
bool is_function_name(const Expression& e) {
  static const std::set<std::string> known{"sqrt", "root", "diff", "sin",  "cos",  "tan",
                                           "cot",  "sec",  "csc",  "exp",  "sinh", "cosh",
                                           "tanh", "coth", "sech", "csch", "log",  "ln"};
  return e.kind() == Kind::name ||
         (e.kind() == Kind::call && e.operands().size() == 1 && !known.contains(e.name()));
}

bool is_call_of_function(const Expression& e) {
  return e.kind() == Kind::call && !is_diff(e) && is_function_name(e) &&
         e.operand(0).kind() == Kind::name;
}

struct Found : Differentiated {
  std::set<std::string> variables;
  // Names and calls in what is differentiated and is not a name: (x*y)', diff(x*y(x), x)
  std::set<std::string> inner_names, inner_calls;
  const Expression* product = nullptr;
};

void look_inside(const Expression& e, Found& found) {
  if (e.kind() == Kind::name && e.name() != "I") found.inner_names.insert(e.name());
  if (is_call_of_function(e)) {
    found.inner_calls.insert(e.name());
    found.arguments.insert(e.operand(0).name());
  }
  for (const Expression& operand : e.operands())
    look_inside(operand, found);
}

void look(const Expression& e, Found& found) {
  const bool differentiates = e.kind() == Kind::derivative || is_diff(e);
  if (differentiates && is_function_name(e.operand(0))) {
    const Expression& f = e.operand(0);
    found.functions.insert(f.name());
    if (is_call_of_function(f)) {
      found.variables.insert(f.operand(0).name());
      found.arguments.insert(f.operand(0).name());
    }
  } else if (differentiates) {
    look_inside(e.operand(0), found);
    if (found.product == nullptr) found.product = &e;
  }
  if (is_diff(e) && e.operands().size() > 1 && e.operand(1).kind() == Kind::name)
    found.variables.insert(e.operand(1).name());
  for (const Expression& operand : e.operands())
    look(operand, found);
}

std::vector<std::string> list_of(const std::set<std::string>& names) {
  return {names.begin(), names.end()};
}

// The function in (x*y)'' or diff(x*y(x), x, 2).
std::string unknown_in_product(Found& found) {
  static const std::set<std::string> usual{"y", "u", "v", "w", "f", "psi", "Y", "U", "V", "W", "F"};
  if (found.inner_calls.size() == 1) {
    if (found.variables.empty()) found.variables = found.arguments;
    return *found.inner_calls.begin();
  }
  std::set<std::string> candidates;
  for (const std::string& name : found.inner_names)
    if (usual.contains(name) && !found.variables.contains(name)) candidates.insert(name);
  if (candidates.size() == 1 && found.inner_calls.empty()) return *candidates.begin();
  throw found.product->error("which function is differentiated here?",
                             "name it: --unknown NAME, or write the derivative of the product out");
}

class OverNumbers : public FieldOfCoefficients<RationalFunction> {
public:
  explicit OverNumbers(const Reading& reading) : reading_(reading) {}

  [[nodiscard]] RationalFunction constant(long n) const override {
    return RationalFunction(coerce(Poly(n), reading_.constants->field()));
  }
  [[nodiscard]] RationalFunction value(const Expression& e) const override {
    return rational_function(e, reading_);
  }
  [[nodiscard]] RationalFunction derivative(const RationalFunction& f) const override {
    reading_.budget.check();
    return kov::derivative(f);
  }
  [[nodiscard]] std::string text(const RationalFunction& f) const override {
    return to_string(f, reading_.variable);
  }
  void check(const RationalFunction& f) const override {
    reading_.budget.check();
    reading_.budget.check_degree(std::max(degree(f.num()), degree(f.den())));
  }

private:
  const Reading& reading_;
};

} // namespace

namespace {

// The letters behind the line in u_xx, u_tt.
std::set<std::string> subscripts(const Expression& equation) {
  std::set<std::string> all;
  for (const std::string& name : names_in(equation)) {
    const std::size_t line = name.find('_');
    if (line == std::string::npos || line + 1 == name.size() || line > 1) continue;
    for (const char c : name.substr(line + 1))
      all.insert(std::string(1, c));
  }
  return all;
}

void refuse_partial_derivatives(const Expression& equation, const Found& found) {
  const bool by_subscripts = found.functions.empty() && found.product == nullptr;
  const auto by = by_subscripts ? subscripts(equation) : found.variables;
  if (by.size() > 1)
    throw equation.error("derivatives with respect to two variables, " + enumerate(list_of(by)) +
                             ": a partial differential equation",
                         "put a product in, u = X(x)*T(t): each factor has an ordinary equation, "
                         "which can be solved here");
}

} // namespace

Differentiated differentiated_in(const Expression& equation) {
  Found found;
  look(equation, found);
  return found;
}

OdeNames ode_names(const Expression& equation, const std::string& declared) {
  Found found;
  look(equation, found);
  std::set<std::string>& unknowns = found.functions;
  for (const std::string& v : found.variables) // (z*y)': z is differentiated by name in diff only
    if (unknowns.size() > 1) unknowns.erase(v);
  refuse_partial_derivatives(equation, found);
  if (unknowns.empty() && found.product == nullptr)
    throw equation.error("no derivative of an unknown function appears",
                         "write e.g. y'' = z*y, with primes for derivatives");
  const bool inside = found.inner_calls.contains(declared) || found.inner_names.contains(declared);
  if (unknowns.empty()) unknowns.insert(inside ? declared : unknown_in_product(found));
  if (!declared.empty() && !unknowns.contains(declared))
    throw equation.error("no derivative of " + declared + " appears",
                         "differentiated: " + enumerate(list_of(unknowns)));
  if (unknowns.size() > 1)
    throw equation.error("two functions are differentiated: " + enumerate(list_of(unknowns)),
                         "one unknown function is expected; a product is written with *: x*y'");
  return {*unknowns.begin(), found.variables.empty() ? std::string() : *found.variables.begin()};
}

SecondOrder second_order(const Expression& equation, const std::string& unknown,
                         const Reading& reading) {
  const OverNumbers numbers(reading);
  const LinearForm form =
      LinearReader<RationalFunction>(unknown, reading.variable, numbers).second_order(equation);
  const auto check = [&](const RationalFunction& a, const RationalFunction& b) {
    reading.budget.check_degree(std::max(degree(a.num()), 0L) + std::max(degree(b.den()), 0L));
    reading.budget.check_degree(std::max(degree(a.den()), 0L) + std::max(degree(b.num()), 0L));
  };
  check(form.c[1], form.c[2]);
  check(form.c[0], form.c[2]);
  return {form.c[1] / form.c[2], form.c[0] / form.c[2]};
}

} // namespace kov
