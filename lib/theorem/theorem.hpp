#pragma once
// A theorem as a tree of lemmas: what the file says, and what was found.
//
// A node is one of
//   claims          all claims of a system file hold (integrals, Casimirs, brackets, ...)
//   case            check of a system file: the verdict, for values or for all parameters
//   splitting       the separatrix criterion for a small parameter, with its exceptional families
//   lowest-order    the lowest weight-homogeneous part is another file's system
//   theorem         a theorem of the literature, with its hypotheses: taken on trust
//   cover           composition: the parameters of the other steps cover those of the statement
//   argument        a step of reasoning in words: read by people, checked by none
//   trusted         "not integrable there", or "integrable there", by a step that nothing repeats
//   open            a part of the parameters of which nothing is said
// and rests on other nodes.  docs/theory/splitting.md describes the built-in steps,
// docs/theory/composition.md how they are put together.
//
// The sentence of a step is generated from what was computed.  The words of the author are a title and a
// remark; they carry no mark of their own.

#include "literature/literature.hpp"
#include "literature/trusted.hpp"
#include "proof/text/json.hpp"
#include "splitting/checked.hpp"
#include "study/headline.hpp"
#include "symbol/document.hpp"
#include "system/system.hpp"
#include "theorem/place.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace kov {

namespace study {
class Evidence; // study/study.hpp
}
struct SplittingFinding; // moves/splitting.hpp
struct CanonicalChange;  // canonical/change.hpp

enum class NodeKind : std::uint8_t {
  claims,
  case_file,
  splitting,
  lowest_order,
  theorem,
  cover,
  argument,
  trusted,
  open_part
};
enum class NodeStatus : std::uint8_t {
  proved,   ///< here, by exact computation (and the theorems named)
  partial,  ///< the same, but it rests on something open: the statement says on which set it holds
  trusted,  ///< a theorem of the literature, or a step that the node names
  reasoned, ///< an argument in words: not checked
  unbound,  ///< computed, but about another system than that of the theorem: not checked
  open,     ///< not decided
  refuted   ///< something that was claimed is false
};
[[nodiscard]] std::string to_string(NodeKind k);
[[nodiscard]] std::string to_string(NodeStatus s);

struct Hypothesis {
  std::string text;
  std::string by;       ///< id of the node that checks it; empty: nothing does
  bool checked = false; ///< that node is proved, and says so
};

/// The values that a search has found for a step: its files are not asked again.
struct FoundStep {
  std::vector<std::shared_ptr<const study::Evidence>> studies{}; ///< that exclude, along one curve
  /// Curves whose exponent differences decide, as no polynomial does.
  std::vector<std::shared_ptr<const study::Evidence>> special{};
  std::shared_ptr<const SplittingFinding> splitting{};
  /// The weights of momenta and of Gamma: those curves are of the system of lowest order.
  std::optional<std::pair<long, long>> lowest{};
  std::shared_ptr<const CanonicalChange> change{}; ///< to another system, that of the studies
  bool carried = false;              ///< from other parameters, by symmetries of the system
  std::vector<ManifoldSpec> along{}; ///< these, if no file names them
  std::vector<std::pair<std::string, MFraction>> integrals{};
  std::vector<std::vector<MFraction>> fields{}; ///< that commute, a function for each coordinate
};

struct TheoremNode {
  std::string id, title;
  std::string statement, note; ///< the author's words: an argument, or a remark
  /// kind theorem: one of literature(), or null
  const LiteratureTheorem* theorem = nullptr;
  Place place; ///< where among the theorem's systems; cover: what is covered
  NodeKind kind = NodeKind::argument;
  std::vector<std::string> needs;
  std::vector<std::string> cite;
  std::vector<Hypothesis> hypotheses;
  std::string file, other; ///< paths as written
  ParameterValues where;
  ParameterValues sample; ///< case: also decided at these values, with tables and a certificate
  std::string manifold;
  /// case: the verdict that counts as proved; "any": every decided one
  std::string expect = "non-integrable";
  int order = 1; ///< case: of the variational equations, where the first leaves something open
  std::vector<std::string> small;    ///< splitting: the parameters of size eps
  std::vector<std::string> families; ///< splitting: the exceptional families that may remain
  bool triangle = true;              ///< splitting: only bodies with A <= B + C
  /// Tables of a system file, for this node: [[node.manifold]], [[node.integral]]; `values`
  /// names the values of integrals in them.
  std::optional<Entry> tables{};
  std::vector<std::string> values{};
  ParameterValues algebraic{}; ///< constants of the theorem: name, polynomial that vanishes
  /// claims: the integrals of `tables` commute, are independent and as many as are needed.
  bool integrable = false;
  /// claims without a bracket: vector fields that commute, a formula for each coordinate.
  std::vector<std::vector<std::string>> fields{};
  /// trusted, open: instead of one place, any of these; lists of conditions.
  std::vector<std::vector<std::string>> regions{};
  /// The trusted sentence: kind trusted; or, where the check of a case or of claims ends in another way.
  std::string step{};
  IntegralClass integrals{}; ///< of a trusted step that excludes
  /// trusted: by Darboux points, of which there is a rule: "relation" or "multiple"; of which part of the
  /// potential: "all", "highest", "lowest".
  std::string darboux{}, part{};
  FoundStep found{};
  long line = 0;
};

/// y = S x, q = q(p) that maps the system to itself.
struct Symmetry {
  std::string title;
  ParameterValues as;
};

struct Theorem {
  std::string file, title;
  std::string sha256{};  ///< of the file, in hexadecimal
  std::string statement; ///< the author's words
  std::string system;    ///< the file of the system that the theorem is about; empty: none is named
  std::vector<Symmetry> symmetries;
  ParameterValues algebraic{}; ///< [algebraic]: constants that the system file does not have
  bool expected_open = false;  ///< for tests: the proof is not complete, and that is known
  std::vector<std::string> cite;
  std::vector<TheoremNode> nodes; ///< the root first
};

/// Errors  InputError: an unknown key, id or kind, a circle of needs
[[nodiscard]] Theorem read_theorem(const Entry& document);

/// Material for a report.
struct Formula {
  std::string label, text;
};
struct Grid {
  std::string caption;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows; ///< formulas
};
/// Points of the complex plane; for the eye only.
struct PolePicture {
  struct Point {
    Rational x, y;
    std::string label;
    bool special = false;
  };
  std::string caption, horizontal, vertical;
  std::vector<Point> points;
  bool strip = false; ///< draw the strip between y = 0 and y = 2
};

/// The conclusion of a step about the parameters of its region.
enum class Conclusion : std::uint8_t { none, not_integrable, has_integral };

/// Proof of a cover.
struct TreeOfSteps {
  std::vector<std::string> parts; ///< steps
  certify::Json tree; ///< its leaves are images of their regions (theorem_certificates.md 8)
};

struct NodeResult {
  TheoremNode node;
  std::string statement; ///< what was computed, in words; empty for an argument
  Conclusion says = Conclusion::none;
  std::vector<Assumptions> regions; ///< instead of one region: any of these
  bool on_trust = false;            ///< by the step that the node names, and by nothing else
  bool is_word =
      false; ///< a case or claims whose own check did not find it, whatever carries it now
  std::string integrals;               ///< says has_integral: which
  std::vector<IntegralClass> excluded; ///< says not_integrable: classes of first integrals
  std::string curve;                   ///< and on the leaf of which phase curve: "N in lemma3.toml"
  /// The needs of the step about the parameters of its file besides what the file assumes: "A - B > 0".
  std::vector<std::string> domain;
  Assumptions region;          ///< of the theorem's parameters, if the step is about its system
  std::optional<PlaceMap> map; ///< if its system had to be compared
  std::vector<PlaceMap> symmetries; ///< cover
  std::optional<TreeOfSteps> cover; ///< proved, and not about strata
  NodeStatus status = NodeStatus::open;
  bool rests_on_open = false;           ///< something below it is open or refuted
  std::size_t steps_on_trust = 0;       ///< its own and those of all below it
  std::string summary;                  ///< one sentence: what was found
  std::string caution;                  ///< a part of it that no short form leaves out
  std::string headline;                 ///< case: the verdict in a few words
  std::optional<study::Headline> found; ///< case: the same as a value
  CheckedIdentities checks;             ///< each identity that was verified
  std::vector<Formula> formulas;
  std::vector<Grid> tables;
  std::vector<PolePicture> pictures;
  std::vector<TheoremUsed> theorems;     ///< of the literature
  std::vector<Trusted> trusted;          ///< other steps on faith
  std::vector<std::string> certificates; ///< JSON, accepted by the judge
  double seconds = 0;
};

/// "in part", "proved, with 2 steps on trust": what the node rests on included.
[[nodiscard]] std::string status_of(const NodeResult& n);

/// A file that a proof was read from.
struct InputFile {
  std::string name;             ///< as the theorem's file writes it
  std::string sha256;           ///< of its bytes, in hexadecimal
  std::string titled;           ///< of a system: as sentences name it
  std::string assumed;          ///< of a system: a sentence, or nothing
  std::vector<Formula> setting; ///< of a system: variables, bracket, equations; else empty
};

/// Each theorem once, with a hypothesis open where one of its uses leaves it open.
[[nodiscard]] std::vector<TheoremUsed> each_once(const std::vector<TheoremUsed>& uses);

struct TheoremResult {
  Theorem theorem;
  std::vector<NodeResult> nodes; ///< in the order of the file
  double seconds = 0;
  std::vector<InputFile> files{}; ///< what it was read from (setting.hpp)
  std::string program{};   ///< the versions of the program and its libraries, where it is known
  std::string bundle{};    ///< all of it as one certificate, accepted by the judge; or empty
  std::string no_bundle{}; ///< why there is none
  /// The number of regions of which the bundle of a theorem about strata says nothing.  Its steps on trust
  /// are those of the nodes.
  std::size_t bundle_open = 0;
  bool found = false; ///< by `classify` in this run; in a file a step on trust is somebody's words

  [[nodiscard]] std::size_t count(NodeStatus s) const;
  [[nodiscard]] std::vector<TheoremUsed> uses() const; ///< each once
  /// The statement of the first step, if it is proved; empty while it is not.
  [[nodiscard]] std::string statement() const;
  [[nodiscard]] std::vector<std::string> trusted_steps() const; ///< e.g. decisions of Z3
  /// How many of them the file names, and nothing else.
  [[nodiscard]] std::size_t words_of_the_file() const;
  [[nodiscard]] std::vector<std::string> unchecked_hypotheses() const;
  [[nodiscard]] std::size_t certificates() const;
  [[nodiscard]] std::size_t identities() const;
  /// The first step is proved, each other one too or a theorem of the literature: nothing open,
  /// refuted, unbound or in words.
  [[nodiscard]] bool complete() const;
  /// The same, but for steps that the file takes on trust.
  [[nodiscard]] bool complete_but_for_words() const;
  /// The same, but for parts of the parameters that are said to be open.
  [[nodiscard]] bool complete_but_for_open_parts() const;
  [[nodiscard]] std::string time() const;  ///< "1.2 s"
  [[nodiscard]] std::string given() const; ///< "4 theorems of the literature and 6 other steps ..."
  [[nodiscard]] std::string computed() const; ///< "16 steps computed here, 4 of them with ..."
  /// "PROVED", "NOT PROVED: 2 steps are open", "PROVED, except 1 step that the file takes on trust", ...
  [[nodiscard]] std::string verdict() const;
  /// "PROVED, given 4 theorems of the literature and 6 arguments in words; 16 steps proved here"
  [[nodiscard]] std::string conclusion() const;
};

} // namespace kov
