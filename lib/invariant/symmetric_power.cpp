#include "invariant/symmetric_power.hpp"

#include "exact/error.hpp"

namespace kov {

bool solves_symmetric_power(const Invariant& v, const Singularities& s) {
  // With S = prod q^ceil(order/2) and E = prod q^e put L_i v = E W_i / S^i.  Then W_0 = P and
  //   W_(i+1) = S W_i' + (S E'/E - i S') W_i - i (m-i+1) (r S^2) W_(i-1),  all polynomials.
  Poly common(1);
  for (const Singularity& place : s.finite)
    common *= pow(place.place, static_cast<unsigned long>((place.order + 1) / 2));
  Poly log_derivative(0); // S E'/E
  for (std::size_t i = 0; i < s.finite.size(); ++i)
    if (v.e.at(i) != 0)
      log_derivative += scale(exact_div(common, s.finite[i].place) * derivative(s.finite[i].place),
                              NfElem(v.e[i]));
  const Poly d_common = derivative(common);
  const Poly r_common = exact_div(s.r.num() * common * common, s.r.den());
  Poly before(0);
  Poly w = v.p;
  for (long i = 0; i <= v.m; ++i) {
    Poly next = common * derivative(w) + (log_derivative - scale(d_common, NfElem(i))) * w;
    if (i > 0) next -= scale(r_common * before, NfElem(i * (v.m - i + 1)));
    before = std::move(w);
    w = std::move(next);
  }
  return is_zero(w);
}

} // namespace kov
