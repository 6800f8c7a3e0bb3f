#pragma once
// Integration of many orbits of any field, lane by lane, with section crossings.
//
// Step   h = min_{k = p-1, p} (epsilon/||x_k||)^(1/k)    [JorbaZou2005] (3-6), per lane; and not so
//        long that the terms x_k h^k outgrow the state, or their rounding drowns epsilon (log2_reach)
// State  x + x_low, two doubles whose sum is the state: the increment of a step is added without rounding away
//        its low half (Kahan, Babuska); the series start from x
// Order  fixed for the run: the work per unit of time, p^2/h(p), has a flat minimum near p = -ln(epsilon)/2 that
//        does not depend on the radius of convergence, i.e. not on where the orbit is (choose_order measures it)
//
// |x_k| is taken in units of the scale of each variable, so that the units of the coordinates do not matter.  The
// series of a step are in units tau of time, a power of 2 near the length of the step before: x_k tau^k neither
// overflows nor vanishes however short the steps become.
//
// A variable that has become small beside its scale is measured with its own size, as long as it moves (x -> 0 in a
// sink, or between the saddles of a cycle); one that was 0 at the start, but for rounding, is not.  A tangent vector
// takes part in the choice of the step, in units of its own length.
//
// A step shorter than 2^-20 of the orbit's longest one is the way to a singularity, or an encounter: the orbit ends
// where the state has no digits left for it (`resolves`), at the latest at 2^-300 of the longest step.  It has
// escaped where a variable is 2^80 times as large as its scale.
//
// A square root r of a follows its series, and r^2 = a is restored after each step: what is small keeps its own digits.
// An orbit rests where a step moves it by rounding only, and lies in the section where S is 0 but for rounding; if it
// goes on so for long and no time is given, it ends, too.

#include "flow/field/growth.hpp"
#include "flow/field/machine.hpp"
#include "flow/orbit/steps.hpp"

#include <atomic>
#include <cstddef>

namespace kov::flow {

template <class R> struct FieldFinish {
  R t{}; ///< of the last state that is a number
  long steps = 0, crossings = 0;
  long hidden =
      0; ///< steps in which S was within rounding all the time, between others where it was seen
  int tangencies = 0;
  Indicators indicators = {}; ///< with a tangent vector only
  Ended ended = Ended::time;
  R rest_from{-1};   ///< from then to the end it rests; -1: it does not
  R inside_from{-1}; ///< from then to the end it lies in the section; -1: it does not
};

template <class R> struct FieldSink {
  /// x: all variables on the section.  False: not a crossing that is wanted (`where`).
  virtual bool crossing(std::size_t orbit, const R& t, const R* x, bool rising) = 0;
  /// Before a crossing, if `sizes_at_crossings`: how large the variables are in the step that has it, with what they move by.
  virtual void sizes_there(const R*) {}
  /// x: the state at the start, after every `check_every` steps and at the end, but not deep in a close encounter.
  virtual void look(std::size_t orbit, const R* x) = 0;
  /// The size that rounding may give to the section function where the variables have these sizes,
  /// in a step of this length.
  virtual R section_noise(std::size_t orbit, const R* sizes, const R& step) = 0;
  /// Has the state digits enough for what the field and the integrals are there?  usual: the sizes of the variables in the
  /// longest step of the orbit; deep: this one is shorter by the digits of R.
  virtual bool resolves(std::size_t /*orbit*/, const R* /*start*/, const R* /*x*/,
                        const R* /*usual*/, bool /*deep*/) {
    return true;
  }
  /// Before it is finished: all variables with the tangent vector, which is to be multiplied by e^log_factor.
  virtual void ends_at(std::size_t, const R* /*x*/, double /*log_factor*/) {}
  virtual void finished(std::size_t orbit, const FieldFinish<R>&) = 0;
  virtual ~FieldSink() = default;
};

/// The low part of a variable, beyond its digits, has a place of its own in the storage.
struct LowPart {
  std::uint32_t variable = 0, place = 0;
};

/// A field and its section for the machine, with series of one order; registers 0 ... variables - 1 are the variables x, then
/// come the tangent vector v (as many, or none) and the numbers without a rational value.
template <class R> struct FieldTapes {
  Tape<R> field, section;
  /// For the order that the field's nodes do not reach: the section, and the variables that follow a rule.
  Tape<R> last, followers;
  Tape<R> section_at; ///< its value at a point, in registers of its own
  /// Places of the variables (x and v) that have a derivative, and of it.
  const std::uint32_t *moving = nullptr, *derivatives = nullptr;
  std::size_t moving_count = 0;
  const LowPart* low_parts = nullptr;
  std::size_t low_parts_count = 0;
  std::uint32_t section_place = 0, section_at_place = 0;
  bool curved = false; ///< the section is not a linear function of the variables
  std::size_t coordinates = 0, variables = 0, tangent = 0, values = 0;
  std::size_t places = 0, point_registers = 0; ///< of the storage
};

template <class R> struct FieldRun {
  double log2_tolerance = -53;
  int order = 20;
  double log2_shorter = 0; ///< every step is shorter by this power of 2 than the tolerance asks for
  R t_end{};
  long max_crossings = -1, max_steps = -1; ///< -1: no limit
  bool idle_ends = false; ///< an orbit ends that rests, or lies in the section, for long
  int check_every = 16;
  bool sizes_at_crossings = false;
  bool native =
      true; ///< with code of the processor (machine_code.hpp); the results are the same without
  bool section = true, falling = false, rising = true;
  const R* per_scale = nullptr; ///< 1/scale of every variable
  /// Angles that are kept within a turn: their places; and a turn, as a sum of three numbers with short first ones.
  const std::uint32_t* turning = nullptr;
  std::size_t turning_count = 0;
  const R* turn = nullptr;
  /// For each orbit: the size of the section.
  const R* section_sizes = nullptr;
  const R* values = nullptr; ///< of the numbers
  const R* orbit_values =
      nullptr; ///< the same for each orbit, one after the other; null: all have `values`
  const R* starts = nullptr; ///< variables + tangent for each orbit
  std::size_t orbits = 0;
  const std::atomic<bool>* stop = nullptr;
  FieldSink<R>* sink = nullptr;
};

inline namespace KOV_ISA {

inline constexpr std::size_t most_variables = 64; ///< with the tangent vector

/// How much smaller than the scales an orbit begins: the power of 2 at or above the largest |x_i|/scale_i, at most 1.
/// 1 at x = 0, which says nothing of the motion.
template <class R> double own_unit(const R* x, const R* per_scale, std::size_t variables) {
  double most = 0;
  for (std::size_t i = 0; i < variables; ++i) {
    const auto size = std::abs(static_cast<double>(R(x[i] * per_scale[i])));
    most = most < size ? size : most;
  }
  if (!(most > 0x1p-200)) return most > 0 ? 0x1p-200 : 1;
  return most < 1 ? std::exp2(std::ceil(std::log2(most))) : 1;
}

/// 1/s, or up to twice as much: of a double only the exponent is turned round, which costs no division.
template <class T> inline T about_inverse(const T& s) {
  if constexpr (!std::is_same_v<typename Lanes<T>::Real, double>) {
    return T(Lanes<T>::all(typename Lanes<T>::Real(1)) / s);
  } else {
    typename Lanes<T>::Bits bits;
    std::memcpy(&bits, &s, sizeof s);
    bits = (2046LL << 52) - (bits & 0x7ff0000000000000LL);
    T inverse;
    std::memcpy(&inverse, &bits, sizeof s);
    return inverse;
  }
}

template <class T> class FieldStepper {
public:
  using L = Lanes<T>;
  using Real = typename L::Real;
  using Step = typename L::Step;
  static constexpr int n = L::size, most_halvings = 12;

  /// How many T the storage needs.
  static std::size_t storage_size(const FieldTapes<Real>& tapes) {
    return tapes.places + tapes.point_registers;
  }

  /// `storage`: aligned for T and zero; the places of the tapes are for this order.
  FieldStepper(const FieldTapes<Real>& tapes, const FieldRun<Real>& run, T* storage)
      : tapes_(tapes), run_(run), s_(storage), points_(storage + tapes.places),
        stride_(run.order + 1), total_(static_cast<int>(tapes.variables + tapes.tangent)),
        variables_(static_cast<int>(tapes.variables)) {
    for (std::size_t i = 0; i < tapes_.values; ++i) {
      *series(total_ + static_cast<int>(i)) = L::all(run_.values[i]);
      points_[tapes_.variables + i] = L::all(run_.values[i]);
    }
    for (int k = 0; k < run_.order; ++k)
      reciprocals_[k] = Real(1) / Real(k + 1);
    run_once(tapes_.field, s_);
    run_once(tapes_.section, s_);
    run_once(tapes_.section_at, points_);
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
  T* series(int i) const { return s_ + static_cast<std::ptrdiff_t>(i) * stride_; }

  // Gives the lane its next orbit, or leaves it idle (it goes on with its old state and nobody looks).
  void refill(int lane) {
    if (busy_[lane]) --active_;
    busy_[lane] = next_ < run_.orbits;
    if (!busy_[lane]) {
      if (run_.orbits > 0) load(lane, 0);
      return;
    }
    ++active_;
    orbit_[lane] = next_;
    load(lane, next_++);
    look(lane);
  }

  void load(int lane, std::size_t orbit) {
    const Real* start = run_.starts + static_cast<std::size_t>(total_) * orbit;
    for (int i = 0; i < total_; ++i) {
      L::set(x_[i], lane, start[i]);
      L::set(low_[i], lane, Real(0));
    }
    const Real unit(own_unit(start, run_.per_scale, tapes_.variables));
    for (int i = 0; i < variables_; ++i) {
      const Real scale = unit / run_.per_scale[i];
      L::set(scale_[i], lane, scale);
      L::set(per_start_[i], lane, Real(Real(1) / scale));
      L::set(least_[i], lane, scale);
      L::set(before_x_[i], lane, Real(0));
    }
    if (run_.orbit_values != nullptr) load_values(lane, run_.orbit_values + tapes_.values * orbit);
    if (run_.section) L::set(section_size_, lane, run_.section_sizes[orbit]);
    L::set(t_, lane, Real(0));
    L::set(t_low_, lane, Real(0));
    L::set(longest_, lane, Real(0));
    L::set(moved_until_, lane, Real(0));
    quiet_[lane] = Quiet{};
    Lanes<Step>::set(log2_tau_, lane, 0.0);
    fresh_ = true;
    watch_.forget(lane);
    tally_[lane] = FieldFinish<Real>{};
    if (tapes_.tangent > 0) {
      log_scale_[lane] = 0;
      growth_[lane].begin(log_norm(lane));
    }
  }

  // Loads numbers; what depends on them alone is computed again, in all lanes.
  void load_values(int lane, const Real* values) {
    for (std::size_t i = 0; i < tapes_.values; ++i) {
      L::set(*series(total_ + static_cast<int>(i)), lane, values[i]);
      L::set(points_[tapes_.variables + i], lane, values[i]);
    }
    run_once(tapes_.field, s_);
    run_once(tapes_.section, s_);
    run_once(tapes_.section_at, points_);
  }

  void step() {
    if (fresh_) set_first_units();
    tau_ = T(exp2_estimate(log2_tau_));
    jets(run_.order);
    measure();
    if (run_.section) section_series();
    const T left = (L::all(run_.t_end) - t_) - t_low_;
    const Step log2_wanted = log2_step() - run_.log2_shorter;
    const T wanted = T(exp2_estimate(log2_wanted)) * tau_;
    T h = choose(wanted < left, wanted, left);
    if (run_.section && tapes_.curved) h = followed(h);
    const T part = h / tau_;
    if (run_.section) look_for_crossings(part);
    T motion{};
    for (int i = 0; i < variables_; ++i) {
      motion = larger(motion, T(absolute(series(i)[1]) * per_start_[i]));
      before_x_[i] = absolute(x_[i]);
    }
    const T rests = L::all(unit_roundoff<Real>() * Real(64));
    look_at_roots();
    for (int i = 0; i < total_; i += 4)
      add_increments(i, total_ - i, part);
    restore_roots();
    for (std::size_t i = 0; i < run_.turning_count; ++i)
      turn_back(run_.turning[i]);
    log2_tau_ =
        within(log2_tau_ + ((log2_wanted + 6755399441055744.0) - 6755399441055744.0)); // rounded
    before_ = t_;
    add_compensated(t_, t_low_, h);
    moved_until_ = choose(motion * T(exp2_estimate(log2_wanted)) > rests, t_, moved_until_);
    if (tapes_.tangent > 0) follow_growth(h);
    account(h, left);
  }

  // Adds the increments of up to four variables side by side: each term of a sum waits for the one before.
  void add_increments(int first, int most, const T& h) {
    return most == 1   ? add_increments<1>(first, h)
           : most == 2 ? add_increments<2>(first, h)
           : most == 3 ? add_increments<3>(first, h)
                       : add_increments<4>(first, h);
  }
  template <int n_together> void add_increments(int first, const T& h) {
    const T* x[n_together];
    T sum[n_together];
    for (int m = 0; m < n_together; ++m) {
      x[m] = series(first + m);
      sum[m] = x[m][run_.order];
    }
    for (int k = run_.order - 1; k >= 1; --k)
      for (int m = 0; m < n_together; ++m)
        sum[m] = multiply_add(sum[m], h, x[m][k]);
    for (int m = 0; m < n_together; ++m)
      add_compensated(x_[first + m], low_[first + m], T(sum[m] * h));
  }

  void turn_back(std::uint32_t angle) {
    T by[3]{};
    bool any = false;
    for (int lane = 0; lane < n; ++lane) {
      const double turns =
          std::round(static_cast<double>(L::get(x_[angle], lane)) / 6.283185307179586);
      if (turns == 0 || !(std::abs(turns) < 0x1p20)) continue;
      any = true;
      for (int k = 0; k < 3; ++k)
        L::set(by[k], lane, Real(run_.turn[k] * Real(-turns)));
    }
    for (int k = 0; k < 3 && any; ++k)
      add_compensated(x_[angle], low_[angle], by[k]);
  }

  // The part that r^2 lacks of a at the start of a step, and then r at its end.
  template <class F> void for_each_root(const F& f) const {
    for (const Instruction* i = tapes_.followers.each; i != tapes_.followers.each_end; ++i)
      if (i->op == Instruction::Op::root)
        f(static_cast<std::ptrdiff_t>(i->out[0]) / stride_, s_[i->out[0]], s_[i->a[0]]);
  }
  void look_at_roots() {
    for_each_root([this](std::ptrdiff_t place, const T& r, T missing) {
      sub_product(missing, r, r);
      sub_product(missing, T(r + r), low_[place]);
      missing_[place] = missing;
    });
  }
  void restore_roots() {
    for_each_root([this](std::ptrdiff_t place, const T&, const T&) {
      const T x = x_[place], change = missing_[place] / (x + x);
      const T small = absolute(x) * L::all(Real(0x1p-8));
      add_compensated(x_[place], low_[place], choose(absolute(change) < small, change, T{}));
    });
  }

  // Before the first step of an orbit that begins fast no step says what the unit of time is: its first derivatives do.
  void set_first_units() {
    fresh_ = false;
    tau_ = L::all(Real(1));
    jets(2);
    measure();
    const Step first = log2_size(1), second = log2_size(2) * 0.5;
    const Step rate = within(first > second ? first : second);
    for (int lane = 0; lane < n; ++lane)
      if (tally_[lane].steps == 0 && Lanes<Step>::get(rate, lane) > 8)
        Lanes<Step>::set(log2_tau_, lane, -std::round(Lanes<Step>::get(rate, lane)));
  }

  void jets(int order) {
    for (int i = 0; i < total_; ++i)
      *series(i) = x_[i];
    for (std::size_t i = 0; i < tapes_.low_parts_count; ++i)
      s_[tapes_.low_parts[i].place] = low_[tapes_.low_parts[i].variable];
    if (tapes_.field.code != nullptr)
      run_orders(tapes_.field, 0, order);
    else
      for (int k = 0; k < order; ++k) {
        run_order(tapes_.field, s_, k);
        const T rate = tau_ * L::all(reciprocals_[k]);
        for (std::size_t m = 0; m < tapes_.moving_count; ++m)
          s_[tapes_.moving[m] + static_cast<std::uint32_t>(k) + 1] =
              s_[tapes_.derivatives[m] + static_cast<std::uint32_t>(k)] * rate;
      }
    run_orders(tapes_.followers, order, order + 1);
  }

  void run_orders(const Tape<Real>& tape, int from, int to) {
    if (tape.each == tape.each_end) return;
    if (tape.code != nullptr) return tape.code(s_, tape.numbers, &tau_, reciprocals_, to);
    for (int k = from; k < to; ++k)
      run_order(tape, s_, k);
  }

  // The sizes of the variables and what they are measured with.  least_: the scale until the variable is awake.
  void measure() {
    const T spare = L::all(Real(0x1p10));
    for (int i = 0; i < variables_; ++i) {
      const T* x = series(i);
      const T now = larger(absolute(x[0]), before_x_[i]);
      size_[i] = larger(larger(now, larger(absolute(x[1]), absolute(x[2]))), least_[i]);
      per_scale_[i] = about_inverse(T(larger(now, smaller(scale_[i], T(spare * size_[i])))));
    }
    if (tapes_.tangent == 0) return;
    T length = L::all(Real(1e-300));
    for (int i = 0; i < variables_; ++i)
      length = larger(length, T(absolute(x_[variables_ + i]) * per_start_[i]));
    for (int i = 0; i < variables_; ++i)
      per_scale_[variables_ + i] = per_start_[i] / length;
  }

  void section_series() {
    run_orders(tapes_.section, 0, run_.order);
    run_orders(tapes_.last, run_.order, run_.order + 1);
  }

  // The series of a section that is no linear function may end before the function does (or the radius of
  // convergence may be its own): the step is halved until it has the value of the function at its end.
  T followed(T h) {
    const T* s = s_ + tapes_.section_place;
    for (int i = 0; i < most_halvings; ++i) {
      const T part = h / tau_, one = L::all(Real(1)), zero{};
      for (int j = 0; j < variables_; ++j)
        points_[j] = x_[j] + (low_[j] + increment(series(j), run_.order, part));
      run_order(tapes_.section_at, points_, 0);
      const T value = points_[tapes_.section_at_place];
      const T apart = absolute(T(s[0] + increment(s, run_.order, part) - value));
      const T bound = larger(absolute(value), section_size_) * section_error_;
      const T too_far = choose(apart > bound, one, zero);
      if (!any_busy(too_far)) break;
      h = choose(too_far > zero, T(h * L::all(Real(0.5))), h);
    }
    return h;
  }

  [[nodiscard]] bool any_busy(const T& flags) const {
    for (int lane = 0; lane < n; ++lane)
      if (busy_[lane] && !(L::get(flags, lane) == Real(0))) return true;
    return false;
  }

  // log2 of ||x_k||, with the tangent vector
  Step log2_size(int k) const {
    T most{};
    for (int i = 0; i < total_; ++i)
      most = larger(most, T(absolute(series(i)[k]) * per_scale_[i]));
    return log2_estimate(larger(most, L::all(Real(1e-300))));
  }

  // The step within its bounds, as an exponent.
  static Step within(Step x) {
    const Step zero{};
    x = x < zero - 900.0 ? zero - 900.0 : x;
    return x > zero + 900.0 ? zero + 900.0 : x;
  }

  // log2 of the length of the step, in units of tau
  Step log2_step() const {
    Step best = log2_reach_ - log2_size(1);
    const auto at_most = [&best](const Step& log_h) { best = log_h < best ? log_h : best; };
    at_most(log2_reach_ - (log2_size(2) + 1.0) * 0.5);
    for (int k = run_.order - 1; k <= run_.order; ++k)
      at_most((run_.log2_tolerance - log2_size(k)) * (1.0 / k));
    if (run_.section && tapes_.curved)
      for (int k = run_.order - 1; k <= run_.order; ++k)
        at_most((run_.log2_tolerance - log2_section_size(k)) * (1.0 / k));
    for (int lane = 0; lane < n; ++lane)
      if (is_bold(lane, best)) {
        be_careful(best);
        break;
      }
    return best;
  }

  // Nothing is known yet, or the step is twice as long as the one before.
  bool is_bold(int lane, const Step& log_h) const {
    return tally_[lane].steps == 0 || Lanes<Step>::get(log_h, lane) > 1;
  }

  void be_careful(Step& log_h) const {
    const Step careful = log2_careful_step();
    for (int lane = 0; lane < n; ++lane)
      if (const double most = Lanes<Step>::get(careful, lane);
          is_bold(lane, log_h) && Lanes<Step>::get(log_h, lane) > most)
        Lanes<Step>::set(log_h, lane, most);
  }

  // By a symmetry the last two may be 0 (x'' = -x^3 at 0 has every fourth one): the second half says ||x_k|| <= rate^k.
  Step log2_careful_step() const {
    Step rate = Step{} - 2000.0;
    for (int k = run_.order / 2; k <= run_.order; ++k) {
      const Step one = log2_size(k) * (1.0 / k);
      rate = one > rate ? one : rate;
    }
    return Step{} + run_.log2_tolerance / run_.order - rate;
  }

  Step log2_section_size(int k) const {
    const T* s = s_ + tapes_.section_place;
    const T scale = larger(absolute(s[0]), section_size_);
    return log2_estimate(larger(T(absolute(s[k]) / scale), L::all(Real(1e-300))));
  }

  // h: in units of tau
  void look_for_crossings(const T& h) {
    const T small = section_size_ * L::all(Real(0x1p-16)); // as in noise
    watch_.step(s_ + tapes_.section_place, run_.order, h, small,
                [&](int lane, const Real& sign_before) {
                  if (busy_[lane]) look_closer(lane, L::get(h, lane), sign_before);
                });
  }

  void look_closer(int lane, const Real& h, const Real& sign_before) {
    bool hidden = false;
    const int found = watch_.sign_changes_in(
        lane, s_ + tapes_.section_place, run_.order, h, sign_before,
        [&](const Real& size) { return noise(lane, size); }, roots_, max_degree,
        tally_[lane].tangencies, &hidden,
        1 + static_cast<double>(tally_[lane].steps) / 16); // errors add up
    if (hidden && quiet_[lane].seen >= 0) ++quiet_[lane].hidden;
    for (int i = 0; i < found; ++i)
      land(lane, Real(roots_[i].x * h), !roots_[i].falling);
  }

  // The size that rounding may give to S, in a step in which its terms have this size.
  Real noise(int lane, const Real& size) {
    const Real whole = L::get(section_size_, lane);
    const Real of_all_terms = whole * (unit_roundoff<Real>() * Real(16));
    Quiet& q = quiet_[lane];
    if (!(size < whole * Real(0x1p-16))) {
      seen_well(lane);
      return of_all_terms;
    }
    Real sizes[most_variables];
    get_sizes(lane, sizes);
    q.noise = run_.sink->section_noise(orbit_[lane], sizes, L::get(tau_, lane));
    if (size > q.noise * Real(0x1p10)) {
      seen_well(lane);
    } else if (size > q.noise) {
      q.from = Real(-1);
    } else if (q.from < Real(0)) {
      q.from = L::get(t_, lane);
      q.step = tally_[lane].steps;
    }
    // far above the terms that were seen: those of a product with many zeros, which cancel
    return of_all_terms * Real(16) < q.noise ? of_all_terms : q.noise;
  }

  // If S has come back, nobody knows what it did meanwhile.
  void seen_well(int lane) {
    Quiet& q = quiet_[lane];
    q.from = Real(-1);
    q.seen = tally_[lane].steps;
    tally_[lane].hidden += q.hidden;
    q.hidden = 0;
  }

  void get_sizes(int lane, Real* sizes) const {
    for (int i = 0; i < variables_; ++i)
      sizes[i] = L::get(size_[i], lane);
  }

  void land(int lane, const Real& dt, bool rising) {
    if (run_.max_crossings >= 0 && tally_[lane].crossings >= run_.max_crossings) return;
    Real x[most_variables];
    if (run_.sizes_at_crossings) {
      get_sizes(lane, x);
      run_.sink->sizes_there(x);
    }
    for (int i = 0; i < variables_; ++i)
      x[i] = value_at(series(i), run_.order, lane, dt);
    const Real t = L::get(t_, lane) + (L::get(t_low_, lane) + dt * L::get(tau_, lane));
    if (!run_.sink->crossing(orbit_[lane], t, x, rising)) return;
    ++tally_[lane].crossings;
    quiet_[lane].crossed = tally_[lane].steps;
  }

  void look(int lane) {
    Real x[most_variables];
    for (int i = 0; i < variables_; ++i) {
      x[i] = L::get(x_[i], lane);
      const Real scale = L::get(scale_[i], lane),
                 size = x[i] < Real(0) ? Real(Real(0) - x[i]) : x[i];
      if (size > scale * Real(0x1p-40)) // awake
        L::set(least_[i], lane, Real(scale * Real(0x1p-400) + Real(1e-270)));
    }
    run_.sink->look(orbit_[lane], x);
    Quiet& q = quiet_[lane];
    const bool rests = L::get(moved_until_, lane) < L::get(t_, lane);
    if (!rests) q.rest_step = -1;
    if (rests && q.rest_step < 0) q.rest_step = tally_[lane].steps;
  }

  // Nothing has happened for long, and nothing will.
  bool is_idle(int lane) const {
    const Quiet& q = quiet_[lane];
    const long steps = tally_[lane].steps, wait = steps / 4 > idle_steps ? steps / 4 : idle_steps;
    const auto since = [&](bool holds, long step) {
      return holds && steps - (step > q.crossed ? step : q.crossed) > wait;
    };
    return since(q.rest_step >= 0, q.rest_step) || since(is_inside(lane), q.step);
  }

  double log_norm(int lane) const {
    double square = 0;
    for (std::size_t i = 0; i < tapes_.coordinates; ++i) {
      const auto v =
          static_cast<double>(Real(L::get(x_[tapes_.variables + i], lane) * run_.per_scale[i]));
      square += v * v;
    }
    return 0.5 * std::log(square) + log_scale_[lane];
  }

  void follow_growth(const T& h) {
    for (int lane = 0; lane < n; ++lane) {
      if (!busy_[lane]) continue;
      const double log_v = log_norm(lane);
      growth_[lane].step(static_cast<double>(L::get(h, lane)), log_v);
      const double above = log_v - log_scale_[lane];
      if (above < 40 && above > -40) continue;
      const Real factor = Real(1) / Real(above > 0 ? 0x1p50 : 0x1p-50);
      log_scale_[lane] += (above > 0 ? 50 : -50) * 0.6931471805599453;
      for (int i = variables_; i < total_; ++i) {
        L::set(x_[i], lane, Real(L::get(x_[i], lane) * factor));
        L::set(low_[i], lane, Real(L::get(low_[i], lane) * factor));
      }
    }
  }

  // Bookkeeping after a step: who is finished, who is broken.
  void account(const T& h, const T& left) {
    T finite{};
    const T close = longest_ * L::all(Real(0x1p-20));
    for (int i = 0; i < variables_; ++i)
      add_product(finite, x_[i], T{}); // 0 only if all are numbers
    for (int lane = 0; lane < n; ++lane)
      if (L::get(longest_, lane) < L::get(h, lane)) note_usual(lane);
    longest_ = larger(longest_, h);
    for (int lane = 0; lane < n; ++lane) {
      const long steps = ++tally_[lane].steps;
      if (!busy_[lane] || run_.check_every <= 0 || steps % run_.check_every != 0) continue;
      // what the integrals are deep in a close encounter is seen when it is over
      if (!(L::get(h, lane) < L::get(close, lane))) look(lane);
    }
    for (int lane = 0; lane < n; ++lane) {
      if (!busy_[lane]) continue;
      const FieldFinish<Real>& f = tally_[lane];
      const Real step = L::get(h, lane);
      if (!(step > Real(0)) || !(L::get(finite, lane) == Real(0)))
        finish(lane, Ended::broken);
      else if (step == L::get(left, lane))
        finish(lane, Ended::time);
      else if (step < L::get(close, lane) && is_lost(lane, step))
        finish(lane, Ended::singular);
      else if (run_.idle_ends && f.steps % 16 == 0 &&
               !(step < L::get(longest_, lane) * Real(0x1p-20)) && is_far(lane))
        finish(lane, Ended::escaped);
      else if (run_.idle_ends && f.steps % 64 == 0 && is_idle(lane))
        finish(lane, Ended::idle);
      else if (run_.max_crossings >= 0 && f.crossings >= run_.max_crossings)
        finish(lane, Ended::crossings);
      else if (run_.max_steps >= 0 && f.steps >= run_.max_steps)
        finish(lane, Ended::steps);
    }
  }

  // The sizes in the longest step so far.
  void note_usual(int lane) {
    for (int i = 0; i < variables_; ++i) {
      const T size = larger(absolute(series(i)[0]), absolute(series(i)[1]));
      L::set(usual_[i], lane, L::get(size, lane));
    }
  }

  bool is_lost(int lane, const Real& step) const {
    if (step < L::get(longest_, lane) * Real(0x1p-300)) return true;
    Real x[most_variables], usual[most_variables];
    for (int i = 0; i < variables_; ++i) {
      x[i] = L::get(x_[i], lane);
      usual[i] = L::get(usual_[i], lane);
    }
    const Real* start = run_.starts + static_cast<std::size_t>(total_) * orbit_[lane];
    const bool deep = step < L::get(longest_, lane) * (unit_roundoff<Real>() * Real(8));
    return !run_.sink->resolves(orbit_[lane], start, x, usual, deep);
  }

  bool is_far(int lane) const {
    for (int i = 0; i < variables_; ++i) {
      const Real size = L::get(x_[i], lane) * run_.per_scale[i];
      if (size > Real(0x1p80) || size < Real(-0x1p80)) return true;
    }
    return false;
  }

  // S may have become large without a sign change: nobody has looked closer then.
  bool is_inside(int lane) const {
    const Quiet& q = quiet_[lane];
    const Real value = run_.section ? L::get(s_[tapes_.section_place], lane) : Real(0);
    return !(q.from < Real(0)) && !(value > q.noise) && !(Real(0) - value > q.noise);
  }

  void finish(int lane, Ended why) {
    if (why != Ended::singular && why != Ended::broken) look(lane);
    FieldFinish<Real>& f = tally_[lane];
    const bool rests = L::get(moved_until_, lane) < L::get(t_, lane);
    if (rests) f.rest_from = L::get(moved_until_, lane);
    if (rests && run_.idle_ends && why == Ended::time) why = Ended::idle; // in one step
    f.t = L::get(why == Ended::broken || why == Ended::idle ? before_ : t_, lane);
    f.ended = why;
    if (is_inside(lane)) f.inside_from = quiet_[lane].from;
    if (tapes_.tangent > 0) {
      f.indicators = growth_[lane].indicators();
      Real x[most_variables];
      for (int i = 0; i < total_; ++i)
        x[i] = L::get(x_[i], lane);
      run_.sink->ends_at(orbit_[lane], x, log_scale_[lane]);
    }
    run_.sink->finished(orbit_[lane], f);
    refill(lane);
  }

  const FieldTapes<Real>& tapes_;
  const FieldRun<Real>& run_;
  T *s_, *points_;
  std::ptrdiff_t stride_;
  int total_, variables_;
  double log2_reach_ = log2_reach(run_.log2_tolerance, log2_estimate(unit_roundoff<Real>()));
  // what the series of the section may miss of its value
  T section_error_ = T(exp2_estimate(Step{} + (run_.log2_tolerance + 4.0))) +
                     L::all(unit_roundoff<Real>() * Real(64));
  T x_[most_variables]{}, low_[most_variables]{}, per_scale_[most_variables]{}, section_size_{};
  /// For each variable: the scale at the start and 1 over it, the size in the last step, in this one, the least one.
  T scale_[most_variables]{}, per_start_[most_variables]{}, before_x_[most_variables]{},
      size_[most_variables]{}, least_[most_variables]{}, missing_[most_variables]{},
      usual_[most_variables]{}; ///< usual: the size in the longest step
  T t_{}, t_low_{}, before_{}, longest_{}, tau_{}, moved_until_{};
  Real reciprocals_[max_degree + 1]{}; ///< 1, 1/2, 1/3, ...
  Step log2_tau_{};
  bool fresh_ = true; ///< an orbit has just begun
  SectionWatch<T> watch_{run_.falling, run_.rising};
  struct Quiet {
    Real from{-1}, noise{};        ///< S is within noise since then; -1: it is not
    long step = 0, rest_step = -1; ///< when that began, and rest
    long crossed = 0;              ///< the step of the last crossing
    long hidden = 0, seen = -1;    ///< steps within noise since S was seen well; when that was
  };
  static constexpr long idle_steps = 2000;
  Quiet quiet_[n]{};
  std::size_t orbit_[n]{};
  bool busy_[n]{};
  FieldFinish<Real> tally_[n]{};
  Root<Real> roots_[max_degree]; ///< in one lane and step: a polynomial has no more
  Growth growth_[n]{};
  double log_scale_[n]{};
  std::size_t next_ = 0;
  int active_ = 0;
};

} // namespace KOV_ISA
} // namespace kov::flow
