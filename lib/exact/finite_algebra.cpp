#include "exact/finite_algebra.hpp"

#include "exact/error.hpp"
#include "exact/linear.hpp"
#include "exact/nmod_matrix.hpp"

#include <algorithm>
#include <random>

namespace kov {

FiniteAlgebra::Element operator+(const FiniteAlgebra::Element& a, const FiniteAlgebra::Element& b) {
  FiniteAlgebra::Element r(a);
  for (std::size_t i = 0; i < r.size(); ++i)
    r[i] += b[i];
  return r;
}
FiniteAlgebra::Element operator-(const FiniteAlgebra::Element& a, const FiniteAlgebra::Element& b) {
  FiniteAlgebra::Element r(a);
  for (std::size_t i = 0; i < r.size(); ++i)
    r[i] -= b[i];
  return r;
}
FiniteAlgebra::Element scale(const FiniteAlgebra::Element& a, const MFraction& c) {
  FiniteAlgebra::Element r(a);
  for (auto& entry : r)
    entry *= c;
  return r;
}
namespace {

// a <- a + c b
void add_multiple(FiniteAlgebra::Element& a, const MFraction& c, const FiniteAlgebra::Element& b,
                  Work& work) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (is_zero(b[i])) continue;
    work.add(c, b[i]);
    const MFraction product = c * b[i];
    work.add(a[i], product);
    a[i] += product;
  }
}

} // namespace

bool is_zero(const FiniteAlgebra::Element& a) {
  for (const auto& entry : a)
    if (!is_zero(entry)) return false;
  return true;
}

FiniteAlgebra::FiniteAlgebra(Ideal ideal, long max_dimension) : ideal_(std::move(ideal)) {
  if (ideal_.dimension() != 0)
    throw InvalidArgument("an ideal of dimension 0 is needed, this one has dimension " +
                          std::to_string(ideal_.dimension()));
  basis_ = ideal_.standard_monomials();
  if (static_cast<long>(basis_.size()) > max_dimension)
    throw OutOfBudget("the function field of the curve has degree " +
                      std::to_string(basis_.size()) + " over the constants of the new variable; " +
                      "the limit is " + std::to_string(max_dimension));
  for (std::size_t i = 0; i < basis_.size(); ++i)
    place_[basis_[i]] = i;
  table_.resize(basis_.size() * basis_.size());
}

FiniteAlgebra::Element FiniteAlgebra::zero() const {
  return Element(basis_.size(), MFraction(ring()));
}
FiniteAlgebra::Element FiniteAlgebra::constant(const MFraction& c) const {
  Element e = zero();
  e[0] = c;
  return e;
}
FiniteAlgebra::Element FiniteAlgebra::coordinates(const KPoly& f) const {
  Element e = zero();
  for (const auto& [m, c] : f)
    e[place_.at(m)] = c;
  return e;
}

const FiniteAlgebra::Element& FiniteAlgebra::product_of_basis(std::size_t i, std::size_t j) const {
  auto& entry = table_[std::min(i, j) * basis_.size() + std::max(i, j)];
  if (!entry) {
    KPoly product(MonomialOrder{0});
    Monomial m(basis_[i]);
    for (std::size_t k = 0; k < m.size(); ++k)
      m[k] += basis_[j][k];
    product.emplace(std::move(m), MFraction(ring(), Rational(1)));
    entry = coordinates(ideal_.reduce(ideal_.from_kpoly(product)));
  }
  return *entry;
}

FiniteAlgebra::Element FiniteAlgebra::multiply(const Element& a, const Element& b) const {
  Element sum = zero();
  Work work(ideal_.budget(), "a product in the function field of the curve");
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (is_zero(a[i]) || is_zero(b[j])) continue;
      work.add(a[i], b[j]);
      add_multiple(sum, a[i] * b[j], product_of_basis(i, j), work);
    }
  return sum;
}

std::optional<FiniteAlgebra::Element> FiniteAlgebra::invert(const Element& a) const {
  const std::size_t n = basis_.size();
  std::vector<std::vector<MFraction>> m(n, std::vector<MFraction>(n, MFraction(ring())));
  for (std::size_t j = 0; j < n; ++j) {
    Element unit = zero();
    unit[j] = MFraction(ring(), Rational(1));
    const Element column = multiply(a, unit);
    for (std::size_t i = 0; i < n; ++i)
      m[i][j] = column[i];
  }
  Element one = constant(MFraction(ring(), Rational(1)));
  auto x = solve_linear(std::move(m), one, ideal_.budget());
  // In a finite algebra a x = 1 has a solution exactly when a is a unit.
  if (!x) return std::nullopt;
  KOV_ENSURE(multiply(a, *x) == one);
  return x;
}

std::optional<FiniteAlgebra::Element> FiniteAlgebra::evaluate(const MFraction& f) const {
  if (is_zero(f)) return zero();
  const Element num = coordinates(ideal_.reduce(MFraction(f.num())));
  const Element den = coordinates(ideal_.reduce(MFraction(f.den())));
  if (const auto c = in_base_field(den)) {
    if (is_zero(*c)) return std::nullopt;
    return scale(num, MFraction(ring(), Rational(1)) / *c);
  }
  const auto inverse = invert(den);
  if (!inverse) return std::nullopt;
  return multiply(num, *inverse);
}

std::optional<MFraction> FiniteAlgebra::in_base_field(const Element& a) const {
  for (std::size_t i = 1; i < a.size(); ++i)
    if (!is_zero(a[i])) return std::nullopt;
  return a[0];
}

MFraction FiniteAlgebra::lift(const Element& a) const {
  KPoly f(MonomialOrder{0});
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!is_zero(a[i])) f.emplace(basis_[i], a[i]);
  return ideal_.from_kpoly(f);
}

namespace {

// The value of f at a point modulo a prime; unset where its denominator vanishes.
std::optional<ulong> value_at(const MFraction& f, const std::vector<ulong>& point, nmod_t mod) {
  if (is_zero(f)) return 0;
  const auto value = [&](const MPoly& g) {
    return fmpz_mpoly_evaluate_all_nmod(g.raw(), point.data(), g.ctx(), mod);
  };
  const ulong den = value(f.den());
  if (den == 0) return std::nullopt;
  return nmod_div(value(f.num()), den, mod);
}

std::vector<ulong> some_point(const Ring& ring, nmod_t mod) {
  std::mt19937_64 generator(20240501);
  std::vector<ulong> point(ring->size());
  for (ulong& x : point)
    x = generator() % mod.n;
  return point;
}

// The elements at a point modulo a prime; unset where a denominator vanishes.
std::optional<std::vector<ulong>> values_at(const FiniteAlgebra::Element& a,
                                            const std::vector<ulong>& point, nmod_t mod) {
  std::vector<ulong> values;
  for (const MFraction& f : a) {
    const auto x = value_at(f, point, mod);
    if (!x) return std::nullopt;
    values.push_back(*x);
  }
  return values;
}

} // namespace

// Powers that are independent at a point modulo a prime are independent.
bool FiniteAlgebra::has_independent_powers(const Element& a, std::size_t most) const {
  const std::size_t n = basis_.size();
  if (most + 1 > n) return false;
  NmodMatrix powers(n, most + 1, 2147483629UL);
  const nmod_t mod = powers.mod();
  const auto point = some_point(ring(), mod);
  const auto factor = values_at(a, point, mod);
  if (!factor) return false;
  std::vector<ulong> power(n, 0); // 1
  power[0] = 1;
  for (std::size_t k = 0; k <= most; ++k) {
    std::vector<ulong> next(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
      powers(i, k) = power[i];
      for (std::size_t j = 0; j < n; ++j) {
        if (power[i] == 0 || (*factor)[j] == 0) continue;
        const auto product = values_at(product_of_basis(i, j), point, mod);
        if (!product) return false;
        const ulong c = nmod_mul(power[i], (*factor)[j], mod);
        for (std::size_t m = 0; m < n; ++m)
          next[m] = nmod_add(next[m], nmod_mul(c, (*product)[m], mod), mod);
      }
    }
    power = std::move(next);
  }
  return powers.has_independent_columns();
}

std::optional<std::vector<MFraction>> FiniteAlgebra::minimal_polynomial(const Element& a,
                                                                        std::size_t most) const {
  if (has_independent_powers(a, most)) return std::nullopt;
  std::vector<Element> powers{constant(MFraction(ring(), Rational(1)))};
  while (powers.size() <= most) {
    const Element next = multiply(powers.back(), a);
    std::vector<std::vector<MFraction>> rows(basis_.size());
    for (std::size_t i = 0; i < basis_.size(); ++i)
      for (const auto& p : powers)
        rows[i].push_back(p[i]);
    if (auto x = solve_linear(std::move(rows), next, ideal_.budget())) {
      for (auto& c : *x)
        c = -c;
      x->push_back(MFraction(ring(), Rational(1)));
      return x;
    }
    powers.push_back(next);
  }
  return std::nullopt;
}

namespace {

/// Counts its work; the shortest pivot keeps the entries small.
struct CountedArithmetic {
  Work& work;

  [[nodiscard]] static bool is_unit(const MFraction& x) { return !is_zero(x); }
  [[nodiscard]] static long cost(const MFraction& x) { return x.num().length() + x.den().length(); }
  void divide(FiniteAlgebra::Element& row, const MFraction& by) const {
    for (MFraction& x : row) {
      work.add(x, by);
      x = x / by;
    }
  }
  void subtract(MFraction& x, const MFraction& factor, const MFraction& y) const {
    work.add(factor, y);
    const MFraction product = factor * y;
    work.add(x, product);
    x -= product;
  }
};

// A minor that is not 0 at some point modulo a prime is not 0.
bool full_rank_at_a_point(const std::vector<std::vector<MFraction>>& m, std::size_t columns,
                          const Ring& ring) {
  if (m.size() < columns || columns == 0) return false;
  NmodMatrix values(m.size(), columns, 2147483629UL);
  const auto point = some_point(ring, values.mod());
  return values.fill([&](std::size_t r, std::size_t c) {
    return value_at(m[r][c], point, values.mod());
  }) && values.has_independent_columns();
}

} // namespace

std::optional<std::vector<MFraction>> solve_linear(std::vector<std::vector<MFraction>> m,
                                                   std::vector<MFraction> b, const Budget& budget) {
  KOV_ENSURE(m.size() == b.size());
  const std::size_t columns = m.empty() ? 0 : m.front().size();
  for (std::size_t r = 0; r < m.size(); ++r)
    m[r].push_back(b[r]);
  Work work(budget, "a system of linear equations");
  return solution(std::move(m), columns, {}, CountedArithmetic{work});
}

std::vector<std::vector<MFraction>> null_space(std::vector<std::vector<MFraction>> m,
                                               std::size_t columns, const Ring& ring,
                                               const Budget& budget) {
  if (full_rank_at_a_point(m, columns, ring)) return {};
  Work work(budget, "a system of linear equations");
  return kernel(std::move(m), columns, MFraction(ring, Rational(1)), {}, CountedArithmetic{work});
}

MFraction determinant(const std::vector<std::vector<MFraction>>& m, const Ring& ring) {
  if (m.empty()) return {ring, Rational(1)};
  MFraction sum(ring);
  for (std::size_t j = 0; j < m.size(); ++j) {
    if (is_zero(m[0][j])) continue;
    std::vector<std::vector<MFraction>> minor(m.begin() + 1, m.end());
    for (auto& row : minor)
      row.erase(row.begin() + static_cast<long>(j));
    const MFraction term = m[0][j] * determinant(minor, ring);
    sum += j % 2 == 0 ? term : -term;
  }
  return sum;
}

bool some_minor(const std::vector<std::vector<MFraction>>& rows, std::size_t columns,
                const Ring& ring, const std::function<bool(const MFraction&)>& is_like_this) {
  if (rows.size() > columns) return false;
  std::vector<bool> chosen(columns, false);
  std::fill_n(chosen.begin(), rows.size(), true);
  do {
    std::vector<std::vector<MFraction>> part;
    for (const auto& row : rows) {
      part.emplace_back();
      for (std::size_t j = 0; j < columns; ++j)
        if (chosen[j]) part.back().push_back(row[j]);
    }
    if (is_like_this(determinant(part, ring))) return true;
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
  return false;
}

} // namespace kov
