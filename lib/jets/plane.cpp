#include "jets/plane.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"

#include <algorithm>
#include <array>

namespace kov::jets {
namespace {

std::string unused(const std::vector<std::string>& names, std::string name) {
  if (name == "E" && is_among(name, names)) name = "energy";
  while (is_among(name, names))
    name += "_";
  return name;
}

// The ring of the system with the variables of this room.
void extend_ring(const System& s, InvariantPlane& plane) {
  std::vector<std::string> names = s.ring()->names();
  for (const auto& [place, name] : {std::pair{&plane.x, "x"},
                                    {&plane.y, "y"},
                                    {&plane.e, "e"},
                                    {&plane.energy, "E"},
                                    {&plane.c1, "c1"},
                                    {&plane.c2, "c2"}}) {
    *place = names.size();
    names.push_back(unused(names, name));
  }
  plane.ring = make_ring(std::move(names));
}

/// (a p1^2 + b p2^2)/2 + V(q), q before p among the coordinates.
struct Natural {
  std::array<MFraction, 2> inertia; ///< a, b
  MFraction potential;
};

std::optional<Natural> natural_form(const VectorField& v) {
  const auto& z = v.coordinates;
  const Ring& ring = v.ring;
  const MFraction half(ring, Rational(1, 2));
  Natural n;
  MFraction rest = *v.hamiltonian;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t p = z[i + 2];
    n.inertia[i] = derivative(derivative(*v.hamiltonian, p), p);
    if (is_zero(n.inertia[i]) || uses_any(n.inertia[i], z)) return std::nullopt;
    rest -= half * n.inertia[i] * pow(MFraction::variable(ring, p), 2);
  }
  n.potential = rest;
  const std::vector<std::size_t> q{z[0], z[1]};
  if (uses_any(rest, {z[2], z[3]}) || is_zero(rest) || uses_any(MFraction(rest.den()), q))
    return std::nullopt;
  return n;
}

/// m1 q1 + m2 q2 = n.
struct Line {
  std::array<MFraction, 2> m;
  MFraction n;
};

std::optional<Line> line_of(const VectorField& v, const ManifoldSpec& spec) {
  const auto& z = v.coordinates;
  for (const Equation& equation : spec.equations) {
    Line line{{derivative(equation.difference, z[0]), derivative(equation.difference, z[1])}, {}};
    MFraction rest = equation.difference;
    for (std::size_t i = 0; i < 2; ++i)
      rest -= line.m[i] * MFraction::variable(v.ring, z[i]);
    const bool linear = !uses_any(line.m[0], z) && !uses_any(line.m[1], z) && !uses_any(rest, z);
    if (!linear || (is_zero(line.m[0]) && is_zero(line.m[1]))) continue;
    line.n = -rest;
    return line;
  }
  return std::nullopt;
}

/// q and p of the system in x, y and the momentum P along the line, for which x stands there.
struct Chart {
  LineOfConfigurations line;
  Substitution positions;    ///< q(x, y)
  Substitution on_the_plane; ///< q(0, y), p(P)
  MFraction across, along;   ///< x'' = -across dV/dx, y'' = -along dV/dy
  MFraction kinetic;         ///< P^2 kinetic/2 on the plane
};

MFraction variable_of(const InvariantPlane& plane, std::size_t i) {
  return MFraction::variable(plane.ring, i);
}

Chart axis_chart(const VectorField& v, const Natural& n, const Line& line, std::size_t across,
                 const InvariantPlane& plane) {
  const auto& z = v.coordinates;
  const std::size_t along = 1 - across;
  const MFraction x = variable_of(plane, plane.x), y = variable_of(plane, plane.y);
  const MFraction start = transfer(line.n / line.m[across], plane.ring);
  const MFraction a = transfer(n.inertia[across], plane.ring);
  const MFraction b = transfer(n.inertia[along], plane.ring);
  const MFraction one(plane.ring, Rational(1)), zero(plane.ring);
  LineOfConfigurations at{{zero, zero}, {zero, zero}, {zero, zero}};
  at.start[across] = start;
  at.across[across] = at.along[along] = one;
  return {at,
          {{z[across], start + x}, {z[along], y}},
          {{z[across], start},
           {z[along], y},
           {z[across + 2], MFraction(plane.ring)},
           {z[along + 2], x}},
          a,
          b,
          b};
}

// q = ((n + x) m + y m')/|m|^2, m' = (-m2, m1): x = m.q - n, y = m'.q.
Chart line_chart(const VectorField& v, const Natural& n, const Line& line,
                 const InvariantPlane& plane) {
  const auto& z = v.coordinates;
  const MFraction x = variable_of(plane, plane.x), y = variable_of(plane, plane.y);
  const MFraction m1 = transfer(line.m[0], plane.ring), m2 = transfer(line.m[1], plane.ring);
  const MFraction start = transfer(line.n, plane.ring);
  const MFraction square = m1 * m1 + m2 * m2;
  const MFraction a = transfer(n.inertia[0], plane.ring);
  const auto position = [&](const MFraction& off) {
    return std::pair{(off * m1 - y * m2) / square, (off * m2 + y * m1) / square};
  };
  const auto [q1, q2] = position(start + x);
  const auto [r1, r2] = position(start);
  return {{{start * m1 / square, start * m2 / square},
           {m1 / square, m2 / square},
           {-(m2 / square), m1 / square}},
          {{z[0], q1}, {z[1], q2}},
          {{z[0], r1}, {z[1], r2}, {z[2], -(x * m2) / square}, {z[3], x * m1 / square}},
          a * square,
          a * square,
          a / square};
}

// K (H - E) for a constant K, or nothing.
std::optional<MFraction> level_of_energy(const InvariantPlane& plane, const Chart& chart,
                                         const MFraction& difference) {
  const MFraction on_plane = substitute(difference, chart.on_the_plane);
  const MFraction p = variable_of(plane, plane.x);
  const MFraction factor = derivative(derivative(on_plane, plane.x), plane.x) / chart.kinetic;
  if (is_zero(factor) || uses_any(factor, {plane.x, plane.y})) return std::nullopt;
  const MFraction half(plane.ring, Rational(1, 2));
  const MFraction energy = half * chart.kinetic * p * p + plane.potential;
  const MFraction level = plane.reduced(energy - on_plane / factor);
  if (uses_any(level, {plane.x, plane.y})) return std::nullopt;
  return level;
}

void keep_nonzero(InvariantPlane& plane, const MPoly& p) {
  if (!is_constant(p)) plane.nonzero.push_back(p);
}

// The one algebraic constant generates an extension of the field of the parameters.
std::optional<OutOfScope> take_constants(const VectorField& v, InvariantPlane& plane) {
  if (v.constants.empty()) return std::nullopt;
  if (v.constants.size() > 1 || v.relations.size() != 1) return OutOfScope::several_constants;
  const auto factors = factor(v.relations.front()).second;
  if (factors.size() != 1 || factors.front().exponent != 1) return OutOfScope::reducible_relation;
  const auto used = used_variables(v.relations.front());
  for (const std::size_t i : used)
    if (is_among(i, v.coordinates)) return OutOfScope::related_coordinates;
  plane.relation = transfer(MFraction(v.relations.front()), plane.ring).num();
  plane.constants.emplace(plane.ring, v.constants, std::vector<MPoly>{*plane.relation});
  for (const MPoly& p : plane.constants->inverted())
    keep_nonzero(plane, p);
  return std::nullopt;
}

using Univariate = std::vector<MFraction>; // ascending, the last coefficient is not 0

void trim(Univariate& f) {
  while (!f.empty() && is_zero(f.back()))
    f.pop_back();
}

// a - factor x^shift b, without the leading term.
Univariate minus_multiple(Univariate a, const MFraction& factor, std::size_t shift,
                          const Univariate& b) {
  if (a.size() < b.size() + shift) a.resize(b.size() + shift);
  for (std::size_t i = 0; i < b.size(); ++i)
    a[i + shift] -= factor * b[i];
  return a;
}

} // namespace

MFraction InvariantPlane::reduced(const MFraction& f) const {
  if (!constants || is_zero(f)) return f;
  const std::size_t constant = constants->main().front();
  if (!uses(f.den(), constant)) return constants->normal_form(f);
  return constants->normal_form(constants->normal_form(f.num()) *
                                inverse_modulo(f.den(), *relation, constant));
}

MPoly InvariantPlane::norm(const MPoly& f) const {
  if (!constants || !uses(f, constants->main().front())) return f;
  return resultant(f, *relation, constants->main().front());
}

InvariantPlane InvariantPlane::reflected() const {
  InvariantPlane other = *this;
  const Substitution minus{{y, -MFraction::variable(ring, y)}};
  other.across = substitute(across, minus);
  other.along = -substitute(along, minus);
  other.potential = substitute(potential, minus);
  for (MFraction& m : other.line.along)
    m = -m;
  return other;
}

std::vector<MFraction> coefficients(const MFraction& f, std::size_t i) {
  std::vector<MFraction> all;
  if (is_zero(f)) return all;
  KOV_ENSURE(!uses(f.den(), i));
  for (const MPoly& c : coefficients(f.num(), i))
    all.emplace_back(c, f.den());
  return all;
}

MFraction inverse_modulo(const MFraction& f, const MFraction& r, std::size_t i) {
  Univariate a = coefficients(r, i), b = coefficients(f, i);
  Univariate s, t{MFraction(f.ring(), Rational(1))};
  while (b.size() > 1) { // s f = a, t f = b modulo r
    while (a.size() >= b.size()) {
      const MFraction q = a.back() / b.back();
      const std::size_t shift = a.size() - b.size();
      a = minus_multiple(std::move(a), q, shift, b);
      s = minus_multiple(std::move(s), q, shift, t);
      trim(a);
      trim(s);
    }
    std::swap(a, b);
    std::swap(s, t);
  }
  if (b.empty()) throw DomainError("division by 0 modulo a polynomial");
  MFraction sum(f.ring());
  const MFraction x = MFraction::variable(f.ring(), i);
  for (std::size_t k = t.size(); k-- > 0;)
    sum = sum * x + t[k];
  return sum / b[0];
}

std::variant<InvariantPlane, OutOfScope> invariant_plane(const System& s, const ManifoldSpec& m) {
  const VectorField& v = s.field;
  if (s.kind != SystemKind::hamiltonian || v.dimension() != 4 || !v.functions.empty())
    return OutOfScope::not_polynomial;
  const auto natural = natural_form(v);
  if (!natural) return OutOfScope::not_natural;
  const auto line = line_of(v, m);
  if (!line) return OutOfScope::no_line;
  InvariantPlane plane;
  extend_ring(s, plane);
  if (auto no = take_constants(v, plane)) return *no;
  const bool axis = is_zero(line->m[0]) || is_zero(line->m[1]);
  if (!axis && !(natural->inertia[0] == natural->inertia[1])) return OutOfScope::inertias_differ;
  const MFraction square = transfer(line->m[0] * line->m[0] + line->m[1] * line->m[1], plane.ring);
  if (is_zero(plane.reduced(square))) return OutOfScope::isotropic_line;
  const Chart chart = axis ? axis_chart(v, *natural, *line, is_zero(line->m[0]) ? 1 : 0, plane)
                           : line_chart(v, *natural, *line, plane);
  const MFraction potential = substitute(transfer(natural->potential, plane.ring), chart.positions);
  plane.across = plane.reduced(-(chart.across * derivative(potential, plane.x)));
  plane.along = plane.reduced(-(chart.along * derivative(potential, plane.y)));
  plane.line = chart.line;
  plane.inertia = chart.along;
  const Substitution zero{{plane.x, MFraction(plane.ring)}};
  plane.potential = plane.reduced(substitute(potential, zero));
  if (!is_zero(substitute(plane.across, zero))) return OutOfScope::force_off_the_line;
  for (const MFraction& f : {plane.across, plane.along, plane.potential, chart.across, chart.along,
                             chart.kinetic, square})
    if (!is_zero(f)) keep_nonzero(plane, f.den());
  for (const MFraction& f : {chart.across, chart.along, square})
    keep_nonzero(plane, f.num());
  for (const Equation& level : m.levels)
    if (!plane.level)
      plane.level = level_of_energy(plane, chart, transfer(level.difference, plane.ring));
  return plane;
}

} // namespace kov::jets
