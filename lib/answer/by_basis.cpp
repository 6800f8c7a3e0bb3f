#include "answer/by_basis.hpp"

#include "answer/notation.hpp"
#include "answer/slope.hpp"
#include "exact/letters.hpp"
#include "exact/tried.hpp"
#include "symbol/formula.hpp"
#include "symbol/read_back.hpp"
#include "symbol/written.hpp"

#include <algorithm>
#include <set>

namespace kov::answer {
namespace {

using Kind = Expression::Kind;
using trees::call;
using trees::name;
using trees::negative;
using trees::number;
using trees::product;
using trees::sum;

// A pair with its Wronskian, by the names of the arguments.
struct Pair {
  const char *first, *second, *arguments, *wronskian;
};
constexpr Pair pairs[]{{"besselj", "bessely", "nx", "2/(pi*x)"},
                       {"besseli", "besselk", "nx", "-1/x"},
                       {"airyai", "airybi", "x", "1/pi"},
                       {"legenp", "legenq", "n0x", "1/(1 - x^2)"}};

/// f F(a, ..., g)
struct Named {
  Expression front, function;
};

std::optional<Named> named(const Expression& y) {
  std::vector<Expression> front;
  std::optional<Expression> function;
  for (const auto& [base, exponent] : powers_in(y)) {
    const bool special = is_special(base);
    if (special && (function || !trees::is_number(exponent, 1))) return std::nullopt;
    if (special)
      function = base;
    else
      front.push_back(trees::power(base, exponent));
  }
  if (!function || function->kind() != Kind::call) return std::nullopt;
  return Named{product(front), *function};
}

struct Value {
  Expression point;
  long order = 0;
  Expression value;
};

bool same(const Expression& a, const Expression& b) { return written(a) == written(b); }

// -above/below with as few signs as there can be.
Expression minus_quotient(Expression above, Expression below) {
  bool minus = true;
  for (Expression* e : {&above, &below})
    if (written(*e).starts_with('-')) { // a sum begins with what is added, if anything is
      *e = distributed(number(-1), *e);
      minus = !minus;
    }
  const Expression q = trees::quotient(above, below);
  return minus ? negative(q) : q;
}

class ByBasis {
public:
  ByBasis(elementary::WholeAnswer& answer, const elementary::WholeEquation& e,
          const std::vector<Expression>& basis)
      : answer_(answer), e_(e), x_(e.variable), y_(basis) {
    std::set<std::string> taken;
    for (const Expression& f : {e.ode, y_[0], y_[1]})
      for (const std::string& letter : names_in(f))
        taken.insert(letter);
    taken.insert({e.variable, e.unknown});
    std::set<std::string> parameters = taken;
    for (const std::string& letter : {e.variable, e.unknown, std::string("I"), std::string("pi")})
      parameters.erase(letter);
    for (const Expression& f : e.conditions)
      for (const std::string& letter : names_in(f))
        if (letter != "I" && letter != "pi") parameters.insert(letter);
    letters_ = std::make_shared<elementary::Letters>(
        e.variable, std::vector<std::string>(parameters.begin(), parameters.end()), "pi");
    const FreshLetters fresh(taken);
    for (std::string* c : {&c1_, &c2_, &c_})
      *c = fresh(*c);
    for (const Expression& y : y_) {
      const auto d = slope(y, x_);
      if (!d) throw elementary::NotElementary("no derivative");
      slope_.push_back(*d);
    }
  }

  void operator()() { e_.riccati ? riccati() : linear(); }

private:
  // y1 y2' - y1' y2
  [[nodiscard]] Expression wronskian() const {
    const auto a = named(y_[0]), b = named(y_[1]);
    if (a && b && same(a->front, b->front))
      for (const Pair& p : pairs) {
        const auto& args = a->function.operands();
        bool fits = a->function.name() == p.first && b->function.name() == p.second;
        for (std::size_t i = 0; fits && i < args.size(); ++i)
          fits = same(args[i], b->function.operand(i)) &&
                 (p.arguments[i] != '0' || trees::is_number(args[i], 0));
        const auto rate = fits ? slope(args.back(), x_) : std::nullopt;
        if (!rate) continue;
        const Expression w = parse_expression(std::string(p.wronskian), "W");
        return product({a->front, a->front, *rate, trees::rebuilt(w, {{"x", args.back()}})});
      }
    return sum({product({y_[0], slope_[1]}), negative(product({slope_[0], y_[1]}))});
  }

  void linear() {
    const auto equation = elementary::linear_equation(e_.ode, e_.unknown, letters_);
    if (is_zero(equation.c2)) return; // of the first order
    const Expression w = wronskian(),
                     f = formula(elementary::simplified(equation.right / equation.c2));
    std::vector<Expression> terms{product({name(c1_), y_[0]}), product({name(c2_), y_[1]})};
    std::optional<Expression> particular;
    bool integrals = false;
    if (answer_.particular) {
      particular = parse_expression(*answer_.particular, "a solution");
    } else if (!trees::is_number(f, 0)) {
      const auto part = [&](std::size_t i, const Expression& other) {
        std::vector<Expression> factors, inside;
        for (const auto& [base, e] : powers_in(product({y_[i], f, trees::power(w, number(-1))})))
          (mentions_name(base, x_) || mentions_name(e, x_) ? inside : factors)
              .push_back(trees::power(base, e));
        factors.push_back(other);
        factors.push_back(call("int", {product(inside), name(x_)}));
        return product(factors);
      };
      particular = sum({part(0, y_[1]), negative(part(1, y_[0]))});
      answer_.particular = written(*particular);
      integrals = true;
    }
    if (particular) {
      const auto& rest = particular->operands();
      if (particular->kind() == Kind::sum)
        terms.insert(terms.end(), rest.begin(), rest.end());
      else
        terms.push_back(*particular);
      answer_.general = written(Expression::made(Kind::sum, terms));
    }
    if (e_.conditions.empty()) return;
    answer_.no_values = "c1 and c2 were not computed: two values at one point are needed";
    const auto v = values();
    if (v.size() != 2 || !same(v[0].point, v[1].point) || v[0].order + v[1].order != 1) return;
    answer_.no_values = "the solutions have no value at " + written(v[0].point);
    const bool turned = v[0].order == 1;
    Expression v0 = v[turned ? 1 : 0].value, v1 = v[turned ? 0 : 1].value;
    if (particular && !integrals) {
      const auto rate = slope(*particular, x_);
      if (!rate) return;
      v0 = sum({v0, negative(at(*particular, v[0]))});
      v1 = sum({v1, negative(at(*rate, v[0]))});
    }
    const auto constant = [&](const Expression& a, const Expression& b) {
      return product({trees::power(at(w, v[0]), number(-1)), sum({a, negative(b)})});
    };
    const Expression c1 = constant(product({v0, at(slope_[1], v[0])}),
                                   product({v1, at(y_[1], v[0])})),
                     c2 = constant(product({v1, at(y_[0], v[0])}),
                                   product({v0, at(slope_[0], v[0])}));
    std::vector<Expression> y{product({c1, y_[0]}), product({c2, y_[1]})};
    if (particular) y.push_back(*particular);
    put(sum(y), {c1, c2});
    if (integrals && answer_.with_values)
      answer_.integrals = "each integral starts at " + x_ + " = " + written(v[0].point);
  }

  void riccati() {
    const Expression a = trees::rebuilt(e_.riccati->a);
    const auto b = named(y_[0]), d = named(y_[1]);
    const Expression front = b && d && same(b->front, d->front) ? b->front : number(1);
    const Expression below = trees::power(front, number(-1));
    std::vector<Expression> u, du;
    for (std::size_t i = 0; i < 2; ++i) {
      u.push_back(product({below, y_[i]}));
      du.push_back(distributed(below, slope_[i]));
    }
    const auto solution = [&](const Expression& c, const Expression& k) {
      const auto both = [&](const std::vector<Expression>& f) {
        return sum({distributed(c, f[0]), distributed(k, f[1])});
      };
      return minus_quotient(both(du), product({a, both(u)}));
    };
    answer_.general = written(solution(number(1), name(c_)));
    if (e_.conditions.empty()) return;
    const auto v = values();
    answer_.no_values = "one value is needed for one function";
    if (v.size() != 1 || v[0].order != 0) return;
    answer_.no_values = "the solutions have no value at " + written(v[0].point);
    // u' + a y u = 0 at the point
    const auto residue = [&](std::size_t i) {
      return sum({at(du[i], v[0]), product({at(a, v[0]), v[0].value, at(u[i], v[0])})});
    };
    const Expression c = residue(1), k = negative(residue(0));
    put(solution(c, k), {c, k});
  }

  // Only where the constants have values.
  void put(const Expression& y, const std::vector<Expression>& constants) {
    if (!std::ranges::all_of(constants, has_value_somewhere)) return;
    answer_.no_values.clear();
    answer_.with_values = written(y);
  }

  [[nodiscard]] Expression at(const Expression& f, const Value& v) const {
    return trees::rebuilt(f, {{x_, v.point}});
  }

  [[nodiscard]] Expression formula(const elementary::Element& f) const {
    return trees::rebuilt(parse_expression(elementary::text(f), "a value"));
  }
  [[nodiscard]] std::vector<Value> values() const {
    std::vector<Value> all;
    for (const Expression& condition : e_.conditions) {
      const auto v = elementary::initial_value(condition, e_.unknown, letters_);
      all.push_back({formula(v.point), v.order, formula(v.value)});
    }
    return all;
  }

  elementary::WholeAnswer& answer_;
  const elementary::WholeEquation& e_;
  std::string x_, c1_ = "c1", c2_ = "c2", c_ = "c";
  std::vector<Expression> y_, slope_;
  elementary::LettersPtr letters_;
};

} // namespace

void answer_by_basis(elementary::WholeAnswer& answer, const elementary::WholeEquation& e,
                     const std::vector<Expression>& basis) {
  (void)tried<elementary::NotElementary, DomainError, InputError>(
      [&] { ByBasis(answer, e, basis)(); });
}

} // namespace kov::answer
