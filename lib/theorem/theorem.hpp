#pragma once
// A theorem as a tree of lemmas: what the file says, and what was found.
//
// A node is one of
//   claims          all claims of a system file hold (integrals, Casimirs, brackets, ...)
//   case            check of a system file: the verdict, for values or for all parameters
//   splitting       the separatrix criterion for a small parameter, with its exceptional families
//   scaling         an exact identity between fields: from small parameters to all
//   lowest-order    the lowest weight-homogeneous part is another file's system
//   theorem         a theorem of the literature, with its hypotheses: taken on trust
//   argument        a step of reasoning in words: read by people, checked by none
// and rests on other nodes.  docs/theory/splitting.md describes the built-in steps.

#include "splitting/checked.hpp"
#include "symbol/document.hpp"
#include "system/system.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace kov {

enum class NodeKind : std::uint8_t {
  claims,
  case_file,
  splitting,
  scaling,
  lowest_order,
  theorem,
  argument
};
enum class NodeStatus : std::uint8_t {
  proved,   ///< here, by exact computation (and the theorems named)
  trusted,  ///< a theorem of the literature
  reasoned, ///< an argument in words
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

/// A family that the separatrix criterion leaves, and the case node that is to prove it.
struct LeftFamily {
  std::string family, by;
  ParameterValues units; ///< parameters that are 1 in the file of the case
};

/// One that occurs, with its equations as values of parameters (in every way that they can be
/// solved).
struct AdmittedFamily {
  LeftFamily left;
  std::vector<ParameterValues> members;
};

struct TheoremNode {
  std::string id, title, statement, note;
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
  std::vector<std::string> small;   ///< splitting, scaling: the parameters of size eps
  std::vector<LeftFamily> families; ///< splitting: the exceptional families that may remain
  bool triangle = true;             ///< splitting: only bodies with A <= B + C
  std::vector<std::string> scaled;  ///< scaling: the variables that take over eps
  long line = 0;
};

struct Theorem {
  std::string file, title, statement;
  std::vector<std::string> cite;
  std::vector<TheoremNode> nodes; ///< the root first
};

/// Errors  InputError: an unknown key, id or kind, a circle of needs
[[nodiscard]] Theorem read_theorem(const Entry& document);
[[nodiscard]] bool is_theorem_document(const Entry& document);

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

struct NodeResult {
  TheoremNode node;
  NodeStatus status = NodeStatus::open;
  bool rests_on_open = false;           ///< something below it is open or refuted
  std::vector<AdmittedFamily> admitted; ///< splitting: families that are left to other nodes
  std::string summary;                  ///< one sentence: what was found
  CheckedIdentities checks;             ///< each identity that was verified
  std::vector<Formula> formulas;
  std::vector<Grid> tables;
  std::vector<PolePicture> pictures;
  std::vector<std::string> theorems;     ///< of the literature, used and not among the needs
  std::vector<std::string> trusted;      ///< other steps on faith
  std::vector<std::string> certificates; ///< JSON, accepted by the judge
  double seconds = 0;
};

struct TheoremResult {
  Theorem theorem;
  std::vector<NodeResult> nodes; ///< in the order of the file
  double seconds = 0;

  [[nodiscard]] std::size_t count(NodeStatus s) const;
  [[nodiscard]] std::vector<std::string> trusted_theorems() const; ///< each once
  [[nodiscard]] std::vector<std::string> trusted_steps() const;    ///< e.g. decisions of Z3
  [[nodiscard]] std::vector<std::string> unchecked_hypotheses() const;
  [[nodiscard]] std::size_t certificates() const;
  [[nodiscard]] std::size_t identities() const;
  /// Nothing open or refuted.
  [[nodiscard]] bool complete() const;
  [[nodiscard]] std::string time() const;    ///< "1.2 s"
  [[nodiscard]] std::string given() const;   ///< "4 theorems of the literature and 6 arguments ..."
  [[nodiscard]] std::string verdict() const; ///< "PROVED", "NOT YET PROVED: 2 steps are open", ...
  /// "PROVED, given 4 theorems of the literature and 6 arguments in words; 16 steps proved here"
  [[nodiscard]] std::string conclusion() const;
};

} // namespace kov
