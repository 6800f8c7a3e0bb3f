#include "bench/escape.hpp"

#include "flow/scene/starts.hpp"
#include "flow/scene/system_section.hpp"

#include <cmath>

namespace kov::flow {
namespace {

// The height where the plane meets the section over l: c.n(l, y) = 0 for n as in starts.cpp.
BigReal height_on_plane(const Scene& s, const BigReal& l) {
  std::array<BigReal, 3> c;
  for (std::size_t i = 0; i < 3; ++i)
    c[i] = (*s.sign_of)[(static_cast<std::size_t>(s.section.axis) + 1 + i) % 3].as<BigReal>();
  const BigReal across = c[0] * sin(l) + c[1] * cos(l);
  const BigReal y = across / sqrt(across * across + c[2] * c[2]);
  return c[2] > BigReal(0) ? BigReal(0) - y : y;
}

// Exactly.
Quantity quantity_of(BigReal x) {
  const long power = mpfr_zero_p(x.raw()) != 0 ? 0 : mpfr_get_exp(x.raw()) - BigReal::bits();
  mpfr_mul_2si(x.raw(), x.raw(), -power, MPFR_RNDN);
  char* text = nullptr;
  mpfr_asprintf(&text, "%.0Rf", x.raw());
  const Quantity q(text);
  mpfr_free_str(text);
  return q.shifted(power);
}

std::vector<Quantity> start_on_plane(SystemScene scene, const Quantity& l) {
  scene.columns = scene.rows = 0;
  scene.seeds = {{l, quantity_of(height_on_plane(scene.body->own, l.as<BigReal>()))}};
  const Field field = field_of_starts(scene);
  std::vector<Quantity> x;
  for (const BigReal& one :
       StartRefiner<BigReal>(scene, field)(starts_of(scene, field, nullptr).back()))
    x.push_back(quantity_of(one));
  return x;
}

// The unit roundoff of the arithmetic.
const char* roundoff(Arithmetic a) {
  return a == Arithmetic::extended ? "2^-64" : a == Arithmetic::pairs ? "2^-104" : "2^-53";
}

} // namespace

double escape_time(const SystemScene& scene, Arithmetic arithmetic, int digits, const Quantity& l,
                   double until) {
  if (!scene.sign_of)
    throw InputError(scene.file, 0, 0, 1, "the scene names no plane", "give sign_of in [plot]");
  const BodyScene& body = *scene.body;
  const PrecisionScope scope(bits_of(arithmetic == Arithmetic::mpfr ? digits : 40));
  SystemScene s = scene;
  s.plot[1].value = *s.sign_of;
  s.sphere.reset();
  s.angle = {};
  s.seeds.clear();
  s.columns = s.rows = 0;
  s.states = {start_on_plane(scene, l)};
  s.digits = digits_of(arithmetic, digits);
  s.tolerance = arithmetic == Arithmetic::mpfr ? Quantity(("10^-" + std::to_string(digits)).c_str())
                                               : Quantity(roundoff(arithmetic));
  s.crossings = -1;
  for (double t = 16;; t *= 2) {
    s.time =
        Quantity(std::to_string(std::lround(std::min(t, until))).c_str()).shifted(-body.units.time);
    for (const DrawnPoint& p : simulate(s).points)
      if (std::abs(std::ldexp(p.at[1], static_cast<int>(body.units.momentum()))) > 0.01) return p.t;
    if (t >= until) return until;
  }
}

} // namespace kov::flow
