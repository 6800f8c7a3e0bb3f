#pragma once
// The works that files and theorems cite: docs/references.bib, which is compiled in.

#include <optional>
#include <string>

namespace kov {

/// One work, in the TeX notation of the file ("M{\"o}bius").
struct Reference {
  std::string key, authors, title;
  std::string published; ///< journal, volume, year, ...: what follows the title
};

/// Nothing if docs/references.bib has no such key.
/// Example reference("Kovacic1986")->published  // -> J. Symbolic Comput. 2 (1986), pp. 3--43
/// Example reference("Fermat1637").has_value()  // -> no
[[nodiscard]] std::optional<Reference> reference(const std::string& key);

/// TeX accents, dashes and braces as UTF-8.
/// Example without_tex("M{\\\"o}bius, H{\\'e}non, {L}am{\\'e}")  // -> Möbius, Hénon, Lamé
[[nodiscard]] std::string without_tex(const std::string& text);

} // namespace kov
