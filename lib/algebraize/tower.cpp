#include "algebraize/tower.hpp"
#include "exact/lists.hpp"

#include <algorithm>

namespace kov {
namespace {

using Element = FunctionField::Element;

// Coordinates of a in terms of these elements of r, if it is a combination of them.
std::optional<std::vector<MFraction>>
combination_of(const FiniteAlgebra& r, const std::vector<Element>& basis, const Element& a) {
  std::vector<std::vector<MFraction>> rows(r.dimension());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const Element& b : basis)
      rows[i].push_back(b[i]);
  return solve_linear(std::move(rows), a, r.ideal().budget());
}

// Variables that are basis monomials themselves first: the others are often rational in them.
std::vector<std::size_t> in_order(const FiniteAlgebra& r) {
  const auto& main = r.ideal().main();
  std::vector<std::size_t> first;
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < main.size(); ++i) {
    Monomial x(main.size(), 0);
    x[i] = 1;
    const bool is_there = is_among(x, r.basis());
    (is_there ? first : others).push_back(main[i]);
  }
  first.insert(first.end(), others.begin(), others.end());
  return first;
}

} // namespace

std::optional<Tower> Tower::make(const FunctionField& f) {
  const FiniteAlgebra& r = f.algebra();
  Tower t;
  t.basis_ = {r.constant(MFraction(r.ring(), Rational(1)))};
  t.monomials_ = {{}};
  for (const std::size_t variable : in_order(r))
    if (!t.adjoin(r, variable)) return std::nullopt;
  for (Exponents& e : t.monomials_)
    e.resize(t.steps_.size(), 0);
  if (t.basis_.size() != r.dimension() || !t.change_basis(r)) return std::nullopt;
  return t;
}

// The least d with x^d in the span of b x^j, j < d.
bool Tower::adjoin(const FiniteAlgebra& r, std::size_t variable) {
  const auto x = r.evaluate(MFraction::variable(r.ring(), variable));
  if (!x) return false;
  std::vector<Element> basis = basis_;
  std::vector<Exponents> monomials = monomials_;
  Element power = *x;
  std::size_t d = 1;
  for (; !combination_of(r, basis, power); ++d, power = r.multiply(power, *x)) {
    if (basis.size() + basis_.size() > r.dimension()) return false;
    for (std::size_t i = 0; i < basis_.size(); ++i) {
      basis.push_back(r.multiply(basis_[i], power));
      monomials.push_back(monomials_[i]);
      monomials.back().resize(steps_.size(), 0);
      monomials.back().push_back(d);
    }
  }
  if (d == 1) return true;
  basis_ = std::move(basis);
  monomials_ = std::move(monomials);
  steps_.push_back({variable, d});
  return true;
}

bool Tower::change_basis(const FiniteAlgebra& r) {
  for (std::size_t i = 0; i < r.dimension(); ++i) {
    Element unit = r.zero();
    unit[i] = MFraction(r.ring(), Rational(1));
    auto c = combination_of(r, basis_, unit);
    if (!c) return false;
    columns_.push_back(*std::move(c));
  }
  return true;
}

std::vector<MFraction> Tower::coordinates(const FunctionField::Element& a) const {
  std::vector<MFraction> sum(a.size(), MFraction(a.front().ring()));
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!is_zero(a[i]))
      for (std::size_t k = 0; k < sum.size(); ++k)
        if (!is_zero(columns_[i][k])) sum[k] += a[i] * columns_[i][k];
  return sum;
}

} // namespace kov
