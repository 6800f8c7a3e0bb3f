// Riemann's equation behind x = f(z): the lasting places of r lie above 0, 1 and infinity.  They are
// divided among these fibres with multiplicities; where all points of two fibres are lasting, f is
// known up to a constant, and the third fibre says which one.

#include "exact/factor.hpp"
#include "exact/lists.hpp"
#include "pullback/kernel.hpp"
#include "pullback/local.hpp"
#include "pullback/standard.hpp"
#include "pullback/zeros.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace kov::pullback {
namespace {

constexpr long largest_riemann_degree = 6;
constexpr std::size_t most_places = 12;
constexpr long most_divisions = 200000;

// -(1 - d0^2)/(4 x^2) - (1 - d1^2)/(4 (x-1)^2) - (d0^2 + d1^2 - d^2 - 1)/(4 x (x-1)), from squares
RationalFunction riemann(const NfElem& at_0, const NfElem& at_1, const NfElem& at_infinity) {
  const Poly x = Poly::z(), y = x - Poly(1);
  const NfElem one(1);
  const Poly above = scale(y * y, at_0 - one) + scale(x * x, at_1 - one) +
                     scale(x * y, one + at_infinity - at_0 - at_1);
  return {scale(above, NfElem(Rational(1, 4))), x * x * y * y};
}

struct Member {
  const Singularity* place;
  long multiplicity;
};

// Is there d with D = +-e d modulo Z at both?  Rational numbers: e' D +- e D' is divisible by
// gcd(e, e').  Square roots of rational numbers: D/e = D'/e'.  Other numbers may be.
bool alike(const Member& p, const Member& q) {
  const Singularity &a = *p.place, &b = *q.place;
  const Rational e(p.multiplicity), f(q.multiplicity);
  if (a.delta && b.delta) {
    const Rational g(std::gcd(p.multiplicity, q.multiplicity));
    return is_integer((f * *a.delta + e * *b.delta) / g) ||
           is_integer((f * *a.delta - e * *b.delta) / g);
  }
  const auto square = [](const Singularity& s) {
    return degree(s.delta_squared) <= 0 && is_rational(s.delta_squared.coeff(0));
  };
  if (!square(a) || !square(b)) return true;
  return scale(a.delta_squared, NfElem(f * f)) == scale(b.delta_squared, NfElem(e * e));
}

// The six maps with the same fibres: a polynomial is easier to read, and z most of all.
RationalFunction simplest(const RationalFunction& f) {
  const RationalFunction one(1);
  RationalFunction best = f;
  for (const RationalFunction& g :
       {one - f, one / f, one / (one - f), f / (f - one), (f - one) / f})
    if (degree(g.den()) < degree(best.den()) || g == RationalFunction(Poly::z())) best = g;
  return best;
}

struct Fibre {
  Poly product = Poly(1); ///< of its finite lasting places
  long left = 0;          ///< degree - what is in the product
  std::vector<Member> places;
};

class RiemannSearch {
public:
  RiemannSearch(const Singularities& s, const Try& tell, const Budget& budget)
      : s_(s), tell_(tell), budget_(budget) {
    for (const Singularity& p : s.finite)
      if (is_lasting(p)) places_.push_back(&p);
    if (is_lasting(s.infinity)) places_.push_back(&s.infinity);
    // large places first: they have the fewest fibres to lie in
    std::stable_sort(places_.begin(), places_.end(),
                     [](const auto* p, const auto* q) { return p->degree() > q->degree(); });
  }

  bool run() {
    if (places_.empty() || places_.size() > most_places) return false;
    for (long n = 1; n <= largest_riemann_degree; ++n) {
      fibres_.assign(3, Fibre{Poly(1), n, {}});
      if (divide(0)) return true;
    }
    return false;
  }

private:
  // The i-th place and those behind it; an empty fibre is like the next one.
  bool divide(std::size_t i) {
    budget_.check();
    if (++divisions_ > most_divisions) return false;
    if (i == places_.size()) return divided();
    const Singularity& place = *places_[i];
    for (std::size_t j = 0; j < 3; ++j) {
      const long most = fibres_[j].left / place.degree();
      for (long e = 1; e <= most; ++e)
        if (fits(fibres_[j], {&place, e}) && with(i, j, e)) return true;
      if (fibres_[j].places.empty()) break;
    }
    return false;
  }

  static bool fits(const Fibre& fibre, const Member& point) {
    return std::ranges::all_of(fibre.places,
                               [&](const Member& other) { return alike(other, point); });
  }

  bool with(std::size_t i, std::size_t j, long e) {
    const Singularity& place = *places_[i];
    const Fibre before = fibres_[j];
    fibres_[j].left -= e * place.degree();
    fibres_[j].places.push_back({&place, e});
    if (!place.at_infinity) fibres_[j].product *= pow(place.place, static_cast<unsigned long>(e));
    const bool done = divide(i + 1);
    fibres_[j] = before;
    return done;
  }

  bool divided() {
    std::vector<std::size_t> full, open;
    for (std::size_t j = 0; j < 3; ++j)
      (fibres_[j].left == 0 ? full : open).push_back(j);
    if (open.empty()) return related();
    if (open.size() > 1 || fibres_[open[0]].left < 2) return false;
    return scaled(fibres_[full[0]], fibres_[full[1]], fibres_[open[0]]);
  }

  // x A + y B + z C = 0: f = -(x A)/(y B), f - 1 = (z C)/(y B).
  bool related() {
    const std::array<const Poly*, 3> p{&fibres_[0].product, &fibres_[1].product,
                                       &fibres_[2].product};
    std::vector<Row> rows;
    const long top = std::max({degree(*p[0]), degree(*p[1]), degree(*p[2])});
    for (long i = 0; i <= top; ++i)
      rows.push_back({p[0]->coeff(i), p[1]->coeff(i), p[2]->coeff(i)});
    const auto relation = kernel(rows, 3, budget_);
    if (relation.size() != 1) return false;
    const Row& x = relation[0];
    if (std::ranges::any_of(x, [](const NfElem& c) { return is_zero(c); })) return false;
    return with_map(RationalFunction(scale(*p[0], -(x[0] / x[1])), *p[1]));
  }

  // f = a A/B, where a point of the third fibre has the value 1: one of its lasting places, or else
  // a critical point.
  bool scaled(const Fibre& zeros, const Fibre& poles, const Fibre& third) {
    const RationalFunction f(zeros.product, poles.product);
    if (is_zero(derivative(f))) return false;
    std::vector<NfElem> values;
    const auto add = [&](const std::optional<NfElem>& value) {
      if (value && !is_zero(*value) && !is_among(*value, values)) values.push_back(*value);
    };
    if (!third.places.empty()) {
      const Singularity& place = *third.places.front().place;
      add(place.at_infinity ? value_at_infinity(f) : value_at(f, place.place));
    } else {
      add(value_at_infinity(f));
      for (const Factor& critical : irreducible_factors(derivative(f).num(), budget_))
        add(value_at(f, critical.base));
    }
    return std::ranges::any_of(values, [&](const NfElem& value) {
      return with_map(f * RationalFunction(Poly(inverse(value))));
    });
  }

  bool with_map(const RationalFunction& found) {
    if (is_zero(derivative(found))) return false;
    const RationalFunction one(1), f = simplest(found);
    const auto at_0 = squares_at_zero(zeros_of(f, s_, budget_));
    const auto at_1 = squares_at_zero(zeros_of(f - one, s_, budget_));
    const auto at_infinity = squares_and_odd_shifts(zeros_of(one / f, s_, budget_));
    for (const NfElem& a : at_0)
      for (const NfElem& b : at_1)
        for (const NfElem& c : at_infinity) {
          budget_.check();
          if (tell_({Classical::riemann, riemann(a, b, c), f})) return true;
        }
    return false;
  }

  const Singularities& s_;
  const Try& tell_;
  const Budget& budget_;
  std::vector<const Singularity*> places_;
  std::vector<Fibre> fibres_;
  long divisions_ = 0;
};

} // namespace

bool try_riemann(const Singularities& s, const Try& tell, const Budget& budget) {
  if (!irregular_places(s).empty()) return false;
  return RiemannSearch(s, tell, budget).run();
}

} // namespace kov::pullback
