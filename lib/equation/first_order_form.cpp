#include "equation/first_order_form.hpp"

#include "exact/letters.hpp"
#include "symbol/constants.hpp"
#include "symbol/formula.hpp"
#include "symbol/linear_reader.hpp"
#include "symbol/written.hpp"
#include "system/parameter_scope.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace kov {
namespace {

using Kind = Expression::Kind;

// The order of a derivative of y itself; 0: none.
long order_of(const Expression& e, const std::string& y) {
  if (e.kind() != Kind::derivative && !is_diff(e)) return 0;
  const Expression& f = e.operand(0);
  const bool of_y = (f.kind() == Kind::name || f.kind() == Kind::call) && f.name() == y;
  if (!of_y) return 2; // of something else: no form of ours
  if (e.kind() == Kind::derivative) return e.order();
  return e.operands().size() == 2 ? 1 : 2;
}

long highest(const Expression& e, const std::string& y) {
  long n = order_of(e, y);
  for (const Expression& x : e.operands())
    n = std::max(n, highest(x, y));
  return n;
}

void need_own_arguments(const Expression& e, const std::string& y, const std::string& x) {
  if (e.kind() == Kind::call && e.name() == y) need_own_argument(e, y, x);
  for (const Expression& operand : e.operands())
    need_own_arguments(operand, y, x);
}

// y' and every call that is not a rational function get a letter.
class LettersForCalls {
public:
  LettersForCalls(const Expression& e, const std::string& y) : y_(y) {
    for (const std::string& name : names_in(e))
      taken_.insert(name);
    taken_.insert(y);
    rate = fresh("slope");
  }
  std::string fresh(std::string letter) {
    while (!taken_.insert(letter).second)
      letter += "_";
    return letter;
  }
  void take(const std::string& name) { taken_.insert(name); }
  [[nodiscard]] std::optional<std::string> operator()(const Expression& e) {
    if (order_of(e, y_) == 1) return rate;
    if (e.kind() == Kind::call && e.name() == y_) return y_;
    if (e.kind() != Kind::call && !is_other_power(e)) return std::nullopt;
    hidden = hidden || mentions_name(e, y_);
    const std::string text = written(e);
    auto& letter = letters_[text];
    if (letter.empty()) {
      letter = fresh("k" + std::to_string(letters_.size()));
      meanings_[letter] = text;
    }
    return letter;
  }
  [[nodiscard]] std::string meant(const MFraction& f) const {
    return renamed(to_string(f), meanings_);
  }
  [[nodiscard]] std::vector<std::string> names() const { return {taken_.begin(), taken_.end()}; }

  std::string rate;
  bool hidden = false; ///< does y stand in a call?

private:
  // y^n, y^(1/2) and, of what y is not in, all but x^2.
  [[nodiscard]] bool is_other_power(const Expression& e) const {
    if (e.kind() != Kind::power) return false;
    if (!mentions_name(e, y_)) return e.operand(1).kind() != Kind::number;
    const auto exponent = as_rational(e.operand(1));
    return !exponent || !is_integer(*exponent);
  }

  std::string y_;
  std::set<std::string> taken_;
  std::map<std::string, std::string> letters_, meanings_;
};

bool is_atom(const std::string& text) { return text.find_first_of(" +-*/") == std::string::npos; }
std::string group(const std::string& text) { return is_atom(text) ? text : "(" + text + ")"; }

// "+ c*u", "- b*u'", "" for 0
std::string term(const MFraction& c, const std::string& text, const std::string& u) {
  if (is_zero(c)) return {};
  if (is_one(c)) return " + " + u;
  if (is_one(-c)) return " - " + u;
  return " + " + group(text) + "*" + u;
}

// y' = sum of c[k] y^k, with letters for calls.
using Powers = std::map<long, MFraction>;

std::optional<Powers> powers(const MPoly& equation, std::size_t y, std::size_t rate) {
  if (degree(equation, rate) != 1) return std::nullopt;
  const auto by_rate = coefficients(equation, rate);
  const auto above = coefficients(by_rate[0], y), below = coefficients(by_rate[1], y);
  const auto shift = static_cast<long>(below.size()) - 1;
  for (std::size_t i = 0; i + 1 < below.size(); ++i)
    if (!is_zero(below[i])) return std::nullopt;
  Powers all;
  for (std::size_t i = 0; i < above.size(); ++i)
    if (!is_zero(above[i]))
      all.emplace(static_cast<long>(i) - shift, -MFraction(above[i], below.back()));
  return all;
}

/// The equation in other letters.
class Forms {
public:
  Forms(LettersForCalls& letters, const Ring& ring, const Powers& powers, std::string y,
        const std::string& variable)
      : letters_(letters), ring_(ring), powers_(powers), y_(std::move(y)),
        x_(ring->find(variable)) {}

  // a (u'/a)' - b u' + a c u = 0, y = -u'/(a u); the derivative of a function with a letter is left to the reader.
  [[nodiscard]] FirstOrderForm riccati() const {
    const MFraction a = at(2), by_u = a * at(0);
    const std::string u = letters_.fresh("u"), shown = letters_.meant(a);
    const bool rational = is_rational(a);
    const MFraction by_rate = rational ? -at(1) - derivative(a, *x_) / a : -at(1);
    const std::string head =
        rational ? u + "''" : group(shown) + "*(" + u + "'/" + group(shown) + ")'";
    const MFraction inverse = MFraction(a.den(), a.num());
    const bool is_plain = is_one(a) || is_one(-a),
               is_quotient = is_constant(a.num()) && !is_constant(a);
    const std::string below = is_plain || is_quotient ? u : "(" + group(shown) + "*" + u + ")";
    const std::string sign = is_one(-a)    ? ""
                             : is_plain    ? "-"
                             : is_quotient ? "-" + group(letters_.meant(inverse)) + "*"
                                           : "-";
    return {FirstOrderForm::Kind::riccati,
            u,
            head + term(by_rate, u + "'") + term(by_u, u) + " = 0",
            y_ + " = " + sign + u + "'/" + below,
            shown,
            "",
            1};
  }

  // v = y^(1-n): v' = (1-n) (b v + d), and y'' = (b + b'/b) y' for what solves y' = b y, and the constants.
  [[nodiscard]] FirstOrderForm linear(long n) const {
    const Rational factor(1 - n);
    const bool bernoulli = n != 0;
    const std::string v = bernoulli ? letters_.fresh("v") : y_;
    const MFraction b = bernoulli ? factor * at(1) : at(1), d = bernoulli ? factor * at(n) : at(0);
    std::string decided = v + "''";
    if (!is_zero(b) && is_rational(b)) {
      decided += term(-b - derivative(b, *x_) / b, v + "'");
    } else if (!is_zero(b)) {
      const bool minus = letters_.meant(b).starts_with('-');
      decided = "(" + v + "'/" + group(letters_.meant(minus ? -b : b)) + ")'" +
                (minus ? " + " : " - ") + v + "'";
    }
    return {bernoulli ? FirstOrderForm::Kind::bernoulli : FirstOrderForm::Kind::linear,
            v,
            decided + " = 0",
            bernoulli
                ? y_ + " = " +
                      written(trees::power(trees::name(v), trees::number(Rational(1) / factor)))
                : "",
            "",
            v + "'" + term(-b, v) + " = " + letters_.meant(d),
            Rational(1) / factor};
  }

private:
  [[nodiscard]] MFraction at(long k) const {
    const auto it = powers_.find(k);
    return it == powers_.end() ? MFraction(ring_) : it->second;
  }
  [[nodiscard]] bool is_rational(const MFraction& f) const {
    return x_ && letters_.meant(f) == to_string(f);
  }
  [[nodiscard]] std::string term(const MFraction& c, const std::string& u) const {
    return kov::term(c, letters_.meant(c), u);
  }

  LettersForCalls& letters_;
  Ring ring_;
  const Powers& powers_;
  std::string y_;
  std::optional<std::size_t> x_;
};

} // namespace

std::optional<FirstOrderForm> first_order_form(const Expression& ode, const std::string& unknown,
                                               const std::string& variable) {
  if (highest(ode, unknown) != 1) return std::nullopt;
  if (!variable.empty()) need_own_arguments(ode, unknown, variable);
  LettersForCalls letters(ode, unknown);
  if (!variable.empty()) letters.take(variable);
  const std::string sides = sum_of(terms_of(ode), [&](const Expression& e) { return letters(e); });
  const Ring ring = make_ring(letters.names());
  const ParameterScope scope(ring, {});
  const MPoly f = evaluate(parse_expression(sides, ode.origin().file), scope).num();
  const auto found = powers(f, ring->index(unknown), ring->index(letters.rate));
  long n = 0; // the power that is not linear
  bool several = false;
  if (found)
    for (const auto& [k, c] : *found)
      if (k != 0 && k != 1) {
        several = several || n != 0;
        n = k;
      }
  const bool riccati = n == 2, inhomogeneous = found && found->contains(0);
  if (!found || letters.hidden || several || (n != 0 && !riccati && inhomogeneous))
    throw ode.error("this equation of the first order is not one that is solved here",
                    "solved are y' = b*y + c, y' = b*y + c*y^n and y' = a*y^2 + b*y + c with "
                    "functions a, b, c of the variable and an integer n");
  const Forms forms(letters, ring, *found, unknown, variable);
  FirstOrderForm form = riccati ? forms.riccati() : forms.linear(n);
  const auto need = [&](const MPoly& g) {
    if (!is_constant(g)) form.divisors.push_back(letters.meant(MFraction(g)));
  };
  need(coefficients(coefficients(f, ring->index(letters.rate))[1], ring->index(unknown)).back());
  if (riccati) need(found->at(2).num());
  return form;
}

} // namespace kov
