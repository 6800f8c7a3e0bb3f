#include "kovacic/residue_field.hpp"

#include "exact/error.hpp"
#include "exact/factor.hpp"
#include "exact/modular.hpp"

namespace kov::kovacic {

NfElem trace(const Poly& b, const Poly& q) {
  // sum b(c)/(z-c) = tr(b)/z + ... at infinity
  return (b * derivative(q) % q).coeff(degree(q) - 1);
}

// The roles of b and q are exchanged, as in Euclid's algorithm.
NfElem norm(const Poly& b, const Poly& q) {
  const Poly g = b % q;
  if (is_zero(g)) return NfElem(0);
  const NfElem units = pow(lead(g), static_cast<unsigned long>(degree(q)));
  if (degree(g) == 0) return units;
  const NfElem swapped = norm(q, monic(g));
  return degree(q) % 2 == 1 && degree(g) % 2 == 1 ? -(units * swapped) : units * swapped;
}

RationalFunction sum_over_roots(const Poly& b, const Poly& q, long j) {
  RationalFunction f(b * derivative(q) % q, q);
  for (long i = 1; i < j; ++i)
    f = derivative(f) * RationalFunction(Rational(-1, i));
  return f;
}

namespace {

// Does one prime of degree one of the residue field show that u is not a square?
bool is_nonresidue_somewhere(const Poly& u, const Poly& q) {
  const Field& k = common_field(u.field(), q.field());
  PrimeIdeals primes(k, mp_limb_t{1} << 30);
  for (int tries = 0; tries < 12; ++tries) {
    const PrimeIdeal prime = primes.next();
    const auto place = prime.reduce(q);
    const auto image = prime.reduce(u);
    if (!place || !image || degree(gcd(*place, derivative(*place))) != 0) continue;
    for (const mp_limb_t root : roots(*place)) {
      const mp_limb_t value = evaluate(*image, root);
      if (value != 0 && n_jacobi_unsigned(value, prime.p) == -1) return true;
    }
  }
  return false;
}

// prod over the roots c of q of (T - u(c)), from the power sums by Newton's identities.
Poly characteristic_polynomial(const Poly& u, const Poly& q) {
  const long n = degree(q);
  std::vector<NfElem> power_sum{NfElem(n)};
  std::vector<NfElem> e{NfElem(1)}; // elementary symmetric functions
  Poly power(1);
  for (long k = 1; k <= n; ++k) {
    power = power * u % q;
    power_sum.push_back(trace(power, q));
    NfElem sum(0);
    for (long i = 1; i <= k; ++i) {
      const NfElem term =
          e[static_cast<std::size_t>(k - i)] * power_sum[static_cast<std::size_t>(i)];
      sum = i % 2 == 1 ? sum + term : sum - term;
    }
    e.push_back(sum / NfElem(k));
  }
  std::vector<NfElem> coefficients;
  for (long i = n; i >= 0; --i)
    coefficients.push_back(i % 2 == 0 ? e[static_cast<std::size_t>(i)]
                                      : -e[static_cast<std::size_t>(i)]);
  return Poly::from_coefficients(coefficients);
}

// The root of u for a factor h = A(T^2) + T B(T^2) of g(T^2): the polynomial -A(u)/B(u) modulo
// q.
Poly root_from_factor(const Poly& h, const Poly& u, const Poly& q) {
  Poly even(0);
  Poly odd(0);
  for (long i = degree(h); i >= 0; --i) {
    Poly& part = i % 2 == 0 ? even : odd;
    part = (part * u + Poly(h.coeff(i))) % q;
  }
  return -(even * inverse_mod(odd, q)) % q;
}

} // namespace

std::optional<Poly> square_root(const Poly& u, const Poly& q, const Budget& budget) {
  if (is_zero(u)) return u;
  if (degree(u) == 0)
    if (const auto root = exact_sqrt(u.coeff(0))) return Poly(*root);
  if (degree(q) == 1) return std::nullopt;
  if (is_nonresidue_somewhere(u, q)) return std::nullopt;
  const Poly c = Poly::z() % q;
  for (long shift = 0;; ++shift) { // almost every s = c + shift makes u s^2 primitive
    budget.check();
    const Poly s = shift == 0 ? Poly(1) : c + Poly(shift - 1);
    const Poly scaled = u * s * s % q;
    if (is_zero(scaled)) continue;
    const Poly g = characteristic_polynomial(scaled, q);
    if (!is_squarefree(g)) continue;
    const Poly squared = compose(g, Poly::monomial(NfElem(1), 2));
    const auto factors = irreducible_factors(squared, budget);
    if (factors.size() == 1) return std::nullopt;
    const Poly root = root_from_factor(factors.front().base, scaled, q);
    const Poly answer = root * inverse_mod(s, q) % q;
    KOV_ENSURE(is_zero((answer * answer - u) % q));
    return answer;
  }
}

// The norm of u = a s^2 is a^n N(s)^2; of degree 2 the trace of u plus or minus twice the root of the
// norm is a (s +- s')^2, or s^2 is the discriminant times a square.
std::vector<NfElem> square_classes(const Poly& u, const Poly& q) {
  if (degree(q) <= 1) return {u.coeff(0)};
  const NfElem product = norm(u, q);
  if (degree(q) % 2 == 1) return {product};
  std::vector<NfElem> found{NfElem(1)};
  if (degree(q) > 2) return found;
  const NfElem sum = trace(u, q);
  if (const auto root = exact_sqrt(product))
    for (const NfElem& twice : {*root + *root, -(*root + *root)})
      if (!is_zero(sum + twice)) found.push_back(sum + twice);
  if (is_zero(u.coeff(1))) { // s' = -s is possible
    const NfElem b = q.coeff(1);
    found.push_back(u.coeff(0) * (b * b - NfElem(4) * q.coeff(0)));
  }
  return found;
}

} // namespace kov::kovacic
