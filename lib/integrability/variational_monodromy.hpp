#pragma once
// Monodromy matrices of the whole variational equation along a phase curve, and what they prove.

#include "algebraize/algebraize.hpp"
#include "algebraize/rational_system.hpp"
#include "literature/levels.hpp"
#include "monodromy/elliptic_time.hpp"
#include "monodromy/identity_component.hpp"
#include "system/system.hpp"

namespace kov {

/// The variational equation, or a part of it, as a system over K(z) with numbers only.
struct NumericalVariation {
  std::vector<std::string> names; ///< of the unknowns (algebraize/rational_system.hpp)
  std::string change;
  monodromy::DifferentialSystem system;
  RationalSystem rational; ///< the same as functions of the parameters
  MFraction phi;           ///< the change of variable
};

/// With the change of variable of the file or, without one, the proposed one that gives the
/// smallest system.  `divisors`: what the derivation of the part divided by.
/// Errors  InvalidArgument: parameters without values; no change of variable leads to a system of
///         size <= 8; OutOfBudget
[[nodiscard]] NumericalVariation numerical_variation(const System& s, const InvariantManifold& m,
                                                     const LinearSystem& linear,
                                                     const std::vector<MPoly>& divisors,
                                                     const Budget& budget = {});

/// The same by the time, where the phase curve is w^2 = F(z), w = dz/dt, F of degree 3 or 4.
struct EllipticVariation {
  std::vector<std::string> names;
  std::string change;
  monodromy::EllipticSystem system;
};

/// Errors  InvalidArgument: parameters without values; no change of variable leads to such a
///         curve; OutOfBudget
[[nodiscard]] EllipticVariation elliptic_variation(const System& s, const InvariantManifold& m,
                                                   const LinearSystem& linear,
                                                   const Budget& budget = {});

/// Two unknowns that are a diagonal block of the system, and words in the periods and poles
/// (monodromy/elliptic_time.hpp: elements) that make the group of this block SL(2, C) up to scalars.
struct EllipticBlockProof {
  std::vector<std::size_t> block;
  monodromy::Sl2Proof words;
};
/// Unset when nothing is seen, which proves nothing.
/// Source  docs/theory/monodromy.md 7.6, 11.4
[[nodiscard]] std::optional<EllipticBlockProof>
prove_non_abelian(const monodromy::EllipticSystem& s, const monodromy::EllipticMonodromy& m,
                  const Budget& budget = {});

/// N such that all eigenvalues of every element of the group are N-th roots of unity: from
/// the diagonal blocks of the system, each of order 1 or 2, whose groups are found by algebra.
/// Nothing where a block is larger, its group has other eigenvalues or is not determined.
/// Cost  `decide` for each block of order 2
[[nodiscard]] std::optional<long> eigenvalue_order(const monodromy::DifferentialSystem& s,
                                                   const Budget& budget = {});

/// Why the identity component of the group of a system is not abelian: one of these.
struct NonAbelianVariation {
  std::optional<monodromy::NonAbelianProof> unipotent;
  bool by_blocks = false; ///< the powers are unipotent by eigenvalue_order, not by local exponents
  std::optional<monodromy::Sl2Proof>
      block_proof; ///< a diagonal block is dense in SL(2, C), up to scalars
  std::vector<std::size_t> block;
};

/// The same as the reason of a verdict.
struct MatrixEvidence {
  NonAbelianVariation proof;
  std::vector<std::string> part; ///< a diagonal block of the normal part; empty: all of it
  long size = 0;                 ///< of the system
  std::vector<std::string> unknowns;
  std::string change;
  bool keeps_casimirs = false; ///< of the normal part on the whole Poisson manifold
  LevelChoice level;           ///< h = 1; empty: the level was not free
  std::string certificate;     ///< kovacic-loops/1, accepted by the judge; empty: none
  bool has_way = false;        ///< with the whole way to it, kovacic-system/1
  std::string no_certificate;
};

/// Unset when nothing is seen, which proves nothing.
/// Source  docs/theory/monodromy.md 6, 7
[[nodiscard]] std::optional<NonAbelianVariation>
prove_non_abelian(const monodromy::DifferentialSystem& s, const monodromy::Monodromy& m,
                  const Budget& budget = {});

} // namespace kov
