#pragma once
// y'' = r y  ->  Galois group, identity component, "is it abelian?", solutions, and the reason.

#include "exact/budget.hpp"
#include "exact/truth.hpp"
#include "galois/group.hpp"
#include "linode/normal_form.hpp"
#include "linode/singularities.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kov {

enum class Method : std::uint8_t { automatic, kovacic, engines, all };

struct Options {
  Budget budget;
  Method method = Method::automatic;
  std::optional<int> only_case; ///< look at one of Kovacic's cases only (the answer may be partial)
  std::string variable = "z";   ///< only for printing
  bool want_solutions = true;
  bool want_trace = false;
  bool want_certificate = false; ///< written, and accepted by the judge of lib/certify
};

/// A Liouvillian solution of y'' = r y.
struct Solution {
  /// "exponential": y itself, as P*prod(z-c)^e*exp(...)
  /// "minimal-polynomial": polynomial in w = y'/y over K(z), ascending coefficients
  std::string kind;
  std::string y;                               ///< exponential: text of y
  std::string omega;                           ///< exponential: y'/y as text
  std::vector<std::string> minimal_polynomial; ///< ascending, text in z (and constants)
  std::string note; ///< e.g. "delta^2 = 5" when a square root of a constant is adjoined
};

/// One line of the derivation, for --trace.
struct TraceStep {
  std::string step; ///< "Case 1, step 2", ...
  std::string text;
};

struct Decision {
  RationalFunction r;
  std::string variable = "z";
  std::optional<Singularities> places; ///< of r, if they were looked at
  std::optional<GaloisGroup> group;    ///< unset: not determined (see reason)
  std::optional<Connected> component;  ///< may be known where the group is not
  Truth abelian = Truth::unknown;      ///< of the identity component
  std::optional<int> kovacic_case;
  std::vector<Solution> solutions;
  std::string reason;              ///< full sentences; for "unknown": why
  std::optional<Unable> undecided; ///< set when anything asked stayed open
  std::vector<TraceStep> trace;
  std::string certificate;    ///< JSON text; empty if not asked for, or
  std::string no_certificate; ///< why there is none
  std::string refused; ///< the certificate that our own checker refused; with it goes the verdict
  double seconds = 0;
};

/// What Kovacic's algorithm came to: its case, or the limit that stopped it.
struct SecondOpinion {
  std::optional<int> kovacic_case;
  std::string limit;
};
/// Two methods, one answer: agreement is noted, a limit or a disagreement takes the answer back
/// (Unable::budget, Unable::methods_disagree).
void compare(Decision& d, const SecondOpinion& other);

/// Never throws for a legal r: limits end in Decision::undecided.  So does a certificate that our
/// own checker refuses (Unable::methods_disagree): nothing is said then.
/// Throws InternalError if a self-check fails.
[[nodiscard]] Decision decide(const NormalForm& equation, const Options& options = {});

} // namespace kov
