#pragma once
// Integration of many orbits, lane by lane, with section crossings.
//
// Step   h = min_{k = p-1, p} (epsilon/||x_k||)^(1/k)    [JorbaZou2005] (3-6), per lane; and not so
//        long that the terms x_k h^k outgrow the state, or their rounding drowns epsilon (log2_reach)
// State  x + x_low, two doubles whose sum is the state: the increment of a step is added without rounding away
//        its low half (Kahan, Babuska); the jets start from x.
// Order  fixed for the run: the work per unit of time, p^2/h(p), has a flat minimum near p = -ln(epsilon)/2 that
//        does not depend on the radius of convergence, i.e. not on where the orbit is (choose_order measures it).
//        A bad order costs time, not accuracy.

#include "flow/orbit/section_jets.hpp"
#include "flow/orbit/steps.hpp"

#include <atomic>
#include <cstddef>

namespace kov::flow {

/// The wanted sign changes of S and the sign of C there (section_jets.hpp).
struct SectionRule {
  bool falling = true, rising = false;
  int side = 1;   ///< sign of C
  int axis = 2;   ///< chart axis: L is the component of the momentum along this body axis (0, 1, 2)
  bool on = true; ///< false: no section at all
};

template <class R> struct Crossing {
  std::size_t orbit = 0;
  R t{};
  R x[6]{}; ///< Omega, Gamma in body axes
  bool falling = true;
};

template <class R> struct Finish {
  R x[6]{};   ///< the last state (rounded)
  R low[6]{}; ///< what rounding took away
  R t{};
  R drift[3]{}; ///< largest |H - H_0|, |F1 - F1_0|, |F2 - F2_0| seen at the checks, absolute
  long steps = 0, crossings = 0;
  int tangencies = 0;
  Ended ended = Ended::time;
};

template <class R> struct Sink {
  virtual void crossing(const Crossing<R>&) = 0;
  virtual void finished(std::size_t orbit, const Finish<R>&) = 0;
  virtual ~Sink() = default;
};

template <class R> struct Run {
  double log2_tolerance = -53; ///< of epsilon, relative to |Gamma| = 1 and to max |Omega_i|
  int order = 20;
  R t_end{};
  long max_crossings = -1; ///< -1: no limit
  long max_steps = -1;
  int check_every = 16; ///< steps between two looks at the integrals; 0: only at the end
  SectionRule section;
  const std::atomic<bool>* stop = nullptr;
  const R* starts = nullptr; ///< 6 numbers for each orbit: Omega, Gamma in body axes
  std::size_t orbits = 0;
  Sink<R>* sink = nullptr;
};

inline namespace KOV_ISA {

/// A compiled set of effects for one pack type.
template <class T> struct Kernel {
  void (*jets)(const Model<T>&, const Jet<T>&, int order) = nullptr;
  void (*section)(const Model<T>&, const Jet<T>&, int order, int axis) = nullptr;
};

template <class T> Model<T> widen(const Model<typename Lanes<T>::Real>& c) {
  Model<T> out{};
  out.shift = c.shift;
  const auto all = [](const auto& x) { return Lanes<T>::all(x); };
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      out.inertia[i][k] = all(c.inertia[i][k]);
      out.inverse[i][k] = all(c.inverse[i][k]);
      out.spin[i][k] = all(c.spin[i][k]);
    }
    out.euler[i] = all(c.euler[i]);
    out.lever[i] = all(c.lever[i]);
    out.p[i] = all(c.p[i]);
    out.q[i] = all(c.q[i]);
    out.e[i] = all(c.e[i]);
    out.f[i] = all(c.f[i]);
    out.ae[i] = all(c.ae[i]);
    out.af[i] = all(c.af[i]);
    out.gyro[i] = all(c.gyro[i]);
  }
  out.c_alpha = all(c.c_alpha);
  out.c_beta = all(c.c_beta);
  out.g_alpha = all(c.g_alpha);
  out.g_beta = all(c.g_beta);
  out.m_lambda2 = all(c.m_lambda2);
  out.m_g_lambda = all(c.m_g_lambda);
  return out;
}

// H, F1, F2 in inner axes.  `sliding` as a number, 0 or 1, is in m_lambda2 (see Stepper).
template <class T>
void pack_integrals(const Model<T>& c, bool sliding, const T (&x)[6], T (&out)[3]) {
  const T k1 = along(c.inertia[0], x[0], x[1], x[2]);
  const T k2 = along(c.inertia[1], x[0], x[1], x[2]);
  const T k3 = along(c.inertia[2], x[0], x[1], x[2]);
  T twice = k1 * x[0] + k2 * x[1] + k3 * x[2];
  if (sliding) {
    const T w = c.lever[0] * (x[4] * x[2] - x[5] * x[1]) +
                c.lever[1] * (x[5] * x[0] - x[3] * x[2]) + c.lever[2] * (x[3] * x[1] - x[4] * x[0]);
    add_product(twice, c.m_lambda2, T(w * w));
  }
  const T half = Lanes<T>::all(typename Lanes<T>::Real(1) / typename Lanes<T>::Real(2));
  out[0] = half * twice + c.m_g_lambda * along(c.lever, x[3], x[4], x[5]);
  out[1] = x[3] * x[3] + x[4] * x[4] + x[5] * x[5];
  out[2] = x[3] * (k1 - c.gyro[0]) + x[4] * (k2 - c.gyro[1]) + x[5] * (k3 - c.gyro[2]);
}

template <class T> class Stepper {
public:
  using L = Lanes<T>;
  using Real = typename L::Real;
  using Step = typename L::Step;
  static constexpr int n = L::size;

  /// `storage`: Jet<T>::count * (order + 2) numbers, aligned for T.
  Stepper(const Kernel<T>& kernel, const Model<Real>& model, bool sliding, const Run<Real>& run,
          T* storage)
      : kernel_(kernel), model_(widen<T>(model)), run_(run), sliding_(sliding) {
    for (int i = 0; i < Jet<T>::count; ++i)
      jet_.s[i] = storage + i * (run.order + 2);
    axis_ = (run.section.axis + 3 - model.shift) % 3;
  }

  void integrate() {
    for (int lane = 0; lane < n; ++lane)
      refill(lane);
    while (active_ > 0) {
      if (run_.stop != nullptr && run_.stop->load(std::memory_order_relaxed)) {
        for (int lane = 0; lane < n; ++lane)
          if (busy_[lane]) finish(lane, Ended::stopped);
        return;
      }
      step();
    }
  }

private:
  Kernel<T> kernel_;
  Model<T> model_;
  const Run<Real>& run_;
  bool sliding_;
  int axis_ = 2;
  double log2_reach_ = log2_reach(run_.log2_tolerance, log2_estimate(unit_roundoff<Real>()));
  Jet<T> jet_{};
  T x_[6]{}, low_[6]{}, first_[3]{}, drift_[3]{};
  T t_{}, t_low_{};
  SectionWatch<T> watch_{run_.section.falling, run_.section.rising};
  std::size_t orbit_[n]{};
  bool busy_[n]{};
  Finish<Real> tally_[n]{};
  std::size_t next_ = 0;
  int active_ = 0;

  int inner(int body_axis) const { return (body_axis + 3 - model_.shift) % 3; }

  // Gives the lane its next orbit, or leaves it idle (it goes on with its old state and nobody looks).
  void refill(int lane) {
    if (busy_[lane]) --active_;
    busy_[lane] = next_ < run_.orbits;
    if (!busy_[lane]) {
      if (run_.orbits > 0 && tally_[lane].steps == 0) load(lane, 0);
      return;
    }
    ++active_;
    orbit_[lane] = next_;
    load(lane, next_++);
    tally_[lane] = Finish<Real>{};
  }

  void load(int lane, std::size_t orbit) {
    const Real* start = run_.starts + 6 * orbit;
    for (int i = 0; i < 3; ++i) {
      L::set(x_[inner(i)], lane, start[i]);
      L::set(x_[3 + inner(i)], lane, start[3 + i]);
    }
    for (int i = 0; i < 6; ++i)
      L::set(low_[i], lane, Real(0));
    for (int i = 0; i < 3; ++i)
      L::set(drift_[i], lane, Real(0));
    T now[3];
    pack_integrals(model_, sliding_, x_, now);
    for (int i = 0; i < 3; ++i)
      L::set(first_[i], lane, L::get(now[i], lane));
    L::set(t_, lane, Real(0));
    L::set(t_low_, lane, Real(0));
    watch_.forget(lane);
  }

  void step() {
    for (int i = 0; i < 6; ++i)
      jet_.s[i][0] = x_[i];
    kernel_.jets(model_, jet_, run_.order);
    const T left = (L::all(run_.t_end) - t_) - t_low_;
    const T wanted = step_size();
    const T h = choose(wanted < left, wanted, left);
    if (run_.section.on) look_for_crossings(h);
    advance(h);
    account(h, left);
  }

  // log2 of ||x_k||: Gamma as it is, Omega relative to the state's.
  Step log2_size(int k, const T& per_spin) const {
    T omega{}, gamma{};
    for (int i = 0; i < 3; ++i) {
      omega = larger(omega, absolute(jet_.s[i][k]));
      gamma = larger(gamma, absolute(jet_.s[3 + i][k]));
    }
    return log2_estimate(larger(T(omega * per_spin), gamma));
  }

  T step_size() const {
    T spin = larger(larger(absolute(x_[0]), absolute(x_[1])), absolute(x_[2]));
    spin = L::all(Real(1)) / larger(spin, L::all(Real(1e-100)));
    Step best = log2_reach_ - log2_size(1, spin);
    const auto at_most = [&best](const Step& log_h) { best = log_h < best ? log_h : best; };
    at_most(log2_reach_ - (log2_size(2, spin) + 1.0) * 0.5);
    for (int k = run_.order - 1; k <= run_.order; ++k)
      at_most((run_.log2_tolerance - log2_size(k, spin)) * (1.0 / k));
    return T(exp2_estimate(best));
  }

  void look_for_crossings(const T& h) {
    kernel_.section(model_, jet_, run_.order, axis_);
    watch_.step(jet_.s[Jet<T>::section], run_.order, h, T{},
                [&](int lane, const Real& sign_before) {
                  if (busy_[lane]) look_closer(lane, L::get(h, lane), sign_before);
                });
  }

  void look_closer(int lane, const Real& h, const Real& sign_before) {
    const Real noise =
        L::get(jet_.s[Jet<T>::m_squared][0], lane) * (unit_roundoff<Real>() * Real(16));
    Root<Real> roots[16];
    const int found = watch_.sign_changes_in(
        lane, jet_.s[Jet<T>::section], run_.order, h, sign_before,
        [&](const Real&) { return noise; }, roots, 16, tally_[lane].tangencies);
    for (int i = 0; i < found; ++i)
      land(lane, Real(roots[i].x * h), roots[i].falling);
  }

  Real at(int series, int lane, const Real& dt) const {
    return value_at(jet_.s[series], run_.order, lane, dt);
  }

  // Evaluates the orbit on the section, and reports it if it is on the wanted side.
  void land(int lane, const Real& dt, bool falling) {
    if (run_.max_crossings >= 0 && tally_[lane].crossings >= run_.max_crossings) return;
    const int a = (axis_ + 1) % 3, b = (axis_ + 2) % 3;
    Crossing<Real> c;
    for (int i = 0; i < 3; ++i) {
      c.x[(i + model_.shift) % 3] = at(i, lane, dt);
      c.x[3 + (i + model_.shift) % 3] = at(3 + i, lane, dt);
    }
    const auto vertical = [&](int i) -> const Real& { return c.x[3 + (i + model_.shift) % 3]; };
    const Real side =
        at(Jet<T>::m1 + b, lane, dt) * vertical(a) - at(Jet<T>::m1 + a, lane, dt) * vertical(b);
    if ((side > Real(0)) != (run_.section.side > 0)) return;
    c.orbit = orbit_[lane];
    c.t = L::get(t_, lane) + (L::get(t_low_, lane) + dt);
    c.falling = falling;
    ++tally_[lane].crossings;
    run_.sink->crossing(c);
  }

  void advance(const T& h) {
    T d[6];
    for (int i = 0; i < 6; ++i)
      d[i] = jet_.s[i][run_.order];
    for (int k = run_.order - 1; k >= 1; --k)
      for (int i = 0; i < 6; ++i)
        d[i] = multiply_add(d[i], h, jet_.s[i][k]);
    for (int i = 0; i < 6; ++i)
      add_compensated(x_[i], low_[i], T(d[i] * h));
    add_compensated(t_, t_low_, h);
  }

  // `due`: 1 in the lanes that are looked at, 0 elsewhere.
  void measure_drift(const T& due) {
    T now[3];
    pack_integrals(model_, sliding_, x_, now);
    for (int i = 0; i < 3; ++i)
      drift_[i] = larger(drift_[i], T(due * absolute(T(now[i] - first_[i]))));
  }

  // Bookkeeping after a step: who is finished, who is broken.
  void account(const T& h, const T& left) {
    bool check = false;
    T due{};
    for (int lane = 0; lane < n; ++lane) {
      const long steps = ++tally_[lane].steps;
      if (!busy_[lane] || run_.check_every <= 0 || steps % run_.check_every != 0) continue;
      check = true;
      L::set(due, lane, Real(1));
    }
    if (check) measure_drift(due);
    for (int lane = 0; lane < n; ++lane) {
      if (!busy_[lane]) continue;
      const Finish<Real>& f = tally_[lane];
      if (!(L::get(h, lane) > Real(0)) || !(L::get(x_[3], lane) == L::get(x_[3], lane)))
        finish(lane, Ended::broken);
      else if (L::get(h, lane) == L::get(left, lane))
        finish(lane, Ended::time);
      else if (run_.max_crossings >= 0 && f.crossings >= run_.max_crossings)
        finish(lane, Ended::crossings);
      else if (run_.max_steps >= 0 && f.steps >= run_.max_steps)
        finish(lane, Ended::steps);
    }
  }

  void finish(int lane, Ended why) {
    T due{};
    L::set(due, lane, Real(1));
    measure_drift(due);
    Finish<Real>& f = tally_[lane];
    for (int i = 0; i < 3; ++i) {
      f.x[(i + model_.shift) % 3] = L::get(x_[i], lane);
      f.x[3 + (i + model_.shift) % 3] = L::get(x_[3 + i], lane);
      f.low[(i + model_.shift) % 3] = L::get(low_[i], lane);
      f.low[3 + (i + model_.shift) % 3] = L::get(low_[3 + i], lane);
      f.drift[i] = L::get(drift_[i], lane);
    }
    f.t = L::get(t_, lane);
    f.ended = why;
    run_.sink->finished(orbit_[lane], f);
    refill(lane);
  }
};

} // namespace KOV_ISA
} // namespace kov::flow
