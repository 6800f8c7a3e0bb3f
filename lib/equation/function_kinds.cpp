#include "equation/function_kinds.hpp"

#include "exact/lists.hpp"
#include "symbol/constants.hpp"
#include "symbol/written.hpp"

#include <algorithm>
#include <array>

namespace kov {
namespace {

constexpr std::array<std::string_view, 6> circular_functions{"sin", "cos", "tan",
                                                             "cot", "sec", "csc"};
constexpr std::array<std::string_view, 7> hyperbolic_functions{"sinh", "cosh", "tanh", "coth",
                                                               "sech", "csch", "exp"};

template <class List> bool is_one_of(const List& list, std::string_view name) {
  return is_among(name, list);
}

std::string as_circular(const CoefficientFunction& f) {
  if (f.family != FunctionFamily::hyperbolic || f.name == "exp") return f.name;
  return f.name == "sech" ? "sec" : f.name == "csch" ? "csc" : f.name.substr(0, f.name.size() - 1);
}

} // namespace

bool is_function_of(const Expression& e, const std::string& x) {
  if (e.kind() == Expression::Kind::call && mentions_name(e, x))
    return is_one_of(circular_functions, e.name()) || is_one_of(hyperbolic_functions, e.name()) ||
           e.name() == "sqrt";
  if (e.kind() != Expression::Kind::power || !mentions_name(e.operand(0), x)) return false;
  const auto exponent = as_rational(e.operand(1));
  return exponent && !is_integer(*exponent);
}

CoefficientFunction function_of(const Expression& e) {
  CoefficientFunction f{.e = e};
  if (e.kind() != Expression::Kind::call || e.name() == "sqrt") return f;
  f.name = e.name();
  f.family =
      is_one_of(circular_functions, f.name) ? FunctionFamily::circular : FunctionFamily::hyperbolic;
  if (e.operands().size() != 1) throw e.error(e.name() + " has one argument");
  return f;
}

MFraction value_of(const CoefficientFunction& f, const MFraction& cos, const MFraction& sin) {
  const auto quotient = [&](const MFraction& a, const MFraction& b) {
    if (is_zero(b)) throw f.e.error("division by zero");
    return a / b;
  };
  const std::string name = as_circular(f);
  const MFraction one(cos.ring(), Rational(1));
  return name == "sin"   ? sin
         : name == "tan" ? quotient(sin, cos)
         : name == "cot" ? quotient(cos, sin)
         : name == "sec" ? quotient(one, cos)
         : name == "csc" ? quotient(one, sin)
                         : cos;
}

} // namespace kov
