#include "integrability/specialise.hpp"

#include "exact/error.hpp"
#include "exact/linear_fraction.hpp"
#include "exact/lists.hpp"
#include "system/relations.hpp"
#include "system/written_functions.hpp"

#include <algorithm>

namespace kov {
namespace {

void put(MFraction& f, const Substitution& values) {
  if (!is_zero(f)) f = substitute(f, values);
}
void put(std::optional<MFraction>& f, const Substitution& values) {
  if (f) put(*f, values);
}
void put(std::vector<MFraction>& all, const Substitution& values) {
  for (auto& f : all)
    put(f, values);
}
void put(std::vector<MPoly>& all, const Substitution& values) {
  for (auto& f : all)
    f = substitute(f, values).num();
}
void put(std::vector<Equation>& all, const Substitution& values) {
  for (auto& e : all)
    put(e.difference, values);
}

// An algebraic constant that no relation restricts any more becomes a parameter.  The relation of
// a function says something of the function: that of sqrt(x^2 + c y^2).
void free_constants(VectorField& v) {
  std::erase_if(v.relations, [](const MPoly& p) { return is_zero(p); });
  const auto is_of_a_function = [&](const MPoly& p) {
    return std::ranges::any_of(v.functions,
                               [&](const FunctionSymbol& f) { return uses(p, f.variable); });
  };
  const auto is_free = [&](std::size_t c) {
    return std::ranges::none_of(v.relations,
                                [&](const MPoly& p) { return uses(p, c) && !is_of_a_function(p); });
  };
  std::ranges::copy_if(v.constants, std::back_inserter(v.parameters), is_free);
  std::erase_if(v.constants, is_free);
}

void put(VectorField& v, const Substitution& values) {
  std::erase_if(v.functions, [&](const FunctionSymbol& f) { return values.contains(f.variable); });
  for (auto* names : {&v.parameters, &v.constants})
    std::erase_if(*names, [&](std::size_t i) { return values.contains(i); });
  for (auto& f : v.functions) {
    put(f.gradient, values);
    put(f.argument, values);
  }
  put(v.relations, values);
  free_constants(v);
  put(v.components, values);
  put(v.hamiltonian, values);
  if (v.poisson)
    for (auto& row : *v.poisson)
      put(row, values);
}

// Sentences about adjoined constants, the last ones, as far as they are constants still.
std::vector<std::string> still_adjoined(const System& before, const VectorField& now) {
  const auto& all = before.field.constants;
  KOV_ENSURE(before.adjoined.size() <= all.size());
  const std::size_t first = all.size() - before.adjoined.size();
  std::vector<std::string> left;
  for (std::size_t k = 0; k < before.adjoined.size(); ++k)
    if (is_among(all[first + k], now.constants)) left.push_back(before.adjoined[k]);
  return left;
}

void put(ManifoldSpec& m, const Substitution& values) {
  put(m.equations, values);
  put(m.levels, values);
  put(m.nonzero, values);
}

// A parameter with a value is none any more; what its value is made of is real if it must be.
void put(std::set<std::string>& real, const Substitution& values, const Ring& ring) {
  std::set<std::string> more;
  for (const auto& [i, value] : values)
    if (real.erase(ring->name(i)) > 0)
      if (const auto x = variable_of_linear_fraction(value)) more.insert(ring->name(*x));
  real.insert(more.begin(), more.end());
}

// The value of the function at a number, if it is a rational number: that of the principal branch,
// as if the number were written in the file.
std::optional<Rational> value_at(const std::string& function, const Rational& x) {
  const bool even = function == "cos" || function == "cosh" || function == "exp";
  const bool odd =
      function == "sin" || function == "sinh" || function == "tan" || function == "tanh";
  if (is_zero(x) && (even || odd)) return Rational(even ? 1 : 0);
  if (x == Rational(1) && (function == "log" || function == "ln")) return Rational(0);
  if (order_of_root(function) > 0 && x == Rational(1)) return x;
  return order_of_root(function) == 2 && sign(x) > 0 ? exact_sqrt(x) : std::nullopt;
}

// The algebraic constant that has to be 0: k, where its relation has become k^2 = 0.
std::optional<std::size_t> constant_without_choice(const VectorField& v, const MPoly& relation) {
  const auto used = used_variables(relation);
  const bool is_power =
      relation.length() == 1 && used.size() == 1 && is_among(used.front(), v.constants);
  return is_power ? std::optional(used.front()) : std::nullopt;
}

} // namespace

Substitution with_functions(const System& s, Substitution values) {
  const VectorField& v = s.field;
  for (bool more = true; more;) {
    more = false;
    for (const FunctionSymbol& f : v.functions) {
      if (f.function.empty() || values.contains(f.variable)) continue;
      const MFraction there = is_zero(f.argument) ? f.argument : substitute(f.argument, values);
      if (!is_zero(there) && !is_constant(there)) continue;
      const auto value = value_at(f.function, is_zero(there) ? Rational(0) : to_rational(there));
      if (!value) continue;
      values[f.variable] = MFraction(v.ring, *value);
      more = true;
    }
    for (const MPoly& relation : v.relations)
      if (const auto c = constant_without_choice(v, substitute(relation, values).num())) {
        values[*c] = MFraction(v.ring);
        more = true;
      }
  }
  return values;
}

System at_values(const System& s, const Substitution& parameters) {
  const Substitution values = with_functions(s, parameters);
  System special = s;
  special.domain = s.domain.at(values);
  put(special.field, values);
  special.adjoined = still_adjoined(s, special.field);
  if (special.field.relations != s.field.relations)
    if (const auto why = reducible_relations(special.field)) throw DomainError(*why);
  for (auto& m : special.manifolds)
    put(m, values);
  for (auto& r : special.reductions)
    put(r.change, values);
  for (auto& a : special.assumptions)
    put(a.value, values);
  put(special.real, values, s.ring());
  return special;
}

ManifoldSpec at_values(const ManifoldSpec& spec, const Substitution& values) {
  ManifoldSpec special = spec;
  put(special, values);
  return special;
}

std::vector<ClaimReport> at_values(std::vector<ClaimReport> claims, const Substitution& values) {
  for (auto& c : claims) {
    for (const auto& g : c.result.generic) // where its proof says nothing
      if (is_zero(substitute(g, values))) c.result.proved = false;
    if (!c.result.proved) continue;
    put(c.claim.value, values);
    put(c.claim.on, values);
  }
  return claims;
}

} // namespace kov
