#include "monodromy/elliptic_time.hpp"

#include "exact/error.hpp"
#include "monodromy/imprecise.hpp"
#include "monodromy/magnitude.hpp"

#include <algorithm>

namespace kov::monodromy {
namespace {

constexpr long spare_digits = 12; // at first, for what products of matrices lose
constexpr long most_digits = 1L << 17;

RationalFunction rational(long n, long d = 1) { return {Rational(Integer(n), Integer(d))}; }

// (y, dy/dz; u, u') with u'' = -F'/(2F) u': u' = w(base)/w, u = w(base) t.
DifferentialSystem with_time(const RationalFunction& r, const RationalFunction& f) {
  const RationalFunction half_log = derivative(f) / (rational(2) * f), zero = rational(0);
  return make_system({{zero, rational(1), zero, zero},
                      {r / f, -half_log, zero, zero},
                      {zero, zero, zero, rational(1)},
                      {zero, zero, zero, -half_log}});
}

class OnTheCurve {
public:
  OnTheCurve(const RationalFunction& r, const Poly& f, const Request& request)
      : r_(r), f_(f), m_(monodromy(with_time(r, RationalFunction(f)), request)), bits_(m_.bits) {
    speed_ = evaluate(f, exact(m_.base), bits_);
    acb_sqrt(speed_.raw(), speed_.raw(), bits_);
    for (std::size_t i = 0; i < m_.loops.size(); ++i)
      if (is_branch(m_.loops[i].place.factor)) branch_.push_back(i);
    if (branch_.size() != static_cast<std::size_t>(degree(f)))
      throw InternalError("a branch point of the curve has no loop");
  }

  [[nodiscard]] EllipticMonodromy all() {
    EllipticMonodromy e{m_.base, speed_, {}, {}, m_.self_tests};
    for (const std::size_t k : {0, 1})
      e.periods.push_back(period({branch_[k], branch_[k + 1]}));
    ensure_lattice(e);
    for (std::size_t i = 0; i < m_.loops.size(); ++i)
      add_pole(e, m_.loops[i], i);
    if (degree(r_.den()) < degree(r_.num())) add_infinity(e);
    return e;
  }

private:
  [[nodiscard]] bool is_branch(const Poly& factor) const {
    return is_zero(coerce(f_, factor.field()) % factor);
  }

  // The rows (y, dy/dt) of a matrix for (y, dy/dz): conjugated by diag(1, w).
  [[nodiscard]] BallMatrix by_time(const BallMatrix& whole) const {
    BallMatrix b(2);
    for (long i = 0; i < 2; ++i)
      for (long j = 0; j < 2; ++j)
        acb_set(b.entry(i, j), whole.entry(i, j));
    acb_div(b.entry(0, 1), b.entry(0, 1), speed_.raw(), bits_);
    acb_mul(b.entry(1, 0), b.entry(1, 0), speed_.raw(), bits_);
    return b;
  }

  // u becomes u + tau u' along the word.
  [[nodiscard]] PeriodMatrix period(const Word& loops) const {
    const BallMatrix whole = matrix_of(m_, loops);
    ComplexBall tau;
    acb_div(tau.raw(), whole.entry(2, 3), speed_.raw(), bits_);
    return {tau, loops, by_time(whole)};
  }

  void add_pole(EllipticMonodromy& e, const LoopMatrix& loop, std::size_t i) const {
    const Poly& place = loop.place.factor;
    if (!is_zero(coerce(r_.den(), place.field()) % place)) return;
    if (is_branch(loop.place.factor)) {
      e.poles.push_back({loop.place, false, by_time(matrix_of(m_, {i, i}))});
      return;
    }
    e.poles.push_back({loop.place, false, by_time(loop.matrix)});
    e.poles.push_back({loop.place, true, by_time(through_branch(loop.matrix))});
  }

  // The large circle is counterclockwise in z, so clockwise around infinity.
  void add_infinity(EllipticMonodromy& e) const {
    if (!m_.large_circle)
      throw InvalidArgument("infinity is a pole in the t-plane: leave --base to the program");
    const BallMatrix back = inverse(*m_.large_circle, bits_);
    if (degree(f_) == 3) {
      e.poles.push_back({std::nullopt, false, by_time(multiply(back, back, bits_))});
      return;
    }
    e.poles.push_back({std::nullopt, false, by_time(back)});
    e.poles.push_back({std::nullopt, true, by_time(through_branch(back))});
  }

  // Along the loop of the first branch point, then this loop, then back.
  [[nodiscard]] BallMatrix through_branch(const BallMatrix& a) const {
    const BallMatrix& by = m_.loops[branch_.front()].matrix;
    return multiply(inverse(by, bits_), multiply(a, by, bits_), bits_);
  }

  // The quotient of the periods is certainly not real.
  static void ensure_lattice(EllipticMonodromy& e) {
    ComplexBall quotient;
    acb_div(quotient.raw(), e.periods[1].period.raw(), e.periods[0].period.raw(), plan_bits);
    if (arb_contains_zero(acb_imagref(quotient.raw())) != 0)
      throw Imprecise("the periods cannot be told from real multiples of each other");
    e.self_tests.emplace_back("the quotient of the periods is not real");
  }

  const RationalFunction& r_;
  const Poly& f_;
  Monodromy m_;
  long bits_;
  ComplexBall speed_;
  std::vector<std::size_t> branch_; ///< loops around branch points, in their order
};

bool is_accurate(const EllipticMonodromy& e, long digits) {
  Ball bound;
  arb_set_si(bound.raw(), 10);
  arb_pow_ui(bound.raw(), bound.raw(), static_cast<ulong>(digits), 64);
  arb_inv(bound.raw(), bound.raw(), 64);
  const auto fine = [&](const BallMatrix& m) {
    const Ball r = largest_radius(m);
    return arb_is_finite(r.raw()) != 0 && arb_le(r.raw(), bound.raw()) != 0;
  };
  const auto number = [](const ComplexBall& z) {
    BallMatrix m(1);
    acb_set(m.entry(0, 0), z.raw());
    return m;
  };
  return std::all_of(e.periods.begin(), e.periods.end(),
                     [&](const auto& p) { return fine(p.matrix) && fine(number(p.period)); }) &&
         std::all_of(e.poles.begin(), e.poles.end(),
                     [&](const PoleMatrix& p) { return fine(p.matrix); });
}

} // namespace

EllipticMonodromy elliptic_monodromy(const RationalFunction& r, const Poly& f,
                                     const Request& request) {
  if (degree(f) < 3 || degree(f) > 4 || degree(gcd(f, derivative(f))) > 0)
    throw InvalidArgument("an elliptic time needs a squarefree polynomial of degree 3 or 4");
  for (long digits = request.digits + spare_digits; digits < most_digits; digits *= 2) {
    try {
      EllipticMonodromy e = OnTheCurve(r, f, {digits, request.base, request.budget}).all();
      if (is_accurate(e, request.digits)) return e;
    } catch (const Imprecise&) { // more digits
    }
  }
  throw OutOfBudget("the matrices could not be computed to " + std::to_string(request.digits) +
                    " digits");
}

} // namespace kov::monodromy
