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

  /// What was inverted has zeros in the independent variables, and components may lie above these.
  [[nodiscard]] bool leaves_components(const Ideal& whole,
                                       const std::vector<MPoly>& relations) const {
    std::vector<MPoly> inverted;
    for (const MPoly& f : algebra_.ideal().inverted())
      if (uses_one(f, independent_)) inverted.push_back(f);
    if (inverted.empty()) return false;
    const Ideal closed(whole.ring(), whole.main(), relations, inverted, whole.budget());
    return std::any_of(closed.basis().begin(), closed.basis().end(),
                       [&](const KPoly& g) { return !whole.contains(closed.from_kpoly(g).num()); });
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

private:
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

  // The factors of a polynomial over K; the first dependent variable stands for its unknown.
  [[nodiscard]] std::vector<MFactor> branches(const std::vector<MFraction>& coefficients) const {
    const MFraction t = MFraction::variable(algebra_.ring(), dependent_[0]);
    MFraction f(algebra_.ring());
    for (std::size_t i = coefficients.size(); i-- > 0;)
      f = f * t + coefficients[i];
    std::vector<MFactor> found = factor(f.num()).second;
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

} // namespace

std::optional<std::string> reducible_relations(const VectorField& v, const Budget& budget) {
  const Ideal whole = relation_ideal(v, {}, {}, budget);
  if (whole.is_zero_ideal()) return std::nullopt;
  const Branches branches(whole, v.relations);
  if (auto several = branches.several()) return several;
  if (branches.leaves_components(whole, v.relations))
    return "the relations have another solution at special values of the coordinates";
  return std::nullopt;
}

} // namespace kov
