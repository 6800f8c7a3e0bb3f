#include "system/relations.hpp"

#include "exact/error.hpp"
#include "exact/finite_algebra.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr long candidates = 40;
constexpr long most_branches = 64;

bool uses_one(const MPoly& f, const std::vector<std::size_t>& variables) {
  return std::any_of(variables.begin(), variables.end(), [&](std::size_t i) { return uses(f, i); });
}

std::vector<std::size_t> without(std::vector<std::size_t> all,
                                 const std::vector<std::size_t>& left_out) {
  std::erase_if(all, [&](std::size_t i) {
    return std::find(left_out.begin(), left_out.end(), i) != left_out.end();
  });
  return all;
}

/// The zeros of I over the field K of the independent variables.
class Branches {
public:
  Branches(const Ideal& whole, const std::vector<MPoly>& relations)
      : independent_(whole.independent_variables()),
        dependent_(without(whole.main(), independent_)),
        algebra_(Ideal(whole.ring(), dependent_, relations, {}, whole.budget()), most_branches) {}

  /// What was inverted has zeros in the independent variables, and components may lie above these:
  /// the closure of the zeros elsewhere, or nothing if there are no such zeros.
  [[nodiscard]] std::optional<Ideal> closure(const Ideal& whole,
                                             const std::vector<MPoly>& relations) const {
    const std::vector<MPoly> inverted = inverted_with(independent_);
    if (inverted.empty()) return std::nullopt;
    return Ideal(whole.ring(), whole.main(), relations, inverted, whole.budget());
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
  /// Where one of these vanishes the fibre may have other than dim points: what was inverted, the
  /// leading coefficient and the discriminant of F, F(theta) = 0 of degree dim; and F itself.
  struct Cover {
    MPoly f;
    std::size_t unknown;
    std::vector<MPoly> inverted;
  };
  [[nodiscard]] Cover cover() const {
    for (long k = 0; k < candidates; ++k) {
      const auto minimal = algebra_.minimal_polynomial(*algebra_.evaluate(candidate(k)));
      if (minimal.size() == algebra_.dimension() + 1)
        return {polynomial(minimal).num(), dependent_[0], inverted_with(independent_)};
    }
    throw OutOfBudget("no generator of the functions was found");
  }

private:
  [[nodiscard]] std::vector<MPoly> inverted_with(const std::vector<std::size_t>& variables) const {
    std::vector<MPoly> all;
    for (const MPoly& f : inverted())
      if (uses_one(f, variables)) all.push_back(f);
    return all;
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
  FiniteAlgebra algebra_;
};

bool has_other_components(const Ideal& whole, const std::optional<Ideal>& closure) {
  return closure &&
         std::any_of(closure->basis().begin(), closure->basis().end(),
                     [&](const KPoly& g) { return !whole.contains(closure->from_kpoly(g).num()); });
}

/// Irreducible polynomials in the parameters, each once.
class Special {
public:
  explicit Special(std::vector<std::size_t> variables) : variables_(std::move(variables)) {}

  void add(const MPoly& f) {
    for (const MFactor& x : factor(f).second)
      if (!uses_one(x.base, variables_) && !is_constant(x.base) &&
          std::find(all_.begin(), all_.end(), x.base) == all_.end())
        all_.push_back(x.base);
  }
  [[nodiscard]] const std::vector<MPoly>& all() const { return all_; }

private:
  std::vector<std::size_t> variables_; ///< which no parameter is
  std::vector<MPoly> all_;
};

/// The cover above the line U = p + t e; the first independent variable is t.
class OnLine {
public:
  OnLine(const Branches::Cover& cover, const std::vector<std::size_t>& independent, long number)
      : t_(independent.front()), unknown_(cover.unknown) {
    const Ring& ring = cover.f.ring();
    const MFraction t = MFraction::variable(ring, t_);
    long k = number;
    for (std::size_t i = 1; i < independent.size(); ++i) {
      k = (k * 7 + 3) % 11; // any numbers
      line_[independent[i]] = Rational(k + 1) * t + MFraction(ring, Rational(2 * k + number, 3));
    }
    f_ = restricted(cover.f);
    for (const MPoly& g : cover.inverted)
      bad_.push_back(restricted(g));
  }

  /// For general parameters the cover is irreducible above the line, of the same degree.
  [[nodiscard]] bool is_general(long degree_of_cover) const {
    if (is_zero(f_) || degree(f_, unknown_) != degree_of_cover) return false;
    if (std::any_of(bad_.begin(), bad_.end(), [](const MPoly& g) { return is_zero(g); }))
      return false;
    long factors = 0;
    for (const MFactor& x : factor(f_).second)
      if (uses(x.base, unknown_)) factors += static_cast<long>(x.exponent);
    return factors == 1;
  }

  /// Where points of the line above which the cover is branched come together or go to infinity.
  void add_to(Special& special) const {
    std::vector<MPoly> points;
    const auto add = [&](const MPoly& g) {
      special.add(g);
      for (const MFactor& x : factor(g).second)
        if (uses(x.base, t_) && std::find(points.begin(), points.end(), x.base) == points.end())
          points.push_back(x.base);
    };
    add(coefficients(f_, unknown_).back());
    if (degree(f_, unknown_) > 1) add(discriminant(f_, unknown_));
    for (const MPoly& g : bad_)
      add(g);
    for (std::size_t i = 0; i < points.size(); ++i) {
      special.add(coefficients(points[i], t_).back());
      if (degree(points[i], t_) > 1) special.add(discriminant(points[i], t_));
      for (std::size_t j = 0; j < i; ++j)
        special.add(resultant(points[i], points[j], t_));
    }
  }

private:
  [[nodiscard]] MPoly restricted(const MPoly& g) const {
    return substitute(MFraction(g), line_).num();
  }

  std::size_t t_, unknown_;
  Substitution line_;
  MPoly f_;
  std::vector<MPoly> bad_;
};

// Of f, g, ... as lists of irreducible factors: the common ones, if the rest has no common zeros.
std::vector<MPoly> common_zeros(const VectorField& v, const std::vector<std::vector<MPoly>>& all,
                                const Budget& budget) {
  std::vector<MPoly> common, products, rest;
  const auto in = [](const std::vector<MPoly>& some, const MPoly& f) {
    return std::find(some.begin(), some.end(), f) != some.end();
  };
  const auto product = [&](const std::vector<MPoly>& some, bool of_all) {
    MPoly p(v.ring, Integer(1));
    for (const MPoly& f : some)
      if (of_all || !in(common, f)) p = p * f;
    return p;
  };
  for (const MPoly& f : all.front())
    if (std::all_of(all.begin(), all.end(), [&](const auto& some) { return in(some, f); }))
      common.push_back(f);
  for (const auto& some : all) {
    products.push_back(product(some, true));
    rest.push_back(product(some, false));
  }
  if (!Ideal(v.ring, v.parameters, rest, {}, budget).is_unit()) return products;
  const MPoly p = product(all.front().size() == common.size() ? all.front() : common, true);
  return is_constant(p) ? std::vector<MPoly>{} : std::vector<MPoly>{p};
}

bool functions_use_parameters(const VectorField& v) {
  return std::any_of(v.relations.begin(), v.relations.end(), [&](const MPoly& f) {
    return uses_one(f, v.parameters) &&
           std::any_of(v.functions.begin(), v.functions.end(),
                       [&](const FunctionSymbol& s) { return uses(f, s.variable); });
  });
}

constexpr long lines = 3, most_lines = 12;

} // namespace

std::optional<std::string> reducible_relations(const VectorField& v, const Budget& budget) {
  const Ideal whole = relation_ideal(v, {}, {}, budget);
  if (whole.is_zero_ideal()) return std::nullopt;
  const Branches branches(whole, v.relations);
  if (auto several = branches.several()) return several;
  if (has_other_components(whole, branches.closure(whole, v.relations)))
    return "the relations have another solution at special values of the coordinates";
  return std::nullopt;
}

std::vector<MPoly> where_relations_fall_apart(const VectorField& v, const Budget& budget) {
  if (!functions_use_parameters(v)) return {};
  const Ideal whole = relation_ideal(v, {}, {}, budget);
  const Branches branches(whole, v.relations);
  if (branches.independent().empty()) return {}; // one point with its conjugates
  Special always(v.main_variables());
  for (const MPoly& f : branches.inverted())
    always.add(f);
  for (const MPoly& f : whole.inverted())
    always.add(f);
  if (const auto closure = branches.closure(whole, v.relations))
    for (const MPoly& f : closure->inverted())
      always.add(f);
  const Branches::Cover cover = branches.cover();
  const long n = degree(cover.f, cover.unknown);
  std::vector<std::vector<MPoly>> found;
  for (long k = 0; k < most_lines && found.size() < lines; ++k) {
    const OnLine line(cover, branches.independent(), k);
    if (!line.is_general(n)) continue;
    Special special = always;
    line.add_to(special);
    if (special.all().empty()) return {};
    found.push_back(special.all());
  }
  if (found.empty())
    throw OutOfBudget("where the relations fall apart was not found: no line in general position");
  return common_zeros(v, found, budget);
}

} // namespace kov
