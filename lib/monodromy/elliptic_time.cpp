#include "monodromy/elliptic_time.hpp"

#include "exact/error.hpp"
#include "monodromy/imprecise.hpp"
#include "monodromy/magnitude.hpp"

#include <algorithm>

namespace kov::monodromy {
namespace {

constexpr long spare_digits = 12; // at first, for what products of matrices lose
constexpr long most_digits = 1L << 17;

class OnTheCurve {
public:
  OnTheCurve(const EllipticSystem& s, const TwoSheets& sheets, const Request& request)
      : s_(s), sheets_(sheets), m_(monodromy(sheets.system(), request)), bits_(m_.bits) {
    speed_ = evaluate(s.f, exact(m_.base), bits_);
    acb_sqrt(speed_.raw(), speed_.raw(), bits_);
    for (std::size_t i = 0; i < m_.loops.size(); ++i)
      if (is_branch(m_.loops[i].place.factor)) branch_.push_back(i);
    if (branch_.size() != static_cast<std::size_t>(degree(s.f)))
      throw InternalError("a branch point of the curve has no loop");
  }

  [[nodiscard]] EllipticMonodromy all() {
    EllipticMonodromy e{m_.base, speed_, {}, {}, m_.self_tests, bits_};
    for (const std::size_t k : {0, 1})
      e.periods.push_back(period({branch_[k], branch_[k + 1]}));
    ensure_lattice(e);
    test_sheets(e);
    for (std::size_t i = 0; i < m_.loops.size(); ++i)
      add_pole(e, m_.loops[i], i);
    if (has_pole_at_infinity()) add_infinity(e);
    return e;
  }

private:
  [[nodiscard]] bool is_branch(const Poly& factor) const {
    return is_zero(coerce(s_.f, factor.field()) % factor);
  }

  // On the sheet w again.
  [[nodiscard]] BallMatrix by_time(const BallMatrix& whole) const {
    return sheets_.on_sheet(whole, speed_, 1, bits_);
  }

  // t = w T; T becomes T + (tau/w) c along the word.
  [[nodiscard]] PeriodMatrix period(const Word& loops) const {
    const BallMatrix whole = matrix_of(m_, loops);
    ComplexBall tau;
    acb_mul(tau.raw(), whole.entry(sheets_.time(), sheets_.time() + 1), speed_.raw(), bits_);
    return {tau, loops, by_time(whole)};
  }

  template <class Condition> [[nodiscard]] bool any_entry(Condition holds) const {
    for (const auto* b : {&s_.even, &s_.odd})
      for (const auto& row : *b)
        for (const RationalFunction& x : row)
          if (!is_zero(x) && holds(x, b == &s_.odd)) return true;
    return false;
  }

  [[nodiscard]] bool is_pole(const Poly& place) const {
    return any_entry([&](const RationalFunction& x, bool) {
      return is_zero(coerce(x.den(), place.field()) % place);
    });
  }

  // z ~ t^-2, w ~ t^-3 or z ~ t^-1, w ~ t^-2.
  [[nodiscard]] bool has_pole_at_infinity() const {
    return any_entry([](const RationalFunction& x, bool odd) {
      return degree(x.den()) - degree(x.num()) < (odd ? 2 : 0);
    });
  }

  void add_pole(EllipticMonodromy& e, const LoopMatrix& loop, std::size_t i) const {
    if (!is_pole(loop.place.factor)) return;
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
    if (degree(s_.f) == 3) {
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

  // If both sheets are continued together, a solution that starts on one ends on it.
  void test_sheets(EllipticMonodromy& e) const {
    bool any = false;
    for (const PeriodMatrix& p : e.periods) {
      const BallMatrix other = sheets_.on_sheet(matrix_of(m_, p.loops), speed_, -1, bits_);
      for (std::size_t i = 0; i < s_.size(); ++i)
        for (std::size_t j = 0; j < s_.size(); ++j) {
          if (!sheets_.is_double(i) || !sheets_.is_double(j)) continue;
          any = true;
          if (acb_contains_zero(other.entry(static_cast<long>(i), static_cast<long>(j))) == 0)
            throw InternalError("a period leads from one sheet of the curve to the other");
        }
    }
    if (any) e.self_tests.emplace_back("the periods stay on their sheet");
  }

  const EllipticSystem& s_;
  const TwoSheets& sheets_;
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
  return std::ranges::all_of(
             e.periods, [&](const auto& p) { return fine(p.matrix) && fine(number(p.period)); }) &&
         std::ranges::all_of(e.poles, [&](const PoleMatrix& p) { return fine(p.matrix); });
}

} // namespace

EllipticMonodromy elliptic_monodromy(const EllipticSystem& s, const Request& request) {
  if (degree(s.f) < 3 || degree(s.f) > 4 || degree(gcd(s.f, derivative(s.f))) > 0)
    throw InvalidArgument("an elliptic time needs a squarefree polynomial of degree 3 or 4");
  const TwoSheets sheets(s);
  for (long digits = request.digits + spare_digits; digits < most_digits; digits *= 2) {
    try {
      EllipticMonodromy e = OnTheCurve(s, sheets, {digits, request.base, request.budget}).all();
      if (is_accurate(e, request.digits)) return e;
    } catch (const Imprecise&) {
      continue; // with more digits
    }
  }
  throw OutOfBudget("the matrices could not be computed to " + std::to_string(request.digits) +
                    " digits");
}

EllipticMonodromy elliptic_monodromy(const RationalFunction& r, const Poly& f,
                                     const Request& request) {
  const RationalFunction zero(0);
  return elliptic_monodromy(
      {{{zero, RationalFunction(1)}, {r, zero}}, {{zero, zero}, {zero, zero}}, f}, request);
}

Monodromy elements(const EllipticMonodromy& e) {
  Monodromy m{e.base, {}, {}, {}, e.bits};
  for (const PeriodMatrix& p : e.periods)
    m.loops.push_back({{}, p.matrix});
  for (const PoleMatrix& p : e.poles)
    m.loops.push_back({{}, p.matrix});
  return m;
}

} // namespace kov::monodromy
