#include "family/algebraic_constants.hpp"

#include "symbol/constants.hpp"

#include <algorithm>

namespace kov {
namespace {

using Kind = Expression::Kind;

std::optional<Integer> integer(const Expression& e) {
  if (e.kind() == Kind::number) return e.number();
  if (e.kind() == Kind::negate && e.operand(0).kind() == Kind::number)
    return -e.operand(0).number();
  return std::nullopt;
}

std::string name_of_root(const Integer& n) { return "sqrt(" + to_string(n) + ")"; }

} // namespace

std::optional<AlgebraicConstants> AlgebraicConstants::in(const EquationText& text) {
  AlgebraicConstants all;
  const bool i_is_a_parameter =
      std::find(text.parameters.begin(), text.parameters.end(), "I") != text.parameters.end();
  for (const auto* e : {&text.r, &text.p, &text.q, &text.ode})
    if (*e && !all.collect(**e)) return std::nullopt;
  if (i_is_a_parameter) all.i_ = false;
  all.minpoly_ = text.minpoly;
  return all;
}

bool AlgebraicConstants::collect(const Expression& e) {
  if (e.kind() == Kind::name && e.name() == "I") i_ = true;
  if (e.kind() == Kind::call && e.name() == "root") return false;
  if (e.kind() == Kind::call && e.name() == "sqrt") {
    const auto n =
        e.name() == "sqrt" && e.operands().size() == 1 ? integer(e.operand(0)) : std::nullopt;
    if (!n || exact_sqrt(Rational(*n))) return false;
    if (std::find(square_roots_.begin(), square_roots_.end(), *n) == square_roots_.end())
      square_roots_.push_back(*n);
    return true;
  }
  return std::all_of(e.operands().begin(), e.operands().end(),
                     [this](const Expression& x) { return collect(x); });
}

std::vector<std::string> AlgebraicConstants::names() const {
  std::vector<std::string> all;
  if (i_) all.emplace_back("I");
  for (const auto& n : square_roots_)
    all.push_back(name_of_root(n));
  if (minpoly_)
    for (const auto& name : names_in(*minpoly_))
      all.push_back(name);
  return all;
}

std::vector<FunctionMeaning> AlgebraicConstants::functions(const Ring& ring) const {
  std::vector<FunctionMeaning> all;
  for (const auto& n : square_roots_)
    all.push_back({ring->index(name_of_root(n)), "sqrt", MFraction(ring, Rational(n))});
  return all;
}

void AlgebraicConstants::assume(strata::Assumptions& all, const Scope& scope) const {
  const Ring& ring = scope.ring();
  const auto square_is = [&](const std::string& name, const Integer& n) {
    const MFraction x = MFraction::variable(ring, name);
    all.require(x * x - MFraction(ring, Rational(n)), strata::Sign::zero);
  };
  if (i_) square_is("I", Integer(-1));
  for (const auto& n : square_roots_) {
    square_is(name_of_root(n), n);
    if (sign(n) > 0) all.real.push_back(ring->index(name_of_root(n)));
  }
  if (minpoly_) all.require(evaluate(*minpoly_, scope), strata::Sign::zero);
}

} // namespace kov
