#pragma once
// Theorems of the literature that are used and not proved here.
//
// A theorem is a value: its statement and its hypotheses belong to it, and no file can reword or
// remove one.  A use of it says of each hypothesis whether it was checked (by what), is part of
// what is stated, or is not checked, and which class of first integrals it excludes.

#include "literature/integral_class.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace kov {

enum class Settled : std::uint8_t {
  checked, ///< by the step that uses the theorem
  stated,  ///< part of the statement: the kind of first integrals that is excluded
  open     ///< not checked
};

struct TheoremHypothesis {
  std::string text;
  Settled settled = Settled::open;
  std::string how; ///< what checks it, or where it is said
};

struct LiteratureTheorem {
  std::string id;   ///< as files name it: "Morales-Ramis"
  std::string name; ///< "Morales-Ruiz and Ramis (2001)"
  std::string statement;
  std::string cite;        ///< key in docs/references.bib
  IntegralClass integrals; ///< the class of first integrals that it excludes
  std::vector<TheoremHypothesis> hypotheses;
  /// A theorem about one system: that system as a system file, with what it assumes.
  std::string system = {};
  std::string article = "the theorem of ";
  [[nodiscard]] std::string in_words() const { return article + name; }
};

[[nodiscard]] const std::vector<LiteratureTheorem>& literature();
/// Nothing if there is no theorem of this id.
/// Example literature_theorem("Ayoul-Zung")->cite  // -> AyoulZung2010
/// Example literature_theorem("Fermat") == nullptr  // -> yes
[[nodiscard]] const LiteratureTheorem* literature_theorem(const std::string& id);

[[nodiscard]] const LiteratureTheorem& morales_ramis();      ///< Hamiltonian systems
[[nodiscard]] const LiteratureTheorem& ayoul_zung();         ///< all vector fields
[[nodiscard]] const LiteratureTheorem& morales_ramis_simo(); ///< higher orders
[[nodiscard]] const LiteratureTheorem& ziglin_1980();        ///< splitting of separatrices
[[nodiscard]] const LiteratureTheorem& ziglin_1982();        ///< lowest-order parts
/// Homoclinic points.  Not one of literature(): no file can name it, a proof in numbers uses it.
[[nodiscard]] const LiteratureTheorem& smale_moser();
/// Rational integrals and the parts of highest or of lowest weight; not of literature() either.
[[nodiscard]] const LiteratureTheorem& ziglin_highest();
[[nodiscard]] const LiteratureTheorem& ziglin_lowest();

/// One use of a theorem.
struct TheoremUsed {
  const LiteratureTheorem* theorem = nullptr; ///< one of literature(), never null in a result
  std::vector<TheoremHypothesis> hypotheses;  ///< as this use settles them
  IntegralClass integrals;                    ///< the class of first integrals that it excludes

  [[nodiscard]] const std::string& id() const { return theorem->id; }
};
/// A use of the theorem, with the hypotheses as it says that its uses settle them.
/// Example sentence(used(morales_ramis()).integrals)  // -> meromorphic
[[nodiscard]] TheoremUsed used(const LiteratureTheorem& theorem);

} // namespace kov
