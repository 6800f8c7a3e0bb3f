#pragma once
// The way from a system to y'' = r(z) y, written down for the checkers: the solution along the
// manifold as functions of z, one covector and its equation (docs/theory/system_certificates.md).

#include "certify/system/check.hpp"
#include "integrability/normal_identity.hpp"
#include "integrability/study.hpp"
#include "literature/trusted.hpp"

namespace kov {

struct WayToR {
  certify::Way way;
  /// The generator of the field of r, if r has algebraic constants.
  std::optional<certify::CurveFunction> root;
  /// Denominators that vanish identically in z for some parameters that the file admits: there the
  /// way says nothing.
  std::vector<MPoly> exceptions;
  bool leaves_out = false; ///< something moves along the curve and has no value on it
};

/// The certificate of the whole way with this one of y'' = r y (a text), and whether the checker
/// accepts it.   `none`: why not.
[[nodiscard]] std::optional<std::string>
certificate_of(const WayToR& way, const std::string& equation, std::string& none);

/// The certificate of the whole way to a system over K(z) with this one of its matrices (kovacic-loops/1), or
/// of the latter alone; `has_way`: which.
struct LoopsOfWay {
  std::string text;
  bool has_way = false;
};
[[nodiscard]] LoopsOfWay certificate_of(const Study& study, const ManifoldReport& report,
                                        const RationalSystem& system, const MFraction& phi,
                                        const UnknownsOfSystem& unknowns, const std::string& loops);

/// The steps of the way to r(z) along this manifold that have no certificate, as steps on trust.
[[nodiscard]] std::vector<Trusted> uncertified_way(const ManifoldReport& m);

/// If certificates or our own checker are asked for, from what the derivation of `block.ode`
/// holds: sets block.way, after the checker has accepted it, or block.no_way; a limit is a reason,
/// too.  A refusal for another reason than a size is marked.
void find_way(const Study& study, const ManifoldReport& report, BlockReport& block);

/// A block whose way our own checker refuses says nothing any more, but why.
void withdraw_refused(std::vector<BlockReport>& blocks);

} // namespace kov
