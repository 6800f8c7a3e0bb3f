// y'' = (1/x + c/x^2) y behind x = f(z): 4 f = (phase)^2, so that f is known at each of its poles
// to half of its principal part, and its zeros are places of r, but for a factor of high
// multiplicity, one linear factor of which is looked for.

#include "exact/factor.hpp"
#include "pullback/local.hpp"
#include "pullback/standard.hpp"
#include "pullback/zeros.hpp"

#include <algorithm>

namespace kov::pullback {
namespace {

constexpr long largest_map_degree = 12;
constexpr long most_zeros = 12;

struct IrregularPole {
  Point point;
  long order = 0;
  ResidueSeries terms; // of f t^order
};

std::vector<IrregularPole> irregular_poles(const Singularities& s) {
  std::vector<IrregularPole> all;
  for (const Singularity* place : irregular_places(s)) {
    const Phase p = phase(s.r, *place);
    const Point point = point_of(*place);
    ResidueSeries terms;
    for (const Poly& c : p.terms)
      terms.push_back(scale(c * p.leading % point.q, NfElem(Rational(1, 4))));
    all.push_back({point, p.pole, std::move(terms)});
  }
  return all;
}

class BesselSearch {
public:
  BesselSearch(const Singularities& s, const Try& tell, const Budget& budget)
      : s_(s), tell_(tell), budget_(budget), poles_(irregular_poles(s)) {
    for (const IrregularPole& p : poles_) {
      left_ += p.order * degree(p.point.q);
      if (!p.point.at_infinity) below_ *= pow(p.point.q, static_cast<unsigned long>(p.order));
    }
    for (const Singularity& place : s.finite)
      if (is_lasting(place)) zeros_.push_back(&place);
    if (is_lasting(s.infinity)) zeros_.push_back(&s.infinity);
  }

  bool run() {
    if (poles_.empty() || left_ > largest_map_degree ||
        static_cast<long>(zeros_.size()) > most_zeros)
      return false;
    return with_multiplicities(0, Poly(1));
  }

private:
  // The zeros from the i-th one on; what is left of the degree belongs to an unseen factor.
  bool with_multiplicities(std::size_t i, const Poly& above) {
    if (i == zeros_.size()) return with_zeros(above);
    const Singularity& place = *zeros_[i];
    const long before = left_;
    bool done = false;
    for (long e = 1; !done && e * place.degree() <= before; ++e) {
      left_ = before - e * place.degree();
      done = with_multiplicities(
          i + 1,
          place.at_infinity ? above : above * pow(place.place, static_cast<unsigned long>(e)));
    }
    left_ = before;
    return done;
  }

  bool with_zeros(const Poly& above) {
    budget_.check();
    if (left_ == 0) return scaled(RationalFunction(above, below_));
    if (left_ < 3) return false; // a double zero without a trace has D = 1/2: not SL(2)
    for (const NfElem& c : hidden_roots(RationalFunction(above, below_)))
      if (scaled(RationalFunction(
              above * pow(Poly::z() - Poly(c), static_cast<unsigned long>(left_)), below_)))
        return true;
    return false;
  }

  // (z - c)^n has the terms H = known/visible at each pole, up to one constant.
  [[nodiscard]] std::vector<NfElem> hidden_roots(const RationalFunction& visible) const {
    struct Value {
      NfElem at, first;
      bool at_infinity;
    };
    std::vector<Value> values;
    const NfElem n(left_);
    for (const IrregularPole& p : poles_) {
      if (degree(p.point.q) != 1) continue;
      const auto terms = static_cast<long>(p.terms.size());
      const Laurent here = laurent(visible, p.point, terms);
      const ResidueSeries h = divide(p.terms, here.terms, p.point.q);
      const NfElem at = -p.point.q.coeff(0);
      const NfElem first = h[0].coeff(0);
      if (terms >= 2) { // the logarithmic derivative
        const NfElem second = h[1].coeff(0);
        if (p.point.at_infinity) return {-second / (n * first)};
        if (is_zero(second)) return {};
        return {at - n * first / second};
      }
      values.push_back({at, first, p.point.at_infinity});
    }
    if (values.size() < 2) return {};
    std::vector<NfElem> found;
    const Value& one = values[0]; // infinity, if it is there
    const Value& other = values[1];
    for (const Poly& root : roots_of(Poly(other.first / one.first), left_, Poly::z(), budget_)) {
      const NfElem ratio = root.coeff(0);
      if (one.at_infinity)
        found.push_back(other.at - ratio);
      else if (!is_one(ratio)) // (other.at - c) = ratio (one.at - c)
        found.push_back((other.at - ratio * one.at) / (NfElem(1) - ratio));
    }
    return found;
  }

  bool scaled(const RationalFunction& shape) {
    const IrregularPole& first = poles_.front();
    const Laurent here = laurent(shape, first.point, 1);
    if (here.order != -first.order) return false;
    const Poly factor = divide({first.terms[0]}, here.terms, first.point.q)[0];
    if (degree(factor) > 0) return false;
    const RationalFunction f = shape * RationalFunction(factor);
    for (const IrregularPole& p : poles_) {
      const Laurent terms = laurent(f, p.point, static_cast<long>(p.terms.size()));
      if (terms.order != -p.order || terms.terms != p.terms) return false;
    }
    for (const NfElem& square : squares_at_zero(zeros_of(f, s_, budget_))) {
      const NfElem c = (square - NfElem(1)) / NfElem(4);
      if (tell_(
              {Classical::bessel, RationalFunction(Poly::z() + Poly(c), Poly::z() * Poly::z()), f}))
        return true;
    }
    return false;
  }

  const Singularities& s_;
  const Try& tell_;
  const Budget& budget_;
  std::vector<IrregularPole> poles_;
  std::vector<const Singularity*> zeros_;
  Poly below_ = Poly(1);
  long left_ = 0;
};

} // namespace

bool try_bessel_of_root(const Singularities& s, const Try& tell, const Budget& budget) {
  return BesselSearch(s, tell, budget).run();
}

} // namespace kov::pullback
