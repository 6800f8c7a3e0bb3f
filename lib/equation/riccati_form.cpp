#include "equation/riccati_form.hpp"

#include "exact/letters.hpp"
#include "symbol/linear_reader.hpp"
#include "symbol/written.hpp"
#include "system/parameter_scope.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace kov {
namespace {

using Kind = Expression::Kind;

bool is_power_of_unknown(const Expression& e, const std::string& y) {
  if (e.kind() == Kind::power && mentions_name(e.operand(0), y)) return true;
  if (e.kind() == Kind::product) {
    const auto n = std::ranges::count_if(e.operands(),
                                         [&](const Expression& x) { return mentions_name(x, y); });
    if (n > 1) return true;
  }
  return std::ranges::any_of(e.operands(),
                             [&](const Expression& x) { return is_power_of_unknown(x, y); });
}

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

// y' and every call that is not a rational function get a letter.
class LettersForCalls {
public:
  LettersForCalls(const Expression& e, const std::string& y) : y_(y) {
    for (const std::string& name : names_in(e))
      taken_.insert(name);
    taken_.insert(y);
    rate = fresh("v");
  }
  std::string fresh(std::string letter) {
    while (!taken_.insert(letter).second)
      letter += "_";
    return letter;
  }
  [[nodiscard]] std::optional<std::string> operator()(const Expression& e) {
    if (order_of(e, y_) == 1) return rate;
    if (e.kind() == Kind::call && e.name() == y_) return y_;
    const bool rational_power =
        e.kind() == Kind::power && e.operand(1).kind() != Kind::number && !mentions_name(e, y_);
    if (e.kind() != Kind::call && !rational_power) return std::nullopt;
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

private:
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

} // namespace

std::optional<RiccatiForm> riccati_form(const Expression& ode, const std::string& unknown,
                                        const std::string& variable) {
  if (!is_power_of_unknown(ode, unknown) || highest(ode, unknown) != 1) return std::nullopt;
  LettersForCalls letters(ode, unknown);
  std::string sides = sum_of(terms_of(ode), [&](const Expression& e) { return letters(e); });
  const std::string u = letters.fresh("u");
  const Ring ring = make_ring(letters.names());
  const ParameterScope scope(ring, {});
  const MFraction f = evaluate(parse_expression(sides, ode.origin().file), scope);
  const std::size_t y = ring->index(unknown), v = ring->index(letters.rate);
  const MPoly num = f.num();
  if (uses(f.den(), y) || uses(f.den(), v) || degree(num, v) != 1 || degree(num, y) != 2)
    return std::nullopt;
  const auto by_rate = coefficients(num, v);
  if (uses(by_rate[1], y)) return std::nullopt;
  const auto c = coefficients(by_rate[0], y);
  const auto part = [&](std::size_t i) { return -MFraction(c[i]) / MFraction(by_rate[1]); };
  const MFraction a = part(2), b = part(1), rest = part(0);
  // u'' - (b + a'/a) u' + a c u = 0; the derivative of a function with a letter is left to the reader.
  const auto x = ring->find(variable);
  const bool rational = letters.meant(a) == to_string(a);
  const MFraction by_u = a * rest, by_rate_of_u = rational && x ? -b - derivative(a, *x) / a : -b;
  const std::string shown = letters.meant(a);
  const std::string head =
      rational ? u + "''" : group(shown) + "*(" + u + "'/" + group(shown) + ")'";
  const std::string linear = head + term(by_rate_of_u, letters.meant(by_rate_of_u), u + "'") +
                             term(by_u, letters.meant(by_u), u) + " = 0";
  const MFraction inverse = MFraction(a.den(), a.num());
  const bool is_plain = is_one(a) || is_one(-a),
             is_quotient = is_constant(a.num()) && !is_constant(a);
  const std::string below = is_plain || is_quotient ? u : "(" + group(shown) + "*" + u + ")";
  const std::string sign = is_one(-a)    ? ""
                           : is_plain    ? "-"
                           : is_quotient ? "-" + group(letters.meant(inverse)) + "*"
                                         : "-";
  const auto text = [&](const MPoly& g) { return letters.meant(MFraction(g)); };
  return RiccatiForm{
      u, linear, shown, unknown + " = " + sign + u + "'/" + below, {text(by_rate[1]), text(c[2])}};
}

} // namespace kov
