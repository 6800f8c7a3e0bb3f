#include "invariant/invariant.hpp"

#include "exact/chinese_lift.hpp"
#include "exact/error.hpp"
#include "exact/meter.hpp"
#include "exact/nmod_matrix.hpp"
#include "invariant/symmetric_power.hpp"
#include "linode/modular_series.hpp"

#include <algorithm>
#include <map>

namespace kov {
namespace {

// For linearly independent forms the first m+1 derivatives have full rank at all points but the
// zeros of a Wronskian, and the point is one of 2^60 without meaning: a few columns more are for
// doubters.
constexpr long spare_columns = 3;

// The kernel modulo one prime, as polynomials P in reduced echelon form from the top degree down.
struct ModularKernel {
  mp_limb_t point = 0;
  std::vector<NmodPoly> basis;
};

struct Search {
  const Singularities& s;
  InvariantShape shape;
  long terms;

  // prod q^-e about the point, as a unit power series
  [[nodiscard]] std::optional<NmodPoly> unit_factor(const PrimeIdeal& prime,
                                                    mp_limb_t point) const {
    std::map<long, NmodPoly> by_exponent;
    for (std::size_t i = 0; i < s.finite.size(); ++i) {
      const auto q = prime.reduce(s.finite[i].place);
      if (!q || degree(*q) != degree(s.finite[i].place)) return std::nullopt;
      const auto [at, fresh] = by_exponent.try_emplace(shape.e[i], *q);
      if (!fresh) at->second = at->second * *q;
    }
    NmodPoly top(prime.p);
    top.set_coeff(0, 1);
    NmodPoly bottom = top;
    for (const auto& [e, q] : by_exponent) {
      if (e == 0) continue;
      const NmodPoly shifted = taylor_shift(q, point);
      if (shifted.coeff(0) == 0) return std::nullopt;
      NmodPoly& side = e < 0 ? top : bottom;
      const auto size = static_cast<unsigned long>(e < 0 ? -e : e);
      side = mul_series(side, pow_series(truncate(shifted, terms), size, terms), terms);
    }
    return mul_series(top, inverse_series(bottom, terms), terms);
  }

  // y1^i y2^(m-i) prod q^-e, 0 <= i <= m, to `terms` coefficients; unset at a bad prime or point
  [[nodiscard]] std::optional<std::vector<NmodPoly>> forms(const PrimeIdeal& prime,
                                                           mp_limb_t point) const {
    const auto num = prime.reduce(s.r.num());
    const auto den = prime.reduce(s.r.den());
    if (!num || !den || static_cast<mp_limb_t>(terms) >= prime.p) return std::nullopt;
    const NmodPoly d = taylor_shift(*den, point);
    if (d.coeff(0) == 0) return std::nullopt;
    const auto unit = unit_factor(prime, point);
    if (!unit) return std::nullopt;
    NmodPoly n = taylor_shift(*num, point);
    nmod_poly_neg(n.raw(), n.raw());
    nmod_poly_shift_left(n.raw(), n.raw(), 2);
    const ThetaEquation equation{d, NmodPoly(prime.p), n};
    const NmodPoly y1 = power_series_solution(equation, {1, 0}, terms);
    const NmodPoly y2 = power_series_solution(equation, {0, 1}, terms);
    std::vector<NmodPoly> left{*unit}; // unit * y1^i
    NmodPoly one(prime.p);
    one.set_coeff(0, 1);
    std::vector<NmodPoly> right{one}; // y2^i
    for (long i = 0; i < shape.m; ++i) {
      left.push_back(mul_series(left.back(), y1, terms));
      right.push_back(mul_series(right.back(), y2, terms));
    }
    std::vector<NmodPoly> rows;
    for (long i = 0; i <= shape.m; ++i)
      rows.push_back(mul_series(left[static_cast<std::size_t>(i)],
                                right[static_cast<std::size_t>(shape.m - i)], terms));
    return rows;
  }

  [[nodiscard]] std::optional<ModularKernel> kernel(const PrimeIdeal& prime) const;
};

// Reduced echelon form of a basis of polynomials, by descending leading degree; entries made monic.
void echelonize(std::vector<NmodPoly>& basis) {
  for (std::size_t done = 0; done < basis.size(); ++done) {
    std::swap(basis[done], *std::max_element(basis.begin() + static_cast<long>(done), basis.end(),
                                             [](const NmodPoly& a, const NmodPoly& b) {
                                               return degree(a) < degree(b);
                                             }));
    NmodPoly& pivot = basis[done];
    const long top = degree(pivot);
    pivot = scale(pivot, nmod_inv(pivot.coeff(top), pivot.mod()));
    for (std::size_t i = 0; i < basis.size(); ++i)
      if (i != done && basis[i].coeff(top) != 0)
        basis[i] = basis[i] - scale(pivot, basis[i].coeff(top));
  }
}

std::optional<ModularKernel> Search::kernel(const PrimeIdeal& prime) const {
  // a point without meaning: a fixed multiple of the golden ratio, so that runs repeat
  ModularKernel result;
  std::optional<std::vector<NmodPoly>> rows;
  for (mp_limb_t i = 1; i <= 8 && !rows; ++i) {
    result.point = n_mulmod2(0x9e3779b97f4a7c15U % prime.p, i, prime.p);
    rows = forms(prime, result.point);
  }
  if (!rows) return std::nullopt;
  const auto beyond = static_cast<std::size_t>(terms - shape.degree - 1);
  NmodMatrix matrix(beyond, rows->size(), prime.p); // one equation per coefficient beyond D_m
  for (std::size_t j = 0; j < rows->size(); ++j)
    for (std::size_t i = 0; i < beyond; ++i)
      matrix(i, j) = (*rows)[j].coeff(shape.degree + 1 + static_cast<long>(i));
  const auto unknowns = static_cast<double>(rows->size());
  charge(static_cast<double>(beyond) * unknowns * unknowns / 32);
  for (const std::vector<mp_limb_t>& x : matrix.kernel()) {
    NmodPoly sum(prime.p);
    for (std::size_t j = 0; j < x.size(); ++j)
      sum = sum + scale(truncate((*rows)[j], shape.degree + 1), x[j]);
    result.basis.push_back(taylor_shift(sum, nmod_neg(result.point, sum.mod())));
  }
  echelonize(result.basis);
  return result;
}

NoInvariant rank_proof(const Search& search, const PrimeIdeal& prime, const ModularKernel& kernel) {
  NoInvariant proof;
  proof.m = search.shape.m;
  proof.prime = prime;
  proof.point = kernel.point;
  proof.terms = search.terms;
  return proof;
}

std::vector<mp_limb_t> residues(const ModularKernel& kernel, long length) {
  std::vector<mp_limb_t> row;
  for (const NmodPoly& p : kernel.basis)
    for (long i = 0; i < length; ++i)
      row.push_back(p.coeff(i));
  return row;
}

// The lifted basis if it is one: every member verified.
std::optional<std::vector<Invariant>> verified_basis(const ChineseLift& lift, const Search& search,
                                                     long dimension) {
  const auto c = lift.reconstruct();
  if (!c) return std::nullopt;
  std::vector<Invariant> basis;
  const long length = search.shape.degree + 1;
  for (long k = 0; k < dimension; ++k) {
    const auto first = c->begin() + k * length;
    Invariant v{search.shape.m, Poly::from_coefficients({first, first + length}), search.shape.e};
    if (is_zero(v.p) || !solves_symmetric_power(v, search.s)) return std::nullopt;
    basis.push_back(std::move(v));
  }
  return basis;
}

} // namespace

namespace {

// Local data and one prime: a proof of absence, or the kernel modulo that prime.
struct FirstLook {
  std::optional<NoInvariant> none;
  PrimeIdeal prime;
  ModularKernel kernel;
};

bool same(const PrimeIdeal& a, const PrimeIdeal& b) {
  return a.p == b.p && a.generator == b.generator;
}

long sufficient_terms(const InvariantShape& shape) {
  return shape.degree + 1 + shape.m + 1 + spare_columns;
}

FirstLook first_look(const Singularities& s, const InvariantShape& shape, const Budget& budget) {
  if (shape.obstruction)
    return {NoInvariant{.m = shape.m, .obstruction = shape.obstruction}, {}, {}};
  budget.check_degree(shape.degree);
  const Search search{s, shape, sufficient_terms(shape)};
  PrimeIdeals primes = PrimeIdeals::large(s.r.field());
  for (int tries = 0; tries < 50; ++tries) {
    budget.check();
    const PrimeIdeal prime = primes.next();
    auto kernel = search.kernel(prime);
    if (!kernel) continue;
    if (kernel->basis.empty()) return {rank_proof(search, prime, *kernel), {}, {}};
    return {std::nullopt, prime, *std::move(kernel)};
  }
  throw OutOfBudget("no good prime found for Sym^" + std::to_string(shape.m));
}

} // namespace

std::optional<NoInvariant> no_invariant(const Singularities& s, long m, const Budget& budget) {
  return first_look(s, invariant_shape(s, m), budget).none;
}

InvariantSearch invariants(const Singularities& s, long m, const Budget& budget) {
  InvariantSearch answer;
  answer.m = m;
  const InvariantShape shape = invariant_shape(s, m);
  const FirstLook look = first_look(s, shape, budget);
  if (look.none) {
    answer.none = look.none;
    return answer;
  }
  const Search search{s, shape, sufficient_terms(shape)};
  const Field& k = s.r.field();
  std::size_t dimension = look.kernel.basis.size();
  PrimeIdeals primes = PrimeIdeals::large(k);
  std::optional<ChineseLift> lift;
  std::vector<long> pivots;
  for (int tries = 0; tries < 100000; ++tries) {
    budget.check();
    const auto ideals = primes.next_split();
    std::vector<std::vector<mp_limb_t>> rows;
    for (const PrimeIdeal& ideal : ideals) {
      const auto kernel = same(ideal, look.prime) ? look.kernel : search.kernel(ideal);
      if (!kernel || kernel->basis.size() > dimension) break;
      if (kernel->basis.empty()) {
        answer.none = rank_proof(search, ideal, *kernel);
        return answer;
      }
      std::vector<long> shape_now;
      for (const NmodPoly& p : kernel->basis)
        shape_now.push_back(degree(p));
      if (kernel->basis.size() < dimension ||
          shape_now > pivots) { // the earlier primes were unlucky
        dimension = kernel->basis.size();
        pivots = shape_now;
        lift.reset();
        rows.clear();
      }
      if (shape_now != pivots) break;
      answer.no_more = rank_proof(search, ideal, *kernel);
      rows.push_back(residues(*kernel, shape.degree + 1));
    }
    if (rows.size() != ideals.size()) continue;
    if (!lift) lift.emplace(k, rows.front().size());
    lift->add(ideals, rows);
    if (!worth_a_try(lift->primes())) continue;
    if (auto basis = verified_basis(*lift, search, static_cast<long>(dimension))) {
      answer.basis = std::move(*basis);
      return answer;
    }
  }
  throw OutOfBudget("invariants modulo primes could not be lifted");
}

RationalFunction value(const Invariant& v, const Singularities& s) {
  RationalFunction f(v.p);
  for (std::size_t i = 0; i < s.finite.size(); ++i)
    if (v.e.at(i) != 0) f *= pow(RationalFunction(s.finite[i].place), v.e[i]);
  return f;
}

} // namespace kov
