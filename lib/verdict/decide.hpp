#pragma once
// y'' = r y  ->  Galois group, identity component, "is it abelian?", solutions, and the reason.

#include "exact/budget.hpp"
#include "exact/truth.hpp"
#include "galois/group.hpp"
#include "linode/normal_form.hpp"
#include "linode/singularities.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace kov {

enum class Method : std::uint8_t { automatic, kovacic, engines, all };

struct Decision;
struct Judged; // verdict/certificate.hpp

struct Options {
  Budget budget;
  Method method = Method::automatic;
  std::optional<int> only_case; ///< look at one of Kovacic's cases only (the answer may be partial)
  std::string variable = "z";   ///< only for printing
  bool want_solutions = true;
  bool want_trace = false;
  bool want_certificate = false; ///< written, and accepted by the judge of lib/certify
  std::size_t max_printed = std::size_t{4} << 20; ///< bytes of solutions; 0 = no limit
  /// Told as soon as something is proved, and again when the certificate is there: before steps
  /// and solutions are made, which can take longer than the proof.
  std::function<void(const Decision&)> proved;
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
  std::string no_solutions; ///< why they are not there: a limit, or
  static constexpr const char* not_asked_for = "not asked for";
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
/// Two methods, one answer: agreement is noted, and a limit of the second one beside the answer
/// (Unable::budget); a disagreement takes the answer back (Unable::methods_disagree).
void compare(Decision& d, const SecondOpinion& other);

/// The judge's opinion of the certificate of d: an accepted one is kept; one that is too large says
/// nothing; any other refusal takes the answer back (Unable::methods_disagree).
void take(Decision& d, Judged opinion);

/// Never throws for a legal r: limits end in Decision::undecided.  So does a certificate that our
/// own checker refuses (Unable::methods_disagree): nothing is said then.
/// Throws InternalError if a self-check fails.
/// Cost    that of classify() (lib/galois), of solutions and of the certificate where they are
///         asked for
/// Example decide({z, 0}).abelian  // -> Truth::no
/// Example decide({z*z + 3, 0}).kovacic_case  // -> 1
/// Example decide({RationalFunction(16*z - 3, 16*z*z), 0}).component  // -> Gm
[[nodiscard]] Decision decide(const NormalForm& equation, const Options& options = {});

} // namespace kov
