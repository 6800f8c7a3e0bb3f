#pragma once
// Systems with an invariant manifold, small enough to be expanded by hand.

#include "variation/normal.hpp"

#include "exact/polynomials.hpp"
#include "system/claims.hpp"

#include <stdexcept>

namespace kov::testing {

struct OnManifold {
  System system;
  InvariantManifold m;
  [[nodiscard]] const VectorField& v() const { return system.field; }
};

inline OnManifold on_manifold(const std::string& text) {
  OnManifold s{read_system(parse_document(text, "test.toml")), {}};
  auto proved = prove_invariant(s.system.field, s.system.manifolds.at(0));
  if (const auto* failure = std::get_if<ManifoldFailure>(&proved))
    throw std::invalid_argument(failure->message);
  s.m = std::get<InvariantManifold>(std::move(proved));
  return s;
}

/// Henon and Heiles; the equations of the manifold as given.
inline OnManifold henon_heiles(const std::string& equations = R"(["q1 = 0", "p1 = 0"])") {
  return on_manifold(R"t([system]
kind = "hamiltonian"
coordinates = ["q1", "q2"]
momenta = ["p1", "p2"]
parameters = ["b", "h"]
hamiltonian = "(p1^2 + p2^2)/2 + (q1^2 + q2^2)/2 + q1^2*q2 + b/3*q2^3"
[[manifold]]
level = "H = h"
equations = )t" + equations);
}

/// A limit cycle: the manifold is not linear.
inline OnManifold circle() {
  return on_manifold(R"t([system]
kind = "vector-field"
coordinates = ["x", "y", "u", "w"]
parameters = ["a"]
[system.field]
x = "-y + a*x*(1 - x^2 - y^2) + u"
y = "x + a*y*(1 - x^2 - y^2) + w*u"
u = "w + (x^2 + y^2 - 1)*x"
w = "(a + x)*u + w^2/(2 + x)"
[[manifold]]
equations = ["x^2 + y^2 = 1", "u = 0", "w = 0"])t");
}

/// Two coupled normal oscillators: a normal block of order 4.
inline OnManifold three_freedoms() {
  return on_manifold(R"t([system]
kind = "hamiltonian"
coordinates = ["q1", "q2", "q3"]
momenta = ["p1", "p2", "p3"]
parameters = ["a", "h"]
hamiltonian = "(p1^2 + p2^2 + p3^2)/2 + q1^4/4 + q2^2*q1 + q3^2*q1^2 + a*q2*q3*q1"
[[manifold]]
equations = ["q2 = 0", "p2 = 0", "q3 = 0", "p3 = 0"]
level = "H = h")t");
}

/// With the first integral u + x w, whose differential is not zero on u = w = s = 0.
inline OnManifold with_integral() {
  return on_manifold(R"t([system]
kind = "vector-field"
coordinates = ["x", "y", "u", "w", "s"]
parameters = ["h"]
[system.field]
x = "y"
y = "-x^3"
u = "-y*w - x^2*s"
w = "x*s"
s = "w + u"
[[integral]]
name = "F"
value = "u + x*w"
[[integral]]
name = "E"
value = "y^2/2 + x^4/4"
[[manifold]]
equations = ["u = 0", "w = 0", "s = 0"]
level = "E = h")t");
}

inline std::vector<OnManifold> all_systems() {
  std::vector<OnManifold> all;
  all.push_back(henon_heiles());
  all.push_back(circle());
  all.push_back(three_freedoms());
  all.push_back(with_integral());
  return all;
}

} // namespace kov::testing
