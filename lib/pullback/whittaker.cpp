// y'' = (a + b/x + c/x^2) y behind x = f(z): a f^2 = (phase)^2, so that f is known up to signs and
// a constant, which makes a place of r or a critical point of f a zero.

#include "exact/factor.hpp"
#include "exact/lists.hpp"
#include "kovacic/residue_field.hpp"
#include "pullback/local.hpp"
#include "pullback/standard.hpp"
#include "pullback/zeros.hpp"

#include <algorithm>

namespace kov::pullback {
namespace {

constexpr std::size_t most_poles = 6;

struct DoublePole {
  const Singularity* place = nullptr;
  Point point;
  long order = 0;
  Poly square;         // a f0^2
  ResidueSeries terms; // of f/f0
};

std::optional<std::vector<DoublePole>> double_poles(const Singularities& s) {
  std::vector<DoublePole> all;
  for (const Singularity* place : irregular_places(s)) {
    if (place->kind == PlaceKind::ramified) return std::nullopt;
    const Phase p = phase(s.r, *place);
    const Point point = point_of(*place);
    all.push_back({place, point, p.pole / 2, p.leading, power(p.terms, Rational(1, 2), point.q)});
  }
  return all;
}

// The constants that a zero of f may subtract.
std::vector<NfElem> constants(const RationalFunction& f, const Singularities& s,
                              const Budget& budget) {
  std::vector<NfElem> found;
  const auto add = [&](const std::optional<NfElem>& value) {
    if (value && !is_among(*value, found)) found.push_back(*value);
  };
  for (const Singularity& place : s.finite)
    if (is_lasting(place)) add(value_at(f, place.place));
  add(value_at_infinity(f));
  for (const Factor& critical : irreducible_factors(derivative(f).num(), budget))
    add(value_at(f, critical.base));
  return found;
}

// In x = g with f = k g^2 Whittaker's equation with D = 1/2 is u'' = (4 k^2 a x^2 + 4 k b) u.
std::optional<Candidate> as_weber(const NfElem& a, const NfElem& b, const NfElem& square,
                                  const RationalFunction& f) {
  if (!(square == NfElem(Rational(1, 4)))) return std::nullopt;
  const auto above = exact_sqrt(monic(f.num()));
  const auto below = exact_sqrt(f.den());
  if (!above || !below) return std::nullopt;
  const NfElem k = lead(f.num());
  const NfElem four(4);
  return Candidate{Classical::weber,
                   RationalFunction(Poly::monomial(four * k * k * a, 2) + Poly(four * k * b)),
                   RationalFunction(*above, *below)};
}

class WhittakerSearch {
public:
  WhittakerSearch(const Singularities& s, std::vector<DoublePole> poles, NfElem a, const Try& tell,
                  const Budget& budget)
      : s_(s), poles_(std::move(poles)), a_(std::move(a)), tell_(tell), budget_(budget) {}

  bool run() {
    if (leading_.size() == poles_.size()) return with_slope();
    const DoublePole& next = poles_[leading_.size()];
    const Poly square = scale(next.square, inverse(a_));
    const auto root = square_root(square, next.point.q);
    if (!root) return false;
    for (const Poly& sign : {*root, -*root}) {
      leading_.push_back(sign);
      const bool done = run();
      leading_.pop_back();
      if (done) return true;
      if (leading_.empty()) break; // f and -f with b and -b are the same
    }
    return false;
  }

private:
  [[nodiscard]] std::optional<Poly> square_root(const Poly& square, const Poly& q) const {
    if (degree(q) > 1) return kovacic::square_root(square, q, budget_);
    const auto root = exact_sqrt(square.coeff(0));
    return root ? std::optional(Poly(*root)) : std::nullopt;
  }

  bool with_slope() {
    RationalFunction f;
    for (std::size_t i = 0; i < poles_.size(); ++i) {
      ResidueSeries terms;
      for (const Poly& c : poles_[i].terms)
        terms.push_back(c * leading_[i] % poles_[i].point.q);
      f += principal_part(terms, poles_[i].order, poles_[i].point);
    }
    for (const NfElem& value : constants(f, s_, budget_)) {
      budget_.check();
      if (with(f - RationalFunction(Poly(value)))) return true;
    }
    return false;
  }

  // b by the residue of sqrt(r) at a pole of f of least order l: b = beta/(l^2 f0) + j sqrt(a)/l.
  [[nodiscard]] std::vector<NfElem> values_of_b() const {
    std::size_t least = 0;
    for (std::size_t i = 1; i < poles_.size(); ++i)
      if (poles_[i].order < poles_[least].order) least = i;
    const DoublePole& p = poles_[least];
    const Poly value = p.place->beta * inverse_mod(leading_[least], p.point.q) % p.point.q;
    if (degree(value) > 0) return {};
    const NfElem l(p.order);
    std::vector<NfElem> found{value.coeff(0) / (l * l)};
    if (const auto root = exact_sqrt(a_))
      for (long j = 1; j < 2 * p.order; ++j)
        found.push_back(found.front() + NfElem(j % 2 == 1 ? (j + 1) / 2 : -j / 2) * *root / l);
    return found;
  }

  bool with(const RationalFunction& f) {
    for (const NfElem& square : squares_at_zero(zeros_of(f, s_, budget_)))
      for (const NfElem& b : values_of_b()) {
        budget_.check();
        const Poly x = Poly::z();
        const NfElem c = (square - NfElem(1)) / NfElem(4);
        const auto weber = as_weber(a_, b, square, f);
        if (tell_(weber
                      ? *weber
                      : Candidate{is_zero(b) ? Classical::bessel : Classical::whittaker,
                                  RationalFunction(scale(x * x, a_) + scale(x, b) + Poly(c), x * x),
                                  f}))
          return true;
      }
    return false;
  }

  const Singularities& s_;
  std::vector<DoublePole> poles_;
  NfElem a_;
  const Try& tell_;
  const Budget& budget_;
  std::vector<Poly> leading_;
};

} // namespace

bool try_whittaker(const Singularities& s, const Try& tell, const Budget& budget) {
  auto poles = double_poles(s);
  if (!poles || poles->empty() || poles->size() > most_poles) return false;
  std::ranges::stable_sort(*poles, [](const DoublePole& p, const DoublePole& q) {
    return degree(p.point.q) < degree(q.point.q);
  });
  const DoublePole& first = poles->front();
  for (const NfElem& a : kovacic::square_classes(first.square, first.point.q))
    if (WhittakerSearch(s, *poles, a, tell, budget).run()) return true;
  return false;
}

} // namespace kov::pullback
