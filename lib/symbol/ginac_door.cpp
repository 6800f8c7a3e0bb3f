#include "symbol/ginac_door.hpp"

#include "exact/error.hpp"

#include <sstream>

namespace kov {
namespace {

GiNaC::ex call(const Expression& e, const GiNaC::ex& argument) {
  if (e.name() == "sqrt") return GiNaC::sqrt(argument);
  if (e.name() == "sin") return GiNaC::sin(argument);
  if (e.name() == "cos") return GiNaC::cos(argument);
  if (e.name() == "exp") return GiNaC::exp(argument);
  throw e.error("'" + e.name() + "' is not known here", "known: sqrt, sin, cos, exp");
}

std::string text_of(const GiNaC::numeric& number) {
  if (!number.is_crational())
    throw InvalidArgument("a GiNaC number is not exact; only rational numbers are read");
  std::ostringstream out;
  if (number.is_rational())
    out << '(' << number << ')';
  else
    out << "((" << number.real() << ")+(" << number.imag() << ")*I)";
  return out.str();
}

std::string joined(const GiNaC::ex& e, const char* sign) {
  std::string s = "(";
  for (std::size_t i = 0; i < e.nops(); ++i)
    s += (i == 0 ? "" : sign) + to_formula(e.op(i));
  return s + ")";
}

std::string power_text(const GiNaC::ex& base, const GiNaC::ex& exponent) {
  if (exponent.is_equal(GiNaC::numeric(1, 2))) return "sqrt(" + to_formula(base) + ")";
  if (exponent.is_equal(GiNaC::numeric(-1, 2))) return "(1/sqrt(" + to_formula(base) + "))";
  return "(" + to_formula(base) + "^" + to_formula(exponent) + ")";
}

std::string function_text(const GiNaC::function& f) {
  const std::string name = f.get_name();
  if (name != "sin" && name != "cos" && name != "exp")
    throw InvalidArgument("the function '" + name + "' of a GiNaC expression is not known here");
  return name + "(" + to_formula(f.op(0)) + ")";
}

} // namespace

GiNaC::ex to_ginac(const Expression& e, SymbolTable& symbols) {
  const auto operand = [&](std::size_t i) { return to_ginac(e.operand(i), symbols); };
  switch (e.kind()) {
  case Expression::Kind::number:
    return GiNaC::numeric(to_string(e.number()).c_str());
  case Expression::Kind::name:
    return e.name() == "I" ? GiNaC::ex(GiNaC::I) : GiNaC::ex(symbols[e.name()]);
  case Expression::Kind::sum: {
    GiNaC::exvector terms;
    for (std::size_t i = 0; i < e.operands().size(); ++i)
      terms.push_back(operand(i));
    return GiNaC::add(terms);
  }
  case Expression::Kind::negate:
    return -operand(0);
  case Expression::Kind::product: {
    GiNaC::ex product = 1;
    for (std::size_t i = 0; i < e.operands().size(); ++i)
      product *= operand(i);
    return product;
  }
  case Expression::Kind::quotient: {
    const GiNaC::ex below = operand(1);
    if (below.is_zero()) throw e.operand(1).error("division by zero");
    return operand(0) / below;
  }
  case Expression::Kind::power:
    return GiNaC::pow(operand(0), operand(1));
  case Expression::Kind::call:
    if (e.operands().size() == 1) return call(e, operand(0));
    [[fallthrough]];
  default:
    throw e.error("this has no meaning as a GiNaC expression");
  }
}

std::string to_formula(const GiNaC::ex& e) {
  if (GiNaC::is_a<GiNaC::numeric>(e)) return text_of(GiNaC::ex_to<GiNaC::numeric>(e));
  if (GiNaC::is_a<GiNaC::symbol>(e)) return GiNaC::ex_to<GiNaC::symbol>(e).get_name();
  if (GiNaC::is_a<GiNaC::add>(e)) return joined(e, "+");
  if (GiNaC::is_a<GiNaC::mul>(e)) return joined(e, "*");
  if (GiNaC::is_a<GiNaC::power>(e)) return power_text(e.op(0), e.op(1));
  if (GiNaC::is_a<GiNaC::function>(e)) return function_text(GiNaC::ex_to<GiNaC::function>(e));
  std::ostringstream out;
  out << e;
  throw InvalidArgument("this GiNaC expression cannot be read: " + out.str());
}

} // namespace kov
