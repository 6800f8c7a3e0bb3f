#include "system/vector_field.hpp"

#include "exact/error.hpp"
#include "exact/finite_algebra.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"

#include <algorithm>

namespace kov {

std::vector<std::size_t> VectorField::main_variables() const {
  std::vector<std::size_t> main(coordinates);
  for (const auto& f : functions)
    main.push_back(f.variable);
  main.insert(main.end(), constants.begin(), constants.end());
  return main;
}

MFraction partial(const VectorField& v, const MFraction& f, std::size_t j) {
  MFraction sum = derivative(f, v.coordinates[j]);
  for (const auto& s : v.functions)
    if (!is_zero(s.gradient[j]) && uses(f, s.variable))
      sum += derivative(f, s.variable) * s.gradient[j];
  return sum;
}

std::vector<MFraction> gradient(const VectorField& v, const MFraction& f) {
  std::vector<MFraction> g;
  for (std::size_t j = 0; j < v.dimension(); ++j)
    g.push_back(partial(v, f, j));
  return g;
}

MFraction lie_derivative(const VectorField& v, const MFraction& f) {
  MFraction sum(v.ring);
  for (std::size_t j = 0; j < v.dimension(); ++j)
    if (!is_zero(v.components[j])) sum += v.components[j] * partial(v, f, j);
  return sum;
}

std::vector<MFraction> hamiltonian_field(const VectorField& v, const Matrix& j,
                                         const MFraction& h) {
  const auto dh = gradient(v, h);
  std::vector<MFraction> x;
  for (const auto& row : j) {
    MFraction sum(v.ring);
    for (std::size_t k = 0; k < dh.size(); ++k)
      sum += row[k] * dh[k];
    x.push_back(std::move(sum));
  }
  return x;
}

std::vector<MPoly> denominators(const VectorField& v) {
  std::vector<MPoly> all;
  const auto add = [&](const MFraction& f) {
    if (!is_zero(f) && !is_constant(f.den())) all.push_back(f.den());
  };
  for (const MFraction& f : v.components)
    add(f);
  for (const FunctionSymbol& symbol : v.functions)
    for (const MFraction& f : symbol.gradient)
      add(f);
  if (v.hamiltonian) add(*v.hamiltonian);
  return all;
}

MFraction poisson_bracket(const VectorField& v, const MFraction& f, const MFraction& g) {
  if (!v.poisson) throw InvalidArgument("this system has no Poisson structure");
  const auto x = hamiltonian_field(v, *v.poisson, g);
  const auto df = gradient(v, f);
  MFraction sum(v.ring);
  for (std::size_t i = 0; i < df.size(); ++i)
    sum += df[i] * x[i];
  return sum;
}

Matrix canonical_structure(const Ring& ring, std::size_t n) {
  Matrix j(2 * n, std::vector<MFraction>(2 * n, MFraction(ring)));
  for (std::size_t i = 0; i < n; ++i) {
    j[i][n + i] = MFraction(ring, Rational(1));
    j[n + i][i] = MFraction(ring, Rational(-1));
  }
  return j;
}

Matrix e3_structure(const Ring& ring, const std::vector<std::size_t>& x,
                    const std::vector<MFraction>& gyrostat) {
  KOV_ENSURE(x.size() == 6 && gyrostat.size() == 3);
  Matrix j(6, std::vector<MFraction>(6, MFraction(ring)));
  for (std::size_t i = 0; i < 3;
       ++i) { // hat(Z): row i, column i+1 is -Z_(i+2), column i+2 is Z_(i+1)
    const std::size_t a = (i + 1) % 3;
    const std::size_t b = (i + 2) % 3;
    const auto m = [&](std::size_t k) { return MFraction::variable(ring, x[k]) - gyrostat[k]; };
    const auto g = [&](std::size_t k) { return MFraction::variable(ring, x[3 + k]); };
    j[i][a] = -m(b);
    j[i][b] = m(a);
    j[i][3 + a] = j[3 + i][a] = -g(b);
    j[i][3 + b] = j[3 + i][b] = g(a);
  }
  return j;
}

std::optional<std::string> structure_failure(const VectorField& v, const Matrix& j,
                                             const Ideal& relations) {
  const std::size_t n = v.dimension();
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a; b < n; ++b)
      if (const MFraction s = j[a][b] + j[b][a]; !is_zero_modulo(s, relations))
        return "{" + v.name(a) + ", " + v.name(b) + "} + {" + v.name(b) + ", " + v.name(a) +
               "} = " + to_string(s);
  const auto cyclic = [&](std::size_t a, std::size_t b, std::size_t c) {
    MFraction sum(v.ring);
    for (std::size_t l = 0; l < n; ++l)
      if (!is_zero(j[l][c])) sum += partial(v, j[a][b], l) * j[l][c];
    return sum;
  };
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b)
      for (std::size_t c = b + 1; c < n; ++c)
        if (const MFraction s = cyclic(a, b, c) + cyclic(b, c, a) + cyclic(c, a, b);
            !is_zero_modulo(s, relations))
          return "the Jacobi identity fails for " + v.name(a) + ", " + v.name(b) + ", " +
                 v.name(c) + ": " + to_string(s);
  return std::nullopt;
}

Legendre legendre(const MFraction& lagrangian, const std::vector<std::size_t>& velocities,
                  const std::vector<std::size_t>& momenta) {
  const std::size_t n = velocities.size();
  KOV_ENSURE(momenta.size() == n);
  const Ring& ring = lagrangian.ring();
  Substitution at_rest;
  for (const std::size_t w : velocities)
    at_rest[w] = MFraction(ring);
  Matrix mass(n);
  std::vector<MFraction> rest;
  for (std::size_t i = 0; i < n; ++i) {
    const MFraction momentum = derivative(lagrangian, velocities[i]);
    for (std::size_t k = 0; k < n; ++k) {
      mass[i].push_back(derivative(momentum, velocities[k]));
      for (const std::size_t w : velocities)
        if (uses(mass[i][k], w))
          throw DomainError("the Lagrangian is not quadratic in the velocities: dL/d" +
                            ring->name(velocities[i]) + " = " + to_string(momentum));
    }
    rest.push_back(MFraction::variable(ring, momenta[i]) - substitute(momentum, at_rest));
  }
  if (!null_space(mass, n, ring).empty())
    throw DomainError(
        "the kinetic energy is degenerate: the velocities do not follow from the momenta");
  Legendre result;
  result.velocities = *solve_linear(mass, rest);
  // L = v.Mv/2 + b.v + c and p = Mv + b: then p.v - L = (p - b).v/2 - c, of one denominator.
  MFraction pairing(ring);
  for (std::size_t i = 0; i < n; ++i)
    pairing += rest[i] * result.velocities[i];
  result.hamiltonian =
      pairing * MFraction(ring, Rational(Integer(1), Integer(2))) - substitute(lagrangian, at_rest);
  return result;
}

namespace {

std::vector<std::size_t> variables_that_matter(const VectorField& v,
                                               const std::vector<MPoly>& generators,
                                               const std::vector<MPoly>& nonzero) {
  std::vector<MFraction> all(v.components);
  for (const auto* polys : {&generators, &nonzero})
    all.insert(all.end(), polys->begin(), polys->end());
  for (const auto& f : v.functions)
    all.insert(all.end(), f.gradient.begin(), f.gradient.end());
  std::vector<std::size_t> main;
  for (const std::size_t i : v.main_variables())
    if (any_uses(all, i)) main.push_back(i);
  return main;
}

} // namespace

Ideal relation_ideal(const VectorField& v, const std::vector<MPoly>& more,
                     const std::vector<MPoly>& nonzero, const Budget& budget) {
  std::vector<MPoly> generators(v.relations);
  generators.insert(generators.end(), more.begin(), more.end());
  return {v.ring, variables_that_matter(v, generators, nonzero), generators, nonzero, budget};
}

bool is_zero_modulo(const MFraction& f, const Ideal& ideal) {
  return is_zero(f) || ideal.contains(f.num());
}

namespace {

// A polynomial that is 0 where f is defined and 0; unset if f is defined nowhere on the set.
std::optional<MPoly> where_defined(const MFraction& f, const Ideal& ideal) {
  if (ideal.vanishes(f.den())) return std::nullopt;
  return f.num() * ideal.normal_form(MFraction(f.den())).num();
}

} // namespace

bool is_in(const MFraction& f, const Ideal& ideal) {
  if (is_zero_modulo(f, ideal)) return true;
  const auto g = where_defined(f, ideal);
  return g && ideal.contains(*g);
}

bool vanishes_on(const MFraction& f, const Ideal& ideal) {
  if (is_zero_modulo(f, ideal) || ideal.vanishes(f.num())) return true;
  const auto g = where_defined(f, ideal);
  return g && ideal.vanishes(*g);
}

std::optional<MPoly> pole_along(const VectorField& v, const Ideal& ideal) {
  std::vector<MFraction> all(v.components);
  for (const auto& f : v.functions) // y u = x says nothing of u where x = y = 0
    if (is_among(f.variable, ideal.main()))
      all.push_back(lie_derivative(v, MFraction::variable(v.ring, f.variable)));
  for (const MFraction& x : all)
    if (!is_zero(x) && ideal.vanishes(x.den())) return x.den();
  return std::nullopt;
}

MPoly squarefree_part(const MPoly& f) {
  MPoly product(f.ring(), Integer(1));
  for (const MFactor& x : factor(f).second)
    product *= x.base;
  return product;
}

std::vector<MPoly> set_generators(const std::vector<Equation>& equations) {
  std::vector<MPoly> all;
  for (const Equation& e : equations)
    if (!is_zero(e.difference)) all.push_back(squarefree_part(e.difference.num()));
  return all;
}

} // namespace kov
