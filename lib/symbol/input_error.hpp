#pragma once
// The faults of a text that somebody wrote: where, what, and what to write instead.

#include "exact/error.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace kov {

/// The source of an expression, so that an offset in it becomes a line and a column of the file.
struct Origin {
  std::string file;       ///< "cases/hh.toml", "-r", "family.jsonl"
  std::string text;       ///< the whole text in which lines are counted
  std::size_t offset = 0; ///< where the expression begins in `text`
  long first_line = 1;    ///< the number of the first line of `text`
  std::string what;       ///< the name of the thing: "r", "hamiltonian"; may be empty
};
using OriginPtr = std::shared_ptr<const Origin>;

/// The origin of a text given by itself, e.g. on the command line.
[[nodiscard]] OriginPtr origin_of_text(std::string file, std::string text, std::string what = {});

/// The same from `offset` on.
[[nodiscard]] OriginPtr origin_from(const OriginPtr& origin, std::size_t offset);

/// Bytes [offset, offset + length) of an expression.
struct Span {
  std::uint32_t offset = 0;
  std::uint32_t length = 0;
};

/// A mistake in an input.  what() is "file:line:column: error: message".
/// Example throw InputError("my.toml", 3, 7, 2, "unknown name 'q3'")
///         // -> throws InputError: my.toml:3:7: error: unknown name 'q3'
class InputError : public Error {
public:
  /// An error at bytes of an expression.
  InputError(const Origin& origin, Span where, std::string message, std::string hint = {});
  /// An error somewhere in a file (line and column from 1, 0 = unknown); source_line may be empty.
  InputError(std::string file, long line, long column, long length, std::string message,
             std::string hint = {}, std::string source_line = {});

  [[nodiscard]] const std::string& file() const noexcept { return file_; }
  [[nodiscard]] long line() const noexcept { return line_; }     ///< from 1; 0 = unknown
  [[nodiscard]] long column() const noexcept { return column_; } ///< in characters, from 1
  [[nodiscard]] long length() const noexcept { return length_; } ///< in characters, at least 1
  [[nodiscard]] const std::string& message() const noexcept { return message_; }
  [[nodiscard]] const std::string& hint() const noexcept { return hint_; }
  [[nodiscard]] const std::string& source_line() const noexcept { return source_line_; }

private:
  struct Place {
    long line, column, length;
    std::string source_line;
  };
  InputError(std::string file, Place place, std::string message, std::string hint);
  static Place locate(const Origin& origin, Span where);

  std::string file_;
  long line_;
  long column_;
  long length_;
  std::string message_;
  std::string hint_;
  std::string source_line_;
};

/// The error as a person reads it, with the line, a caret, and the hint; ends in a newline.
///
///     cases/hh.toml:10:63: error: unknown name 'q3' in hamiltonian
///        10 | hamiltonian = "(p1^2 + p2^2)/2 + q1^2*q3"
///           |                                       ^~
///        note: coordinates are q1, q2; did you mean q2?
///
/// Long lines are cut around the caret; bytes that a terminal cannot show are replaced.
[[nodiscard]] std::string render(const InputError& error, bool color = false);

/// Bytes made fit for a terminal: control characters and broken UTF-8 become '?', tabs one space.
/// Example printable("a\tb\x07")  // -> a b?
[[nodiscard]] std::string printable(std::string_view bytes);

} // namespace kov
