#pragma once
// What all integrators of kovacic-peers are given, and what is measured on the way.

// These files are compiled with contraction, as suits the others: their inlined code stays their own.
#define KOV_ISA peers
#include "body.hpp"
#include "flow/scene/body_system.hpp"
#include "flow/scene/system_section.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace kov::peers {

using namespace kov::flow;
using X = std::array<double, 6>;

// Omega' and Gamma' for principal axes, written as a person would.
template <bool sliding> struct Field {
  double i1, i2, i3, l1, l2, l3, m, g;
  explicit Field(const Body<double>& b)
      : i1(b.inertia[0][0]), i2(b.inertia[1][1]), i3(b.inertia[2][2]), l1(b.lever[0]),
        l2(b.lever[1]), l3(b.lever[2]), m(b.mass), g(b.gravity) {}
  /// V: numbers, or formulas.
  template <class V>
  void operator()(const std::array<V, 6>& x, std::array<V, 6>& d, double = 0) const {
    const auto& [w1, w2, w3, g1, g2, g3] = x;
    d[3] = g2 * w3 - g3 * w2;
    d[4] = g3 * w1 - g1 * w3;
    d[5] = g1 * w2 - g2 * w1;
    const V y1 = (i2 - i3) / i1 * w2 * w3, y2 = (i3 - i1) / i2 * w3 * w1,
            y3 = (i1 - i2) / i3 * w1 * w2;
    const V v1 = l2 * g3 - l3 * g2, v2 = l3 * g1 - l1 * g3, v3 = l1 * g2 - l2 * g1;
    const V u1 = v1 / i1, u2 = v2 / i2, u3 = v3 / i3;
    V push = V(m * g);
    if constexpr (sliding) {
      const V e1 = l2 * d[5] - l3 * d[4], e2 = l3 * d[3] - l1 * d[5], e3 = l1 * d[4] - l2 * d[3];
      const V dm1 = m * (v1 * u1 + v2 * u2 + v3 * u3);
      push = push + m * (e1 * w1 + e2 * w2 + e3 * w3 + v1 * y1 + v2 * y2 + v3 * y3 - g * dm1) /
                        (1.0 + dm1);
    }
    d[0] = y1 - push * u1;
    d[1] = y2 - push * u2;
    d[2] = y3 - push * u3;
  }
};

// What a precise run found: the number of crossings of an orbit, and (l, y) of its first 10.
struct Reference {
  long crossings = -1;
  std::vector<std::array<double, 2>> points;
};

struct Problem {
  SystemScene scene; ///< in its own units, as all of this
  Body<double> body;
  std::vector<X> starts;
  double t_end = 0;
  std::vector<Reference> reference;
};

inline double section(const Body<double>& b, const X& x, double& side) {
  const State<double> s{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
  const Vec<double> n = momentum(b, s);
  side = n[1] * s.gamma[0] - n[0] * s.gamma[1];
  return dot(n, s.gamma) * n[2] - dot(n, n) * s.gamma[2];
}

// How large H, F1 and F2 can be on the level: drifts are relative to these.
inline Integrals<double> sizes_on_level(const Scene& s) {
  const Body<double> b = body_of(s);
  const auto sum = [](const Vec<double>& v) {
    return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
  };
  const double lever = sum(b.lever), energy = std::abs(s.energy.as<double>()),
               length = s.length.as<double>();
  double moments = b.inertia[0][0] + b.inertia[1][1] + b.inertia[2][2];
  if (b.sliding) moments += b.mass * lever * lever * length;
  const double weight = b.mass * std::abs(b.gravity) * lever * std::sqrt(length);
  const double most = std::sqrt(2 * moments * (energy + weight)) * 1.01 + 2 * sum(b.gyrostat);
  return {std::max(energy, 1e-300), length, std::max(most * std::sqrt(length), 1e-300)};
}

// What is measured on the way: the same for every method.
struct Tally {
  const Problem& p;
  Integrals<double> sizes;
  long crossings = 0, wrong = 0;
  double drift = 0, error = 0;
  double seconds = -1; ///< of the integration, where a method tells it
  Integrals<double> first{};
  std::size_t orbit = 0;
  long of_orbit = 0;
  explicit Tally(const Problem& problem) : p(problem), sizes(sizes_on_level(p.scene.body->own)) {}
  static State<double> state(const X& x) { return {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}}; }
  void begin(std::size_t i) {
    orbit = i;
    of_orbit = 0;
    first = integrals(p.body, state(p.starts[i]));
  }
  void look(const X& x) {
    const auto now = integrals(p.body, state(x));
    drift = std::max({drift, std::abs(now.energy - first.energy) / sizes.energy,
                      std::abs(now.length - first.length) / sizes.length,
                      std::abs(now.casimir - first.casimir) / sizes.casimir});
  }
  void cross(const X& x) {
    ++crossings;
    look(x);
    if (orbit < p.reference.size() &&
        of_orbit < static_cast<long>(p.reference[orbit].points.size())) {
      const auto a = on_sphere(momentum(p.body, state(x)));
      const auto& r = p.reference[orbit].points[of_orbit];
      error =
          std::max({error, std::abs(std::remainder(a[0] - r[0], 2 * M_PI)), std::abs(a[1] - r[1])});
    }
    ++of_orbit;
  }
  // The end of an orbit.
  void end(const X& x) {
    look(x);
    if (orbit < p.reference.size() && of_orbit != p.reference[orbit].crossings) ++wrong;
  }
  [[nodiscard]] std::string row() const {
    std::ostringstream out;
    out << crossings << ' ' << wrong << ' ' << drift << ' ' << error;
    return out.str();
  }
};

/// Integrates all orbits of a problem.
using Method = std::function<void(double tolerance, Tally&)>;

/// heyoka's Taylor integrator in batches; empty in a build without it.
std::map<std::string, Method> heyoka_methods(const Problem& p);

} // namespace kov::peers
