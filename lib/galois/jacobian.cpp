#include "galois/jacobian.hpp"

#include "exact/error.hpp"

#include <map>
#include <vector>

namespace kov {
namespace {

NmodPoly constant(mp_limb_t p, mp_limb_t c) {
  NmodPoly f(p);
  f.set_coeff(0, c);
  return f;
}

} // namespace

NmodPoly remainder(const NmodPoly& a, const NmodPoly& b) {
  NmodPoly r(a.modulus());
  nmod_poly_rem(r.raw(), a.raw(), b.raw());
  return r;
}

NmodPoly monic(const NmodPoly& f) {
  NmodPoly m(f.modulus());
  nmod_poly_make_monic(m.raw(), f.raw());
  return m;
}

namespace {

struct ExtendedGcd {
  NmodPoly g;
  NmodPoly s;
  NmodPoly t;
};

ExtendedGcd xgcd(const NmodPoly& a, const NmodPoly& b) {
  ExtendedGcd r{NmodPoly(a.modulus()), NmodPoly(a.modulus()), NmodPoly(a.modulus())};
  if (is_zero(b)) { // FLINT wants the larger argument first
    r.g = monic(a);
    r.s = constant(a.modulus(), nmod_inv(a.coeff(degree(a)), a.mod()));
    return r;
  }
  if (degree(a) >= degree(b))
    nmod_poly_xgcd(r.g.raw(), r.s.raw(), r.t.raw(), a.raw(), b.raw());
  else
    nmod_poly_xgcd(r.g.raw(), r.t.raw(), r.s.raw(), b.raw(), a.raw());
  return r;
}

std::vector<mp_limb_t> key(const DivisorClass& d) {
  std::vector<mp_limb_t> k;
  for (long i = 0; i <= degree(d.u); ++i)
    k.push_back(d.u.coeff(i));
  for (long i = 0; i <= degree(d.v); ++i)
    k.push_back(d.v.coeff(i));
  return k;
}

} // namespace

DivisorClass Jacobian::zero() const { return {constant(g_.modulus(), 1), NmodPoly(g_.modulus())}; }

DivisorClass Jacobian::reduce(DivisorClass d) const {
  d.v = remainder(d.v, d.u);
  while (degree(d.u) > genus_) {
    d.u = monic(exact_div(g_ - d.v * d.v, d.u));
    nmod_poly_neg(d.v.raw(), d.v.raw());
    d.v = remainder(d.v, d.u);
  }
  d.u = monic(d.u);
  return d;
}

DivisorClass Jacobian::add(const DivisorClass& a, const DivisorClass& b) const {
  // Cantor's composition: d = gcd(u1, u2, v1 + v2) = s1 u1 + s2 u2 + s3 (v1 + v2)
  const ExtendedGcd first = xgcd(a.u, b.u);
  const NmodPoly sum = a.v + b.v;
  const ExtendedGcd second = xgcd(first.g, sum);
  const NmodPoly& d = second.g;
  const NmodPoly s1 = second.s * first.s;
  const NmodPoly s2 = second.s * first.t;
  const NmodPoly u = exact_div(a.u * b.u, d * d);
  const NmodPoly top = s1 * a.u * b.v + s2 * b.u * a.v + second.t * (a.v * b.v + g_);
  return reduce({u, remainder(exact_div(top, d), u)});
}

DivisorClass Jacobian::multiply(const DivisorClass& a, const Integer& n) const {
  DivisorClass base = a;
  if (sign(n) < 0) nmod_poly_neg(base.v.raw(), base.v.raw());
  const Integer size = sign(n) < 0 ? -n : n;
  DivisorClass result = zero();
  const auto bits = static_cast<long>(fmpz_bits(size.raw()));
  for (long i = bits - 1; i >= 0; --i) {
    result = add(result, result);
    if (fmpz_tstbit(size.raw(), static_cast<ulong>(i)) != 0) result = add(result, base);
  }
  return result;
}

namespace {

constexpr long largest_bound = 1000000000;
constexpr long small_order = 4000;

// The order, if it is at most `small_order`: step by step.
std::optional<Integer> order_by_steps(const Jacobian& jacobian, const DivisorClass& a,
                                      const Budget& budget) {
  const DivisorClass none = jacobian.zero();
  DivisorClass sum = a;
  for (long n = 1; n <= small_order; ++n) {
    if (n % 256 == 0) budget.check();
    if (sum == none) return Integer(n);
    sum = jacobian.add(sum, a);
  }
  return std::nullopt;
}

} // namespace

std::optional<Integer> Jacobian::order(const DivisorClass& a, const Budget& budget) const {
  // (1 + sqrt p)^(2g) <= (2 + p + isqrt(4p))^g
  const Integer base(g_.modulus() + 2 + n_sqrt(4 * g_.modulus()));
  const Integer bound = pow(base, static_cast<unsigned long>(genus_));
  if (bound > Integer(largest_bound)) return order_by_steps(*this, a, budget);
  const DivisorClass none = zero();
  if (a == none) return Integer(1);
  // some multiple n of the order: baby steps j a, giant steps i m a
  const long m =
      to_long(Integer(static_cast<long>(n_sqrt(static_cast<ulong>(to_long(bound)))) + 1));
  std::map<std::vector<mp_limb_t>, long> baby;
  DivisorClass step = none;
  for (long j = 0; j < m; ++j) {
    if (j % 256 == 0) budget.check();
    if (j > 0 && step == none) return Integer(j);
    baby.emplace(key(step), j);
    step = add(step, a);
  }
  const DivisorClass giant = step; // m a
  DivisorClass reached = giant;
  for (long i = 1; i <= m + 1; ++i) {
    if (i % 256 == 0) budget.check();
    const auto hit = baby.find(key(reached));
    if (hit != baby.end()) {
      Integer n = Integer(i) * Integer(m) - Integer(hit->second);
      // divide out primes while the multiple still kills the class
      for (long p = 2; Integer(p) * Integer(p) <= n || p == 2; ++p)
        while (fmpz_divisible_si(n.raw(), p) != 0 && multiply(a, exact_div(n, Integer(p))) == none)
          n = exact_div(n, Integer(p));
      // what is left may be a large prime factor that can go
      Integer rest = n;
      for (long p = 2; Integer(p) * Integer(p) <= rest; ++p)
        while (fmpz_divisible_si(rest.raw(), p) != 0)
          rest = exact_div(rest, Integer(p));
      if (rest > Integer(1) && multiply(a, exact_div(n, rest)) == none) n = exact_div(n, rest);
      return n;
    }
    reached = add(reached, giant);
  }
  throw InternalError("a divisor class has no order below the Hasse-Weil bound");
}

} // namespace kov
