#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"
#include "integrals/independence.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace kov {

MPoly common_denominator(const Ring& ring, const std::vector<MFraction>& all) {
  MPoly den(ring, Integer(1));
  for (const MFraction& f : all)
    if (!is_zero(f)) den = common_multiple(den, f.den());
  return den;
}

std::vector<MPoly> numerators(const std::vector<MFraction>& all, const MPoly& den) {
  std::vector<MPoly> result;
  for (const MFraction& f : all)
    result.push_back(is_zero(f) ? MPoly(den.ring()) : (f * MFraction(den)).num());
  return result;
}

std::map<std::vector<unsigned long>, MPoly>
by_monomials(const MPoly& f, const std::vector<std::size_t>& variables) {
  std::map<std::vector<unsigned long>, MPoly> all;
  for (long t = 0; t < f.length(); ++t) {
    auto rest = f.exponents(t);
    std::vector<unsigned long> phase;
    for (const std::size_t i : variables) {
      phase.push_back(rest[i]);
      rest[i] = 0;
    }
    all.try_emplace(std::move(phase), f.ring()).first->second +=
        MPoly::term(f.ring(), f.coefficient(t), rest);
  }
  return all;
}

namespace {

bool is_parametric(const PhaseSpace& p, const MPoly& f) { return !uses_any(f, p.variables); }

// A denominator must not vanish: where all of its coefficients do modulo the relations the system
// has no meaning; a denominator without a constant coefficient is asked to keep its first one.
void require_denominator(PhaseSpace& p, const MPoly& den, std::vector<MPoly>& required) {
  for (const MFactor& f : factor(den).second) {
    const auto parts = p.coefficients(f.base, nullptr);
    if (parts.empty())
      throw InvalidArgument("the denominator " + to_string(f.base) + " is 0 by the relations");
    if (std::ranges::any_of(parts, [](const auto& c) { return is_constant(c.second); })) continue;
    for (const MFactor& c : factor(parts.begin()->second).second)
      add_once(required, c.base);
  }
}

void read_relations(PhaseSpace& p, const Budget& budget, std::vector<MPoly>& required) {
  std::vector<MPoly> between_variables;
  for (const MPoly& r : p.field.relations)
    (is_parametric(p, r) ? p.equations : between_variables).push_back(r);
  if (between_variables.empty()) return;
  p.relations.emplace(p.field.ring, p.variables, between_variables, std::vector<MPoly>{}, budget);
  for (const MPoly& c : p.relations->inverted())
    add_once(required, c);
}

void read_assumptions(PhaseSpace& p, const System& s) {
  for (const MPoly& f : s.domain.nonzero())
    if (is_parametric(p, f)) add_once(p.nonzero, f);
  for (const Assumption& a : s.assumptions) {
    if (!a.value.ring() || is_constant(a.value) || !is_parametric(p, a.value.num())) continue;
    if (a.is(Sign::zero)) p.assumed_equations.push_back(a.value.num());
    if (a.is_nonzero())
      for (const MFactor& f : factor(a.value.num()).second)
        add_once(p.nonzero, f.base);
  }
}

// The product of the factors of f that are neither constant nor parametric.
MPoly phase_part(const PhaseSpace& p, const MPoly& f) {
  MPoly product(p.field.ring, Integer(1));
  for (const MFactor& x : factor(f).second)
    if (!is_parametric(p, x.base)) product *= pow(x.base, static_cast<unsigned long>(x.exponent));
  return product;
}

// The field on the variables: functions by the chain rule.
std::vector<MFraction> on_variables(const PhaseSpace& p, const std::vector<MFraction>& x) {
  std::vector<MFraction> all(x);
  for (const FunctionSymbol& f : p.field.functions) {
    MFraction sum(p.field.ring);
    for (std::size_t j = 0; j < x.size(); ++j)
      sum += x[j] * f.gradient[j];
    all.push_back(std::move(sum));
  }
  return all;
}

// Nothing contains the coordinate but function symbols do depend on it.
bool is_angle(const VectorField& v, std::size_t j) {
  const std::size_t x = v.coordinates[j];
  bool moves = false;
  for (const FunctionSymbol& f : v.functions) {
    if (any_uses(f.gradient, x)) return false;
    moves = moves || !is_zero(f.gradient[j]);
  }
  return moves && !any_uses(v.components, x) && !(v.hamiltonian && uses(*v.hamiltonian, x)) &&
         !any_uses(v.relations, x);
}

} // namespace

PhaseSpace::PhaseSpace(const System& s, const Budget& budget)
    : field(s.field), variables(s.field.coordinates), parameters(s.field.parameters) {
  momentum.assign(variables.size(), false);
  if (s.kind == SystemKind::hamiltonian)
    std::fill(momentum.begin() + static_cast<long>(variables.size() / 2), momentum.end(), true);
  for (std::size_t j = 0; j < variables.size(); ++j)
    angle.push_back(!momentum[j] && is_angle(field, j));
  for (const FunctionSymbol& f : field.functions) {
    variables.push_back(f.variable);
    momentum.push_back(false);
    angle.push_back(false);
  }
  parameters.insert(parameters.end(), field.constants.begin(), field.constants.end());
  std::vector<MPoly> required;
  read_relations(*this, budget, required);
  read_assumptions(*this, s);
  require_denominator(*this, common_denominator(field.ring, on_variables(*this, field.components)),
                      required);
  const MPoly den = field.hamiltonian ? field.hamiltonian->den()
                                      : common_denominator(field.ring, field.components);
  require_denominator(*this, den, required);
  denominator = phase_part(*this, den);
  of_bracket = MPoly(field.ring, Integer(1));
  if (field.poisson) // Casimirs and the rank are those of the bracket
    for (const auto& row : *field.poisson) {
      const MPoly below = common_denominator(field.ring, row);
      require_denominator(*this, below, required);
      of_bracket = common_multiple(of_bracket, phase_part(*this, below));
    }
  for (const MPoly& f : required)
    if (!is_among(f, nonzero)) {
      not_covered.push_back(f);
      nonzero.push_back(f);
    }
}

std::vector<std::size_t> PhaseSpace::momenta() const {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < variables.size(); ++i)
    if (momentum[i]) all.push_back(variables[i]);
  return all;
}

std::map<std::vector<unsigned long>, MPoly> PhaseSpace::coefficients(const MPoly& f,
                                                                     MPoly* scale) const {
  if (!relations || is_zero(f)) return by_monomials(f, variables);
  const MFraction reduced = relations->normal_form(MFraction(f));
  if (scale != nullptr && !is_zero(reduced)) *scale = reduced.den();
  return by_monomials(reduced.num(), variables);
}

bool PhaseSpace::vanishes(const Set& where, const MFraction& f) const {
  if (is_zero(f)) return true;
  const auto all = coefficients(f.num(), nullptr);
  return std::ranges::all_of(all, [&](const auto& c) { return where.vanishes(c.second); });
}

namespace {

bool is_parametric(const PhaseSpace& p, const MFraction& f) {
  return is_zero(f) || (is_parametric(p, f.num()) && is_parametric(p, f.den()));
}

// For H = p^T G p/2 + (A/D)·p + N/D, G constant: what degree the numerators over D^j may gain with
// each j, twice (docs/theory/integrals.md, Theorem 3).
long twice_step(const PhaseSpace& p, bool even) {
  const MFraction over = *p.field.hamiltonian * MFraction(p.denominator);
  const std::size_t n = p.variables.size() / 2;
  const long d = degree_of(p, p.denominator);
  std::array<long, 2> degree{}; // of N and A
  for (const auto& [e, c] : by_monomials(over.num(), p.variables)) {
    const auto middle = e.begin() + static_cast<long>(n);
    const auto k = std::accumulate(middle, e.end(), 0UL);
    if (k < 2)
      degree.at(k) =
          std::max(degree.at(k), static_cast<long>(std::accumulate(e.begin(), middle, 0UL)));
  }
  if (even) return 2 * std::max(degree[0], d - 2);
  return std::max({2 * degree[1], degree[0] + d, 2 * d - 2});
}

} // namespace

std::optional<NaturalHamiltonian> natural_hamiltonian(const PhaseSpace& p) {
  const std::size_t n = p.field.coordinates.size() / 2;
  if (!p.field.hamiltonian || n == 0 || !p.momentum[n]) return std::nullopt;
  const std::vector<std::size_t> momenta(p.field.coordinates.begin() + static_cast<long>(n),
                                         p.field.coordinates.end());
  for (std::size_t j = n; j < 2 * n; ++j) { // functions of the coordinates alone
    for (const FunctionSymbol& f : p.field.functions)
      if (!is_zero(f.gradient[j])) return std::nullopt;
    for (const MPoly& relation : p.field.relations)
      if (uses(relation, momenta[j - n])) return std::nullopt;
  }
  std::vector<std::vector<MFraction>> metric(n);
  MPoly den(p.field.ring, Integer(1));
  NaturalHamiltonian natural;
  for (std::size_t i = 0; i < n; ++i) {
    MFraction linear = derivative(*p.field.hamiltonian, momenta[i]);
    for (std::size_t j = 0; j < n; ++j) {
      metric[i].push_back(derivative(derivative(*p.field.hamiltonian, momenta[i]), momenta[j]));
      if (!is_parametric(p, metric[i][j])) return std::nullopt;
      if (!is_zero(metric[i][j])) den = common_multiple(den, metric[i][j].den());
      linear = linear - metric[i][j] * MFraction::variable(p.field.ring, momenta[j]);
    }
    natural.even = natural.even && is_zero(linear);
  }
  std::vector<std::vector<MPoly>> rows;
  for (const auto& row : metric)
    rows.push_back(numerators(row, den));
  natural.determinant = determinant(rows);
  if (is_zero(natural.determinant)) return std::nullopt;
  if (p.is_polynomial_ring()) {
    natural.polynomial = is_one(p.denominator);
    natural.twice_step = twice_step(p, natural.even);
  }
  return natural;
}

namespace {

unsigned long sum_at(const std::vector<unsigned long>& e, const std::vector<std::size_t>& places) {
  unsigned long sum = 0;
  for (const std::size_t i : places)
    sum += e[i];
  return sum;
}

long degree_in(const MPoly& f, const std::vector<std::size_t>& variables) {
  unsigned long degree = 0;
  for (long t = 0; t < f.length(); ++t)
    degree = std::max(degree, sum_at(f.exponents(t), variables));
  return static_cast<long>(degree);
}

} // namespace

long degree_of(const PhaseSpace& p, const MPoly& f) { return degree_in(f, p.variables); }

long degree_in_momenta(const PhaseSpace& p, const MPoly& f) {
  return degree_in(f, p.is_canonical() ? p.momenta() : p.variables);
}

namespace {

// For an integral whose highest degree in the momenta is `degree` or one less: how many steps below
// the highest one are the momenta of degree k?
long layer(const NaturalHamiltonian& natural, long degree, long k) {
  return natural.even ? (degree - k) / 2 : degree - k;
}

// The degree of the highest part that the one of degree k belongs to.
long top_degree(const NaturalHamiltonian& natural, long degree, long k) {
  return natural.even ? degree - (degree - k) % 2 : degree;
}

/// The largest degree of the coefficients beside momenta of degree k.
long coefficient_bound(const AnsatzBounds& b, const std::optional<NaturalHamiltonian>& natural,
                       long k, long denominator_degree) {
  if (b.coefficients && !b.layered) return *b.coefficients + denominator_degree;
  const long j = layer(natural.value(), b.degree, k);
  const long top = top_degree(*natural, b.degree, k);
  if (j == 0) return top;
  return b.coefficients ? *b.coefficients + j * denominator_degree
                        : top + j * natural->twice_step.value() / 2;
}

bool is_standard(const PhaseSpace& p, const std::vector<unsigned long>& e) {
  if (!p.relations) return true;
  return std::ranges::none_of(p.relations->basis(), [&](const KPoly& f) {
    const Monomial& lead = f.begin()->first;
    for (std::size_t i = 0; i < e.size(); ++i)
      if (lead[i] > e[i]) return false;
    return true;
  });
}

class MonomialList {
public:
  MonomialList(const PhaseSpace& p, const AnsatzBounds& b,
               const std::optional<NaturalHamiltonian>& natural, long denominator_degree)
      : p_(p), bounds_(b), natural_(natural), extra_(denominator_degree),
        mechanical_(p.is_canonical()) {
    const auto& f = p.field.components; // a parameter that only labels levels is idle
    if (std::ranges::any_of(p.parameters, [&](std::size_t t) { return any_uses(f, t); }))
      most_ = 4000;
  }

  std::vector<std::vector<unsigned long>> all() {
    e_.assign(p_.variables.size(), 0);
    add(0, 0, 0);
    return std::move(found_);
  }

private:
  // Momenta come after the coordinates and before the functions, so that bounds are tested at the
  // end and, for the sake of time, on the way.
  void add(std::size_t i, long momenta, long others) {
    if (momenta > bounds_.degree || others > largest(momenta)) return;
    if (++steps_ > 2'000'000) throw OutOfBudget("an ansatz with too many monomials");
    if (i == p_.variables.size()) {
      if (is_possible(momenta, others) && others <= bound(momenta) &&
          (is_highest(momenta) || is_standard(p_, e_))) {
        if (found_.size() >= most_)
          throw OutOfBudget("an ansatz with more than " + std::to_string(most_) + " unknowns");
        found_.push_back(e_);
      }
      return;
    }
    for (e_[i] = 0; e_[i] == 0 || !p_.angle[i]; ++e_[i]) {
      const long k = static_cast<long>(e_[i]);
      const long m = momenta + (p_.momentum[i] ? k : 0);
      const long o = others + (p_.momentum[i] ? 0 : k);
      if (m > bounds_.degree || o > largest(m)) break;
      add(i + 1, m, o);
    }
    e_[i] = 0;
  }
  // Polynomials in the coordinates alone, even where relations express some of them by symbols.
  bool is_highest(long momenta) const {
    return bounds_.layered && layer(*natural_, bounds_.degree, momenta) == 0;
  }
  // Constants are left out, and function symbols in the highest part of a layered ansatz.
  bool is_possible(long momenta, long others) const {
    if (!bounds_.layered) return momenta + others + extra_ > 0;
    const long j = layer(*natural_, bounds_.degree, momenta);
    if (j == 0)
      for (std::size_t i = p_.field.coordinates.size(); i < e_.size(); ++i)
        if (e_[i] > 0) return false;
    return momenta + others + j * extra_ > 0;
  }
  long bound(long momenta) const {
    return mechanical_ ? coefficient_bound(bounds_, natural_, momenta, extra_)
                       : bounds_.degree + extra_;
  }
  // Over all momenta that may still come: the bounds fall when these grow.
  long largest(long momenta) const {
    return std::max(bound(momenta), momenta < bounds_.degree ? bound(momenta + 1) : 0);
  }

  const PhaseSpace& p_;
  const AnsatzBounds& bounds_;
  const std::optional<NaturalHamiltonian>& natural_;
  long extra_;
  bool mechanical_;
  std::size_t most_ = 20000; // unknowns
  long steps_ = 0;
  std::vector<unsigned long> e_;
  std::vector<std::vector<unsigned long>> found_;
};

} // namespace

MPoly ansatz_denominator(const PhaseSpace& p, long degree, unsigned long power) {
  return pow(p.denominator,
             p.is_canonical() ? static_cast<unsigned long>((degree + 1) / 2) : power);
}

Ansatz make_ansatz(const PhaseSpace& p, const AnsatzBounds& bounds,
                   const std::optional<NaturalHamiltonian>& natural) {
  Ansatz a;
  const auto below = [&](long degree) {
    return pow(p.denominator, static_cast<unsigned long>(layer(natural.value(), degree, 0)));
  };
  a.denominator =
      bounds.layered ? below(bounds.degree) : ansatz_denominator(p, bounds.degree, bounds.power);
  const long extra = degree_of(p, bounds.layered ? p.denominator : a.denominator);
  if (extra > 0 && bounds.layered)
    for (long k = 0; k <= bounds.degree; ++k)
      a.layers.push_back(exact_div(a.denominator, below(bounds.degree - k)));
  for (const auto& e : MonomialList(p, bounds, natural, extra).all()) {
    std::vector<unsigned long> exponents(p.field.ring->size(), 0);
    std::size_t momenta = 0;
    for (std::size_t i = 0; i < e.size(); ++i) {
      exponents[p.variables[i]] = e[i];
      if (p.momentum[i]) momenta += e[i];
    }
    a.column.emplace(e, a.numerators.size());
    a.numerators.push_back(MPoly::term(p.field.ring, Integer(1), exponents));
    if (a.layers.empty()) continue;
    a.monomials.push_back(a.numerators.back());
    a.powers.push_back(layer(*natural, bounds.degree, static_cast<long>(momenta)));
    a.numerators.back() *= a.layers[momenta];
  }
  return a;
}

namespace {

// The parts of each degree in the momenta.
std::map<std::size_t, MPoly> by_momenta(const PhaseSpace& p, const MPoly& f) {
  const auto momenta = p.momenta();
  std::map<std::size_t, MPoly> all;
  for (long t = 0; t < f.length(); ++t) {
    const auto e = f.exponents(t);
    all.try_emplace(sum_at(e, momenta), f.ring()).first->second +=
        MPoly::term(f.ring(), f.coefficient(t), e);
  }
  return all;
}

// The columns of X(m/D^j), each degree in the momenta over the lowest common power of D.
std::vector<MPoly> layered_columns(const PhaseSpace& p, const Ansatz& ansatz,
                                   const std::vector<MPoly>& numerators, const Budget& budget) {
  const MPoly& den = p.denominator;
  const MPoly dd = derived(p.variables, numerators, den);
  std::vector<std::map<std::size_t, MPoly>> columns;
  std::map<std::size_t, long> highest;
  for (std::size_t j = 0; j < ansatz.monomials.size(); ++j) {
    budget.check();
    const MPoly& m = ansatz.monomials[j];
    const long power = ansatz.powers[j];
    const MPoly own = power == 0 ? derived(p.variables, numerators, m)
                                 : den * derived(p.variables, numerators, m) -
                                       MPoly(m.ring(), Integer(power)) * m * dd;
    columns.push_back(by_momenta(p, own));
    for (const auto& [k, part] : columns.back())
      highest[k] = std::max(highest[k], power == 0 ? 0 : power + 1);
  }
  std::vector<MPoly> all;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const long power = ansatz.powers[j] == 0 ? 0 : ansatz.powers[j] + 1;
    MPoly sum(p.field.ring);
    for (const auto& [k, part] : columns[j])
      sum += part * pow(den, static_cast<unsigned long>(highest[k] - power));
    all.push_back(std::move(sum));
  }
  return all;
}

// W^2 X(N/W), for each column, up to a common factor in each degree of the momenta.
std::vector<MPoly> derived_columns(const PhaseSpace& p, const Ansatz& ansatz,
                                   const std::vector<MPoly>& numerators, const Budget& budget) {
  if (!ansatz.layers.empty()) return layered_columns(p, ansatz, numerators, budget);
  std::vector<MPoly> all;
  const MPoly dw = derived(p.variables, numerators, ansatz.denominator);
  for (const MPoly& n : ansatz.numerators) {
    budget.check();
    all.push_back(ansatz.denominator * derived(p.variables, numerators, n) - n * dw);
  }
  return all;
}

} // namespace

EchelonForm equations_of(const PhaseSpace& p, const Ansatz& ansatz,
                         const std::vector<std::vector<MFraction>>& fields, const Budget& budget) {
  EchelonForm e;
  e.columns = ansatz.numerators.size();
  for (const auto& field : fields) {
    const auto x = on_variables(p, field);
    const MPoly den = common_denominator(p.field.ring, x);
    std::map<std::vector<unsigned long>, SparseRow> rows;
    MPoly scale(p.field.ring, Integer(1));
    const auto columns = derived_columns(p, ansatz, numerators(x, den), budget);
    for (std::size_t j = 0; j < e.columns; ++j) {
      budget.check();
      const MPoly& d = columns[j];
      MPoly here(p.field.ring, Integer(1));
      const auto column = p.coefficients(d, &here);
      // All columns over one denominator: what is there already is multiplied.
      const MPoly all = common_multiple(scale, here);
      if (const MPoly more = exact_div(all, scale); !is_one(more))
        for (auto& [m, row] : rows)
          for (auto& [i, c] : row)
            c *= more;
      scale = all;
      const MPoly own = exact_div(all, here);
      for (const auto& [m, c] : column)
        if (!is_zero(c)) rows[m].emplace(j, c * own);
    }
    for (auto& [m, row] : rows)
      e.rows.push_back(std::move(row));
  }
  return e;
}

namespace {

// The parts of each degree in the momenta, divided by the factors of their layers.
std::optional<MPoly> without_layers(const PhaseSpace& p, const Ansatz& ansatz, const MPoly& f) {
  if (ansatz.layers.empty()) return f;
  std::vector<MPoly> parts(ansatz.layers.size(), MPoly(f.ring()));
  for (const auto& [e, c] : by_monomials(f, p.variables)) {
    std::vector<unsigned long> exponents(f.ring()->size(), 0);
    std::size_t k = 0;
    for (std::size_t i = 0; i < e.size(); ++i) {
      exponents[p.variables[i]] = e[i];
      if (p.momentum[i]) k += e[i];
    }
    if (k >= parts.size()) return std::nullopt;
    parts[k] += c * MPoly::term(f.ring(), Integer(1), exponents);
  }
  MPoly sum(f.ring());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto quotient = divides(ansatz.layers[k], parts[k]);
    if (!quotient) return std::nullopt;
    sum += *quotient;
  }
  return sum;
}

} // namespace

std::optional<SparseRow> coordinates(const PhaseSpace& p, const Ansatz& ansatz,
                                     const MFraction& f) {
  const MFraction over = f * MFraction(ansatz.denominator);
  if (!is_parametric(p, over.den())) return std::nullopt;
  const auto numerator = without_layers(p, ansatz, over.num());
  if (!numerator) return std::nullopt;
  SparseRow row;
  for (const auto& [m, c] : p.coefficients(*numerator, nullptr)) {
    const bool constant = std::ranges::all_of(m, [](unsigned long k) { return k == 0; });
    if (constant && is_one(ansatz.denominator)) continue;
    const auto column = ansatz.column.find(m);
    if (column == ansatz.column.end()) return std::nullopt;
    row.emplace(column->second, c);
  }
  return row;
}

} // namespace kov
