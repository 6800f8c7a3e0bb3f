#pragma once
// Words of the author of a file, where the program prints them.

#include <string>

namespace kov {

/// On one line: blanks, line breaks and control characters, also those of Unicode that break a line
/// or turn its direction, become single blanks; none at the ends.
/// Example one_line("a title\n\n  [proved]")  // -> a title [proved]
[[nodiscard]] std::string one_line(const std::string& words);

/// Letters, digits and _, no digit first: what a formula can name.
/// Example is_identifier("F1")  // -> yes
/// Example is_identifier("x is an integral")  // -> no
[[nodiscard]] bool is_identifier(const std::string& name);

/// A name inside a sentence of the program: in quotation marks unless it is an identifier.
/// Example name_in_words("N")  // -> N
/// Example name_in_words("two words")  // -> "two words"
[[nodiscard]] std::string name_in_words(const std::string& name);

} // namespace kov
