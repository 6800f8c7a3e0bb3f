#pragma once
// The study of a system file: claims, then one answer for each manifold whatever orders are asked, then
// what they say together.  `check`, `test`, `prove`, `report`, Python and the tests call this and
// nothing else.
//
// Assumed equations are values where they can be (system/assumed_values.hpp); eigenvalues over which
// variations fall apart are adjoined (integrability/eigenvalue.hpp).

#include "integrability/certificate.hpp"
#include "study/higher_orders.hpp"
#include "study/proof_tree.hpp"

#include <map>

namespace kov::study {

struct StudyOptions {
  CheckOptions check = {};
  int order = 1; ///< of the variational equations, where the first leaves something open
  std::optional<ManifoldSpec> along = {}; ///< instead of those of the file
};

/// One manifold.
struct CurveStudy {
  ManifoldReport first; ///< of the first variational equation
  std::optional<HigherOrders> higher;
  std::vector<Exclusion> exclusions;            ///< of all orders
  std::optional<SystemClassification> together; ///< where several of them leave nothing
  Headline headline;
  std::vector<std::string> failed; ///< parts that a limit or an error of the program ended, and why

  [[nodiscard]] const std::string& name() const { return first.name; }
};

/// A curve as it was studied: what its exclusions are made from, kept so that it can be written down when a
/// statement asks for it.
class Evidence {
public:
  Evidence(System s, CurveStudy m) : system_(std::move(s)), curve_(std::move(m)) {}

  [[nodiscard]] const System& system() const { return system_; }
  [[nodiscard]] const CurveStudy& curve() const { return curve_; }
  /// Cost  that of writing and judging them, the first time
  [[nodiscard]] const std::vector<NamedCertificate>& certificates() const;

private:
  System system_;
  CurveStudy curve_;
  mutable std::optional<std::vector<NamedCertificate>> written_;
};

/// The manifolds that the options ask for.
/// Errors  InvalidArgument if the one named is not there
[[nodiscard]] std::vector<const ManifoldSpec*> manifolds_to_check(const System& s,
                                                                  const CheckOptions& options);

/// A system file at one set of values, asked piece by piece, each under limits of its own; what was
/// answered is kept.
class FileStudy {
public:
  /// Errors  InputError; InvalidArgument: no values satisfy what the file assumes
  FileStudy(const Entry& document, ParameterValues set,
            const std::optional<ManifoldSpec>& along = {});
  /// A system that was read, as it is: no eigenvalues are adjoined.
  explicit FileStudy(System s);

  /// The system as the file has it, without the eigenvalues.
  [[nodiscard]] const System& system() const { return system_; }
  /// The system with the eigenvalues.
  [[nodiscard]] const System& studied(const CheckOptions& options);
  [[nodiscard]] const std::vector<ClaimReport>& claims(const CheckOptions& options);
  /// The k-th of manifolds_to_check(system(), options.check).  with_claims: proved ones are used.
  [[nodiscard]] const CurveStudy& manifold(std::size_t k, const StudyOptions& options,
                                           bool with_claims = true);
  /// The sets that these manifolds exclude together.   Errors  InvalidArgument
  [[nodiscard]] SystemClassification together(const std::vector<std::size_t>& of,
                                              const StudyOptions& options, bool with_claims = true);

  /// The steps that are proved so far.
  [[nodiscard]] const ProofTree& tree() const { return tree_; }
  /// A limit or an error of the program ended this curve, or (no name) what they say together.
  void missing(const std::string& curve);

private:
  [[nodiscard]] bool is_fine_without_values(const std::string& manifold, const Budget&) const;

  std::optional<Entry> document_;
  ParameterValues set_;
  System system_;
  std::optional<System> studied_;
  std::optional<std::vector<ClaimReport>> claims_;
  std::map<std::string, CurveStudy> manifolds_; ///< by their names
  ProofTree tree_;
};

struct SystemStudy {
  System system; ///< with eigenvalues
  std::vector<ClaimReport> claims;
  std::vector<CurveStudy> manifolds;
  std::optional<SystemClassification> together; ///< of several manifolds
  ProofTree tree;
  Headline headline; ///< of the tree
  double seconds = 0;
};

/// The whole: each manifold has an equal share of the time that is left, and a limit costs that
/// manifold only.  An error of the program in one of them is thrown where the others prove nothing.
/// Errors  InputError; InvalidArgument: no values satisfy what the file assumes, no such manifold
/// Given   const Entry file = parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['q1', 'q2'], momenta = ['p1', 'p2'], parameters = ['h'], "
///             "hamiltonian = '(p1^2 + p2^2)/2 + q1^2*q2 + q2^3/2'}\n"
///             "manifold = [{name = 'N', equations = ['q1 = 0', 'p1 = 0'], level = ['H = h']}]",
///             "cubic.toml");
/// Example to_string(study(file, {{"h", "1"}}).headline.verdict)  // -> non-integrable
[[nodiscard]] SystemStudy study(const Entry& document, const ParameterValues& set,
                                const StudyOptions& options = {});

/// The values that the expectations of a file are about, each once; given ones take their place.
[[nodiscard]] std::vector<ParameterValues> rounds(const System& file, const ParameterValues& given);

/// The certificates of all orders, if they were asked for: for each either a text or why there is none.
[[nodiscard]] std::vector<NamedCertificate> certificates(const System& s, const CurveStudy& m);

} // namespace kov::study
