#include "strata/exponential_families.hpp"

#include "exact/factor.hpp"
#include "exact/ideal.hpp"
#include "exact/linear.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"
#include "parameters/statement.hpp"

#include <algorithm>

namespace kov::strata {
namespace {

constexpr std::size_t most_choices = 4096;

// The summands of one choice at one place in a family.
struct Contribution {
  MFraction omega, degree, exponent;
  std::optional<std::pair<MPoly, MFraction>> power;
};
using Choices = std::vector<Contribution>;

// f = sum of f_k t^k, k <= n; f has no pole at t = 0.
std::vector<MFraction> taylor(const MFraction& f, std::size_t t, std::size_t n) {
  const auto num = coefficients(f.num(), t);
  const auto den = coefficients(f.den(), t);
  std::vector<MFraction> out;
  for (std::size_t k = 0; k <= n; ++k) {
    MFraction c = k < num.size() ? MFraction(num[k]) : MFraction(f.ring());
    for (std::size_t i = 1; i <= k && i < den.size(); ++i)
      c -= MFraction(den[i]) * out[k - i];
    out.push_back(c / MFraction(den.at(0)));
  }
  return out;
}

// The square root of a power series; unset: that of its first term is not a function of the parameters.
std::optional<std::vector<MFraction>> root_of_series(const std::vector<MFraction>& g) {
  const auto first = square_root(g.at(0));
  if (!first) return std::nullopt;
  std::vector<MFraction> s{*first};
  for (std::size_t k = 1; k < g.size(); ++k) {
    MFraction c = g[k];
    for (std::size_t i = 1; i < k; ++i)
      c -= s[i] * s[k - i];
    s.push_back(Rational(1, 2) * c / *first);
  }
  return s;
}

class Builder {
public:
  Builder(const Scheme& s, const Budget& budget)
      : s_(s), budget_(budget), z_(MFraction::variable(s.r.ring(), s.z)) {}

  ExponentialFamilies run() {
    std::vector<Choices> all;
    std::size_t count = 1;
    for (std::size_t i = 0; i < number_of_places(s_); ++i) {
      const ParametricPlace& p = place_at(s_, i);
      auto here = choices(p);
      if (!here) return {{}, missing_};
      if (here->empty()) return {}; // a ramified place: no exponential solution
      count *= here->size();
      if (count > most_choices) return {{}, "there are more than 4096 choices of exponents"};
      all.push_back(*std::move(here));
    }
    ExponentialFamilies found;
    combine(all, 0, {zero(), zero(), {}, zero()}, found);
    return found;
  }

private:
  [[nodiscard]] MFraction number(const Rational& c) const { return {s_.r.ring(), c}; }
  [[nodiscard]] MFraction zero() const { return MFraction(s_.r.ring()); }

  std::optional<Choices> fail(const ParametricPlace& p, const std::string& why) {
    missing_ = why + " (" + place_name(p, s_.z) + ")";
    return std::nullopt;
  }

  std::optional<Choices> choices(const ParametricPlace& p) {
    if (p.kind == PlaceKind::ramified) return Choices{};
    if (p.kind == PlaceKind::irregular)
      return p.at_infinity ? irregular_infinity(p) : irregular_pole(p);
    const auto exponents = regular_exponents(p);
    if (!exponents) return fail(p, "the exponents there are no functions of the parameters");
    if (!p.at_infinity && exponents->size() > 1 && p.degree(s_.z) > 1)
      return fail(p, "conjugate points may take different exponents");
    Choices all;
    for (const MFraction& e : *exponents)
      all.push_back(p.at_infinity ? Contribution{zero(), e, zero(), {}} : at_pole(p, e));
    return all;
  }

  // The exponents at a pole; at infinity 1 - exponent, so that degrees are differences.
  [[nodiscard]] std::optional<std::vector<MFraction>>
  regular_exponents(const ParametricPlace& p) const {
    const Rational half(1, 2);
    if (p.at_infinity && p.kind != PlaceKind::regular)
      return std::vector<MFraction>{number(0), number(1)};
    if (p.kind == PlaceKind::simple) return std::vector<MFraction>{number(1)};
    const auto delta = difference(p);
    if (!delta) return std::nullopt;
    if (is_zero(*delta)) return std::vector<MFraction>{number(half)};
    return std::vector<MFraction>{half * (number(1) + *delta), half * (number(1) - *delta)};
  }

  [[nodiscard]] std::optional<MFraction> difference(const ParametricPlace& p) const {
    if (p.exponent == ExponentKind::rational) return number(p.delta);
    if (p.chi.size() != 2) return std::nullopt;
    return square_root(-p.chi[0] / p.chi[1]);
  }

  [[nodiscard]] Contribution at_pole(const ParametricPlace& p, const MFraction& alpha) const {
    const MFraction q(p.q);
    return {alpha * derivative(q, s_.z) / q, number(Rational(-p.degree(s_.z))) * alpha, zero(),
            std::pair(p.q, alpha)};
  }

  // r = z^(2 nu) (g_0 + g_1/z + ...)
  std::optional<Choices> irregular_infinity(const ParametricPlace& p) {
    const long nu = p.order / 2 - 2;
    const MFraction inverse = number(1) / z_;
    const MFraction g = substitute(s_.r, {{s_.z, inverse}}) * pow(z_, 2 * nu);
    const auto root = root_of_series(taylor(g, s_.z, static_cast<std::size_t>(nu) + 1));
    if (!root)
      return fail(p, "the leading coefficient is not a square of a function of the parameters");
    MFraction w = zero();
    MFraction integral = zero();
    for (long i = 0; i <= nu; ++i) {
      const MFraction& c = (*root)[static_cast<std::size_t>(i)];
      w += c * pow(z_, nu - i);
      integral += c * pow(z_, nu - i + 1) * number(Rational(1, nu - i + 1));
    }
    const MFraction& b = root->back();
    const MFraction middle = number(Rational(-nu, 2));
    return Choices{{w, middle + b, integral, {}}, {-w, middle - b, -integral, {}}};
  }

  // r = (z - c)^(-2 nu) (g_0 + g_1 (z - c) + ...)
  std::optional<Choices> irregular_pole(const ParametricPlace& p) {
    if (p.degree(s_.z) != 1) return fail(p, "an irregular place at conjugate points");
    const auto linear = coefficients(p.q, s_.z);
    const MFraction c = -MFraction(linear[0]) / MFraction(linear[1]);
    const long nu = p.order / 2;
    const MFraction g = substitute(s_.r, {{s_.z, z_ + c}}) * pow(z_, 2 * nu);
    const auto root = root_of_series(taylor(g, s_.z, static_cast<std::size_t>(nu) - 1));
    if (!root)
      return fail(p, "the leading coefficient is not a square of a function of the parameters");
    MFraction w = zero();
    MFraction integral = zero();
    for (long i = 0; i + 2 <= nu; ++i) {
      const MFraction& a = (*root)[static_cast<std::size_t>(i)];
      w += a * pow(z_ - c, i - nu);
      integral += a * pow(z_ - c, i - nu + 1) * number(Rational(1, i - nu + 1));
    }
    Choices all;
    for (const long sign : {1L, -1L}) {
      const MFraction alpha = number(Rational(nu, 2)) + number(Rational(sign)) * root->back();
      Contribution here = at_pole(p, alpha);
      here.omega += number(Rational(sign)) * w;
      here.exponent = number(Rational(sign)) * integral;
      all.push_back(std::move(here));
    }
    return all;
  }

  void combine(const std::vector<Choices>& all, std::size_t i, const ExponentialFamily& sum,
               ExponentialFamilies& found) const {
    budget_.check();
    if (i == all.size()) {
      found.all.push_back(sum);
      return;
    }
    for (const Contribution& c : all[i]) {
      ExponentialFamily next = sum;
      next.omega += c.omega;
      next.degree += c.degree;
      next.exponent += c.exponent;
      if (c.power) next.powers.push_back(*c.power);
      combine(all, i + 1, next, found);
    }
  }

  const Scheme& s_;
  const Budget& budget_;
  MFraction z_;
  std::string missing_;
};

// Rows of a linear system for p_0, ..., p_(d-1); the last entry is the constant term.
using Row = std::vector<MFraction>;

// Unknowns are eliminated as long as some coefficient vanishes nowhere on the stratum.
class Elimination {
public:
  Elimination(std::vector<Row> rows, const ParametrisedSet& region, const Budget& budget)
      : rows_(std::move(rows)), is_solved_(rows_.size()), region_(region), budget_(budget) {}

  [[nodiscard]] std::optional<PolynomialPart> run(std::size_t unknowns, const Ring& ring) {
    std::vector<Place> solved;
    while (const auto pivot = next_pivot(unknowns)) {
      budget_.check();
      clear_column(rows_, pivot->first, pivot->second);
      is_solved_[pivot->first] = true;
      solved.push_back(*pivot);
    }
    if (solved.size() != unknowns) return std::nullopt;
    PolynomialPart part;
    part.p.assign(unknowns, MFraction(ring));
    for (const auto& [i, j] : solved)
      part.p[j] = -rows_[i].back();
    part.p.push_back(MFraction(ring, Rational(1)));
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (const MPoly g = rows_[i].back().num(); !is_solved_[i] && !is_zero(g))
        part.conditions.push_back(sign(g.coefficient(0)) < 0 ? -g : g);
    return part;
  }

private:
  using Place = std::pair<std::size_t, std::size_t>;

  // Constants first, those of the highest powers of z before others: each brings one unknown less
  // with it.  Then the shortest.
  [[nodiscard]] std::optional<Place> next_pivot(std::size_t unknowns) const {
    for (std::size_t i = rows_.size(); i-- > 0;)
      for (std::size_t j = 0; !is_solved_[i] && j < unknowns; ++j)
        if (is_constant(rows_[i][j]) && !is_zero(rows_[i][j])) return Place(i, j);
    std::optional<Place> best;
    long length = 0;
    for (std::size_t i = rows_.size(); i-- > 0;)
      for (std::size_t j = 0; !is_solved_[i] && j < unknowns; ++j) {
        const MFraction& x = rows_[i][j];
        const long here = is_zero(x) ? 0 : x.num().length() + x.den().length();
        if (here == 0 || (best && here >= length) || !region_.provably_nonzero(x.num())) continue;
        best = Place(i, j);
        length = here;
      }
    return best;
  }

  std::vector<Row> rows_;
  std::vector<bool> is_solved_;
  const ParametrisedSet& region_;
  const Budget& budget_;
};

// The equation for P, cleared of denominators: what multiplies P'', P' and P.
struct Operator {
  MPoly second, first, zeroth;
};

Operator operator_of(const Scheme& s, const ExponentialFamily& f) {
  const MFraction first = Rational(2) * f.omega;
  const MFraction zeroth = derivative(f.omega, s.z) + f.omega * f.omega - s.r;
  const MPoly common = exact_div(first.den() * zeroth.den(), gcd(first.den(), zeroth.den()));
  return {common, (first * MFraction(common)).num(), (zeroth * MFraction(common)).num()};
}

// The coefficients of the operator applied to z^i.
std::vector<MFraction> applied(const Operator& op, std::size_t z, long i) {
  const Ring& ring = op.second.ring();
  const MFraction x = MFraction::variable(ring, z);
  MFraction sum = MFraction(op.zeroth) * pow(x, i);
  if (i >= 1) sum += Rational(i) * MFraction(op.first) * pow(x, i - 1);
  if (i >= 2) sum += Rational(i * (i - 1)) * MFraction(op.second) * pow(x, i - 2);
  std::vector<MFraction> out;
  const MFraction below(sum.den());
  for (const MPoly& c : coefficients(sum.num(), z))
    out.push_back(MFraction(c) / below);
  return out;
}

// Verifies by other code than the elimination: theta' + theta^2 = r for theta = omega + P'/P.
void verify(const Scheme& s, const ExponentialFamily& f, const PolynomialPart& part,
            const Budget& budget) {
  const MFraction x = MFraction::variable(s.r.ring(), s.z);
  MFraction p(s.r.ring());
  for (std::size_t i = 0; i < part.p.size(); ++i)
    p += part.p[i] * pow(x, static_cast<long>(i));
  const MFraction theta = f.omega + derivative(p, s.z) / p;
  const MFraction rest = derivative(theta, s.z) + theta * theta - s.r;
  if (is_zero(rest)) return;
  const std::vector<std::size_t> main = used_by_any(part.conditions);
  KOV_ENSURE(!main.empty() &&
             Ideal(s.r.ring(), main, part.conditions, {}, budget).contains(rest.num()));
}

} // namespace

ExponentialFamilies families_of_exponents(const Scheme& s, const Budget& budget) {
  return Builder(s, budget).run();
}

PolynomialPart polynomial_part(const Scheme& s, const ExponentialFamily& f, long d,
                               const ParametrisedSet& region, const Budget& budget) {
  const auto unknowns = static_cast<std::size_t>(d);
  const Ring& ring = s.r.ring();
  const Operator op = operator_of(s, f);
  std::vector<Row> rows;
  for (std::size_t i = 0; i <= unknowns; ++i) {
    const auto column = applied(op, s.z, static_cast<long>(i));
    if (column.size() > rows.size()) rows.resize(column.size(), Row(unknowns + 1, MFraction(ring)));
    for (std::size_t k = 0; k < column.size(); ++k)
      rows[k][i] = column[k];
  }
  auto part = Elimination(std::move(rows), region, budget).run(unknowns, ring);
  if (!part) return {{}, {}, "a coefficient of the linear system for P may vanish"};
  const bool exists = std::ranges::none_of(part->conditions,
                                           [](const MPoly& g) { return is_constant(g); }); // 1 = 0
  if (exists) verify(s, f, *part, budget);
  return *std::move(part);
}

namespace {

// A natural number that is small enough; unset: another number; no value: it depends on the parameters.
std::optional<std::optional<long>> degree_of(const ExponentialFamily& f) {
  if (!is_zero(f.degree) && !is_constant(f.degree)) return std::nullopt;
  const Rational d = is_zero(f.degree) ? Rational(0) : to_rational(f.degree);
  if (!is_integer(d) || sign(d) < 0) return std::optional<long>();
  constexpr long most_degree = 20;
  if (d > Rational(most_degree)) return std::nullopt;
  return std::optional(to_long(d.num()));
}

// A factor of one of them that may vanish.  All of them must for a solution: unset where one is known not to.
std::optional<MPoly> in_doubt(const std::vector<MPoly>& conditions, const ParametrisedSet& region) {
  std::optional<MPoly> shortest;
  for (const MPoly& g : conditions) {
    if (is_constant(g) || region.provably_nonzero(g)) return std::nullopt;
    for (const MFactor& f : factor(g).second)
      if (!region.provably_nonzero(f.base) && (!shortest || f.base.length() < shortest->length()))
        shortest = f.base;
  }
  return shortest;
}

} // namespace

ExponentialSolutions exponential_solutions(const Scheme& s, const ParametrisedSet& region,
                                           const Budget& budget) {
  const ExponentialFamilies families = families_of_exponents(s, budget);
  ExponentialSolutions found;
  found.none = families.missing.empty();
  for (const ExponentialFamily& f : families.all) {
    const auto degree = degree_of(f);
    if (degree && !*degree) continue;
    if (!degree) {
      found.none = false;
      continue;
    }
    const PolynomialPart part = polynomial_part(s, f, **degree, region, budget);
    if (part.open.empty() && part.conditions.empty()) {
      MFraction p(s.r.ring());
      for (std::size_t i = part.p.size(); i-- > 0;)
        p = p * MFraction::variable(s.r.ring(), s.z) + part.p[i];
      return {.w = f.omega + derivative(p, s.z) / p, .needs = {}};
    }
    const auto doubt = in_doubt(part.conditions, region);
    if (doubt && !found.needs) found.needs = doubt;
    found.none = found.none && part.open.empty() && !doubt;
  }
  return found;
}

} // namespace kov::strata
