#include "integrals/darboux.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"

#include <algorithm>
#include <functional>

namespace kov {
namespace {

// Beside the parameters: unknown coefficients of the cofactor of a polynomial that is looked for.
constexpr std::size_t most_unknown = 6;
constexpr std::size_t most_columns = 30;
constexpr double most_terms = 2e4; // where a plane is put into the field
constexpr double most_work = 1e6;  // in each of the ideals that come up

MPoly one(const Ring& ring) { return MPoly(ring, Integer(1)); }

} // namespace

MPoly derived(const std::vector<std::size_t>& variables, const std::vector<MPoly>& numerators,
              const MPoly& f) {
  MPoly sum(f.ring());
  for (std::size_t i = 0; i < variables.size(); ++i)
    if (uses(f, variables[i]) && !is_zero(numerators[i]))
      sum += numerators[i] * derivative(f, variables[i]);
  return sum;
}

std::optional<PolynomialField> polynomial_field(const PhaseSpace& p) {
  if (!p.is_polynomial_ring()) return std::nullopt;
  PolynomialField x;
  const MPoly all = common_denominator(p.field.ring, p.field.components);
  x.multiplier = one(p.field.ring);
  for (const MFactor& f : factor(all).second)
    if (uses_any(f.base, p.variables))
      x.multiplier = x.multiplier * pow(f.base, static_cast<unsigned long>(f.exponent));
  x.denominator = exact_div(all, x.multiplier);
  x.numerators = numerators(p.field.components, all);
  for (const MPoly& f : x.numerators)
    x.degree = std::max(x.degree, degree_of(p, f));
  return x;
}

std::vector<MPoly> monomials(const Ring& ring, const std::vector<std::size_t>& variables,
                             long degree) {
  std::vector<MPoly> all{one(ring)};
  std::vector<std::pair<MPoly, std::size_t>> last{{one(ring), 0}}; // with the last variable used
  for (long d = 1; d <= degree; ++d) {
    std::vector<std::pair<MPoly, std::size_t>> next;
    for (const auto& [m, from] : last)
      for (std::size_t i = from; i < variables.size(); ++i)
        next.emplace_back(m * MPoly::variable(ring, variables[i]), i);
    for (const auto& [m, i] : next)
      all.push_back(m);
    last = std::move(next);
  }
  return all;
}

namespace {

// The number of terms of a power of a sum of n terms.
double terms_of_power(std::size_t n, long degree) {
  double terms = 1;
  for (std::size_t k = 1; k < n; ++k)
    terms *= static_cast<double>(degree + static_cast<long>(k)) / static_cast<double>(k);
  return terms;
}

/// f with unknown coefficients, or with an unknown cofactor: these count as further parameters, and
/// the equations are solved at all values of both.
class DarbouxSearch {
public:
  DarbouxSearch(const PhaseSpace& p, const PolynomialField& x, const Set& where, Budget budget)
      : p_(p), x_(x), where_(where), budget_(std::move(budget)) {}

  /// Darboux polynomials of degree 1, any cofactor: X(f) vanishes where f does.
  std::vector<DarbouxPolynomial> planes() {
    for (std::size_t i = 0; i < p_.variables.size(); ++i)
      if (terms_of_power(p_.variables.size() - i, x_.degree) <= most_terms) planes_through(i);
    return std::move(found_);
  }
  /// Up to a degree, cofactors up to a degree: linear in f.
  std::vector<DarbouxPolynomial> with_cofactor(long degree, long cofactor_degree) {
    const auto k = monomials(p_.field.ring, p_.variables, cofactor_degree);
    const auto f = monomials(p_.field.ring, p_.variables, degree);
    if (k.size() > most_unknown || f.size() > most_columns) return {};
    add_unknowns(k.size());
    auto columns = mapped<MPoly>(f, [&](const MPoly& m) { return there(m); });
    MPoly cofactor(ring_);
    for (std::size_t i = 0; i < k.size(); ++i)
      cofactor += MPoly::variable(ring_, unknown_[i]) * there(k[i]);
    for_each_kernel(
        set_there(), equations_for(columns, cofactor),
        [&](const Set& set, const EchelonForm& done) {
          if (done.pivots.size() == done.columns) return;
          auto left = set.equations();
          const auto values = unknown_values(set, left);
          if (!values) return;
          const MFraction known = here(substitute(cofactor, *values)) / MFraction(x_.denominator);
          for (const auto& vector : kernel_basis(set, done)) {
            MFraction sum(ring_);
            for (const auto& [j, c] : vector)
              sum += substitute(c, *values) * MFraction(columns[j]);
            add_if_irreducible(here(sum).num(), known, equations_here(left));
          }
        },
        budget_);
    return std::move(found_);
  }

private:
  // ---- the ring with unknowns

  void add_unknowns(std::size_t count) {
    auto names = p_.field.ring->names();
    unknown_.clear();
    for (std::size_t i = 0; i < count; ++i) {
      std::string name = "K" + std::to_string(i);
      while (is_among(name, names))
        name += '_';
      unknown_.push_back(names.size());
      names.push_back(std::move(name));
    }
    ring_ = make_ring(std::move(names));
    numerators_.clear();
    for (const MPoly& f : x_.numerators)
      numerators_.push_back(there(f));
  }
  MPoly there(const MPoly& f) const { return transfer(MFraction(f), ring_).num(); }
  MFraction here(const MFraction& f) const { return transfer(f, p_.field.ring); }

  Set set_there() const {
    auto parameters = unknown_;
    parameters.insert(parameters.end(), p_.parameters.begin(), p_.parameters.end());
    Set set(ring_, parameters, budget_);
    for (const MPoly& f : where_.inequations())
      set = set.where_nonzero(there(f));
    for (const MPoly& f : where_.equations())
      set = set.where_zero(there(f));
    return set;
  }
  // The equations between parameters that do not hold on the whole set.
  std::vector<MPoly> equations_here(const std::vector<MPoly>& left) const {
    std::vector<MPoly> equations;
    for (const MPoly& f : left)
      if (const MPoly g = here(MFraction(f)).num(); !is_zero(where_.restrict(g)))
        equations.push_back(g);
    return equations;
  }

  // The unknowns as functions of the parameters; unset where they are not rational.
  std::optional<Substitution> unknown_values(const Set& set, std::vector<MPoly>& left) const {
    Substitution values;
    while (const auto step = next_value(set, left)) {
      for (auto& [j, value] : values)
        value = substitute(value, *step);
      values.insert(*step->begin());
      for (MPoly& f : left)
        f = substitute(f, *step).num();
      std::erase_if(left, [](const MPoly& f) { return is_zero(f); });
    }
    const bool rational =
        values.size() == unknown_.size() && std::ranges::none_of(values, [&](const auto& v) {
          return uses_any(v.second.num(), unknown_) || uses_any(v.second.den(), unknown_);
        });
    if (!rational) return std::nullopt;
    return values;
  }
  std::optional<Substitution> next_value(const Set& set, const std::vector<MPoly>& left) const {
    for (const MPoly& f : left)
      for (const std::size_t i : unknown_) {
        if (degree(f, i) != 1) continue;
        const auto c = coefficients(f, i);
        if (set.is_nonzero(c[1])) return Substitution{{i, -(MFraction(c[0]) / MFraction(c[1]))}};
      }
    return std::nullopt;
  }

  // ---- planes

  // x_i + sum over j > i of c_j x_j + c.
  void planes_through(std::size_t i) {
    add_unknowns(p_.variables.size() - i);
    MPoly rest = MPoly::variable(ring_, unknown_.front());
    for (std::size_t j = i + 1; j < p_.variables.size(); ++j)
      rest += MPoly::variable(ring_, unknown_[j - i]) * MPoly::variable(ring_, p_.variables[j]);
    const MPoly plane = MPoly::variable(ring_, p_.variables[i]) + rest;
    const MPoly along = derived(p_.variables, numerators_, plane);
    const MFraction on_it = substitute(along, Substitution{{p_.variables[i], -MFraction(rest)}});
    EchelonForm e; // one column: its kernel is not 0 where all rows vanish
    e.columns = 1;
    for (auto& [m, c] : by_monomials(on_it.num(), p_.variables))
      e.rows.push_back({{0, c}});
    const MFraction cofactor =
        (MFraction(along) - on_it) / MFraction(plane * there(x_.denominator));
    for_each_kernel(
        set_there(), std::move(e),
        [&](const Set& set, const EchelonForm& done) {
          if (!done.pivots.empty()) return;
          auto left = set.equations();
          if (const auto values = unknown_values(set, left))
            add_if_irreducible(here(substitute(plane, *values)).num(),
                               here(substitute(cofactor, *values)), equations_here(left));
        },
        budget_);
  }

  // ---- by cofactors

  EchelonForm equations_for(const std::vector<MPoly>& columns, const MPoly& cofactor) const {
    std::map<std::vector<unsigned long>, SparseRow> rows;
    for (std::size_t j = 0; j < columns.size(); ++j)
      for (auto& [m, c] :
           by_monomials(derived(p_.variables, numerators_, columns[j]) - cofactor * columns[j],
                        p_.variables))
        rows[m].emplace(j, c);
    EchelonForm e;
    e.columns = columns.size();
    for (auto& [m, row] : rows)
      e.rows.push_back(std::move(row));
    return e;
  }

  // A factor that is Darboux too is found by itself.
  void add_if_irreducible(const MPoly& f, const MFraction& k, const std::vector<MPoly>& equations) {
    std::optional<MPoly> base;
    for (const MFactor& x : factor(f).second)
      if (uses_any(x.base, p_.variables)) {
        if (base || x.exponent > 1) return;
        base = x.base;
      }
    if (base) found_.push_back({*base, k, equations});
  }

  const PhaseSpace& p_;
  const PolynomialField& x_;
  const Set& where_;
  Budget budget_;
  Ring ring_;
  std::vector<MPoly> numerators_; ///< in that ring
  std::vector<std::size_t> unknown_;
  std::vector<DarbouxPolynomial> found_;
};

// x_i divides X_i.
std::vector<DarbouxPolynomial> coordinates_that_are(const PhaseSpace& p, const PolynomialField& x) {
  std::vector<DarbouxPolynomial> all;
  for (std::size_t i = 0; i < p.variables.size(); ++i) {
    const MPoly f = MPoly::variable(p.field.ring, p.variables[i]);
    if (is_zero(x.numerators[i])) continue; // a first integral
    if (const auto k = divides(f, x.numerators[i]))
      all.push_back({f, MFraction(*k, x.denominator), {}});
  }
  return all;
}

} // namespace

std::vector<DarbouxPolynomial> darboux_polynomials(const PhaseSpace& p, const PolynomialField& x,
                                                   const Set& where, const Budget& budget) {
  auto all = coordinates_that_are(p, x);
  const auto add = [&](DarbouxPolynomial f) {
    const bool known = std::ranges::any_of(all, [&](const DarbouxPolynomial& g) {
      return g.polynomial == f.polynomial && g.equations.empty();
    });
    const bool integral = is_zero(f.cofactor) && f.equations.empty();
    if (!known && !integral) all.push_back(std::move(f));
  };
  using Search = std::function<std::vector<DarbouxPolynomial>(DarbouxSearch&)>;
  std::vector<Search> searches{[](DarbouxSearch& s) { return s.planes(); },
                               [](DarbouxSearch& s) { return s.with_cofactor(2, 0); }};
  if (p.variables.size() == 2 && x.degree == 2)
    searches.emplace_back([](DarbouxSearch& s) { return s.with_cofactor(2, 1); });
  Budget own = budget;
  own.max_work = std::min(own.max_work, most_work);
  for (const Search& search : searches)
    try {
      DarbouxSearch here(p, x, where, own);
      for (DarbouxPolynomial& f : search(here))
        add(std::move(f));
    } catch (const OutOfBudget&) { // nothing is said of others
      budget.check();
    }
  return all;
}

EchelonForm equations_of(const PhaseSpace& p, const PolynomialField& x,
                         const LogarithmicAnsatz& ansatz) {
  std::map<std::vector<unsigned long>, SparseRow> rows;
  EchelonForm e;
  std::vector<MFraction> columns;
  for (const DarbouxPolynomial& f : ansatz.polynomials)
    columns.push_back(f.cofactor * MFraction(x.denominator * ansatz.below));
  const MFraction k = ansatz.cofactor * MFraction(x.denominator);
  for (const MPoly& m : ansatz.monomials)
    columns.push_back(MFraction(derived(p.variables, x.numerators, m)) - k * MFraction(m));
  const MPoly den = common_denominator(p.field.ring, columns);
  for (const MFraction& f : columns) {
    if (!is_zero(f))
      for (auto& [m, c] : by_monomials((f * MFraction(den)).num(), p.variables))
        rows[m].emplace(e.columns, c);
    ++e.columns;
  }
  for (auto& [m, row] : rows)
    e.rows.push_back(std::move(row));
  return e;
}

EchelonForm commuting_fields(const PhaseSpace& p, const PolynomialField& x,
                             const std::vector<MPoly>& monomials, const MFraction& cofactor_of_w,
                             const std::vector<std::vector<MFraction>>& gradients,
                             const Budget& budget) {
  const std::size_t n = p.variables.size();
  const MFraction k = cofactor_of_w * MFraction(x.denominator);
  const MPoly below = is_zero(k) ? one(p.field.ring) : k.den();
  const MPoly above = is_zero(k) ? MPoly(p.field.ring) : k.num();
  std::map<std::pair<std::size_t, std::vector<unsigned long>>, SparseRow> rows;
  EchelonForm e;
  const auto put = [&](std::size_t equation, const MPoly& f) {
    for (auto& [m, c] : by_monomials(f, p.variables))
      if (!is_zero(c)) rows[{equation, m}].emplace(e.columns, c);
  };
  for (std::size_t i = 0; i < n; ++i)
    for (const MPoly& m : monomials) { // m d/dx_i
      budget.check();
      const MPoly own = below * derived(p.variables, x.numerators, m) - above * m;
      for (std::size_t j = 0; j < n; ++j) {
        const MPoly rest = below * m * derivative(x.numerators[j], p.variables[i]);
        put(j, i == j ? own - rest : -rest);
      }
      for (std::size_t g = 0; g < gradients.size(); ++g)
        if (const MFraction& d = gradients[g][i]; !is_zero(d))
          put(n + g, m * (d * MFraction(common_denominator(p.field.ring, gradients[g]))).num());
      ++e.columns;
    }
  for (auto& [key, row] : rows)
    e.rows.push_back(std::move(row));
  return e;
}

std::vector<MFraction> commutator(const VectorField& v, const std::vector<MFraction>& x,
                                  const std::vector<MFraction>& y) {
  std::vector<MFraction> all;
  for (std::size_t i = 0; i < x.size(); ++i) {
    MFraction sum(v.ring);
    for (std::size_t j = 0; j < x.size(); ++j)
      sum += x[j] * partial(v, y[i], j) - y[j] * partial(v, x[i], j);
    all.push_back(std::move(sum));
  }
  return all;
}

} // namespace kov
