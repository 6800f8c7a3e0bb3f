#include "classify/darboux_points.hpp"

#include "classify/components.hpp"
#include "exact/error.hpp"
#include "literature/literature.hpp"
#include "special/potential.hpp"

#include <algorithm>
#include <set>

namespace kov {
namespace {

constexpr long most_table_entries = 100000;
constexpr long largest_degree = 8;
constexpr long most_lost = 2; // points at double zeros of V

// ---- the table

// Lambda != 0 of the table, up to `most`.
std::vector<Rational> table_values(const EigenvalueTable& table, const Rational& most,
                                   const Budget& budget) {
  std::set<Rational> values;
  for (const EigenvalueFamily& f : table.families)
    for (const long step : {1L, -1L})
      for (long p = step > 0 ? 0 : -1;; p += step) {
        const Rational slope = (f.u + f.v * Rational(p)) * Rational(step) * f.v;
        const Rational value = f.at(Integer(p)) - Rational(1);
        if (value > most && sign(slope) > 0) break;
        if (value <= most && !is_zero(value)) values.insert(value);
        if (std::abs(p) > most_table_entries)
          throw OutOfBudget("too many eigenvalues of the table would have to be looked at");
        if (p % 1000 == 0) budget.check();
      }
  return {values.begin(), values.end()};
}

class Choices {
public:
  Choices(long k, const Budget& budget) : table_(eigenvalue_table(k)), budget_(budget) {
    negative_ = table_values(table_, Rational(0), budget);
  }

  std::vector<std::vector<Rational>> run(long points, const Rational& sum) {
    choose_negative(0, points, sum);
    return {found_.begin(), found_.end()};
  }

private:
  void choose_negative(std::size_t first, long left, const Rational& rest) {
    choose_positive(left, rest, Rational(0));
    if (left == 0) return;
    for (std::size_t i = first; i < negative_.size(); ++i) {
      chosen_.push_back(negative_[i]);
      choose_negative(i, left - 1, rest - Rational(1) / negative_[i]);
      chosen_.pop_back();
    }
  }

  // left values >= least with sum of 1/L = rest: the smallest is between 1/rest and left/rest.
  void choose_positive(long left, const Rational& rest, const Rational& least) {
    budget_.check();
    if (left == 0) {
      if (is_zero(rest)) {
        auto sorted = chosen_;
        std::sort(sorted.begin(), sorted.end());
        found_.insert(std::move(sorted));
      }
      return;
    }
    if (sign(rest) <= 0) return;
    const Rational from = std::max(least, Rational(1) / rest);
    if (left == 1) {
      const Rational last = Rational(1) / rest;
      if (last == from && is_in_table(last)) take(last, 0, Rational(0));
      return;
    }
    for (const Rational& value : table_values(table_, Rational(left) / rest, budget_)) {
      if (value >= from) take(value, left - 1, rest - Rational(1) / value);
    }
  }
  void take(const Rational& value, long left, const Rational& rest) {
    chosen_.push_back(value);
    choose_positive(left, rest, value);
    chosen_.pop_back();
  }
  [[nodiscard]] bool is_in_table(const Rational& value) const {
    return std::any_of(table_.families.begin(), table_.families.end(),
                       [&](const EigenvalueFamily& f) { return f.contains(value + Rational(1)); });
  }

  EigenvalueTable table_;
  const Budget& budget_;
  std::vector<Rational> negative_;
  std::vector<Rational> chosen_;
  std::set<std::vector<Rational>> found_;
};

// ---- the potential

/// H = c p^2 + V(q) with two coordinates.
struct PlanarPotential {
  MPoly leading; ///< of degree k in the coordinates, up to a constant factor
  long k = 0;
  bool homogeneous = false;
  std::size_t x = 0, y = 0;
  MPoly mass; ///< H = c p^2 + V with c = 0 where this vanishes: nothing is said there
};

long degree_in(const std::vector<unsigned long>& e, std::size_t x, std::size_t y) {
  return static_cast<long>(e[x] + e[y]);
}

// V = H - c (p1^2 + p2^2), polynomial in the coordinates.
std::optional<MFraction> potential_of(const System& s) {
  const VectorField& v = s.field;
  if (s.kind != SystemKind::hamiltonian || v.dimension() != 4 || !v.functions.empty() ||
      !v.hamiltonian)
    return std::nullopt;
  const std::size_t p1 = v.coordinates[2];
  const std::size_t p2 = v.coordinates[3];
  const MFraction& h = *v.hamiltonian;
  const MFraction c = Rational(1, 2) * derivative(derivative(h, p1), p1);
  const MFraction a = MFraction::variable(v.ring, p1);
  const MFraction b = MFraction::variable(v.ring, p2);
  if (is_zero(c)) return std::nullopt;
  const MFraction potential = h - c * (a * a + b * b);
  for (const std::size_t i : v.coordinates)
    if (uses(c, i) || uses(potential.den(), i)) return std::nullopt;
  if (uses(potential, p1) || uses(potential, p2)) return std::nullopt;
  return potential;
}

std::optional<PlanarPotential> planar_potential(const System& s) {
  const auto potential = potential_of(s);
  if (!potential) return std::nullopt;
  PlanarPotential p;
  p.x = s.field.coordinates[0];
  p.y = s.field.coordinates[1];
  const std::size_t p1 = s.field.coordinates[2];
  p.mass = derivative(derivative(*s.field.hamiltonian, p1), p1).num();
  const MPoly num = potential->num();
  for (long t = 0; t < num.length(); ++t)
    p.k = std::max(p.k, degree_in(num.exponents(t), p.x, p.y));
  p.leading = MPoly(num.ring());
  p.homogeneous = true;
  for (long t = 0; t < num.length(); ++t) {
    const auto e = num.exponents(t);
    if (degree_in(e, p.x, p.y) == p.k)
      p.leading += MPoly::term(num.ring(), num.coefficient(t), e);
    else if (degree_in(e, p.x, p.y) > 0)
      p.homogeneous = false;
  }
  return p;
}

/// The Darboux points in the chart w = x/y after a rotation, without those where V vanishes and the
/// isotropic ones: the zeros of g.
struct Chart {
  Ring ring; ///< that of the system, and L
  std::size_t w = 0, l = 0;
  MPoly v;                ///< V(w, 1)
  MPoly derivative_of_g0; ///< of (1 + w^2) v' - k w v
  MPoly g;
  MPoly leading;      ///< of that polynomial: 0 where a point is at infinity
  long points = 0;    ///< degree of g
  long isotropic = 0; ///< the power of 1 + w^2 in v
};

MPoly without(MPoly f, const MPoly& factors) {
  for (MPoly common = gcd(f, factors); !is_constant(common); common = gcd(f, factors))
    f = exact_div(f, common);
  return f;
}

Chart chart(const PlanarPotential& p, long cosine, long sine) {
  Chart c;
  auto names = p.leading.ring()->names();
  names.emplace_back("eigenvalue L");
  c.ring = make_ring(names);
  c.w = p.x;
  c.l = names.size() - 1;
  const MFraction w = MFraction::variable(c.ring, c.w);
  const MFraction one(c.ring, Rational(1));
  const Rational a(cosine);
  const Rational b(sine);
  c.v = substitute(transfer(MFraction(p.leading), c.ring),
                   {{p.x, a * w - b * one}, {p.y, b * w + a * one}})
            .num();
  const MPoly wp = MPoly::variable(c.ring, c.w);
  const MPoly circle = wp * wp + MPoly(c.ring, Integer(1));
  const MPoly g0 = circle * derivative(c.v, c.w) - MPoly(c.ring, Integer(p.k)) * wp * c.v;
  c.derivative_of_g0 = derivative(g0, c.w);
  MPoly rest = c.v;
  while (const auto quotient = divides(circle, rest)) {
    rest = *quotient;
    ++c.isotropic;
  }
  if (degree(g0, c.w) != p.k) return c; // a point at infinity, for all parameters
  c.leading = coefficients(g0, c.w).back();
  c.g = without(without(g0, c.v), circle);
  c.points = degree(c.g, c.w);
  return c;
}

// Where none of these vanishes the zeros of g are simple and not isotropic, and none is at infinity.
std::vector<MPoly> generic(const Chart& c) {
  const MPoly wp = MPoly::variable(c.ring, c.w);
  const MPoly circle = wp * wp + MPoly(c.ring, Integer(1));
  std::vector<MPoly> all{c.leading, resultant(c.g, circle, c.w)};
  if (c.points > 1) all.push_back(discriminant(c.g, c.w));
  MPoly rest = c.v;
  for (long i = 0; i < c.isotropic; ++i)
    rest = exact_div(rest, circle);
  all.push_back(resultant(rest, circle, c.w));
  return all;
}

// prod (L - Lambda_i) up to a factor, by powers of L.
std::vector<MPoly> eigenvalue_polynomial(const Chart& c, long k) {
  const MPoly wp = MPoly::variable(c.ring, c.w);
  const MPoly circle = wp * wp + MPoly(c.ring, Integer(1));
  const MPoly l = MPoly::variable(c.ring, c.l);
  return coefficients(
      resultant(c.g, circle * c.derivative_of_g0 - l * MPoly(c.ring, Integer(k)) * c.v, c.w), c.l);
}

MPoly at(const std::vector<MPoly>& polynomial, const Rational& value) {
  MFraction sum(polynomial.front().ring());
  for (std::size_t i = polynomial.size(); i-- > 0;)
    sum = sum * MFraction(sum.ring(), value) + MFraction(polynomial[i]);
  return sum.num();
}

std::vector<MPoly> derivative_of(const std::vector<MPoly>& polynomial) {
  std::vector<MPoly> all;
  for (std::size_t i = 1; i < polynomial.size(); ++i)
    all.push_back(polynomial[i] * MPoly(polynomial[i].ring(), Integer(static_cast<long>(i))));
  return all;
}

// The equations for these eigenvalues, ascending: each is a zero of chi with its multiplicity.
// They fall into factors where some direction is rational in the parameters.
std::vector<MPoly> equations(const std::vector<MPoly>& chi, const std::vector<Rational>& choice) {
  KOV_ENSURE(chi.size() == choice.size() + 1);
  std::vector<MPoly> all;
  std::vector<MPoly> derived = chi;
  for (std::size_t i = 0; i < choice.size(); ++i) {
    derived = i > 0 && choice[i] == choice[i - 1] ? derivative_of(derived) : chi;
    all.push_back(at(derived, choice[i]));
  }
  return all;
}

std::string text_of(const std::vector<std::vector<Rational>>& choices) {
  std::string text;
  for (const auto& choice : choices) {
    text += text.empty() ? "{" : ", {";
    for (std::size_t i = 0; i < choice.size(); ++i)
      text += (i == 0 ? "" : ", ") + to_string(choice[i] + Rational(1));
    text += "}";
  }
  return text.empty() ? "none" : text;
}

MPoly back(const MPoly& p, const Ring& ring) { return transfer(MFraction(p), ring).num(); }

// With `lost` simple zeros of g at double zeros of v: chi loses so many degrees.
std::optional<Exclusion> exclusion(const System& s, const PlanarPotential& p, const Chart& c,
                                   std::vector<MPoly> chi, long lost, const Budget& budget) {
  Exclusion e;
  for (; lost > 0; --lost) {
    if (is_constant(chi.back())) return std::nullopt;
    e.zero.push_back(back(chi.back(), s.ring()));
    chi.pop_back();
    if (chi.size() < 2 || is_zero(chi.back())) return std::nullopt;
  }
  auto conditions = generic(c);
  conditions.push_back(chi.back());
  if (std::any_of(conditions.begin(), conditions.end(), [](const MPoly& f) { return is_zero(f); }))
    return std::nullopt;
  const long points = static_cast<long>(chi.size()) - 1;
  const auto choices =
      eigenvalue_choices(p.k, points, Rational(-p.k, p.k - 2 * c.isotropic), budget);
  if (!is_constant(p.mass)) e.not_all_zero.push_back({p.mass});
  for (const MPoly& f : conditions)
    e.not_all_zero.push_back({back(f, s.ring())});
  for (const auto& choice : choices)
    for (const auto& component : components(equations(chi, choice), conditions, budget)) {
      e.not_all_zero.emplace_back();
      for (const MPoly& f : component)
        e.not_all_zero.back().push_back(back(f, s.ring()));
    }
  e.by.solution =
      "the Darboux points of the part of degree " + std::to_string(p.k) + " of the potential";
  e.by.level = "energy not 0";
  e.by.reason = "their eigenvalues are not in the table of Morales-Ruiz and Ramis; with " +
                std::to_string(points) + " simple points it leaves " + text_of(choices);
  e.by.integrals = p.homogeneous ? ExcludedClass::meromorphic : ExcludedClass::rational;
  e.by.theorems = {morales_ramis().name};
  e.by.trusted = {"the polynomial of the eigenvalues at Darboux points"};
  if (!p.homogeneous) e.by.theorems.emplace_back("Ziglin's lemma, for parts of highest weight");
  return e;
}

void add_exclusions(const System& s, const PlanarPotential& p, const Chart& c, const Budget& budget,
                    std::vector<Exclusion>& all) {
  if (c.points == 0 || 2 * c.isotropic == p.k) return;
  const auto chi = eigenvalue_polynomial(c, p.k);
  if (chi.size() != static_cast<std::size_t>(c.points) + 1) return;
  for (long lost = 0; lost < c.points && lost <= most_lost; ++lost)
    if (auto e = exclusion(s, p, c, chi, lost, budget)) all.push_back(*std::move(e));
}

} // namespace

std::vector<std::vector<Rational>> eigenvalue_choices(long k, long points, const Rational& sum,
                                                      const Budget& budget) {
  KOV_ENSURE(k >= 3);
  return Choices(k, budget).run(points, sum);
}

std::vector<Exclusion> exclusions_by_darboux_points(const System& s, const Budget& budget) {
  const auto p = planar_potential(s);
  std::vector<Exclusion> all;
  if (!p || p->k < 3 || p->k > largest_degree) return all;
  for (const auto& [cosine, sine] : {std::pair(1L, 0L), std::pair(3L, 4L), std::pair(5L, 12L)}) {
    const Chart c = chart(*p, cosine, sine);
    add_exclusions(s, *p, c, budget, all);
    if (c.points > 0 && is_constant(c.leading)) break; // no point is ever at infinity
  }
  return all;
}

} // namespace kov
