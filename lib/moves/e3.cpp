#include "moves/e3.hpp"

#include "exact/error.hpp"

#include <algorithm>

namespace kov {
namespace {

bool same(const Matrix& a, const Matrix& b, int sign) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j)
      if (!is_zero(a[i][j] - Rational(sign) * b[i][j])) return false;
  return true;
}

// d^2 H/dx^2 at the origin of the phase space.
std::optional<MFraction> second_derivative_at_0(const VectorField& v, std::size_t x) {
  Substitution origin;
  for (const std::size_t i : v.coordinates)
    origin[i] = MFraction(v.ring);
  try {
    return substitute(derivative(derivative(*v.hamiltonian, x), x), origin);
  } catch (const DomainError&) { // a pole
    return std::nullopt;
  }
}

} // namespace

bool has_bracket_of_e3(const VectorField& v) {
  if (!v.poisson || v.dimension() != 6) return false;
  const Matrix e3 =
      e3_structure(v.ring, v.coordinates, std::vector<MFraction>(3, MFraction(v.ring)));
  return same(*v.poisson, e3, 1) || same(*v.poisson, e3, -1);
}

int assumed_sign(const System& s, std::size_t parameter) {
  const MFraction x = MFraction::variable(s.ring(), parameter);
  for (const Assumption& a : s.assumptions)
    if (a.is(Sign::positive) && (a.value == x || a.value == -x)) return a.value == x ? 1 : -1;
  return 0;
}

int sign_of_monomial(const System& s, const MPoly& p) {
  if (p.length() != 1) return 0;
  int all = sign(p.coefficient(0));
  const auto e = p.exponents(0);
  for (const std::size_t i : used_variables(p)) {
    const int one = assumed_sign(s, i);
    all *= e[i] % 2 == 0 ? one * one : one;
  }
  return all;
}

std::optional<FreeBody> free_body(const System& s) {
  const VectorField& v = s.field;
  if (!v.hamiltonian || !v.functions.empty() || !v.relations.empty() || !v.constants.empty() ||
      !has_bracket_of_e3(v))
    return std::nullopt;
  FreeBody body{};
  std::ranges::copy(v.coordinates, body.coordinates.begin());
  for (std::size_t k = 0; k < 3; ++k) {
    const auto a = second_derivative_at_0(v, v.coordinates[k]);
    if (!a || sign_of_monomial(s, a->num()) * sign_of_monomial(s, a->den()) <= 0)
      return std::nullopt;
    body.moments[k] = MFraction(s.ring(), Rational(1)) / *a;
  }
  const auto& m = body.moments;
  if (m[0] == m[1] || m[1] == m[2] || m[2] == m[0]) return std::nullopt;
  return body;
}

} // namespace kov
