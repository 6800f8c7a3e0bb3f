#include "classify/darboux_points.hpp"

#include "classify/components.hpp"
#include "closed/potential.hpp"
#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/variables.hpp"
#include "literature/literature.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace kov {
namespace {

constexpr long most_table_entries = 100000;
constexpr long most_directions = 8;
constexpr long most_lost = 2; // points at double zeros or poles of V

// For other degrees every eigenvalue is in the table, or there is none.
bool has_darboux_points(long k) { return k != 0 && k != 2 && k != -2; }

// ---- the table

long side(long k) { return k > 0 ? 1 : -1; }

// Lambda sign(k) != 0 of the table, up to `most`: the families grow to the side of k.
std::vector<Rational> table_values(const EigenvalueTable& table, const Rational& most,
                                   const Budget& budget) {
  std::set<Rational> values;
  for (const EigenvalueFamily& f : table.families)
    for (const long step : {1L, -1L})
      for (long p = step > 0 ? 0 : -1;; p += step) {
        const Rational slope = (f.u + f.v * Rational(p)) * Rational(step) * f.v;
        const Rational value = Rational(side(table.k)) * (f.at(Integer(p)) - Rational(1));
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
    choose_negative(0, points, Rational(side(table_.k)) * sum);
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
        for (Rational& value : sorted)
          value = Rational(side(table_.k)) * value;
        std::ranges::sort(sorted);
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
    return std::ranges::any_of(table_.families, [&](const EigenvalueFamily& f) {
      return f.contains(Rational(side(table_.k)) * value + Rational(1));
    });
  }

  EigenvalueTable table_;
  const Budget& budget_;
  std::vector<Rational> negative_;
  std::vector<Rational> chosen_;
  std::set<std::vector<Rational>> found_;
};

// ---- the potential

/// H = (m11 p1^2 + 2 m12 p1 p2 + m22 p2^2)/2 + V(q), V = num/den homogeneous of degree k.
struct PlanarPotential {
  std::size_t x = 0, y = 0;
  MPoly m11, m12, m22; ///< up to a common factor
  MPoly num, den;      ///< without a common factor
  long k = 0;
  long directions =
      0; ///< degree of the form that vanishes at the Darboux points: num and den together
  enum class Part : std::uint8_t { all, highest, lowest } part = Part::all; ///< of the potential
  /// Valid where each list has a nonvanishing member; elsewhere the leading part of H is another one.
  std::vector<std::vector<MPoly>> not_all_zero;
};

MPoly determinant(const PlanarPotential& p) { return p.m11 * p.m22 - p.m12 * p.m12; }

using Part = PlanarPotential::Part;

/// A homogeneous rational function of two variables.
struct Form {
  MFraction value;
  long degree = 0;
};

long degree_of_term(const MPoly& f, long t, std::size_t x, std::size_t y) {
  const auto e = f.exponents(t);
  return static_cast<long>(e[x] + e[y]);
}
// The degree of a form.
long degree_of(const MPoly& f, std::size_t x, std::size_t y) { return degree_of_term(f, 0, x, y); }

/// The terms of highest or lowest degree in two variables.
class LeadingTerms {
public:
  LeadingTerms(std::size_t x, std::size_t y, Part part) : x_(x), y_(y), part_(part) {}

  [[nodiscard]] Form operator()(const MFraction& f) const {
    const Form num = of(f.num());
    const Form den = of(f.den());
    return {num.value / den.value, num.degree - den.degree};
  }
  /// The coefficients of the leading part of f: where all of them vanish another part leads.
  [[nodiscard]] std::vector<MPoly> coefficients_of(const MPoly& f) const {
    std::vector<MPoly> all;
    for (const MPoly& by_x : coefficients(of(f).value.num(), x_))
      for (MPoly& c : coefficients(by_x, y_))
        if (!is_zero(c)) all.push_back(std::move(c));
    return all;
  }

private:
  [[nodiscard]] Form of(const MPoly& f) const {
    Form best;
    for (long t = 0; t < f.length(); ++t) {
      const long d = degree_of_term(f, t, x_, y_);
      if (t == 0 || (part_ == Part::highest ? d > best.degree : d < best.degree))
        best = {MFraction(f.ring()), d};
      if (d == best.degree)
        best.value += MFraction(MPoly::term(f.ring(), f.coefficient(t), f.exponents(t)));
    }
    return best;
  }
  std::size_t x_, y_;
  Part part_;
};

/// H = (a quadratic form in p with constant coefficients)/2 + A1 p1 + A2 p2 + V.
struct MagneticHamiltonian {
  std::array<MFraction, 3> mass; ///< m11, m12, m22
  std::array<MFraction, 2> linear;
  MFraction potential;
};

std::optional<MagneticHamiltonian> natural_hamiltonian(const System& s) {
  const VectorField& v = s.field;
  if (s.kind != SystemKind::hamiltonian || v.dimension() != 4 || !v.functions.empty() ||
      !v.hamiltonian)
    return std::nullopt;
  const auto& z = v.coordinates;
  const MFraction& h = *v.hamiltonian;
  const auto second = [&](std::size_t i, std::size_t j) {
    return derivative(derivative(h, z[i]), z[j]);
  };
  MagneticHamiltonian n{{second(2, 2), second(2, 3), second(3, 3)}, {}, {}};
  for (const MFraction& m : n.mass)
    if (uses_any(m, z)) return std::nullopt;
  if (!uses_any(h, {z[2], z[3]})) return std::nullopt;
  const MFraction zero(v.ring);
  const Substitution at_rest{{z[2], zero}, {z[3], zero}};
  for (const std::size_t i : {0U, 1U})
    n.linear[i] = substitute(derivative(h, z[i + 2]), at_rest);
  n.potential = substitute(h, at_rest);
  return n;
}

// Without the part of degree 0, which no equation of motion contains.
MFraction without_constant(const MFraction& potential, std::size_t x, std::size_t y) {
  if (uses_any(MFraction(potential.den()), {x, y})) return potential;
  const MFraction zero(potential.ring());
  return potential - substitute(potential, {{x, zero}, {y, zero}});
}

// With the weights 2 of q and k of p all the rest of H is lower (of the part of highest degree), or
// higher: of A1 p1 + A2 p2 this asks that its coefficients have a degree below (above) k/2.
bool is_leading(const MagneticHamiltonian& n, const LeadingTerms& leading, Part part, long k) {
  return std::ranges::all_of(n.linear, [&](const MFraction& a) {
    if (is_zero(a)) return true;
    const long d = 2 * leading(a).degree;
    return part == Part::highest ? d < k : d > k;
  });
}

// At special parameters a form may be 0, and a common factor of two forms too, which their quotient
// does not show; of A1, A2 only the denominators matter: a larger degree is not a bound any more.
void set_conditions(PlanarPotential& p, const MagneticHamiltonian& n, const MFraction& v,
                    const LeadingTerms& leading) {
  for (const MPoly& f : {v.num(), v.den(), n.linear[0].den(), n.linear[1].den()})
    p.not_all_zero.push_back(leading.coefficients_of(f));
}

// The common factor 1/(all denominators) of the masses does not matter.
void set_mass(PlanarPotential& p, const MagneticHamiltonian& n) {
  MFraction common(n.potential.ring(), Rational(1));
  for (const MFraction& m : n.mass)
    common = common * MFraction((MFraction(m.den()) / common).num());
  p.m11 = (n.mass[0] * common).num();
  p.m12 = (n.mass[1] * common).num();
  p.m22 = (n.mass[2] * common).num();
}

// V itself if it is homogeneous, else its parts of highest and of lowest degree.
std::vector<PlanarPotential> planar_potentials(const System& s) {
  std::vector<PlanarPotential> all;
  const auto n = natural_hamiltonian(s);
  if (!n) return all;
  const std::size_t x = s.field.coordinates[0];
  const std::size_t y = s.field.coordinates[1];
  const MFraction v = without_constant(n->potential, x, y);
  if (is_zero(v)) return all;
  const bool at_rest = is_zero(n->linear[0]) && is_zero(n->linear[1]);
  for (const Part part : {Part::highest, Part::lowest}) {
    const LeadingTerms leading(x, y, part);
    const Form top = leading(v);
    const bool whole = at_rest && top.value == v;
    if (!has_darboux_points(top.degree) || !is_leading(*n, leading, part, top.degree)) continue;
    PlanarPotential p;
    p.x = x;
    p.y = y;
    set_mass(p, *n);
    p.num = top.value.num();
    p.den = top.value.den();
    p.k = top.degree;
    p.directions = degree_of(p.num, x, y) + degree_of(p.den, x, y);
    p.part = whole ? Part::all : part;
    if (!whole) set_conditions(p, *n, v, leading);
    if (!is_zero(determinant(p))) all.push_back(std::move(p));
    if (whole) break;
  }
  return all;
}

/// The Darboux points in the chart w = x/y after a linear change of coordinates, without those where
/// V is 0 or infinite and the isotropic ones: the zeros of g.
struct Chart {
  Ring ring; ///< that of the system, and L
  std::size_t w = 0, l = 0;
  MPoly num, den;         ///< V(w, 1) is their quotient
  MPoly circle;           ///< 0 at the isotropic directions: 1 + w^2 for p1^2 + p2^2
  MPoly determinant;      ///< of the masses
  MPoly derivative_of_g0; ///< of all of the equation for directions
  MPoly g;
  MPoly leading;               ///< of that equation: 0 where a direction is at infinity
  long points = 0;             ///< degree of g
  std::vector<long> isotropic; ///< the powers in V of the two isotropic directions
  MPoly rest;                  ///< num den without them
};

MPoly without(MPoly f, const MPoly& factors) {
  for (MPoly common = gcd(f, factors); !is_constant(common); common = gcd(f, factors))
    f = exact_div(f, common);
  return f;
}

long take_out(const MPoly& factor, MPoly& f) {
  long power = 0;
  while (const auto quotient = divides(factor, f)) {
    f = *quotient;
    ++power;
  }
  return power;
}

// Conjugate directions have the same power.
void count_isotropic(Chart& c) {
  MPoly num = c.num;
  MPoly den = c.den;
  for (const MFactor& f : factor(c.circle).second) {
    const long d = degree(f.base, c.w);
    if (d < 1) continue;
    const long power = take_out(f.base, num) - take_out(f.base, den);
    for (long i = 0; i < d * static_cast<long>(f.exponent); ++i)
      c.isotropic.push_back(power);
  }
  c.rest = num * den;
}

/// q = B (w, 1), B = (a -b; b a), and the masses there.
class LinearChange {
public:
  LinearChange(const PlanarPotential& p, const Ring& ring, long a, long b)
      : p_(p), ring_(ring), a_(ring, Integer(a)), b_(ring, Integer(b)) {}
  [[nodiscard]] MPoly of(const MPoly& f) const {
    const MFraction w = MFraction::variable(ring_, p_.x);
    const MFraction a(a_), b(b_);
    return substitute(transfer(MFraction(f), ring_), {{p_.x, a * w - b}, {p_.y, b * w + a}}).num();
  }
  // adj(B) M adj(B)^T
  [[nodiscard]] std::array<MPoly, 3> mass() const {
    const MPoly m11 = here(p_.m11), m12 = here(p_.m12), m22 = here(p_.m22);
    const MPoly two(ring_, Integer(2));
    return {a_ * a_ * m11 + two * a_ * b_ * m12 + b_ * b_ * m22,
            a_ * a_ * m12 - b_ * b_ * m12 + a_ * b_ * (m22 - m11),
            b_ * b_ * m11 - two * a_ * b_ * m12 + a_ * a_ * m22};
  }

private:
  [[nodiscard]] MPoly here(const MPoly& f) const { return transfer(MFraction(f), ring_).num(); }
  const PlanarPotential& p_;
  Ring ring_;
  MPoly a_, b_;
};

Chart chart(const PlanarPotential& p, long cosine, long sine) {
  Chart c;
  auto names = p.num.ring()->names();
  names.emplace_back("eigenvalue L");
  c.ring = make_ring(names);
  c.w = p.x;
  c.l = names.size() - 1;
  const LinearChange change(p, c.ring, cosine, sine);
  const auto [m11, m12, m22] = change.mass();
  c.num = change.of(p.num);
  c.den = change.of(p.den);
  const MPoly w = MPoly::variable(c.ring, c.w);
  c.circle = m22 * w * w - MPoly(c.ring, Integer(2)) * m12 * w + m11;
  c.determinant = m11 * m22 - m12 * m12;
  if (degree(c.circle, c.w) != 2) return c; // an isotropic direction is at infinity
  count_isotropic(c);
  const MPoly wronskian = derivative(c.num, c.w) * c.den - c.num * derivative(c.den, c.w);
  const MPoly g0 =
      c.circle * wronskian - MPoly(c.ring, Integer(p.k)) * (m22 * w - m12) * c.num * c.den;
  c.derivative_of_g0 = derivative(g0, c.w);
  if (is_zero(g0) || degree(g0, c.w) != p.directions) return c; // a direction at infinity
  c.leading = coefficients(g0, c.w).back();
  c.g = without(without(without(g0, c.num), c.den), c.circle);
  c.points = degree(c.g, c.w);
  return c;
}

// The generic case: where none of these vanishes the zeros of g are simple and not isotropic, none
// of them nor an isotropic direction is at infinity, those are two, and num/den is in lowest terms.
std::vector<MPoly> generic(const Chart& c) {
  std::vector<MPoly> all{c.determinant, coefficients(c.circle, c.w).back(), c.leading,
                         resultant(c.g, c.circle, c.w)};
  if (c.points > 1) all.push_back(discriminant(c.g, c.w));
  if (degree(c.num, c.w) > 0 && degree(c.den, c.w) > 0) all.push_back(resultant(c.num, c.den, c.w));
  all.push_back(resultant(c.rest, c.circle, c.w));
  return all;
}

// prod (L - Lambda_i) up to a factor, by powers of L.
std::vector<MPoly> eigenvalue_polynomial(const Chart& c, long k) {
  const MPoly l = MPoly::variable(c.ring, c.l);
  return coefficients(resultant(c.g,
                                c.circle * c.derivative_of_g0 -
                                    l * MPoly(c.ring, Integer(k)) * c.determinant * c.num * c.den,
                                c.w),
                      c.l);
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
  const auto number = [](const Rational& x) { return to_string(x + Rational(1)); };
  return joined(choices, [&](const auto& choice) { return "{" + joined(choice, number) + "}"; });
}

MPoly back(const MPoly& p, const Ring& ring) { return transfer(MFraction(p), ring).num(); }

// The sum of 1/Lambda over all directions; unset: V decides it.
std::optional<Rational> sum_of_inverses(const Chart& c, long k) {
  Rational sum(0);
  for (const long m : c.isotropic) {
    if (2 * m == k) return std::nullopt;
    sum = sum - Rational(k, 2 * (k - 2 * m));
  }
  return sum;
}

std::string which_part(const PlanarPotential& p) {
  if (p.part == Part::all) return "the potential";
  return std::string("the part of ") + (p.part == Part::highest ? "highest" : "lowest") +
         " degree, " + std::to_string(p.k) + ", of the potential";
}

// The reason, as far as all statements about Darboux points share it.
ExclusionReason reason(const PlanarPotential& p) {
  ExclusionReason by;
  by.level.which =
      p.part == Part::all ? Levels::Which::energy_not_zero : Levels::Which::energy_of_part_not_zero;
  if (p.part == Part::all)
    by.integrals.curves = {"the Darboux points"};
  else
    by.integrals = {.kind = IntegralClass::Kind::rational,
                    .near = IntegralClass::Near::phase_space};
  by.trusted = {{Trusted::Step::darboux_eigenvalues}};
  by.rule = Rule::darboux_points;
  if (p.part != Part::all)
    by.theorems.push_back(p.part == Part::highest ? &ziglin_highest() : &ziglin_lowest());
  return by;
}

ExclusionReason why(const PlanarPotential& p, std::size_t points,
                    const std::vector<std::vector<Rational>>& choices) {
  ExclusionReason by = reason(p);
  by.solution = "the Darboux points of " + which_part(p);
  const std::string these =
      std::to_string(points) + " simple Darboux point" + (points == 1 ? "" : "s");
  by.reason = choices.empty()
                  ? "no integrable potential has " + these + " (Morales-Ruiz and Ramis)"
                  : "an integrable potential with " + these +
                        " has one of these sets of eigenvalues (Morales-Ruiz and Ramis): " +
                        text_of(choices) + "; this one does not";
  by.theorems.insert(by.theorems.begin(), &morales_ramis());
  return by;
}

// With `lost` simple zeros of g where V has no Darboux point: chi loses so many degrees.
std::optional<Exclusion> exclusion(const System& s, const PlanarPotential& p, const Chart& c,
                                   const Rational& sum, std::vector<MPoly> chi, long lost,
                                   const Budget& budget) {
  Exclusion e;
  for (; lost > 0; --lost) {
    if (is_constant(chi.back())) return std::nullopt;
    e.zero.push_back(back(chi.back(), s.ring()));
    chi.pop_back();
    if (chi.size() < 2 || is_zero(chi.back())) return std::nullopt;
  }
  auto conditions = generic(c);
  conditions.push_back(chi.back());
  if (std::ranges::any_of(conditions, [](const MPoly& f) { return is_zero(f); }))
    return std::nullopt;
  const std::size_t points = chi.size() - 1;
  const auto choices = eigenvalue_choices(p.k, static_cast<long>(points), sum, budget);
  e.not_all_zero = p.not_all_zero;
  for (const MPoly& f : conditions)
    e.not_all_zero.push_back({back(f, s.ring())});
  for (const auto& choice : choices)
    for (const auto& component : components(equations(chi, choice), conditions, budget)) {
      e.not_all_zero.emplace_back();
      for (const MPoly& f : component)
        e.not_all_zero.back().push_back(back(f, s.ring()));
    }
  e.by = why(p, points, choices);
  return e;
}

// ---- parameters at which a zero of g becomes isotropic: there V vanishes

MPoly content(const std::vector<MPoly>& polynomial) {
  MPoly all = polynomial.front();
  for (const MPoly& f : polynomial)
    all = gcd(all, f);
  return all;
}

// The coefficients of the remainder of g modulo the circle: 0 where it divides g.
std::vector<MPoly> remainder(const Chart& c) {
  const auto circle = coefficients(c.circle, c.w);
  auto g = coefficients(c.g, c.w);
  while (g.size() > 2) {
    const MPoly top = g.back();
    const std::size_t shift = g.size() - 3;
    for (MPoly& f : g)
      f = f * circle[2];
    for (std::size_t i = 0; i < 3; ++i)
      g[shift + i] = g[shift + i] - top * circle[i];
    g.pop_back();
  }
  return g;
}

bool is_generic_polynomial(const PlanarPotential& p, const Chart& c) {
  return degree(c.den, c.w) == 0 && c.points == p.directions &&
         std::ranges::all_of(c.isotropic, [](long m) { return m == 0; });
}

// The case that one or both of the isotropic directions are zeros of g: chi, without the factors
// that vanish there, keeps a zero k - 2 for each, and the others belong to Darboux points.
std::optional<Exclusion> exclusion_at_isotropic(const System& s, const PlanarPotential& p,
                                                const Chart& c, std::vector<MPoly> chi, long merged,
                                                const Budget& budget) {
  const long points = c.points - merged;
  const Rational hidden(p.k - 2);
  if (points < 1) return std::nullopt;
  const MPoly common = content(chi);
  for (MPoly& f : chi)
    f = exact_div(f, common);
  const std::vector<MPoly> divided = remainder(c);
  const std::vector<MPoly> where =
      merged == 1 ? std::vector<MPoly>{resultant(c.g, c.circle, c.w)} : divided;
  std::vector<MPoly> conditions{c.determinant, coefficients(c.circle, c.w).back(), c.leading, c.den,
                                chi.back()};
  if (c.points > 1) conditions.push_back(discriminant(c.g, c.w));
  if (std::ranges::any_of(conditions, [](const MPoly& f) { return is_zero(f); }))
    return std::nullopt;
  const Rational sum = Rational(-p.k, 2) * (Rational(merged, p.k - 2) + Rational(2 - merged, p.k));
  const auto choices = eigenvalue_choices(p.k, points, sum, budget);
  Exclusion e;
  e.not_all_zero = p.not_all_zero;
  const auto here = [&](const std::vector<MPoly>& list) {
    std::vector<MPoly> all;
    for (const MPoly& f : list)
      if (!is_zero(f)) all.push_back(back(f, s.ring()));
    return all;
  };
  e.zero = here(where);
  if (merged == 1) e.not_all_zero.push_back(here(divided));
  for (const MPoly& f : conditions)
    e.not_all_zero.push_back({back(f, s.ring())});
  for (auto choice : choices) {
    choice.insert(choice.end(), static_cast<std::size_t>(merged), hidden);
    std::ranges::sort(choice);
    auto zero = equations(chi, choice);
    zero.insert(zero.end(), where.begin(), where.end());
    for (const auto& component : components(zero, conditions, budget))
      e.not_all_zero.push_back(here(component));
  }
  e.by = why(p, static_cast<std::size_t>(points), choices);
  return e;
}

// ---- multiple zeros of g, all of them directions of Darboux points

std::optional<Exclusion> exclusion_at_multiple(const System& s, const PlanarPotential& p,
                                               const Chart& c) {
  if (p.k < 3 || c.points < 2) return std::nullopt;
  std::vector<MPoly> conditions{c.determinant, coefficients(c.circle, c.w).back(), c.leading};
  for (const MPoly& other : {c.circle, c.num, c.den})
    if (degree(other, c.w) > 0)
      conditions.push_back(resultant(c.g, other, c.w));
    else
      conditions.push_back(other);
  if (std::ranges::any_of(conditions, [](const MPoly& f) { return is_zero(f); }))
    return std::nullopt;
  Exclusion e;
  e.zero = {back(discriminant(c.g, c.w), s.ring())};
  e.not_all_zero = p.not_all_zero;
  for (const MPoly& f : conditions)
    e.not_all_zero.push_back({back(f, s.ring())});
  e.by = reason(p);
  e.by.solution = "a multiple Darboux point of " + which_part(p);
  e.by.reason = "of the rational potentials of degree " + std::to_string(p.k) +
                " with such a point, not isotropic and no zero, " +
                (p.k % 2 == 0 ? "only the radial one" : "none") +
                " is integrable: the first term that is not radial gives a logarithm";
  e.by.trusted = {{Trusted::Step::darboux_logarithm}};
  e.by.rule = Rule::multiple_darboux_point;
  e.by.theorems.insert(e.by.theorems.begin(), &morales_ramis_simo());
  return e;
}

void add_exclusions(const System& s, const PlanarPotential& p, const Chart& c, const Budget& budget,
                    std::vector<Exclusion>& all) {
  if (c.points == 0) return;
  if (p.part == Part::all)
    if (auto e = exclusion_at_multiple(s, p, c)) all.push_back(*std::move(e));
  const auto sum = sum_of_inverses(c, p.k);
  if (!sum) return;
  const auto chi = eigenvalue_polynomial(c, p.k);
  if (chi.size() != static_cast<std::size_t>(c.points) + 1) return;
  for (long lost = 0; lost < c.points && lost <= most_lost; ++lost)
    if (auto e = exclusion(s, p, c, *sum, chi, lost, budget)) all.push_back(*std::move(e));
  if (is_generic_polynomial(p, c))
    for (const long merged : {1L, 2L})
      if (auto e = exclusion_at_isotropic(s, p, c, chi, merged, budget))
        all.push_back(*std::move(e));
}

// In some charts: one is enough if no point is ever at infinity there.
template <class F> void in_charts(const PlanarPotential& p, F look) {
  if (p.directions > most_directions) return;
  for (const auto& [cosine, sine] : {std::pair(1L, 0L), std::pair(3L, 4L), std::pair(5L, 12L)}) {
    const Chart c = chart(p, cosine, sine);
    look(c);
    if (c.points > 0 && is_constant(c.leading)) break;
  }
}

} // namespace

std::vector<std::vector<Rational>> eigenvalue_choices(long k, long points, const Rational& sum,
                                                      const Budget& budget) {
  KOV_ENSURE(has_darboux_points(k));
  return Choices(k, budget).run(points, sum);
}

std::vector<Exclusion> exclusions_by_darboux_points(const System& s, const Budget& budget) {
  std::vector<Exclusion> all;
  for (const PlanarPotential& p : planar_potentials(s))
    in_charts(p, [&](const Chart& c) { add_exclusions(s, p, c, budget, all); });
  return all;
}

std::vector<Exclusion> exclusions_by_multiple_points_of_parts(const System& s) {
  std::vector<Exclusion> all;
  for (const PlanarPotential& p : planar_potentials(s))
    if (p.part != Part::all)
      in_charts(p, [&](const Chart& c) {
        if (auto e = exclusion_at_multiple(s, p, c)) all.push_back(*std::move(e));
      });
  return all;
}

} // namespace kov
