#include "exact/modular_gcd.hpp"

#include "exact/chinese_lift.hpp"

namespace kov {
namespace {

// About [K:Q]! primes are met before one splits completely.
constexpr long largest_degree = 6;
constexpr int prime_limit = 4000;

using Images = std::vector<NmodPoly>;

// The gcd modulo each ideal above one prime; nothing if the prime is not good for a and b.
std::optional<Images> gcd_modulo(const std::vector<PrimeIdeal>& ideals, const Poly& a,
                                 const Poly& b) {
  Images images;
  for (const PrimeIdeal& ideal : ideals) {
    const auto x = ideal.reduce(a);
    const auto y = ideal.reduce(b);
    // If one leading coefficient survives, the image of the gcd keeps its degree.
    if (!x || !y || (degree(*x) != degree(a) && degree(*y) != degree(b))) return std::nullopt;
    images.push_back(gcd(*x, *y));
    if (degree(images.back()) != degree(images.front())) return std::nullopt;
  }
  return images;
}

// Rows for ChineseLift: the first n coefficients of each image.
std::vector<std::vector<mp_limb_t>> residues(const Images& images, long n) {
  std::vector<std::vector<mp_limb_t>> rows;
  for (const NmodPoly& g : images) {
    auto& row = rows.emplace_back();
    for (long i = 0; i < n; ++i)
      row.push_back(g.coeff(i));
  }
  return rows;
}

std::optional<Poly> lifted(const ChineseLift& lift) {
  const auto coefficients = lift.reconstruct();
  if (!coefficients) return std::nullopt;
  return Poly::from_coefficients(*coefficients);
}

// The inverse of a modulo q at each ideal above one prime; nothing if there is none.
std::optional<Images> inverse_modulo(const std::vector<PrimeIdeal>& ideals, const Poly& a,
                                     const Poly& q) {
  Images images;
  for (const PrimeIdeal& ideal : ideals) {
    const auto x = ideal.reduce(a);
    const auto y = ideal.reduce(q);
    if (!x || !y || degree(*y) != degree(q)) return std::nullopt;
    NmodPoly s(ideal.p);
    if (nmod_poly_invmod(s.raw(), x->raw(), y->raw()) == 0) return std::nullopt;
    images.push_back(std::move(s));
  }
  return images;
}

// The quotient modulo each ideal above one prime.
struct QuotientImages {
  bool good = true;  ///< the leading coefficient of b survives
  bool exact = true; ///< no remainder
  Images images;
};

QuotientImages quotient_modulo(const std::vector<PrimeIdeal>& ideals, const Poly& a,
                               const Poly& b) {
  QuotientImages out;
  for (const PrimeIdeal& ideal : ideals) {
    const auto x = ideal.reduce(a);
    const auto y = ideal.reduce(b);
    out.good = x && y && degree(*y) == degree(b);
    if (!out.good) return out;
    NmodPoly q(ideal.p), rest(ideal.p);
    nmod_poly_divrem(q.raw(), rest.raw(), x->raw(), y->raw());
    out.exact = is_zero(rest);
    if (!out.exact) return out;
    out.images.push_back(std::move(q));
  }
  return out;
}

} // namespace

ModularQuotient modular_quotient(const Poly& a, const Poly& b) {
  const Field& k = common_field(a.field(), b.field());
  const long n = degree(a) - degree(b) + 1;
  if (k->degree() > largest_degree || n < 1) return {};
  PrimeIdeals primes = PrimeIdeals::large(k);
  ChineseLift lift(k, static_cast<std::size_t>(n));
  for (int tries = 0; tries < prime_limit; ++tries) {
    const auto ideals = primes.next_split();
    const QuotientImages q = quotient_modulo(ideals, a, b);
    if (!q.good) continue;
    if (!q.exact) return {Truth::no, Poly(k)};
    lift.add(ideals, residues(q.images, n));
    if (!worth_a_try(lift.primes())) continue;
    if (auto found = lifted(lift); found && *found * b == a)
      return {Truth::yes, coerce(*std::move(found), k)};
  }
  return {};
}

std::optional<Poly> modular_gcd(const Poly& a, const Poly& b) {
  return modular_gcd(a, b, [&](const Poly& g) { return divides(g, a) && divides(g, b); });
}

std::optional<Poly> modular_gcd(const Poly& a, const Poly& b,
                                const std::function<bool(const Poly&)>& proved) {
  const Field& k = common_field(a.field(), b.field());
  if (k->degree() > largest_degree) return std::nullopt;
  PrimeIdeals primes = PrimeIdeals::large(k);
  std::optional<ChineseLift> lift;
  long d = -1;
  for (int tries = 0; tries < prime_limit; ++tries) {
    const auto ideals = primes.next_split();
    const auto images = gcd_modulo(ideals, a, b);
    if (!images) continue;
    const long now = degree(images->front());
    if (d >= 0 && now > d) continue; // this prime is unlucky
    if (now != d) {                  // those before were
      d = now;
      lift.emplace(k, static_cast<std::size_t>(d + 1));
    }
    if (d == 0) return coerce(Poly(1), k);
    lift->add(ideals, residues(*images, d + 1));
    if (!worth_a_try(lift->primes())) continue;
    if (auto g = lifted(*lift); g && proved(*g)) return g;
  }
  return std::nullopt;
}

std::optional<Poly> modular_inverse(const Poly& a, const Poly& q) {
  const Field& k = common_field(a.field(), q.field());
  if (k->degree() > largest_degree) return std::nullopt;
  PrimeIdeals primes = PrimeIdeals::large(k);
  ChineseLift lift(k, static_cast<std::size_t>(degree(q)));
  int bad = 0;
  while (bad < 4) {
    const auto ideals = primes.next_split();
    const auto images = inverse_modulo(ideals, a, q);
    if (!images) {
      ++bad; // large primes are seldom bad: a and q may have a common factor
      continue;
    }
    lift.add(ideals, residues(*images, degree(q)));
    if (!worth_a_try(lift.primes())) continue;
    if (auto s = lifted(lift); s && is_one((*s * a) % q)) return s;
  }
  return std::nullopt;
}

} // namespace kov
