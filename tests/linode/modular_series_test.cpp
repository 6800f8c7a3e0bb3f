#include "linode/modular_series.hpp"

#include "exact/error.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

namespace kov::modular_series_test {
namespace {

NmodPoly from(mp_limb_t p, const std::vector<mp_limb_t>& c) {
  NmodPoly f(p);
  for (std::size_t i = 0; i < c.size(); ++i)
    f.set_coeff(static_cast<long>(i), c[i] % p);
  return f;
}

// Is there a monic V of degree L with sum_i V_i s_(i+j) = 0 for all j < n - L?  Gauss over F_p.
bool has_recurrence(const std::vector<mp_limb_t>& s, std::size_t L, mp_limb_t p) {
  nmod_t mod;
  nmod_init(&mod, p);
  const std::size_t n = s.size();
  std::vector<std::vector<mp_limb_t>> rows;
  for (std::size_t j = 0; j + L < n; ++j) {
    rows.emplace_back(s.begin() + static_cast<long>(j), s.begin() + static_cast<long>(j + L));
    rows.back().push_back(nmod_neg(s[j + L], mod));
  }
  std::size_t top = 0;
  for (std::size_t c = 0; c < L && top < rows.size(); ++c) {
    std::size_t pivot = top;
    while (pivot < rows.size() && rows[pivot][c] == 0)
      ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[top], rows[pivot]);
    for (std::size_t r = top + 1; r < rows.size(); ++r) {
      const mp_limb_t factor = nmod_div(rows[r][c], rows[top][c], mod);
      for (std::size_t j = c; j <= L; ++j)
        rows[r][j] = nmod_sub(rows[r][j], nmod_mul(factor, rows[top][j], mod), mod);
    }
    ++top;
  }
  for (std::size_t r = top; r < rows.size(); ++r)
    if (rows[r][L] != 0) return false;
  return true;
}

void expect_shortest(const std::vector<mp_limb_t>& s, mp_limb_t p) {
  const long n = static_cast<long>(s.size());
  const Recurrence found = shortest_recurrence(from(p, s), n);
  std::size_t shortest = 0;
  while (!has_recurrence(s, shortest, p))
    ++shortest;
  if (2 * shortest > s.size()) return; // not determined by so few terms
  std::string text;
  for (const mp_limb_t x : s)
    text += std::to_string(x) + " ";
  ASSERT_EQ(found.length, static_cast<long>(shortest)) << text << "mod " << p;
  EXPECT_EQ(degree(found.characteristic), found.length);
  nmod_t mod;
  nmod_init(&mod, p);
  for (long j = 0; j + found.length < n; ++j) {
    mp_limb_t sum = 0;
    for (long i = 0; i <= found.length; ++i)
      sum =
          nmod_addmul(sum, found.characteristic.coeff(i), s[static_cast<std::size_t>(i + j)], mod);
    EXPECT_EQ(sum, 0U) << text << "mod " << p;
  }
}

// All short sequences over the smallest fields, those that begin with zeros among them.
TEST(ShortestRecurrence, OfAllShortSequencesAgainstLinearAlgebra) {
  for (const auto& [p, length] : {std::pair(2UL, 8U), {3UL, 6U}, {5UL, 4U}})
    for (unsigned n = 1; n <= length; ++n) {
      std::vector<mp_limb_t> s(n, 0);
      while (true) {
        expect_shortest(s, p);
        std::size_t i = 0;
        while (i < n && ++s[i] == p)
          s[i++] = 0;
        if (i == n) break;
      }
    }
}

TEST(ShortestRecurrence, OfRandomSequencesWithARecurrencePlanted) {
  test::random_rounds(40, [](test::Random& random) {
    const mp_limb_t p = random.one_of<mp_limb_t>({101, 65537, 2305843009213693951UL});
    nmod_t mod;
    nmod_init(&mod, p);
    const auto L = static_cast<std::size_t>(random.between(1, 5));
    std::vector<mp_limb_t> s, c;
    for (std::size_t i = 0; i < L; ++i) {
      s.push_back(random.bits()() % p);
      c.push_back(random.bits()() % p);
    }
    while (s.size() < 14) {
      mp_limb_t next = 0;
      for (std::size_t i = 0; i < L; ++i)
        next = nmod_addmul(next, c[i], s[s.size() - L + i], mod);
      s.push_back(next);
    }
    expect_shortest(s, p);
  });
}

// c2 t^2 u'' + c1 t u' + c0 u, from derivatives of the polynomial u
NmodPoly residual(const ThetaEquation& e, const NmodPoly& u) {
  const NmodPoly t = from(u.modulus(), {0, 1});
  const NmodPoly du = derivative(u);
  return e.c2 * t * t * derivative(du) + e.c1 * t * du + e.c0 * u;
}

TEST(PowerSeriesSolution, SolvesTheEquationAndKeepsTheInitialValues) {
  test::random_rounds(60, [](test::Random& random) {
    const mp_limb_t p = random.one_of<mp_limb_t>({10007, 1152921504606847009UL});
    const long n = random.between(5, 40);
    const auto poly = [&] {
      std::vector<mp_limb_t> c;
      for (long i = random.between(0, 4); i >= 0; --i)
        c.push_back(random.bits()() % p);
      return c;
    };
    auto c2 = poly();
    auto c1 = poly();
    auto c0 = poly();
    c2[0] = 1; // indicial polynomial k(k-1) - 2, with roots 2 and -1
    c1[0] = 0;
    c0[0] = p - 2;
    const ThetaEquation e{from(p, c2), from(p, c1), from(p, c0)};
    const mp_limb_t third = 1 + random.bits()() % (p - 1);
    const NmodPoly u = power_series_solution(e, {0, 0, third}, n);
    EXPECT_EQ(u.coeff(2), third);
    EXPECT_EQ(u.coeff(0), 0U);
    EXPECT_TRUE(is_zero(truncate(residual(e, u), n)));
  });
}

TEST(PowerSeriesSolution, VanishingPivotsAreErrors) {
  const mp_limb_t p = 101;
  const ThetaEquation e{from(p, {1}), from(p, {0}), from(p, {p - 6})}; // k(k-1) = 6: k = 3
  EXPECT_THROW((void)power_series_solution(e, {0}, 10), InternalError);
  EXPECT_NO_THROW((void)power_series_solution(e, {0, 0, 0, 1}, 10));
  EXPECT_THROW((void)power_series_solution(e, {0, 0, 0, 1}, 101), InternalError); // n < p
}

} // namespace
} // namespace kov::modular_series_test
