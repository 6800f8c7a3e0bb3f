#include "flow/scene/scene.hpp"

#include "symbol/document.hpp"

#include <algorithm>

namespace kov::flow {
namespace {

Quantity quantity(const Entry& e) { return Quantity(e.expression()); }

std::array<Quantity, 3> vector(const Entry& e) {
  if (e.array().size() != 3) throw e.error("'" + e.name() + "' must have three components");
  return {quantity(e.array()[0]), quantity(e.array()[1]), quantity(e.array()[2])};
}

void set(Quantity& q, const Entry& table, std::string_view key) {
  if (const Entry* e = table.find(key)) q = quantity(*e);
}

using Matrix = std::array<std::array<Quantity, 3>, 3>;

// The minors of order 2 of a symmetric matrix.
std::array<Quantity, 3> two_by_two(const Matrix& a) {
  const auto minor = [&](std::size_t i, std::size_t k) {
    return a[i][i] * a[k][k] - a[i][k] * a[i][k];
  };
  return {minor(0, 1), minor(1, 2), minor(2, 0)};
}

Quantity determinant(const Matrix& a) {
  const auto part = [&](std::size_t i) {
    const std::size_t k = (i + 1) % 3, n = (i + 2) % 3;
    return a[0][i] * (a[1][k] * a[2][n] - a[1][n] * a[2][k]);
  };
  return part(0) + part(1) + part(2);
}

// The least sign of the principal minors: 1 positive definite, 0 semidefinite, -1 neither.
int definiteness(const Matrix& a) {
  int least = determinant(a).sign();
  for (const Quantity& minor : two_by_two(a))
    least = std::min(least, minor.sign());
  for (std::size_t i = 0; i < 3; ++i)
    least = std::min(least, a[i][i].sign());
  return least;
}

// Principal moments of a rigid body: positive, and none larger than the sum of the others.  For a
// full tensor the same in terms of E = tr(I) - 2 I, which must be positive semidefinite.  All
// exact.
void check_inertia(const Entry& at, const Matrix& m) {
  for (std::size_t i = 0; i < 3; ++i)
    if (!(m[i][(i + 1) % 3] - m[(i + 1) % 3][i]).is_zero())
      throw at.error("the tensor of inertia is not symmetric");
  if (definiteness(m) < 1) throw at.error("the moments of inertia must be positive");
  Matrix e;
  const Quantity trace = m[0][0] + m[1][1] + m[2][2];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      e[i][k] = (i == k ? trace : Quantity()) - m[i][k] - m[i][k];
  if (definiteness(e) < 0)
    throw at.error("these moments of inertia violate the triangle inequality",
                   "no rigid body has a principal moment larger than the sum of the other two");
}

void read_body(const Entry& body, Scene& s) {
  body.check_keys({"inertia", "lever", "mass", "gravity", "tip", "gyrostat"});
  const Entry& inertia = body.at("inertia");
  if (inertia.array().size() != 3)
    throw inertia.error("'inertia' must be three principal moments or three rows");
  for (std::size_t i = 0; i < 3; ++i) {
    if (inertia.array()[i].is_array())
      s.inertia[i] = vector(inertia.array()[i]);
    else
      s.inertia[i][i] = quantity(inertia.array()[i]);
  }
  check_inertia(inertia, s.inertia);
  if (const Entry* e = body.find("lever")) s.lever = vector(*e);
  if (const Entry* e = body.find("gyrostat")) s.gyrostat = vector(*e);
  set(s.mass, body, "mass");
  set(s.gravity, body, "gravity");
  if (s.mass.sign() <= 0) throw body.at("mass").error("the mass must be positive");
  const Entry& tip = body.at("tip");
  if (tip.string() != "sliding" && tip.string() != "fixed")
    throw tip.error("the tip is \"sliding\" or \"fixed\"");
  s.sliding = tip.string() == "sliding";
}

void read_section(const Entry& e, Scene& s) {
  e.check_keys({"angle", "direction", "axis"});
  if (const Entry* axis = e.find("axis")) {
    if (axis->integer() < 1 || axis->integer() > 3) throw axis->error("the axis is 1, 2 or 3");
    s.section.axis = static_cast<int>(axis->integer()) - 1;
  }
  if (const Entry* angle = e.find("angle")) {
    const Quantity g = quantity(*angle);
    const bool first = (g - "pi/2").is_zero(), second = (g - "3*pi/2").is_zero();
    if (!first && !second)
      throw angle->error("the section angle must be \"pi/2\" or \"3*pi/2\"",
                         "only there is the section a polynomial in M and Gamma");
    s.section.side = first ? 1 : -1;
  }
  bool up = true, down = false;
  read_direction(e, up, down);
  // S falls with growing g where C > 0, and rises where C < 0
  s.section.falling = s.section.side > 0 ? up : down;
  s.section.rising = s.section.side > 0 ? down : up;
}

void read_orbits(const Entry& e, Scene& s) {
  e.check_keys({"seeds", "grid", "crossings", "time"});
  if (const Entry* seeds = e.find("seeds"))
    for (const Entry& pair : seeds->array()) {
      if (pair.array().size() != 2) throw pair.error("a seed is a pair [l, L/G]");
      s.seeds.push_back({quantity(pair.array()[0]), quantity(pair.array()[1])});
      if ((s.seeds.back().y - "1").sign() > 0 || (s.seeds.back().y + "1").sign() < 0)
        throw pair.error("L/G lies between -1 and 1");
    }
  read_limits(e, s.columns, s.rows, s.crossings, s.time);
  if (s.seeds.empty() && s.columns == 0) throw e.error("no orbits: give seeds or a grid");
}

} // namespace

void read_direction(const Entry& e, bool& upward, bool& downward) {
  const Entry* direction = e.find("direction");
  const std::string way = direction == nullptr ? "upward" : direction->string();
  if (way != "upward" && way != "downward" && way != "both")
    throw direction->error("the direction is \"upward\" (growing), \"downward\" or \"both\"");
  upward = way != "downward";
  downward = way != "upward";
}

void read_tolerance(const Entry& e, Quantity& tolerance, Quantity& drift, int& digits) {
  set(tolerance, e, "tolerance");
  set(drift, e, "drift");
  if (drift.sign() <= 0) throw e.at("drift").error("the drift must be positive");
  if (const Entry* d = e.find("digits")) {
    if (d->integer() < 16 || d->integer() > 300) throw d->error("'digits' is 16 to 300");
    digits = static_cast<int>(d->integer());
  }
  const double t = tolerance.as<double>(), floor = digits > 0 ? 0.0 : 1e-20;
  if (!(t > floor) || t > 0.01)
    throw e.at("tolerance")
        .error("the tolerance must lie between 10^-20 and 1/100", "smaller ones need 'digits'");
}

void read_limits(const Entry& e, int& columns, int& rows, long& crossings,
                 std::optional<Quantity>& time) {
  if (const Entry* grid = e.find("grid")) {
    if (grid->array().size() != 2) throw grid->error("a grid is [columns, rows]");
    const long across = grid->array()[0].integer(), up = grid->array()[1].integer();
    if (across < 1 || up < 1 || across > 1000 || up > 1000)
      throw grid->error("a grid has 1 to 1000 columns and rows");
    columns = static_cast<int>(across);
    rows = static_cast<int>(up);
  }
  if (const Entry* n = e.find("crossings")) {
    if (n->integer() < 1 || n->integer() > 1000000000)
      throw n->error("1 to 10^9 crossings of each orbit");
    crossings = n->integer();
  }
  if (const Entry* t = e.find("time")) {
    time = quantity(*t);
    if (time->sign() <= 0) throw t->error("the time must be positive");
  }
  if (crossings < 0 && !time) throw e.error("no end: give crossings or time");
}

SceneExpectation read_expectation(const Entry& e) {
  e.check_keys({"points", "singular", "drift", "elliptic", "hyperbolic", "inverse_hyperbolic",
                "proved", "never_crossed", "source"});
  SceneExpectation x;
  const auto count = [&](const char* key) {
    const Entry* n = e.find(key);
    return n == nullptr ? std::nullopt : std::optional<long>(n->integer());
  };
  if (const Entry* source = e.find("source")) x.source = source->string();
  if (const Entry* drift = e.find("drift")) x.drift = quantity(*drift);
  if (const Entry* proved = e.find("proved")) x.proved = proved->boolean();
  if (const Entry* never = e.find("never_crossed")) x.never_crossed = never->boolean();
  x.points = count("points");
  x.singular = count("singular");
  x.elliptic = count("elliptic");
  x.hyperbolic = count("hyperbolic");
  x.inverse_hyperbolic = count("inverse_hyperbolic");
  return x;
}

Scene read_scene(const Entry& root) {
  root.check_keys({"format", "title", "source", "body", "levels", "section", "orbits", "accuracy",
                   "plot", "expect"});
  const Entry& format = root.at("format");
  if (format.string() != "scene/1") throw format.error("the format of a scene is \"scene/1\"");
  Scene s;
  s.file = root.file();
  if (const Entry* e = root.find("title")) s.title = e->string();
  if (const Entry* e = root.find("source")) s.source = e->string();
  read_body(root.at("body"), s);
  const Entry& levels = root.at("levels");
  levels.check_keys({"H", "F1", "F2"});
  s.energy = quantity(levels.at("H"));
  s.casimir = quantity(levels.at("F2"));
  set(s.length, levels, "F1");
  if (s.length.sign() <= 0) throw levels.at("F1").error("F1 = |Gamma|^2 must be positive");
  if (const Entry* e = root.find("section")) read_section(*e, s);
  read_orbits(root.at("orbits"), s);
  if (const Entry* e = root.find("accuracy")) {
    e->check_keys({"tolerance", "drift", "digits"});
    read_tolerance(*e, s.tolerance, s.drift, s.digits);
  }
  if (const Entry* plot = root.find("plot")) {
    plot->check_keys({"sign_of"});
    if (const Entry* e = plot->find("sign_of")) s.sign_of = vector(*e);
  }
  if (const Entry* expect = root.find("expect"))
    for (const Entry& e : expect->array())
      s.expect.push_back(read_expectation(e));
  return s;
}

Scene read_scene(const std::string& path) { return read_scene(read_document(path)); }

Scene parse_scene(std::string text, const std::string& name) {
  return read_scene(parse_document(std::move(text), name));
}

} // namespace kov::flow
