#include "splitting/conditions.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"

#include <algorithm>
#include <set>

namespace kov {
namespace {

// Everything positive that the sums contain: alpha, beta, delta, b, G > F > 0, Y < 1, ...
Cone sum_cone(const OrbitSpace& o) {
  const Ring& r = o.chart.ring;
  Substitution values;
  // Variables of the ring that the sums do not use stand for the new positive ones.
  const MFraction one(r, Rational(1)), y = o.chart.variable("cos_g"), w = o.chart.variable("sin_g");
  values[r->index("Y")] = one / (one + y);
  values[r->index("G")] = o.chart.variable("F") + w;
  // a = b - alpha^2 > 0: b = alpha^2 + (a new one)
  values[r->index("b")] =
      o.chart.variable("alpha") * o.chart.variable("alpha") + o.chart.variable("e");
  return Cone(values);
}

// Components of S and other parameters, unless the file says that they are positive: a factor with one of them in it
// has no sign.
bool uses_some_without_sign(const MPoly& f, const EulerPerturbation& p, const Ring& constants) {
  const auto used = used_variables(f);
  return std::ranges::any_of(used, [&](std::size_t v) {
    const std::string& name = f.ring()->name(v);
    return !constants->find(name) && !is_among(name, p.positive);
  });
}

// Real and imaginary parts of every sum, and for each k their sums and differences over the orbits.
std::vector<MFraction> parts_of_sums(const SplittingData& d) {
  const std::size_t i = d.space.chart.ring->index("i");
  std::map<long, std::vector<std::pair<MFraction, MFraction>>> by_k;
  for (const StripResidues& r : d.residues)
    by_k[r.k].push_back(d.space.field.parts(strip_sum(d.space, r), i));
  std::vector<MFraction> parts;
  for (const auto& [k, sums] : by_k) {
    KOV_ENSURE(sums.size() == 2);
    for (const int sign : {1, -1}) {
      parts.push_back(sums[0].first + Rational(sign) * sums[1].first);
      parts.push_back(sums[0].second + Rational(sign) * sums[1].second);
    }
  }
  return parts;
}

// A polynomial in alpha, beta, b, S, even in alpha and beta, as one in a, b, c, S.
MPoly in_moments(const OrbitSpace& o, const MPoly& f, const Ring& target) {
  MFraction value(target);
  const std::size_t alpha = o.chart.ring->index("alpha"), beta = o.chart.ring->index("beta");
  const auto x = [&](const char* n) { return MFraction::variable(target, n); };
  for (long t = 0; t < f.length(); ++t) {
    MFraction term(target, Rational(f.coefficient(t)));
    const auto e = f.exponents(t);
    for (std::size_t j = 0; j < e.size(); ++j) {
      if (e[j] == 0) continue;
      const bool root = j == alpha || j == beta;
      if (root && e[j] % 2 != 0) throw DomainError("an odd power of a root is left in a condition");
      if (!root && !target->find(o.chart.ring->name(j)))
        throw DomainError(o.chart.ring->name(j) + " is left in a condition");
      const MFraction base = j == alpha  ? x("b") - x("a")
                             : j == beta ? x("c") - x("b")
                                         : MFraction::variable(target, o.chart.ring->name(j));
      term *= pow(base, static_cast<long>(root ? e[j] / 2 : e[j]));
    }
    value += term;
  }
  return value.num();
}

// The parameters of H1 that are neither small nor moments.
std::vector<std::string> others_of(const SplittingData& d) {
  const EulerPerturbation& p = d.perturbation;
  std::vector<std::string> all;
  for (const std::size_t v : used_variables(p.first)) {
    const std::string& name = p.first.ring()->name(v);
    const bool known =
        is_among(v, p.coordinates) || is_among(name, p.small) || any_uses(p.inverse_inertia, v);
    if (!known) all.push_back(name);
  }
  return all;
}

// A function of these parameters alone.
bool is_in(const MPoly& f, const std::vector<std::string>& parameters) {
  const auto used = used_variables(f);
  return std::ranges::all_of(
      used, [&](std::size_t v) { return is_among(f.ring()->name(v), parameters); });
}

// The cone of the moments takes all other parameters for positive ones.
void require_signs(const MPoly& equation, const std::vector<std::string>& others,
                   const EulerPerturbation& p) {
  for (const std::size_t v : used_variables(equation)) {
    const std::string& name = equation.ring()->name(v);
    if (is_among(name, others) && !is_among(name, p.positive))
      throw DomainError("the sums of residues vanish where " + name +
                        ", which has no sign, satisfies an equation");
  }
}

} // namespace

Cone moment_cone(const Ring& ring) {
  const auto x = [&](const char* n) { return MFraction::variable(ring, n); };
  return Cone({{ring->index("b"), x("a") + x("u")}, {ring->index("c"), x("a") + x("u") + x("v")}});
}

VanishingConditions vanishing_conditions(const SplittingData& d) {
  const OrbitSpace& o = d.space;
  const std::vector<std::string>& small = d.perturbation.small;
  std::vector<std::string> names{"a", "b", "c", "A", "B", "C", "u", "v"};
  names.insert(names.end(), small.begin(), small.end());
  const std::vector<std::string> others = others_of(d);
  names.insert(names.end(), others.begin(), others.end());
  VanishingConditions out;
  out.ring = make_ring(names);
  for (const std::string& s : small)
    out.direction.push_back(out.ring->index(s));
  const Cone cone = sum_cone(o);
  const Ring constants = orbit_space({"Y"}).chart.ring;
  std::set<std::string> seen;
  for (const MFraction& part : parts_of_sums(d)) {
    if (is_zero(part)) continue;
    MPoly condition(o.chart.ring, Integer(1));
    for (const MFactor& f : factor(part.num()).second) {
      const bool has_sign =
          !uses_some_without_sign(f.base, d.perturbation, constants) && cone.sign(f.base) != 0;
      if (!has_sign && is_in(f.base, others))
        add_once(out.nonzero, transfer(MFraction(f.base), out.ring).num());
      else if (!has_sign)
        condition *= f.base;
      else if (const std::string text = to_string(f.base); !is_among(text, out.dropped))
        out.dropped.push_back(text);
    }
    const MPoly equation = in_moments(o, condition, out.ring);
    require_signs(equation, others, d.perturbation);
    if (seen.insert(to_string(equation)).second) out.equations.push_back(equation);
  }
  return out;
}

} // namespace kov
