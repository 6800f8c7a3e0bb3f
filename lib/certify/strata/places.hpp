#pragma once
// The places of r on a whole stratum, the bounds that follow from them and the symmetric powers
// without solution: strata_certificates.md 7.1-7.5.

#include "certify/strata/rules.hpp"

#include <set>

namespace kov::certify {

/// How it is shown that an exponent difference is irrational.
enum class Irrational : std::uint8_t { constant, positive, discriminant };

/// Facts proved about the roots of q, or of infinity, at every point of the stratum.
struct ProvedPlace : ExponentData {
  std::optional<MPoly> q{};         ///< unset at infinity
  Coefficients chi{};               ///< chi(Delta^2) = 0; empty: not given
  std::optional<Rational> square{}; ///< Delta^2, if chi is linear and shows a constant
  std::optional<Irrational> by{};   ///< it is irrational
  std::optional<Rational> bound{};  ///< of Delta^2

  [[nodiscard]] bool ordinary() const { return order <= 0; }
  [[nodiscard]] bool simple() const { return order == 1; }
  [[nodiscard]] bool regular() const { return order == 2; }
  [[nodiscard]] bool irregular() const { return order >= 3; }
  /// No torus and no open exponent difference.
  [[nodiscard]] bool tame() const { return order <= 1 || delta; }
  [[nodiscard]] bool linear() const { return chi.size() == 2; }
  [[nodiscard]] int sign() const { return q ? -1 : 1; } ///< s of 7.7
  /// The least k/2, k >= 0, with (k/2)^2 >= bound; nothing without a bound.
  [[nodiscard]] std::optional<Rational> largest() const;
};

[[nodiscard]] inline bool is_natural_number(const Rational& x) {
  return is_integer(x) && sign(x) >= 0;
}

/// Sums of exponents.
using Sums = std::set<Rational>;
/// Adds one of the choices, times over.  Nothing when there are more than 4000 sums.
[[nodiscard]] std::optional<Sums> add_choices(Arithmetic& a, std::optional<Sums> sums,
                                              const Sums& choices, long times);

class Places : public LocalData<ProvedPlace> {
public:
  /// 7.1, 7.2, 7.3, 7.5; refuses what is not proved.
  Places(const Stratum& s, const ByPlaces& leaf);

  [[nodiscard]] const Stratum& stratum() const { return s_; }
  [[nodiscard]] const ByPlaces& leaf() const { return leaf_; }
  [[nodiscard]] bool no_line_by_degree() const; ///< a ramified place or D_1 < 0
  [[nodiscard]] bool no_line() const;
  /// The contribution of a place to the degree of a polynomial in an exponential solution, at one
  /// root; nothing if Delta is not rational.
  [[nodiscard]] static std::optional<Sums> line_choices(const ProvedPlace& x);
  /// Is it proved that Sym^m, m even, has no rational solution of the shape of degree_bound(m)?
  [[nodiscard]] bool no_invariant(long m) const;

private:
  void examine(ProvedPlace& x, const StratumPlace& given);
  void examine_exponent(ProvedPlace& x, const StratumPlace& given);
  void need_chi(const ProvedPlace& x) const;
  void need_irrational(const ProvedPlace& x) const;
  void need_bound(const ProvedPlace& x) const;
  void need_separate() const;
  void need_order(const ProvedPlace& x) const;
  [[nodiscard]] MPoly resultant(const MPoly& f, const MPoly& g) const;
  void need_full_rank(const AbsentInvariant& x, long D) const;
  [[nodiscard]] Coefficients minors(const AbsentInvariant& x, std::size_t n) const;
  void need_no_common_root(const Coefficients& minors, const AbsentInvariant& x) const;
  static void set_real(ProvedPlace& x);
  [[nodiscard]] std::vector<InvariantPlace> exponents(long m) const;

  const Stratum& s_;
  const ByPlaces& leaf_;
  Arithmetic& a_;
};

/// den/q^2 at a regular place.
[[nodiscard]] MPoly without_pole(const Stratum& s, const MPoly& q);
/// Delta^2 = X/Y at the roots of q (7.2): Y = q'^2 den/q^2, X = Y + 4 num.
[[nodiscard]] Fraction difference_squared(const Stratum& s, const MPoly& q);

/// 7.9: three places, and two differences that are not rational.
void check_separated(const Places& places);

/// 7.3: is the defect of Frobenius' recurrence at x, Delta = N >= 1, deg q = 1, known to be
/// nonzero?
[[nodiscard]] bool has_logarithm(const Stratum& s, const ProvedPlace& x);

} // namespace kov::certify
