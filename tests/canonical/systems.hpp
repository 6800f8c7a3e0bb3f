#pragma once
// Small systems, and elementary canonical changes of them.

#include "canonical/form.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

namespace kov::test {

inline System hamiltonian(const std::string& q, const std::string& p, const std::string& h,
                          const std::string& more = "") {
  return read_system(parse_document("[system]\nkind = 'hamiltonian'\ncoordinates = [" + q +
                                        "]\nmomenta = [" + p + "]\nhamiltonian = '" + h + "'\n" +
                                        more,
                                    "test.toml"));
}
inline System planar(const std::string& h, const std::string& more = "parameters = ['a', 'b']\n") {
  return hamiltonian("'x', 'y'", "'u', 'v'", h, more);
}
inline System lagrangian(const std::string& q, const std::string& v, const std::string& l) {
  return read_system(parse_document("[system]\nkind = 'lagrangian'\ncoordinates = [" + q +
                                        "]\nvelocities = [" + v +
                                        "]\nparameters = ['a', 'b']\nlagrangian = '" + l + "'\n",
                                    "test.toml"));
}

/// The Hamiltonian with q1, q2, ... p1, p2, ... for the coordinates and momenta: names do not matter.
inline std::string shape(const System& s) {
  const std::size_t n = s.field.dimension() / 2;
  auto names = s.ring()->names();
  for (std::size_t k = 0; k < 2 * n; ++k)
    names.push_back((k < n ? "q_" : "p_") + std::to_string(k % n));
  const Ring ring = make_ring(names);
  Substitution renamed;
  for (std::size_t k = 0; k < 2 * n; ++k)
    renamed[s.field.coordinates[k]] = MFraction::variable(ring, s.ring()->size() + k);
  return to_string(substitute(transfer(*s.field.hamiltonian, ring), renamed));
}

/// x = old(new variables), new = now(old variables).
struct Step {
  Substitution old, now;
};
inline Step inverse(const Step& s) { return {s.now, s.old}; }
inline Form changed(const Form& form, const Step& s) { return kov::changed(form, s.old, s.now); }

/// p + df, q + dg, a shift, (p, -q), (c q, p/c): one of them, of the pair i or of all.
inline Step random_step(const Form& form, Random& random) {
  const Ring& ring = form.field.ring;
  const std::size_t n = form.degrees();
  const auto number = [&] { return MFraction(ring, Rational(random.between(-3, 3))); };
  const auto x = [&](std::size_t k) {
    return MFraction::variable(ring, form.field.coordinates[k]);
  };
  const std::size_t i = static_cast<std::size_t>(random.between(0, static_cast<long>(n) - 1));
  const std::size_t k = (i + 1) % n, q = form.q(i), p = form.p(i);
  Step step;
  const auto moved = [&](std::size_t variable, const MFraction& by) {
    step.old[variable] = MFraction::variable(ring, variable) - by;
    step.now[variable] = MFraction::variable(ring, variable) + by;
  };
  switch (random.between(1, 5)) {
  case 1: {
    const MFraction f = number() * x(i) * x(i) * x(k) + number() * x(i) * x(k) + number() * x(k);
    for (std::size_t j = 0; j < n; ++j)
      moved(form.p(j), derivative(f, form.q(j)));
    break;
  }
  case 2: {
    const MFraction g = number() * x(n + i) * x(n + k) + number() * x(n + i) * x(n + i);
    for (std::size_t j = 0; j < n; ++j)
      moved(form.q(j), derivative(g, form.p(j)));
    break;
  }
  case 3:
    moved(q, number() + number() * MFraction::variable(ring, form.field.parameters.front()));
    moved(p, number());
    break;
  case 4:
    step = {{{q, -x(n + i)}, {p, x(i)}}, {{q, x(n + i)}, {p, -x(i)}}};
    break;
  default: {
    const Rational c(random.between(1, 4), random.once_in(2) ? -3 : 5);
    step = {{{q, Rational(1) / c * x(i)}, {p, c * x(n + i)}},
            {{q, c * x(i)}, {p, Rational(1) / c * x(n + i)}}};
  }
  }
  return step;
}

} // namespace kov::test
