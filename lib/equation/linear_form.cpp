#include "equation/linear_form.hpp"

#include "symbol/suggest.hpp"

#include <algorithm>
#include <set>
#include <unordered_map>

namespace kov {
namespace {

using Kind = Expression::Kind;

constexpr long max_order = 20; // higher derivatives are refused before they are computed

bool is_diff(const Expression& e) { return e.kind() == Kind::call && e.name() == "diff"; }

// y, or y(z) where y is no function that formulas know
bool is_function_name(const Expression& e) {
  static const std::set<std::string> known{"sqrt", "root", "diff", "sin", "cos", "exp"};
  return e.kind() == Kind::name ||
         (e.kind() == Kind::call && e.operands().size() == 1 && !known.contains(e.name()));
}

struct Found {
  std::set<std::string> unknowns;
  std::set<std::string> variables;
};

void look(const Expression& e, Found& found) {
  const bool differentiates = e.kind() == Kind::derivative || is_diff(e);
  if (differentiates && is_function_name(e.operand(0))) {
    const Expression& f = e.operand(0);
    found.unknowns.insert(f.name());
    if (f.kind() == Kind::call && f.operand(0).kind() == Kind::name)
      found.variables.insert(f.operand(0).name());
  }
  if (is_diff(e) && e.operands().size() > 1 && e.operand(1).kind() == Kind::name)
    found.variables.insert(e.operand(1).name());
  for (const Expression& operand : e.operands())
    look(operand, found);
}

class Recogniser {
public:
  Recogniser(const std::string& unknown, const Reading& reading)
      : unknown_(unknown), reading_(reading), zero_(coerce(Poly(0), reading.constants->field())) {}

  LinearForm operator()(const Expression& e) {
    if (!mentions(e)) return {{}, rational_function(e, reading_)};
    switch (e.kind()) {
    case Kind::name:
      return unknown_itself();
    case Kind::sum:
      return sum(e);
    case Kind::negate:
      return scaled((*this)(e.operand(0)), RationalFunction(-1));
    case Kind::product:
      return product(e);
    case Kind::quotient:
      if (mentions(e.operand(1))) throw not_linear(e);
      return scaled((*this)(e.operand(0)), inverse(e.operand(1)));
    case Kind::power:
      if (e.operand(1).kind() == Kind::number && e.operand(1).number() == Integer(1))
        return (*this)(e.operand(0));
      throw not_linear(e);
    case Kind::call:
      return call(e);
    case Kind::derivative:
      return differentiated((*this)(e.operand(0)), e.order(), e);
    case Kind::equation: {
      LinearForm left = (*this)(e.operand(0));
      return added(std::move(left), scaled((*this)(e.operand(1)), RationalFunction(-1)));
    }
    default:
      throw not_linear(e);
    }
  }

private:
  bool mentions(const Expression& e) {
    const auto known = mentions_.find(e.id());
    if (known != mentions_.end()) return known->second;
    if (e.kind() == Kind::call && e.name() == "root") return false; // a constant
    const bool named = e.kind() == Kind::name || e.kind() == Kind::call;
    bool result = (named && e.name() == unknown_) || e.kind() == Kind::derivative || is_diff(e);
    for (const Expression& operand : e.operands())
      result = mentions(operand) || result;
    mentions_[e.id()] = result;
    return result;
  }

  [[nodiscard]] InputError not_linear(const Expression& e) const {
    return e.error("this is not linear in " + unknown_,
                   "only a2*" + unknown_ + "'' + a1*" + unknown_ + "' + a0*" + unknown_ +
                       " = 0 with rational functions a2, a1, a0 can be solved");
  }

  [[nodiscard]] LinearForm unknown_itself() const {
    return {{RationalFunction(coerce(Poly(1), reading_.constants->field()))}, zero_};
  }

  [[nodiscard]] LinearForm added(LinearForm a, const LinearForm& b) const {
    if (a.c.size() < b.c.size()) a.c.resize(b.c.size(), zero_);
    for (std::size_t i = 0; i < b.c.size(); ++i)
      a.c[i] += b.c[i];
    a.rest += b.rest;
    return a;
  }

  static LinearForm scaled(LinearForm a, const RationalFunction& f) {
    for (RationalFunction& c : a.c)
      c *= f;
    a.rest *= f;
    return a;
  }

  [[nodiscard]] RationalFunction inverse(const Expression& e) const {
    const RationalFunction f = rational_function(e, reading_);
    if (is_zero(f)) throw e.error("division by zero");
    return RationalFunction(1) / f;
  }

  LinearForm sum(const Expression& e) {
    LinearForm total{{}, zero_};
    for (const Expression& term : e.operands())
      total = added(std::move(total), (*this)(term));
    return total;
  }

  LinearForm product(const Expression& e) {
    RationalFunction factor(coerce(Poly(1), reading_.constants->field()));
    const Expression* linear = nullptr;
    for (const Expression& operand : e.operands()) {
      reading_.budget.check();
      if (!mentions(operand)) {
        factor *= rational_function(operand, reading_);
        reading_.budget.check_degree(std::max(degree(factor.num()), degree(factor.den())));
      } else if (linear != nullptr) {
        throw not_linear(e);
      } else {
        linear = &operand;
      }
    }
    return scaled((*this)(*linear), factor);
  }

  LinearForm call(const Expression& e) {
    if (e.name() == unknown_) { // y(z)
      const bool plain = e.operands().size() == 1 && e.operand(0).kind() == Kind::name &&
                         e.operand(0).name() == reading_.variable;
      if (!plain)
        throw e.error("'" + unknown_ + "' is a function of " + reading_.variable,
                      "write " + unknown_ + " or " + unknown_ + "(" + reading_.variable + ")");
      return unknown_itself();
    }
    if (!is_diff(e)) throw not_linear(e);
    const std::string form = "write diff(" + unknown_ + ", " + reading_.variable + ") or diff(" +
                             unknown_ + ", " + reading_.variable + ", 2)";
    if (e.operands().size() < 2 || e.operands().size() > 3)
      throw e.error("diff has two or three arguments", form);
    if (e.operand(1).kind() != Kind::name || e.operand(1).name() != reading_.variable)
      throw e.operand(1).error("the derivative is with respect to " + reading_.variable, form);
    long order = 1;
    if (e.operands().size() == 3) {
      const Expression& n = e.operand(2);
      if (n.kind() != Kind::number || n.number() > Integer(max_order))
        throw n.error("the order of a derivative is a small integer", form);
      order = to_long(n.number());
    }
    return differentiated((*this)(e.operand(0)), order, e);
  }

  // (sum c_k y^(k))' = sum c_k' y^(k) + c_k y^(k+1)
  LinearForm differentiated(LinearForm a, long order, const Expression& at) const {
    if (static_cast<long>(a.c.size()) + order > max_order + 1)
      throw at.error("only second-order equations can be solved");
    for (; order > 0; --order) {
      reading_.budget.check();
      LinearForm b{std::vector<RationalFunction>(a.c.empty() ? 0 : a.c.size() + 1, zero_),
                   derivative(a.rest)};
      for (std::size_t k = 0; k < a.c.size(); ++k) {
        b.c[k] += derivative(a.c[k]);
        b.c[k + 1] += a.c[k];
      }
      a = std::move(b);
    }
    return a;
  }

  const std::string& unknown_;
  const Reading& reading_;
  RationalFunction zero_;
  std::unordered_map<const void*, bool> mentions_;
};

} // namespace

OdeNames ode_names(const Expression& equation) {
  Found found;
  look(equation, found);
  for (const std::string& v : found.variables) // (z*y')': z is differentiated by name in diff only
    if (found.unknowns.size() > 1) found.unknowns.erase(v);
  if (found.unknowns.empty())
    throw equation.error("no derivative of an unknown function appears",
                         "write e.g. y'' = z*y, with primes for derivatives");
  if (found.unknowns.size() > 1) {
    const std::vector<std::string> names(found.unknowns.begin(), found.unknowns.end());
    throw equation.error("two functions are differentiated: " + enumerate(names),
                         "one equation for one unknown function is expected");
  }
  if (found.variables.size() > 1) {
    const std::vector<std::string> names(found.variables.begin(), found.variables.end());
    throw equation.error("derivatives with respect to two variables: " + enumerate(names));
  }
  return {*found.unknowns.begin(),
          found.variables.empty() ? std::string() : *found.variables.begin()};
}

LinearForm linear_form(const Expression& equation, const std::string& unknown,
                       const Reading& reading) {
  LinearForm form = Recogniser(unknown, reading)(equation);
  while (!form.c.empty() && is_zero(form.c.back()))
    form.c.pop_back();
  return form;
}

SecondOrder second_order(const Expression& equation, const std::string& unknown,
                         const Reading& reading) {
  const LinearForm form = linear_form(equation, unknown, reading);
  const std::string pattern = "y'' + p y' + q y = 0 is expected";
  const long order = static_cast<long>(form.c.size()) - 1;
  if (order > 2)
    throw equation.error("the equation has order " + std::to_string(order),
                         "only second-order equations can be solved");
  if (!is_zero(form.rest)) {
    std::string term = to_string(form.rest, reading.variable);
    if (term.size() > 60) term = term.substr(0, 60) + "...";
    throw equation.error("the equation is not homogeneous: the term " + term + " has no " + unknown,
                         pattern);
  }
  if (order < 2)
    throw equation.error(order < 0 ? "everything cancels: there is no equation left"
                                   : "the coefficient of " + unknown + "'' is zero",
                         pattern);
  const auto check = [&](const RationalFunction& a, const RationalFunction& b) {
    reading.budget.check_degree(std::max(degree(a.num()), 0L) + std::max(degree(b.den()), 0L));
    reading.budget.check_degree(std::max(degree(a.den()), 0L) + std::max(degree(b.num()), 0L));
  };
  check(form.c[1], form.c[2]);
  check(form.c[0], form.c[2]);
  return {form.c[1] / form.c[2], form.c[0] / form.c[2]};
}

} // namespace kov
