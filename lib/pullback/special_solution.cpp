#include "pullback/special_solution.hpp"

#include "exact/error.hpp"
#include "exact/factor.hpp"
#include "exact/joined.hpp"
#include "exact/letters.hpp"
#include "pullback/gauge.hpp"
#include "pullback/local.hpp"
#include "pullback/standard.hpp"

#include <vector>

namespace kov {
namespace {

using namespace pullback;

constexpr long largest_degree = 200; ///< of num(r) and den(r)

// p = k^2 h up to a constant, h squarefree.
std::pair<Poly, Poly> square_and_rest(const Poly& p) {
  Poly k(1), h(1);
  for (const Factor& factor : squarefree_factors(p)) {
    k *= pow(factor.base, static_cast<unsigned long>(factor.exponent / 2));
    if (factor.exponent % 2 == 1) h *= factor.base;
  }
  return {k, h};
}

// U = u(f)/sqrt(f'), U' = (f' u'(f) - f''/(2 f') u(f))/sqrt(f'); 1/f' = num den/num^2 of f'.
SpecialSolution written(const Candidate& c, const Gauge& gauge) {
  const RationalFunction slope = derivative(c.f);
  const auto [k, h] = square_and_rest(gauge.g * slope.num() * slope.den());
  const RationalFunction outer(k, slope.num());
  const RationalFunction half(Rational(1, 2));
  SpecialSolution y{c.family, c.standard, c.f, h, {}, {}};
  y.a = outer * (gauge.a - gauge.b * derivative(slope) * half / slope);
  y.b = outer * gauge.b * slope;
  // one constant is free
  const Poly& scale_of = is_zero(y.b) ? y.a.num() : y.b.num();
  const RationalFunction unit(Poly(inverse(lead(scale_of))));
  y.a = y.a * unit;
  y.b = y.b * unit;
  return y;
}

// x may be scaled: c x with c a root in K makes the standard equation simpler.
void normalise(SpecialSolution& y) {
  if (y.family != Classical::airy) return;
  const NfElem a = y.standard.num().coeff(1);
  const auto roots = roots_of(Poly(a), 3, Poly::z());
  if (roots.empty()) return;
  y.f = y.f * RationalFunction(roots.front());
  y.b = y.b * RationalFunction(roots.front());
  y.standard = RationalFunction(Poly::z());
}

} // namespace

bool satisfies(const SpecialSolution& y, const RationalFunction& r) {
  const RationalFunction half(Rational(1, 2));
  const RationalFunction root = derivative(RationalFunction(y.h)) / RationalFunction(y.h) * half;
  const RationalFunction slope = derivative(y.f);
  const RationalFunction behind = compose(y.standard, y.f) * slope;
  RationalFunction a = y.a, b = y.b;
  for (int i = 0; i < 2; ++i) {
    const RationalFunction next = derivative(a) + root * a + behind * b;
    b = derivative(b) + root * b + slope * a;
    a = next;
  }
  return (!is_zero(y.a) || !is_zero(y.b)) && a == r * y.a && b == r * y.b;
}

std::optional<SpecialSolution> special_solution(const Singularities& s, const Budget& budget) {
  if (degree(s.r.num()) > largest_degree || degree(s.r.den()) > largest_degree) return std::nullopt;
  std::optional<SpecialSolution> found;
  const Try tell = [&](const Candidate& c) {
    budget.check();
    const RationalFunction there = pulled_back(c.standard, c.f);
    if (is_zero(there)) return false; // y'' = 0 behind no map has the group SL(2)
    const auto gauge = find_gauge(s, singularities(there, budget), budget);
    if (!gauge) return false;
    found = written(c, *gauge);
    normalise(*found);
    KOV_ENSURE(satisfies(*found, s.r));
    return true;
  };
  if (try_airy(s, tell, budget) || try_whittaker(s, tell, budget) ||
      try_bessel_of_root(s, tell, budget) || try_riemann(s, tell, budget))
    return found;
  return std::nullopt;
}

namespace {

std::string in_parentheses(const std::string& text) { return "(" + text + ")"; }

// A text in front of or behind a *: sums get parentheses.
std::string as_factor(const std::string& text) {
  long depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += (text[i] == '(') - (text[i] == ')');
    if (i > 0 && depth == 0 && (text[i] == '+' || text[i] == '-')) return in_parentheses(text);
  }
  return text;
}

std::string root_text(const NfElem& square) {
  if (const auto root = exact_sqrt(square)) return to_string(*root);
  return "sqrt(" + to_string(square) + ")";
}

// a/sqrt(b)
std::string quotient_text(const NfElem& a, const NfElem& b) {
  if (const auto root = exact_sqrt(b)) return to_string(a / *root);
  return in_parentheses(to_string(a)) + "/sqrt(" + to_string(b) + ")";
}

// A name or a number needs no parentheses.
std::string factor_text(const RationalFunction& f, const std::string& variable) {
  const std::string text = to_string(f, variable);
  return text.find_first_of("+-*/^ ") == std::string::npos ? text : in_parentheses(text);
}

std::string power_text(const std::string& base, const NfElem& exponent) {
  if (is_zero(exponent)) return "";
  return is_one(exponent) ? base + "*" : base + "^(" + to_string(exponent) + ")*";
}

/// One solution in print: its variable x and the letters beside the names of the equation.
class Print {
public:
  Print(const SpecialSolution& y, const std::string& variable, std::set<std::string> taken)
      : y_(y), variable_(variable) {
    taken.merge(names_in_text(variable));
    taken.merge(names_in_text(y.f.field()->letter()));
    letter_ = FreshLetters(taken);
    const bool is_name = names_in_text(variable) == std::set<std::string>{variable};
    x_ = is_name && y.f == RationalFunction(Poly::z()) ? variable : letter_("x");
  }

  [[nodiscard]] SpecialSolutionText text() const {
    const std::string f = letter_("F");
    return {y_text(),
            f,
            x_,
            to_string(y_.f, variable_),
            f + "'' = " + in_parentheses(to_string(y_.standard, x_)) + " " + f,
            functions(),
            solutions(),
            named().where};
  }

private:
  // c x in brackets, c given by its square.
  [[nodiscard]] std::string argument(const NfElem& square) const {
    const std::string c = root_text(square);
    return "(" + (c == "1" ? "" : as_factor(c) + "*") + as_factor(x_) + ")";
  }

  [[nodiscard]] std::string y_text() const {
    std::vector<std::string> terms;
    const auto add = [&](const RationalFunction& f, const std::string& function) {
      if (is_zero(f)) return;
      const bool one = f == RationalFunction(1);
      terms.push_back((one ? "" : factor_text(f, variable_) + "*") + function +
                      (x_.front() == '(' ? x_ : in_parentheses(x_)));
    };
    add(y_.a, letter_("F"));
    add(y_.b, letter_("F") + "'");
    std::string sum = terms.front();
    if (terms.size() > 1) sum += " + " + terms.back();
    if (is_one(y_.h)) return sum;
    return "sqrt(" + to_string(y_.h, variable_) + ")*" +
           (terms.size() > 1 ? in_parentheses(sum) : sum);
  }

  /// Two F, and what their letters mean.
  struct Named {
    std::vector<std::string> functions;
    std::string where;
  };

  [[nodiscard]] Named airy() const {
    const NfElem a = y_.standard.num().coeff(1);
    if (is_one(a)) return {{"Ai(" + x_ + ")", "Bi(" + x_ + ")"}, ""};
    const std::string c = letter_("c"), argument = "(" + c + "*" + as_factor(x_) + ")";
    return {{"Ai" + argument, "Bi" + argument}, c + "^3 = " + to_string(a)};
  }

  // p = x^2 R: a x^2 + c, or x + c
  [[nodiscard]] Named bessel(const Poly& p) const {
    const std::string n = letter_("n");
    const auto both = [&](const char* first, const char* second, const std::string& argument,
                          const NfElem& order_squared) {
      const std::string root = "sqrt(" + x_ + ")*";
      return Named{{root + first + n + argument, root + second + n + argument},
                   n + " = " + root_text(order_squared)};
    };
    if (degree(p) == 1)
      return both("I_", "K_", "(2*sqrt(" + x_ + "))", NfElem(1) + NfElem(4) * p.coeff(0));
    return both("J_", "Y_", argument(-p.coeff(2)), p.coeff(0) + NfElem(Rational(1, 4)));
  }

  [[nodiscard]] Named whittaker(const Poly& p) const {
    const NfElem square = NfElem(4) * p.coeff(2);
    const std::string k = letter_("k"), m = letter_("m");
    const std::string of = "_(" + k + "," + m + ")" + argument(square);
    return {{"M" + of, "W" + of},
            k + " = " + quotient_text(-p.coeff(1), square) + ", " + m + " = " +
                root_text(p.coeff(0) + NfElem(Rational(1, 4)))};
  }

  // x^((1-l)/2) (1-x)^((1-m)/2) 2F1((1-l-m-n)/2, (1-l-m+n)/2; 1-l; x), and -l for l where that is
  // another function.
  [[nodiscard]] Named hypergeometric() const {
    const RationalFunction y(Poly::z() - Poly(1)), z(Poly::z());
    const auto root_at = [&](const RationalFunction& f, const NfElem& point) {
      const NfElem value = evaluate(f.num(), point) / evaluate(f.den(), point);
      return exact_sqrt(NfElem(1) + NfElem(4) * value);
    };
    const RationalFunction at_infinity = y_.standard * z * z;
    const bool vanishes = degree(at_infinity.num()) < degree(at_infinity.den());
    const auto l = root_at(at_infinity, NfElem(0)), m = root_at(y_.standard * y * y, NfElem(1)),
               n = exact_sqrt(NfElem(1) + (vanishes ? NfElem(0)
                                                    : NfElem(4) * lead(at_infinity.num()) /
                                                          lead(at_infinity.den())));
    if (!l || !m || !n) return {};
    const NfElem one(1), half(Rational(1, 2));
    const auto with = [&](const NfElem& l0) {
      const NfElem sum = one - l0 - *m;
      return power_text(as_atom(x_), (one - l0) * half) +
             power_text("(1 - " + as_factor(x_) + ")", (one - *m) * half) + "2F1(" +
             to_string((sum - *n) * half) + ", " + to_string((sum + *n) * half) + "; " +
             to_string(one - l0) + "; " + x_ + ")";
    };
    const bool integer = is_rational(*l) && is_integer(to_rational(*l));
    if (!integer) return {{with(*l), with(-*l)}, ""};
    return {{with(sign(to_rational(*l)) > 0 ? -*l : *l)}, ""}; // 1 - l is not a denominator then
  }

  // The variable may be z - c.
  static std::string as_atom(const std::string& x) { return is_plain(x) ? x : in_parentheses(x); }
  static bool is_plain(const std::string& x) {
    return x.find_first_of("+-*/^ ") == std::string::npos || x.front() == '(';
  }

  [[nodiscard]] Named named() const {
    const Poly p = (y_.standard * RationalFunction(Poly::z() * Poly::z())).num();
    switch (y_.family) {
    case Classical::airy:
      return airy();
    case Classical::bessel:
      return bessel(p);
    case Classical::whittaker:
      return whittaker(p);
    case Classical::riemann:
      return hypergeometric();
    default:
      return {};
    }
  }

  [[nodiscard]] std::string functions() const {
    const Named all = named();
    std::string text = joined(all.functions);
    return text + (all.where.empty() ? "" : " with " + all.where);
  }

  [[nodiscard]] std::vector<std::string> solutions() const {
    if (!is_zero(y_.b)) return {};
    std::vector<std::string> all = named().functions;
    const bool one = y_.a == RationalFunction(1);
    for (std::string& f : all)
      f.insert(0, (is_one(y_.h) ? "" : "sqrt(" + to_string(y_.h, variable_) + ")*") +
                      (one ? "" : factor_text(y_.a, variable_) + "*"));
    return all;
  }

  const SpecialSolution& y_;
  const std::string& variable_;
  FreshLetters letter_;
  std::string x_;
};

} // namespace

SpecialSolutionText printed(const SpecialSolution& y, const std::string& variable,
                            const std::set<std::string>& taken) {
  return Print(y, variable, taken).text();
}

} // namespace kov
