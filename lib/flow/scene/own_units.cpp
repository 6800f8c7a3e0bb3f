#include "flow/scene/own_units.hpp"

#include <algorithm>
#include <cmath>

namespace kov::flow {
namespace {

double largest(const std::array<Quantity, 3>& v) {
  return std::max({v[0].log2_size(), v[1].log2_size(), v[2].log2_size()});
}

double largest_moment(const Scene& s) {
  return std::max({largest(s.inertia[0]), largest(s.inertia[1]), largest(s.inertia[2])});
}

// log2 of the larger of |H| and the weight times the lever.
double energy_size(const Scene& s) {
  const double weight =
      s.mass.log2_size() + s.gravity.log2_size() + largest(s.lever) + s.length.log2_size() / 2;
  return std::max(s.energy.log2_size(), weight);
}

// log2 of the fastest angular velocity: of the energy, and of the gyrostat's rotor.
double speed(const Scene& s) {
  const double inertia = largest_moment(s);
  return std::max((energy_size(s) - inertia) / 2, largest(s.gyrostat) - inertia);
}

void shift(std::array<Quantity, 3>& v, long k) {
  for (Quantity& q : v)
    q = q.shifted(k);
}

void check_size(const Scene& s, const Quantity& q, const char* what) {
  if (q.log2_size() > 332)
    throw InputError(s.file, 0, 0, 1,
                     std::string("beside the other numbers of the scene, ") + what + " = " +
                         q.text() + " is larger than 10^100");
}

} // namespace

OwnUnits own_units(const Scene& s) {
  OwnUnits u;
  const double rate = speed(s);
  u.mass = std::lround(s.mass.log2_size());
  u.length = std::lround((largest_moment(s) - static_cast<double>(u.mass)) / 2);
  u.time = std::isfinite(rate) ? std::lround(-rate) : 0;
  u.vertical = std::lround(s.length.log2_size() / 2);
  for (const long k : {u.mass, u.length, u.time, u.vertical, u.inertia(), u.momentum(), u.energy()})
    if (std::abs(k) > 900) // results are doubles in the units of the scene
      throw InputError(s.file, 0, 0, 1, "this scene has times, lengths or momenta beyond 10^270",
                       "choose units that suit it");
  return u;
}

Scene in_units(const Scene& s, const OwnUnits& u) {
  Scene o = s;
  for (auto& row : o.inertia)
    shift(row, -u.inertia());
  shift(o.lever, u.vertical - u.length);
  shift(o.gyrostat, -u.momentum());
  o.mass = s.mass.shifted(-u.mass);
  o.gravity = s.gravity.shifted(2 * u.time - u.length);
  o.energy = s.energy.shifted(-u.energy());
  o.length = s.length.shifted(-2 * u.vertical);
  o.casimir = s.casimir.shifted(-u.momentum() - u.vertical);
  if (s.time) o.time = s.time->shifted(-u.time);
  check_size(o, o.casimir, "F2");
  check_size(o, o.gravity, "gravity");
  for (const Quantity& l : o.lever)
    check_size(o, l, "lever");
  return o;
}

} // namespace kov::flow
