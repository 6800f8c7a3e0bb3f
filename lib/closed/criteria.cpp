#include "closed/criteria.hpp"

#include "closed/kimura.hpp"
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

const Residues odd_integers{Rational(1), Rational(2)};
const Residues half_integers{Rational(1, 2), Rational(1)};

MFraction number(const Ring& ring, const Rational& c) { return {ring, c}; }

// ---- Riemann: kimura.md, 1 to 3

class RiemannParts {
public:
  RiemannParts(Squares squares, Parts& parts) : s_(std::move(squares)), parts_(parts) {
    std::stable_partition(s_.begin(), s_.end(),
                          [](const MFraction& x) { return constant_root(x).has_value(); });
    for (const MFraction& x : s_) {
      if (const auto root = constant_root(x))
        numbers_.push_back(*root);
      else if (!is_number(x))
        open_.push_back(x);
    }
  }

  void run() {
    parts_.split(
        SumIn{s_, {odd_integers}}, [&] { reducible(); }, [&] { irreducible(); });
  }
  [[nodiscard]] const Squares& squares() const { return s_; }

private:
  // l and m rational: so is n, and the order of y^k is that of (1+l)/2, (1+m)/2 (strata.md 10.2).
  void reducible() {
    const auto rational = std::ranges::count_if(
        s_, [&](const MFraction& x) { return parts_.known(AllRational{{x}}) == Truth::yes; });
    if (numbers_.size() < 2 && rational >= 2)
      return diagonal_or_not(GroupType::cyclic, GroupType::T);
    if (numbers_.size() < 2)
      return parts_.split(
          AllRational{s_}, [&] { diagonal_or_not(GroupType::cyclic, GroupType::T); },
          [&] { diagonal_or_not(GroupType::Gm, GroupType::Borel); });
    Integer n(1);
    for (std::size_t i = 0; i < 2; ++i)
      n = lcm(n, ((Rational(1) + numbers_[i]) * Rational(1, 2)).den());
    diagonal_or_not(GroupType::cyclic, GroupType::T, n);
  }
  void diagonal_or_not(GroupType diagonal, GroupType other, const std::optional<Integer>& n = {}) {
    parts_.split(
        WithoutLogarithm{s_}, [&] { parts_.add(diagonal, n); }, [&] { parts_.add(other, n); });
  }

  void irreducible() {
    const auto halves = static_cast<std::size_t>(
        std::ranges::count_if(numbers_, [](const Rational& x) { return x.den() == Integer(2); }));
    if (halves >= 2) return dihedral(halves);
    if (halves + open_.size() < 2) return primitive();
    parts_.split(
        InHalves{open_, 2 - halves}, [&] { dihedral(halves); }, [&] { primitive(); });
  }

  // The third place, beside two in 1/2 + Z, is rational or not.
  void dihedral(std::size_t halves) {
    if (halves == 1 && open_.size() == 1) { // the open one is in 1/2 + Z
      if (numbers_.size() < 2) return parts_.add(GroupType::Dinf);
      const bool first = numbers_[0].den() == Integer(2);
      return parts_.add(GroupType::D, numbers_[first ? 1 : 0].den());
    }
    std::optional<Integer> order;
    if (numbers_.size() == 3)
      order = std::max({numbers_[0].den(), numbers_[1].den(), numbers_[2].den()});
    parts_.split(
        AllRational{s_}, [&] { parts_.add(GroupType::D, order); },
        [&] { parts_.add(GroupType::Dinf); });
  }

  void primitive() { row(0); }
  void row(std::size_t i) {
    static constexpr std::array types{GroupType::A4, GroupType::S4, GroupType::A5};
    if (i == types.size()) return parts_.add(GroupType::SL2);
    const auto there = [&] { parts_.add(types[i]); };
    const auto next = [&] { row(i + 1); };
    if (numbers_.size() < 2 || open_.size() != 1)
      return parts_.split(InRow{s_, types[i]}, there, next);
    const auto classes = thirds(types[i]);
    if (classes.empty()) return next();
    parts_.split(SumIn{{open_[0]}, classes}, there, next);
  }

  // The third exponents of the rows with the first two; they matter up to sign and modulo 2.
  [[nodiscard]] std::vector<Residues> thirds(GroupType type) const {
    std::vector<Rational> found;
    for (long d = 2; d <= 5; ++d)
      for (long j = 1; j < d; ++j) {
        const Rational x(j, d);
        const SchwarzClass* c = schwarz_class({numbers_[0], numbers_[1], x});
        if (x.den() == Integer(d) && c != nullptr && c->group == type) found.push_back(x);
      }
    std::vector<Residues> classes;
    for (const Rational& x : found) {
      const Rational other = Rational(1) - x;
      const bool both = is_among(other, found);
      if (both && other < x) continue;
      classes.push_back({x, Rational(both ? 1 : 2)});
    }
    return classes;
  }

  Squares s_; ///< rational numbers first
  Parts& parts_;
  std::vector<Rational> numbers_;
  Squares open_; ///< those that depend on parameters
};

// ---- which equation it is

class Recognition {
public:
  Recognition(const Scheme& s, const Region& region) : s_(s), region_(region), parts_(region) {}

  Answer run() {
    if (!find_places()) return {};
    if (irregular_.empty()) return regular();
    if (irregular_.size() == 1 && squares_.size() <= 1) return confluent();
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
  Answer found(Classical family, Named squares, std::optional<ClassicalEquation> equation = {}) {
    ClassicalForm form{family, std::move(squares), MFraction(ring()), 1};
    return ClassicalAnswer{std::move(form), parts_.take(), std::move(equation)};
  }
  [[nodiscard]] MFraction variable() const { return MFraction::variable(ring(), s_.z); }

  Answer regular() {
    if (squares_.size() == 2) return euler(squares_[0]);
    if (squares_.size() != 3) return {};
    RiemannParts riemann(squares_, parts_);
    riemann.run();
    const Squares& s = riemann.squares();
    ClassicalEquation equation{s_.z, variable(), s_.r, {}, numbers_};
    for (const PlaceIndex i : regular_)
      if (!place_at(s_, i).at_infinity) equation.factors.push_back(place_at(s_, i).q);
    return found(Classical::riemann, {{"l", s[0]}, {"m", s[1]}, {"n", s[2]}}, std::move(equation));
  }

  Answer euler(const MFraction& square) {
    if (is_zero(square)) {
      parts_.add(GroupType::T, Integer(2));
    } else {
      if (auto doubt = region_.doubtful_factor(square.num()))
        return Needs{*std::move(doubt),
                     {.kind = Event::Kind::difference_is,
                      .place = name_of(place_at(s_, regular_[0]), s_.z)}};
      parts_.split(
          AllRational{{square}}, [&] { parts_.add(GroupType::cyclic); },
          [&] { parts_.add(GroupType::Gm); });
    }
    return found(Classical::euler, {{"l", square}});
  }

  // The irregular place goes to infinity and the regular one to 0.
  [[nodiscard]] ClassicalEquation moved() const {
    const MFraction x = variable();
    const auto root = [&](PlaceIndex i) {
      const auto line = coefficients(place_at(s_, i).q, s_.z);
      return -(MFraction(line[0]) / MFraction(line[1]));
    };
    const ParametricPlace& irregular = place_at(s_, irregular_[0]);
    const bool other = !regular_.empty();
    MFraction r = s_.r;
    MFraction change = x;
    MFraction shift(ring());
    if (!irregular.at_infinity) {
      const MFraction c = root(irregular_[0]);
      change = pow(x - c, -1);
      r = substitute(r, {{s_.z, c + pow(x, -1)}}) * pow(x, -4);
      if (other && !place_at(s_, regular_[0]).at_infinity) shift = pow(root(regular_[0]) - c, -1);
    } else if (other) {
      shift = root(regular_[0]);
    }
    return {s_.z, change - shift, substitute(r, {{s_.z, x + shift}}), {}, {}};
  }

  Answer confluent() {
    const long order = place_at(s_, irregular_[0]).order;
    const bool alone = squares_.empty();
    if (order == 3 && !alone) return ramified_bessel(squares_[0]);
    const MFraction x = variable();
    ClassicalEquation equation = moved();
    const MFraction f = alone ? equation.r : equation.r * x * x;
    if (uses(f.den(), s_.z)) return {};
    std::vector<MFraction> c;
    for (const MPoly& p : coefficients(f.num(), s_.z))
      c.push_back(MFraction(p) / MFraction(f.den()));
    if (alone) return polynomial(c);
    if (order != 4 || c.size() != 3) return {};
    equation.numbers = {c[1] * c[1] / (Rational(4) * c[2]), Rational(1, 4) * squares_[0]};
    return whittaker(std::move(equation));
  }

  Answer ramified_bessel(const MFraction& m) {
    parts_.split(
        SumIn{{m}, {half_integers}}, [&] { parts_.add(GroupType::Dinf); },
        [&] { parts_.add(GroupType::SL2); });
    ClassicalEquation equation = moved();
    equation.numbers = {m};
    return found(Classical::bessel, {{"m", m}}, std::move(equation));
  }

  Answer whittaker(ClassicalEquation equation) {
    const MFraction k = equation.numbers[0];
    const MFraction m = equation.numbers[1];
    const auto gm = [&] { parts_.add(GroupType::Gm); };
    const auto sl2 = [&] { parts_.add(GroupType::SL2); };
    if (is_zero(k)) {
      parts_.split(SumIn{{m}, {half_integers}}, gm, sl2);
      return found(Classical::bessel, {{"m", m}}, std::move(equation));
    }
    const auto reducible = [&] {
      parts_.split(Separated{{Rational(4) * m, Rational(4) * k}}, gm,
                   [&] { parts_.add(GroupType::Borel); });
    };
    parts_.split(SumIn{{k, m}, {half_integers}}, reducible, sl2);
    return found(Classical::whittaker, {{"k", k}, {"m", m}}, std::move(equation));
  }

  // c[0] + c[1] x + ... with c.back() != 0.
  Answer polynomial(const std::vector<MFraction>& c) {
    const std::size_t degree = c.size() - 1;
    if (degree == 0) {
      parts_.add(GroupType::Gm);
      return found(Classical::constant, {});
    }
    if (degree % 2 == 1) {
      parts_.add(GroupType::SL2);
      return found(degree == 1 ? Classical::airy : Classical::polynomial, {});
    }
    const MFraction e = exponent_squared(c);
    const auto nu = static_cast<long>(degree / 2);
    parts_.split(
        SumIn{{e}, {{Rational(nu), Rational(2)}}},
        [&] {
          if (degree == 2)
            parts_.add(GroupType::Borel);
          else
            parts_.add(Truth::no, GroupBound::SL2_or_Borel);
        },
        [&] { parts_.add(GroupType::SL2); });
    return found(degree == 2 ? Classical::weber : Classical::polynomial, {{"a", e}});
  }

  // r = u q(x)^2 + b x^(nu-1) + ..., q monic of degree nu: b^2/u.
  [[nodiscard]] static MFraction exponent_squared(const std::vector<MFraction>& c) {
    const std::size_t nu = (c.size() - 1) / 2;
    const MFraction& u = c.back();
    const Ring& ring = u.ring();
    std::vector<MFraction> q(nu + 1, MFraction(ring)); // descending
    q[0] = number(ring, Rational(1));
    const auto product = [&](std::size_t k) { // of q and q at x^(2 nu - k), without q_0 q_k
      MFraction sum(ring);
      for (std::size_t i = 1; i < k; ++i)
        if (i <= nu && k - i <= nu) sum += q[i] * q[k - i];
      return sum;
    };
    for (std::size_t k = 1; k <= nu; ++k)
      q[k] = Rational(1, 2) * (c[2 * nu - k] / u - product(k));
    const MFraction b = c[nu - 1] - u * product(nu + 1);
    return b * b / u;
  }

  const Scheme& s_;
  const Region& region_;
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

Answer classical_answer(const Scheme& s, const Region& region, const Budget& budget, bool maps) {
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
      if (auto& equation = found->equation)
        equation->change =
            substitute(equation->change,
                       {{s.z, pow(MFraction::variable(s.r.ring(), s.z) - centre, below->power)}});
      for (Part& part : found->parts)
        pull_back(part, s);
    }
    if (answer.index() != 0) return answer;
  }
  return {};
}

} // namespace kov::strata
