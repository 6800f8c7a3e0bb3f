#include "equation/assumptions.hpp"

#include "equation/sentence.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "parameters/parametrised_set.hpp"
#include "symbol/rational_form.hpp"
#include "symbol/suggest.hpp"
#include "system/parameter_scope.hpp"

#include <algorithm>
#include <set>

namespace kov {
namespace {

using Names = std::vector<std::string>;

InputError error_at_name(const Sentence& s, const std::string& name, const std::string& message,
                         const std::string& hint) {
  for (const Expression* side : {&s.left, s.right ? &*s.right : nullptr})
    if (side != nullptr)
      if (const Expression* found = find_name(*side, name)) return found->error(message, hint);
  return s.error(message, hint);
}

bool is_ordered(const Sentence& s) {
  return s.kind == Sentence::Kind::sign && certify::is_ordered(s.sign);
}

// Everything in an inequality is real: the names themselves, and of what they are put to only
// what must be.
void declare_names(Assumptions& all, const Sentence& s, const Scope& scope) {
  if (!is_ordered(s)) return;
  for (const std::string& name : names_in(s))
    if (const auto value = scope.value(name)) all.declare_real(*value);
}

// An inequality is about real numbers.
void refuse_imaginary_unit(const Sentence& s, const MFraction& value, const Ring& ring) {
  const auto i = ring->find("I");
  if (is_ordered(s) && i && uses(value, *i))
    throw s.error("an inequality is about real numbers", "I is the imaginary unit");
}

void assume(Assumptions& all, const Sentence& s, const Scope& scope) {
  MFraction value = evaluate(s.left, scope);
  switch (s.kind) {
  case Sentence::Kind::sign:
    value -= evaluate(*s.right, scope);
    refuse_imaginary_unit(s, value, scope.ring());
    return all.require(value, s.sign);
  case Sentence::Kind::membership:
    value -= evaluate(*s.right, scope);
    if (s.holds) all.declare_rational(value);
    all.require_integral((Rational(1) / s.modulus) * value, s.holds);
    return;
  default:
    if (s.sort == Sort::real) all.declare_real(value);
    if (s.sort == Sort::rational) all.declare_rational(value);
  }
}

// Declares first what is real: a quotient has the sign of num * den where den is.
Assumptions together(const std::vector<Sentence>& said, const Scope& scope, Assumptions all = {}) {
  for (const Sentence& s : said)
    declare_names(all, s, scope);
  for (const Sentence& s : said)
    if (s.kind == Sentence::Kind::declaration) assume(all, s, scope);
  for (const Sentence& s : said)
    if (s.kind != Sentence::Kind::declaration) assume(all, s, scope);
  return all;
}

// The constants of the equation, as read_equation defines them.
Constants constants_of(const EquationText& text) {
  Constants c;
  for (const auto& name : text.parameters)
    c.reserve(name);
  if (text.minpoly)
    if (const Names names = names_in(*text.minpoly); names.size() == 1)
      c.define_root(names.front(), *text.minpoly);
  for (const auto& [name, value] : text.set)
    if (!c.is_defined(name)) c.define_value(name, value);
  return c;
}

NfElem constant(const Expression& e, Constants& c) {
  c.gather(std::span(&e, 1));
  const RationalFunction f = rational_function(e, {.variable = "", .constants = &c, .budget = {}});
  return f.num().coeff(0) / f.den().coeff(0);
}

struct Place {
  int real_part = 0; ///< its sign; 0: too near to tell
  bool real = true;  ///< not proved to be off the real line
};
Place place(const NfElem& v) {
  Place p;
  for (long bits = 64; bits <= 4096 && p.real && p.real_part == 0; bits *= 2) {
    const ComplexBall b = embed(v, bits);
    p.real = arb_contains_zero(acb_imagref(b.raw())) != 0;
    p.real_part = arb_is_positive(acb_realref(b.raw())) != 0   ? 1
                  : arb_is_negative(acb_realref(b.raw())) != 0 ? -1
                                                               : 0;
  }
  return p;
}

// Is the sentence proved to be false of the constant v?
bool is_false(const Sentence& s, const NfElem& v) {
  if (s.kind == Sentence::Kind::membership) {
    const bool in = is_rational(v) && is_integer(to_rational(v) / s.modulus);
    return in != s.holds;
  }
  if (s.kind == Sentence::Kind::declaration)
    return (s.sort == Sort::rational && !is_rational(v)) ||
           (s.sort == Sort::real && !place(v).real);
  if (s.sign == Sign::zero || s.sign == Sign::nonzero) return is_zero(v) != (s.sign == Sign::zero);
  if (is_zero(v)) return s.sign == Sign::positive;
  const Place p = place(v);
  return !p.real || p.real_part < 0;
}

class Checker {
public:
  explicit Checker(const EquationText& text)
      : text_(text), names_(equation_names(text)), known_(settable_names(text)),
        constants_(constants_of(text)) {
    std::erase(known_, names_.variable);
    if (text.ode) std::erase(known_, names_.unknown);
  }

  void operator()(const Sentence& s) {
    const Names used = names_in(s);
    for (const auto& name : used)
      check_name(s, name);
    const bool number = std::ranges::all_of(
        used, [&](const std::string& name) { return name == "I" || constants_.is_defined(name); });
    if (number) check_value(s);
  }

private:
  void check_name(const Sentence& s, const std::string& name) const {
    if (name == names_.variable)
      throw error_at_name(s, name, "'" + name + "' is the variable of the equation",
                          "assumptions are about parameters");
    if (text_.ode && name == names_.unknown)
      throw error_at_name(s, name, "'" + name + "' is the unknown function",
                          "assumptions are about parameters");
    if (name == "I" || is_among(name, known_)) return;
    const auto near = nearest(name, known_);
    throw error_at_name(s, name, "'" + name + "' is not a parameter of the equation",
                        near             ? "did you mean " + *near + "?"
                        : known_.empty() ? "it has no parameters"
                                         : "its parameters: " + enumerate(known_));
  }

  void check_value(const Sentence& s) {
    NfElem v = constant(s.left, constants_);
    if (s.right) {
      const NfElem right = constant(*s.right, constants_); // may move all values to a larger field
      v = constant(s.left, constants_) - right;
    }
    if (!is_false(s, v)) return;
    throw s.error("the assumption '" + s.text + "' is violated by the values given",
                  (s.right ? "the left side minus the right side is " : "the value is ") +
                      to_string(v));
  }

  const EquationText& text_;
  EquationNames names_;
  Names known_;
  Constants constants_;
};

// Together, where all of them are about rational functions.
void refuse_contradictions(const EquationText& text, const std::vector<Sentence>& all) {
  std::set<std::string> names;
  for (const Sentence& s : all) {
    if (!is_rational_formula(s.left) || (s.right && !is_rational_formula(*s.right))) return;
    for (const auto& name : names_in(s))
      names.insert(name);
  }
  for (const auto& [name, value] : text.set)
    if (!is_rational_formula(value) || !names_in(value).empty()) return;
  for (const auto& [name, value] : text.set)
    names.insert(name);
  const Ring ring = make_ring({names.begin(), names.end()});
  std::map<std::string, MFraction> values;
  for (const auto& [name, value] : text.set)
    values[name] = evaluate(value, ParameterScope(ring, {}));
  if (ParametrisedSet(ring, together(all, ParameterScope(ring, values))).is_empty())
    throw all.back().error(all.size() == 1 ? "no parameters satisfy the assumption"
                                           : "the assumptions contradict each other");
}

} // namespace

bool is_rational_formula(const Expression& e) {
  if (e.kind() == Expression::Kind::call) return false;
  if (e.kind() == Expression::Kind::name && e.name() == "I") return false;
  return std::ranges::all_of(e.operands(), is_rational_formula);
}

Assumptions read_assumptions(const EquationText& text, const Scope& scope, Assumptions known) {
  std::vector<Sentence> said;
  for (const auto& a : text.assume)
    std::ranges::move(sentences(a), std::back_inserter(said));
  return together(said, scope, std::move(known));
}

namespace {

// A parameter in an inequality is real: one that is said to be complex is a contradiction in terms.
void refuse_complex_order(const std::vector<Sentence>& all) {
  std::set<std::string> complex;
  for (const Sentence& s : all)
    if (s.kind == Sentence::Kind::declaration && !s.sort)
      for (const auto& name : names_in(s))
        complex.insert(name);
  for (const Sentence& s : all) {
    if (!is_ordered(s)) continue;
    for (const auto& name : names_in(s))
      if (complex.contains(name))
        throw error_at_name(s, name, "'" + name + "' is said to be complex",
                            "an inequality is about real parameters");
  }
}

} // namespace

void check_assumptions(const EquationText& text) {
  if (text.assume.empty()) return;
  Checker check(text);
  std::vector<Sentence> all;
  for (const auto& a : text.assume)
    for (Sentence& s : sentences(a)) {
      check(s);
      all.push_back(std::move(s));
    }
  refuse_complex_order(all);
  refuse_contradictions(text, all);
}

std::optional<NfElem> constant_value(const Expression& e, const EquationText& text) {
  Constants constants = constants_of(text);
  for (const std::string& name : names_in(e))
    if (name != "I" && !constants.is_defined(name)) return std::nullopt;
  return constant(e, constants);
}

std::vector<std::string> names_in_assumption(const AssumedText& text) {
  std::set<std::string> names;
  for (const Sentence& s : sentences(text))
    for (const auto& name : names_in(s))
      names.insert(name);
  return {names.begin(), names.end()};
}

bool is_prose(const std::string& text, const std::vector<std::string>& names) {
  if (text.find_first_not_of(" \t\n,;") == std::string::npos) return false;
  if (text.find_first_of("<>=") != std::string::npos) return false;
  if (tried<InputError>([&] { static_cast<void>(sentences({text, nullptr, ""})); })) return false;
  try {
    const Names used = names_in(parse_expression(text, "assumption"));
    return !std::ranges::all_of(used, [&](const std::string& n) { return is_among(n, names); });
  } catch (const InputError&) {
    return true;
  }
}

} // namespace kov
