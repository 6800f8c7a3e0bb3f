#include "canonical/elementary.hpp"

#include "exact/finite_algebra.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr std::size_t most_degrees = 4; // of freedom: 2^n exchanges

bool uses_momenta(const Form& form, const MFraction& f) {
  for (std::size_t i = 0; i < form.degrees(); ++i)
    if (uses(f, form.p(i))) return true;
  return false;
}

// A function of the momenta: then H is not a polynomial in them.
bool functions_use_momenta(const Form& form) {
  const std::size_t n = form.degrees();
  for (const FunctionSymbol& f : form.field.functions) {
    if (!uses(*form.field.hamiltonian, f.variable)) continue;
    for (std::size_t i = 0; i < n; ++i)
      if (!is_zero(f.gradient[n + i]) || uses_momenta(form, f.gradient[i])) return true;
  }
  return false;
}

Substitution no_momenta(const Form& form) {
  Substitution at_rest;
  for (std::size_t i = 0; i < form.degrees(); ++i)
    at_rest[form.p(i)] = MFraction(form.field.ring);
  return at_rest;
}

Form exchanged(const Form& form, std::size_t set) {
  Substitution old, now;
  for (std::size_t i = 0; i < form.degrees(); ++i) {
    if ((set >> i & 1U) == 0) continue;
    old[form.q(i)] = -form.variable(form.p(i));
    old[form.p(i)] = form.variable(form.q(i));
    now[form.q(i)] = form.variable(form.p(i));
    now[form.p(i)] = -form.variable(form.q(i));
  }
  return changed(form, old, now);
}

enum class Kinetic : std::uint8_t { constant, quadratic, other };

Kinetic kinetic(const Form& form) {
  const auto g = kinetic_matrix(form);
  if (!g) return Kinetic::other;
  for (const auto& row : *g)
    for (const MFraction& x : row)
      if (!form.is_constant_of_motion(x)) return Kinetic::quadratic;
  return Kinetic::constant;
}

} // namespace

std::optional<Matrix> kinetic_matrix(const Form& form) {
  const MFraction& h = *form.field.hamiltonian;
  if (functions_use_momenta(form) || uses_momenta(form, MFraction(h.den()))) return std::nullopt;
  Matrix g;
  for (std::size_t i = 0; i < form.degrees(); ++i) {
    const MFraction slope = derivative(h, form.p(i));
    g.emplace_back();
    for (std::size_t k = 0; k < form.degrees(); ++k) {
      g.back().push_back(derivative(slope, form.p(k)));
      if (uses_momenta(form, g.back().back())) return std::nullopt;
    }
  }
  if (!null_space(g, form.degrees(), form.field.ring).empty()) return std::nullopt;
  return g;
}

Form with_quadratic_kinetic_term(const Form& form) {
  Kinetic best = kinetic(form);
  Form result = form;
  if (form.degrees() > most_degrees) return result;
  for (std::size_t set = 1; set < std::size_t{1} << form.degrees(); ++set) {
    if (best == Kinetic::constant) break;
    Form next = exchanged(form, set);
    if (const Kinetic k = kinetic(next); k < best) {
      best = k;
      result = std::move(next);
    }
  }
  return result;
}

namespace {

/// The momenta p + a, with a(q).
Form with_gauge(const Form& form, const std::vector<MFraction>& a) {
  Substitution old, now;
  for (std::size_t i = 0; i < form.degrees(); ++i) {
    if (is_zero(a[i])) continue;
    old[form.p(i)] = form.variable(form.p(i)) - a[i];
    now[form.p(i)] = form.variable(form.p(i)) + a[i];
  }
  return old.empty() ? form : changed(form, old, now);
}

bool is_closed(const Form& form, const std::vector<MFraction>& a, const Ideal& relations) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (!is_zero_modulo(partial(form.field, a[i], k) - partial(form.field, a[k], i), relations))
        return false;
  return true;
}

// The terms of f that are polynomials in the coordinates alone, by their degree in them.
std::map<unsigned long, MFraction> polynomial_terms(const Form& form, const MFraction& f) {
  std::map<unsigned long, MFraction> all;
  if (is_zero(f) || !form.is_constant_of_motion(MFraction(f.den()))) return all;
  const MPoly num = f.num();
  for (long t = 0; t < num.length(); ++t) {
    const auto e = num.exponents(t);
    unsigned long degree = 0;
    for (std::size_t i = 0; i < form.degrees(); ++i)
      degree += e[form.q(i)];
    const MPoly term = MPoly::term(form.field.ring, num.coefficient(t), e);
    if (std::ranges::any_of(form.field.functions,
                            [&](const FunctionSymbol& s) { return uses(term, s.variable); }))
      continue;
    all.try_emplace(degree, form.field.ring).first->second += MFraction(term, f.den());
  }
  return all;
}

// df for f = sum of a_k.q/(k + 1), a_k the part of degree k: a - df is the radial gauge.
std::vector<MFraction> radial_part(const Form& form, const std::vector<MFraction>& a) {
  MFraction f(form.field.ring);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (const auto& [degree, term] : polynomial_terms(form, a[i]))
      f += Rational(Integer(1), Integer(static_cast<long>(degree) + 1)) *
           (term * form.variable(form.q(i)));
  std::vector<MFraction> slopes;
  for (std::size_t i = 0; i < a.size(); ++i)
    slopes.push_back(derivative(f, form.q(i)));
  return slopes;
}

} // namespace

Form with_completed_square(const Form& form, const Budget& budget) {
  const auto g = kinetic_matrix(form);
  if (!g) return form;
  const auto at_rest = no_momenta(form);
  std::vector<MFraction> linear;
  for (std::size_t i = 0; i < form.degrees(); ++i)
    linear.push_back(substitute(derivative(*form.field.hamiltonian, form.p(i)), at_rest));
  const auto a = solve_linear(*g, linear, budget);
  if (!a || std::ranges::all_of(*a, [](const MFraction& x) { return is_zero(x); })) return form;
  const Ideal relations = relation_ideal(form.field, {}, {}, budget);
  if (is_closed(form, *a, relations)) return with_gauge(form, *a);
  auto gauge = radial_part(form, *a);
  std::vector<MFraction> rest;
  for (std::size_t i = 0; i < a->size(); ++i) {
    rest.push_back((*a)[i]);
    for (const auto& [degree, term] : polynomial_terms(form, (*a)[i]))
      rest.back() -= term;
  }
  if (is_closed(form, rest, relations))
    for (std::size_t i = 0; i < rest.size(); ++i)
      gauge[i] += rest[i];
  return with_gauge(form, gauge);
}

} // namespace kov
