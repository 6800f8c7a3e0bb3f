#pragma once
// Steps on which an answer rests besides theorems of the literature, exact computation and certificates
// that the checkers accept.  A step is a value: who counts, compares or drops one looks at `step`.

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

namespace kov {

struct Trusted {
  enum class Step : std::uint8_t {
    refuted_by_z3,      ///< of: conditions, and where; no real parameters satisfy them
    no_root_by_z3,      ///< of: a polynomial in one real parameter; none of its roots is admitted
    composition,        ///< of: why there is no certificate of a theorem as a whole
    solver,             ///< of: what the solver alone says
    gap,                ///< of: what a certificate lacks for some strata
    uncertified_strata, ///< of: why there is no certificate
    uncertified_answer, ///< of: why, and the answer
    closed_answer,      ///< of a classical equation
    necessary_conditions,
    exponential_families,
    solved_for_the_energy,
    way_to_r,        ///< of: along what, and where it is not a way
    way_to_matrices, ///< of: the equation, and along what
    enclosures,      ///< of: the equation, and along what
    whole_variation, ///< of: along what; the blocks are all of it
    series,          ///< of higher variational equations
    group_of_normal_equation,
    quadratures, ///< of: along what
    residues,    ///< at doubly asymptotic solutions of the free body
    part_of_h,   ///< of: "lowest", "highest"
    exponential_coordinates,
    darboux_eigenvalues,
    darboux_logarithm,
    common_values,
    by_author ///< of: the words of a theorem file
  };
  Step step = Step::solver;
  std::string of = {};

  [[nodiscard]] bool by_z3() const {
    return step == Step::refuted_by_z3 || step == Step::no_root_by_z3;
  }
  friend auto operator<=>(const Trusted&, const Trusted&) = default;
};

/// Example sentence(Trusted{Trusted::Step::series})  // -> the series of the higher variational equations
[[nodiscard]] std::string sentence(const Trusted& t);
[[nodiscard]] std::vector<std::string> sentences(const std::vector<Trusted>& all);

} // namespace kov
