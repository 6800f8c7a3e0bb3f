// Krawczyk's test for a fixed point of the section map, with enclosures all the way; see fixed_points.hpp.

#include "flow/enclosure.hpp"
#include "flow/quantity.hpp"

namespace kov::flow {
template <> struct QuantityTraits<Enclosure> {
  static Enclosure integer(const std::string& digits) {
    Enclosure x;
    arb_set_str(x.raw(), digits.c_str(), Enclosure::bits());
    return x;
  }
  static Enclosure root(const Enclosure& x, const Expression&) { return sqrt(x); }
  static Enclosure pi(const Expression&) { return pi_of(Enclosure()); }
};
} // namespace kov::flow

#include "flow/fixed_points.hpp"
#include "flow/section_map.hpp"

#include <algorithm>
#include <cmath>

namespace kov::flow {
namespace {

using DualBall = Dual<Enclosure>;

// Why a proof did not succeed; never leaves this file.
struct NotProved {
  std::string why;
};

template <class F> State<DualBall> each(const State<DualBall>& a, const State<DualBall>& b, const F& f) {
  State<DualBall> r;
  for (int i = 0; i < 3; ++i) {
    r.omega[i] = f(a.omega[i], b.omega[i]);
    r.gamma[i] = f(a.gamma[i], b.gamma[i]);
  }
  return r;
}

DualBall widened(const DualBall& x, const Enclosure& part) {
  const auto grow = [&](const Enclosure& e) {
    Enclosure r(e.radius());
    return e.widened(r * part);
  };
  return {grow(x.v), grow(x.d[0]), grow(x.d[1])};
}

bool inside(const DualBall& a, const DualBall& b) {
  const auto in = [](const Enclosure& x, const Enclosure& y) {
    return x.inside(y) || (x.radius() == 0 && y.radius() == 0 && x == y);
  };
  return in(a.v, b.v) && in(a.d[0], b.d[0]) && in(a.d[1], b.d[1]);
}

bool inside(const State<DualBall>& a, const State<DualBall>& b) {
  bool all = true;
  for (int i = 0; i < 3; ++i)
    all = all && inside(a.omega[i], b.omega[i]) && inside(a.gamma[i], b.gamma[i]);
  return all;
}

class ProvedMap {
public:
  ProvedMap(const Scene& s, int order)
      : order_(order), rule_(s.section), plain_(s.body<Enclosure>()), body_(dual_body(plain_)),
        levels_{DualBall(s.energy.as<Enclosure>()), DualBall(s.length.as<Enclosure>()),
                DualBall(s.casimir.as<Enclosure>())},
        jet_(body_, effects_of(s.body<double>()), order), box_jet_(body_, effects_of(s.body<double>()), order + 1) {}

  /// P and DP over the box (l, y); G near `size`.
  SectionImage<Enclosure> operator()(const Enclosure& l, const Enclosure& y, double size) {
    start_size_ = enclose_size(l, y, size);
    State<DualBall> x = lifted(body_, levels_, rule_, l, y, start_size_);
    Enclosure time(0);
    bool leaving = true; // the section, on which the orbit starts
    double h = 0.02;
    for (int step = 0; step < 100000; ++step) {
      jet_.expand(x, order_);
      const State<DualBall> end = advance(x, h);
      const Verdict v = look(x, end, leaving);
      if (v == Verdict::retry) {
        if (h < 1e-6) throw NotProved{"a crossing could not be separated from the end of a step"};
        h *= 0.61803;
        continue;
      }
      if (v == Verdict::lands) return land(h, time);
      x = end;
      time += Enclosure(h);
      h = std::min(h * 1.5, 0.1);
    }
    throw NotProved{"the orbit did not return"};
  }

private:
  enum class Verdict : unsigned char { goes_on, lands, retry };
  int order_;
  SectionRule rule_;
  Body<Enclosure> plain_;
  Body<DualBall> body_;
  Levels<DualBall> levels_;
  VariationalJet<Enclosure> jet_, box_jet_;
  Enclosure start_size_; // G
  State<DualBall> box_;  // contains the orbit during the step
  State<DualBall> last_; // coefficient order + 1 over the box

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
    throw NotProved{"G could not be enclosed"};
  }

  // Picard: x + [0, h] f(B) inside B; then the Taylor polynomial with its remainder.  May shorten h.
  State<DualBall> advance(const State<DualBall>& x, double& h) {
    for (int attempt = 0; attempt < 60; ++attempt, h *= 0.7) {
      if (!contain(x, h)) continue;
      box_jet_.expand(box_, order_ + 1);
      last_ = box_jet_.coefficient(order_ + 1);
      const Enclosure reach = power(Enclosure(h), order_ + 1);
      double worst = 0;
      for (int i = 0; i < 3; ++i)
        for (const DualBall* c : {&last_.omega[i], &last_.gamma[i]})
          for (const Enclosure* e : {&c->v, &c->d[0], &c->d[1]})
            worst = std::max(worst, std::abs(static_cast<double>(*e * reach)) + (*e * reach).radius());
      if (!(worst < std::ldexp(1.0, static_cast<int>(-Enclosure::bits() / 2)))) continue;
      return at(Enclosure(h));
    }
    throw NotProved{"the orbit could not be contained in a box"};
  }

  bool contain(const State<DualBall>& x, double h) {
    const DualBall span(Enclosure::between(0, h));
    const auto one_step = [&](const State<DualBall>& f) {
      return each(x, f, [&](const DualBall& a, const DualBall& b) { return a + span * b; });
    };
    const auto grown = [](const State<DualBall>& s) {
      return each(s, s, [](const DualBall& a, const DualBall&) { return widened(a, Enclosure(0.25)); });
    };
    box_ = grown(one_step(jet_.coefficient(1)));
    for (int i = 0; i < 12; ++i) {
      box_jet_.expand(box_, 1);
      const State<DualBall> image = one_step(box_jet_.coefficient(1));
      if (inside(image, box_)) {
        box_ = image; // also contains the orbit
        return true;
      }
      box_ = grown(each(image, box_, [](const DualBall& a, const DualBall& b) {
        return DualBall(Enclosure::hull(a.v, b.v), Enclosure::hull(a.d[0], b.d[0]),
                        Enclosure::hull(a.d[1], b.d[1]));
      }));
    }
    return false;
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
    const auto before = [&](const Enclosure& s) { return way < 0 ? s.is_positive() : s.is_negative(); };
    const auto after = [&](const Enclosure& s) { return way < 0 ? s.is_negative() : s.is_positive(); };
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
        throw NotProved{"the crossing was lost"};
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
    chart(body_, x, rule_.axis, out.l, out.y);
    out.time = before + t;
    same_sheet(x, out);
    return out;
  }

  // (l, L/G) determines G only locally: no second solution of H = h between the G of start and arrival.
  void same_sheet(const State<DualBall>& x, const SectionImage<Enclosure>& p) const {
    const Vec<DualBall> n = minus(momentum(body_, x), body_.gyrostat);
    const Enclosure both = Enclosure::hull(start_size_, sqrt(dot(n, n)).v);
    if (energy_in_size(body_, levels_, rule_, p.l.v, p.y.v, both).d[0].contains_zero())
      throw NotProved{"the orbit may return on another sheet of the level"};
  }
};

// l - l0 without the turns in between.
Enclosure angle(const Enclosure& difference) {
  const double turns = std::round(static_cast<double>(difference) / (2 * pi_of(0.0)));
  return difference - Enclosure(turns * 2) * pi_of(Enclosure());
}

struct Newton {
  Enclosure l, y;
};

// -(DP - 1)^-1 (P(u) - u) in the middles.
Newton correction(const SectionImage<Enclosure>& p, const Enclosure& l, const Enclosure& y) {
  const Enclosure fl = angle(p.l.v - l).middle(), fy = (p.y.v - y).middle();
  const Enclosure a = (p.l.d[0] - Enclosure(1)).middle(), b = p.l.d[1].middle(), c = p.y.d[0].middle(),
                  d = (p.y.d[1] - Enclosure(1)).middle();
  const Enclosure det = (a * d - b * c).middle();
  return {((b * fy - d * fl) / det).middle(), ((c * fl - a * fy) / det).middle()};
}

void krawczyk(FixedPoint& f, ProvedMap& map) {
  Enclosure l(f.l), y(f.y);
  SectionImage<Enclosure> p = map(l, y, f.g_size);
  double move = 1;
  for (int i = 0; i < 6 && move > 1e-45; ++i) {
    const Newton n = correction(p, l, y);
    l = (l + n.l).middle();
    y = (y + n.y).middle();
    move = std::max(std::abs(static_cast<double>(n.l)), std::abs(static_cast<double>(n.y)));
    if (move > 1e-3) throw NotProved{"Newton's method left the point that the search had found"};
    p = map(l, y, f.g_size);
  }
  const Newton n = correction(p, l, y); // what is left, for the size of the box
  const double left = std::max({std::abs(static_cast<double>(n.l)), std::abs(static_cast<double>(n.y)),
                                p.l.v.radius(), p.y.v.radius()});
  for (double radius = std::max(left * 1e3, 1e-60); radius < 1e-9; radius *= 1e4) {
    const Enclosure r(radius), bl = l.widened(r), by = y.widened(r);
    const SectionImage<Enclosure> over = map(bl, by, f.g_size);
    const Enclosure a = (p.l.d[0] - Enclosure(1)).middle(), b = p.l.d[1].middle(),
                    c = p.y.d[0].middle(), d = (p.y.d[1] - Enclosure(1)).middle();
    const Enclosure det = (a * d - b * c).middle();
    const Enclosure c00 = (d / det).middle(), c01 = (-b / det).middle(), c10 = (-c / det).middle(),
                    c11 = (a / det).middle();
    const Enclosure fl = angle(p.l.v - l), fy = p.y.v - y;
    const Enclosure m00 = over.l.d[0] - Enclosure(1), m01 = over.l.d[1], m10 = over.y.d[0],
                    m11 = over.y.d[1] - Enclosure(1);
    const Enclosure zero = Enclosure(0).widened(r);
    const Enclosure kl = l - (c00 * fl + c01 * fy) + (Enclosure(1) - (c00 * m00 + c01 * m10)) * zero -
                         (c00 * m01 + c01 * m11) * zero;
    const Enclosure ky = y - (c10 * fl + c11 * fy) - (c10 * m00 + c11 * m10) * zero +
                         (Enclosure(1) - (c10 * m01 + c11 * m11)) * zero;
    if (!kl.inside(bl) || !ky.inside(by)) continue;
    const Enclosure trace = over.l.d[0] + over.y.d[1];
    const auto bound = [](const Enclosure& x, double shown) {
      const Enclosure e = x - Enclosure(shown);
      return (std::abs(static_cast<double>(e)) + e.radius()) * (1 + 1e-12);
    };
    f.l = static_cast<double>(kl);
    f.y = static_cast<double>(ky);
    f.error = std::max(bound(kl, f.l), bound(ky, f.y));
    f.trace = static_cast<double>(trace);
    f.trace_error = bound(trace, f.trace);
    f.determinant = static_cast<double>(over.l.d[0] * over.y.d[1] - over.l.d[1] * over.y.d[0]);
    f.period = static_cast<double>(over.time);
    f.proved = true;
    return;
  }
  throw NotProved{"Krawczyk's test failed on every box that was tried"};
}

} // namespace

FixedPoint prove_fixed_point(const Scene& scene, const FixedPoint& guess, long bits) {
  FixedPoint f = guess;
  const EnclosureScope scope(bits);
  try {
    ProvedMap map(scene, 30);
    krawczyk(f, map);
  } catch (const NotProved& n) {
    f = guess;
    f.why = n.why;
  }
  return f;
}

} // namespace kov::flow
