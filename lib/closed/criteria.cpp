#include "closed/criteria.hpp"

#include "closed/criterion.hpp"
#include "closed/lame_criteria.hpp"
#include "closed/parts.hpp"
#include "closed/statement.hpp"
#include "exact/error.hpp"
#include "exact/lists.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace kov::strata {
namespace {

using Answer = std::variant<std::monostate, ClassicalAnswer, Needs>;

MFraction number(const Ring& ring, const Rational& c) { return {ring, c}; }

// ---- which equation it is

class Recognition {
public:
  Recognition(const Scheme& s, const ParametrisedSet& region)
      : s_(s), region_(region), parts_(region) {}

  Answer run() {
    if (!find_places()) return {};
    if (irregular_.empty()) return regular();
    if (irregular_.size() == 1 && squares_.size() <= 1) return confluent();
    if (irregular_.size() == 1 && squares_.size() == 2) return mathieu();
    return {};
  }

private:
  // False: a place that no classical equation has.
  bool find_places() {
    for (PlaceIndex i = 0; i < number_of_places(s_); ++i) {
      const ParametricPlace& p = place_at(s_, i);
      const long n = p.degree(s_.z);
      if (p.kind == PlaceKind::ordinary) continue;
      if (p.kind == PlaceKind::irregular || p.kind == PlaceKind::ramified) {
        if (n > 1) return false;
        irregular_.push_back(i);
        continue;
      }
      const auto square = square_at(p);
      if (!square || n > 3) return false;
      for (long k = 0; k < n; ++k)
        squares_.push_back(*square);
      numbers_.push_back(*square);
      regular_.push_back(i);
    }
    return true;
  }
  [[nodiscard]] std::optional<MFraction> square_at(const ParametricPlace& p) const {
    if (p.exponent == ExponentKind::rational) return number(ring(), p.delta * p.delta);
    if (p.chi.size() != 2) return std::nullopt;
    return -(p.chi[0] / p.chi[1]);
  }
  [[nodiscard]] const Ring& ring() const { return s_.r.ring(); }

  using Named = std::vector<std::pair<std::string, MFraction>>;
  ClassicalAnswer found(Classical family, Named squares, MFraction x,
                        std::optional<ClassicalEquation> equation = {}) {
    ClassicalForm form{family, std::move(squares), MFraction(ring()), 1};
    return {std::move(form), parts_.take(), std::move(x), std::move(equation)};
  }
  [[nodiscard]] MFraction variable() const { return MFraction::variable(ring(), s_.z); }

  Answer regular() {
    if (squares_.size() == 2) return euler(squares_[0]);
    if (squares_.size() != 3) return {};
    RiemannCriterion riemann(squares_, parts_);
    riemann.run();
    const Squares& s = riemann.squares();
    ClassicalEquation equation{s_.z, s_.r, {}, numbers_};
    for (const PlaceIndex i : regular_)
      if (!place_at(s_, i).at_infinity) equation.factors.push_back(place_at(s_, i).q);
    return found(Classical::riemann, {{"l", s[0]}, {"m", s[1]}, {"n", s[2]}}, variable(),
                 std::move(equation));
  }

  Answer euler(const MFraction& square) {
    if (!is_zero(square))
      if (auto doubt = region_.doubtful_factor(square.num()))
        return Needs{*std::move(doubt),
                     {.kind = Event::Kind::difference_is,
                      .place = name_of(place_at(s_, regular_[0]), s_.z)}};
    euler_criterion(parts_, square);
    return found(Classical::euler, {{"l", square}}, variable());
  }

  struct Moved {
    MFraction x, r;
  };
  // The irregular place goes to infinity.
  [[nodiscard]] Moved irregular_at_infinity() const {
    if (place_at(s_, irregular_[0]).at_infinity) return {variable(), s_.r};
    const MFraction x = variable();
    const MFraction c = root(irregular_[0]);
    return {pow(x - c, -1), substitute(s_.r, {{s_.z, c + pow(x, -1)}}) * pow(x, -4)};
  }
  [[nodiscard]] Moved shifted(const Moved& there, const MFraction& by) const {
    return {there.x - by, substitute(there.r, {{s_.z, variable() + by}})};
  }
  [[nodiscard]] MFraction root(PlaceIndex i) const {
    const auto line = coefficients(place_at(s_, i).q, s_.z);
    return -(MFraction(line[0]) / MFraction(line[1]));
  }
  // The irregular place goes to infinity and the regular one to 0.
  [[nodiscard]] Moved moved() const {
    const Moved there = irregular_at_infinity();
    if (regular_.empty() || place_at(s_, regular_[0]).at_infinity) return there;
    return shifted(there, substitute(there.x, {{s_.z, root(regular_[0])}}));
  }

  Answer confluent() {
    const long order = place_at(s_, irregular_[0]).order;
    const bool alone = squares_.empty();
    Moved there = moved();
    if (order == 3 && !alone) return ramified_bessel(std::move(there));
    const MFraction f = alone ? there.r : there.r * variable() * variable();
    if (uses(f.den(), s_.z)) return {};
    std::vector<MFraction> c;
    for (const MPoly& p : coefficients(f.num(), s_.z))
      c.push_back(MFraction(p) / MFraction(f.den()));
    if (alone) return polynomial(c, std::move(there.x));
    if (order != 4 || c.size() != 3) return {};
    return whittaker(std::move(there), c[1] * c[1] / (Rational(4) * c[2]),
                     Rational(1, 4) * squares_[0], c[2]);
  }

  // Two regular places at +-sqrt(d), a and q by the identity of recognition.md 7.
  Answer mathieu() {
    Moved there = irregular_at_infinity();
    const auto den = coefficients(there.r.den(), s_.z);
    if (den.size() != 5) return {};
    there = shifted(there, Rational(-1, 4) * (MFraction(den[3]) / MFraction(den[4])));
    const auto centred = coefficients(there.r.den(), s_.z);
    const MFraction d = Rational(-1, 2) * (MFraction(centred[2]) / MFraction(centred[4]));
    const MFraction square = variable() * variable();
    const MFraction line = there.r * (square - d) + Rational(3, 8) * ((square + d) / (square - d));
    const auto c = coefficients(line.num(), s_.z);
    if (uses(line.den(), s_.z) || c.size() != 2) return {};
    const MFraction alpha = MFraction(c[1]) / MFraction(line.den());
    parts_.add(GroupType::SL2, {}, words_of(Classical::mathieu).sl2);
    ClassicalAnswer answer =
        found(Classical::mathieu, {{"q", Rational(4) * (d * alpha * alpha)}}, std::move(there.x));
    answer.form.values = {{"a", Rational(4) * (MFraction(c[0]) / MFraction(line.den())) -
                                    number(ring(), Rational(1, 2))}};
    return answer;
  }

  Answer ramified_bessel(Moved there) {
    const MFraction m = squares_[0];
    ramified_bessel_criterion(parts_, m);
    ClassicalEquation equation{s_.z, std::move(there.r), {}, {m}};
    return found(Classical::bessel, {{"m", m}}, std::move(there.x), std::move(equation));
  }

  // r = a + ... for x = infinity.
  Answer whittaker(Moved there, const MFraction& k, const MFraction& m, const MFraction& a) {
    whittaker_criterion(parts_, k, m);
    ClassicalEquation equation{s_.z, std::move(there.r), {}, {k, m}};
    if (!is_zero(k))
      return found(Classical::whittaker, {{"k", k}, {"m", m}}, std::move(there.x),
                   std::move(equation));
    ClassicalAnswer bessel =
        found(Classical::bessel, {{"m", m}}, std::move(there.x), std::move(equation));
    bessel.scale = {"a", a};
    return bessel;
  }

  // c[0] + c[1] x + ... with c.back() != 0; Airy's and Weber's x is without the second term.
  Answer polynomial(const std::vector<MFraction>& c, MFraction x) {
    const long degree = static_cast<long>(c.size()) - 1;
    const bool even = degree > 0 && degree % 2 == 0;
    const MFraction e = even ? exponent_squared(c) : MFraction(ring());
    polynomial_criterion(parts_, degree, e);
    if (degree == 1 || degree == 2)
      x += Rational(1, degree) * c[static_cast<std::size_t>(degree) - 1] / c.back();
    ClassicalAnswer answer =
        found(polynomial_family(degree), even ? Named{{"a", e}} : Named{}, std::move(x));
    if (degree < 2) answer.scale = {degree == 0 ? "c" : "a", c.back()};
    return answer;
  }

  const Scheme& s_;
  const ParametrisedSet& region_;
  Parts parts_;
  std::vector<PlaceIndex> irregular_, regular_;
  Squares squares_; ///< of the differences at the regular places, one for each root
  Squares numbers_; ///< the same, one for each place
};

// ---- w = (z - c)^k

struct PowerForm {
  MFraction r, centre;
  long power = 1;
};

std::vector<MFraction> centres(const Scheme& s) {
  std::vector<MFraction> all;
  const auto add_mean = [&](const MPoly& f) { // of the roots of f
    const long n = kov::degree(f, s.z);
    if (n < 1) return;
    const auto c = coefficients(f, s.z);
    const auto at = static_cast<std::size_t>(n);
    MFraction mean = Rational(-1, n) * (MFraction(c[at - 1]) / MFraction(c[at]));
    add_once(all, std::move(mean));
  };
  MPoly product(s.r.ring(), Integer(1));
  for (const ParametricPlace& p : s.finite) {
    add_mean(p.q);
    product *= p.q;
  }
  add_mean(s.finite.empty() ? s.r.num() : product);
  return all;
}

// z^2 r as a function F of w = z^k, k the largest one: r_w = (F + 1/4)/(k w)^2 - 1/(4 w^2).
std::optional<PowerForm> in_power(const Scheme& s, const MFraction& centre) {
  const Ring& ring = s.r.ring();
  const MFraction t = MFraction::variable(ring, s.z);
  const MFraction f = substitute(s.r, {{s.z, t + centre}}) * t * t;
  const auto num = coefficients(f.num(), s.z);
  const auto den = coefficients(f.den(), s.z);
  std::vector<long> exponents;
  for (const auto* side : {&num, &den})
    for (std::size_t i = 0; i < side->size(); ++i)
      if (!is_zero((*side)[i])) exponents.push_back(static_cast<long>(i));
  long k = 0;
  for (const long e : exponents)
    k = std::gcd(k, e - exponents.front());
  if (k < 2) return std::nullopt;
  MFraction g(ring);
  MFraction below(ring);
  for (std::size_t i = 0; i < num.size(); ++i)
    if (!is_zero(num[i]))
      g += MFraction(num[i]) * pow(t, (static_cast<long>(i) - exponents.front()) / k);
  for (std::size_t i = 0; i < den.size(); ++i)
    if (!is_zero(den[i]))
      below += MFraction(den[i]) * pow(t, (static_cast<long>(i) - exponents.front()) / k);
  const MFraction quarter = number(ring, Rational(1, 4));
  return PowerForm{((g / below + quarter) * number(ring, Rational(1, k * k)) - quarter) / (t * t),
                   centre, k};
}

// The group of the pull-back, of finite index in the given one (strata.md 10.4).
void pull_back(Part& part, const Scheme& above) {
  if (!part.group) return;
  const bool ramified =
      std::ranges::any_of(above.finite,
                          [](const ParametricPlace& p) { return p.kind == PlaceKind::ramified; }) ||
      above.infinity.kind == PlaceKind::ramified;
  long regular = 0; // roots at which a quadratic extension may be ramified
  for (PlaceIndex i = 0; i < number_of_places(above); ++i)
    if (place_at(above, i).kind == PlaceKind::regular)
      regular += place_at(above, i).degree(above.z);
  switch (part.group->type) {
  case GroupType::SL2:
  case GroupType::Borel:
  case GroupType::Gm:
    return;
  case GroupType::T:
  case GroupType::cyclic:
    part.group->n.reset();
    return;
  case GroupType::Dinf:
    if (ramified) return;
    if (regular <= 1)
      part.group->type = GroupType::Gm;
    else
      part.group.reset();
    part.bound = GroupBound::torus_normaliser;
    return;
  default:
    part.group.reset();
    part.bound = GroupBound::finite;
  }
}

} // namespace

Answer classical_answer(const Scheme& s, const ParametrisedSet& region, const Budget& budget,
                        bool maps) {
  auto direct = Recognition(s, region).run();
  if (direct.index() != 0 || !maps) return direct;
  if (const auto lame = recognize_lame(s.r, s.z, budget)) {
    auto answer = lame_answer_on(*lame, region, budget);
    if (answer.index() != 0) return answer;
  }
  for (const MFraction& centre : centres(s)) {
    budget.check();
    const auto below = in_power(s, centre);
    if (!below || is_zero(below->r)) continue;
    auto places = scheme(below->r, s.z, region, budget);
    if (auto* needs = std::get_if<Needs>(&places)) return std::move(*needs);
    auto answer = Recognition(std::get<Scheme>(places), region).run();
    if (auto* found = std::get_if<ClassicalAnswer>(&answer)) {
      found->form.centre = centre;
      found->form.power = below->power;
      found->x = substitute(
          found->x, {{s.z, pow(MFraction::variable(s.r.ring(), s.z) - centre, below->power)}});
      for (Part& part : found->parts)
        pull_back(part, s);
    }
    if (answer.index() != 0) return answer;
  }
  return {};
}

} // namespace kov::strata
