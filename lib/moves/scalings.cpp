#include "moves/scalings.hpp"

#include "exact/finite_algebra.hpp"

namespace kov {
namespace {

Weights exponents(const MPoly& f, long term) {
  Weights row;
  const auto e = f.exponents(term);
  for (std::size_t i = 0; i < e.size(); ++i)
    if (e[i] > 0) row[i] = static_cast<long>(e[i]);
  return row;
}
Weights minus(Weights a, const Weights& b) {
  for (const auto& [i, c] : b)
    a[i] -= c;
  return a;
}

} // namespace

void WeightEquations::add_row(const Weights& row) {
  auto& all = rows_.emplace_back(ring_->size() + 2, MFraction(ring_));
  for (const auto& [i, c] : row)
    all[i] = MFraction(ring_, Rational(c));
}

void WeightEquations::add_homogeneous(const MFraction& f) {
  if (is_zero(f)) return;
  for (const MPoly& p : {f.num(), f.den()})
    for (long t = 1; t < p.length(); ++t)
      add_row(minus(exponents(p, t), exponents(p, 0)));
}

void WeightEquations::add(const MFraction& f, const Weights& weight) {
  if (is_zero(f)) return;
  add_homogeneous(f);
  add_row(minus(minus(exponents(f.num(), 0), exponents(f.den(), 0)), weight));
}

Matrix WeightEquations::all() const { return null_space(rows_, ring_->size() + 2, ring_); }

WeightEquations weight_equations(const System& s) {
  const VectorField& v = s.field;
  const auto& x = v.coordinates;
  WeightEquations equations(v.ring);
  for (const MPoly& f : v.relations)
    equations.add_homogeneous(MFraction(f));
  for (std::size_t j = 0; j < v.dimension(); ++j)
    equations.add(v.components[j], {{x[j], 1}, {equations.time(), 1}});
  for (const FunctionSymbol& u : v.functions)
    for (std::size_t j = 0; j < v.dimension(); ++j)
      equations.add(u.gradient[j], {{u.variable, 1}, {x[j], -1}});
  if (v.poisson)
    for (std::size_t i = 0; i < v.dimension(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        equations.add((*v.poisson)[i][j], {{x[i], 1}, {x[j], 1}, {equations.bracket(), 1}});
  for (const std::size_t c : v.constants)
    equations.add_row({{c, 1}});
  return equations;
}

Matrix scalings(const System& s) { return weight_equations(s).all(); }

} // namespace kov
