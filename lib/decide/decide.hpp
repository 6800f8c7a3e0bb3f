#pragma once
// y'' = r y  ->  Galois group, identity component, "is it abelian?", solutions, and why: values, to
// be asked by pattern matching; words.hpp makes sentences of them.

#include "closed/recognize.hpp"
#include "exact/budget.hpp"
#include "exact/truth.hpp"
#include "galois/solutions.hpp"
#include "kovacic/trace.hpp"
#include "linode/normal_form.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace kov {

enum class Method : std::uint8_t { automatic, kovacic, engines, all };

struct Decision;
struct Judged; // decide/certificate.hpp

struct Options {
  Budget budget;
  Method method = Method::automatic;
  std::optional<int> only_case; ///< look at one of Kovacic's cases only (the answer may be partial)
  std::string variable = "z";   ///< only for printing
  bool want_solutions = true;
  /// Strata are divided until the group is known also where that the identity component is not abelian is
  /// enough for a verdict.
  bool want_group = false;
  bool want_trace = false;
  bool want_certificate = false; ///< written, and accepted by the judge of lib/certify
  /// The certificate is written and judged and not kept; a verdict that is refused is withdrawn.
  bool ask_the_judge = false;
  /// Told as soon as something is proved, and again when the certificate is there: before steps
  /// and solutions are made, which can take longer than the proof.
  std::function<void(const Decision&)> proved;
};

// ---- why: the argument that an answer rests on

/// The engines of lib/galois: `proof->argument` with its evidence, or `proof->undecided`.
struct ByEngines {
  std::shared_ptr<const Classification> proof;
};
/// Kovacic's algorithm excludes its cases 1, 2 and 3: SL(2, C).
struct ByKovacic {};
/// The closed answer of a classical equation.
struct ByFormula {
  Recognized known;              ///< known.answer is set
  std::optional<Unable> engines; ///< what had stopped them
};
using Because = std::variant<std::monostate, ByEngines, ByKovacic, ByFormula>;

// ---- what became of an answer

struct MethodsDisagree { ///< Kovacic's cases that they find
  int engines = 0, kovacic = 0;
};
struct CertificateRefused {
  std::optional<GaloisGroup> found; ///< what had been found
  std::string by_checker;           ///< shown to the user; no code reads it
};
/// Why an answer was taken back.
using Withdrawn = std::variant<MethodsDisagree, CertificateRefused>;

/// The checker's opinion of an answer for which no certificate is kept.
struct ThirdOpinion {
  bool accepted = false;
  std::string no_certificate; ///< otherwise; shown to the user; no code reads it
};

struct SolutionsMissing {
  enum class Why : std::uint8_t { not_asked_for, limit };
  Why why = Why::not_asked_for;
  std::string limit{}; ///< shown to the user; no code reads it
};

struct Decision {
  RationalFunction r;
  std::string variable = "z";
  std::optional<Singularities> places; ///< of r, if they were looked at
  std::optional<GaloisGroup> group;    ///< unset: not determined
  std::optional<Connected> component;  ///< may be known where the group is not
  Truth abelian = Truth::unknown;      ///< of the identity component
  std::optional<int> kovacic_case;
  Because because;
  std::optional<int> second_opinion;         ///< Kovacic's case, by his algorithm as well
  std::optional<ThirdOpinion> third_opinion; ///< Method::all
  std::optional<Withdrawn> withdrawn;        ///< then nothing else is stated
  std::vector<LiouvillianSolution> solutions;
  std::optional<SolutionsMissing> no_solutions;
  std::optional<int> only_case;    ///< that was asked for
  std::optional<Unable> undecided; ///< set when anything asked stayed open
  kovacic::Trace trace;
  bool checked = false;       ///< our own checker accepted a certificate, kept or not
  std::string certificate;    ///< JSON text; empty if not asked for, or
  std::string no_certificate; ///< why there is none: shown to the user; no code reads it
  std::string refused; ///< the certificate that our own checker refused; with it goes the verdict
  double seconds = 0;

  // In decision.cpp, and not in each file that copies one: they are long.
  Decision();
  Decision(const Decision&);
  Decision(Decision&&) noexcept;
  Decision& operator=(const Decision&);
  Decision& operator=(Decision&&) noexcept;
  ~Decision();

  /// The engines' proof, where the answer is theirs; else null.
  [[nodiscard]] const Classification* proof() const {
    const auto* engines = std::get_if<ByEngines>(&because);
    return engines == nullptr ? nullptr : engines->proof.get();
  }
};

/// The result of Kovacic's algorithm: its case, or the limit that stopped it.
struct SecondOpinion {
  std::optional<int> kovacic_case;
  std::string limit;
};
/// Two methods, one answer: agreement is kept, and a limit of the second one beside the answer
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
