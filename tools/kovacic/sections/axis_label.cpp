#include "sections/axis_label.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

namespace kov::cli {
namespace {

using Greek = std::pair<std::string_view, std::string_view>;
constexpr std::array<Greek, 32> greek{
    {{"alpha", "α"}, {"beta", "β"},  {"gamma", "γ"}, {"delta", "δ"}, {"epsilon", "ε"},
     {"zeta", "ζ"},  {"eta", "η"},   {"theta", "θ"}, {"kappa", "κ"}, {"lambda", "λ"},
     {"mu", "μ"},    {"nu", "ν"},    {"xi", "ξ"},    {"pi", "π"},    {"rho", "ρ"},
     {"sigma", "σ"}, {"tau", "τ"},   {"phi", "φ"},   {"chi", "χ"},   {"psi", "ψ"},
     {"omega", "ω"}, {"Gamma", "Γ"}, {"Delta", "Δ"}, {"Theta", "Θ"}, {"Lambda", "Λ"},
     {"Xi", "Ξ"},    {"Pi", "Π"},    {"Sigma", "Σ"}, {"Phi", "Φ"},   {"Psi", "Ψ"},
     {"Omega", "Ω"}, {"iota", "ι"}}};

std::string greek_letter(std::string_view name) {
  const auto found = std::ranges::find_if(greek, [&](const Greek& g) { return g.first == name; });
  return found != greek.end() ? std::string(found->second)
         : name.size() == 1   ? std::string(name)
                              : "";
}

std::string in_italics(const std::string& text) { return "{/:Italic " + text + "}"; }

// x, theta, q1, p_theta, px, ptheta; "": none of these
std::string typeset_name(std::string_view name) {
  if (const std::string letter = greek_letter(name); !letter.empty()) return in_italics(letter);
  const auto digit = std::ranges::find_if(
      name, [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
  const auto stem = name.substr(0, static_cast<std::size_t>(digit - name.begin()));
  const auto index = name.substr(stem.size());
  if (!index.empty() && std::ranges::all_of(index, [](char c) {
        return std::isdigit(static_cast<unsigned char>(c)) != 0;
      }))
    if (const std::string base = stem.ends_with('_') ? typeset_name(stem.substr(0, stem.size() - 1))
                                                     : typeset_name(stem);
        !base.empty())
      return base + "_{" + std::string(index) + "}";
  const auto low = name.find('_');
  const std::string_view head = low != std::string_view::npos ? name.substr(0, low)
                                                              : name.substr(0, 1),
                         tail =
                             low != std::string_view::npos ? name.substr(low + 1) : name.substr(1);
  const bool momentum = head == "p" || low != std::string_view::npos;
  const std::string base = greek_letter(head), below = greek_letter(tail);
  return momentum && !base.empty() && !below.empty() ? in_italics(base + "_{" + below + "}") : "";
}

std::string escaped_for_gnuplot(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("_{}@&~\\").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

} // namespace

std::string axis_label(const std::string& formula) {
  std::string out;
  for (std::size_t i = 0; i < formula.size();) {
    const auto part_of_a_name = [&](std::size_t k) {
      return k < formula.size() &&
             (std::isalnum(static_cast<unsigned char>(formula[k])) != 0 || formula[k] == '_');
    };
    if (std::isalpha(static_cast<unsigned char>(formula[i])) == 0) {
      const bool power = formula[i] == '^' && i + 1 < formula.size() &&
                         std::isdigit(static_cast<unsigned char>(formula[i + 1])) != 0;
      out += power               ? "^"
             : formula[i] == '^' ? "\\^"
             : formula[i] == '*' ? " "
                                 : escaped_for_gnuplot(formula.substr(i, 1));
      ++i;
      continue;
    }
    std::size_t end = i;
    while (part_of_a_name(end))
      ++end;
    const std::string name = formula.substr(i, end - i), typeset = typeset_name(name);
    out += typeset.empty() ? escaped_for_gnuplot(name) : typeset;
    i = end;
  }
  return out;
}

} // namespace kov::cli
