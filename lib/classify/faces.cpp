#include "classify/faces.hpp"

#include "exact/finite_algebra.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"
#include "integrability/parameters.hpp"
#include "integrals/ansatz.hpp"
#include "study/curve.hpp"
#include "system/in_ring.hpp"

#include <algorithm>

namespace kov {
namespace {

bool is_constant_of(const VectorField& v, const MFraction& f) {
  const auto used = used_variables(f);
  return std::ranges::all_of(
      used, [&](std::size_t i) { return is_among(i, v.parameters) || is_among(i, v.constants); });
}

// Coordinates that nothing contains but through functions.
std::vector<std::size_t> hidden_coordinates(const VectorField& v) {
  std::vector<std::size_t> hidden;
  for (std::size_t j = 0; j < v.dimension(); ++j) {
    const std::size_t x = v.coordinates[j];
    const bool seen = any_uses(v.components, x) || uses(*v.hamiltonian, x) ||
                      std::ranges::any_of(v.functions, [&](const FunctionSymbol& f) {
                        return any_uses(f.gradient, x);
                      });
    const bool has_functions = std::ranges::any_of(
        v.functions, [j](const FunctionSymbol& f) { return !is_zero(f.gradient[j]); });
    if (!seen && has_functions) hidden.push_back(j);
  }
  return hidden;
}

// The exponents of exponentials in the hidden coordinates; unset: some function of them is none.
std::optional<Matrix> exponents(const VectorField& v, const std::vector<std::size_t>& hidden,
                                std::vector<std::size_t>& exponentials) {
  Matrix a;
  for (const FunctionSymbol& f : v.functions) {
    const MFraction u = MFraction::variable(v.ring, f.variable);
    std::vector<MFraction> row;
    bool only_hidden = true;
    for (std::size_t j = 0; j < v.dimension(); ++j)
      if (is_among(j, hidden))
        row.push_back(f.gradient[j] / u);
      else
        only_hidden = only_hidden && is_zero(f.gradient[j]);
    if (std::ranges::all_of(row, [](const MFraction& x) { return is_zero(x); })) continue;
    if (!only_hidden ||
        !std::ranges::all_of(row, [&](const MFraction& x) { return is_constant_of(v, x); }))
      return std::nullopt;
    a.push_back(std::move(row));
    exponentials.push_back(f.variable);
  }
  return a;
}

// The maximal minors that are not 0.
std::vector<MPoly> minors(const Matrix& a, std::size_t columns, const Ring& ring) {
  std::vector<MPoly> all;
  static_cast<void>(some_minor(a, columns, ring, [&](const MFraction& d) {
    if (!is_zero(d)) all.push_back(d.num());
    return false; // all of them
  }));
  return all;
}

constexpr std::size_t most_hidden = 8;

// Keeps nothing of the Hamiltonian system but its field.
System without_bracket(System s) {
  s.kind = SystemKind::vector_field;
  s.field.hamiltonian.reset();
  s.field.poisson.reset();
  s.claims.clear();
  s.manifolds.clear();
  s.reductions.clear();
  s.lagrangian.reset();
  return s;
}

// The field in the other coordinates and the exponentials.
void use_as_coordinates(const VectorField& v, const std::vector<std::size_t>& hidden,
                        ExponentialCoordinates& x) {
  VectorField& field = x.system.field;
  field.coordinates.clear();
  field.components.clear();
  std::erase_if(field.functions,
                [&](const FunctionSymbol& f) { return is_among(f.variable, x.exponentials); });
  for (FunctionSymbol& f : field.functions) {
    std::vector<MFraction> gradient;
    for (std::size_t j = 0; j < v.dimension(); ++j)
      if (!is_among(j, hidden)) gradient.push_back(f.gradient[j]);
    gradient.resize(gradient.size() + x.exponentials.size(), MFraction(v.ring));
    f.gradient = std::move(gradient);
  }
  for (std::size_t j = 0; j < v.dimension(); ++j) {
    if (is_among(j, hidden)) {
      x.instead_of.push_back(v.coordinates[j]);
      continue;
    }
    field.coordinates.push_back(v.coordinates[j]);
    field.components.push_back(v.components[j]);
  }
  for (const std::size_t u : x.exponentials) {
    field.coordinates.push_back(u);
    field.components.push_back(lie_derivative(v, MFraction::variable(v.ring, u)));
  }
}

} // namespace

std::optional<ExponentialCoordinates> exponential_coordinates(const System& s) {
  const VectorField& v = s.field;
  if (!v.hamiltonian || !v.poisson) return std::nullopt;
  const auto hidden = hidden_coordinates(v);
  std::vector<std::size_t> exponentials;
  const auto a = exponents(v, hidden, exponentials);
  if (!a || a->empty() || a->size() > hidden.size() || hidden.size() > most_hidden)
    return std::nullopt;
  const bool related =
      std::ranges::any_of(v.relations, [&](const MPoly& f) { return uses_any(f, exponentials); });
  auto independent = minors(*a, hidden.size(), v.ring);
  if (related || independent.empty()) return std::nullopt;
  ExponentialCoordinates x{
      without_bracket(s), *v.hamiltonian, exponentials, {}, std::move(independent)};
  use_as_coordinates(v, hidden, x);
  const auto is_defined = [&](const MFraction& f) { return !uses_any(f.den(), exponentials); };
  const auto& components = x.system.field.components;
  if (!is_defined(x.hamiltonian) || !std::ranges::all_of(components, is_defined))
    return std::nullopt;
  return x;
}

namespace {

// The coefficients of f by monomials in all that moves.
std::map<std::vector<ulong>, MFraction> coefficients_of(const VectorField& v, const MFraction& f) {
  std::map<std::vector<ulong>, MFraction> all;
  if (is_zero(f)) return all;
  std::vector<std::size_t> main = v.coordinates;
  for (const FunctionSymbol& u : v.functions)
    main.push_back(u.variable);
  for (const auto& [monomial, c] : by_monomials(f.num(), main))
    all.emplace(monomial, MFraction(c) / MFraction(f.den()));
  return all;
}

// A basis of the sums c_i x_i, c constant, that are constant.
std::vector<std::vector<MFraction>> constant_combinations(const VectorField& v,
                                                          const std::vector<std::size_t>& of,
                                                          const Substitution& at,
                                                          const Budget& budget) {
  std::map<std::vector<ulong>, std::vector<MFraction>> rows; // by the monomial
  for (std::size_t k = 0; k < of.size(); ++k) {
    const auto j =
        static_cast<std::size_t>(std::ranges::find(v.coordinates, of[k]) - v.coordinates.begin());
    const MFraction f = substitute(v.components[j], at);
    if (!is_constant_of(v, MFraction(f.den()))) return {};
    for (const auto& [monomial, coefficient] : coefficients_of(v, f)) {
      auto& row = rows[monomial];
      row.resize(of.size(), MFraction(v.ring));
      row[k] = coefficient;
    }
  }
  Matrix m;
  for (auto& [monomial, row] : rows)
    m.push_back(std::move(row));
  return null_space(std::move(m), of.size(), v.ring, budget);
}
std::vector<MFraction> without_denominators(std::vector<MFraction> row) {
  for (const MFraction& x : std::vector<MFraction>(row))
    if (const MFraction den(x.den()); !is_constant(den))
      for (MFraction& y : row)
        y = y * den;
  return row;
}
/// Two exponentials, the others being 0: one of the two vanishes on the solutions as well.
class Face {
public:
  Face(const ExponentialCoordinates& x, std::size_t moving, std::size_t vanishing)
      : x_(x), moving_(moving), vanishing_(vanishing) {}

  /// In the ring of the Hamiltonian system.
  [[nodiscard]] std::vector<Exclusion> exclusions(const System& s, const CheckOptions& options) {
    restrict_to_two();
    find_linear_integrals(options.decide.budget);
    if (free_.empty()) return {};
    name_levels();
    const auto spec = manifold();
    if (!spec) return {};
    const ManifoldReport report = study_curve(system_, *spec, {}, options);
    std::vector<Exclusion> all;
    for (Exclusion& e : kov::exclusions(system_, report, level_parameters(system_)))
      if (auto here = in_ring_of(s, e)) all.push_back(*std::move(here));
    return all;
  }

private:
  // The field on {e_i = 0, i neither of the two}.
  void restrict_to_two() {
    system_ = x_.system;
    hamiltonian_ = x_.hamiltonian;
    Substitution zero;
    for (const std::size_t u : x_.exponentials)
      if (u != moving_ && u != vanishing_) zero[u] = MFraction(system_.ring());
    VectorField& v = system_.field;
    for (std::size_t j = v.dimension(); j-- > 0;)
      if (zero.count(v.coordinates[j])) {
        v.coordinates.erase(v.coordinates.begin() + static_cast<long>(j));
        v.components.erase(v.components.begin() + static_cast<long>(j));
        for (FunctionSymbol& f : v.functions)
          f.gradient.erase(f.gradient.begin() + static_cast<long>(j));
      }
    for (MFraction& c : v.components)
      c = substitute(c, zero);
    hamiltonian_ = substitute(hamiltonian_, zero);
  }

  // sum c_i x_i, c constant, over the coordinates that are not exponentials: a basis of those that
  // are constant, and one of those that are so where the second exponential is 0.
  void find_linear_integrals(const Budget& budget) {
    for (const std::size_t i : system_.field.coordinates)
      if (i != moving_ && i != vanishing_) others_.push_back(i);
    for (auto& row : constant_combinations(system_.field, others_, {}, budget))
      fixed_.push_back(without_denominators(std::move(row)));
    const auto on_the_face = constant_combinations(
        system_.field, others_, {{vanishing_, MFraction(system_.ring())}}, budget);
    auto known = fixed_;
    for (const auto& row : on_the_face) {
      const auto c = without_denominators(row);
      known.push_back(c);
      if (null_space(known, others_.size(), system_.ring(), budget).size() + known.size() ==
          others_.size())
        free_.push_back(c);
      else
        known.pop_back();
    }
  }
  // One constant c1, c2, ... for each linear integral of the face system that the full system does not
  // have.
  void name_levels() {
    auto names = system_.ring()->names();
    const std::size_t first = names.size();
    for (std::size_t k = 0; k < free_.size(); ++k) {
      std::string name = "c" + std::to_string(k + 1);
      while (is_among(name, names))
        name += "_";
      names.push_back(name);
    }
    const Ring ring = make_ring(names);
    system_ = in_ring(system_, ring);
    hamiltonian_ = transfer(hamiltonian_, ring);
    for (auto* list : {&fixed_, &free_})
      for (auto& row : *list)
        for (MFraction& c : row)
          c = transfer(c, ring);
    for (std::size_t k = 0; k < free_.size(); ++k) {
      system_.field.parameters.push_back(first + k);
      levels_.push_back(first + k);
    }
  }

  // One more equation of the manifold; the coordinate for which it is solved is put in elsewhere.
  void add_equation(const std::vector<MFraction>& row, const MFraction& value, ManifoldSpec& spec) {
    MFraction f(system_.ring());
    for (std::size_t k = 0; k < others_.size(); ++k)
      f += row[k] * MFraction::variable(system_.ring(), others_[k]);
    add(f - value, to_string(f) + " = " + to_string(value), spec);
    const MFraction left = substitute(f - value, solved_);
    for (const std::size_t i : others_) {
      const MFraction slope = derivative(left, i);
      if (solved_.count(i) || is_zero(slope)) continue;
      nonzero_.push_back(slope.num());
      nonzero_.push_back(slope.den());
      const Substitution step{{i, MFraction::variable(system_.ring(), i) - left / slope}};
      for (auto& [j, known] : solved_)
        known = substitute(known, step);
      solved_.insert(step.begin(), step.end());
      return;
    }
  }
  static void add(const MFraction& difference, const std::string& text, ManifoldSpec& spec) {
    spec.equations.push_back({difference, text});
    spec.name += (spec.name.empty() ? "" : ", ") + text;
  }

  // Through the point of the curve where the other exponential is 0 and the last coordinate is 1.
  [[nodiscard]] std::optional<ManifoldSpec> manifold() {
    const Ring& ring = system_.ring();
    if (others_.size() != fixed_.size() + free_.size() + 1) return std::nullopt;
    ManifoldSpec spec;
    for (const std::size_t u : x_.exponentials)
      if (u != moving_ && u != vanishing_)
        spec.name += (spec.name.empty() ? "" : ", ") + ring->name(u) + " = 0";
    add(MFraction::variable(ring, vanishing_), ring->name(vanishing_) + " = 0", spec);
    for (const auto& row : fixed_)
      add_equation(row, MFraction(ring), spec);
    for (std::size_t k = 0; k < free_.size(); ++k)
      add_equation(free_[k], MFraction::variable(ring, levels_[k]), spec);
    solved_[vanishing_] = MFraction(ring);
    const auto last =
        std::ranges::find_if(others_, [&](std::size_t i) { return !solved_.count(i); });
    if (last == others_.end()) return std::nullopt;
    const MFraction value =
        substitute(substitute(hamiltonian_, solved_),
                   {{moving_, MFraction(ring)}, {*last, MFraction(ring, Rational(1))}});
    if (!is_constant_of(system_.field, value)) return std::nullopt;
    nonzero_.push_back(value.den());
    spec.levels.push_back({hamiltonian_ - value, "H = " + to_string(value)});
    return spec;
  }

  // Unset: it speaks of a variable of this face.
  [[nodiscard]] std::optional<Exclusion> in_ring_of(const System& s, Exclusion e) const {
    const auto move = [&](MFraction& f) {
      for (const std::size_t i : used_variables(f))
        if (is_among(i, levels_)) return false;
      f = transfer(f, s.ring());
      return true;
    };
    const auto move_all = [&](std::vector<MPoly>& all) {
      return std::ranges::all_of(all, [&](MPoly& p) {
        MFraction f(p);
        const bool done = move(f);
        if (done) p = f.num();
        return done;
      });
    };
    for (const MPoly& p : nonzero_)
      e.not_all_zero.push_back({p});
    if (!move_all(e.zero)) return std::nullopt;
    for (auto& list : e.not_all_zero)
      if (!move_all(list)) return std::nullopt;
    for (Statement& x : e.statements)
      if (!std::ranges::all_of(squares_of(x.says), move)) return std::nullopt;
    e.not_all_zero.push_back(x_.independent);
    e.by.integrals = integrals(s);
    e.by.trusted.push_back({Trusted::Step::exponential_coordinates});
    return e;
  }

  // Rational in the exponentials, and in the coordinates that are not behind them.
  [[nodiscard]] IntegralClass integrals(const System& s) const {
    IntegralClass c{.kind = IntegralClass::Kind::rational,
                    .near = IntegralClass::Near::phase_space};
    for (const FunctionSymbol& f : s.field.functions)
      c.functions.push_back(s.ring()->name(f.variable));
    for (const std::size_t i : x_.instead_of)
      c.without.push_back(s.ring()->name(i));
    for (const std::string& coordinate : c.without)
      for (const std::string& symbol : c.functions)
        c.through.emplace_back(coordinate, symbol);
    return c;
  }

  const ExponentialCoordinates& x_;
  std::size_t moving_, vanishing_;
  System system_;
  MFraction hamiltonian_;
  std::vector<std::size_t> others_, levels_;
  std::vector<std::vector<MFraction>> fixed_, free_;
  Substitution solved_;        ///< by the linear equations
  std::vector<MPoly> nonzero_; ///< for which they are solved, and the level has a value
};

} // namespace

std::vector<Exclusion> exclusions_at_faces(const System& s, const CheckOptions& options) {
  std::vector<Exclusion> all;
  const auto x = exponential_coordinates(s);
  if (!x) return all;
  for (const std::size_t moving : x->exponentials)
    for (const std::size_t vanishing : x->exponentials)
      if (moving != vanishing)
        for (Exclusion& e : Face(*x, moving, vanishing).exclusions(s, options))
          all.push_back(std::move(e));
  return all;
}

} // namespace kov
