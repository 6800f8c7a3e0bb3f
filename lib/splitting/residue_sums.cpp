#include "splitting/residue_sums.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"

#include <algorithm>

namespace kov {
namespace {

// The exponent of base in f.
long multiplicity(const MPoly& base, MPoly f) {
  long n = 0;
  while (const auto quotient = divides(base, f)) {
    f = *quotient;
    ++n;
  }
  return n;
}

// (1/(n-1)!) (d/dw + i k nu/w)^(n-1) F at w = w0 = +-1.
MFraction residue_at(const OrbitSpace& o, MFraction regular, long n, long k, int side) {
  const std::size_t w = o.chart.ring->index("z");
  const MFraction twist = Rational(k) * o.chart.variable("i") * o.nu / o.chart.variable("z");
  Integer factorial(1);
  for (long j = 1; j < n; ++j) {
    regular = o.field.reduce(derivative(regular, w) + twist * regular);
    factorial *= Integer(j);
  }
  const MFraction at = substitute(regular, {{w, MFraction(o.chart.ring, Rational(side))}});
  return o.field.reduce(Rational(Integer(1), factorial) * at);
}

} // namespace

// With z = i w the poles are w = +-1, and no denominator holds an i; dz/z = dw/w, dz = i dw.
StripResidues residues(const OrbitSpace& o, const MFraction& rational, long k, int sign) {
  const Ring& r = o.chart.ring;
  const std::size_t zi = r->index("z");
  const MFraction w = o.chart.variable("z"), i = o.chart.variable("i");
  const MFraction one(r, Rational(1));
  const MFraction turned = o.field.reduce(substitute(rational, {{zi, i * w}}));
  const MPoly circle = (w * w - one).num();
  StripResidues out{k, sign, rational, multiplicity(circle, turned.den()), {}, {}, {}, {}};
  const MFraction smooth = turned * pow(MFraction(circle), out.pole_order);
  if (kov::degree(smooth.den(), zi) != multiplicity(w.num(), smooth.den()))
    throw DomainError("h_k has poles other than z = 0, i and -i");
  const auto one_side = [&](int side, const MFraction& form) {
    const MFraction other = pow(w + Rational(side) * one, -out.pole_order);
    if (out.pole_order == 0) return MFraction(r);
    return residue_at(o, smooth * other * form, out.pole_order, k, side);
  };
  const MFraction in_t = pow(o.lambda * w, -1);
  out.upper = one_side(1, in_t);
  out.lower = one_side(-1, in_t);
  out.upper_dz = one_side(1, i);
  out.lower_dz = one_side(-1, i);
  return out;
}

MFraction strip_sum(const OrbitSpace& o, const StripResidues& r) {
  return o.field.reduce(r.upper + pow(o.chart.variable("Y"), r.k) * r.lower);
}

MFraction principal_sum(const OrbitSpace& o, const StripResidues& r) {
  return o.field.reduce(r.upper_dz + pow(o.chart.variable("Y"), -r.k) * r.lower_dz);
}

namespace {

// A moment x with a = 1/x (or a = x): x as a function of a.
std::pair<std::size_t, long> moment_parameter(const MFraction& a) {
  for (const long e : {-1L, 1L})
    for (const std::size_t v : used_variables(a))
      if (pow(a, e) == MFraction::variable(a.ring(), v)) return {v, e};
  throw DomainError("the moments of inertia must be parameters of the system, not " + brief(a));
}

// H1 in the variables of the chart.
MFraction in_chart(const EulerPerturbation& p, const OrbitSpace& o) {
  const Ring& source = p.first.ring();
  std::vector<std::string> names = o.chart.ring->names();
  for (const std::string& n : source->names())
    if (!o.chart.ring->find(n)) names.push_back(n);
  const Ring both = make_ring(names);
  Substitution values;
  const auto put = [&](std::size_t v, const MFraction& value) {
    values[both->index(source->name(v))] = transfer(value, both);
  };
  const std::array<MFraction, 3> inverse{o.a, o.b, o.c};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [v, e] = moment_parameter(p.inverse_inertia[k]);
    put(v, pow(inverse[k], e));
    put(p.coordinates[k], o.chart.momentum[k]);
    put(p.coordinates[k + 3], o.chart.gamma[k]);
  }
  return o.chart.field.reduce(transfer(substitute(transfer(p.first, both), values), o.chart.ring));
}

// The parameters of H1 that are not moments.
std::vector<std::string> other_parameters(const EulerPerturbation& p) {
  std::vector<std::string> names{"Y"};
  for (const std::size_t v : used_variables(p.first)) {
    bool known = is_among(v, p.coordinates);
    for (const auto& a : p.inverse_inertia)
      known = known || uses(a, v);
    if (!known) names.push_back(p.first.ring()->name(v));
  }
  return names;
}

} // namespace

SplittingData splitting_data(const EulerPerturbation& p, const Budget& budget) {
  SplittingData d{p, orbit_space(other_parameters(p)), {}, {}, {}, {}};
  d.checks = check_andoyer(d.space.chart);
  d.first = in_chart(p, d.space);
  d.modes = fourier_modes(d.space.chart, d.first);
  for (const int sign : {1, -1}) {
    const DoublyAsymptotic orbit = doubly_asymptotic(d.space, sign);
    std::ranges::copy(check_orbit(d.space, orbit), std::back_inserter(d.checks));
    for (const auto& [k, mode] : d.modes) {
      budget.check();
      if (k > 0)
        d.residues.push_back(residues(d.space, mode_on_orbit(d.space, orbit, mode, k), k, sign));
    }
  }
  return d;
}

} // namespace kov
