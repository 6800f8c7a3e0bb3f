#pragma once
// A TOML file as a tree of values that know their place, so that every complaint has a line, a
// column and a hint.

#include "symbol/expression.hpp"
#include "symbol/input_error.hpp"

#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kov {

/// One value of the file: the whole document is a table.
///
/// Given   const Entry file = parse_document("[system]\nkind = 'poisson'\n", "my.toml");
/// Example file.at("system").at("kind").string()  // -> poisson
/// Example file.at("system").at("kind").line()  // -> 2
/// Example file.at("system").check_keys({"kinds"})  // -> throws InputError
class Entry {
public:
  enum class Kind : std::uint8_t { string, integer, boolean, array, table, other };

  [[nodiscard]] Kind kind() const noexcept { return kind_; }
  [[nodiscard]] bool is_table() const noexcept { return kind_ == Kind::table; }
  [[nodiscard]] bool is_array() const noexcept { return kind_ == Kind::array; }
  /// Keys in the order of the file.
  [[nodiscard]] const std::vector<std::pair<std::string, Entry>>& members() const noexcept {
    return members_;
  }

  [[nodiscard]] const Entry* find(std::string_view key) const; ///< null if absent
  [[nodiscard]] const Entry& at(std::string_view key) const;   ///< InputError if absent
  /// Unknown keys are errors with the nearest known key.
  void check_keys(std::initializer_list<std::string_view> known) const;

  [[nodiscard]] const std::string& string() const;        ///< InputError for anything else
  [[nodiscard]] long integer() const;                     ///< InputError for anything else
  [[nodiscard]] bool boolean() const;                     ///< InputError for anything else
  [[nodiscard]] const std::vector<Entry>& array() const;  ///< InputError for anything else
  [[nodiscard]] std::vector<const Entry*> list() const;   ///< an array, or one value by itself
  [[nodiscard]] std::vector<std::string> strings() const; ///< a string, or an array of strings
  /// A string (or an integer) as a formula; columns of its errors count in the file.
  [[nodiscard]] Expression expression(bool allow_equation = false) const;

  /// The place of the text of a string (or an integer).
  [[nodiscard]] OriginPtr origin() const;

  [[nodiscard]] const std::string& name() const noexcept { return name_; } ///< its key, or ""
  [[nodiscard]] long line() const noexcept { return line_; }
  [[nodiscard]] const std::string& file() const noexcept { return source_->file; }
  [[nodiscard]] const std::string& file_text() const noexcept {
    return source_->text;
  } ///< all of it
  [[nodiscard]] InputError error(std::string message, std::string hint = {}) const;
  /// The same, pointing at the key instead of its value.
  [[nodiscard]] InputError key_error(std::string message, std::string hint = {}) const;

  /// This table with what another one of its kind adds: tables key by key, lists one after the other.
  /// Errors  InputError: another value for the same key
  /// Example file.merged(parse_document("system = {time = 't'}", "more")).at("system").members().size()
  ///         // -> 2
  [[nodiscard]] Entry merged(const Entry& more) const;
  /// A table of this document without its other keys.
  [[nodiscard]] Entry only(const std::vector<std::string>& keys) const;

private:
  friend class DocumentReader;
  [[nodiscard]] InputError error_at(long line, long column, std::size_t length, std::string message,
                                    std::string hint) const;
  struct Source {
    std::string file;
    std::string text;
    std::vector<std::size_t> lines; ///< where each line begins
  };
  /// A text, or a number as it stands in the file.
  [[nodiscard]] std::string written() const;

  Kind kind_ = Kind::other;
  std::string text_;
  long number_ = 0;
  bool flag_ = false;
  std::vector<std::pair<std::string, Entry>> members_;
  std::vector<Entry> items_;
  std::string name_;
  long line_ = 0;
  long column_ = 0;
  long key_line_ = 0;
  long key_column_ = 0;
  std::shared_ptr<const Source> source_;
};

/// The bytes of a file of at most limit bytes; "-" is standard input.
/// Errors  InputError: a directory, not readable, or larger
[[nodiscard]] std::string read_text(const std::string& path, std::size_t limit);
/// Reads a file; "-" is standard input.  Errors  InputError: not readable, not TOML, or over 16 MB
[[nodiscard]] Entry read_document(const std::string& path);
/// Reads a text; `name` is what messages call it.  Errors  InputError: not TOML
[[nodiscard]] Entry parse_document(std::string text, const std::string& name);
/// Does the document begin with format = "KIND/..."?
[[nodiscard]] bool has_format(const Entry& document, std::string_view kind);

} // namespace kov
