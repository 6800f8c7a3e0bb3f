#pragma once
// Solutions of y'' + p y' + q y = 0 on a stratum, valid at every point of it.
//
//   v = y1 y2, a solution of Sym^2: with C^2 = v'^2 - 2 v v'' + 4 r v^2, which is free of z,
//     y = sqrt(v) exp(+-(C/2) int 1/v) where C != 0, and sqrt(v), sqrt(v) int 1/v where C = 0
//   w = y'/y, an exponential solution: exp(int w), and the product of it with int exp(-2 int w)
//
// times exp(-1/2 int p).  A formula is kept where its logarithmic derivative solves the equation of Riccati with the
// relations of the stratum; where a denominator in it is not known to be != 0 the condition is part of the answer.
//
// Source  Kovacic 1986, 4.1; docs/theory/normal_form.md, 1

#include "strata/decide_strata.hpp"

#include <string>
#include <vector>

namespace kov::strata {

/// One or two independent solutions, where none of `nonzero` vanishes and all of `zero` do, besides the conditions of
/// the stratum.
struct ParametricSolutions {
  std::vector<MPoly> zero, nonzero;
  std::vector<std::string> y; ///< in our own notation; int(f, z) where an integral stays
};

/// f = square^2 * rest, rest a polynomial without square factors times a square-free integer.
struct RootParts {
  MFraction square;
  MPoly rest;
};
/// Requires f != 0.
/// Given   const Ring ring = make_ring({"z", "a"});
/// Given   const MFraction a = MFraction::variable(ring, 1);
/// Example parts_of_root(Rational(8) * a * a).square  // -> 2*a
[[nodiscard]] RootParts parts_of_root(const MFraction& f);

/// The stratum as a region again; unset where an equation is not solved for a parameter.
[[nodiscard]] std::optional<ParametrisedSet> region_of(const Question& q, const Stratum& s,
                                                       const std::vector<MPoly>& domain);

/// Empty: none is known in closed form.  `gauge` is -p/2, in the parameters of the question.
/// Never throws for a legal question: what needs more work than the budget is left out.
/// Given   Question square; square.r = a * a;
/// Given   const StrataAnswer all = decide_strata(square);
/// Given   const ParametrisedSet there = *region_of(square, all.strata.at(0), {});
/// Example solutions_on(square, MFraction(ring), all.strata.at(0).leaf, there).at(0).y  // -> {exp(z*a), exp(-z*a)}
[[nodiscard]] std::vector<ParametricSolutions>
solutions_on(const Question& q, const MFraction& gauge, const Leaf& leaf,
             const ParametrisedSet& region, const Budget& budget = {});

} // namespace kov::strata
