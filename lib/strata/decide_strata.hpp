#pragma once
// y'' = r(z; parameters) y for all admissible parameters at once: a tree of strata, each split
// p = 0 / p != 0 with p found on the way, and a verdict with its reason on every leaf.
//
// Source  docs/theory/strata.md

#include "strata/proof_tree.hpp"

#include <map>

namespace kov::strata {

/// Something that was divided by on the way to r: not all coefficients may vanish.
struct Genericity {
  enum class Else : std::uint8_t {
    no_value, ///< a coefficient of the equation has none
    no_order, ///< the coefficient of the second derivative of `of` is 0
    division, ///< the reduction divides by `of`
    relations ///< those of the functions fall apart
  };
  std::vector<MPoly> not_all_zero; ///< polynomials in the parameters
  Else otherwise = Else::division;
  std::string of{};
};

struct Question {
  MFraction r;
  std::size_t z = 0;
  Assumptions assumptions;
  std::vector<Genericity> generic;
};

struct Stratum {
  std::vector<Condition> conditions; ///< in the parameters; empty: always
  Leaf leaf;
  Substitution solved; ///< the equations among the conditions, solved
  /// Set for a part that told_apart made; never in StrataAnswer::strata, whose members are
  /// given by `conditions` alone.
  std::vector<Statement> arithmetic{};
};

/// The parts of the stratum as strata of their own, or the stratum itself if it has none.
[[nodiscard]] std::vector<Stratum> told_apart(const Stratum& s);

struct StrataLimits {
  Options decide;
  std::size_t max_strata = 200;
};

struct StrataCertificate;

struct StrataAnswer {
  std::vector<Stratum> strata;        ///< disjoint; with `unvisited` they cover the assumptions
  std::vector<std::string> unvisited; ///< conditions of strata that a limit left open
  std::vector<Trusted> trusted;       ///< Z3, theorems without a rule
  std::vector<std::string> pruned;    ///< empty strata, with the conditions that contradict
  bool contradictory = false;         ///< no parameters satisfy the assumptions
  double seconds = 0;
  /// Strata on which r means nothing and an equation of their own was decided instead: that answer.
  std::vector<std::shared_ptr<const StrataAnswer>> special;
  std::shared_ptr<const Question> question; ///< what was asked
  ProofTreePtr tree;                        ///< how `strata` were found
  /// If Options::want_certificate or ask_the_judge, and it could be written.
  std::shared_ptr<const StrataCertificate> certificate;
  std::string refusal; ///< what our own checker has against it: every verdict is withdrawn then

  /// yes or no: the same on all strata; unknown otherwise.
  [[nodiscard]] Truth abelian() const;
  [[nodiscard]] bool decided() const; ///< no stratum is open, told apart
  /// All strata, each told apart.
  [[nodiscard]] std::vector<Stratum> told_apart() const;
};

/// Never throws for a legal question: limits end in open strata.
/// Given   Question bessel; bessel.r = a / z;
/// Given   const StrataAnswer answer = decide_strata(bessel);
/// Example answer.strata.size()  // -> 2
/// Example answer.abelian()  // -> Truth::unknown
[[nodiscard]] StrataAnswer decide_strata(const Question& q, const StrataLimits& limits = {});

/// The stratum that contains a point (values for all parameters), if its conditions can be checked
/// there.
/// Example stratum_at(answer, {{1, Rational(0)}})->leaf.abelian  // -> Truth::yes
[[nodiscard]] const Stratum* stratum_at(const StrataAnswer& a,
                                        const std::map<std::size_t, Rational>& point);

} // namespace kov::strata
