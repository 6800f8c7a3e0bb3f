// kovacic-peers SCENE [REFERENCE] [SECONDS]: the orbits of a scene with other people's integrators,
// for `kovacic bench accuracy`.
// kovacic-peers --ratios SCENE [SECONDS [TIME]]: theirs and ours by turns in one process, so that whatever
// slows the machine slows both: how many times as long they take for the same drift.
//
// Boost.odeint: dopri5 (dense output), rkf78 (controlled), Bulirsch-Stoer (dense output);
// SUNDIALS: CVODE (Adams) and ARKODE (explicit Runge-Kutta, order 8) with their own root finding;
// heyoka (peers_heyoka.cpp; the CMake option KOV_HEYOKA): Taylor series in batches, its own events.
// Each gets the same right-hand side, written out for the effects of the scene and compiled for
// this machine, the same starts, and the same section: sign change of S at the end of a step, then
// the crossing is located (dense output with bisection and secant, or the package's root finder).
// Output, one line for each run:
//   method tolerance seconds crossings wrong drift error10
// seconds: of the processor, the best of three;  wrong: orbits whose number of crossings differs
// from that in the file REFERENCE (lines: orbit crossings l_1 y_1 ... l_10 y_10);  error10: largest
// distance of the first 10 section points of each orbit from those there.

#include "peers.hpp"

#include "flow/scene/section_stage.hpp"
#include "symbol/document.hpp"

#include <boost/numeric/odeint.hpp>

#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <cstdio>
#include <fstream>

namespace kov::peers {
namespace {

namespace ode = boost::numeric::odeint;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

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

void ours(double tolerance, int digits, int lanes, const Problem& p, Tally& t) {
  SystemScene s = p.scene;
  s.tolerance = Quantity((std::to_string(std::llround(tolerance * 1e18)) + "/10^18").c_str());
  s.digits = digits;
  SystemSectionOptions options;
  options.lanes = lanes;
  const SystemSection section = simulate(s, options);
  t.crossings += static_cast<long>(section.points.size());
  t.drift = std::max(t.drift, section.drift);
  t.seconds = section.seconds;
}

// Beside the fastest: in other packs, and in long double.
std::map<std::string, Method> our_variants(const Problem& p) {
  const auto packs = [&p](int digits, int lanes) {
    return [&p, digits, lanes](double e, Tally& t) { ours(e, digits, lanes, p, t); };
  };
  return {{"kovacic-1-lane", packs(0, 1)},
          {"kovacic-4-lanes", packs(0, 4)},
          {"kovacic-long-double", packs(19, 1)}};
}

template <bool sliding>
std::map<std::string, Method> methods(const Field<sliding>& f, const Problem& p) {
  std::map<std::string, Method> all = heyoka_methods(p);
  all.merge(std::map<std::string, Method>{
      {"odeint-dopri5",
       [&](double e, Tally& t) {
         dense(ode::make_dense_output(e, e, ode::runge_kutta_dopri5<X>()), f, p, t);
       }},
      {"odeint-rkf78", [&](double e, Tally& t) { rkf78(e, f, p, t); }},
      {"odeint-bulirsch-stoer",
       [&](double e, Tally& t) { dense(ode::bulirsch_stoer_dense_out<X>(e, e), f, p, t); }},
      {"cvode-adams", [&](double e, Tally& t) { cvode(e, f, p, t); }},
      {"arkode-erk8", [&](double e, Tally& t) { arkode(e, f, p, t); }}});
  return all;
}

double seconds_of(const Method& method, double tolerance, Tally& tally) {
  const double begun = cpu_seconds();
  method(tolerance, tally);
  return tally.seconds < 0 ? cpu_seconds() - begun : tally.seconds;
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

// The loosest tolerance, to a quarter of a digit, with which a method stays below the drift; 0 if
// it does not, within the time.
double tolerance_for(const Method& method, const Problem& p, double drift, double seconds) {
  const auto keeps = [&](int quarters) {
    Tally tally(p);
    const double spent = seconds_of(method, std::pow(10.0, -quarters / 4.0), tally);
    if (spent > seconds) seconds = 0;
    return tally.drift <= drift;
  };
  int q = 16;
  while (q < 64 && !keeps(q)) {
    if (seconds == 0) return 0;
    q += 4;
  }
  if (q == 64) return 0;
  for (int looser = q - 3; looser < q; ++looser)
    if (keeps(looser)) return std::pow(10.0, -looser / 4.0);
  return std::pow(10.0, -q / 4.0);
}

// Median, least and most.
std::string spread(std::vector<double> seen) {
  if (seen.empty()) return "- - - 0";
  std::ranges::sort(seen);
  std::ostringstream out;
  out.precision(3);
  out << seen[seen.size() / 2] << ' ' << seen.front() << ' ' << seen.back() << ' ' << seen.size();
  return out.str();
}

struct Timed {
  Method method;
  double tolerance;
  double operator()(const Problem& p) const {
    Tally t(p);
    return seconds_of(method, tolerance, t);
  }
};

// Ours, theirs, ours: theirs in units of the mean of ours.
std::vector<double> by_turns(const Timed& mine, const Timed& theirs, const Problem& p,
                             double seconds) {
  std::vector<double> seen;
  const double begun = cpu_seconds();
  while (seen.size() < 25 && (seen.size() < 3 || cpu_seconds() - begun < seconds)) {
    const double before = mine(p), middle = theirs(p), after = mine(p);
    seen.push_back(2 * middle / (before + after));
  }
  return seen;
}

void print_rate(const Timed& mine, const Problem& p, double drift) {
  std::vector<double> rates;
  for (int turn = 0; turn < 25; ++turn) {
    Tally t(p);
    const double spent = seconds_of(mine.method, mine.tolerance, t);
    rates.push_back(static_cast<double>(t.crossings) / spent);
  }
  std::printf("# drift %.0e: crossings per second %s\n", drift, spread(rates).c_str());
}

template <bool sliding> void ratios(const Problem& p, double seconds) {
  const Field<sliding> f(p.body);
  std::map<std::string, Method> all = methods(f, p);
  all.merge(our_variants(p));
  const Method best = [&](double e, Tally& t) { ours(e, 0, 0, p, t); };
  std::map<double, Timed> mine; // by drift
  for (const double drift : {1e-6, 1e-9, 1e-12}) {
    mine[drift] = {best, tolerance_for(best, p, drift, seconds)};
    print_rate(mine[drift], p, drift);
  }
  std::printf("drift method median least most turns\n");
  for (auto peer = all.rbegin(); peer != all.rend(); ++peer) // by chance the fastest first
    for (const auto& [drift, ours_then] : mine) {
      const Timed theirs{peer->second, tolerance_for(peer->second, p, drift, seconds)};
      const std::vector<double> seen = theirs.tolerance > 0
                                           ? by_turns(ours_then, theirs, p, seconds / 4)
                                           : std::vector<double>{};
      std::printf("%.0e %s %s\n", drift, peer->first.c_str(), spread(seen).c_str());
      std::fflush(stdout);
    }
}

} // namespace

#ifndef KOV_HEYOKA
std::map<std::string, Method> heyoka_methods(const Problem&) { return {}; }
#endif

} // namespace kov::peers

int main(int argc, char** argv) {
  using namespace kov::peers;
  if (argc < 2) {
    std::fprintf(stderr, "usage: kovacic-peers SCENE [REFERENCE] [SECONDS]\n"
                         "       kovacic-peers --ratios SCENE [SECONDS [TIME]]\n");
    return 2;
  }
  const bool by_turns = std::string(argv[1]) == "--ratios";
  if (by_turns && argc < 3) return 2;
  Problem p;
  p.scene = read_system_scenes(kov::read_document(argv[by_turns ? 2 : 1])).front();
  const Scene& own = p.scene.body->own;
  p.body = body_of(own);
  if (argc > 4 && by_turns) p.scene.time = Quantity(argv[4]);
  p.t_end = p.scene.time ? p.scene.time->as<double>() : 1000;
  const Stage stage(p.scene, nullptr);
  for (const FieldStart& start : stage.starts) { // the axes of these scenes are those of the body
    const Vec<double> m{start.x[0], start.x[1], start.x[2]},
        gamma{start.x[3], start.x[4], start.x[5]}, omega = omega_of(p.body, m, gamma);
    p.starts.push_back({omega[0], omega[1], omega[2], gamma[0], gamma[1], gamma[2]});
  }
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
