#include "symbol/pasted_characters.hpp"

#include "exact/lists.hpp"
#include "symbol/tokens.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace kov {
namespace {

bool is_latin(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

struct WrittenSign {
  std::string_view bytes;
  std::string_view plain;
};

constexpr std::array signs{
    WrittenSign{"\u2032", "'"},     WrittenSign{"\u2019", "'"},      WrittenSign{"\u00b4", "'"},
    WrittenSign{"\u2033", "''"},    WrittenSign{"\u201d", "''"},     WrittenSign{"\u2034", "'''"},
    WrittenSign{"\u2057", "''''"},  WrittenSign{"\"", "''"},         WrittenSign{"\u2212", "-"},
    WrittenSign{"\u2013", "-"},     WrittenSign{"\u2014", "-"},      WrittenSign{"\ufe63", "-"},
    WrittenSign{"\u00b7", "*"},     WrittenSign{"\u00d7", "*"},      WrittenSign{"\u22c5", "*"},
    WrittenSign{"\u2219", "*"},     WrittenSign{"\u2022", "*"},      WrittenSign{"\u2217", "*"},
    WrittenSign{"\u00f7", "/"},     WrittenSign{"\u2044", "/"},      WrittenSign{"\u2215", "/"},
    WrittenSign{"\u2254", ":="},    WrittenSign{"\uff1d", "="},      WrittenSign{"\u00bd", "(1/2)"},
    WrittenSign{"\u00bc", "(1/4)"}, WrittenSign{"\u00be", "(3/4)"},  WrittenSign{"\u2153", "(1/3)"},
    WrittenSign{"\u2154", "(2/3)"}, WrittenSign{"\u221a", "\\sqrt "}};

// Blanks of every width, and what is not seen at all.
constexpr std::array<std::string_view, 10> blanks{"\u00a0", "\u2002", "\u2003", "\u2005", "\u2009",
                                                  "\u200a", "\u202f", "\u200b", "\u2061", "\u2062"};

constexpr std::array superscripts{
    WrittenSign{"\u2070", "0"}, WrittenSign{"\u00b9", "1"}, WrittenSign{"\u00b2", "2"},
    WrittenSign{"\u00b3", "3"}, WrittenSign{"\u2074", "4"}, WrittenSign{"\u2075", "5"},
    WrittenSign{"\u2076", "6"}, WrittenSign{"\u2077", "7"}, WrittenSign{"\u2078", "8"},
    WrittenSign{"\u2079", "9"}, WrittenSign{"\u207b", "-"}, WrittenSign{"\u207a", "+"},
    WrittenSign{"\u207f", "n"}, WrittenSign{"\u02e3", "x"}};

// Letters with dots above: a derivative by the time.
constexpr std::array dotted{WrittenSign{"\u1e8b", "x'"}, WrittenSign{"\u1e8d", "x''"},
                            WrittenSign{"\u1e8f", "y'"}, WrittenSign{"\u00ff", "y''"},
                            WrittenSign{"\u017c", "z'"}, WrittenSign{"\u0307", "'"},
                            WrittenSign{"\u0308", "''"}};

constexpr std::array<std::string_view, 24> greek{
    "alpha", "beta",  "gamma",  "delta",   "epsilon", "zeta", "eta",     "theta",
    "iota",  "kappa", "lambda", "mu",      "nu",      "xi",   "omicron", "pi",
    "rho",   "sigma", "tau",    "upsilon", "phi",     "chi",  "psi",     "omega"};

template <class List> std::optional<WrittenSign> found_in(const List& list, std::string_view rest) {
  for (const WrittenSign& w : list)
    if (rest.starts_with(w.bytes)) return w;
  return std::nullopt;
}

// U+0391 to U+03A9 and U+03B1 to U+03C9 (a final sigma is one), the curly forms of three, h bar and l.
std::string greek_letter(std::string_view rest) {
  for (const WrittenSign& curly :
       {WrittenSign{"\u03d1", "theta"}, WrittenSign{"\u03d5", "phi"},
        WrittenSign{"\u03f5", "epsilon"}, WrittenSign{"\u00b5", "mu"},
        WrittenSign{"\u0127", "hbar"}, WrittenSign{"\u210f", "hbar"}, WrittenSign{"\u2113", "ell"}})
    if (rest.starts_with(curly.bytes)) return std::string(curly.plain);
  if (rest.size() < 2) return {};
  const auto a = static_cast<unsigned char>(rest[0]), b = static_cast<unsigned char>(rest[1]);
  if ((a != 0xCE && a != 0xCF) || (b & 0xC0U) != 0x80) return {};
  const unsigned code = (a & 0x1FU) << 6 | (b & 0x3FU);
  const bool capital = code >= 0x391 && code <= 0x3A9, small = code >= 0x3B1 && code <= 0x3C9;
  if (!capital && !small) return {};
  unsigned index = code - (capital ? 0x391 : 0x3B1);
  if (index == 17 && capital) return {};
  if (index >= 17) --index;
  std::string name(greek.at(index));
  if (capital) name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name;
}

std::size_t character_length(std::string_view rest) {
  const auto byte = static_cast<unsigned char>(rest[0]);
  std::size_t n = 1;
  while (byte >= 0xC0 && n < std::min<std::size_t>(4, rest.size()) &&
         (static_cast<unsigned char>(rest[n]) & 0xC0U) == 0x80)
    ++n;
  return n;
}

class Rewriting {
public:
  Rewriting(std::string_view text, const OriginPtr& origin, std::vector<InputError>& errors)
      : text_(text), origin_(origin), errors_(errors) {}

  PlainCharacters operator()() {
    while (at_ < text_.size())
      step();
    out_.from.push_back(static_cast<std::uint32_t>(text_.size()));
    return std::move(out_);
  }

private:
  [[nodiscard]] std::string_view rest() const { return text_.substr(at_); }

  void emit(std::string_view plain) {
    out_.text += plain;
    out_.from.resize(out_.text.size(), static_cast<std::uint32_t>(at_));
  }
  void take(const WrittenSign& w) {
    emit(w.plain);
    at_ += w.bytes.size();
  }

  void step() {
    const char c = text_[at_];
    if (c == '\\') return command();
    if (static_cast<unsigned char>(c) < 0x80 && c != '"') return ascii(c);
    if (const auto w = found_in(signs, rest())) return sign(*w);
    if (const auto w = found_in(dotted, rest())) {
      out_.dotted = true;
      return take(*w);
    }
    for (const std::string_view blank : blanks)
      if (rest().starts_with(blank)) return take({blank, " "});
    if (found_in(superscripts, rest())) return superscript();
    if (const std::string name = greek_letter(rest()); !name.empty()) return letter(name);
    if (rest().starts_with("\xe2\x82") && rest().size() > 2) return subscript();
    strange();
  }

  // A number before a fraction, or behind a root sign and before a letter, could mean two things.
  void sign(const WrittenSign& w) {
    const auto refuse = [&](std::size_t length, std::string message, std::string hint) {
      errors_.emplace_back(*origin_, make_span(at_, at_ + length), std::move(message),
                           std::move(hint));
    };
    const auto before = out_.text.find_last_not_of(' ');
    if (w.plain.front() == '(' && before != std::string::npos && is_digit(out_.text[before]))
      refuse(w.bytes.size(), "a number and a fraction side by side: a sum, or a product?",
             "write a sum like 2 1/2 as 5/2, a product with *");
    const std::string_view under = rest().substr(w.bytes.size());
    const auto end =
        static_cast<std::size_t>(std::ranges::find_if_not(under, is_digit) - under.begin());
    if (w.plain.starts_with("\\sqrt") && end > 0 && end < under.size() && is_latin(under[end]))
      refuse(w.bytes.size() + end + 1, "where does the root end?",
             "write sqrt(" + std::string(under.substr(0, end)) + ")*" + under[end] + ", or sqrt(" +
                 std::string(under.substr(0, end)) + "*" + under[end] + ")");
    take(w);
  }

  void ascii(char c) {
    const bool visible = c > 0x20 && c < 0x7f;
    const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!blank && (!visible || std::string_view("!?#`|<>").find(c) != std::string_view::npos))
      return strange();
    emit(std::string_view(&text_[at_], 1));
    ++at_;
  }

  // \name and a blank, so that \frac12 has two words; an index belongs to its name.
  void command() {
    std::size_t end = at_ + 1;
    while (end < text_.size() && is_latin(text_[end]))
      ++end;
    if (end == at_ + 1) end = std::min(end + 1, text_.size());
    for (std::size_t i = at_; i < end; ++i) {
      out_.text += text_[i];
      out_.from.push_back(static_cast<std::uint32_t>(i));
    }
    at_ = end;
    if (at_ >= text_.size() || text_[at_] != '_') emit(" ");
  }

  // A Greek letter is a name by itself, with the index that follows.
  void letter(const std::string& name) {
    if (!out_.text.empty() && (is_latin(out_.text.back()) || is_digit(out_.text.back()))) emit(" ");
    emit(name);
    at_ += character_length(rest());
    const bool index = at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '_' ||
                                              rest().starts_with("\xe2\x82"));
    if (!index) emit(" ");
  }

  void superscript() {
    std::string power;
    std::size_t end = at_;
    while (const auto w = found_in(superscripts, text_.substr(end))) {
      power += w->plain;
      end += w->bytes.size();
    }
    const bool simple = std::ranges::all_of(power, is_digit) || power.size() == 1;
    emit(simple ? "^" + power : "^(" + power + ")");
    at_ = end;
    if (at_ < text_.size() && (is_latin(text_[at_]) || is_digit(text_[at_]))) emit(" ");
  }

  // U+2080 to U+2089
  void subscript() {
    const auto digit = static_cast<unsigned char>(rest()[2]);
    if (digit < 0x80 || digit > 0x89) return strange();
    emit(std::string(1, static_cast<char>('0' + (digit - 0x80))));
    at_ += 3;
    if (at_ < text_.size() && is_latin(text_[at_])) emit(" ");
  }

  void strange() {
    const std::size_t n = character_length(rest());
    const auto byte = static_cast<unsigned char>(text_[at_]);
    constexpr std::string_view hex = "0123456789abcdef";
    const bool shown = n > 1 || (byte > 0x20 && byte < 0x7f);
    errors_.emplace_back(
        *origin_, make_span(at_, at_ + n),
        shown ? "unexpected character " + quoted(rest().substr(0, n))
              : std::string("unexpected byte 0x") + hex[byte >> 4] + hex[byte & 15],
        rest().starts_with("\u2202") ? "one variable is expected: write d^2y/dx^2 or y''"
        : byte == '<' || byte == '>' ? "what is assumed is an option: --assume 'a > 0'"
                                     : "");
    emit(" ");
    at_ += n;
  }

  std::string_view text_;
  const OriginPtr& origin_;
  std::vector<InputError>& errors_;
  PlainCharacters out_;
  std::size_t at_ = 0;
};

} // namespace

PlainCharacters plain_characters(std::string_view text, const OriginPtr& origin,
                                 std::vector<InputError>& errors) {
  return Rewriting(text, origin, errors)();
}

bool is_greek(std::string_view name) {
  std::string small(name);
  if (!small.empty() && small[0] >= 'A' && small[0] <= 'Z')
    small[0] = static_cast<char>(small[0] - 'A' + 'a');
  return is_among(small, greek);
}

} // namespace kov
