#include "proof/text/json.hpp"

#include "exact/error.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>
#include <cstdint>
#include <unordered_set>

namespace kov::certify {

namespace {

class Parser {
public:
  Parser(std::string_view s, int depth) : s_(s), max_depth_(depth) {}

  Json document() {
    Json j = value(0);
    space();
    if (at_ != s_.size()) fail("text after the end");
    return j;
  }

private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InvalidArgument("not JSON: " + what + " at byte " + std::to_string(at_));
  }
  void space() {
    while (at_ < s_.size() &&
           (s_[at_] == ' ' || s_[at_] == '\n' || s_[at_] == '\t' || s_[at_] == '\r'))
      ++at_;
  }
  char peek() {
    space();
    if (at_ == s_.size()) fail("unexpected end");
    return s_[at_];
  }
  void expect(char c) {
    if (peek() != c) fail(std::string("expected '") + c + "'");
    ++at_;
  }
  bool word(std::string_view w) {
    if (s_.substr(at_, w.size()) != w) return false;
    at_ += w.size();
    return true;
  }

  Json value(int depth) {
    if (depth > max_depth_) fail("too deeply nested");
    switch (peek()) {
    case '{':
      return {object(depth)};
    case '[':
      return {array(depth)};
    case '"':
      return {string()};
    default:
      break;
    }
    if (word("null")) return {};
    if (word("true")) return {true};
    if (word("false")) return {false};
    fail("a string, array or object is expected (numbers must be strings)");
  }

  Json::Object object(int depth) {
    Json::Object o;
    std::unordered_set<std::string> seen;
    expect('{');
    if (peek() == '}') return ++at_, o;
    while (true) {
      if (peek() != '"') fail("a key is expected");
      std::string key = string();
      if (!seen.insert(key).second) fail("key '" + key + "' occurs twice");
      expect(':');
      o.emplace_back(std::move(key), value(depth + 1));
      if (peek() == '}') return ++at_, o;
      expect(',');
    }
  }

  Json::Array array(int depth) {
    Json::Array a;
    expect('[');
    if (peek() == ']') return ++at_, a;
    while (true) {
      a.push_back(value(depth + 1));
      if (peek() == ']') return ++at_, a;
      expect(',');
    }
  }

  std::string string() {
    std::string out;
    ++at_;
    while (true) {
      const std::size_t start = at_;
      while (at_ < s_.size() && s_[at_] != '"' && s_[at_] != '\\' &&
             static_cast<unsigned char>(s_[at_]) >= 0x20)
        ++at_;
      out.append(s_.substr(start, at_ - start));
      if (at_ == s_.size()) fail("unexpected end");
      const char c = s_[at_];
      if (c == '"') return ++at_, out;
      if (c != '\\') fail("a control character in a string");
      ++at_;
      escape(out);
    }
  }

  void escape(std::string& out) {
    if (at_ == s_.size()) fail("unexpected end");
    static constexpr std::string_view from = "\"\\/bfnrt";
    static constexpr std::string_view to = "\"\\/\b\f\n\r\t";
    const char c = s_[at_++];
    if (c != 'u') {
      const std::size_t i = from.find(c);
      if (i == std::string_view::npos) fail("an unknown escape");
      out += to[i];
      return;
    }
    std::uint32_t u = hex();
    if (u >= 0xD800 && u < 0xDC00 && s_.substr(at_, 2) == "\\u") {
      const std::size_t back = at_;
      at_ += 2;
      const std::uint32_t low = hex();
      if (low >= 0xDC00 && low < 0xE000)
        u = 0x10000 + ((u - 0xD800) << 10) + (low - 0xDC00);
      else
        at_ = back;
    }
    append_utf8(out, u);
  }

  std::uint32_t hex() {
    std::uint32_t u = 0;
    for (int i = 0; i < 4; ++i, ++at_) {
      if (at_ == s_.size()) fail("unexpected end");
      const char c = s_[at_];
      if (c >= '0' && c <= '9')
        u = u * 16 + static_cast<std::uint32_t>(c - '0');
      else if ((c | 32) >= 'a' && (c | 32) <= 'f')
        u = u * 16 + static_cast<std::uint32_t>((c | 32) - 'a' + 10);
      else
        fail("a hexadecimal digit is expected");
    }
    return u;
  }

  static void append_utf8(std::string& out, std::uint32_t u) {
    const auto tail = [&](int shift) { out += static_cast<char>(0x80 | ((u >> shift) & 0x3F)); };
    if (u < 0x80) {
      out += static_cast<char>(u);
    } else if (u < 0x800) {
      out += static_cast<char>(0xC0 | (u >> 6));
      tail(0);
    } else if (u < 0x10000) {
      out += static_cast<char>(0xE0 | (u >> 12));
      tail(6), tail(0);
    } else {
      out += static_cast<char>(0xF0 | (u >> 18));
      tail(12), tail(6), tail(0);
    }
  }

  std::string_view s_;
  int max_depth_;
  std::size_t at_ = 0;
};

// The length of the well-formed UTF-8 sequence at s[i], or 0.
std::size_t utf8_length(std::string_view s, std::size_t i) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(s[k]); };
  const unsigned char c = byte(i);
  if (c < 0x80) return 1;
  const std::size_t n = c >= 0xF0 ? 4 : c >= 0xE0 ? 3 : 2;
  if (c < 0xC2 || c > 0xF4 || i + n > s.size()) return 0;
  for (std::size_t k = 1; k < n; ++k)
    if ((byte(i + k) & 0xC0) != 0x80) return 0;
  const unsigned char d = byte(i + 1);
  if ((c == 0xE0 && d < 0xA0) || (c == 0xED && d > 0x9F) || (c == 0xF0 && d < 0x90) ||
      (c == 0xF4 && d > 0x8F))
    return 0;
  return n;
}

void append(std::string& out, const Json& j) {
  if (const auto* s = j.text()) {
    out += '"';
    for (const char c : *s) {
      static constexpr std::string_view digits = "0123456789abcdef";
      if (c == '"' || c == '\\') {
        out += '\\';
        out += c;
      } else if (static_cast<unsigned char>(c) < 0x20) {
        out += "\\u00";
        out += digits[static_cast<unsigned char>(c) >> 4];
        out += digits[static_cast<unsigned char>(c) & 15];
      } else {
        out += c;
      }
    }
    out += '"';
  } else if (const auto* a = j.array()) {
    out += '[';
    for (std::size_t i = 0; i < a->size(); ++i) {
      if (i) out += ',';
      append(out, (*a)[i]);
    }
    out += ']';
  } else if (const auto* o = j.object()) {
    out += '{';
    for (std::size_t i = 0; i < o->size(); ++i) {
      if (i) out += ',';
      append(out, Json{(*o)[i].first});
      out += ':';
      append(out, (*o)[i].second);
    }
    out += '}';
  } else if (const auto* b = j.truth()) {
    out += *b ? "true" : "false";
  } else {
    out += "null";
  }
}

} // namespace

Json parse_json(std::string_view text, int max_depth) {
  if (text.size() > max_text) throw InvalidArgument("the certificate is longer than 2^28 bytes");
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t n = utf8_length(text, i);
    if (n == 0) throw InvalidArgument("not JSON: not UTF-8 at byte " + std::to_string(i));
    i += n;
  }
  return Parser(text, max_depth).document();
}

std::string to_string(const Json& j) {
  std::string out;
  append(out, j);
  return out;
}

} // namespace kov::certify
