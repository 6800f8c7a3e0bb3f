// The recurrence of the symmetric powers against products of power series solutions.

#include "invariant/symmetric_power.hpp"

#include "linode/series.hpp"
#include "support/equations.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using testing::from_square;
using testing::series_at;
using testing::solution_series;

// Is v = sum_i c_i y1^(m-i) y2^i near z0, with y1 = 1 + ..., y2 = t + ...?  The first m+1
// coefficients give the c_i, one after the other; n terms decide.
bool is_a_form_in_the_solutions(const RationalFunction& v, const RationalFunction& r, long m,
                                const NfElem& z0) {
  constexpr long n = 40;
  const Poly q = -series_at(r, z0, n);
  const Poly y1 = solution_series(Poly(0), q, NfElem(1), NfElem(0), n);
  const Poly y2 = solution_series(Poly(0), q, NfElem(0), NfElem(1), n);
  Poly rest = series_at(v, z0, n);
  for (long i = 0; i <= m; ++i) {
    Poly product(1); // t^i + ...
    for (long j = 0; j < m; ++j)
      product = truncate(product * (j < i ? y2 : y1), n);
    rest -= scale(product, rest.coeff(i));
  }
  return is_zero(rest);
}

// v = p prod q^e over the places; nothing if v has a pole elsewhere.
std::optional<Invariant> as_invariant(const RationalFunction& v, const Singularities& s, long m) {
  Invariant result{m, Poly(1), {}};
  RationalFunction rest = v;
  for (const Singularity& place : s.finite) {
    const long e =
        remove_factor(v.num(), place.place).first - remove_factor(v.den(), place.place).first;
    result.e.push_back(e);
    rest = rest * pow(RationalFunction(place.place), -e);
  }
  if (degree(rest.den()) > 0) return std::nullopt;
  result.p = rest.num();
  return result;
}

TEST(SymmetricPower, AgreesWithProductsOfSeriesSolutions) {
  int solved = 0;
  int refused = 0;
  test::random_rounds(25, [&](test::Random& random) {
    const auto line = [&] { return Poly::z() - Poly(random.between(1, 6)); };
    const bool square = random.once_in(2);
    const RationalFunction v = square ? RationalFunction(line() * line(), line())
                                      : RationalFunction(line() * line() * line());
    const RationalFunction f = square ? v * v : v;
    const RationalFunction r = from_square(f, NfElem(Rational(random.between(1, 5), 2)));
    const Singularities s = singularities(r);
    const NfElem z0(-1); // ordinary: all places are positive
    std::vector<std::pair<RationalFunction, long>> tried{
        {f, 4}, {f * f, 8}, {f + RationalFunction(1), 4}};
    if (square) tried.insert(tried.end(), {{v, 2}, {v * f, 6}, {v + RationalFunction(3), 2}});
    tried.emplace_back(f * RationalFunction(Poly::z()), 4);
    for (const auto& [candidate, m] : tried) {
      const auto invariant = as_invariant(candidate, s, m);
      if (!invariant) continue;
      const bool expected = is_a_form_in_the_solutions(candidate, r, m, z0);
      EXPECT_EQ(solves_symmetric_power(*invariant, s), expected)
          << to_string(candidate) << " for r = " << to_string(r) << ", m = " << m;
      EXPECT_EQ(value(*invariant, s), candidate);
      ++(expected ? solved : refused);
    }
  });
  EXPECT_GT(solved, 40);
  EXPECT_GT(refused, 15);
}

} // namespace
} // namespace kov
