#include "equation/function_change.hpp"

#include "equation/function_kinds.hpp"
#include "exact/letters.hpp"
#include "symbol/constants.hpp"
#include "symbol/linear_reader.hpp"
#include "symbol/suggest.hpp"
#include "symbol/written.hpp"
#include "system/linear_formula.hpp"
#include "system/parameter_scope.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

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

using Texts = std::map<const void*, std::string>;

bool is_constant_to_name(const Expression& e) {
  if (e.kind() == Kind::name) return e.name() == "I";
  if (e.kind() == Kind::call) return e.name() == "sqrt" || e.name() == "root";
  const auto exponent = e.kind() == Kind::power ? as_rational(e.operand(1)) : std::nullopt;
  return exponent && !is_integer(*exponent);
}

Rational exponent_of(const CoefficientFunction& f) {
  return f.e.kind() == Kind::call ? Rational(1, 2) : *as_rational(f.e.operand(1));
}

/// The equation and the divisors as they are given, with the functions in them.
class GivenFormulas {
public:
  GivenFormulas(const Expression& equation, const std::string& y, const std::string& variable,
                const std::vector<Expression>& also)
      : ode(equation), divisors(also), unknown(y), x(variable), symbols(ode, unknown) {
    gather(ode);
    for (const Expression& d : divisors) {
      gather(d);
      symbols.take(names_in(d));
    }
    t = symbols.fresh("t");
    settle_constants(ode);
    for (const Expression& d : divisors)
      settle_constants(d);
    const auto names = symbols.names();
    ring = make_ring({names.begin(), names.end()});
    scope.emplace(ring, std::map<std::string, MFraction>{});
  }

  [[nodiscard]] Instead constants() {
    return [this](const Expression& e) -> std::optional<std::string> {
      if (!is_constant_to_name(e) || mentions_name(e, x)) return std::nullopt;
      return symbols(written(e));
    };
  }
  [[nodiscard]] MFraction value(const Expression& e) {
    return evaluate(parse_expression(written(e, constants()), "formula"), *scope);
  }
  [[nodiscard]] std::size_t at(const std::string& name) const { return ring->index(name); }
  [[nodiscard]] MFraction number(long n) const { return {ring, Rational(n)}; }
  [[nodiscard]] MFraction slope(const MFraction& f) const { return derivative(f, at(x)); }

  /// The function where its argument has this value, with which the variable has nothing to do.
  [[nodiscard]] std::string value_at(const CoefficientFunction& f,
                                     const MFraction& argument) const {
    if (f.family == FunctionFamily::root) return root_of(exponent_of(f), argument);
    if (!is_zero(argument)) return f.name + "(" + symbols.meant(to_string(argument)) + ")";
    try {
      return "(" + to_string(value_of(f, number(1), number(0))) + ")";
    } catch (const InputError&) {
      return "(1/0)";
    }
  }
  [[nodiscard]] std::string with(const Texts& texts) const {
    return written(ode, [&](const Expression& e) -> std::optional<std::string> {
      const auto known = texts.find(e.id());
      return known == texts.end() ? std::nullopt : std::optional(known->second);
    });
  }

  const Expression& ode;
  const std::vector<Expression>& divisors;
  std::string unknown, x, t;
  Symbols symbols;
  std::vector<CoefficientFunction> functions;
  Ring ring;
  std::optional<ParameterScope> scope;

private:
  void gather(const Expression& e) {
    if (is_function_of(e, x)) {
      functions.push_back(function_of(e));
      return;
    }
    for (const Expression& operand : e.operands())
      gather(operand);
  }
  // Every constant has its letter before the ring is made.
  void settle_constants(const Expression& e) { static_cast<void>(written(e, constants())); }
  [[nodiscard]] std::string root_of(const Rational& exponent, const MFraction& base) const {
    if (is_zero(base)) return sign(exponent) > 0 ? "0" : "(1/0)";
    if (is_one(base)) return "1";
    const std::string text = "(" + symbols.meant(to_string(base)) + ")";
    if (exponent.den() != Integer(2)) return "(" + text + "^(" + to_string(exponent) + "))";
    const Integer whole = floor_div(exponent.num(), Integer(2));
    return "(" + text + "^(" + to_string(whole) + ")*sqrt" + text + ")";
  }
};

// diff(f, x), diff(f, x, 2)
long primes_of(const Expression& e, const std::string& x) {
  const std::size_t n = e.operands().size();
  const bool by_x = n >= 2 && e.operand(1).kind() == Kind::name && e.operand(1).name() == x;
  const bool counted =
      n == 3 && e.operand(2).kind() == Kind::number && e.operand(2).number() <= Integer(3);
  if (!by_x || (n != 2 && !counted))
    throw e.error("this derivative is not understood beside functions of " + x, "write y' and y''");
  return counted ? to_long(e.operand(2).number()) : 1;
}

/// Functions of a letter t that are functions of a power of it.
class Letter {
public:
  Letter(Ring ring, std::size_t t) : ring_(std::move(ring)), t_(t) {}

  /// The largest m for which f is a function of t^m; 0 where t is not there.
  [[nodiscard]] long step_of(const MFraction& f) const {
    if (is_zero(f)) return 0;
    const Terms above = terms(f.num()), below = terms(f.den());
    long step = above.front().first - below.front().first;
    for (const Terms* side : {&above, &below})
      for (const auto& [k, c] : *side)
        step = std::gcd(step, k - side->front().first);
    return std::abs(step);
  }
  /// f as a function of t^m, with t written for t^m.
  [[nodiscard]] MFraction lowered(const MFraction& f, long m) const {
    if (is_zero(f)) return f;
    const MFraction t = MFraction::variable(ring_, t_);
    const auto sum = [&](const Terms& all) {
      MFraction result(ring_);
      for (const auto& [k, c] : all)
        result += MFraction(c) * pow(t, (k - all.front().first) / m);
      return result;
    };
    const Terms above = terms(f.num()), below = terms(f.den());
    const long shift = above.front().first - below.front().first;
    KOV_ENSURE(shift % m == 0);
    return sum(above) / sum(below) * pow(t, shift / m);
  }

private:
  using Terms = std::vector<std::pair<long, MPoly>>; // by the exponent of t
  [[nodiscard]] Terms terms(const MPoly& g) const {
    Terms all;
    for (const MPoly& c : coefficients(g, t_))
      all.emplace_back(static_cast<long>(all.size()), c);
    std::erase_if(all, [](const auto& term) { return is_zero(term.second); });
    return all;
  }

  Ring ring_;
  std::size_t t_;
};

// The arguments as integer multiples of one: g x.
MFraction common_slope(GivenFormulas& given) {
  std::vector<MFraction> slopes;
  for (const CoefficientFunction& f : given.functions) {
    const MFraction argument = given.value(f.e.operand(0));
    const MFraction slope = argument / MFraction::variable(given.ring, given.x);
    if (is_zero(slope) || uses(slope, given.at(given.x)))
      throw f.e.error("the argument of " + f.name + " is not a multiple of " + given.x,
                      "change the variable so that the coefficients become rational");
    slopes.push_back(slope);
  }
  Integer numerators(0), denominators(1);
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    const MFraction ratio = slopes[i] / slopes.front();
    if (!is_constant(ratio))
      throw given.functions[i].e.error("'" + std::string(given.functions[i].e.text()) + "' and '" +
                                           std::string(given.functions.front().e.text()) +
                                           "' have arguments whose quotient is not rational",
                                       "no one variable makes both rational");
    given.functions[i].multiple = to_rational(ratio);
    numerators = gcd(numerators, given.functions[i].multiple.num());
    denominators = lcm(denominators, given.functions[i].multiple.den());
  }
  Rational unit(numerators, denominators);
  if (sign(slopes.front().num().coefficient(0)) < 0) unit = -unit; // exp(x), not exp(-x)
  for (CoefficientFunction& f : given.functions) {
    f.multiple = f.multiple / unit;
    if (!fits_long(f.multiple.num()) || std::abs(to_long(f.multiple.num())) > largest_multiple)
      throw f.e.error("the arguments differ by too large a factor");
  }
  return slopes.front() * MFraction(given.ring, unit);
}

// (a x + b)^(k/n): all of one base.
std::pair<MFraction, long> common_base(GivenFormulas& given) {
  Integer n(1);
  MFraction common;
  for (CoefficientFunction& f : given.functions) {
    f.multiple = exponent_of(f);
    const MFraction base = given.value(f.e.operand(0));
    if (&f == &given.functions.front()) {
      common = base;
      const MFraction slope = given.slope(base);
      if (is_zero(slope) || uses(slope, given.at(given.x)))
        throw f.e.error("this is not a root of a linear function of " + given.x,
                        "change the variable to remove it");
    } else if (base != common) {
      throw f.e.error("roots of two functions of " + given.x,
                      "no one variable is known that makes both rational");
    }
    n = lcm(n, f.multiple.den());
  }
  if (n > Integer(largest_multiple)) throw given.ode.error("the exponent of a root is too large");
  return {common, to_long(n)};
}

class Change {
public:
  explicit Change(GivenFormulas& given) : given_(given), letter_(given.ring, given.at(given.t)) {}

  ChangedEquation operator()() {
    family_ = given_.functions.front().family;
    for (const CoefficientFunction& f : given_.functions)
      if (f.family != family_)
        throw f.e.error("no one variable makes '" + std::string(f.e.text()) + "' and '" +
                            std::string(given_.functions.front().e.text()) + "' rational",
                        "functions of one kind are expected: exp and hyperbolic ones, or sin and "
                        "cos, or roots of one linear function");
    if (family_ == FunctionFamily::root)
      std::tie(base_, n_) = common_base(given_);
    else
      g_ = common_slope(given_);
    return family_ == FunctionFamily::root         ? by_root()
           : family_ == FunctionFamily::hyperbolic ? by_exponential()
                                                   : by_tangent();
  }

private:
  // The equation where the common argument of all functions is 0, or does not change.
  [[nodiscard]] std::string elsewhere() const {
    Texts texts;
    const MFraction rest =
        family_ == FunctionFamily::root ? base_ - given_.slope(base_) * x() : given_.number(0);
    for (const CoefficientFunction& f : given_.functions)
      texts[f.e.id()] = given_.value_at(f, rest);
    return given_.with(texts);
  }

  // c0, c1, c2 with the functions, and x where it is a function of t, replaced by what they are in t.
  LinearFormOver<MFraction> form(const Texts& texts, const MFraction& speed,
                                 const std::string& x_in_t = {}) {
    const std::string text = written(given_.ode, in_t(texts, x_in_t));
    const Expression e = parse_expression(text, given_.ode.origin().file, true);
    if (mentions_name(e, given_.x))
      throw given_.ode.error("the coefficients have '" +
                                 std::string(given_.functions.front().e.text()) + "' and also " +
                                 given_.x + " outside of it",
                             "no change of variable makes both rational");
    const CoefficientsOverRing coefficients(*given_.scope, given_.at(given_.t), speed);
    auto read = LinearReader<MFraction>(given_.unknown, given_.t, coefficients).second_order(e);
    leading_ = to_string(MFraction(read.c[2].num()));
    for (const Expression& d : given_.divisors)
      in_t_.push_back(written(d, in_t(texts, x_in_t)));
    return read;
  }

  [[nodiscard]] Instead in_t(const Texts& texts, const std::string& x_in_t) {
    return [this, &texts, x_in_t](const Expression& e) -> std::optional<std::string> {
      if (const auto known = texts.find(e.id()); known != texts.end()) return known->second;
      if (e.kind() == Kind::call && e.name() == given_.unknown) {
        need_own_argument(e, given_.unknown, given_.x);
        return given_.unknown;
      }
      if (is_diff(e))
        return "(" + written(e.operand(0), in_t(texts, x_in_t)) + ")" +
               std::string(static_cast<std::size_t>(primes_of(e, given_.x)), '\'');
      if (e.kind() == Kind::name && e.name() == given_.x && !x_in_t.empty()) return x_in_t;
      return given_.constants()(e);
    };
  }
  // With t' = speed: y'' = speed^2 y_tt + speed speed_t y_t.
  void reduce(const LinearFormOver<MFraction>& f, const MFraction& speed) {
    p_ = (f.c[1] / f.c[2] + derivative(speed, given_.at(given_.t))) / speed;
    q_ = f.c[0] / (f.c[2] * speed * speed);
  }

  [[nodiscard]] ChangedEquation result(const std::string& change) const {
    const auto meant = [&](const std::string& text) { return given_.symbols.meant(text); };
    const MFraction speed = family_ == FunctionFamily::root ? given_.slope(base_) : g_;
    ChangedEquation e{.variable = given_.t,
                      .p = meant(to_string(p_)),
                      .q = meant(to_string(q_)),
                      .change = given_.t + " = " + meant(change),
                      .nonzero = meant(to_string(MFraction(speed.num()))),
                      .elsewhere = elsewhere(),
                      .leading = meant(leading_),
                      .divisors = {}};
    for (const std::string& d : in_t_)
      e.divisors.push_back(meant(d));
    return e;
  }
  [[nodiscard]] std::string argument(const MFraction& g) const { return to_string(g * x()); }
  [[nodiscard]] MFraction t() const { return MFraction::variable(given_.ring, given_.t); }
  [[nodiscard]] MFraction x() const { return MFraction::variable(given_.ring, given_.x); }
  [[nodiscard]] MFraction with_t(const MFraction& f, const MFraction& value) const {
    return substitute(f, {{given_.at(given_.t), value}});
  }

  ChangedEquation by_root() {
    Texts texts;
    for (const CoefficientFunction& f : given_.functions)
      texts[f.e.id()] = "(" + given_.t + "^(" + to_string(f.multiple * Rational(n_)) + "))";
    const MFraction slope = given_.slope(base_), rest = base_ - slope * x();
    const MFraction x = (pow(t(), n_) - rest) / slope;
    const MFraction speed = slope / (given_.number(n_) * pow(t(), n_ - 1));
    reduce(form(texts, speed, "(" + to_string(x) + ")"), speed);
    const std::string base = to_string(base_);
    return result((base == given_.x ? base : "(" + base + ")") + "^(1/" + std::to_string(n_) + ")");
  }

  // theta^2 y + P theta y + Q y = 0, theta = t d/dt.
  ChangedEquation by_exponential() {
    Texts texts;
    for (const CoefficientFunction& f : given_.functions) {
      const long m = to_long(f.multiple.num());
      const MFraction up = pow(t(), m), down = pow(t(), -m);
      texts[f.e.id()] = "(" +
                        to_string(value_of(f, f.name == "exp" ? up : Rational(1, 2) * (up + down),
                                           Rational(1, 2) * (up - down))) +
                        ")";
    }
    const auto c = form(texts, g_ * t());
    p_ = c.c[1] / (c.c[2] * g_), q_ = c.c[0] / (c.c[2] * g_ * g_);
    const long m = std::max(1L, std::gcd(letter_.step_of(p_), letter_.step_of(q_)));
    p_ = Rational(1, m) * letter_.lowered(p_, m), q_ = Rational(1, m * m) * letter_.lowered(q_, m);
    g_ = given_.number(m) * g_;
    const MFraction one = given_.number(1), inverse = one / t();
    if (is_odd_even(inverse)) { // cosh: t = (1 + tau)/(1 - tau), cosh = (1 + tau^2)/(1 - tau^2)
      const MFraction tau = t(), cosh = t(), there = (one + tau) / (one - tau);
      const MFraction sinh = given_.number(2) * tau / (one - tau * tau);
      const MFraction square = (cosh - one) / (cosh + one), length = cosh * cosh - one;
      const MFraction a = with_t(letter_.lowered(with_t(p_, there) * sinh, 2), square);
      p_ = (cosh + a) / length;
      q_ = with_t(letter_.lowered(with_t(q_, there), 2), square) / length;
      return result("cosh(" + argument(g_) + ")");
    }
    p_ = (one + p_) / t(), q_ = q_ / (t() * t());
    return result("exp(" + argument(g_) + ")");
  }

  // y'' + P y' + Q y = 0 by the angle, t = tan(angle/2).
  ChangedEquation by_tangent() {
    const MFraction one = given_.number(1), square = t() * t(),
                    speed = Rational(1, 2) * (one + square);
    const MFraction cosine = (one - square) / (one + square),
                    sine = given_.number(2) * t() / (one + square);
    Texts texts;
    for (const CoefficientFunction& f : given_.functions) {
      const long m = to_long(f.multiple.num());
      MFraction c = one, s = given_.number(0);
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
      const MFraction a = with_t(letter_.lowered(-p_ * sine, 2), half);
      p_ = (a - cos) / length;
      q_ = with_t(letter_.lowered(q_, 2), half) / length;
      return result("cos(" + argument(g_) + ")");
    }
    p_ = (t() + p_) / speed, q_ = q_ / (speed * speed);
    return result("tan(" + argument(Rational(1, 2) * g_) + ")");
  }

  // P(s(t)) = -P(t) and Q(s(t)) = Q(t): the equation does not change with x -> -x.
  [[nodiscard]] bool is_odd_even(const MFraction& reflected) const {
    if (!uses(p_, given_.at(given_.t)) && !uses(q_, given_.at(given_.t))) return false;
    return with_t(p_, reflected) == -p_ && with_t(q_, reflected) == q_;
  }

  GivenFormulas& given_;
  Letter letter_;
  std::string leading_;
  std::vector<std::string> in_t_; // the divisors
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
  GivenFormulas given(ode, unknown, variable, divisors);
  return Change(given)();
}

std::optional<std::string> with_constant_functions(const Expression& ode,
                                                   const std::string& unknown,
                                                   const std::string& variable) {
  if (!has_functions_of(ode, variable)) return std::nullopt;
  const std::vector<Expression> none;
  GivenFormulas given(ode, unknown, variable, none);
  Texts texts;
  for (const CoefficientFunction& f : given.functions)
    if (const MFraction argument = given.value(f.e.operand(0)); !uses(argument, given.at(variable)))
      texts[f.e.id()] = given.value_at(f, argument);
  if (texts.empty()) return std::nullopt;
  return given.with(texts);
}

} // namespace kov
