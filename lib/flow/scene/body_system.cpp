#include "flow/scene/body_system.hpp"

#include "symbol/document.hpp"

#include <array>

namespace kov::flow {
namespace {

// H as a function of M = N + B, by Sherman and Morrison: s = v.I^-1 M, d = D = 1 + m v.I^-1 v, tip = m or 0.
// The vector v = alpha e + beta f is written in two directions orthogonal to L, e = L x (an axis) and f with e.I^-1 f = 0.
// The rates of N and Gamma, which are those of H, are written with the fewest products: p = z' = s/d,
//   N' = (I Omega - B) x Omega + m z' L x Gamma' + m g Gamma x L,   Gamma' = Gamma x Omega.
constexpr const char* body = R"toml(format = "equation/1"
[system]
kind = "euler-poisson"
coordinates = ["n1", "n2", "n3", "g1", "g2", "g3"]
parameters = ["i11", "i22", "i33", "i12", "i23", "i31", "l1", "l2", "l3", "b1", "b2", "b3", "x1", "x2", "x3", "c1", "c2", "c3", "tip", "weight", "level"]
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
p = "s/d"
o1 = "w1 - tip*(p*alpha*y1 + p*beta*z1)"
o2 = "w2 - tip*(p*alpha*y2 + p*beta*z2)"
o3 = "w3 - tip*(p*alpha*y3 + p*beta*z3)"
r1 = "g2*o3 - g3*o2"
r2 = "g3*o1 - g1*o3"
r3 = "g1*o2 - g2*o1"
q1 = "(i22 - i33)*o2*o3 + i12*o1*o3 - i31*o1*o2 + i23*(o3^2 - o2^2) - b2*o3 + b3*o2 + tip*p*(l2*r3 - l3*r2) + weight*(l3*g2 - l2*g3)"
q2 = "(i33 - i11)*o1*o3 + i23*o1*o2 - i12*o2*o3 + i31*(o1^2 - o3^2) - b3*o1 + b1*o3 + tip*p*(l3*r1 - l1*r3) + weight*(l1*g3 - l3*g1)"
q3 = "(i11 - i22)*o1*o2 + i31*o2*o3 - i23*o1*o3 + i12*(o2^2 - o1^2) - b1*o2 + b2*o1 + tip*p*(l1*r2 - l2*r1) + weight*(l2*g1 - l1*g2)"
F1 = "g1^2 + g2^2 + g3^2"
F2 = "n1*g1 + n2*g2 + n3*g3"
[scene]
section = "level*n3 - (n1^2 + n2^2 + n3^2)*g3"
start = ["q1", "q2", "q3", "r1", "r2", "r3"]
plot = ["n1", "c1*m1 + c2*m2 + c3*m3"]
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

// The values of the parameters.
std::string values_of(const Scene& s, const OwnUnits& u) {
  std::string set;
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
    number("c" + label(i), s.sign_of ? (*s.sign_of)[a].text() : "0");
  }
  const std::string mass = times_power(s.mass, -u.mass);
  number("tip", s.sliding && !no_lever ? mass : "0");
  number("weight", no_lever ? "0" : mass + "*" + times_power(s.gravity, 2 * u.time - u.length));
  number("level", times_power(s.casimir, -u.momentum() - u.vertical));
  return "set = {" + set + "}\n";
}

} // namespace

SystemScene system_of(const Scene& s) {
  const OwnUnits u = own_units(s);
  const Scene own = in_units(s, u);
  std::string text = body + values_of(s, u);
  text += line("where", s.section.side > 0 ? "n2*g1 - n1*g2" : "n1*g2 - n2*g1");
  text += line("direction", !s.section.falling ? "upward" : s.section.rising ? "both" : "downward");
  text += "[scene.levels]\n" + line("H", times_power(s.energy, -u.energy()));
  text += line("F1", times_power(s.length, -2 * u.vertical));
  text += line("F2", times_power(s.casimir, -u.momentum() - u.vertical));
  SystemScene scene = read_system_scenes(parse_document(text, s.file)).front();
  scene.start.clear(); // its formulas are known now
  scene.section.text = s.section.side > 0 ? "g = pi/2" : "g = 3*pi/2";
  if (s.sign_of) scene.sign_of = scene.plot[1].value;
  scene.sphere.emplace();
  for (std::size_t i = 0; i < 3; ++i)
    (*scene.sphere)[i] =
        MFraction::variable(scene.system.ring(), scene.system.field.coordinates[i]);
  scene.plot = {SceneFormula{(*scene.sphere)[0], "l"}, SceneFormula{(*scene.sphere)[2], "L/G"}};
  scene.angle = {true, false};
  scene.range = {{{"0", "2*pi"}, {"-1", "1"}}};
  scene.seeds.clear();
  for (const Seed& seed : s.seeds)
    scene.seeds.push_back({seed.l, seed.y});
  scene.columns = s.columns;
  scene.rows = s.rows;
  scene.crossings = s.crossings;
  scene.time = own.time;
  scene.tolerance = s.tolerance;
  scene.drift = s.drift;
  scene.digits = s.digits;
  scene.title = s.title;
  scene.source = s.source;
  scene.expect = s.expect;
  scene.body = std::make_shared<const BodyScene>(BodyScene{s, own, u});
  return scene;
}

} // namespace kov::flow
