#include "elementary/whole.hpp"

#include "elementary/check.hpp"
#include "exact/letters.hpp"
#include "exact/tried.hpp"
#include "symbol/formula.hpp"
#include "symbol/linear_reader.hpp"
#include "symbol/written.hpp"

#include <algorithm>
#include <set>

namespace kov::elementary {
namespace {

class Whole {
public:
  Whole(const WholeEquation& e, const std::function<std::optional<Basis>(const LettersPtr&)>& known)
      : e_(e), hyperbolic_(is_hyperbolic(e.ode)) {
    std::set<std::string> names;
    const auto take = [&](const Expression& f) {
      for (const std::string& name : names_in(f))
        names.insert(name);
    };
    take(e.ode);
    std::ranges::for_each(e.conditions, take);
    for (const std::string& name : {e.variable, e.unknown, std::string("I")})
      names.erase(name);
    if (e.riccati) names.erase(e.riccati->unknown);
    if (e.bernoulli) names.erase(e.bernoulli->unknown);
    std::set<std::string> taken = names;
    taken.insert({e.variable, e.unknown});
    const FreshLetters fresh(taken);
    for (std::string* c : {&c1_, &c2_, &c_}) {
      *c = fresh(*c);
      names.insert(*c);
    }
    const bool named = find_name(e.ode, "pi") != nullptr; // a parameter of this name is no number
    letters_ = std::make_shared<Letters>(
        e.variable, std::vector<std::string>(names.begin(), names.end()), named ? "" : "pi");
    known_ = [this, &known] { return known(letters_); };
  }

  WholeAnswer operator()() {
    (void)tried<NotElementary, DomainError>([&] {
      e_.riccati ? riccati() : e_.bernoulli ? bernoulli() : linear();
    }); // no formula of our form
    if (!e_.conditions.empty() && !answer_.with_values && answer_.no_values.empty())
      answer_.no_values = "no solution with these values was found";
    return std::move(answer_);
  }

private:
  [[nodiscard]] std::optional<Basis> basis(const LinearEquation& e) {
    auto both = homogeneous_basis(e);
    if (!both) both = known_();
    if (both) needs(dependent_where(*both));
    return both;
  }
  void needs(const std::vector<std::string>& nonzero) {
    for (const std::string& f : nonzero)
      if (!std::ranges::count(answer_.nonzero, f)) answer_.nonzero.push_back(f);
  }

  // Its text, if that solves the equation: it is read back.
  std::optional<std::string> told(const Element& y, const char* what) {
    needs(excluded(y));
    return told(text(y, hyperbolic_), what);
  }
  std::optional<std::string> told(const std::string& shown, const char* what) {
    if (holds_at_points(e_.ode, e_.unknown, parse_expression(shown, what), *letters_)) return shown;
    answer_.failed.push_back(std::string("the ") + what +
                             " is withdrawn: it does not solve the equation");
    return std::nullopt;
  }

  [[nodiscard]] std::vector<InitialValue> values() const {
    std::vector<InitialValue> all;
    for (const Expression& c : e_.conditions)
      all.push_back(initial_value(c, e_.unknown, letters_));
    return all;
  }

  [[nodiscard]] Element letter(const std::string& name) const {
    return {letters_, MFraction::variable(letters_->ring(), name)};
  }

  void linear() {
    const LinearEquation e = linear_equation(e_.ode, e_.unknown, letters_);
    if (is_zero(e.c2)) return first_order(e);
    const auto both = basis(e);
    if (!both && !e_.conditions.empty())
      answer_.no_values = "c1 and c2 were not computed: the solutions are not elementary functions";
    const auto particular = particular_solution(e, both);
    if (!particular) return;
    if (!is_zero(*particular)) answer_.particular = told(*particular, "particular solution");
    if (!both || (!is_zero(*particular) && !answer_.particular)) return;
    for (const Element* y : {&both->first, &both->second, &*particular})
      needs(excluded(*y));
    answer_.general =
        told(sum_text({{c1_, both->first}, {c2_, both->second}}, *particular), "general solution");
    if (e_.conditions.empty() || !answer_.general) return;
    put(kov::elementary::with_values(*both, *particular, values()));
  }

  void first_order(const LinearEquation& e) {
    const FirstOrderSolutions found = solutions_of(e);
    answer_.general =
        told(sum_text({{c_, found.homogeneous}}, found.particular), "general solution");
    if (e_.conditions.empty() || !answer_.general) return;
    if (const auto v = only_value()) put(with_value(found, *v));
  }

  FirstOrderSolutions solutions_of(const LinearEquation& e) {
    FirstOrderSolutions found = first_order_solutions(e);
    needs(excluded(found.homogeneous));
    needs(excluded(found.particular));
    return found;
  }

  std::optional<InitialValue> only_value() {
    const auto all = values();
    if (all.size() == 1) return all.front();
    answer_.no_values = "one value is needed for one function";
    return std::nullopt;
  }

  // y = v^exponent
  void bernoulli() {
    const auto& [ode, v, exponent] = *e_.bernoulli;
    const FirstOrderSolutions found = solutions_of(linear_equation(ode, v, letters_));
    const auto root = [&](const std::string& inside) {
      return written(trees::power(trees::rebuilt(parse_expression(inside, "a power")),
                                  trees::number(exponent)));
    };
    if (sign(exponent) < 0) answer_.special.emplace_back("0");
    answer_.general =
        told(root(sum_text({{c_, found.homogeneous}}, found.particular)), "general solution");
    if (answer_.general && exponent.den() == Integer(2)) // both roots
      if (auto other = told("-" + *answer_.general, "general solution"))
        answer_.special.insert(answer_.special.begin(), *std::move(other));
    if (e_.conditions.empty() || !answer_.general) return;
    const auto given = only_value();
    if (!given) return;
    if (is_zero(given->value) && sign(exponent) < 0) { // y^n, n > 1: it is the only one
      answer_.with_values = "0";
      return;
    }
    const MFraction back = letters_->number(Rational(1) / exponent);
    const WithValues there =
        with_value(found, {given->point, given->order, power(given->value, back)});
    answer_.no_values = there.missing;
    if (!there.y) return;
    for (const std::string& y : {root(text(*there.y)), "-" + root(text(*there.y))})
      if (!answer_.with_values && holds_at_points(value_of(y, *given), "", Element(letters_)))
        answer_.with_values = told(y, "solution with these values");
  }

  // y(x0) = y0
  [[nodiscard]] Expression value_of(const std::string& y, const InitialValue& v) const {
    const Expression at = trees::rebuilt(parse_expression(y, "a solution"),
                                         {{e_.variable, parse_expression(text(v.point), "x")}});
    return Expression::made(Expression::Kind::equation,
                            {at, parse_expression(text(v.value), "a value")});
  }

  // c1*y1 + c2*y2 + y_p
  [[nodiscard]] std::string sum_text(const std::vector<std::pair<std::string, Element>>& all,
                                     const Element& particular) const {
    std::string sum;
    for (const auto& [c, y] : all) {
      const std::string f = text(y, hyperbolic_);
      const bool simple =
          f.front() != '-' && parse_expression(f, "a solution").kind() != Expression::Kind::sum;
      const std::string term = f == "1"              ? c
                               : f.starts_with("1/") ? c + f.substr(1)
                               : simple              ? c + "*" + f
                                                     : c + "*(" + f + ")";
      sum += (sum.empty() ? "" : " + ") + term;
    }
    if (is_zero(particular)) return sum;
    const std::string f = text(particular, hyperbolic_);
    return sum + (f.front() == '-' ? " - " + f.substr(1) : " + " + f);
  }

  void riccati() {
    const Element a = element(e_.riccati->a, letters_);
    const auto both = basis(linear_equation(e_.riccati->linear, e_.riccati->unknown, letters_));
    if (!both) return;
    const RiccatiSolutions found = riccati_solutions(a, *both, c_);
    for (const Element& y : found.special)
      if (auto s = told(y, "solution")) answer_.special.push_back(*s);
    answer_.general = told(found.general, "general solution");
    if (e_.conditions.empty()) return;
    if (const auto v = only_value()) put(riccati_with_value(a, *both, *v));
  }

  void put(const WithValues& found) {
    answer_.no_values = found.missing;
    if (!found.y) return;
    answer_.with_values = told(*found.y, "solution with these values");
    if (found.start)
      answer_.integrals = "each integral starts at " + e_.variable + " = " + text(*found.start);
  }

  const WholeEquation& e_;
  bool hyperbolic_;
  std::string c1_ = "c1", c2_ = "c2", c_ = "c";
  LettersPtr letters_;
  std::function<std::optional<Basis>()> known_;
  WholeAnswer answer_;
};

} // namespace

WholeAnswer whole_answer(const WholeEquation& equation,
                         const std::function<std::optional<Basis>(const LettersPtr&)>& known) {
  return Whole(equation, known)();
}

} // namespace kov::elementary
