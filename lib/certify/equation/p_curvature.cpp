// Rule "p-curvature" (docs/theory/p_curvature.md).  With y^(k) = (A_k y + B_k y')/den^k,
//   A_(k+1) = den A_k' - k den' A_k + num B_k,   B_(k+1) = den A_k + den B_k' - k den' B_k,
// the p-curvature has trace 0 and square B Id with B den^(2p+1) = A_p^2 den + B_p A_(p+1).

#include "certify/equation/rules.hpp"
#include "proof/text/limits.hpp"

namespace kov::certify {

namespace {

// f with B den^(2p) = f(z^p).
NmodPoly square_of_curvature(const Reduced& r) {
  const mp_limb_t p = r.prime.p;
  const NmodPoly d1 = derivative(r.den);
  NmodPoly A(p), B(p), Ap(p), Bp(p);
  A.set_coeff(0, 1);
  for (mp_limb_t k = 0; k <= p; ++k) {
    if (k == p) {
      Ap = A;
      Bp = B;
    }
    const mp_limb_t minus_k = k % p == 0 ? 0 : p - k;
    NmodPoly next = r.den * derivative(A) + scale(d1 * A, minus_k) + r.num * B;
    B = r.den * A + r.den * derivative(B) + scale(d1 * B, minus_k);
    A = std::move(next);
  }
  NmodPoly f(p), rest(p);
  const NmodPoly product = Ap * Ap * r.den + Bp * A;
  nmod_poly_divrem(f.raw(), rest.raw(), product.raw(), r.den.raw());
  need(is_zero(rest), "the p-curvature is not a p-th power");
  NmodPoly b(p);
  for (long i = 0; i <= degree(f); ++i) {
    if (f.coeff(i) == 0) continue;
    need(static_cast<mp_limb_t>(i) % p == 0, "the p-curvature is not a p-th power");
    b.set_coeff(i / static_cast<long>(p), f.coeff(i));
  }
  return b;
}

// Some odd place of B is not the reduction of an admissible place.
bool excludes_imprimitive(const NmodPoly& b, const Reduced& r, const LocalFact& local) {
  NmodPoly rest = b;
  for (const PlaceFact& x : local.all) {
    if (!x.q || !x.exchanges_lines()) continue;
    const NmodPoly q = reduce(*x.q, r.prime);
    for (NmodPoly g = gcd(rest, q); degree(g) > 0; g = gcd(rest, q))
      rest = exact_div(rest, g);
  }
  if (degree(rest) > 0 && !is_square(rest)) return true;
  return degree(b) % 2 == 1 && !local.infinity().exchanges_lines();
}

} // namespace

PCurvatureFact check_p_curvature(const Judge& j, const PCurvature& data, const LocalFact* local) {
  const Reduced r = j.reduced(data.prime);
  const auto p = static_cast<double>(data.prime.p);
  const auto size = static_cast<double>(degree(r.num) + degree(r.den) + 2);
  need_within(p * size <= 1e7 && p * p * size <= max_work,
              "the prime is too large for a p-curvature");
  j.spend(p * p * size);
  const NmodPoly b = square_of_curvature(r);
  need(!is_zero(b), "the p-curvature is nilpotent");
  if (data.shows == "sl2") {
    need(data.prime.p >= 7 && local, "sl2 needs p >= 7 and a local premise");
    need(excludes_imprimitive(b, r, *local), "no odd place of B_p is excluded");
  } else if (data.shows == "irreducible") {
    need(!is_square(b), "B_p is a square");
  } else {
    need(data.shows == "nonzero", "shows must be nonzero, irreducible or sl2");
  }
  return {data.prime.p, data.shows};
}

} // namespace kov::certify
