#include "symbol/ginac_door.hpp"

#include "exact/error.hpp"
#include "symbol/known_functions.hpp"
#include "symbol/written.hpp"

#include <sstream>

namespace kov {
namespace {

using GiNaC::ex;
using Kind = Expression::Kind;

thread_local GiNaC::exvector integrands; // by their numbers

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

// By the last argument, the only one that depends on the variable.
ex slope_of_called(const ex& f, const ex& a, const ex& b, const ex& c, const ex& x, unsigned by) {
  if (by != 4) throw DomainError("no derivative by an index is known");
  const std::string name = GiNaC::ex_to<GiNaC::symbol>(f).get_name();
  if (name == "int")
    return integrands.at(static_cast<std::size_t>(GiNaC::ex_to<GiNaC::numeric>(c).to_int()));
  static thread_local SymbolTable letters;
  const KnownFunction* known = nullptr;
  for (std::size_t n = 1; known == nullptr; ++n)
    known = known_function(name, n);
  const GiNaC::exvector given{a, b, c, x};
  GiNaC::exmap values;
  for (std::size_t i = 0, n = known->arguments.size(); i < n; ++i)
    values.emplace(letters[known->arguments[i]], given[given.size() - n + i]);
  return to_ginac(*known->slope, letters).subs(values, GiNaC::subs_options::no_pattern);
}

} // namespace

// NOLINTNEXTLINE
REGISTER_FUNCTION(called, derivative_func(slope_of_called))

class GinacReader {
public:
  explicit GinacReader(SymbolTable& symbols) : s_(symbols) {}

  ex operator()(const Expression& e) {
    switch (e.kind()) {
    case Kind::number:
      return GiNaC::numeric(to_string(e.number()).c_str());
    case Kind::name:
      return of_name(e);
    case Kind::sum:
      return GiNaC::add(operands(e));
    case Kind::product: {
      ex product = 1;
      for (const ex& x : operands(e))
        product *= x;
      return product;
    }
    case Kind::negate:
      return -(*this)(e.operand(0));
    case Kind::quotient: {
      const ex below = (*this)(e.operand(1));
      if (below.is_zero()) throw e.operand(1).error("division by zero");
      return (*this)(e.operand(0)) / below;
    }
    case Kind::power:
      return GiNaC::pow((*this)(e.operand(0)), (*this)(e.operand(1)));
    case Kind::derivative:
      return derivative((*this)(e.operand(0)), e.order());
    case Kind::equation:
      return (*this)(e.operand(0)) - (*this)(e.operand(1));
    case Kind::call:
      return of_call(e);
    default:
      throw e.error("this has no meaning as a GiNaC expression");
    }
  }

private:
  [[nodiscard]] GiNaC::exvector operands(const Expression& e) {
    GiNaC::exvector all;
    for (const Expression& x : e.operands())
      all.push_back((*this)(x));
    return all;
  }
  // y'' is the derivative of y', which an equation has as well.
  ex derivative(const ex& e, long order) {
    if (order == 0) return e;
    const auto [it, is_new] = s_.slopes_.try_emplace(e);
    if (is_new) it->second = e.diff(s_[s_.variable_]);
    return derivative(it->second, order - 1);
  }

  ex of_name(const Expression& e) {
    const std::string& name = e.name();
    if (const auto it = s_.values_.find(name); it != s_.values_.end()) {
      if (!s_.read_.contains(name)) s_.read_.emplace(name, (*this)(it->second));
      return s_.read_.at(name);
    }
    if (name == "I") return GiNaC::I;
    if (name == "pi") return GiNaC::Pi;
    return s_[name];
  }

  ex of_call(const Expression& e) {
    const std::string& f = e.name();
    const std::size_t n = e.operands().size();
    if (n == 1 && s_.values_.contains(f)) return of_name(e); // y(x)
    if (f == "diff" && n >= 2) {
      const bool has_order = n == 3 && e.operand(2).kind() == Kind::number;
      return derivative((*this)(e.operand(0)), n == 2      ? 1
                                               : has_order ? to_long(e.operand(2).number())
                                                           : 2);
    }
    if (f == "root" && n == 2) {
      const std::string name = written(e);
      s_.roots_.emplace(name, e);
      return s_[name];
    }
    static thread_local SymbolTable functions;
    if (f == "int" && n == 2) {
      const ex inside = (*this)(e.operand(0));
      const auto it =
          std::ranges::find_if(integrands, [&](const ex& x) { return x.is_equal(inside); });
      const auto number = static_cast<int>(it - integrands.begin());
      if (it == integrands.end()) integrands.push_back(inside);
      return called(functions[f], 0, 0, number, (*this)(e.operand(1)));
    }
    const GiNaC::exvector a = operands(e);
    if (n == 1)
      if (const auto it = of_ginac().find(f); it != of_ginac().end()) return it->second(a[0]);
    const KnownFunction* known = known_function(f, n);
    if (known != nullptr && known->means) {
      SymbolTable letters;
      return to_ginac(*known->means, letters).subs(letters[known->arguments.front()] == a.front());
    }
    if (known == nullptr && f != "rgamma") throw e.error("'" + f + "' is not known here");
    GiNaC::exvector all(4 - n, 0);
    all.insert(all.end(), a.begin(), a.end());
    return called(functions[f], all[0], all[1], all[2], all[3]);
  }

  using One = ex (*)(const ex&);
  static const std::map<std::string, One>& of_ginac() {
    static const std::map<std::string, One> all{
        {"exp", [](const ex& x) -> ex { return GiNaC::exp(x); }},
        {"log", [](const ex& x) -> ex { return GiNaC::log(x); }},
        {"sin", [](const ex& x) -> ex { return GiNaC::sin(x); }},
        {"cos", [](const ex& x) -> ex { return GiNaC::cos(x); }},
        {"sinh", [](const ex& x) -> ex { return GiNaC::sinh(x); }},
        {"cosh", [](const ex& x) -> ex { return GiNaC::cosh(x); }},
        {"atan", [](const ex& x) -> ex { return GiNaC::atan(x); }},
        {"asin", [](const ex& x) -> ex { return GiNaC::asin(x); }},
        {"acos", [](const ex& x) -> ex { return GiNaC::acos(x); }},
        {"asinh", [](const ex& x) -> ex { return GiNaC::asinh(x); }},
        {"acosh", [](const ex& x) -> ex { return GiNaC::acosh(x); }},
        {"atanh", [](const ex& x) -> ex { return GiNaC::atanh(x); }}};
    return all;
  }

  SymbolTable& s_;
};

ex to_ginac(const Expression& e, SymbolTable& symbols) { return GinacReader(symbols)(e); }

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
