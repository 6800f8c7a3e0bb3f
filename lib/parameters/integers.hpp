#pragma once
// What follows from "v1, ..., vk are integers, u1, ..., ul are not", by linear algebra over Z.
//
// The functions of the parameters that occur are taken as vectors over Q.  Their linear relations
// mu1 v1 + ... + muk vk = c restrict the integers (v1, ..., vk) to a coset of a lattice, or to
// nothing; a combination of v1, ..., vk takes there the values of a class a + gZ.  For linear
// functions of free parameters this is all that follows.
//
// Source  docs/theory/strata.md, 10.7

#include "exact/truth.hpp"
#include "parameters/conditions.hpp"

namespace kov {

/// yes: v is an integer wherever the memberships hold; no: nowhere; unknown: neither follows.
/// Cost    Hermite normal forms of matrices with as many rows as memberships
/// Given   const Membership a_is_integer{a, true};
/// Example is_integral({a_is_integer}, Rational(2) * a + one)  // -> Truth::yes
/// Example is_integral({a_is_integer}, Rational(1, 2) * a + Rational(1, 4) * one)  // -> Truth::no
/// Example is_integral({a_is_integer}, Rational(1, 2) * a)  // -> Truth::unknown
[[nodiscard]] Truth is_integral(const std::vector<Membership>& known, const MFraction& v);

/// Proved: the memberships cannot hold together.
/// Example contradict({{Rational(2) * a, true}, {Rational(4) * a, false}})  // -> yes
[[nodiscard]] bool contradict(const std::vector<Membership>& known);

} // namespace kov
