#pragma once
// Consequences of "v1, ..., vk are integers, u1, ..., ul are not", by linear algebra over Z.
//
// The functions of the parameters that occur are taken as vectors over Q.  Their linear relations
// mu1 v1 + ... + muk vk = c restrict the integers (v1, ..., vk) to a coset of a lattice, or to
// nothing; a combination of v1, ..., vk takes there the values of a class a + gZ.  For linear
// functions of free parameters this is all that follows from the vi; of the ui each is used alone,
// and more may follow (3 n in Z and n, n + 1/3, n - 1/3 not in Z contradict each other).
//
// Source  docs/theory/strata.md, 10.7

#include "exact/truth.hpp"
#include "parameters/conditions.hpp"

#include <optional>

namespace kov {

/// v, if it is a number that the membership does not allow.
/// Example violated({a, true}, Rational(1, 2) * one)  // -> 1/2
/// Example violated({a, true}, Rational(1, 2) * a).has_value()  // -> no
[[nodiscard]] std::optional<Rational> violated(const Membership& m, const MFraction& v);

/// Why v is an integer, or is none, wherever the memberships w1, w2, ... hold: an identity.
///   integral:          sum1 w1 + sum2 w2 + ... - v is an integer
///   not, with `none`:  times v + sum1 w1 + ... - w_none is an integer, and w_none is none
///   not, without:      times v + sum1 w1 + ... is a constant, and no integer
/// sum is 0 at memberships that say "not in Z".
struct IntegerProof {
  bool integral = false;
  Integer times;
  std::vector<Integer> sum;
  std::optional<std::size_t> none;
};
/// Unset: v is 0, or none of these identities holds; then, if all memberships say "in Z" of linear
/// functions of free parameters, v is an integer at some points and none at others (strata.md 10.7).
/// Cost    a Hermite normal form with as many rows as memberships, for each that says "not in Z"
/// Example integer_proof({{Rational(2) * a, true}}, a + Rational(1, 4) * one)->integral  // -> no
[[nodiscard]] std::optional<IntegerProof> integer_proof(const std::vector<Membership>& known,
                                                        const MFraction& v);

/// yes: v is an integer wherever the memberships hold; no: nowhere; unknown: neither follows.
/// Given   const Membership a_is_integer{a, true};
/// Example is_integral({a_is_integer}, Rational(2) * a + one)  // -> Truth::yes
/// Example is_integral({a_is_integer}, Rational(1, 2) * a + Rational(1, 4) * one)  // -> Truth::no
/// Example is_integral({a_is_integer}, Rational(1, 2) * a)  // -> Truth::unknown
[[nodiscard]] Truth is_integral(const std::vector<Membership>& known, const MFraction& v);

/// Proved: the memberships cannot hold together.
/// Example contradict({{Rational(2) * a, true}, {Rational(4) * a, false}})  // -> yes
[[nodiscard]] bool contradict(const std::vector<Membership>& known);

} // namespace kov
