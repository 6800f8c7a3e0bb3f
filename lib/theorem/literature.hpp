#pragma once
// Theorems of the literature that are used and not proved here.
//
// A theorem is a value: its statement and its hypotheses belong to it, and a theorem file can
// neither reword nor remove one.  Each use says of each hypothesis whether it was checked (by
// what), is part of what is stated, or is not checked.

#include <optional>
#include <string>
#include <vector>

namespace kov {

enum class Settled : std::uint8_t {
  checked, ///< by the step that uses the theorem
  stated,  ///< part of the statement: the kind of first integrals that is excluded
  open     ///< not checked
};

struct LiteratureHypothesis {
  std::string text;
  Settled settled = Settled::open;
  std::string how; ///< what checks it, or where it is said
};

struct LiteratureTheorem {
  std::string id;   ///< "Morales-Ramis"
  std::string name; ///< "the theorem of Morales-Ruiz and Ramis (2001)"
  std::string statement;
  std::string cite; ///< key in docs/references.bib
  std::vector<LiteratureHypothesis> hypotheses;
  /// A theorem about one system: that system as a system file, with what it assumes.
  std::string system = {};
};

[[nodiscard]] const std::vector<LiteratureTheorem>& literature();
/// Nothing if there is no theorem of this id.
[[nodiscard]] const LiteratureTheorem* literature_theorem(const std::string& id);
/// Whether a theorem of that name stands in literature().
[[nodiscard]] bool is_in_literature(const std::string& name);

} // namespace kov
