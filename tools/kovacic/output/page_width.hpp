#pragma once
// How wide a line may be.

#include <cstddef>
#include <cstdint>
#include <string>

namespace kov::cli {

/// The columns of a terminal; `otherwise` where the descriptor is none.
[[nodiscard]] std::size_t columns_of(int descriptor, std::size_t otherwise);

/// What a colour means: there are solutions or integrals; it is proved that there are none; it depends,
/// or nothing is proved.
enum class Meaning : std::uint8_t { positive, negative, open };
/// A headline in the colour of its meaning, where answers have colours.
[[nodiscard]] std::string painted(const std::string& text, Meaning meaning);
/// Set once, before workers start.
void set_colours(bool on);

/// Of running text: 98 columns, fewer on a terminal that is narrower.
[[nodiscard]] std::size_t page_width();
/// Set once, before workers start: is the answer shown on standard output?
void set_page_width(bool on_standard_output);

/// Lines that are too long for the page go on below, indented like their text; what has no blanks is cut
/// nowhere.
[[nodiscard]] std::string folded(const std::string& text, std::size_t width);
/// At most 40 lines: titles, headlines and what answers the question first; what does not fit is counted in the last
/// line.
[[nodiscard]] std::string one_page(const std::string& text);
/// Folded where standard output is a terminal, else as it is.
[[nodiscard]] std::string for_standard_output(const std::string& text);

} // namespace kov::cli
