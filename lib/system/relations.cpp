#include "system/relations.hpp"

#include "exact/error.hpp"
#include "exact/finite_algebra.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr long candidates = 40, points = 4;
constexpr long most_branches = 200;

std::vector<std::size_t> without(std::vector<std::size_t> all,
                                 const std::vector<std::size_t>& left_out) {
  std::erase_if(all, [&](std::size_t i) { return is_among(i, left_out); });
  return all;
}

/// The zeros of I over the field K of the independent variables.
class Branches {
public:
  Branches(const Ideal& whole, std::vector<MPoly> relations)
      : Branches(whole, std::move(relations), whole.independent_variables()) {}

  /// The branches above a line or a point: `where` gives values to variables of K.
  [[nodiscard]] Branches above(const Ideal& whole, const Substitution& where) const {
    std::vector<MPoly> there;
    for (const MPoly& f : relations_)
      there.push_back(substitute(MFraction(f), where).num());
    return {whole, std::move(there), independent_};
  }

  /// The inverted polynomials have zeros in the independent variables, and components may lie above these:
  /// the closure of the zeros elsewhere, or nothing if there are no such zeros.
  [[nodiscard]] std::optional<Ideal> closure(const Ideal& whole) const {
    const std::vector<MPoly> inverted = inverted_with(independent_);
    if (inverted.empty()) return std::nullopt;
    return Ideal(whole.ring(), whole.main(), relations_, inverted, whole.budget());
  }

  /// A characteristic polynomial that is irreducible at a point is so in general: much cheaper.
  [[nodiscard]] bool one_above_a_point(const Ideal& whole) const {
    for (long k = 0; k < points; ++k) {
      const Substitution point = numbers(k);
      if (std::ranges::any_of(inverted(),
                              [&](const MPoly& f) { return is_zero(substitute(f, point)); }))
        continue;
      if (above(whole, point).is_irreducible()) return true;
    }
    return false;
  }

  /// Nothing if the algebra is a field.
  [[nodiscard]] std::optional<std::string> several() const {
    for (long k = 0; k < candidates; ++k) {
      const MFraction theta = candidate(k);
      const auto minimal = algebra_.minimal_polynomial(*algebra_.evaluate(theta));
      const auto factors = branches(minimal);
      if (factors.size() > 1 || factors[0].exponent > 1) return written(factors, theta);
      if (minimal.size() == algebra_.dimension() + 1) return std::nullopt; // theta generates it
    }
    return "the relations are not seen to have one irreducible solution";
  }

  [[nodiscard]] const std::vector<std::size_t>& independent() const { return independent_; }
  [[nodiscard]] const std::vector<MPoly>& inverted() const { return algebra_.ideal().inverted(); }
  [[nodiscard]] std::size_t degree() const { return algebra_.dimension(); }
  [[nodiscard]] std::size_t unknown() const { return dependent_[0]; }
  /// F, F(theta) = 0 of degree dim for a generator theta, without denominators; the first dependent
  /// variable stands for its unknown.  Nothing if none of the candidates generates the algebra.
  [[nodiscard]] std::optional<MPoly> equation() const {
    for (long k = 0; k < candidates; ++k) {
      const auto minimal = algebra_.minimal_polynomial(*algebra_.evaluate(candidate(k)));
      if (minimal.size() == algebra_.dimension() + 1) return polynomial(minimal).num();
    }
    return std::nullopt;
  }
  [[nodiscard]] std::vector<MPoly> inverted_with(const std::vector<std::size_t>& variables) const {
    std::vector<MPoly> all;
    for (const MPoly& f : inverted())
      if (uses_any(f, variables)) all.push_back(f);
    return all;
  }

private:
  Branches(const Ideal& whole, std::vector<MPoly> relations, std::vector<std::size_t> independent)
      : independent_(std::move(independent)), dependent_(without(whole.main(), independent_)),
        relations_(std::move(relations)),
        algebra_(Ideal(whole.ring(), dependent_, relations_, {}, whole.budget()), most_branches) {}

  // Some numbers for all variables of K.
  [[nodiscard]] Substitution numbers(long k) const {
    Substitution point;
    const Ring& ring = algebra_.ring();
    for (std::size_t i = 0; i < ring->size(); ++i)
      if (!is_among(i, dependent_))
        point[i] = MFraction(ring, Rational(static_cast<long>(i * i) + 3 * k + 2, 1 + k));
    return point;
  }
  [[nodiscard]] bool is_irreducible() const {
    const long general = static_cast<long>(dependent_.size()) + 1;
    const auto f = algebra_.minimal_polynomial(*algebra_.evaluate(candidate(general)));
    const auto factors = branches(f);
    return f.size() == algebra_.dimension() + 1 && factors.size() == 1 && factors[0].exponent == 1;
  }
  // x1, x2, ..., then x1 + k x2 + k^2 x3 + ...: all but finitely many generate a field.
  [[nodiscard]] MFraction candidate(long k) const {
    const Ring& ring = algebra_.ring();
    const auto n = static_cast<long>(dependent_.size());
    if (k < n) return MFraction::variable(ring, dependent_[static_cast<std::size_t>(k)]);
    MFraction theta(ring);
    Rational weight(1);
    for (const std::size_t i : dependent_) {
      theta += weight * MFraction::variable(ring, i);
      weight *= Rational(k - n + 1);
    }
    return theta;
  }

  // Coefficients over K; the first dependent variable stands for the unknown.
  [[nodiscard]] MFraction polynomial(const std::vector<MFraction>& coefficients) const {
    const MFraction t = MFraction::variable(algebra_.ring(), dependent_[0]);
    MFraction f(algebra_.ring());
    for (std::size_t i = coefficients.size(); i-- > 0;)
      f = f * t + coefficients[i];
    return f;
  }
  [[nodiscard]] std::vector<MFactor> branches(const std::vector<MFraction>& coefficients) const {
    std::vector<MFactor> found = factor(polynomial(coefficients).num()).second;
    std::erase_if(found, [&](const MFactor& x) { return !uses(x.base, dependent_[0]); });
    return found;
  }

  [[nodiscard]] std::string written(const std::vector<MFactor>& factors,
                                    const MFraction& theta) const {
    std::string text = "the relations have several solutions: ";
    for (const MFactor& f : factors) {
      const MFraction at = substitute(MFraction(f.base), {{dependent_[0], theta}});
      text += (&f == &factors.front() ? "(" : "*(") + to_string(at) + ")";
      if (f.exponent > 1) text += "^" + std::to_string(f.exponent);
    }
    return text + " = 0";
  }

  std::vector<std::size_t> independent_, dependent_;
  std::vector<MPoly> relations_;
  FiniteAlgebra algebra_;
};

bool has_other_components(const Ideal& whole, const std::optional<Ideal>& closure) {
  return closure && std::ranges::any_of(closure->basis(), [&](const KPoly& g) {
           return !whole.contains(closure->from_kpoly(g).num());
         });
}

/// Irreducible polynomials in the parameters, each once.
class Special {
public:
  explicit Special(std::vector<std::size_t> variables) : variables_(std::move(variables)) {}

  void add(const MPoly& f) {
    for (const MFactor& x : factor(f).second)
      if (!uses_any(x.base, variables_) && !is_constant(x.base) && !is_among(x.base, all_))
        all_.push_back(x.base);
  }
  [[nodiscard]] const std::vector<MPoly>& all() const { return all_; }

private:
  std::vector<std::size_t> variables_; ///< which no parameter is
  std::vector<MPoly> all_;
};

// U = p + t e; the first independent variable is t.
Substitution line(const Ring& ring, const std::vector<std::size_t>& independent, long number) {
  const MFraction t = MFraction::variable(ring, independent.front());
  Substitution all;
  long k = number;
  for (std::size_t i = 1; i < independent.size(); ++i) {
    k = (k * 7 + 3) % 11; // any numbers
    all[independent[i]] = Rational(k + 1) * t + MFraction(ring, Rational(2 * k + number, 3));
  }
  return all;
}

/// The cover above a line.
class OnLine {
public:
  OnLine(const Ideal& whole, const Branches& all, long number)
      : t_(all.independent().front()), unknown_(all.unknown()) {
    const Substitution where = line(whole.ring(), all.independent(), number);
    for (const MPoly& g : all.inverted_with(all.independent()))
      bad_.push_back(substitute(MFraction(g), where).num());
    if (std::ranges::any_of(bad_, [](const MPoly& g) { return is_zero(g); })) return;
    const Branches there = all.above(whole, where);
    bad_.insert(bad_.end(), there.inverted().begin(), there.inverted().end());
    if (there.degree() == all.degree()) f_ = there.equation();
  }

  /// For general parameters the cover is irreducible above the line, of the same degree.
  [[nodiscard]] bool is_general() const {
    if (!f_) return false;
    long factors = 0;
    for (const MFactor& x : factor(*f_).second)
      if (uses(x.base, unknown_)) factors += static_cast<long>(x.exponent);
    return factors == 1;
  }

  /// Adds the cases in which points of the line above which the cover is branched meet or go to infinity.
  void add_to(Special& special) const {
    std::vector<MPoly> branched;
    const auto add = [&](const MPoly& g) {
      special.add(g);
      for (const MFactor& x : factor(g).second)
        if (uses(x.base, t_) && !is_among(x.base, branched)) branched.push_back(x.base);
    };
    add(coefficients(*f_, unknown_).back());
    if (degree(*f_, unknown_) > 1) add(discriminant(*f_, unknown_));
    for (const MPoly& g : bad_)
      add(g);
    for (std::size_t i = 0; i < branched.size(); ++i) {
      special.add(coefficients(branched[i], t_).back());
      if (degree(branched[i], t_) > 1) special.add(discriminant(branched[i], t_));
      for (std::size_t j = 0; j < i; ++j)
        special.add(resultant(branched[i], branched[j], t_));
    }
  }

private:
  std::size_t t_, unknown_;
  std::optional<MPoly> f_;
  std::vector<MPoly> bad_; ///< what was inverted
};

// The common irreducible factors of f, g, ... (lists of such), if the rest has no common zeros.
std::vector<MPoly> common_zeros(const VectorField& v, const std::vector<std::vector<MPoly>>& all,
                                const Budget& budget) {
  std::vector<MPoly> common, products, rest;
  const auto in = [](const std::vector<MPoly>& some, const MPoly& f) { return is_among(f, some); };
  const auto product = [&](const std::vector<MPoly>& some, bool of_all) {
    MPoly p(v.ring, Integer(1));
    for (const MPoly& f : some)
      if (of_all || !in(common, f)) p = p * f;
    return p;
  };
  for (const MPoly& f : all.front())
    if (std::ranges::all_of(all, [&](const auto& some) { return in(some, f); }))
      common.push_back(f);
  for (const auto& some : all) {
    products.push_back(product(some, true));
    rest.push_back(product(some, false));
  }
  if (!Ideal(v.ring, v.parameters, rest, {}, budget).is_unit()) return products;
  const MPoly p = product(common, true);
  return is_constant(p) ? std::vector<MPoly>{} : std::vector<MPoly>{p};
}

bool functions_use_parameters(const VectorField& v) {
  return std::ranges::any_of(v.relations, [&](const MPoly& f) {
    return uses_any(f, v.parameters) &&
           std::ranges::any_of(v.functions,
                               [&](const FunctionSymbol& s) { return uses(f, s.variable); });
  });
}

constexpr long lines = 3, most_lines = 12;

bool share(const MPoly& f, const MPoly& g, const std::vector<std::size_t>& variables) {
  return std::ranges::any_of(variables, [&](std::size_t i) { return uses(f, i) && uses(g, i); });
}

// Relations that have no variables in common: the solutions are a product.
std::vector<std::vector<MPoly>> independent_relations(const VectorField& v) {
  std::vector<std::vector<MPoly>> groups;
  const auto main = v.main_variables();
  for (const MPoly& f : v.relations) {
    std::vector<MPoly> mine{f};
    std::erase_if(groups, [&](const std::vector<MPoly>& group) {
      const bool meets =
          std::ranges::any_of(group, [&](const MPoly& g) { return share(f, g, main); });
      if (meets) mine.insert(mine.end(), group.begin(), group.end());
      return meets;
    });
    groups.push_back(std::move(mine));
  }
  return groups;
}

VectorField with_relations_alone(const VectorField& v, const std::vector<MPoly>& group) {
  VectorField part = v;
  part.relations = group;
  part.components.clear();
  part.hamiltonian.reset();
  part.poisson.reset();
  std::erase_if(part.functions,
                [&](const FunctionSymbol& s) { return !any_uses(group, s.variable); });
  return part;
}

// Polynomials that vanish together exactly where all of one list or all of the other do.  Empty: no list.
std::vector<MPoly> either(const std::vector<MPoly>& a, const std::vector<MPoly>& b) {
  if (a.empty() || b.empty()) return a.empty() ? b : a;
  std::vector<MPoly> products;
  for (const MPoly& f : a)
    for (const MPoly& g : b)
      products.push_back(squarefree_part(f * g));
  return products;
}

} // namespace

std::optional<std::string> reducible_relations(const VectorField& v, const Budget& budget) {
  const Ideal whole = relation_ideal(v, {}, {}, budget);
  if (whole.is_zero_ideal()) return std::nullopt;
  if (whole.is_unit()) return "the relations have no solution for general values of the parameters";
  const Branches branches(whole, v.relations);
  if (!branches.one_above_a_point(whole))
    if (auto several = branches.several()) return several;
  if (has_other_components(whole, branches.closure(whole)))
    return "the relations have another solution at special values of the coordinates";
  return std::nullopt;
}

std::vector<MPoly> where_relations_fall_apart(const VectorField& v, const Budget& budget) {
  if (!functions_use_parameters(v)) return {};
  if (const auto groups = independent_relations(v); groups.size() > 1) {
    std::vector<MPoly> somewhere; // a product is irreducible where its factors are
    for (const auto& group : groups)
      somewhere =
          either(somewhere, where_relations_fall_apart(with_relations_alone(v, group), budget));
    return somewhere;
  }
  const Ideal whole = relation_ideal(v, {}, {}, budget);
  const Branches branches(whole, v.relations);
  if (branches.independent().empty()) return {}; // one point with its conjugates
  Special always(v.main_variables());
  for (const MPoly& f : branches.inverted())
    always.add(f);
  for (const MPoly& f : whole.inverted())
    always.add(f);
  if (const auto closure = branches.closure(whole))
    for (const MPoly& f : closure->inverted())
      always.add(f);
  std::vector<std::vector<MPoly>> found;
  for (long k = 0; k < most_lines && found.size() < lines; ++k) {
    const OnLine one(whole, branches, k);
    if (!one.is_general()) continue;
    Special special = always;
    one.add_to(special);
    if (special.all().empty()) return {};
    found.push_back(special.all());
  }
  if (found.empty())
    throw OutOfBudget("where the relations fall apart was not found: no line in general position");
  return common_zeros(v, found, budget);
}

std::vector<QuadraticConstant> quadratic_constants(const VectorField& v) {
  std::vector<QuadraticConstant> all;
  const auto is_parameter = [&](std::size_t i) { return is_among(i, v.parameters); };
  for (const std::size_t c : v.constants)
    for (const MPoly& relation : v.relations) {
      const auto used = used_variables(relation);
      if (degree(relation, c) == 2 &&
          std::ranges::all_of(used, [&](std::size_t i) { return i == c || is_parameter(i); }))
        all.push_back({c, relation});
    }
  return all;
}

} // namespace kov
