#include "kovacic/residue_field.hpp"
#include "pullback/local.hpp"
#include "pullback/standard.hpp"

#include <algorithm>

namespace kov::pullback {

RationalFunction pulled_back(const RationalFunction& r, const RationalFunction& f) {
  const RationalFunction slope = derivative(f);
  const RationalFunction u = derivative(slope) / slope;
  const RationalFunction half(Rational(1, 2));
  const RationalFunction schwarzian = derivative(u) - u * u * half;
  return slope * slope * compose(r, f) - schwarzian * half;
}

namespace {

// One place of f: a f^3 = (9/4) (phase)^2, so that the principal part of f and its constant are
// known but for a cube root.
struct Pole {
  Point point;
  long order = 0;      // of f
  Poly cube;           // a f0^3
  ResidueSeries terms; // of f/f0
};

std::optional<std::vector<Pole>> poles_of(const Singularities& s) {
  std::vector<Pole> all;
  for (const Singularity* place : irregular_places(s)) {
    const Phase p = phase(s.r, *place);
    if (p.pole % 3 != 0) return std::nullopt;
    const Point point = point_of(*place);
    all.push_back({point, p.pole / 3, scale(p.leading, NfElem(Rational(9, 4))),
                   power(p.terms, Rational(1, 3), point.q)});
  }
  return all;
}

// f from its parts; the constant is read off at one place.
std::optional<RationalFunction> assembled(const std::vector<Pole>& poles,
                                          const std::vector<Poly>& leading) {
  RationalFunction f;
  ResidueSeries last;
  for (std::size_t i = 0; i < poles.size(); ++i) {
    last.clear();
    for (const Poly& c : poles[i].terms)
      last.push_back(c * leading[i] % poles[i].point.q);
    f += principal_part(last, poles[i].order, poles[i].point);
  }
  const Pole& at = poles.back();
  const auto index = static_cast<std::size_t>(at.order);
  const Laurent here = laurent(f, at.point, at.order + 1);
  const Poly constant = last.at(index) - here.terms.at(index);
  if (degree(constant) > 0) return std::nullopt;
  return f + RationalFunction(constant);
}

class AirySearch {
public:
  AirySearch(std::vector<Pole> poles, NfElem a, const Try& tell, const Budget& budget)
      : poles_(std::move(poles)), a_(std::move(a)), tell_(tell), budget_(budget) {}

  bool run() {
    if (leading_.size() == poles_.size()) {
      const auto f = assembled(poles_, leading_);
      return f && tell_({Classical::airy, RationalFunction(scale(Poly::z(), a_)), *f});
    }
    const Pole& next = poles_[leading_.size()];
    const Poly cube = scale(next.cube, inverse(a_));
    for (const Poly& root : roots_of(cube, 3, next.point.q, budget_)) {
      budget_.check();
      leading_.push_back(root);
      const bool done = run();
      leading_.pop_back();
      if (done) return true;
      if (leading_.empty()) return false; // a cube root of unity in f changes nothing
    }
    return false;
  }

private:
  std::vector<Pole> poles_;
  NfElem a_;
  const Try& tell_;
  const Budget& budget_;
  std::vector<Poly> leading_;
};

} // namespace

bool try_airy(const Singularities& s, const Try& tell, const Budget& budget) {
  auto poles = poles_of(s);
  if (!poles || poles->empty()) return false;
  std::ranges::stable_sort(
      *poles, [](const Pole& p, const Pole& q) { return degree(p.point.q) < degree(q.point.q); });
  const Pole& first = poles->front();
  const long n = degree(first.point.q);
  // a matters up to cubes: N(a f0^3) = a^n N(f0)^3
  std::vector<NfElem> constants;
  const NfElem norm = kovacic::norm(first.cube, first.point.q);
  if (n % 3 == 1) constants = {norm};
  if (n % 3 == 2) constants = {norm * norm};
  if (n % 3 == 0) constants = {NfElem(1)};
  for (const NfElem& a : constants)
    if (AirySearch(*poles, a, tell, budget).run()) return true;
  return false;
}

} // namespace kov::pullback
