#include "flow/field/written.hpp"

#include "exact/budget.hpp"

#include <algorithm>

namespace kov::flow {
namespace {

std::set<std::size_t> numbers_of(const VectorField& v) {
  std::set<std::size_t> all(v.parameters.begin(), v.parameters.end());
  all.insert(v.constants.begin(), v.constants.end());
  return all;
}

} // namespace

Written::Written(const Entry& document, const SystemScope& scope, const System& s)
    : scope_(scope), graph_(numbers_of(s.field)) {
  const Entry& system = document.at("system");
  const VectorField& v = s.field;
  if (const Entry* define = system.find("define"))
    for (const auto& [name, entry] : define->members())
      definitions_.emplace(name, entry.expression());
  if (const Entry* h = system.find("hamiltonian"); h != nullptr && v.hamiltonian)
    add(h->expression(), *v.hamiltonian);
  if (const Entry* field = system.find("field"))
    for (const auto& [name, entry] : field->members())
      for (std::size_t j = 0; j < v.dimension(); ++j)
        if (v.name(j) == name) add(entry.expression(), v.components[j]);
}

void Written::add(const Expression& e, const MFraction& value) {
  if (e.kind() == Expression::Kind::equation) {
    const NodeId left = of(e.operand(0)), right = of(e.operand(1));
    graph_.know(value, graph_.sum({{Rational(1), left}, {Rational(-1), right}}));
  } else {
    graph_.know(value, of(e));
  }
}

NodeId Written::of(const Expression& e) {
  using Kind = Expression::Kind;
  switch (e.kind()) {
  case Kind::number:
    return graph_.constant(Rational(e.number()));
  case Kind::name:
    return of_name(e);
  case Kind::negate:
    return graph_.sum({{Rational(-1), of(e.operand(0))}});
  case Kind::sum: {
    Node::Terms terms;
    for (const Expression& x : e.operands())
      terms.emplace_back(Rational(1), of(x));
    return graph_.sum(terms);
  }
  case Kind::product: {
    NodeId all = graph_.constant(Rational(1));
    for (const Expression& x : e.operands())
      all = graph_.product(all, of(x));
    return all;
  }
  case Kind::quotient: {
    const NodeId above = of(e.operand(0));
    return graph_.quotient(above, of(e.operand(1)));
  }
  case Kind::power:
    return of_power(e);
  default: // a function: what its symbol stands for
    return graph_.of(evaluate(e, scope_));
  }
}

NodeId Written::of_name(const Expression& e) {
  const auto definition = definitions_.find(e.name());
  if (definition == definitions_.end() || scope_.values.contains(e.name()))
    return graph_.of(evaluate(e, scope_));
  if (const auto known = defined_.find(e.name()); known != defined_.end()) return known->second;
  return defined_[e.name()] = of(definition->second);
}

NodeId Written::of_power(const Expression& e) {
  const MFraction exponent = evaluate(e.operand(1), scope_);
  if (!is_constant(exponent) || !is_integer(to_rational(exponent)))
    return graph_.of(evaluate(e, scope_)); // a root, which has a symbol
  const long n = to_long(floor(to_rational(exponent)));
  if (n == 0) return graph_.constant(Rational(1));
  const NodeId power = graph_.power(of(e.operand(0)), std::abs(n));
  return n > 0 ? power : graph_.quotient(graph_.constant(Rational(1)), power);
}

} // namespace kov::flow
