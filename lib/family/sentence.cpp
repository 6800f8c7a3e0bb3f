#include "family/sentence.hpp"

#include <algorithm>
#include <array>

namespace kov {
namespace {

std::string trimmed(const std::string& s) {
  const auto from = s.find_first_not_of(" \t\n");
  if (from == std::string::npos) return {};
  return s.substr(from, s.find_last_not_of(" \t\n") - from + 1);
}

// Cuts `tail` off the end, at a word boundary.
bool drop_tail(std::string& s, const std::string& tail) {
  if (s.size() <= tail.size() || !s.ends_with(tail)) return false;
  const char before = s[s.size() - tail.size() - 1];
  if (before != ' ' && before != ')') return false;
  s = trimmed(s.substr(0, s.size() - tail.size()));
  return true;
}

class SentenceReader {
public:
  explicit SentenceReader(std::string text) : whole_(std::move(text)) {}

  Sentence read() {
    rest_ = whole_;
    if (auto s = comparison()) return *std::move(s);
    if (auto s = in_integers()) return *std::move(s);
    if (auto s = integer_word()) return *std::move(s);
    if (auto s = word()) return *std::move(s);
    throw InputError(*origin_of_text("assumption", whole_),
                     {0, static_cast<std::uint32_t>(whole_.size())},
                     "this assumption is not understood",
                     "e.g. \"A > 0\", \"d != 0\", \"n not an integer\", \"2*nu odd integer\", "
                     "\"nu not in 1/2+Z\", \"c complex\"");
  }

private:
  Expression formula(const std::string& text) const {
    return parse_expression(trimmed(text), "assumption");
  }

  std::optional<Sentence> comparison() const {
    using strata::Sign;
    const std::array<std::pair<const char*, Sign>, 6> signs{{{">=", Sign::nonnegative},
                                                             {"<=", Sign::nonnegative},
                                                             {"!=", Sign::nonzero},
                                                             {">", Sign::positive},
                                                             {"<", Sign::positive},
                                                             {"=", Sign::zero}}};
    for (const auto& [sign, meaning] : signs) {
      const std::string mark(sign);
      const auto at = whole_.find(mark);
      if (at == std::string::npos) continue;
      Expression left = formula(whole_.substr(0, at));
      Expression right = formula(whole_.substr(at + mark.size()));
      if (mark[0] == '<') std::swap(left, right);
      return Sentence{Sentence::Kind::sign, left, right, meaning};
    }
    return std::nullopt;
  }

  std::optional<Sentence> in_integers() const {
    const auto at = whole_.find(" in ");
    if (at == std::string::npos) return std::nullopt;
    std::string left = whole_.substr(0, at);
    const bool holds = !drop_tail(left, "not");
    drop_tail(left, "is");
    std::string right;
    for (const char c : whole_.substr(at + 4))
      if (c != ' ') right += c;
    if (!right.ends_with('Z')) return std::nullopt;
    right.pop_back();
    if (right.ends_with('+')) right.pop_back();
    return Sentence{Sentence::Kind::membership, formula(left), formula(right.empty() ? "0" : right),
                    strata::Sign::nonzero, holds};
  }

  std::optional<Sentence> integer_word() {
    if (!drop_tail(rest_, "integer")) return std::nullopt;
    const bool odd = drop_tail(rest_, "odd");
    const bool even = !odd && drop_tail(rest_, "even");
    drop_tail(rest_, "an");
    const bool holds = !drop_tail(rest_, "not");
    drop_tail(rest_, "is");
    return Sentence{Sentence::Kind::membership, formula(rest_), formula(odd ? "1" : "0"),
                    strata::Sign::nonzero,      holds,          Integer(odd || even ? 2 : 1)};
  }

  std::optional<Sentence> word() {
    using strata::Sign;
    const auto said = [&](const char* w) {
      if (!drop_tail(rest_, w)) return false;
      drop_tail(rest_, "is");
      return true;
    };
    const auto sign = [&](Sign s) {
      return Sentence{Sentence::Kind::sign, formula(rest_), std::nullopt, s};
    };
    if (said("positive")) return sign(Sign::positive);
    if (said("nonnegative")) return sign(Sign::nonnegative);
    if (said("nonzero")) return sign(Sign::nonzero);
    if (said("negative"))
      return Sentence{Sentence::Kind::sign, formula("-(" + rest_ + ")"), std::nullopt,
                      Sign::positive};
    for (const auto& [w, real] : {std::pair("real", true), std::pair("rational", true),
                                  std::pair("complex", false), std::pair("arbitrary", false)}) {
      if (!said(w)) continue;
      drop_tail(rest_, "arbitrary");
      Sentence s{Sentence::Kind::declaration, formula(rest_), std::nullopt};
      s.real = real;
      return s;
    }
    return std::nullopt;
  }

  std::string whole_;
  std::string rest_;
};

} // namespace

std::vector<Sentence> sentences(const std::string& text) {
  std::vector<Sentence> all;
  std::string rest = text;
  for (auto at = rest.find(" and "); at != std::string::npos; at = rest.find(" and "))
    rest.replace(at, 5, ",");
  std::string part;
  for (const char c : rest + ",") {
    if (c != ',' && c != ';') {
      part += c;
      continue;
    }
    if (part = trimmed(part); !part.empty()) all.push_back(SentenceReader(part).read());
    part.clear();
  }
  return all;
}

} // namespace kov
