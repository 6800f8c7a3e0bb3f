#pragma once
// Sets of points, that is values of names, and what holds at each of them: strata_certificates.md 3 to 5,
// theorem_certificates.md 2.  Nothing is searched for.

#include "proof/condition/condition.hpp"

namespace kov::certify {

/// x = -m/l: f becomes f* = sum f_k (-m)^k l^(N-k).
class Root {
public:
  Root(Arithmetic& a, MPoly slope, const MPoly& m) : a_(a), l_(std::move(slope)), minus_m_(-m) {}

  /// N: at least the degree of f in x, which it is if it is not given.
  [[nodiscard]] MPoly operator()(const MPoly& f, std::size_t x, long N = 0) const;

private:
  Arithmetic& a_;
  MPoly l_, minus_m_;
};

/// The points at which all conditions hold.
class ConditionSet {
public:
  /// names: by variable of the ring, which of them occur; real, rational: which have such a value at each
  /// point, the rational ones among the real ones.  Requires that the arithmetic stays alive.
  ConditionSet(Ring ring, Arithmetic& a, std::vector<bool> names, std::vector<bool> real,
               std::vector<bool> rational = {});
  /// All names of the ring are real.
  ConditionSet(const Ring& ring, Arithmetic& a)
      : ConditionSet(ring, a, std::vector<bool>(ring->size(), true),
                     std::vector<bool>(ring->size(), true)) {}

  [[nodiscard]] const Ring& ring() const { return ring_; }
  [[nodiscard]] Arithmetic& arithmetic() const { return *arithmetic_; }
  [[nodiscard]] const Conditions& conditions() const { return conditions_; }
  /// Refuses an index that is out of range, and another sign.
  [[nodiscard]] const MPoly& condition(std::size_t i, std::initializer_list<Sign> signs) const;
  [[nodiscard]] const Membership& membership(std::size_t i) const; ///< Refuses, as condition().
  [[nodiscard]] const std::vector<MPoly>& group(std::size_t i) const;

  [[nodiscard]] const std::vector<bool>& names() const { return names_; } ///< by variable
  void hide(std::size_t variable) { names_[variable] = false; }           ///< it does not occur
  void assume(Condition c);
  void forget(); ///< the last condition
  void assume(Membership m);
  /// Not all of them are 0.
  void assume_some(std::vector<MPoly> all) { groups_.push_back(std::move(all)); }
  void add_unit(const MPoly& p) { added_.push_back(p); } ///< it is 0 nowhere; without a number

  /// Its names are, or a condition says so of a multiple by a number.
  [[nodiscard]] bool is_real(const MPoly& p) const;
  [[nodiscard]] bool is_rational(const MPoly& p) const; ///< its names are
  /// A number that is not 0, or such a number times a product of what is 0 nowhere.
  /// Cost  counted: a division by each of them, as often as it goes
  [[nodiscard]] bool is_unit(const MPoly& p) const;
  /// A positive multiple of what a condition says to be positive, or such a number.
  [[nodiscard]] bool is_positive(const MPoly& p) const;
  /// p divided by all that is 0 nowhere, as often as it goes.
  [[nodiscard]] MPoly rest(MPoly p) const;
  /// The polynomials that are 0 nowhere, each divided by the others: a product is recognised whatever the
  /// order in which its factors came.  If 0 is among them, there is no point.
  [[nodiscard]] const std::vector<MPoly>& units() const;

  /// The sum of the terms times k > 0, and k.  It is > 0 at each point; of one term alone, if `positive` is not
  /// asked for, it is 0 nowhere.
  [[nodiscard]] std::pair<MPoly, Integer> sum(const std::vector<SignTerm>& terms,
                                              bool positive) const;
  /// Refuses unless a membership would have the value c, which it has not: where p = 0; everywhere if p is null.
  void need_violated(std::size_t membership, const Rational& c, const MPoly* p) const;
  void need_shown(const ShownMembership& x) const;
  /// p has no root modulo the prime q, and so no rational one.
  void need_no_rational_root(const MPoly& p, mp_limb_t q) const;

  /// The points with p = 0, p = l x + m; x does not occur any more.
  Root solve(const MPoly& p, std::size_t x);
  /// A number that the work of copying this is proportional to.
  [[nodiscard]] double size() const;

private:
  [[nodiscard]] bool is_strict(const SignTerm& t) const; ///< it is 0 nowhere
  [[nodiscard]] bool has_sign(const SignTerm& t) const;  ///< it is >= 0 everywhere
  void replace(std::size_t x, const Root& root, bool real);
  void learn_sorts(const MPoly& p, std::size_t x);
  void divide(const MPoly& unit) const;

  Ring ring_;
  Arithmetic* arithmetic_;
  std::vector<bool> names_, real_, rational_; ///< by variable
  Conditions conditions_;
  std::vector<Membership> memberships_;
  std::vector<std::vector<MPoly>> groups_;
  std::vector<MPoly> added_; ///< 0 nowhere, in the order in which they came
  mutable std::vector<MPoly> units_;
  mutable std::size_t divided_ = 0; ///< so many of added_ are in units_
};

/// Is f = 0 wherever p = 0?  Everywhere, if p is null?
[[nodiscard]] bool vanishes(const MPoly& f, const MPoly* p, Arithmetic& a);

} // namespace kov::certify
