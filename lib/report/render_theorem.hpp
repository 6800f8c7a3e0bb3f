#pragma once
// A proved theorem as text, JSON, LaTeX and one self-contained HTML page.

#include "literature/literature.hpp"
#include "literature/references.hpp"
#include "report/formula.hpp"
#include "theorem/theorem.hpp"

#include <cstdint>

namespace kov::report {

/// "checked by ...: ", "part of the statement: " or "NOT CHECKED: ".
[[nodiscard]] std::string settled(const TheoremHypothesis& h);
/// The finding of the step, unless its statement says it.
[[nodiscard]] std::string finding(const NodeResult& n);
/// The file of the system that the statement is about, and the works cited, in the order of the
/// alphabet.
[[nodiscard]] const InputFile* main_system(const TheoremResult& t);
/// "The system"; of several: "The system of lemma.toml".
[[nodiscard]] std::string name_of_system(const TheoremResult& t, const InputFile& f, Markup m);
[[nodiscard]] std::vector<Reference> references(const TheoremResult& t);
/// Which commands check the result again, and the sentence before them.
[[nodiscard]] std::vector<std::string> commands_to_check(const TheoremResult& t);
[[nodiscard]] std::string how_to_check(const TheoremResult& t);
/// The files that a reader has, without formulas of the command line.
[[nodiscard]] std::vector<InputFile> files_of(const TheoremResult& t);
/// The first step, and each other one on which none rests.
[[nodiscard]] std::vector<const NodeResult*> roots(const TheoremResult& t);
/// The label before the words of the author.
[[nodiscard]] std::string remark(const NodeResult& n);

enum class TheoremDetail : std::uint8_t {
  tree,  ///< what is proved, given what, and one line per step: a screen
  whole, ///< also each step with what was checked, and the theorems with their hypotheses
};
[[nodiscard]] std::string theorem_text(const TheoremResult& t,
                                       TheoremDetail detail = TheoremDetail::whole);
/// kovacic-proof/1: what prove found, to be read by programs; a certificate is kovacic-theorem/1.
[[nodiscard]] std::string theorem_json(const TheoremResult& t);
/// An article; compiles with texlive-latex-base.
[[nodiscard]] std::string theorem_tex(const TheoremResult& t);
/// One file, without scripts and network: MathML, inline SVG, collapsible steps.
[[nodiscard]] std::string theorem_html(const TheoremResult& t);
/// A page with this body, in the style of theorem_html.
[[nodiscard]] std::string html_page(const std::string& title, const std::string& body);

/// Points of a picture in a box of the given size, with the scale found; for SVG and LaTeX.
struct PlacedPoint {
  long x = 0, y = 0; ///< in thousandths of the unit of the box, from its lower left corner
  std::string label;
  bool special = false;
  long label_x = 0, label_y = 0; ///< where the label begins, on its baseline
};
/// The box, and the size of a letter, in thousandths.
struct PictureSize {
  long width = 0, height = 0, letter_width = 0, letter_height = 0;
};
struct PlacedPicture {
  long width = 0, height = 0;                ///< in thousandths
  std::optional<long> axis_x, axis_y;        ///< where the imaginary and the real axis run
  std::optional<std::pair<long, long>> band; ///< the strip, lower and upper edge
  std::vector<PlacedPoint> points;
};
/// Labels stand beside their points, where they cover no other point or label if there is room.
[[nodiscard]] PlacedPicture place(const PolePicture& p, const PictureSize& size);

} // namespace kov::report
