#pragma once
// The proof by monodromy matrices, as a certificate of the format kovacic-loops/1
// (docs/theory/loop_certificates.md), accepted by the judge of lib/certify.

#include "integrability/variational_monodromy.hpp"

#include <string>

namespace kov {

/// One of both is empty.
struct LoopsProof {
  std::string certificate;
  std::string none; ///< why there is no certificate
};

/// The proof that the group of a system of size 2 is SL(2, C) up to scalars.
/// Cost  the judge's continuation along the loops of three words
[[nodiscard]] LoopsProof sl2_certificate(const std::string& title,
                                         const monodromy::DifferentialSystem& s,
                                         const monodromy::Monodromy& m, const Budget& budget = {});

/// The proof that the identity component of the group of a system with diagonal blocks of order 1
/// and 2 is not abelian: two words whose powers are unipotent by the groups of the
/// blocks; or, where a block of order 2 shows it alone, that the group of this block is SL(2, C) up
/// to scalars.
/// Cost  the same, and a certificate for each block of order 2
[[nodiscard]] LoopsProof not_abelian_certificate(const NonAbelianVariation& known,
                                                 const std::string& title,
                                                 const monodromy::DifferentialSystem& s,
                                                 const monodromy::Monodromy& m,
                                                 const Budget& budget = {});

} // namespace kov
