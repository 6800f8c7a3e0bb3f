#include "bench/effort.hpp"

#include "flow/scene/system_section.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace kov::flow {
namespace {

constexpr std::size_t kept_points = 10;

SystemSection run(SystemScene s, int tolerance, int digits, int lanes = 0) {
  s.tolerance = Quantity(("10^-" + std::to_string(tolerance)).c_str());
  s.digits = digits;
  SystemSectionOptions options;
  options.lanes = lanes;
  return simulate(s, options);
}

BigReal number(const std::string& text) {
  BigReal x;
  mpfr_set_str(x.raw(), text.c_str(), 10, MPFR_RNDN);
  return x;
}

// A point with all its digits.
std::array<BigReal, 2> drawn(const DrawnPoint& p) {
  if (p.digits.empty()) return {BigReal(p.at[0]), BigReal(p.at[1])};
  std::istringstream words(p.digits);
  std::string t, x, y;
  words >> t >> x >> y;
  return {number(x), number(y)};
}

// The first points of each orbit.
std::vector<std::vector<std::array<BigReal, 2>>> first_points(const SystemSection& s) {
  std::vector<std::vector<std::array<BigReal, 2>>> all(s.orbits.size());
  for (const DrawnPoint& p : s.points)
    if (all[p.orbit].size() < kept_points) all[p.orbit].push_back(drawn(p));
  return all;
}

double distance(const std::array<BigReal, 2>& a, const std::array<BigReal, 2>& b) {
  const auto size = [](const BigReal& x) { return std::abs(static_cast<double>(x)); };
  const BigReal turn = BigReal(2) * pi_of(BigReal());
  const BigReal l = a[0] - b[0];
  return std::max(std::min({size(l), size(l - turn), size(l + turn)}), size(a[1] - b[1]));
}

void compare(Effort& e, const SystemSection& run, const Reference& reference) {
  const auto points = first_points(run);
  for (std::size_t i = 0; i < run.orbits.size(); ++i) {
    e.crossings += run.orbits[i].crossings;
    e.wrong += run.orbits[i].crossings != reference.crossings.at(i) ? 1 : 0;
    const auto& wanted = reference.points.at(i);
    for (std::size_t n = 0; n < std::min(points[i].size(), wanted.size()); ++n)
      e.error = std::max(e.error, distance(points[i][n], wanted[n]));
  }
}

} // namespace

std::string to_string(Arithmetic a) {
  switch (a) {
  case Arithmetic::packs:
    return "double-" + std::to_string(best_lanes()) + "-lanes";
  case Arithmetic::one_lane:
    return "double-1-lane";
  case Arithmetic::extended:
    return "long-double";
  case Arithmetic::pairs:
    return "pairs-of-doubles";
  default:
    return "mpfr";
  }
}

int digits_of(Arithmetic a, int mpfr) {
  return a == Arithmetic::extended ? 19
         : a == Arithmetic::pairs  ? 31
         : a == Arithmetic::mpfr   ? mpfr
                                   : 0;
}

Reference reference_of(const SystemScene& scene, int digits) {
  const PrecisionScope scope(bits_of(digits + 2));
  Reference out;
  for (const DrawnOrbit& o : run(scene, 28, 31).orbits)
    out.crossings.push_back(o.crossings);
  SystemScene few = scene;
  few.crossings = kept_points;
  out.points = first_points(run(few, digits - 3, digits));
  return out;
}

Effort measure(const SystemScene& scene, Arithmetic arithmetic, int digits,
               const Reference& reference) {
  const PrecisionScope scope(bits_of(std::max(digits + 6, 42)));
  Effort e;
  e.tolerance = std::pow(10.0, -digits);
  e.seconds = INFINITY;
  for (int turn = 0; turn < 3 && (turn == 0 || e.seconds < 1); ++turn) {
    const SystemSection s = run(scene, digits, digits_of(arithmetic, std::max(digits + 6, 42)),
                                arithmetic == Arithmetic::one_lane ? 1 : 0);
    e.seconds = std::min(e.seconds, s.seconds);
    if (turn > 0) continue;
    e.order = s.order;
    e.drift = s.drift;
    compare(e, s, reference);
  }
  return e;
}

} // namespace kov::flow
