// Rule "no-exponential": y'' = r y has no solution with y'/y rational (riccati_one_place.md).

#include "certify/equation/rules.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

// The coefficients of C*S vanish at length..k-1 and not at k: no recurrence of length k - length or
// less produces S_0..S_k (riccati_one_place.md, 4).  Returns k + 1 - length, or -1.
long complexity_bound(const ApproximantLine& line, const std::vector<mp_limb_t>& S, mp_limb_t p) {
  const auto terms = static_cast<long>(S.size());
  if (line.length < 0 || static_cast<long>(line.approximant.size()) > line.length + 1) return -1;
  NmodPoly c(p), s(p);
  for (std::size_t i = 0; i < line.approximant.size(); ++i) {
    need(line.approximant[i] < p, "a coefficient is not reduced modulo p");
    c.set_coeff(static_cast<long>(i), line.approximant[i]);
  }
  for (std::size_t i = 0; i < S.size(); ++i)
    s.set_coeff(static_cast<long>(i), S[i]);
  const NmodPoly product = mul_series(c, s, terms);
  for (long k = line.length; k < terms; ++k)
    if (product.coeff(k) != 0) return k + 1 - line.length;
  return -1;
}

void check_series(const Judge& j, const BySeries& data, const LocalFact& local) {
  const Reduced r = j.reduced(data.prime);
  const nmod_t mod = r.num.mod();
  const PlaceFact& x = local.place(data.place);
  need(x.order >= 1, "infinity is not singular");
  std::optional<mp_limb_t> root;
  if (x.q) {
    root = data.root;
    need(data.root < mod.n && evaluate(reduce(*x.q, data.prime), data.root) == 0,
         "not a root of the place modulo p");
  }
  need_within(data.terms >= 2 && data.terms <= static_cast<long>(max_length),
              "too few or too many terms");
  need(data.delta < mod.n, "delta is not reduced modulo p");
  const Integer L = length_bound(local, x);
  j.spend(static_cast<double>(data.terms) * (static_cast<double>(data.terms) + j.length()));
  const Expansion e = expand(r, root, x.order);
  const mp_limb_t half = nmod_inv(2, mod);
  std::vector<mp_limb_t> starts{data.delta, nmod_neg(data.delta, mod)};
  if (x.order <= 2)
    for (mp_limb_t& s : starts)
      s = nmod_mul(nmod_add(s, 1, mod), half, mod);
  if (starts[0] == starts[1]) starts.pop_back();
  std::size_t used = 0;
  for (const mp_limb_t s : starts) {
    const auto S = riccati(e, s, data.terms);
    if (!S) continue;
    need(used < data.lines.size(), "each line that is left needs one approximant");
    need(Integer(complexity_bound(data.lines[used++], *S, mod.n)) > L,
         "a solution of the allowed degree is not excluded");
  }
  need(used == data.lines.size(), "each line that is left needs one approximant");
}

} // namespace

Integer length_bound(const LocalFact& local, const PlaceFact& x) {
  Integer M = local.degree_bound_1();
  for (const PlaceFact& y : local.all)
    if (y.q) M += Integer(y.n) * Integer(std::max(1L, y.order / 2));
  const long extra =
      x.q ? std::max(0L, local.infinity().order / 2 - 2) + 1 : std::max(1L, x.order / 2);
  return M + Integer(extra);
}

IrreducibleFact check_no_exponential(const Judge& j, const NoExponential& data,
                                     const LocalFact& local) {
  if (std::holds_alternative<ByParity>(data.by))
    need(local.any(&PlaceFact::ramified), "no place of odd order");
  else if (std::holds_alternative<ByDegree>(data.by))
    need(sign(local.degree_bound_1()) < 0, "D_1 is not negative");
  else
    check_series(j, std::get<BySeries>(data.by), local);
  return {};
}

} // namespace kov::certify
