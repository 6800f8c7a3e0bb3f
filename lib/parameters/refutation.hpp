#pragma once
// Searches for proofs over the reals: that no real point satisfies all of a list of conditions, as a
// NODE of docs/theory/theorem_certificates.md 2, which a checker verifies by expanding.  A proof not
// found says nothing.

#include "exact/budget.hpp"
#include "proof/condition/condition.hpp"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace kov {

using certify::Condition;
using certify::Json;
using certify::negation;
using certify::Sign;

/// scale f = rest + sum cofactors[i] (condition i); scale > 0.
struct ReducedPoly {
  Integer scale{1};
  MPoly rest;
  std::map<std::size_t, MPoly> cofactors;
};

/// Factorisations that one search asks for again and again.
class Factorizations {
public:
  using Factors = std::pair<Integer, std::vector<MFactor>>;
  /// As `factor`, f of one ring.
  const Factors& of(const MPoly& f);

private:
  std::map<std::string, Factors> known_;
};
using SharedFactorizations = std::shared_ptr<Factorizations>;

/// Consequences of a list of conditions, without any case distinction.
class RealFacts {
public:
  /// All names of the ring are real variables.
  explicit RealFacts(Ring ring, std::vector<Condition> given,
                     SharedFactorizations factorizations = std::make_shared<Factorizations>());

  [[nodiscard]] const std::vector<Condition>& given() const { return given_; }
  /// The node `empty`, if it is found.
  [[nodiscard]] std::optional<Json> contradiction() const;
  /// f modulo the equations that are linear with a constant coefficient.
  [[nodiscard]] ReducedPoly reduced(const MPoly& f) const;
  /// Polynomials whose sign, or vanishing, would help; best first.
  struct Split {
    MPoly p;
    bool ordered = false; ///< p > 0, = 0, < 0, and not only != 0, = 0
  };
  [[nodiscard]] std::vector<Split> splits() const;

private:
  struct Basis { ///< l x + ..., l > 0 a number, a combination of the conditions
    std::size_t x = 0;
    MPoly b;
    std::map<std::size_t, MPoly> cofactors;
  };
  struct Term { ///< c Q^2 prod (condition i)^e
    Rational c{1};
    MPoly q;
    std::vector<std::pair<std::size_t, long>> powers;
    bool strict = false;
  };
  struct Known { ///< a condition that is `ratio` times the polynomial looked for
    std::size_t condition = 0;
    Rational ratio;
  };

  void solve();
  void combine_equations();
  bool put_equation(std::size_t i);
  [[nodiscard]] std::optional<Known> known(const MPoly& q, bool ordered) const;
  [[nodiscard]] std::optional<std::vector<Term>> terms_of(const MPoly& f, int sign, bool by_squares,
                                                          std::vector<Split>* missing) const;
  [[nodiscard]] std::optional<std::vector<Term>>
  strict_terms_of(const MPoly& f, int sign, bool by_squares, std::vector<Split>* missing) const;
  [[nodiscard]] bool put_group(std::vector<Term>& all, const MPoly& c, const MPoly& monomial,
                               int sign, std::vector<Split>* missing) const;
  [[nodiscard]] std::optional<Json> finish(const std::vector<Term>& terms) const;
  [[nodiscard]] std::optional<Json> plain() const;
  [[nodiscard]] std::optional<Json> by_signs(std::vector<Split>* missing) const;
  [[nodiscard]] std::optional<Json> by_factors() const;
  [[nodiscard]] std::optional<Json> by_combination() const;
  [[nodiscard]] std::optional<Json> by_opposites() const;
  [[nodiscard]] Term one() const;
  [[nodiscard]] Term power(std::size_t i, long e) const;

  Ring ring_;
  std::vector<Condition> given_;
  SharedFactorizations factorizations_;
  std::vector<Basis> basis_;
  std::vector<ReducedPoly> reduced_;   ///< of the conditions
  std::vector<ReducedPoly> equations_; ///< nonlinear: rest = sum cofactors (condition), scale 1
  std::optional<ReducedPoly> number_;  ///< an equation that is a number other than 0
};

/// The NODE, or nothing if it is not found with case distinctions of this depth.  `known` may come
/// from searches before, in the same ring.
/// Errors  OutOfBudget
/// Example refutation(ring, {{a.num(), Sign::positive}, {-a.num(), Sign::nonnegative}}, 1).has_value()
///         // -> yes
/// Example refutation(ring, {{a.num(), Sign::positive}}, 1).has_value()  // -> no
[[nodiscard]] std::optional<Json> refutation(const Ring& ring, const std::vector<Condition>& given,
                                             int depth, const Budget& budget = {},
                                             const SharedFactorizations& known = {});
/// The same for the conditions and the negation of c.
[[nodiscard]] std::optional<Json> shown(const Ring& ring, std::vector<Condition> given,
                                        const Condition& c, int depth, const Budget& budget = {},
                                        const SharedFactorizations& known = {});
/// A node is found and the judge accepts it: the conditions, of real variables, have no point.
/// Example is_refuted_exactly({{a.num(), Sign::nonzero}, {(a * a).num(), Sign::zero}})  // -> yes
/// Example is_refuted_exactly({{(a * a).num(), Sign::zero}})  // -> no
[[nodiscard]] bool is_refuted_exactly(std::vector<Condition> conditions);
/// The sign of p wherever the conditions, of real variables, hold.
struct KnownSign {
  int sign = 1; ///< of p: 1 or -1
  Json node; ///< shows (sign p, positive) from the conditions in their order; the judge accepts it
};
/// The sign of p, by sums of squares and products of conditions, with few case distinctions; unset: not
/// found.
/// Example sign_follows({{a.num(), Sign::positive}}, (-a - one).num())->sign  // -> -1
/// Example sign_follows({{a.num(), Sign::nonnegative}}, a.num()).has_value()  // -> no
[[nodiscard]] std::optional<KnownSign> sign_follows(std::vector<Condition> known, MPoly p);

// JSON of nodes
[[nodiscard]] Json json_text(std::string s);
[[nodiscard]] Json json_list(std::vector<Json> all);
[[nodiscard]] Json json_sign_node(const MPoly& p, Json positive, Json zero, Json negative);
[[nodiscard]] Json json_zero_node(const MPoly& p, Json nonzero, Json zero);

} // namespace kov
