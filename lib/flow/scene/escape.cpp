#include "flow/scene/escape.hpp"

#include "flow/number/rounded.hpp"
#include "flow/scene/simulate.hpp"

#include <cmath>

namespace kov::flow {
namespace {

template <class R> Vec<R> plane_of(const Scene& s) {
  return {(*s.sign_of)[0].as<R>(), (*s.sign_of)[1].as<R>(), (*s.sign_of)[2].as<R>()};
}

// The height where the plane meets the section over l: c.n(l, y) = 0 for n as in andoyer.hpp.
BigReal height_on_plane(const Scene& s, const BigReal& l) {
  const Vec<BigReal> c = plane_of<BigReal>(s);
  const int axis = s.section.axis;
  const BigReal across = c[(axis + 1) % 3] * sin(l) + c[(axis + 2) % 3] * cos(l);
  const BigReal y = across / sqrt(across * across + c[axis] * c[axis]);
  return c[axis] > BigReal(0) ? BigReal(0) - y : y;
}

State<BigReal> start_on_plane(const Scene& s, const BigReal& l) {
  const BigReal y = height_on_plane(s, l);
  const auto sizes = momentum_sizes(s.body<double>(), s.levels<double>(), s.section,
                                    static_cast<double>(l), static_cast<double>(y));
  if (sizes.empty())
    throw InputError(s.file, 0, 0, 1, "the level has no point of the plane over this l");
  return refine_point(s.body<BigReal>(), s.levels<BigReal>(), s.section, l, y, sizes.back());
}

// Ends the run at the first crossing off the plane.
template <class R> struct Watch : Sink<R> {
  Body<R> body;
  Vec<R> plane;
  std::atomic<bool> off{false};
  double time = 0;
  Watch(const Body<R>& b, const Vec<R>& c) : body(b), plane(c) {}
  void crossing(const Crossing<R>& c) override {
    if (off) return;
    const State<R> x{{c.x[0], c.x[1], c.x[2]}, {c.x[3], c.x[4], c.x[5]}};
    if (std::abs(static_cast<double>(dot(plane, momentum(body, x)))) < 0.01) return;
    time = static_cast<double>(c.t);
    off = true;
  }
  void finished(std::size_t, const Finish<R>&) override {}
};

template <class R> double escape(const Scene& s, const Quantity& l, double until) {
  const State<BigReal> x = start_on_plane(s, l.as<BigReal>());
  std::vector<R> numbers;
  for (const Vec<BigReal>& v : {x.omega, x.gamma})
    for (const BigReal& c : v)
      numbers.push_back(rounded<R>(c));
  const Body<R> body = s.body<R>();
  const Effects effects = s.effects();
  Watch<R> watch(body, plane_of<R>(s));
  Run<R> run;
  run.section = s.section;
  run.log2_tolerance = log2_estimate(unit_roundoff<R>()) - safety_bits;
  run.order = static_cast<int>(-0.36 * run.log2_tolerance) + 2;
  run.t_end = R(until);
  run.starts = numbers.data();
  run.orbits = 1;
  run.sink = &watch;
  run.stop = &watch.off;
  const Model<R> model = model_of(body, effects);
  if constexpr (std::is_same_v<R, double>)
    integrate(effects, model, body.sliding, run, 1);
  else if constexpr (std::is_same_v<R, Twin1>)
    integrate(effects, model, body.sliding, run, 0);
  else
    integrate(effects, model, body.sliding, run);
  return watch.off ? watch.time : until;
}

} // namespace

double escape_time(const Scene& scene, Arithmetic arithmetic, int digits, const Quantity& l,
                   double until) {
  if (!scene.sign_of)
    throw InputError(scene.file, 0, 0, 1, "the scene names no plane", "give sign_of in [plot]");
  const int enough = arithmetic == Arithmetic::mpfr ? digits : 40;
  const PrecisionScope scope(static_cast<long>(enough * std::log2(10.0)));
  switch (arithmetic) {
  case Arithmetic::packs:
  case Arithmetic::one_lane:
    return escape<double>(scene, l, until);
  case Arithmetic::extended:
    return escape<long double>(scene, l, until);
  case Arithmetic::pairs:
    return escape<Twin1>(scene, l, until);
  default:
    return escape<BigReal>(scene, l, until);
  }
}

} // namespace kov::flow
