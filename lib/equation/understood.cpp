#include "equation/understood.hpp"

#include "equation/assumptions.hpp"
#include "equation/first_order_form.hpp"
#include "equation/function_change.hpp"
#include "equation/linear_form.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "symbol/no_value.hpp"
#include "symbol/operators.hpp"
#include "symbol/pasted.hpp"
#include "symbol/rational_form.hpp"
#include "symbol/suggest.hpp"
#include "symbol/written.hpp"

#include <algorithm>
#include <functional>
#include <set>

namespace kov {
namespace {

using Kind = Expression::Kind;
using Names = std::vector<std::string>;

constexpr std::size_t longest_operator = std::size_t{1} << 20;

Names free_names(const Expression& e, const std::string& but, const Names& declared) {
  Names free;
  for (const std::string& name : names_in(e))
    if (name != "I" && name != but && !is_among(name, declared)) free.push_back(name);
  return free;
}

InputError which_variable(const Expression& ode, const Names& free) {
  std::string flags;
  for (const std::string& n : free)
    if (n != "x" && n != "t") flags += " --parameter " + n;
  return ode.error("which of " + enumerate(free) + " is the variable?",
                   "name it with --variable, the others with --parameter:" + flags);
}

std::string variable_of_euler(const Expression& ode, Names free) {
  std::erase_if(free, [](const std::string& n) { return n == "y" || n == "u" || n == "w"; });
  if (free.size() == 1) return free.front();
  if (free.empty() || is_among("z", free)) return "z";
  if (const auto variable = obvious_variable(free, "y"); variable && is_among(*variable, free))
    return *variable;
  throw which_variable(ode, free);
}

bool has(const Expression& e, const std::function<bool(const Expression&)>& what) {
  return what(e) ||
         std::ranges::any_of(e.operands(), [&](const Expression& x) { return has(x, what); });
}

bool divides_by_unknown(const Expression& e, const std::string& unknown) {
  return has(e, [&](const Expression& x) {
    return x.kind() == Kind::quotient && mentions_name(x.operand(1), unknown);
  });
}

// Does a letter stand in a function, or in a sum or power beside y'', as constants rarely do?
bool is_varied(const Expression& ode, const std::string& letter) {
  const auto is_second = [](const Expression& x) {
    return x.kind() == Kind::derivative && x.order() > 1;
  };
  const auto varies = [&](const Expression& x) {
    return (x.kind() == Kind::sum || x.kind() == Kind::power) && mentions_name(x, letter);
  };
  return has_functions_of(ode, letter) || std::ranges::any_of(terms_of(ode), [&](const auto& t) {
           return has(t.term, is_second) && has(t.term, varies);
         });
}

bool is_zero_constant(const Expression& e) {
  return names_in(e).empty() && tried<InputError>([&] {
           Constants constants;
           constants.gather({&e, 1});
           return is_zero(rational_function(e, {"z", &constants, {}}));
         });
}

// 1/0 beside the equation, where nobody computes with it.
void refuse_zero_divisors(const Expression& e) {
  if (e.kind() == Kind::quotient && is_zero_constant(e.operand(1)))
    throw NoValue(e.operand(1).error("division by zero"));
  for (const Expression& part : e.operands())
    refuse_zero_divisors(part);
}

void refuse_infinity(const Expression& condition) {
  for (const char* name : {"inf", "infinity", "oo"})
    if (const Expression* at = find_name(condition, name))
      throw at->error("a value at infinity is a limit, and no limit is asked for here",
                      "give values at points: y(0) = 1");
}

std::string with_values(const Expression& e, const EquationText& text) {
  return written(e, [&](const Expression& x) -> std::optional<std::string> {
    if (x.kind() != Kind::name) return std::nullopt;
    for (const auto& [name, value] : text.set)
      if (name == x.name()) return "(" + written(value) + ")";
    return std::nullopt;
  });
}

/// One question on its way.
class Way {
public:
  Way(Pasted pasted, const std::string& name, const EquationText& given)
      : ode_(std::move(pasted.formula)), name_(name), declared_(declared_names(given)),
        by_time_(pasted.by_time) {
    result_.text = given;
    if (!pasted.as_written) result_.read_as = written(ode_);
    result_.notes = std::move(pasted.notes);
    conditions_ = std::move(pasted.conditions);
  }

  Understood operator()() {
    refuse_zero_divisors(ode_);
    std::ranges::for_each(conditions_, refuse_zero_divisors);
    std::ranges::for_each(conditions_, refuse_infinity);
    apply_operator();
    if (!differentiates(ode_)) { // the reader says what is missing
      result_.text.ode = ode_;
      return std::move(result_);
    }
    result_.text.ode = ode_;
    refuse_words(result_.text);
    result_.text.ode = std::nullopt;
    const OdeNames names = ode_names(ode_, result_.text.unknown);
    unknown_ = names.unknown;
    variable_ = result_.text.variable.empty() ? names.variable : result_.text.variable;
    if (variable_.empty()) variable_ = only_free_name();
    if (result_.text.variable.empty() && !is_alone(free_names()))
      result_.text.variable = variable_; // no name alone says it
    if ((names.variable.empty() || by_operator_) && !variable_.empty())
      note(Done::names, {unknown_, variable_});
    result_.given = by_operator_ ? operator_ : written(ode_);
    own_divisors();
    elementary::WholeEquation whole{valued(written(ode_), true), unknown_, variable_, conditions_};
    const bool first = first_order(whole);
    separate();
    if (first || result_.right_side || !conditions_.empty()) result_.whole = whole;
    change();
    if (!result_.text.p)
      result_.text.ode = ode_;
    else if (!result_.whole && is_without_unknown(whole))
      result_.whole = whole;
    return std::move(result_);
  }

private:
  // y'' + p y' = 0 is solved by integrals whatever p is.
  static bool is_without_unknown(const elementary::WholeEquation& e) {
    auto names = names_in(e.ode);
    std::erase_if(names, [&](const std::string& n) { return n == e.variable || n == e.unknown; });
    return tried<elementary::NotElementary, InputError, DomainError>([&] {
      const auto letters = std::make_shared<elementary::Letters>(e.variable, names);
      return is_zero(elementary::linear_equation(e.ode, e.unknown, letters).c0);
    });
  }

  void own_divisors() {
    for (const Expression& d : divisors_in(ode_))
      if (!mentions_name(d, unknown_)) result_.text.divisors.push_back({d});
  }

  void replace(const std::string& text) {
    const OriginPtr origin = origin_of_text(name_, text);
    ode_ = parse_expression(origin->text, origin, true);
  }
  using Done = ReadingNote::What;
  void note(Done what, std::vector<std::string> of = {}) {
    result_.notes.push_back({what, std::move(of)});
  }

  [[nodiscard]] Names free_names() const { return kov::free_names(ode_, unknown_, declared_); }

  // The reader takes it for the variable, or asks back for a number.
  [[nodiscard]] bool is_alone(const Names& free) const {
    return free == Names{variable_} || std::ranges::any_of(free, is_number_for_some);
  }
  static bool is_number_for_some(const std::string& name) {
    return is_constant_of_mathematics(name) || name == "i" || name == "Pi";
  }

  // "": several
  [[nodiscard]] std::string only_free_name() const {
    Names free = free_names();
    std::erase_if(free, is_constant_of_mathematics);
    std::erase(free, "i"); // the reader knows it as I
    const bool by_time = by_time_ && unknown_ != "t" && !is_among("t", declared_);
    if (free.empty() && !by_time) return unnamed_variable(result_.text, unknown_);
    if (const auto variable = obvious_variable(free, unknown_, by_time)) {
      if (free.size() > 1 && may_be_constant(*variable) && !is_varied(ode_, *variable))
        throw variable_or_constant(ode_, *variable);
      return *variable;
    }
    if (free.size() != 1) return is_among("z", free) ? "z" : "";
    throw variable_or_constant(ode_, free.front());
  }

  // Dx of any formula; D and theta where nothing else is differentiated.
  void apply_operator() {
    if (differentiates(ode_)) return;
    auto d = derivation_in(ode_);
    for (const char* name : {"D", "theta"})
      if (!d && is_among(name, names_in(ode_)) && !is_among(name, declared_))
        d = Derivation{name, result_.text.variable, std::string(name) == "theta"};
    if (!d) return;
    if (d->euler && d->variable.empty())
      d->variable = variable_of_euler(ode_, kov::free_names(ode_, d->name, declared_));
    operator_ = written(ode_);
    ode_ = applied(ode_, *d, longest_operator);
    by_operator_ = true;
    if (d->name == "D" || d->euler)
      note(d->euler ? Done::euler : Done::differentiates, {d->name, d->variable});
    result_.text.variable = d->variable;
  }

  [[nodiscard]] Expression valued(const std::string& text, bool equation) const {
    return parse_expression(with_values(parse_expression(text, name_, equation), result_.text),
                            name_, equation);
  }

  // By a linear equation of the second order.
  bool first_order(elementary::WholeEquation& whole) {
    const auto form = first_order_form(ode_, unknown_, variable_);
    if (!form) return false;
    using Kind = FirstOrderForm::Kind;
    if (result_.read_as.empty()) result_.read_as = written(ode_);
    if (form->kind == Kind::linear)
      note(Done::first_order, {form->decided});
    else
      note(form->kind == Kind::riccati ? Done::riccati : Done::bernoulli,
           {form->substitution, form->kind == Kind::riccati ? form->decided : form->linear});
    for (const std::string& formula : form->divisors)
      result_.text.divisors.push_back({parse_expression(formula, name_), Divisor::By::reduction});
    unknown_ = form->unknown;
    if (!result_.text.unknown.empty()) result_.text.unknown = unknown_;
    result_.text.variable = variable_;
    if (form->kind == Kind::riccati)
      whole.riccati = {valued(form->quadratic, false), valued(form->decided, true), unknown_};
    if (form->kind == Kind::bernoulli)
      whole.bernoulli = {valued(form->linear, true), unknown_, form->exponent};
    replace(form->decided);
    return true;
  }

  // Terms without y go to the right side.
  void separate() {
    std::vector<SignedTerm> left, right;
    for (const SignedTerm& t : terms_of(ode_)) {
      if (divides_by_unknown(t.term, unknown_)) return;
      const bool zero = t.term.kind() == Kind::number && is_zero(t.term.number());
      if (mentions_name(t.term, unknown_))
        left.push_back(t);
      else if (!zero)
        right.push_back({!t.minus, t.term});
    }
    if (right.empty() || left.empty()) return;
    if (result_.text.variable.empty()) {
      if (variable_.empty()) throw which_variable(ode_, free_names());
      result_.text.variable = variable_;
    }
    if (result_.read_as.empty()) result_.read_as = written(ode_);
    result_.right_side = sum_of(right);
    replace(sum_of(left) + " = 0");
    std::erase_if(result_.text.divisors,
                  [](const Divisor& d) { return d.by == Divisor::By::author; });
    own_divisors();
    note(Done::homogeneous, {written(ode_), *result_.right_side});
  }
  void change() {
    if (variable_.empty()) {
      const Names free = free_names();
      const bool any = std::ranges::any_of(
          free, [&](const std::string& x) { return has_functions_of(ode_, x); });
      if (any) throw which_variable(ode_, free);
      return;
    }
    if (!has_functions_of(ode_, variable_)) return;
    if (result_.read_as.empty()) result_.read_as = written(ode_);
    result_.text.variable = variable_;
    for (const std::string& name : names_in(ode_))
      if (name != unknown_ && name != variable_ && name != "I") result_.text.names.push_back(name);
    put_values();
    EquationText& text = result_.text;
    const std::vector<Divisor> all = text.divisors;
    std::erase_if(text.divisors, // the equation itself divides by them
                  [&](const Divisor& d) { return has_functions_of(d.formula, variable_); });
    auto divisors = mapped<Expression>(all, &Divisor::formula);
    const auto changed = function_change(ode_, unknown_, variable_, divisors);
    if (!changed) return;
    const std::string place = name_ + " in " + changed->variable;
    VariableChange change{.given = ode_,
                          .unknown = unknown_,
                          .variable = variable_,
                          .formula = changed->change,
                          .nonzero = parse_expression(changed->nonzero, place),
                          .elsewhere = parse_expression(changed->elsewhere, name_, true),
                          .divisors = text.divisors};
    if (const auto constant = constant_value(*change.nonzero, text)) {
      if (is_zero(*constant)) {
        ode_ = change.elsewhere;
        return;
      }
      change.nonzero.reset();
    }
    note(Done::variable, {changed->change});
    text.p = parse_expression(changed->p, place);
    text.q = parse_expression(changed->q, place);
    text.divisors = all;
    for (std::size_t i = 0; i < all.size(); ++i)
      text.divisors[i].formula = parse_expression(changed->divisors[i], place);
    text.divisors.push_back({parse_expression(changed->leading, place), Divisor::By::order});
    text.variable = changed->variable;
    text.change = std::move(change);
  }

  // Parameters with values have them before another variable is chosen.
  void put_values() {
    if (!result_.text.set.empty()) {
      replace(with_values(ode_, result_.text));
      for (Divisor& d : result_.text.divisors)
        d.formula = parse_expression(with_values(d.formula, result_.text), name_);
    }
    if (const auto plain = with_constant_functions(ode_, unknown_, variable_)) replace(*plain);
  }

  Expression ode_;
  std::string name_;
  Names declared_;
  std::string unknown_, variable_;
  bool by_time_;             ///< a dot above is a derivative by the time t
  bool by_operator_ = false; ///< which names no function
  std::string operator_;     ///< as it was read
  std::vector<Expression> conditions_;
  Understood result_;
};

} // namespace

bool is_another_equation(const std::vector<ReadingNote>& notes) {
  using What = ReadingNote::What;
  return std::ranges::any_of(notes, [](const ReadingNote& n) {
    return n.what == What::riccati || n.what == What::homogeneous || n.what == What::variable ||
           n.what == What::first_order || n.what == What::bernoulli;
  });
}

Understood understood(const std::string& ode, const std::string& name, const EquationText& given) {
  const PastedNames names{declared_names(given), given.variable, given.unknown};
  return Way(pasted_equation(ode, name, names), name, given)();
}

} // namespace kov
