#pragma once
// A linear differential equation recognised in the tree of a formula, whatever its coefficients are:
// rational functions over a number field (lib/equation), or over parameters (lib/system).

#include "symbol/expression.hpp"
#include "symbol/no_value.hpp"

#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace kov {

/// c[0] y + c[1] y' + ... + rest
template <class F> struct LinearFormOver {
  std::vector<F> c;
  F rest;
};

/// The questions of the reader to the field of coefficients.
template <class F> class FieldOfCoefficients {
public:
  FieldOfCoefficients() = default;
  FieldOfCoefficients(const FieldOfCoefficients&) = delete;
  FieldOfCoefficients& operator=(const FieldOfCoefficients&) = delete;
  virtual ~FieldOfCoefficients() = default;

  [[nodiscard]] virtual F constant(long n) const = 0;
  [[nodiscard]] virtual F value(const Expression& e) const = 0;
  [[nodiscard]] virtual F derivative(const F& f) const = 0;
  /// The term as a message shows it.
  [[nodiscard]] virtual std::string text(const F& f) const = 0;
  /// Throws where f is larger than what may be worked with.
  virtual void check(const F&) const {}
};

/// Refuses a call of the unknown at another place than its variable: y(x + 1), y(0) and y(2*x) are no y(x).
inline void need_own_argument(const Expression& call, const std::string& unknown,
                              const std::string& variable) {
  const auto& all = call.operands();
  if (all.size() != 1 || all[0].kind() != Expression::Kind::name || all[0].name() != variable)
    throw call.error("'" + unknown + "' is a function of " + variable,
                     "write " + unknown + " or " + unknown + "(" + variable + ")");
}

/// A call of diff, which is what every notation's derivative becomes.
/// Example is_diff(parse_expression("diff(y, z, 2)", "-e"))  // -> yes
/// Example is_diff(parse_expression("y''", "-e"))  // -> no
[[nodiscard]] inline bool is_diff(const Expression& e) {
  return e.kind() == Expression::Kind::call && e.name() == "diff";
}

inline constexpr long highest_derivative =
    20; // higher derivatives are refused before they are computed

/// diff(f, x) or diff(f, x, 2), f with the unknown function.   Errors  InputError for another form
[[nodiscard]] inline long order_of_diff(const Expression& e, const std::string& unknown,
                                        const std::string& variable) {
  using Kind = Expression::Kind;
  const std::string form =
      "write diff(" + unknown + ", " + variable + ") or diff(" + unknown + ", " + variable + ", 2)";
  if (e.operands().size() < 2 || e.operands().size() > 3)
    throw e.error("diff has two or three arguments", form);
  if (e.operand(1).kind() != Kind::name || e.operand(1).name() != variable)
    throw e.operand(1).error("the derivative is with respect to " + variable, form);
  if (e.operands().size() == 2) return 1;
  const Expression& n = e.operand(2);
  if (n.kind() != Kind::number || n.number() > Integer(highest_derivative))
    throw n.error("the order of a derivative is a small integer", form);
  return to_long(n.number());
}

template <class F> class LinearReader {
  using Kind = Expression::Kind;
  using Form = LinearFormOver<F>;

public:
  LinearReader(std::string unknown, std::string variable, const FieldOfCoefficients<F>& in)
      : unknown_(std::move(unknown)), variable_(std::move(variable)), in_(in),
        zero_(in.constant(0)) {}

  /// left side - right side (or the formula itself if it has no '=').  y''/y = r is y'' = r y.
  /// Errors  InputError where the formula is not linear in the unknown function and its derivatives
  Form form(const Expression& e) {
    Terms all = read(e);
    drop_zeros(all.form.c);
    drop_zeros(all.over_y);
    if (all.over_y.empty()) return std::move(all.form);
    if (!all.form.c.empty()) throw not_linear(e);
    all.over_y.front() = all.form.rest;
    return {std::move(all.over_y), zero_};
  }

  /// The form, if it is c2 y'' + c1 y' + c0 y with c2 != 0; else an error that says what is wrong.
  Form second_order(const Expression& e) {
    Form f = form(e);
    const std::string pattern = "y'' + p y' + q y = 0 is expected";
    const auto size = f.c.size();
    if (size > 3)
      throw e.error("the equation has order " + std::to_string(size - 1),
                    "only second-order equations can be solved");
    if (!is_zero(f.rest)) {
      std::string term = in_.text(f.rest);
      if (term.size() > 60) term = term.substr(0, 60) + "...";
      throw e.error("the equation is not homogeneous: the term " + term + " has no " + unknown_,
                    pattern);
    }
    if (size < 3)
      throw NoValue(e.error(size == 0 ? "everything cancels: there is no equation left"
                                      : "the coefficient of " + unknown_ + "'' is zero",
                            pattern));
    return f;
  }

private:
  struct Terms {
    Form form;
    std::vector<F> over_y = {}; // over_y[k] y^(k)/y for k > 0; what belongs to k = 0 is in the rest
  };

  static void drop_zeros(std::vector<F>& c) {
    while (!c.empty() && is_zero(c.back()))
      c.pop_back();
  }

  Terms read(const Expression& e) {
    if (!mentions(e)) return {{{}, in_.value(e)}};
    switch (e.kind()) {
    case Kind::name:
      return unknown_itself();
    case Kind::sum: {
      Terms total{{{}, zero_}};
      for (const Expression& term : e.operands())
        add(total, read(term));
      return total;
    }
    case Kind::negate:
      return scaled(read(e.operand(0)), in_.constant(-1));
    case Kind::product:
      return product(e);
    case Kind::quotient:
      return quotient(e);
    case Kind::power:
      if (e.operand(1).kind() == Kind::number && e.operand(1).number() == Integer(1))
        return read(e.operand(0));
      throw not_linear(e);
    case Kind::call:
      return call(e);
    case Kind::derivative:
      return differentiated(read(e.operand(0)), e.order(), e);
    case Kind::equation: {
      Terms left = read(e.operand(0));
      add(left, scaled(read(e.operand(1)), in_.constant(-1)));
      return left;
    }
    default:
      throw not_linear(e);
    }
  }

  bool mentions(const Expression& e) {
    const auto known = mentions_.find(e.id());
    if (known != mentions_.end()) return known->second;
    if (e.kind() == Kind::call && e.name() == "root") return false; // a constant
    const bool named = e.kind() == Kind::name || e.kind() == Kind::call;
    bool result = (named && e.name() == unknown_) || e.kind() == Kind::derivative ||
                  e.kind() == Kind::equation || is_diff(e);
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

  [[nodiscard]] Terms unknown_itself() const { return {{{in_.constant(1)}, zero_}}; }

  void add(std::vector<F>& a, const std::vector<F>& b) const {
    if (a.size() < b.size()) a.resize(b.size(), zero_);
    for (std::size_t i = 0; i < b.size(); ++i)
      a[i] += b[i];
  }
  void add(Terms& a, const Terms& b) const {
    add(a.form.c, b.form.c);
    add(a.over_y, b.over_y);
    a.form.rest += b.form.rest;
  }

  static Terms scaled(Terms a, const F& f) {
    for (std::vector<F>* list : {&a.form.c, &a.over_y})
      for (F& c : *list)
        c *= f;
    a.form.rest *= f;
    return a;
  }

  [[nodiscard]] F inverse(const F& f, const Expression& at) const {
    if (is_zero(f)) throw at.error("division by zero");
    return in_.constant(1) / f;
  }

  Terms product(const Expression& e) {
    F factor = in_.constant(1);
    const Expression* linear = nullptr;
    for (const Expression& operand : e.operands()) {
      if (!mentions(operand)) {
        factor *= in_.value(operand);
        in_.check(factor);
      } else if (linear != nullptr) {
        throw not_linear(e);
      } else {
        linear = &operand;
      }
    }
    return scaled(read(*linear), factor);
  }

  Terms quotient(const Expression& e) {
    const Expression& below = e.operand(1);
    if (!mentions(below)) return scaled(read(e.operand(0)), inverse(in_.value(below), below));
    Terms d = read(below), n = read(e.operand(0));
    drop_zeros(d.form.c);
    const bool of_y = d.form.c.size() == 1 && is_zero(d.form.rest) && d.over_y.empty();
    if (!of_y || !is_zero(n.form.rest) || !n.over_y.empty()) throw not_linear(e);
    n = scaled(std::move(n), inverse(d.form.c.front(), below));
    std::swap(n.form.c, n.over_y);
    if (!n.over_y.empty()) n.form.rest = std::exchange(n.over_y.front(), zero_);
    return n;
  }

  Terms call(const Expression& e) {
    if (e.name() == unknown_) { // y(z)
      need_own_argument(e, unknown_, variable_);
      return unknown_itself();
    }
    if (!is_diff(e)) throw not_linear(e);
    return differentiated(read(e.operand(0)), order_of_diff(e, unknown_, variable_), e);
  }

  // (sum c_k y^(k))' = sum c_k' y^(k) + c_k y^(k+1)
  [[nodiscard]] Terms differentiated(Terms a, long order, const Expression& at) const {
    if (order > 0 && !a.over_y.empty()) throw not_linear(at);
    if (static_cast<long>(a.form.c.size()) + order > highest_derivative + 1)
      throw at.error("only second-order equations can be solved");
    for (; order > 0; --order) {
      std::vector<F>& c = a.form.c;
      std::vector<F> b(c.empty() ? 0 : c.size() + 1, zero_);
      a.form.rest = in_.derivative(a.form.rest);
      for (std::size_t k = 0; k < c.size(); ++k) {
        b[k] += in_.derivative(c[k]);
        b[k + 1] += c[k];
      }
      c = std::move(b);
    }
    return a;
  }

  std::string unknown_;
  std::string variable_;
  const FieldOfCoefficients<F>& in_;
  F zero_;
  std::unordered_map<const void*, bool> mentions_;
};

} // namespace kov
