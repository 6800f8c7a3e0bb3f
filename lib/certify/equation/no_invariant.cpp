// Rule "no-invariant": Sym^m has no nonzero rational solution
// (docs/theory/invariants_one_point.md).

#include "certify/equation/rules.hpp"
#include "exact/in_pairs.hpp"
#include "exact/nmod_matrix.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>
#include <map>

namespace kov::certify {

namespace {

// The solution of den y'' = num y with given y(0), y'(0), to T terms.
NmodPoly solution(const NmodPoly& num, const NmodPoly& den, mp_limb_t y0, mp_limb_t y1, long T) {
  const nmod_t mod = num.mod();
  const auto reversed = [](const NmodPoly& f, long from) { // coefficients deg..from
    std::vector<mp_limb_t> c;
    for (long i = degree(f); i >= from; --i)
      c.push_back(f.coeff(i));
    return c;
  };
  const std::vector<mp_limb_t> n = reversed(num, 0);
  const std::vector<mp_limb_t> d = reversed(den, 1);
  std::vector<mp_limb_t> y{y0, y1}, w; // w_i = (i+2)(i+1) y_(i+2)
  const int limbs = _nmod_vec_dot_bound_limbs(T, mod);
  // the sum of c_j v_(k-j), where c runs down to its last entry
  const auto convolve = [&](const std::vector<mp_limb_t>& c, const std::vector<mp_limb_t>& v,
                            long count) {
    const long len = std::min<long>(static_cast<long>(c.size()), count);
    return _nmod_vec_dot(c.data() + (static_cast<long>(c.size()) - len), v.data() + (count - len),
                         len, mod, limbs);
  };
  const mp_limb_t unit = nmod_inv(den.coeff(0), mod);
  for (long k = 0; k + 2 < T; ++k) {
    const mp_limb_t s = nmod_sub(convolve(n, y, k + 1), convolve(d, w, k), mod);
    w.push_back(nmod_mul(s, unit, mod));
    mp_limb_t f = static_cast<mp_limb_t>(k + 2) % mod.n;
    f = nmod_mul(f, static_cast<mp_limb_t>(k + 1) % mod.n, mod);
    y.push_back(nmod_mul(w.back(), nmod_inv(f, mod), mod));
  }
  NmodPoly out(mod.n);
  for (long i = 0; i < T; ++i)
    out.set_coeff(i, y[static_cast<std::size_t>(i)]);
  return out;
}

// prod q^(-e) as a series at x0.
NmodPoly denominator(const LocalFact& local, long m, const PrimeIdeal& prime, mp_limb_t x0,
                     long T) {
  std::map<Integer, std::vector<NmodPoly>> groups;
  for (const PlaceFact& x : local.all)
    if (x.q) groups[*x.lowest(m)].push_back(truncate(taylor_shift(reduce(*x.q, prime), x0), T));
  NmodPoly U(prime.p);
  U.set_coeff(0, 1);
  for (const auto& [e, qs] : groups) {
    need_within(abs(Rational(e)) < Rational(10000000), "an exponent is too large");
    const NmodPoly q =
        in_pairs(qs, [T](const NmodPoly& a, const NmodPoly& b) { return mul_series(a, b, T); });
    const NmodPoly base = sign(e) > 0 ? inverse_series(q, T) : q;
    U = mul_series(U, pow_series(base, static_cast<unsigned long>(std::abs(to_long(e))), T), T);
  }
  return U;
}

// Are the m + 1 products independent from the coefficient `first` on?
bool independent_tails(const NmodPoly& y0, const NmodPoly& y1, const NmodPoly& U, long m,
                       long first, long T) {
  std::vector<NmodPoly> a{y0}, b{U};
  a[0] = NmodPoly(U.modulus());
  a[0].set_coeff(0, 1);
  for (long i = 0; i < m; ++i) {
    a.push_back(mul_series(a.back(), y0, T));
    b.push_back(mul_series(b.back(), y1, T));
  }
  const auto columns = static_cast<std::size_t>(m + 1);
  NmodMatrix M(static_cast<std::size_t>(T - first), columns, U.modulus());
  for (std::size_t i = 0; i < columns; ++i) {
    const NmodPoly column = mul_series(a[i], b[columns - 1 - i], T);
    for (long k = first; k < T; ++k)
      M(static_cast<std::size_t>(k - first), i) = column.coeff(k);
  }
  return M.has_independent_columns();
}

void check_rank(const Judge& j, const RankModP& data, long m, const Integer& D,
                const LocalFact& local) {
  const Reduced r = j.reduced(data.prime);
  const long T = data.terms;
  const auto work = static_cast<double>(T) * static_cast<double>(degree(r.num) + degree(r.den) + 2);
  const Integer spare = Integer(T) - (sign(D) < 0 ? Integer(-1) : D) - Integer(m + 2);
  need_within(sign(spare) >= 0 && spare <= Integer(1000) &&
                  T <= 10 * static_cast<long>(max_length) && Integer(T) <= Integer(data.prime.p) &&
                  work <= max_work,
              "terms out of range");
  const auto rows = static_cast<double>(m + 1);
  need_within(rows * static_cast<double>(T) <= max_matrix, "terms out of range");
  j.spend(work + 60 * rows * static_cast<double>(T) + rows * rows * static_cast<double>(T));
  need(data.x0 < data.prime.p && evaluate(r.den, data.x0) != 0, "x0 is a pole modulo p");
  const NmodPoly n = taylor_shift(r.num, data.x0);
  const NmodPoly d = taylor_shift(r.den, data.x0);
  const NmodPoly U = denominator(local, m, data.prime, data.x0, T);
  const long first = sign(D) < 0 ? 0 : to_long(D) + 1;
  need(independent_tails(solution(n, d, 1, 0, T), solution(n, d, 0, 1, T), U, m, first, T),
       "the rank is not m + 1");
}

} // namespace

AbsentFact check_no_invariant(const Judge& j, const NoInvariant& data, const LocalFact& local) {
  need(data.m >= 2 && data.m <= max_sym && data.m % 2 == 0, "m must be even");
  const Integer D = local.degree_bound(data.m);
  if (std::holds_alternative<ByDegree>(data.by))
    need(sign(D) < 0, "D_m is not negative");
  else {
    for (const PlaceFact& x : local.all)
      need(!x.q || (!x.open() && x.lowest(data.m)), "the degree bound is negative: use degree");
    check_rank(j, std::get<RankModP>(data.by), data.m, D, local);
  }
  return {data.m};
}

} // namespace kov::certify
