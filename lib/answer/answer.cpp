#include "answer/answer.hpp"

#include "answer/classical_basis.hpp"
#include "answer/notation.hpp"
#include "answer/slope.hpp"
#include "elementary/homogeneous.hpp"
#include "equation/linear_form.hpp"
#include "exact/letters.hpp"
#include "exact/lists.hpp"
#include "exact/share.hpp"
#include "exact/tried.hpp"
#include "galois/basis.hpp"
#include "pullback/special_solution.hpp"
#include "strata/domain.hpp"
#include "strata/log_integral.hpp"
#include "strata/parametric_basis.hpp"
#include "strata/words.hpp"
#include "symbol/author_words.hpp"
#include "symbol/formula.hpp"
#include "symbol/read_back.hpp"
#include "symbol/written.hpp"

#include <algorithm>
#include <functional>
#include <set>

namespace kov::answer {
namespace {

using Kind = Expression::Kind;
using trees::call;
using trees::name;
using trees::number;
using trees::product;

Expression derivative_of(const Expression& y, long order) {
  return Expression::made(Kind::derivative, {y}, {}, order);
}

// ----- in the given variable

// (t - 1)^e (t + 1)^e is sin(g)^(2e) for t = cos(g), up to a constant.
Expression with_sines(const Expression& e, const std::string& t, const Expression& value) {
  if (value.kind() != Kind::call || (value.name() != "cos" && value.name() != "cosh")) return e;
  const auto all = powers_in(e);
  const auto at = [&](const Rational& c) { // t + c, c + t or their negatives
    const Expression sum = trees::sum({name(t), number(c)});
    const std::string text = written(sum), other = written(trees::negative(sum));
    return std::ranges::find_if(all, [&](const auto& x) {
      const std::string here = written(x.first);
      return here == text || here == other;
    });
  };
  const auto minus = at(-1), plus = at(1);
  if (minus == all.end() || plus == all.end() || written(minus->second) != written(plus->second))
    return e;
  std::vector<Expression> factors{
      trees::power(call(value.name() == "cos" ? "sin" : "sinh", {value.operand(0)}),
                   product({number(2), minus->second}))};
  for (auto it = all.begin(); it != all.end(); ++it)
    if (it != minus && it != plus) factors.push_back(trees::power(it->first, it->second));
  return product(factors);
}

// t^2 - 1 is -sin(g)^2 for t = cos(g), sinh(g)^2 for cosh(g); t^2 + 1 is cos(g)^(-2) for tan(g).
std::map<std::string, Expression> squares_of(const std::string& t, const Expression& value) {
  if (value.kind() != Kind::call) return {};
  const auto square = [&](const char* f, long e) {
    return trees::power(call(f, {value.operand(0)}), number(e));
  };
  if (value.name() == "cos")
    return {{t + "^2 - 1", trees::negative(square("sin", 2))},
            {"1 - " + t + "^2", square("sin", 2)}};
  if (value.name() == "cosh")
    return {{t + "^2 - 1", square("sinh", 2)},
            {"1 - " + t + "^2", trees::negative(square("sinh", 2))}};
  if (value.name() == "tan") return {{t + "^2 + 1", square("cos", -2)}};
  return {};
}

// Sums that have these texts, and integrals over t as integrals over the given variable.
Expression replaced(const Expression& e, const std::map<std::string, Expression>& sums,
                    const std::string& t, const Expression& rate, const std::string& variable) {
  if (e.kind() == Kind::sum)
    if (const auto it = sums.find(written(e)); it != sums.end()) return it->second;
  if (e.operands().empty()) return e;
  std::vector<Expression> all;
  for (const Expression& x : e.operands())
    all.push_back(replaced(x, sums, t, rate, variable));
  if (e.kind() == Kind::call && e.name() == "int" && all.size() == 2 && written(all[1]) == t)
    all = {product({all[0], rate}), name(variable)};
  return Expression::made(e.kind(), std::move(all), e.name(), e.order());
}

// acos(cos(g)) is g, acos(cosh(g)) is -I g: a branch.
Expression without_inverse(const Expression& e) {
  std::vector<Expression> all;
  for (const Expression& x : e.operands())
    all.push_back(without_inverse(x));
  if (e.kind() == Kind::call && e.name() == "acos" && all[0].kind() == Kind::call) {
    if (all[0].name() == "cos") return all[0].operand(0);
    if (all[0].name() == "cosh") return product({number(-1), name("I"), all[0].operand(0)});
  }
  return all.empty() ? e : Expression::made(e.kind(), std::move(all), e.name(), e.order());
}

Expression in_given_variable(const Given& given, const Expression& e) {
  if (!given.change) return e;
  const auto& [t, value] = *given.change;
  const Expression rate = slope(value, given.variable).value_or(number(1));
  const Expression there =
      replaced(with_sines(e, t, value), squares_of(t, value), t, rate, given.variable);
  return trees::rebuilt(without_inverse(trees::rebuilt(there, {{t, value}})));
}

// ----- real formulas

Expression with_other_signs(const Expression& e) {
  if (e.kind() != Kind::sum) return trees::negative(e);
  std::vector<Expression> terms;
  for (const Expression& x : e.operands())
    terms.push_back(trees::negative(x));
  return trees::sum(terms);
}

// M (A +- I B) exp(+-I a): M (A cos(a) - B sin(a)), M (A sin(a) + B cos(a))
void make_real(std::vector<Expression>& y) {
  if (y.size() != 2) return;
  const auto first = trees::phase_of(y[0]), second = trees::phase_of(y[1]);
  const auto same = [](const Expression& a, const Expression& b) {
    return written(a) == written(b);
  };
  if (!first || !second || !same(first->modulus, second->modulus) ||
      !same(first->real, second->real) ||
      !same(with_other_signs(first->imaginary), second->imaginary) ||
      !same(first->angle, trees::negative(second->angle)))
    return;
  const Expression minus = trees::negative(first->angle);
  const bool turned = trees::length_of(minus) < trees::length_of(first->angle);
  const Expression& a = turned ? minus : first->angle;
  const Expression& b = turned ? second->imaginary : first->imaginary;
  const Expression c = call("cos", {a}), s = call("sin", {a});
  const auto both = [&](const Expression& with_real, const Expression& with_imaginary) {
    return product({first->modulus,
                    trees::sum({product({first->real, with_real}), product({b, with_imaginary})})});
  };
  y = {both(c, trees::negative(s)), both(s, c)};
}

// ----- as a person writes it

/// Roots and logarithms of what is positive where the leading coefficient, as it was written, is: sqrt(1 - x) beside
/// (1 - x^2)*y''.
class AsWritten {
public:
  explicit AsWritten(const Given& given) : x_(given.variable) {
    if (given.ode.kind() != Kind::equation) return;
    const Expression left =
        trees::sum({given.ode.operand(0), trees::negative(given.ode.operand(1))});
    std::map<std::string, Rational> at;
    for (const std::string& letter : names_in(given.ode)) // parameters, if they stand there at all
      if (letter != given.unknown) at.emplace(letter, Rational(11, 16));
    bool has_signs = false;
    for (const Rational& x : {Rational(3, 8), Rational(-3, 8), Rational(13, 4), Rational(-13, 4)}) {
      at[x_] = x;
      // (x - x0)^2/2 for y: what is left of the equation at x0 is its leading coefficient
      const Expression y = parse_expression("(" + x_ + " - (" + to_string(x) + "))^2/2", "a point");
      const auto sign = sign_at(left, at, x_, {{given.unknown, y}});
      if (sign == 1 && !point_) point_ = x;
      has_signs = has_signs || sign == -1;
    }
    if (!has_signs) point_.reset();
  }

  Expression operator()(const Expression& y) const {
    Expression best = with_real_bases(together(y));
    std::vector<Expression> front;
    std::optional<Expression> sum;
    for (const auto& [base, exponent] : powers_in(best)) {
      const bool is_sum = base.kind() == Kind::sum && trees::is_number(exponent, 1);
      if (is_sum && sum) return best;
      if (is_sum)
        sum = base;
      else
        front.push_back(trees::power(base, exponent));
    }
    if (!sum) return best;
    Expression out = trees::rebuilt(distributed(product(front), *sum));
    if (written(out).starts_with('-')) out = distributed(number(-1), out);
    return trees::length_of(out) < trees::length_of(best) ? out : best;
  }

private:
  // sqrt(x - 1) sqrt(x + 1) is sqrt(x^2 - 1).
  [[nodiscard]] Expression together(const Expression& y) const {
    auto all = powers_in(y);
    const Expression minus_x = trees::negative(name(x_));
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        auto& [a, e] = all[i];
        auto& [b, f] = all[k];
        const auto rate = a.kind() == Kind::sum ? slope(a, x_) : std::nullopt;
        if (b.kind() != Kind::sum || written(e) != written(f) || is_whole(e)) continue;
        if (!rate || !(trees::is_number(*rate, 1) || trees::is_number(*rate, -1))) continue;
        const std::string mirrored = written(trees::rebuilt(a, {{x_, minus_x}}));
        if (mirrored != written(b) && mirrored != written(distributed(number(-1), b))) continue;
        const Expression c = trees::rebuilt(a, {{x_, number(0)}});
        a = trees::sum(
            {trees::power(name(x_), number(2)), trees::negative(trees::power(c, number(2)))});
        b = number(1);
      }
    std::vector<Expression> factors;
    for (const auto& [base, exponent] : all)
      if (!trees::is_number(base, 1)) factors.push_back(trees::power(base, exponent));
    return product(factors);
  }
  static bool is_whole(const Expression& e) {
    const auto value = as_rational(e);
    return value && is_integer(*value);
  }

  [[nodiscard]] Expression with_real_bases(const Expression& e) const {
    if (!point_ || e.operands().empty()) return e;
    std::vector<Expression> all;
    for (const Expression& x : e.operands())
      all.push_back(with_real_bases(x));
    const bool root = (e.kind() == Kind::power && !is_whole(e.operand(1))) ||
                      (e.kind() == Kind::call && (e.name() == "sqrt" || e.name() == "log"));
    if (root && sign_at(all[0], {{x_, *point_}}) == -1) {
      const bool q = all[0].kind() == Kind::quotient;
      const Expression above = distributed(number(-1), q ? all[0].operand(0) : all[0]);
      all[0] = q ? trees::quotient(above, all[0].operand(1)) : above;
    }
    return Expression::made(e.kind(), std::move(all), e.name(), e.order());
  }

  std::string x_;
  std::optional<Rational> point_;
};

// A number in front says nothing.
Expression without_number(const Expression& e) {
  const auto bare = [](const Expression& x) { return x.kind() == Kind::negate ? x.operand(0) : x; };
  const Expression f = bare(e);
  if (as_rational(f)) return number(1);
  if (f.kind() == Kind::product && as_rational(f.operand(0))) {
    const std::vector<Expression> rest(f.operands().begin() + 1, f.operands().end());
    return product(rest);
  }
  if (f.kind() == Kind::quotient) {
    const Expression above = without_number(f.operand(0)), below = f.operand(1);
    if (as_rational(below)) return above;
    return trees::quotient(above, below.kind() == Kind::product ? without_number(below) : below);
  }
  return f;
}

// ----- where the formulas come from

// K(z), K = Q or Q(a) with a as a letter.
std::optional<MFraction> with_letter(const RationalFunction& f, const Ring& ring) {
  const std::string letter = f.field()->letter();
  if (f.field()->degree() == 1) return from_rational_function(f, ring, 0);
  if (!ring->find(letter)) return std::nullopt;
  const MFraction a = MFraction::variable(ring, letter), z = MFraction::variable(ring, 0);
  const auto polynomial = [&](const Poly& p) {
    MFraction sum(ring);
    for (long i = 0; i <= degree(p); ++i)
      for (long k = 0; k < f.field()->degree(); ++k)
        if (const Rational c = p.coeff(i).coeff(k); !is_zero(c)) sum += c * pow(a, k) * pow(z, i);
    return sum;
  };
  return polynomial(f.num()) / polynomial(f.den());
}

Ring ring_of(const std::string& variable, const RationalFunction& p, const RationalFunction& q) {
  std::vector<std::string> names{variable};
  for (const RationalFunction* f : {&p, &q})
    if (f->field()->degree() > 1 && names.size() == 1 && is_identifier(f->field()->letter()))
      names.push_back(f->field()->letter());
  return make_ring(names);
}

std::vector<Expression> both(const ClassicalBasis& b) { return {b.first, b.second}; }

// exp(int g)
std::optional<Expression> exponential_of(const MFraction& g) {
  const auto y = strata::log_integral(g, 0);
  if (!y) return std::nullopt;
  std::vector<Expression> factors{call("exp", {trees::from(y->exponential)})};
  for (const auto& [base, exponent] : y->powers)
    factors.push_back(trees::power(trees::from(base), trees::from(exponent)));
  return product(factors);
}

// sqrt(h) (A F(f) + B F'(f)), F'' = R F, F a function with a name.
std::vector<Expression> behind_a_map(const SpecialSolution& s, const Expression& variable,
                                     const RationalFunction& gauge) {
  const std::string x = "X_";
  const Ring ring = ring_of(x, s.standard, s.f), outer = ring_of("Z_", s.a, s.b);
  const auto standard = with_letter(s.standard, ring);
  const auto f = with_letter(s.f, outer), a = with_letter(s.a, outer), b = with_letter(s.b, outer),
             h = with_letter(RationalFunction(s.h), outer), g = with_letter(gauge, outer);
  if (!standard || !f || !a || !b || !h || !g) return {};
  const auto known = classical_basis(MFraction(ring), -*standard, 0);
  const auto front = exponential_of(*g);
  if (!known || !front) return {};
  std::vector<Expression> all;
  for (const Expression& u : both(*known)) {
    const auto du = is_zero(*b) ? std::optional(number(0)) : slope(u, x);
    if (!du) return {};
    const std::map<std::string, Expression> there{{x, trees::from(*f)}};
    const Expression inside = trees::sum({product({trees::from(*a), trees::rebuilt(u, there)}),
                                          product({trees::from(*b), trees::rebuilt(*du, there)})});
    all.push_back(trees::rebuilt(
        product({*front, trees::power(trees::from(*h), number(Rational(1, 2))), inside}),
        {{"Z_", variable}}));
  }
  return all;
}

std::vector<Expression> liouvillian(const Decision& d, const RationalFunction& gauge,
                                    const Budget& budget) {
  const auto known = basis_of(d, gauge, budget);
  if (!known) return {};
  std::vector<Expression> all;
  for (const std::string& text : {known->first, known->second})
    all.push_back(trees::rebuilt(parse_expression(text, "a solution")));
  return all;
}

std::vector<Expression> with_a_name(const GivenEquation& e, const Decision& d,
                                    const RationalFunction& gauge, bool maps,
                                    const Budget& budget) {
  const Ring ring = ring_of(e.variable, e.p, e.q);
  const auto p = with_letter(e.p, ring), q = with_letter(e.q, ring);
  if (p && q)
    if (const auto found = classical_basis(*p, *q, 0)) return both(*found);
  if (!maps || !d.places || !d.group || d.group->type != GroupType::SL2) return {};
  constexpr double courtesy = 2e8; // units of work, some seconds: nobody asked for it
  const auto found = special_solution(*d.places, at_most(budget, courtesy));
  if (!found) return {};
  return behind_a_map(*found, parse_expression(d.variable, "a variable"), gauge);
}

} // namespace

std::optional<std::pair<std::string, std::string>>
basis_of(const Decision& d, const RationalFunction& gauge, const Budget& budget) {
  if (d.no_solutions || d.solutions.empty() || d.proof() == nullptr) return std::nullopt;
  const auto both = basis(*d.proof(), d.r, d.solutions, d.variable, gauge, budget);
  if (!both) return std::nullopt;
  return std::pair{both->first, both->second};
}

Given given_equation(const EquationText& text) {
  std::map<std::string, Expression> values;
  for (const auto& [letter, value] : text.set)
    values.emplace(letter, value);
  if (text.change) {
    const Expression change = parse_expression(text.change->formula, "a variable", true);
    return {text.change->given, text.change->unknown, text.change->variable,
            std::pair{change.operand(0).name(), change.operand(1)}, std::move(values)};
  }
  EquationNames names = equation_names(text);
  if (text.ode) return {*text.ode, names.unknown, names.variable, {}, std::move(values)};
  std::set<std::string> taken{names.variable};
  for (const auto& f : {text.r, text.p, text.q})
    if (f)
      for (const std::string& letter : names_in(*f))
        taken.insert(letter);
  names.unknown = FreshLetters(taken)("y");
  const Expression y = name(names.unknown);
  const auto of = [&](const Expression& c, long order) {
    const Expression f = order == 0 ? y : derivative_of(y, order);
    if (trees::is_number(c, 1)) return f;
    if (trees::is_number(c, -1)) return Expression::made(Kind::negate, {f});
    return Expression::made(Kind::product, {c, f});
  };
  const Expression second = derivative_of(y, 2);
  const Expression left =
      text.r ? second : Expression::made(Kind::sum, {second, of(*text.p, 1), of(*text.q, 0)});
  return {Expression::made(Kind::equation, {left, text.r ? of(*text.r, 0) : number(0)}),
          names.unknown,
          names.variable,
          {},
          std::move(values)};
}

namespace {

std::optional<Expression> second_solution(const Given& given, const Expression& first) {
  const Expression ode = trees::rebuilt(given.ode, given.values);
  std::set<std::string> names;
  for (const Expression& f : {ode, first})
    for (const std::string& letter : names_in(f))
      names.insert(letter);
  for (const std::string& letter : {given.variable, given.unknown, std::string("I")})
    names.erase(letter);
  return tried<elementary::NotElementary, InputError, DomainError>([&] {
    const auto letters = std::make_shared<elementary::Letters>(
        given.variable, std::vector<std::string>(names.begin(), names.end()));
    const std::string text =
        elementary::text(second_solution(elementary::linear_equation(ode, given.unknown, letters),
                                         elementary::element(first, letters)));
    return std::optional(trees::rebuilt(parse_expression(text, "a solution")));
  });
}

// A second solution that is a product with a sum of integrals and logarithms, multiplied out where that is shorter.
void close_integrals(const Given& given, std::vector<Expression>& y) {
  if (y.size() != 2) return;
  const auto weight = [](const Expression& f) {
    return std::pair(mentions_name(f, "int"), trees::length_of(f));
  };
  constexpr std::size_t longest = 300;
  if (!mentions_name(y[1], "int") && !mentions_name(y[1], "log")) return;
  if (trees::length_of(y[0]) > longest || trees::length_of(given.ode) > longest) return;
  if (const auto other = second_solution(given, y[0]); other && weight(*other) < weight(y[1]))
    y[1] = *other;
}

std::vector<Expression> in_its_letters(const Given& given, std::vector<Expression> formulas,
                                       const Style& style) {
  for (Expression& y : formulas)
    y = in_given_variable(given, trees::rebuilt(y));
  close_integrals(given, formulas);
  if (!style.complex) make_real(formulas);
  for (Expression& y : formulas)
    y = without_number(y);
  return formulas;
}

} // namespace

Solutions shown(const Given& given, std::vector<Expression> formulas, const Style& style) {
  Solutions out;
  const ReadBackEquation equation{given.ode, given.unknown, given.variable, given.values,
                                  style.constants};
  const AsWritten as_written(given);
  for (Expression& y : in_its_letters(given, std::move(formulas), style)) {
    const ReadBack result = read_back(for_programs(y), equation);
    if (const Expression other = as_written(y); written(other) != written(y))
      if (result == ReadBack::solves && read_back(for_programs(other), equation) == result)
        y = other;
    if (result == ReadBack::differs) {
      out.failed.push_back("the formula " + for_people(y) +
                           " was found, and does not solve the given equation: it is left out");
      continue;
    }
    if (result != ReadBack::solves) out.read_back = false;
    out.y.push_back(y);
  }
  return out;
}

Solutions solutions_of(const Given& given, const GivenEquation& equation, const Decision& decision,
                       const RationalFunction& gauge, const Style& style, const Budget& budget) {
  std::vector<Expression> y = liouvillian(decision, gauge, budget);
  if (y.empty()) y = with_a_name(equation, decision, gauge, style.maps, budget);
  Style here = style;
  if (!equation.constant.empty())
    here.constants.emplace(equation.constant, equation.constant_meaning);
  return shown(given, std::move(y), here);
}

namespace {

Solutions classical_solutions(const Given& given, const ParametricEquation& equation,
                              const Style& style) {
  const auto found = classical_basis(equation.p, equation.q, equation.question.z);
  if (!found) return {};
  Solutions out = shown(given, both(*found), style);
  for (const MPoly& f : found->nonzero)
    out.where.push_back(to_string(f) + " != 0");
  out.unless = found->unless;
  return out;
}

// exp(int gauge) in closed form, if that needs no condition.
std::optional<Expression> factor_of(const MFraction& gauge, std::size_t z,
                                    const ParametrisedSet& region, const Budget& budget) {
  const strata::Question zero{
      .r = MFraction(region.ring()), .z = z, .assumptions = {}, .generic = {}};
  const auto found = strata::solutions_on(zero, gauge, {}, region, budget);
  if (found.size() != 1 || !found.front().zero.empty() || !found.front().nonzero.empty())
    return std::nullopt;
  return trees::rebuilt(parse_expression(found.front().y.front(), "a solution"));
}

// Closed forms, or those in functions with a name, with conditions of their own.  domain: what does not vanish anywhere.
std::vector<Solutions> solutions_on_stratum(const Given& given, const ParametricEquation& equation,
                                            const strata::Stratum& stratum,
                                            const std::vector<MPoly>& domain, bool closed,
                                            const Style& style, const Budget& budget) {
  const std::size_t z = equation.question.z;
  const auto region = strata::region_of(equation.question, stratum, domain);
  if (!region) return {};
  std::vector<Solutions> all;
  const auto add = [&](std::vector<Expression> y, const std::vector<MPoly>& zero,
                       const std::vector<MPoly>& nonzero) {
    // p = 0 is solved for a parameter that is linear in it, and else nobody can put it into the equation
    ParametrisedSet there = *region;
    bool is_solved = true;
    for (const MPoly& p : zero) {
      const auto parts = irreducible_parts(there.restrict(MFraction(p)).num());
      is_solved = is_solved && parts.size() == 1;
      if (!is_solved) break;
      auto next = there.where_zero(parts.front());
      is_solved = std::holds_alternative<ParametrisedSet>(next);
      if (is_solved) there = std::get<ParametrisedSet>(std::move(next));
    }
    Given here = given;
    for (const auto& [i, value] : there.solved())
      here.values.insert_or_assign(region->ring()->name(i), trees::from(value));
    std::vector<std::string> where;
    for (const MPoly& p : zero)
      where.push_back(to_string(Condition{p, Sign::zero}));
    for (const MPoly& p : nonzero)
      where.push_back(to_string(Condition{p, Sign::nonzero}));
    Solutions one = is_solved
                        ? shown(here, std::move(y), style)
                        : Solutions{in_its_letters(given, std::move(y), style), {}, {}, {}, false};
    one.where = std::move(where);
    if (!one.y.empty() || !one.failed.empty()) all.push_back(std::move(one));
  };
  if (!closed) {
    const auto found =
        classical_basis(region->restrict(equation.p), region->restrict(equation.q), z);
    if (found) add(both(*found), {}, found->nonzero);
    return all;
  }
  const MFraction gauge = region->restrict(equation.gauge);
  const auto* at_a_point = strata::evidence<strata::Number>(stratum.leaf);
  const auto used = used_variables(gauge);
  const bool free = std::ranges::any_of(used, [&](std::size_t i) { return i != z; });
  if (at_a_point != nullptr && !is_zero(at_a_point->decision.r)) {
    const RationalFunction none;
    auto y =
        liouvillian(at_a_point->decision, free ? none : to_rational_function(gauge, z), budget);
    const auto factor = free ? factor_of(gauge, z, *region, budget) : std::nullopt;
    if (free && !factor) return all;
    if (free)
      for (Expression& one : y)
        one = product({*factor, one});
    if (!y.empty()) add(std::move(y), {}, {});
    return all;
  }
  for (const auto& x :
       strata::solutions_on(equation.question, equation.gauge, stratum.leaf, *region, budget)) {
    std::vector<Expression> y;
    for (const std::string& text : x.y)
      y.push_back(trees::rebuilt(parse_expression(text, "a solution")));
    add(std::move(y), x.zero, x.nonzero);
  }
  return all;
}

long equations(const strata::Stratum& s) {
  return std::ranges::count_if(s.conditions,
                               [](const Condition& c) { return c.sign == Sign::zero; });
}

} // namespace

FamilySolutions solutions_of(const Given& given, const ParametricEquation& equation,
                             const strata::StrataAnswer& decided, const Style& style,
                             const Budget& budget) {
  const auto domain = strata::domain(decided).nonzero;
  const auto strata = strata::on_domain(decided).told_apart();
  FamilySolutions out;
  if (decided.contradictory || strata.empty()) return out;
  std::optional<long> fewest;
  for (const strata::Stratum& s : strata)
    fewest = fewest ? std::min(*fewest, equations(s)) : equations(s);
  for (const strata::Stratum& s : strata) {
    out.on_strata.push_back(solutions_on_stratum(given, equation, s, domain, true, style, budget));
    const auto& here = out.on_strata.back();
    if (here.empty() || !out.general.y.empty() || equations(s) != *fewest) continue;
    out.general = here.front();
    // a formula solves the equation for all parameters, whether they are integers or not
    const auto conditions = in_pairs(s.conditions);
    const auto texts =
        mapped<std::string>(conditions, [](const Condition& c) { return to_string(c); });
    out.general.where.insert(out.general.where.begin(), texts.begin(), texts.end());
  }
  if (out.general.y.empty()) out.general = classical_solutions(given, equation, style);
  if (!out.general.y.empty()) return out;
  for (std::size_t i = 0; i < strata.size(); ++i) // another equation may be a classical one
    if (out.on_strata[i].empty() && equations(strata[i]) > *fewest)
      out.on_strata[i] =
          solutions_on_stratum(given, equation, strata[i], domain, false, style, budget);
  return out;
}

} // namespace kov::answer
