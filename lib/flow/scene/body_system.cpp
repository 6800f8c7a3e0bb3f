#include "flow/scene/body_system.hpp"

#include "symbol/document.hpp"

#include <array>

namespace kov::flow {
namespace {

// H of body.hpp as a function of M = N + B, by Sherman and Morrison: s = v.I^-1 M, d = D, tip = m or 0.  The vector
// v = alpha e + beta f is written in two conjugate directions, e = L x (an axis) and f (model.hpp).
constexpr const char* body = R"toml(format = "equation/1"
[system]
kind = "euler-poisson"
coordinates = ["n1", "n2", "n3", "g1", "g2", "g3"]
parameters = ["i11", "i22", "i33", "i12", "i23", "i31", "l1", "l2", "l3", "b1", "b2", "b3", "x1", "x2", "x3", "tip", "weight"]
hamiltonian = "(m1*w1 + m2*w2 + m3*w3)/2 - tip*s*(s/d)/2 + weight*(l1*g1 + l2*g2 + l3*g3)"
[system.define]
det = "i11*i22*i33 + 2*i12*i23*i31 - i11*i23^2 - i22*i31^2 - i33*i12^2"
a11 = "(i22*i33 - i23^2)/det"
a22 = "(i33*i11 - i31^2)/det"
a33 = "(i11*i22 - i12^2)/det"
a12 = "(i23*i31 - i12*i33)/det"
a23 = "(i31*i12 - i23*i11)/det"
a31 = "(i12*i23 - i31*i22)/det"
m1 = "n1 + b1"
m2 = "n2 + b2"
m3 = "n3 + b3"
w1 = "a11*m1 + a12*m2 + a31*m3"
w2 = "a12*m1 + a22*m2 + a23*m3"
w3 = "a31*m1 + a23*m2 + a33*m3"
e1 = "l2*x3 - l3*x2"
e2 = "l3*x1 - l1*x3"
e3 = "l1*x2 - l2*x1"
y1 = "a11*e1 + a12*e2 + a31*e3"
y2 = "a12*e1 + a22*e2 + a23*e3"
y3 = "a31*e1 + a23*e2 + a33*e3"
f1 = "l2*y3 - l3*y2"
f2 = "l3*y1 - l1*y3"
f3 = "l1*y2 - l2*y1"
z1 = "a11*f1 + a12*f2 + a31*f3"
z2 = "a12*f1 + a22*f2 + a23*f3"
z3 = "a31*f1 + a23*f2 + a33*f3"
ee = "e1*y1 + e2*y2 + e3*y3"
ff = "f1*z1 + f2*z2 + f3*z3"
alpha = "((y2*l3 - y3*l2)*g1 + (y3*l1 - y1*l3)*g2 + (y1*l2 - y2*l1)*g3)/ee"
beta = "((z2*l3 - z3*l2)*g1 + (z3*l1 - z1*l3)*g2 + (z1*l2 - z2*l1)*g3)/ff"
s = "alpha*(e1*w1 + e2*w2 + e3*w3) + beta*(f1*w1 + f2*w2 + f3*w3)"
d = "1 + tip*(ee*alpha^2 + ff*beta^2)"
casimir = "n1*g1 + n2*g2 + n3*g3"
[scene]
section = "casimir*n3 - (n1^2 + n2^2 + n3^2)*g3"
plot = ["n1", "n3"]
seeds = [[0, 0]]
crossings = 1
)toml";

// The number in own units.
std::string times_power(const Quantity& q, long k) {
  return "(" + q.text() + ")*2^(" + std::to_string(k) + ")";
}

// The axis of the body that is the i-th here.
std::size_t inner_axis(const Scene& s, std::size_t i) {
  return (static_cast<std::size_t>(s.section.axis) + 1 + i) % 3;
}

std::string line(const std::string& key, const std::string& value) {
  return key + " = \"" + value + "\"\n";
}

} // namespace

SystemScene system_of(const Scene& s, const OwnUnits& u) {
  std::string set, text = body;
  std::array<Quantity, 3> lever;
  for (std::size_t i = 0; i < 3; ++i)
    lever[i] = s.lever[inner_axis(s, i)];
  const bool no_lever = lever[0].is_zero() && lever[1].is_zero() && lever[2].is_zero();
  if (no_lever) lever[0] = "1"; // any: it has no effect
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (lever[i].log2_size() < lever[least].log2_size()) least = i;
  const auto number = [&](const std::string& name, const std::string& value) {
    set += (set.empty() ? "" : ", ") + name + " = \"" + value + "\"";
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const auto label = [](std::size_t k) { return std::to_string(k % 3 + 1); };
    const std::size_t a = inner_axis(s, i), b = inner_axis(s, i + 1);
    number("i" + label(i) + label(i), times_power(s.inertia[a][a], -u.inertia()));
    number("i" + label(i) + label(i + 1), times_power(s.inertia[a][b], -u.inertia()));
    number("l" + label(i), times_power(lever[i], u.vertical - u.length));
    number("b" + label(i), times_power(s.gyrostat[a], -u.momentum()));
    number("x" + label(i), i == least ? "1" : "0");
  }
  const std::string mass = times_power(s.mass, -u.mass);
  number("tip", s.sliding && !no_lever ? mass : "0");
  number("weight", no_lever ? "0" : mass + "*" + times_power(s.gravity, 2 * u.time - u.length));
  text += "set = {" + set + "}\n";
  text += line("where", s.section.side > 0 ? "n2*g1 - n1*g2" : "n1*g2 - n2*g1");
  text += line("direction", s.section.falling ? "downward" : "upward");
  text += "[scene.levels]\n" + line("H", times_power(s.energy, -u.energy()));
  text += line("casimir", times_power(s.casimir, -u.momentum() - u.vertical));
  text += line("\"g1^2 + g2^2 + g3^2\"", times_power(s.length, -2 * u.vertical));
  return read_system_scenes(parse_document(text, s.file)).front();
}

} // namespace kov::flow
