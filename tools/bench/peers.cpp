// kovacic-peers SCENE [REFERENCE] [SECONDS]: the orbits of a scene with other people's integrators,
// for `kovacic bench accuracy`.
// kovacic-peers --ratios SCENE [SECONDS]: theirs and ours by turns in one process, so that whatever
// slows the machine slows both: how many times as long they take for the same drift.
//
// Boost.odeint: dopri5 (dense output), rkf78 (controlled), Bulirsch-Stoer (dense output);
// SUNDIALS: CVODE (Adams) and ARKODE (explicit Runge-Kutta, order 8) with their own root finding.
// Each gets the same right-hand side, written out for the effects of the scene and compiled for
// this machine, the same starts, and the same section: sign change of S at the end of a step, then
// the crossing is located (dense output with bisection and secant, or the package's root finder).
// Output, one line for each run:
//   method tolerance seconds crossings wrong drift error10
// seconds: of the processor, the best of three;  wrong: orbits whose number of crossings differs
// from that in the file REFERENCE (lines: orbit crossings l_1 y_1 ... l_10 y_10);  error10: largest
// distance of the first 10 section points of each orbit from those there.

// This file is compiled with contraction, as suits the others: its inlined kernels stay its own.
#define KOV_ISA peers
#include "flow/simulate.hpp"

#include <boost/numeric/odeint.hpp>

#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

namespace {

using namespace kov::flow;
namespace ode = boost::numeric::odeint;
using X = std::array<double, 6>;

// Omega' and Gamma' for principal axes, written as a person would.
template <bool sliding> struct Field {
  double i1, i2, i3, l1, l2, l3, m, g;
  explicit Field(const Body<double>& b)
      : i1(b.inertia[0][0]), i2(b.inertia[1][1]), i3(b.inertia[2][2]), l1(b.lever[0]),
        l2(b.lever[1]), l3(b.lever[2]), m(b.mass), g(b.gravity) {}
  void operator()(const X& x, X& d, double = 0) const {
    const auto [w1, w2, w3, g1, g2, g3] = x;
    d[3] = g2 * w3 - g3 * w2;
    d[4] = g3 * w1 - g1 * w3;
    d[5] = g1 * w2 - g2 * w1;
    const double y1 = (i2 - i3) / i1 * w2 * w3, y2 = (i3 - i1) / i2 * w3 * w1,
                 y3 = (i1 - i2) / i3 * w1 * w2;
    const double v1 = l2 * g3 - l3 * g2, v2 = l3 * g1 - l1 * g3, v3 = l1 * g2 - l2 * g1;
    const double u1 = v1 / i1, u2 = v2 / i2, u3 = v3 / i3;
    double push = m * g;
    if constexpr (sliding) {
      const double e1 = l2 * d[5] - l3 * d[4], e2 = l3 * d[3] - l1 * d[5],
                   e3 = l1 * d[4] - l2 * d[3];
      const double dm1 = m * (v1 * u1 + v2 * u2 + v3 * u3);
      push += m * (e1 * w1 + e2 * w2 + e3 * w3 + v1 * y1 + v2 * y2 + v3 * y3 - g * dm1) / (1 + dm1);
    }
    d[0] = y1 - push * u1;
    d[1] = y2 - push * u2;
    d[2] = y3 - push * u3;
  }
};

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// What a precise run found: the number of crossings of an orbit, and (l, y) of its first 10.
struct Reference {
  long crossings = -1;
  std::vector<std::array<double, 2>> points;
};

struct Problem {
  Scene scene;
  Body<double> body;
  std::vector<X> starts;
  double t_end = 0;
  std::vector<Reference> reference;
};

double section(const Body<double>& b, const X& x, double& side) {
  const State<double> s{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
  const Vec<double> n = momentum(b, s);
  side = n[1] * s.gamma[0] - n[0] * s.gamma[1];
  return dot(n, s.gamma) * n[2] - dot(n, n) * s.gamma[2];
}

// What is measured on the way: the same for every method.
struct Tally {
  const Problem& p;
  Levels<double> sizes;
  long crossings = 0, wrong = 0;
  double drift = 0, error = 0;
  Integrals<double> first{};
  std::size_t orbit = 0;
  long of_orbit = 0;
  explicit Tally(const Problem& problem)
      : p(problem), sizes(sizes_on_level(p.body, p.scene.levels<double>())) {}
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
      const auto a = andoyer_of(p.body, state(x), 2);
      const auto& r = p.reference[orbit].points[of_orbit];
      error =
          std::max({error, std::abs(std::remainder(a.l - r[0], 2 * M_PI)), std::abs(a.y - r[1])});
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

// Locates S = 0 in (a, b] given a way to evaluate the orbit there: the Illinois variant of the
// secant.
template <class At> void locate(Tally& t, double a, double b, double sa, double sb, const At& at) {
  X x{};
  double side = 0;
  for (int i = 0; i < 60 && std::abs(b - a) > 1e-15 * (1 + std::abs(b)); ++i) {
    double c = b - sb * (b - a) / (sb - sa);
    at(c, x);
    const double sc = section(t.p.body, x, side);
    if (std::abs(sc) < 1e-15) break;
    if ((sc > 0) != (sb > 0)) {
      a = b;
      sa = sb;
    } else {
      sa /= 2;
    }
    b = c;
    sb = sc;
  }
  if (side > 0) t.cross(x);
}

template <class Stepper, class F>
void dense(Stepper stepper, const F& f, const Problem& p, Tally& t) {
  for (std::size_t i = 0; i < p.starts.size(); ++i) {
    t.begin(i);
    stepper.initialize(p.starts[i], 0.0, 0.01);
    double side = 0, before = -1, last = 0; // the starts are on the section, going down
    X x{};
    while (last < p.t_end) {
      const auto span = stepper.do_step(f);
      double end = span.second;
      x = stepper.current_state();
      if (end > p.t_end) stepper.calc_state(end = p.t_end, x);
      const double s = section(p.body, x, side);
      if (before > 0 && s <= 0)
        locate(t, span.first, end, before, s,
               [&](double c, X& out) { stepper.calc_state(c, out); });
      before = s;
      last = end;
    }
    t.end(x);
  }
}

template <class F> void rkf78(double tolerance, const F& f, const Problem& p, Tally& t) {
  using Error = ode::runge_kutta_fehlberg78<X>;
  auto stepper = ode::make_controlled<Error>(tolerance, tolerance);
  Error plain;
  for (std::size_t i = 0; i < p.starts.size(); ++i) {
    t.begin(i);
    X x = p.starts[i];
    double time = 0, dt = 0.01, side = 0, before = -1;
    while (time < p.t_end) {
      dt = std::min(dt, p.t_end - time);
      const X old = x;
      const double from = time;
      while (stepper.try_step(f, x, time, dt) == ode::fail) {
      }
      const double s = section(p.body, x, side);
      if (before > 0 && s <= 0)
        locate(t, from, time, before, s, [&](double c, X& out) {
          out = old;
          plain.do_step(f, out, from, c - from);
        });
      before = s;
    }
    t.end(x);
  }
}

// ---- SUNDIALS ----

constexpr double off_section = 0.01;

template <class F> struct User {
  const F* f;
  const Body<double>* body;
};

template <class F> int sundials_field(double, N_Vector y, N_Vector d, void* user) {
  X x, out;
  std::copy_n(N_VGetArrayPointer(y), 6, x.begin());
  (*static_cast<User<F>*>(user)->f)(x, out);
  std::copy_n(out.begin(), 6, N_VGetArrayPointer(d));
  return 0;
}
template <class F> int sundials_root(double, N_Vector y, double* g, void* user) {
  X x;
  std::copy_n(N_VGetArrayPointer(y), 6, x.begin());
  double side = 0;
  *g = section(*static_cast<User<F>*>(user)->body, x, side);
  return 0;
}

X state_of(N_Vector y) {
  X x;
  std::copy_n(N_VGetArrayPointer(y), 6, x.begin());
  return x;
}

template <class F> void cvode(double tolerance, const F& f, const Problem& p, Tally& t) {
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
  for (std::size_t i = 0; i < p.starts.size(); ++i) {
    t.begin(i);
    N_Vector y = N_VNew_Serial(6, context);
    std::copy_n(p.starts[i].begin(), 6, N_VGetArrayPointer(y));
    void* mem = CVodeCreate(CV_ADAMS, context);
    User<F> user{&f, &p.body};
    CVodeInit(mem, sundials_field<F>, 0, y);
    CVodeSStolerances(mem, tolerance, tolerance);
    SUNNonlinearSolver solver = SUNNonlinSol_FixedPoint(y, 0, context);
    CVodeSetNonlinearSolver(mem, solver);
    CVodeSetUserData(mem, &user);
    CVodeSetMaxNumSteps(mem, 100000000);
    CVodeSetErrFile(mem, nullptr);
    double time = 0, side = 0;
    // The starts lie on the section: its root finding refuses to begin there.
    CVode(mem, off_section, y, &time, CV_NORMAL);
    CVodeReInit(mem, time, y);
    CVodeRootInit(mem, 1, sundials_root<F>);
    int falling = -1;
    CVodeSetRootDirection(mem, &falling);
    int flag = 0;
    while ((flag = CVode(mem, p.t_end, y, &time, CV_NORMAL)) == CV_ROOT_RETURN) {
      section(p.body, state_of(y), side);
      if (side > 0) t.cross(state_of(y));
    }
    if (flag < 0) t.drift = INFINITY;
    t.end(state_of(y));
    CVodeFree(&mem);
    SUNNonlinSolFree(solver);
    N_VDestroy(y);
  }
  SUNContext_Free(&context);
}

template <class F> void arkode(double tolerance, const F& f, const Problem& p, Tally& t) {
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
  for (std::size_t i = 0; i < p.starts.size(); ++i) {
    t.begin(i);
    N_Vector y = N_VNew_Serial(6, context);
    std::copy_n(p.starts[i].begin(), 6, N_VGetArrayPointer(y));
    void* mem = ERKStepCreate(sundials_field<F>, 0, y, context);
    User<F> user{&f, &p.body};
    ERKStepSStolerances(mem, tolerance, tolerance);
    ERKStepSetOrder(mem, 8);
    ERKStepSetUserData(mem, &user);
    ERKStepSetMaxNumSteps(mem, 100000000);
    ERKStepSetInterpolantDegree(mem, 5);
    ERKStepSetErrFile(mem, nullptr);
    double time = 0, side = 0;
    ERKStepEvolve(mem, off_section, y, &time, ARK_NORMAL);
    ERKStepReInit(mem, sundials_field<F>, time, y);
    ERKStepRootInit(mem, 1, sundials_root<F>);
    int falling = -1;
    ERKStepSetRootDirection(mem, &falling);
    int flag = 0;
    while ((flag = ERKStepEvolve(mem, p.t_end, y, &time, ARK_NORMAL)) == ARK_ROOT_RETURN) {
      section(p.body, state_of(y), side);
      if (side > 0) t.cross(state_of(y));
    }
    if (flag < 0) t.drift = INFINITY;
    t.end(state_of(y));
    ERKStepFree(&mem);
    N_VDestroy(y);
  }
  SUNContext_Free(&context);
}

// ---- ours ----

struct Count : Sink<double> {
  Tally& t;
  explicit Count(Tally& tally) : t(tally) {}
  void crossing(const Crossing<double>&) override { ++t.crossings; }
  void finished(std::size_t, const Finish<double>& f) override {
    const double now[] = {f.drift[0] / t.sizes.energy, f.drift[1] / t.sizes.length,
                          f.drift[2] / t.sizes.casimir};
    t.drift = std::max({t.drift, now[0], now[1], now[2]});
  }
};

void ours(double tolerance, const Problem& p, Tally& t) {
  const Effects effects = p.scene.effects();
  const Model<double> model = model_of(p.body, effects);
  Count count(t);
  Run<double> run;
  run.section = p.scene.section;
  run.t_end = p.t_end;
  run.log2_tolerance = std::log2(tolerance) - safety_bits;
  run.starts = p.starts.front().data();
  run.orbits = p.starts.size();
  run.order = choose_order(effects, model, run.starts, run.orbits, run.log2_tolerance);
  run.sink = &count;
  integrate(effects, model, p.body.sliding, run);
}

using Method = std::function<void(double tolerance, Tally&)>;

template <bool sliding>
std::map<std::string, Method> methods(const Field<sliding>& f, const Problem& p) {
  return {{"odeint-dopri5",
           [&](double e, Tally& t) {
             dense(ode::make_dense_output(e, e, ode::runge_kutta_dopri5<X>()), f, p, t);
           }},
          {"odeint-rkf78", [&](double e, Tally& t) { rkf78(e, f, p, t); }},
          {"odeint-bulirsch-stoer",
           [&](double e, Tally& t) { dense(ode::bulirsch_stoer_dense_out<X>(e, e), f, p, t); }},
          {"cvode-adams", [&](double e, Tally& t) { cvode(e, f, p, t); }},
          {"arkode-erk8", [&](double e, Tally& t) { arkode(e, f, p, t); }}};
}

double seconds_of(const Method& method, double tolerance, Tally& tally) {
  const double begun = cpu_seconds();
  method(tolerance, tally);
  return cpu_seconds() - begun;
}

template <bool sliding> void run_all(const Problem& p, double seconds_each) {
  const Field<sliding> f(p.body);
  for (const auto& [name, method] : methods(f, p))
    for (int digits = 4; digits <= 15; ++digits) {
      double seconds = INFINITY;
      std::string row;
      for (int turn = 0; turn < 3 && (turn == 0 || seconds < 1); ++turn) { // the best of three
        Tally tally(p);
        seconds = std::min(seconds, seconds_of(method, std::pow(10.0, -digits), tally));
        row = tally.row();
      }
      std::printf("%s 1e-%d %.6f %s\n", name.c_str(), digits, seconds, row.c_str());
      std::fflush(stdout);
      if (seconds > seconds_each) break;
    }
}

// The loosest tolerance with which a method stays below the drift; 0 if it does not, within the
// time.
double tolerance_for(const Method& method, const Problem& p, double drift, double seconds) {
  for (int digits = 4; digits <= 15; ++digits) {
    Tally tally(p);
    const double spent = seconds_of(method, std::pow(10.0, -digits), tally);
    if (tally.drift <= drift) return std::pow(10.0, -digits);
    if (spent > seconds) break;
  }
  return 0;
}

template <bool sliding> void ratios(const Problem& p, double seconds) {
  const Field<sliding> f(p.body);
  const Method mine = [&](double e, Tally& t) { ours(e, p, t); };
  std::printf("drift method median least most pairs\n");
  for (const double drift : {1e-6, 1e-9, 1e-12})
    for (const auto& [name, method] : methods(f, p)) {
      const double e = tolerance_for(method, p, drift, seconds),
                   my_e = tolerance_for(mine, p, drift, seconds);
      std::vector<double> seen;
      Tally t(p);
      const double begun = cpu_seconds();
      while (e > 0 && seen.size() < 15 && (seen.size() < 3 || cpu_seconds() - begun < seconds)) {
        const double before = seconds_of(mine, my_e, t), theirs = seconds_of(method, e, t),
                     after = seconds_of(mine, my_e, t);
        seen.push_back(2 * theirs / (before + after));
      }
      std::sort(seen.begin(), seen.end());
      if (seen.empty())
        std::printf("%.0e %s - - - 0\n", drift, name.c_str());
      else
        std::printf("%.0e %s %.3g %.3g %.3g %zu\n", drift, name.c_str(), seen[seen.size() / 2],
                    seen.front(), seen.back(), seen.size());
      std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: kovacic-peers SCENE [REFERENCE] [SECONDS]\n"
                         "       kovacic-peers --ratios SCENE [SECONDS]\n");
    return 2;
  }
  const bool by_turns = std::string(argv[1]) == "--ratios";
  if (by_turns && argc < 3) return 2;
  Problem p;
  p.scene = read_scene(argv[by_turns ? 2 : 1]);
  p.body = p.scene.body<double>();
  p.t_end = p.scene.time ? p.scene.time->as<double>() : 1000;
  for (const Start& s : starts_of(p.scene))
    p.starts.push_back(
        {s.x.omega[0], s.x.omega[1], s.x.omega[2], s.x.gamma[0], s.x.gamma[1], s.x.gamma[2]});
  if (argc > 2 && !by_turns) {
    std::ifstream in(argv[2]);
    for (std::string line; std::getline(in, line);) {
      std::istringstream words(line);
      std::size_t orbit = 0;
      Reference r;
      words >> orbit >> r.crossings;
      for (double l = 0, y = 0; words >> l >> y;)
        r.points.push_back({l, y});
      p.reference.push_back(r);
    }
  }
  const double limit = argc > 3 ? std::atof(argv[3]) : 30;
  if (p.body.sliding)
    by_turns ? ratios<true>(p, limit) : run_all<true>(p, limit);
  else
    by_turns ? ratios<false>(p, limit) : run_all<false>(p, limit);
  return 0;
}
