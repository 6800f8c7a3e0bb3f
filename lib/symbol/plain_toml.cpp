#include "symbol/plain_toml.hpp"

namespace kov {
namespace {

bool beyond_ascii(char c) { return static_cast<unsigned char>(c) >= 0x80; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

class Scanner {
public:
  explicit Scanner(std::string_view text) : text_(text) {
    if (text_.starts_with("\xEF\xBB\xBF")) i_ = 3; // a byte order mark
  }

  std::optional<std::size_t> run() {
    while (i_ < text_.size()) {
      const char c = text_[i_];
      if (beyond_ascii(c)) return i_;
      if (c == '#')
        skip_comment();
      else if (c == '"' || c == '\'')
        skip_string(c);
      else
        ++i_;
      if (stray_) return stray_;
    }
    return std::nullopt;
  }

private:
  void skip_comment() {
    while (i_ < text_.size() && text_[i_] != '\n')
      ++i_;
  }

  void skip_string(char quote) {
    const std::string_view fence = quote == '"' ? "\"\"\"" : "'''";
    const bool many_lines = text_.substr(i_, 3) == fence;
    i_ += many_lines ? 3 : 1;
    while (i_ < text_.size()) {
      if (quote == '"' && text_[i_] == '\\') {
        skip_escape(many_lines);
        if (stray_) return;
      } else if (many_lines ? text_.substr(i_, 3) == fence : text_[i_] == quote) {
        i_ += many_lines ? 3 : 1;
        return;
      } else if (!many_lines && text_[i_] == '\n') {
        return; // an unfinished string: toml++ says so
      } else {
        ++i_;
      }
    }
  }

  void skip_escape(bool many_lines) {
    ++i_;
    if (!many_lines || i_ >= text_.size() || !is_space(text_[i_])) {
      ++i_;
      return;
    }
    while (i_ < text_.size() && is_space(text_[i_]))
      ++i_;
    if (i_ < text_.size() && beyond_ascii(text_[i_])) stray_ = i_;
  }

  std::string_view text_;
  std::size_t i_ = 0;
  std::optional<std::size_t> stray_;
};

} // namespace

std::optional<std::size_t> stray_character(std::string_view toml) { return Scanner(toml).run(); }

} // namespace kov
