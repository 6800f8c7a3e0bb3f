#include "symbol/reading_note.hpp"

#include "symbol/suggest.hpp"

#include <algorithm>

namespace kov {

std::string sentence(const ReadingNote& n) {
  using What = ReadingNote::What;
  const auto of = [&n](std::size_t i) -> const std::string& { return n.of.at(i); };
  switch (n.what) {
  case What::decimal:
    return "decimals are exact: " + of(0) + " = " + of(1);
  case What::root:
    return "RootOf(" + of(0) + ") is taken as " + of(1) + "; another root gives a conjugate answer";
  case What::derivative:
    return of(0) + " is a derivative";
  case What::coefficients:
    return "the list has the coefficients of " + of(0) + ", " + of(0) + "', " + of(0) +
           "'', the lowest derivative first";
  case What::not_used:
    return "not used: " + of(0);
  case What::differentiates:
    return of(0) + " is the derivative";
  case What::euler:
    return of(0) + " is " + of(1) + " times the derivative";
  case What::riccati:
    return "a Riccati equation: " + of(0) + ", and " + of(1);
  case What::bernoulli:
    return "Bernoulli's equation: " + of(0) + ", and " + of(1);
  case What::first_order:
    return "a linear equation of the first order: without its right side its solutions, and the "
           "constants, solve the equation that is decided";
  case What::homogeneous:
    return "the homogeneous equation " + of(0) + " is decided; the right side is " + of(1);
  case What::variable:
    return "in the variable " + of(0) + " the coefficients are rational";
  case What::names: {
    std::string text = of(0).empty() ? "" : "the unknown is " + of(0) + ", ";
    text += "the variable is " + of(1);
    const std::vector<std::string> parameters(n.of.begin() + 2, n.of.end());
    if (parameters.empty()) return text;
    return text + (parameters.size() == 1 ? ", the parameter is " : ", the parameters are ") +
           enumerate(parameters);
  }
  }
  return {};
}

std::vector<std::string> sentences(const std::vector<ReadingNote>& all) {
  const auto roots = std::ranges::count_if(
      all, [](const ReadingNote& n) { return n.what == ReadingNote::What::root; });
  std::vector<std::string> out;
  for (const ReadingNote& n : all)
    out.push_back(n.what == ReadingNote::What::root && roots > 1 // which may depend on each other
                      ? "RootOf(" + n.of.at(0) + ") is taken as " + n.of.at(1)
                      : sentence(n));
  return out;
}

} // namespace kov
