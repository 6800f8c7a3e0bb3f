#pragma once
// A stratum as the checker of a certificate sees it: conditions with their numbers, polynomials
// that are known not to vanish, and lemmas that prove more of them.  The solver's own bookkeeping
// is parametrised_set.hpp; a certificate is written against this one.
//
// docs/theory/strata_certificates.md, 3 and 5

#include "parameters/signs.hpp"

#include <map>
#include <optional>

namespace kov::strata {

using certify::Lemma;
using certify::LemmaTerm;
using certify::Violation;

/// The facts that the checker knows; proved ones are added.
///
/// Given   Assumptions assumed; assumed.require(a, Sign::positive);
/// Given   KnownFacts facts(ring, assumed, {}); std::vector<Lemma> lemmas;
/// Example facts.ensure_nonzero((a + one).num(), lemmas)  // -> yes
/// Example facts.ensure_nonzero((a - one).num(), lemmas)  // -> no
class KnownFacts {
public:
  KnownFacts(Ring ring, const Assumptions& assumptions, std::vector<std::vector<MPoly>> generic);

  [[nodiscard]] const std::vector<Condition>& conditions() const noexcept { return conditions_; }
  [[nodiscard]] const std::vector<std::vector<MPoly>>& generic() const noexcept { return generic_; }
  [[nodiscard]] const std::vector<Membership>& memberships() const noexcept { return memberships_; }
  [[nodiscard]] bool is_real(const MPoly& p) const;

  /// The rest of p after division by the members of `nonzero`: constant if p is known != 0.
  [[nodiscard]] MPoly without_known_factors(MPoly p) const;
  [[nodiscard]] bool contains_zero() const; ///< a member of `nonzero` became 0

  /// Makes "p is known != 0" true, with lemmas; false if no proof is found.
  [[nodiscard]] bool ensure_nonzero(const MPoly& p, std::vector<Lemma>& lemmas);
  /// The same for "p is known positive".
  [[nodiscard]] bool ensure_positive(const MPoly& p, std::vector<Lemma>& lemmas);
  /// Terms with sum 0, one of them positive: the stratum is empty.
  [[nodiscard]] std::optional<std::vector<LemmaTerm>> contradiction() const;
  /// A membership that is constant and not what is assumed: the stratum is empty.
  [[nodiscard]] std::optional<Violation> violation() const;

  void assume_nonzero(const MPoly& p) { nonzero_.push_back(p); }
  /// p = l x + m is 0, l known != 0: everything in the parameters that are left.
  void solve(const MPoly& p, std::size_t x);

private:
  using Terms = std::vector<LemmaTerm>;
  void add(const Lemma& lemma);
  [[nodiscard]] std::optional<std::pair<std::size_t, int>>
  condition_with_sign(const MPoly& f) const;
  [[nodiscard]] SignProver signs() const { return {ring_, conditions_, nonzero_, real_}; }
  [[nodiscard]] std::optional<std::pair<std::size_t, int>> ensure_sign(const MPoly& f,
                                                                       std::vector<Lemma>& lemmas);
  [[nodiscard]] bool divides_known(const MPoly& f, std::vector<Lemma>& lemmas);
  [[nodiscard]] bool violates(const MPoly& f, std::vector<Lemma>& lemmas);
  [[nodiscard]] bool has_no_rational_root(const MPoly& f, std::vector<Lemma>& lemmas);

  Ring ring_;
  std::vector<Condition> conditions_; ///< with their numbers in the certificate
  std::vector<MPoly> nonzero_;
  std::vector<Membership> memberships_; ///< with their numbers in the certificate
  std::vector<std::size_t> real_, rational_;
  std::vector<std::vector<MPoly>> generic_;
};

/// l^N p(-m/l), N >= deg_x p: p where l x + m = 0, without a denominator.
[[nodiscard]] MPoly on_line(const MPoly& p, std::size_t x, const MPoly& l, const MPoly& m, long n);

} // namespace kov::strata
