// Krawczyk's test for a fixed point of the section map, with enclosures all the way; see
// fixed_points.hpp.

#include "flow/scene/own_units.hpp"
#include "flow/section/fixed_points.hpp"
#include "flow/section/section_map.hpp"

#include <algorithm>
#include <cmath>

namespace kov::flow {
namespace {

using DualBall = Dual<Enclosure>;

// Why a proof did not succeed; never leaves this file.
template <class F>
State<DualBall> each(const State<DualBall>& a, const State<DualBall>& b, const F& f) {
  State<DualBall> r;
  for (int i = 0; i < 3; ++i) {
    r.omega[i] = f(a.omega[i], b.omega[i]);
    r.gamma[i] = f(a.gamma[i], b.gamma[i]);
  }
  return r;
}

// An upper bound of |x|.
double magnitude(const Enclosure& x) {
  return (std::abs(static_cast<double>(x)) + x.radius()) * (1 + 1e-15);
}

double magnitude(const State<DualBall>& x) {
  double most = 0;
  for (int i = 0; i < 3; ++i)
    for (const DualBall* c : {&x.omega[i], &x.gamma[i]})
      most = std::max({most, magnitude(c->v), magnitude(c->d[0]), magnitude(c->d[1])});
  return most;
}

class ProvedMap {
public:
  ProvedMap(const Scene& s, const std::atomic<bool>* stop)
      : stop_(stop), rule_(s.section), plain_(s.body<Enclosure>()),
        body_(dual_body(plain_)), levels_{DualBall(s.energy.as<Enclosure>()),
                                          DualBall(s.length.as<Enclosure>()),
                                          DualBall(s.casimir.as<Enclosure>())},
        jet_(body_, s.effects(), order_), box_jet_(body_, s.effects(), order_ + 1) {}

  /// P and DP over the box (l, y); G near `size`.
  SectionImage<Enclosure> operator()(const Enclosure& l, const Enclosure& y, double size) {
    start_size_ = enclose_size(l, y, size);
    about_ = l.middle();
    State<DualBall> x = lifted(body_, levels_, rule_, l, y, start_size_);
    Enclosure time(0);
    bool leaving = true; // the section, on which the orbit starts
    double h = 0.1;
    for (int step = 0; step < max_steps_of_a_return; ++step) {
      if (stop_ != nullptr && stop_->load()) throw NotProved::no_time;
      jet_.expand(x, order_);
      Verdict v = Verdict::retry;
      State<DualBall> end;
      while (v == Verdict::retry) {
        end = advance(h);
        v = look(x, end, leaving);
        if (v != Verdict::retry) break;
        if (h < 1e-6) throw NotProved::end_of_step;
        h *= 0.61803;
      }
      if (v == Verdict::lands) return land(h, time);
      x = end;
      time += Enclosure(h);
      h *= room_;
    }
    throw NotProved::no_return;
  }

private:
  const std::atomic<bool>* stop_;
  enum class Verdict : unsigned char { goes_on, lands, retry };
  // A step's remainder is kept below 2^(-5/8 bits): the other bits are for the growth of the
  // enclosures.
  double tolerance_ = std::exp2(-0.625 * static_cast<double>(Enclosure::bits()));
  int order_ = static_cast<int>(Enclosure::bits()) / 5 + 4;
  SectionRule rule_;
  Body<Enclosure> plain_;
  Body<DualBall> body_;
  Levels<DualBall> levels_;
  VariationalJet<Enclosure> jet_, box_jet_;
  Enclosure start_size_; // G
  Enclosure about_;      // l
  State<DualBall> box_;  // contains the orbit during the step
  State<DualBall> last_; // coefficient order + 1 over the box
  double room_ = 1;      // how much longer than this step the next one may be

  // Interval Newton for H(l, y, G) = h.
  Enclosure enclose_size(const Enclosure& l, const Enclosure& y, double guess) const {
    Enclosure g = Enclosure(guess);
    for (int i = 0; i < 12; ++i) { // to full precision, in the middle
      const DualBall e = energy_in_size(body_, levels_, rule_, l.middle(), y.middle(), g);
      g = (g - (e.v - levels_.energy.v) / e.d[0]).middle();
    }
    Enclosure box = g;
    for (int i = 0; i < 8; ++i) {
      const Enclosure wide = box.widened(Enclosure(box.radius() * 4 + std::ldexp(1.0, -200)));
      const DualBall slope = energy_in_size(body_, levels_, rule_, l, y, wide);
      const DualBall value = energy_in_size(body_, levels_, rule_, l, y, g);
      const Enclosure next = g - (value.v - levels_.energy.v) / slope.d[0];
      if (next.inside(wide)) return next;
      box = Enclosure::hull(wide, next);
    }
    throw NotProved::momentum;
  }

  // One step from jet_'s point; may shorten h.  Let B be the Taylor polynomial over [0, h], widened
  // by epsilon, and R an enclosure of the coefficient order + 1 over B.  If h^(order + 1) |R| <
  // epsilon then the orbit stays in B during the step: as long as it does, it differs from the
  // polynomial by at most h^(order + 1) |R|, so that it cannot reach the border of B
  // [CorlissRihm1996].  The same for its derivatives, which solve an equation too.
  State<DualBall> advance(double& h) {
    const Enclosure epsilon(tolerance_);
    const auto wider = [&](const DualBall& a, const DualBall&) {
      return DualBall(a.v.widened(epsilon), a.d[0].widened(epsilon), a.d[1].widened(epsilon));
    };
    for (int attempt = 0; attempt < 60; ++attempt) {
      const State<DualBall> over = jet_.at(DualBall(Enclosure::between(0, h)), order_);
      box_ = each(over, over, wider);
      box_jet_.expand(box_, order_ + 1);
      last_ = box_jet_.coefficient(order_ + 1);
      const double rest = magnitude(last_) * magnitude(power(Enclosure(h), order_ + 1));
      const double scale =
          std::isfinite(rest) ? std::pow(tolerance_ / (rest + 1e-290), 1.0 / (order_ + 1)) : 0.5;
      if (rest < tolerance_) {
        room_ = std::clamp(0.95 * scale, 0.5, 1.5);
        return at(Enclosure(h));
      }
      h *= std::clamp(0.9 * scale, 0.3, 0.9);
    }
    throw NotProved::no_box;
  }

  static Enclosure power(const Enclosure& x, int n) {
    Enclosure r;
    arb_pow_ui(r.raw(), x.raw(), static_cast<ulong>(n), Enclosure::bits());
    return r;
  }

  // The orbit at t in [0, h] of the current step.
  [[nodiscard]] State<DualBall> at(const Enclosure& t) const {
    const DualBall reach(power(t, order_ + 1));
    return each(jet_.at(DualBall(t), order_), last_,
                [&](const DualBall& a, const DualBall& r) { return a + reach * r; });
  }

  // No crossing of the wanted kind in this step, or exactly one, or not decided.
  Verdict look(const State<DualBall>& from, const State<DualBall>& to, bool& leaving) {
    const int way = rule_.falling ? -1 : 1; // wanted sign of dS/dt
    const auto over = section_functions(body_, box_, rule_.axis);
    if (!over.s.v.contains_zero()) {
      leaving = false;
      return Verdict::goes_on;
    }
    if (rule_.side > 0 ? over.c.v.is_negative() : over.c.v.is_positive()) {
      leaving = false;
      return Verdict::goes_on;
    }
    box_jet_.expand(box_, 2);
    const Enclosure rate = box_jet_.section(rule_.axis, 1)[1].v;
    const bool wanted = way < 0 ? rate.is_negative() : rate.is_positive();
    const bool unwanted = way < 0 ? rate.is_positive() : rate.is_negative();
    if (unwanted) {
      leaving = false;
      return Verdict::goes_on;
    }
    if (!wanted) return Verdict::retry;
    if (leaving) return Verdict::goes_on; // S = 0 at the start and monotone since
    const Enclosure s0 = section_functions(body_, from, rule_.axis).s.v,
                    s1 = section_functions(body_, to, rule_.axis).s.v;
    const auto before = [&](const Enclosure& s) {
      return way < 0 ? s.is_positive() : s.is_negative();
    };
    const auto after = [&](const Enclosure& s) {
      return way < 0 ? s.is_negative() : s.is_positive();
    };
    if (before(s0) && after(s1)) return sided(over.c.v) ? Verdict::lands : Verdict::retry;
    if (before(s0) && before(s1)) return Verdict::goes_on;
    if (after(s0) && after(s1)) return Verdict::goes_on;
    return Verdict::retry;
  }
  [[nodiscard]] bool sided(const Enclosure& c) const {
    return rule_.side > 0 ? c.is_positive() : c.is_negative();
  }

  // The unique zero of S in (0, h), by interval Newton steps on the time.
  SectionImage<Enclosure> land(double h, const Enclosure& before) {
    Enclosure t = Enclosure::between(0, h), rate;
    State<DualBall> x = box_;
    for (int i = 0; i < 60; ++i) {
      box_jet_.expand(x, 2);
      rate = box_jet_.section(rule_.axis, 1)[1].v;
      const Enclosure m = t.middle();
      const Enclosure s = section_functions(body_, at(m), rule_.axis).s.v;
      Enclosure next = m - s / rate;
      Enclosure both;
      if (arb_intersection(both.raw(), next.raw(), t.raw(), Enclosure::bits()) == 0)
        throw NotProved::crossing_lost;
      const double old = t.radius();
      t = both;
      x = at(t);
      if (t.radius() > 0.7 * old && i > 4) break;
    }
    box_jet_.expand(x, 2);
    rate = box_jet_.section(rule_.axis, 1)[1].v;
    const DualBall s = section_functions(body_, x, rule_.axis).s;
    const State<DualBall> speed = box_jet_.coefficient(1);
    x = each(x, speed, [&](const DualBall& a, const DualBall& f) {
      return DualBall(a.v, a.d[0] - f.v * s.d[0] / rate, a.d[1] - f.v * s.d[1] / rate);
    });
    SectionImage<Enclosure> out;
    chart(body_, x, rule_.axis, DualBall(about_), out.l, out.y);
    out.time = before + t;
    same_sheet(x, out);
    return out;
  }

  // (l, L/G) determines G only locally: no second solution of H = h between the G of start and
  // arrival.
  void same_sheet(const State<DualBall>& x, const SectionImage<Enclosure>& p) const {
    const Vec<DualBall> n = minus(momentum(body_, x), body_.gyrostat);
    const Enclosure both = Enclosure::hull(start_size_, sqrt(dot(n, n)).v);
    if (energy_in_size(body_, levels_, rule_, p.l.v, p.y.v, both).d[0].contains_zero())
      throw NotProved::another_sheet;
  }
};

// The middle of (DP - 1)^-1: exact numbers, so that the test below may use it as if it were the
// inverse.
struct Inverse {
  Enclosure a, b, c, d;
  explicit Inverse(const SectionImage<Enclosure>& p) {
    const Enclosure m = (p.l.d[0] - Enclosure(1)).middle(), n = p.l.d[1].middle(),
                    o = p.y.d[0].middle(), q = (p.y.d[1] - Enclosure(1)).middle();
    const Enclosure det = m * q - n * o;
    a = (q / det).middle();
    b = (-n / det).middle();
    c = (-o / det).middle();
    d = (m / det).middle();
  }
};

// A place and what the map makes of it.
struct Candidate {
  Enclosure l, y; // exact
  SectionImage<Enclosure> image;
  double size;     // G
  double left = 0; // of the last correction, with its radius
};

// Newton's method in the middles, until the enclosures' radius is reached.
Candidate refined(const FixedPoint& f, ProvedMap& map) {
  Candidate u{Enclosure(f.l), Enclosure(f.y), {}, f.g_size};
  for (int i = 0; i < 8; ++i) {
    u.image = map(u.l, u.y, u.size);
    const Inverse inverse(u.image);
    const Enclosure fl = u.image.l.v - u.l, fy = u.image.y.v - u.y;
    const Enclosure dl = inverse.a * fl + inverse.b * fy, dy = inverse.c * fl + inverse.d * fy;
    u.left = std::max(magnitude(dl), magnitude(dy));
    if (!(u.left < 1e-3)) throw NotProved::left_by_newton;
    if (u.left <= 16 * std::max(dl.radius(), dy.radius())) return u;
    u.l = (u.l - dl).middle();
    u.y = (u.y - dy).middle();
  }
  u.image = map(u.l, u.y, u.size);
  return u;
}

// K = u - C (P(u) - u) + (1 - C (DP(U) - 1)) (U - u); true if K lies inside U.
bool contracts(const Candidate& u, const SectionImage<Enclosure>& over, const Enclosure& radius,
               Enclosure& kl, Enclosure& ky) {
  const Inverse inv(u.image);
  const Enclosure fl = u.image.l.v - u.l, fy = u.image.y.v - u.y, one(1);
  const Enclosure m = over.l.d[0] - one, n = over.l.d[1], o = over.y.d[0], q = over.y.d[1] - one;
  const Enclosure ball = Enclosure(0).widened(radius);
  kl = u.l - (inv.a * fl + inv.b * fy) + (one - (inv.a * m + inv.b * o)) * ball -
       (inv.a * n + inv.b * q) * ball;
  ky = u.y - (inv.c * fl + inv.d * fy) - (inv.c * m + inv.d * o) * ball +
       (one - (inv.c * n + inv.d * q)) * ball;
  return kl.inside(u.l.widened(radius)) && ky.inside(u.y.widened(radius));
}

// A bound of |x - shown|.
double error_of(const Enclosure& x, double shown) { return magnitude(x - Enclosure(shown)); }

void krawczyk(FixedPoint& f, ProvedMap& map) {
  const Candidate u = refined(f, map);
  for (double r = std::max(u.left * 4, 1e-60); r < 1e-9; r *= 100) {
    const Enclosure radius(r);
    SectionImage<Enclosure> over = map(u.l.widened(radius), u.y.widened(radius), u.size);
    Enclosure kl, ky;
    if (!contracts(u, over, radius, kl, ky)) continue;
    if (std::max(kl.radius(), ky.radius()) < r / 4 && (over.l.d[0] + over.y.d[1]).radius() > 1e-16)
      over = map(kl, ky, u.size); // the fixed point is in K
    const Enclosure trace = over.l.d[0] + over.y.d[1];
    f.l = static_cast<double>(kl);
    f.y = static_cast<double>(ky);
    f.error = std::max(error_of(kl, f.l), error_of(ky, f.y));
    f.trace = static_cast<double>(trace);
    f.trace_error = error_of(trace, f.trace);
    f.determinant = static_cast<double>(over.l.d[0] * over.y.d[1] - over.l.d[1] * over.y.d[0]);
    f.period = static_cast<double>(over.time);
    f.proved = true;
    return;
  }
  throw NotProved::krawczyk;
}

} // namespace

FixedPoint prove_fixed_point(const Scene& scene, const FixedPoint& guess, long bits,
                             const std::atomic<bool>* stop) {
  const OwnUnits units = own_units(scene);
  FixedPoint f = guess;
  f.g_size = std::ldexp(f.g_size, static_cast<int>(-units.momentum()));
  const EnclosureScope scope(bits);
  try {
    ProvedMap map(in_units(scene, units), stop);
    krawczyk(f, map);
  } catch (const NotProved& n) {
    f = guess;
    f.why = n;
    return f;
  }
  f.g_size = guess.g_size;
  f.period = std::ldexp(f.period, static_cast<int>(units.time));
  return f;
}

} // namespace kov::flow
