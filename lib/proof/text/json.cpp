#include "proof/text/json.hpp"

#include "exact/error.hpp"
#include "proof/text/limits.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <unordered_set>

namespace kov::certify {

namespace {

/// A place in the text, which tells how far the reader came.
struct Cursor {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = char;

  const char* at;
  const char** reached;

  char operator*() const { return *at; }
  Cursor& operator++() {
    *reached = ++at;
    return *this;
  }
  friend bool operator!=(const Cursor& a, const Cursor& b) { return a.at != b.at; }
};

/// Takes what nlohmann-json reads, piece by piece, and refuses what certificates have not.
class Reader {
public:
  Reader(std::string_view text, int max_depth)
      : text_(text), reached_(text.data()), max_depth_(static_cast<std::size_t>(max_depth)) {}

  Json document() {
    if (text_.starts_with("\xEF\xBB\xBF")) fail("a byte order mark");
    if (text_.find('\0') != std::string_view::npos)
      fail("a zero byte"); // it would pass for the end
    const char* end = text_.data() + text_.size();
    nlohmann::json::sax_parse(Cursor{text_.data(), &reached_}, Cursor{end, nullptr}, this);
    return std::move(whole_);
  }

  bool null() { return put({}), true; }
  bool boolean(bool b) { return put({b}), true; }
  bool string(std::string& s) { return put({std::move(s)}), true; }
  bool number_integer(std::int64_t) { fail(number); }
  bool number_unsigned(std::uint64_t) { fail(number); }
  bool number_float(double, const std::string&) { fail(number); }
  bool binary(std::vector<std::uint8_t>&) { return false; } // JSON has none
  bool start_object(std::size_t) { return open({Json::Object{}}); }
  bool start_array(std::size_t) { return open({Json::Array{}}); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(std::string& k) {
    if (!open_.back().keys.insert(k).second) fail("key '" + k + "' occurs twice");
    std::get<Json::Object>(open_.back().json->value).emplace_back(std::move(k), Json{});
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception& e) {
    const bool is_number = dynamic_cast<const nlohmann::json::out_of_range*>(&e) != nullptr;
    fail(is_number ? number : "a syntax error"); // a number beyond a double
  }

private:
  static constexpr const char* number = "numbers must be strings";
  struct Open {
    Json* json;
    std::unordered_set<std::string> keys{};
  };

  [[noreturn]] void fail(const std::string& what) const {
    throw InvalidArgument("not JSON: " + what + " at byte " +
                          std::to_string(reached_ - text_.data()));
  }
  // The lists above do not grow while it is open, so that it does not move.
  Json& put(Json j) {
    if (open_.size() > max_depth_) fail("too deeply nested");
    if (open_.empty()) return whole_ = std::move(j);
    auto& into = open_.back().json->value;
    if (auto* list = std::get_if<Json::Array>(&into)) return list->emplace_back(std::move(j));
    return std::get<Json::Object>(into).back().second = std::move(j);
  }
  bool open(Json j) {
    open_.push_back({&put(std::move(j))});
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  const char* reached_;
  std::size_t max_depth_;
  Json whole_;
  std::vector<Open> open_;
};

void append(std::string& out, const std::string& text) {
  const auto plain = [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; };
  if (std::ranges::all_of(text, plain))
    out.append("\"").append(text).append("\"");
  else
    out += nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void append(std::string& out, const Json& j) {
  const auto list = [&out](char left, const auto& all, char right, const auto& add) {
    out += left;
    for (const auto& x : all) {
      if (&x != &all.front()) out += ',';
      add(x);
    }
    out += right;
  };
  if (const auto* s = j.text()) {
    append(out, *s);
  } else if (const auto* a = j.array()) {
    list('[', *a, ']', [&](const Json& x) { append(out, x); });
  } else if (const auto* o = j.object()) {
    list('{', *o, '}', [&](const auto& x) {
      append(out, x.first);
      out += ':';
      append(out, x.second);
    });
  } else if (const auto* b = j.truth()) {
    out += *b ? "true" : "false";
  } else {
    out += "null";
  }
}

} // namespace

Json parse_json(std::string_view text, int max_depth) {
  if (text.size() > max_text) throw InvalidArgument("the certificate is longer than 2^28 bytes");
  return Reader(text, max_depth).document();
}

std::string to_string(const Json& j) {
  std::string out;
  append(out, j);
  return out;
}

} // namespace kov::certify
