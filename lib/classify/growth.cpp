#include "classify/growth.hpp"

#include <algorithm>

namespace kov {
namespace {

long degree_in(const std::vector<std::size_t>& variables, const MPoly& f) {
  long highest = 0;
  for (long t = 0; t < f.length(); ++t) {
    const auto e = f.exponents(t);
    long all = 0;
    for (const std::size_t i : variables)
      all += static_cast<long>(e[i]);
    highest = std::max(highest, all);
  }
  return highest;
}

} // namespace

std::optional<long> larger_coefficients(const System& s, long degree, long most) {
  const VectorField& v = s.field;
  if (s.kind != SystemKind::hamiltonian || !v.hamiltonian || !v.functions.empty())
    return std::nullopt;
  const auto half = v.coordinates.begin() + static_cast<long>(v.dimension() / 2);
  const std::vector<std::size_t> q(v.coordinates.begin(), half), p(half, v.coordinates.end());
  const MFraction& h = *v.hamiltonian;
  if (degree_in(p, h.den()) > 0) return std::nullopt;
  Substitution at_rest;
  for (const std::size_t i : p)
    at_rest[i] = MFraction(v.ring);
  const MFraction potential = substitute(h, at_rest);
  if (is_zero(potential)) return std::nullopt;
  const long below = degree_in(q, potential.den());
  const long needed = (degree_in(q, potential.num()) - below) * degree / 2;
  if (below == 0 || needed <= degree || needed > most) return std::nullopt;
  return needed;
}

} // namespace kov
