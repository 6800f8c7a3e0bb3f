#include "equation/sentence.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace kov {
namespace {

constexpr const char* examples =
    "e.g. \"A > 0\", \"d != 0\", \"n not an integer\", "
    "\"2*nu odd integer\", \"nu not in 1/2+Z\", \"n in N\", \"c complex\"";

std::string_view trimmed(std::string_view s) {
  const auto from = s.find_first_not_of(" \t\n");
  if (from == std::string_view::npos) return {};
  return s.substr(from, s.find_last_not_of(" \t\n") - from + 1);
}

// Cuts `tail` off the end, at a word boundary.
bool drop_tail(std::string_view& s, std::string_view tail) {
  if (s.size() <= tail.size() || !s.ends_with(tail)) return false;
  const char before = s[s.size() - tail.size() - 1];
  if (before != ' ' && before != ')') return false;
  s = trimmed(s.substr(0, s.size() - tail.size()));
  return true;
}

// The text with its subject before it, and the place of each of its pieces.
class Placed {
public:
  explicit Placed(const AssumedText& t)
      : before_(t.subject.empty() ? 0 : t.subject.size() + 1),
        whole_(before_ == 0 ? t.text : t.subject + " " + t.text),
        origin_(t.origin ? t.origin : origin_of_text("assumption", t.text)) {}

  [[nodiscard]] std::string_view whole() const { return whole_; }
  [[nodiscard]] const OriginPtr& origin() const { return origin_; }
  [[nodiscard]] std::size_t offset(std::string_view piece) const {
    const auto at = static_cast<std::size_t>(piece.data() - whole_.data());
    return at > before_ ? at - before_ : 0;
  }
  [[nodiscard]] Span span(std::string_view piece) const {
    const auto end = static_cast<std::size_t>(piece.data() - whole_.data()) + piece.size();
    const std::size_t from = offset(piece);
    return {static_cast<std::uint32_t>(from),
            static_cast<std::uint32_t>(end > before_ + from ? end - before_ - from : 1)};
  }
  [[nodiscard]] Expression formula(std::string_view piece) const {
    piece = trimmed(piece);
    if (piece.empty()) throw InputError(*origin_, {0, 1}, "a formula is missing");
    return parse_expression(piece, origin_from(origin_, offset(piece)));
  }

private:
  std::size_t before_;
  std::string whole_;
  OriginPtr origin_;
};

Expression number(const char* digits) { return parse_expression(digits, "assumption"); }

class SentenceReader {
public:
  SentenceReader(const Placed& place, std::string_view text)
      : place_(place), whole_(text), rest_(text) {}

  // One, or two of a natural number: it is an integer, and has a sign.
  std::vector<Sentence> read() {
    std::vector<Sentence> all = natural();
    if (all.empty()) all.push_back(read_one());
    for (Sentence& s : all) {
      s.text = whole_;
      s.origin = place_.origin();
      s.span = place_.span(whole_);
    }
    return all;
  }

private:
  Sentence read_one() {
    for (const auto form : {&SentenceReader::comparison, &SentenceReader::in_integers,
                            &SentenceReader::integer_word, &SentenceReader::word})
      if (auto s = (this->*form)()) return *std::move(s);
    throw InputError(*place_.origin(), place_.span(whole_), "this assumption is not understood",
                     examples);
  }

  [[nodiscard]] Expression formula(std::string_view text) const { return place_.formula(text); }

  std::optional<Sentence> comparison() {
    const auto c = kov::comparison(whole_);
    if (!c) return std::nullopt;
    return Sentence{Sentence::Kind::sign, formula(c->left), formula(c->right), c->sign};
  }

  // "n in N", "n natural", "n a positive integer": 0 is in N.
  std::vector<Sentence> natural() {
    std::string_view rest = whole_;
    Sign sign = Sign::nonnegative;
    if (drop_tail(rest, "N")) {
      if (!drop_tail(rest, "in")) return {};
    } else if (drop_tail(rest, "integer")) {
      if (drop_tail(rest, "positive"))
        sign = Sign::positive;
      else if (!drop_tail(rest, "nonnegative"))
        return {};
    } else {
      drop_tail(rest, "number");
      if (!drop_tail(rest, "natural")) return {};
    }
    drop_tail(rest, "a");
    if (drop_tail(rest, "not"))
      throw InputError(*place_.origin(), place_.span(whole_),
                       "what is not a natural number is not an integer, or negative",
                       "these are two questions: ask them one by one");
    drop_tail(rest, "is");
    const Expression left = formula(rest);
    return {Sentence{Sentence::Kind::membership, left, number("0")},
            Sentence{Sentence::Kind::sign, left, number("0"), sign}};
  }

  std::optional<Sentence> in_integers() {
    const auto at = whole_.find(" in ");
    if (at == std::string_view::npos) return std::nullopt;
    std::string_view left = whole_.substr(0, at);
    const bool holds = !drop_tail(left, "not");
    drop_tail(left, "is");
    std::string_view right = trimmed(whole_.substr(at + 4));
    if (!right.ends_with('Z')) return std::nullopt;
    right = trimmed(right.substr(0, right.size() - 1));
    // offset + multiplier Z: what follows the last plus sign is the multiplier
    const std::size_t plus = last_plus(right);
    const std::string_view offset = plus == none ? std::string_view{} : right.substr(0, plus);
    const std::string_view multiplier = plus == none ? right : right.substr(plus + 1);
    return Sentence{Sentence::Kind::membership,
                    formula(left),
                    trimmed(offset).empty() ? number("0") : formula(offset),
                    Sign::nonzero,
                    holds,
                    multiplier_of(multiplier)};
  }

  static constexpr std::size_t none = std::string_view::npos;

  // Outside parentheses.
  static std::size_t last_plus(std::string_view s) {
    long depth = 0;
    for (std::size_t i = s.size(); i-- > 0;) {
      depth += s[i] == ')' ? 1 : s[i] == '(' ? -1 : 0;
      if (s[i] == '+' && depth == 0) return i;
    }
    return none;
  }

  // The multiplier of Z: a positive rational number, 1 if nothing stands there.
  [[nodiscard]] Rational multiplier_of(std::string_view piece) const {
    using Kind = Expression::Kind;
    piece = trimmed(piece);
    if (piece.ends_with('*')) piece = trimmed(piece.substr(0, piece.size() - 1));
    if (piece.empty()) return Rational(1);
    const Expression e = formula(piece);
    const auto digits = [](const Expression& x) { return x.kind() == Kind::number; };
    if (digits(e) && !is_zero(e.number())) return Rational(e.number());
    if (e.kind() == Kind::quotient && digits(e.operand(0)) && digits(e.operand(1)) &&
        !is_zero(e.operand(0).number()) && !is_zero(e.operand(1).number()))
      return {e.operand(0).number(), e.operand(1).number()};
    throw e.error("what multiplies Z is a positive rational number",
                  "write e.g. n in 2Z, nu in 1/2+Z, or nu in a+2Z");
  }

  std::optional<Sentence> integer_word() {
    std::string_view rest = rest_;
    if (!drop_tail(rest, "integer")) return std::nullopt;
    const bool odd = drop_tail(rest, "odd");
    const bool even = !odd && drop_tail(rest, "even");
    drop_tail(rest, "an");
    const bool holds = !drop_tail(rest, "not");
    drop_tail(rest, "is");
    return Sentence{
        Sentence::Kind::membership,   formula(rest), number(odd ? "1" : "0"), Sign::nonzero, holds,
        Rational(odd || even ? 2 : 1)};
  }

  std::optional<Sentence> word() {
    const auto said = [&](const char* w) {
      if (!drop_tail(rest_, w)) return false;
      drop_tail(rest_, "is");
      return true;
    };
    const auto sign = [&](Sign s) {
      return Sentence{Sentence::Kind::sign, formula(rest_), number("0"), s};
    };
    if (said("positive")) return sign(Sign::positive);
    if (said("nonnegative")) return sign(Sign::nonnegative);
    if (said("nonzero")) return sign(Sign::nonzero);
    if (said("negative"))
      return Sentence{Sentence::Kind::sign, number("0"), formula(rest_), Sign::positive};
    using MaybeSort = std::optional<Sort>;
    for (const auto& [w, sort] :
         {std::pair("real", MaybeSort(Sort::real)),
          std::pair("rational", MaybeSort(Sort::rational)), std::pair("complex", MaybeSort()),
          std::pair("arbitrary", MaybeSort())}) {
      if (!said(w)) continue;
      drop_tail(rest_, "arbitrary");
      Sentence s{Sentence::Kind::declaration, formula(rest_), std::nullopt};
      s.sort = sort;
      return s;
    }
    return std::nullopt;
  }

  const Placed& place_;
  std::string_view whole_;
  std::string_view rest_;
};

// "k +- m not in Z" is said of k + m and of k - m: the text of this part alone, with one sign, at
// its place.
AssumedText with_sign(const AssumedText& text, const Placed& place, std::string_view part,
                      char sign) {
  if (part.find('=') != std::string_view::npos && part.find("!=") == std::string_view::npos)
    throw InputError(*place.origin(), place.span(part), "'+-' in an equation says no single thing",
                     "write two assumptions, or the equation of the squares");
  if (!text.subject.empty())
    throw InputError(*place.origin(), place.span(part), "'+-' is not read here",
                     "write two assumptions");
  AssumedText one = text;
  one.origin = place.origin();
  one.text = std::string(place.offset(part), ' ') + std::string(part);
  const std::size_t at = one.text.find("+-");
  one.text[at] = sign;
  one.text[at + 1] = ' ';
  return one;
}

} // namespace

std::vector<Sentence> sentences(const AssumedText& text) {
  const Placed place(text);
  std::vector<Sentence> all;
  std::string_view rest = place.whole();
  while (!rest.empty()) {
    const std::size_t mark = std::min(rest.find_first_of(",;"), rest.size());
    const std::size_t word = std::min(rest.find(" and "), rest.size());
    const std::string_view part = trimmed(rest.substr(0, std::min(mark, word)));
    if (part.find("+-") != std::string_view::npos)
      for (const char sign : {'+', '-'})
        std::ranges::move(sentences(with_sign(text, place, part, sign)), std::back_inserter(all));
    else if (!part.empty())
      std::ranges::move(SentenceReader(place, part).read(), std::back_inserter(all));
    rest.remove_prefix(std::min(rest.size(), word < mark ? word + 5 : mark + 1));
  }
  if (all.empty())
    throw InputError(*place.origin(), {0, 1}, "the assumption says nothing", examples);
  return all;
}

std::vector<std::string> names_in(const Sentence& s) {
  std::set<std::string> names;
  for (const auto& n : names_in(s.left))
    names.insert(n);
  if (s.right)
    for (const auto& n : names_in(*s.right))
      names.insert(n);
  return {names.begin(), names.end()};
}

} // namespace kov
