#include "equation/function_change.hpp"

#include "equation/function_kinds.hpp"
#include "exact/letters.hpp"
#include "symbol/constants.hpp"
#include "symbol/suggest.hpp"
#include "symbol/written.hpp"
#include "system/linear_formula.hpp"
#include "system/parameter_scope.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace kov {
namespace {

using Kind = Expression::Kind;

constexpr long largest_multiple = 60; // of one argument among the arguments
/// Names for the constants that are not rational numbers, so that they are variables of a ring.
class Symbols {
public:
  Symbols(const Expression& ode, const std::string& unknown) {
    for (const std::string& name : names_in(ode))
      if (name != unknown) taken_.insert(name);
    taken_.insert(unknown);
  }
  void take(const std::vector<std::string>& names) { taken_.insert(names.begin(), names.end()); }

  // The letter for sqrt(2), root(x^3 - 2, 1.26), I, 2^(1/3): one letter for one text.
  std::string operator()(const std::string& constant) {
    const auto known = letters_.find(constant);
    if (known != letters_.end()) return known->second;
    const std::string letter = fresh("k" + std::to_string(letters_.size() + 1));
    meanings_[letter] = "(" + constant + ")";
    return letters_[constant] = letter;
  }
  std::string fresh(std::string letter) {
    while (!taken_.insert(letter).second)
      letter += "_";
    return letter;
  }
  [[nodiscard]] std::string meant(const std::string& text) const {
    return renamed(text, meanings_);
  }
  [[nodiscard]] std::vector<std::string> names() const { return {taken_.begin(), taken_.end()}; }

private:
  std::set<std::string> taken_;
  std::map<std::string, std::string> letters_, meanings_;
};

MFraction evaluated(const std::string& text, const Scope& scope) {
  return evaluate(parse_expression(text, "formula"), scope);
}

class Change {
public:
  Change(const Expression& ode, const std::string& unknown, const std::string& x,
         const std::vector<Expression>& divisors)
      : ode_(ode), divisors_(divisors), unknown_(unknown), x_(x), symbols_(ode, unknown) {
    gather(ode);
    for (const Expression& d : divisors) {
      gather(d);
      symbols_.take(names_in(d));
    }
    t_ = symbols_.fresh("t");
    settle_constants(ode_);
    for (const Expression& d : divisors)
      settle_constants(d);
    const auto names = symbols_.names();
    ring_ = make_ring({names.begin(), names.end()});
    scope_.emplace(ring_, std::map<std::string, MFraction>{});
  }

  std::optional<std::string> with_constant_functions() {
    std::map<const void*, std::string> texts;
    for (CoefficientFunction& f : functions_)
      if (MFraction argument = value(f.e.operand(0)); !uses(argument, at(x_)))
        texts[f.e.id()] = value_at(f, argument);
    if (texts.empty()) return std::nullopt;
    return with(texts);
  }

  ChangedEquation operator()() {
    family_ = functions_.front().family;
    for (const CoefficientFunction& f : functions_)
      if (f.family != family_)
        throw f.e.error("no one variable makes '" + std::string(f.e.text()) + "' and '" +
                            std::string(functions_.front().e.text()) + "' rational",
                        "functions of one kind are expected: exp and hyperbolic ones, or sin and "
                        "cos, or roots of one linear function");
    if (family_ == FunctionFamily::root)
      roots();
    else
      multiples();
    return family_ == FunctionFamily::root         ? by_root()
           : family_ == FunctionFamily::hyperbolic ? by_exponential()
                                                   : by_tangent();
  }

private:
  // The function where its argument has this value, with which the variable has nothing to do.
  [[nodiscard]] std::string value_at(const CoefficientFunction& f,
                                     const MFraction& argument) const {
    if (f.family == FunctionFamily::root) return root_of(exponent_of(f), argument);
    if (!is_zero(argument)) return f.name + "(" + symbols_.meant(to_string(argument)) + ")";
    try {
      return "(" + to_string(value_of(f, number(1), number(0))) + ")";
    } catch (const InputError&) {
      return "(1/0)";
    }
  }
  [[nodiscard]] static Rational exponent_of(const CoefficientFunction& f) {
    return f.e.kind() == Kind::call ? Rational(1, 2) : *as_rational(f.e.operand(1));
  }
  [[nodiscard]] std::string root_of(const Rational& exponent, const MFraction& base) const {
    if (is_zero(base)) return sign(exponent) > 0 ? "0" : "(1/0)";
    if (is_one(base)) return "1";
    const std::string text = "(" + symbols_.meant(to_string(base)) + ")";
    if (exponent.den() != Integer(2)) return "(" + text + "^(" + to_string(exponent) + "))";
    const Integer whole = floor_div(exponent.num(), Integer(2));
    return "(" + text + "^(" + to_string(whole) + ")*sqrt" + text + ")";
  }
  [[nodiscard]] std::string with(const std::map<const void*, std::string>& texts) const {
    return written(ode_, [&](const Expression& e) -> std::optional<std::string> {
      const auto known = texts.find(e.id());
      return known == texts.end() ? std::nullopt : std::optional(known->second);
    });
  }
  // The equation where the common argument of all functions is 0, or does not change.
  [[nodiscard]] std::string elsewhere() const {
    std::map<const void*, std::string> texts;
    const MFraction rest = family_ == FunctionFamily::root
                               ? base_ - derivative(base_, at(x_)) * MFraction::variable(ring_, x_)
                               : number(0);
    for (const CoefficientFunction& f : functions_)
      texts[f.e.id()] = value_at(f, rest);
    return with(texts);
  }

  void gather(const Expression& e) {
    if (is_function_of(e, x_)) {
      functions_.push_back(function_of(e));
      return;
    }
    for (const Expression& x : e.operands())
      gather(x);
  }

  static bool is_constant_to_name(const Expression& e) {
    if (e.kind() == Kind::name) return e.name() == "I";
    if (e.kind() == Kind::call) return e.name() == "sqrt" || e.name() == "root";
    const auto exponent = e.kind() == Kind::power ? as_rational(e.operand(1)) : std::nullopt;
    return exponent && !is_integer(*exponent);
  }

  [[nodiscard]] Instead constants() {
    return [this](const Expression& e) -> std::optional<std::string> {
      if (!is_constant_to_name(e) || mentions_name(e, x_)) return std::nullopt;
      return symbols_(written(e));
    };
  }

  // Every constant has its letter before the ring is made.
  void settle_constants(const Expression& e) { static_cast<void>(written(e, constants())); }

  [[nodiscard]] MFraction value(const Expression& e) {
    return evaluated(written(e, constants()), *scope_);
  }
  [[nodiscard]] std::size_t at(const std::string& name) const { return ring_->index(name); }

  // The arguments as integer multiples of one: g x.
  void multiples() {
    std::vector<MFraction> slopes;
    for (const CoefficientFunction& f : functions_) {
      const MFraction argument = value(f.e.operand(0));
      const MFraction slope = argument / MFraction::variable(ring_, x_);
      if (is_zero(slope) || uses(slope, at(x_)))
        throw f.e.error("the argument of " + f.name + " is not a multiple of " + x_,
                        "change the variable so that the coefficients become rational");
      slopes.push_back(slope);
    }
    Integer numerators(0), denominators(1);
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      const MFraction ratio = slopes[i] / slopes.front();
      if (!is_constant(ratio))
        throw functions_[i].e.error("'" + std::string(functions_[i].e.text()) + "' and '" +
                                        std::string(functions_.front().e.text()) +
                                        "' have arguments whose quotient is not rational",
                                    "no one variable makes both rational");
      functions_[i].multiple = to_rational(ratio);
      numerators = gcd(numerators, functions_[i].multiple.num());
      denominators = lcm(denominators, functions_[i].multiple.den());
    }
    Rational unit(numerators, denominators);
    if (sign(slopes.front().num().coefficient(0)) < 0) unit = -unit; // exp(x), not exp(-x)
    g_ = slopes.front() * MFraction(ring_, unit);
    for (CoefficientFunction& f : functions_) {
      f.multiple = f.multiple / unit;
      if (!fits_long(f.multiple.num()) || std::abs(to_long(f.multiple.num())) > largest_multiple)
        throw f.e.error("the arguments differ by too large a factor");
    }
  }

  // (a x + b)^(k/n): all of one base.
  void roots() {
    Integer n(1);
    for (CoefficientFunction& f : functions_) {
      f.multiple = exponent_of(f);
      const MFraction base = value(f.e.operand(0));
      if (&f == &functions_.front()) {
        base_ = base;
        const MFraction slope = derivative(base, at(x_));
        if (is_zero(slope) || uses(slope, at(x_)))
          throw f.e.error("this is not a root of a linear function of " + x_,
                          "change the variable to remove it");
      } else if (base != base_) {
        throw f.e.error("roots of two functions of " + x_,
                        "no one variable is known that makes both rational");
      }
      n = lcm(n, f.multiple.den());
    }
    if (n > Integer(largest_multiple)) throw ode_.error("the exponent of a root is too large");
    n_ = to_long(n);
  }

  // c0, c1, c2 with the functions, and x where it is a function of t, replaced by what they are in t.
  LinearFormOver<MFraction> form(const std::map<const void*, std::string>& texts,
                                 const MFraction& speed, const std::string& x_in_t = {}) {
    const std::string text = written(ode_, in_t(texts, x_in_t));
    const Expression e = parse_expression(text, ode_.origin().file, true);
    if (mentions_name(e, x_))
      throw ode_.error("the coefficients have '" + std::string(functions_.front().e.text()) +
                           "' and also " + x_ + " outside of it",
                       "no change of variable makes both rational");
    const CoefficientsOverRing coefficients(*scope_, at(t_), speed);
    auto read = LinearReader<MFraction>(unknown_, t_, coefficients).second_order(e);
    leading_ = to_string(MFraction(read.c[2].num()));
    for (const Expression& d : divisors_)
      in_t_.push_back(written(d, in_t(texts, x_in_t)));
    return read;
  }

  [[nodiscard]] Instead in_t(const std::map<const void*, std::string>& texts,
                             const std::string& x_in_t) {
    return [this, &texts, x_in_t](const Expression& e) -> std::optional<std::string> {
      if (const auto known = texts.find(e.id()); known != texts.end()) return known->second;
      if (e.kind() == Kind::call && e.name() == unknown_) return unknown_of(e);
      if (is_diff(e))
        return "(" + written(e.operand(0), in_t(texts, x_in_t)) + ")" +
               std::string(static_cast<std::size_t>(order_of(e)), '\'');
      if (e.kind() == Kind::name && e.name() == x_ && !x_in_t.empty()) return x_in_t;
      return constants()(e);
    };
  }
  // y(x)
  [[nodiscard]] std::string unknown_of(const Expression& e) const {
    const bool plain =
        e.operands().size() == 1 && e.operand(0).kind() == Kind::name && e.operand(0).name() == x_;
    if (!plain) throw e.error("'" + unknown_ + "' is a function of " + x_);
    return unknown_;
  }
  // diff(f, x), diff(f, x, 2)
  [[nodiscard]] long order_of(const Expression& e) const {
    const std::size_t n = e.operands().size();
    const bool by_x = n >= 2 && e.operand(1).kind() == Kind::name && e.operand(1).name() == x_;
    const bool counted =
        n == 3 && e.operand(2).kind() == Kind::number && e.operand(2).number() <= Integer(3);
    if (!by_x || (n != 2 && !counted))
      throw e.error("this derivative is not understood beside functions of " + x_,
                    "write y' and y''");
    return counted ? to_long(e.operand(2).number()) : 1;
  }

  // With t' = speed: y'' = speed^2 y_tt + speed speed_t y_t.
  void reduce(const LinearFormOver<MFraction>& f, const MFraction& speed) {
    p_ = (f.c[1] / f.c[2] + derivative(speed, at(t_))) / speed;
    q_ = f.c[0] / (f.c[2] * speed * speed);
  }

  [[nodiscard]] ChangedEquation result(const std::string& change) const {
    const auto meant = [&](const std::string& text) { return symbols_.meant(text); };
    const MFraction speed = family_ == FunctionFamily::root ? derivative(base_, at(x_)) : g_;
    ChangedEquation e{.variable = t_,
                      .p = meant(to_string(p_)),
                      .q = meant(to_string(q_)),
                      .change = t_ + " = " + meant(change),
                      .nonzero = meant(to_string(MFraction(speed.num()))),
                      .elsewhere = elsewhere(),
                      .leading = meant(leading_),
                      .divisors = {}};
    for (const std::string& d : in_t_)
      e.divisors.push_back(meant(d));
    return e;
  }
  [[nodiscard]] std::string argument() const { return argument(g_); }
  [[nodiscard]] std::string argument(const MFraction& g) const {
    return to_string(g * MFraction::variable(ring_, x_));
  }
  [[nodiscard]] MFraction t() const { return MFraction::variable(ring_, t_); }
  [[nodiscard]] MFraction number(long n) const { return {ring_, Rational(n)}; }
  [[nodiscard]] MFraction with_t(const MFraction& f, const MFraction& value) const {
    return substitute(f, {{at(t_), value}});
  }

  ChangedEquation by_root() {
    std::map<const void*, std::string> texts;
    for (const CoefficientFunction& f : functions_)
      texts[f.e.id()] = "(" + t_ + "^(" + to_string(f.multiple * Rational(n_)) + "))";
    const MFraction slope = derivative(base_, at(x_)),
                    rest = base_ - slope * MFraction::variable(ring_, x_);
    const MFraction x = (pow(t(), n_) - rest) / slope;
    const MFraction speed = slope / (number(n_) * pow(t(), n_ - 1));
    reduce(form(texts, speed, "(" + to_string(x) + ")"), speed);
    const std::string base = to_string(base_);
    return result((base == x_ ? base : "(" + base + ")") + "^(1/" + std::to_string(n_) + ")");
  }

  // theta^2 y + P theta y + Q y = 0, theta = t d/dt.
  ChangedEquation by_exponential() {
    std::map<const void*, std::string> texts;
    for (const CoefficientFunction& f : functions_) {
      const long m = to_long(f.multiple.num());
      const MFraction up = pow(t(), m), down = pow(t(), -m);
      texts[f.e.id()] = "(" +
                        to_string(value_of(f, f.name == "exp" ? up : Rational(1, 2) * (up + down),
                                           Rational(1, 2) * (up - down))) +
                        ")";
    }
    const auto c = form(texts, g_ * t());
    p_ = c.c[1] / (c.c[2] * g_), q_ = c.c[0] / (c.c[2] * g_ * g_);
    const long m = std::max(1L, std::gcd(step_of(p_), step_of(q_)));
    p_ = Rational(1, m) * lowered(p_, m), q_ = Rational(1, m * m) * lowered(q_, m);
    g_ = number(m) * g_;
    const MFraction one = number(1), inverse = one / t();
    if (is_odd_even(inverse)) { // cosh: t = (1 + tau)/(1 - tau), cosh = (1 + tau^2)/(1 - tau^2)
      const MFraction tau = t(), cosh = t(), there = (one + tau) / (one - tau);
      const MFraction sinh = number(2) * tau / (one - tau * tau);
      const MFraction square = (cosh - one) / (cosh + one), length = cosh * cosh - one;
      const MFraction a = with_t(lowered(with_t(p_, there) * sinh, 2), square);
      p_ = (cosh + a) / length;
      q_ = with_t(lowered(with_t(q_, there), 2), square) / length;
      return result("cosh(" + argument() + ")");
    }
    p_ = (one + p_) / t(), q_ = q_ / (t() * t());
    return result("exp(" + argument() + ")");
  }

  // y'' + P y' + Q y = 0 by the angle, t = tan(angle/2).
  ChangedEquation by_tangent() {
    const MFraction one = number(1), square = t() * t(), speed = Rational(1, 2) * (one + square);
    const MFraction cosine = (one - square) / (one + square),
                    sine = number(2) * t() / (one + square);
    std::map<const void*, std::string> texts;
    for (const CoefficientFunction& f : functions_) {
      const long m = to_long(f.multiple.num());
      MFraction c = one, s = number(0);
      for (long i = 0; i < std::abs(m); ++i) {
        const MFraction next = c * cosine - s * sine;
        s = s * cosine + c * sine, c = next;
      }
      texts[f.e.id()] = "(" + to_string(value_of(f, c, m < 0 ? -s : s)) + ")";
    }
    const auto c = form(texts, g_ * speed);
    p_ = c.c[1] / (c.c[2] * g_), q_ = c.c[0] / (c.c[2] * g_ * g_);
    if (is_odd_even(-t())) { // cos: tan(angle/2)^2 = (1 - cos)/(1 + cos)
      const MFraction cos = t(), half = (one - cos) / (one + cos), length = one - cos * cos;
      const MFraction a = with_t(lowered(-p_ * sine, 2), half);
      p_ = (a - cos) / length;
      q_ = with_t(lowered(q_, 2), half) / length;
      return result("cos(" + argument() + ")");
    }
    p_ = (t() + p_) / speed, q_ = q_ / (speed * speed);
    return result("tan(" + argument(Rational(1, 2) * g_) + ")");
  }

  // P(s(t)) = -P(t) and Q(s(t)) = Q(t): the equation does not change with x -> -x.
  [[nodiscard]] bool is_odd_even(const MFraction& reflected) const {
    if (!uses(p_, at(t_)) && !uses(q_, at(t_))) return false;
    return with_t(p_, reflected) == -p_ && with_t(q_, reflected) == q_;
  }
  // The largest m for which f is a function of t^m; 0 where t is not there.
  [[nodiscard]] long step_of(const MFraction& f) const {
    if (is_zero(f)) return 0;
    const auto lowest = [&](const MPoly& g, long& step) {
      const auto c = coefficients(g, at(t_));
      long first = -1;
      for (std::size_t i = 0; i < c.size(); ++i) {
        if (is_zero(c[i])) continue;
        const long k = static_cast<long>(i);
        if (first < 0) first = k;
        step = std::gcd(step, k - first);
      }
      return first;
    };
    long step = 0;
    const long above = lowest(f.num(), step), below = lowest(f.den(), step);
    return std::gcd(step, above - below);
  }
  // f as a function of t^m, with t written for t^m.
  [[nodiscard]] MFraction lowered(const MFraction& f, long m) const {
    if (is_zero(f)) return f;
    const auto all = [&](const MPoly& g) {
      const auto c = coefficients(g, at(t_));
      MFraction sum(ring_);
      long first = -1;
      for (std::size_t i = 0; i < c.size(); ++i) {
        if (is_zero(c[i])) continue;
        const long k = static_cast<long>(i);
        if (first < 0) first = k;
        sum += MFraction(c[i]) * pow(t(), (k - first) / m);
      }
      return std::pair(sum, first);
    };
    const auto [above, a] = all(f.num());
    const auto [below, b] = all(f.den());
    KOV_ENSURE((a - b) % m == 0);
    return above / below * pow(t(), (a - b) / m);
  }

  const Expression& ode_;
  const std::vector<Expression>& divisors_;
  std::string unknown_, x_, t_, leading_;
  std::vector<std::string> in_t_; // the divisors
  Symbols symbols_;
  std::vector<CoefficientFunction> functions_;
  Ring ring_;
  std::optional<ParameterScope> scope_;
  FunctionFamily family_ = FunctionFamily::root;
  MFraction g_, base_, p_, q_;
  long n_ = 1;
};

} // namespace

bool has_functions_of(const Expression& e, const std::string& variable) {
  return is_function_of(e, variable) || std::ranges::any_of(e.operands(), [&](const Expression& x) {
           return has_functions_of(x, variable);
         });
}

std::optional<ChangedEquation> function_change(const Expression& ode, const std::string& unknown,
                                               const std::string& variable,
                                               const std::vector<Expression>& divisors) {
  if (!has_functions_of(ode, variable)) return std::nullopt;
  return Change(ode, unknown, variable, divisors)();
}

std::optional<std::string> with_constant_functions(const Expression& ode,
                                                   const std::string& unknown,
                                                   const std::string& variable) {
  if (!has_functions_of(ode, variable)) return std::nullopt;
  return Change(ode, unknown, variable, {}).with_constant_functions();
}

} // namespace kov
