// Rules "no-exponential" and "no-invariant": see witness.hpp.

#include "decide/witness.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "proof/text/limits.hpp"
#include "riccati/line.hpp"

#include <algorithm>

namespace kov::witness {

namespace {

constexpr int prime_tries = 40;

// Berlekamp and Massey, ended where the length of the recurrence would exceed `bound`: the
// recurrence that holds up to that place shows that a longer one is needed.
std::optional<certify::ApproximantLine> too_short(const std::vector<mp_limb_t>& S, long bound,
                                                  const nmod_t& mod) {
  const auto terms = static_cast<long>(S.size());
  std::vector<mp_limb_t> reversed(S.rbegin(), S.rend()), C{1}, B{1};
  const int limbs = _nmod_vec_dot_bound_limbs(terms, mod);
  long length = 0, gap = 1;
  mp_limb_t last = 1;
  for (long k = 0; k < terms; ++k) {
    const auto size = std::min<long>(static_cast<long>(C.size()), k + 1);
    const mp_limb_t d =
        _nmod_vec_dot(C.data(), reversed.data() + (terms - 1 - k), size, mod, limbs);
    if (d == 0) {
      ++gap;
      continue;
    }
    if (k + 1 - length > bound) return certify::ApproximantLine{length, C};
    std::vector<mp_limb_t> before = C;
    if (C.size() < B.size() + static_cast<std::size_t>(gap))
      C.resize(B.size() + static_cast<std::size_t>(gap));
    _nmod_vec_scalar_addmul_nmod(C.data() + gap, B.data(), static_cast<slong>(B.size()),
                                 nmod_neg(nmod_div(d, last, mod), mod), mod);
    if (2 * length > k) {
      ++gap;
      continue;
    }
    length = k + 1 - length;
    B = std::move(before);
    last = d;
    gap = 1;
  }
  return std::nullopt;
}

std::optional<mp_limb_t> square_root(mp_limb_t x, mp_limb_t p) {
  if (x == 0) return 0;
  const mp_limb_t root = n_sqrtmod(x, p);
  return root == 0 ? std::nullopt : std::optional(root);
}

// The data of "series" at one place modulo one prime; nothing when the prime does not serve.
std::optional<certify::BySeries> series(const certify::Judge& judge,
                                        const certify::LocalFact& local, std::optional<long> index,
                                        const PrimeIdeal& prime, long bound) {
  const certify::PlaceFact& place = local.place(index);
  certify::BySeries data;
  data.place = index;
  data.prime = prime;
  data.terms = 2 * bound + 4;
  std::optional<mp_limb_t> root;
  if (index) {
    const auto q = prime.reduce(*place.q);
    const auto all = q ? roots(*q) : std::vector<mp_limb_t>{};
    if (all.empty()) return std::nullopt;
    data.root = all.front();
    root = data.root;
  }
  const certify::Expansion e = certify::expand(judge.reduced(prime), root, place.order);
  const nmod_t mod = e.num.mod();
  const mp_limb_t top =
      place.order == 1 ? 0 : nmod_div(e.num.coeff(0), e.den.coeff(0), mod); // of t^(2nu) r
  const bool regular = place.order <= 2;
  const auto delta = square_root(regular ? nmod_add(1, nmod_mul(4, top, mod), mod) : top, prime.p);
  if (!delta) return std::nullopt;
  data.delta = *delta;
  std::vector<mp_limb_t> starts{*delta};
  if (*delta != 0) starts.push_back(nmod_neg(*delta, mod));
  for (mp_limb_t s : starts) {
    if (regular) s = nmod_mul(nmod_add(s, 1, mod), nmod_inv(2, mod), mod);
    const auto S = certify::riccati(e, s, data.terms);
    if (!S) continue;
    auto line = too_short(*S, bound, mod);
    if (!line) return std::nullopt;
    data.lines.push_back(std::move(*line));
  }
  return data;
}

// Places where the expansion is determined: few lines and small residue fields first.
std::vector<std::optional<long>> places_to_try(const Singularities& s) {
  struct Candidate {
    std::optional<long> index;
    int lines;
    long degree;
  };
  std::vector<Candidate> all;
  for (std::size_t i = 0; i < s.finite.size(); ++i)
    all.push_back({static_cast<long>(i), formal_lines(s.finite[i]), s.finite[i].degree()});
  all.push_back({std::nullopt, formal_lines(s.infinity), 1});
  all.erase(std::remove_if(all.begin(), all.end(), [](const auto& c) { return c.lines < 1; }),
            all.end());
  std::ranges::stable_sort(all, [](const Candidate& a, const Candidate& b) {
    return std::pair(a.degree, a.lines) < std::pair(b.degree, b.lines);
  });
  return mapped<std::optional<long>>(all, &Candidate::index);
}

} // namespace

certify::NoExponential no_exponential(const certify::Judge& judge, const Singularities& s,
                                      const certify::LocalFact& local, const Budget& budget) {
  if (local.any(&certify::PlaceFact::ramified)) return {certify::ByParity{}};
  if (sign(local.degree_bound_1()) < 0) return {certify::ByDegree{}};
  const auto places = places_to_try(s);
  for (std::size_t i = 0; i < std::min<std::size_t>(places.size(), 5); ++i) {
    const auto& at = places[i];
    const Integer bound = certify::length_bound(local, local.place(at));
    if (bound > Integer(30000)) throw OutOfBudget("the recurrence would be too long to write down");
    PrimeIdeals primes = PrimeIdeals::large(judge.field);
    for (int tries = 0; tries < prime_tries; ++tries) {
      budget.check();
      auto data = tried<certify::Refused>(
          [&] { return series(judge, local, at, primes.next(), to_long(bound)); });
      if (data) return {std::move(*data)};
    }
  }
  throw OutOfBudget("no prime shows that there is no exponential solution");
}

certify::NoInvariant no_invariant(const certify::Judge& judge, long m,
                                  const certify::LocalFact& local, const Budget& budget) {
  const Integer D = local.degree_bound(m);
  if (sign(D) < 0) return {m, certify::ByDegree{}};
  budget.check_degree(fits_long(D) ? to_long(D) : budget.max_degree + 1);
  PrimeIdeals primes = PrimeIdeals::large(judge.field);
  for (int tries = 0; tries < 6; ++tries) {
    budget.check();
    const PrimeIdeal prime = primes.next();
    // a point without meaning, the same in every run
    const mp_limb_t x0 = 0x9e3779b97f4a7c15U % prime.p;
    const certify::NoInvariant data{m, certify::RankModP{prime, x0, to_long(D) + m + 12}};
    if (tried<certify::Refused>(
            [&] { static_cast<void>(certify::check_no_invariant(judge, data, local)); }))
      return data;
  }
  throw OutOfBudget("no prime shows that Sym^" + std::to_string(m) + " has no rational solution");
}

} // namespace kov::witness
