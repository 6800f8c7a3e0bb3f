#include "power_product.hpp"

#include "exact/integer.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace kov::cli {
namespace {

struct PowerOf {
  std::string base; // without blanks and outer parentheses
  Rational exponent{1};
  std::string text; // as it was written
};

// The positions outside of parentheses with one of these characters.
std::vector<std::size_t> places_outside(const std::string& text, const char* wanted) {
  std::vector<std::size_t> all;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    if (depth == 0 && std::string_view(wanted).find(text[i]) != std::string_view::npos)
      all.push_back(i);
  }
  return all;
}

std::string base_of(std::string text) {
  std::erase(text, ' ');
  while (text.size() > 1 && text.front() == '(' && text.back() == ')' &&
         places_outside(text.substr(0, text.size() - 1), ")").empty())
    text = text.substr(1, text.size() - 2);
  return text;
}

std::optional<Rational> exponent_of(const std::string& text) {
  if (text.empty() || text.find_first_not_of("-0123456789/") != std::string::npos ||
      std::ranges::count(text, '/') > 1)
    return std::nullopt;
  return Rational::parse(text);
}

PowerOf power_of(const std::string& factor) {
  if (factor.starts_with("sqrt(") && places_outside(factor, ")").size() == 1 &&
      factor.back() == ')')
    return {base_of(factor.substr(4)), Rational(1, 2), factor};
  const auto at = places_outside(factor, "^");
  if (at.size() == 1)
    if (const auto e = exponent_of(base_of(factor.substr(at[0] + 1))))
      return {base_of(factor.substr(0, at[0])), *e, factor};
  return {base_of(factor), Rational(1), factor};
}

// The factors of a product; one that is a sum or a quotient outside of parentheses is one factor.
std::vector<PowerOf> powers_in(const std::string& product) {
  if (product.empty() || product == "1") return {};
  if (!places_outside(product, "+/ ").empty())
    return {{base_of(product), Rational(1), "(" + product + ")"}};
  std::vector<PowerOf> all;
  std::size_t begin = 0;
  for (const std::size_t star : places_outside(product, "*")) {
    all.push_back(power_of(product.substr(begin, star - begin)));
    begin = star + 1;
  }
  all.push_back(power_of(product.substr(begin)));
  return all;
}

// 1 - x is x - 1 up to a constant factor.
bool proportional(const std::string& a, const std::string& b) {
  const auto reversed = [](const std::string& one) -> std::string {
    const auto minus = one.find('-', 1);
    if (minus == std::string::npos || one.find_first_of("+*/^()", 1) != std::string::npos)
      return "";
    return one.substr(minus + 1) + "-" + one.substr(0, minus);
  };
  return a == b || (a.front() != '-' && reversed(a) == b);
}

std::string power_text(const PowerOf& p) {
  const bool plain = p.base.find_first_of("+-*/^ ") == std::string::npos;
  const std::string base = plain ? p.base : "(" + p.base + ")";
  return p.exponent == Rational(1) ? base : base + "^(" + to_string(p.exponent) + ")";
}

} // namespace

std::string product_of_powers(const std::string& first, const std::string& second) {
  if (first.empty() || first == "1") return second;
  std::vector<PowerOf> all = powers_in(first);
  const std::size_t before = all.size();
  for (PowerOf& p : powers_in(second)) {
    const auto same = std::find_if(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(before),
                                   [&](const PowerOf& q) { return proportional(p.base, q.base); });
    if (same == all.begin() + static_cast<std::ptrdiff_t>(before)) {
      all.push_back(std::move(p));
      continue;
    }
    same->exponent = same->exponent + p.exponent;
    same->text = is_zero(same->exponent) ? "" : power_text(*same);
  }
  std::string product;
  for (const PowerOf& p : all)
    if (!p.text.empty()) product += (product.empty() ? "" : "*") + p.text;
  return product.empty() ? "1" : product;
}

} // namespace kov::cli
