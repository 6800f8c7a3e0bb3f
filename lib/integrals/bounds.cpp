#include "integrals/bounds.hpp"

#include "exact/tried.hpp"
#include "symbol/author_words.hpp"

namespace kov {
namespace {

// The largest number of unknowns of the ansatz with the bounds of Theorem 3, with and without
// parameters; if it would be larger, a smaller ansatz is chosen.
constexpr std::size_t most_with_parameters = 600;
constexpr std::size_t most_without = 2000;

// A denominator as its factors, or by the number of its terms.
std::string denominator_text(const MPoly& den) {
  constexpr std::size_t longest = 80;
  const std::string factors = to_factored_string(MFraction(den));
  return factors.size() <= longest ? factors
                                   : "a denominator of " + std::to_string(den.length()) + " terms";
}

// Unset: too many.
std::optional<std::size_t> unknowns(const IntegralBounds& b, long degree,
                                    std::optional<long> coefficients) {
  return tried<OutOfBudget>(
      [&] { return std::optional(b.ansatz(b.space, degree, coefficients).numerators.size()); });
}

// The ansatz of Theorem 3, by itself or beside the one that is chosen otherwise.
bool is_small(const IntegralBounds& b, long degree) {
  const std::size_t most = b.space.parameters.empty() ? most_without : most_with_parameters;
  const auto size = unknowns(b, degree, std::nullopt);
  return size && (*size <= most || *size <= unknowns(b, degree, b.options.degree).value_or(*size));
}

// Statements of theorems about the highest part, and about denominators and degrees, need no words.
std::string searched_in_layers(const IntegralBounds& b) {
  if (!b.highest)
    return b.natural->polynomial ? ""
                                 : ", their coefficients rational functions of the coordinates";
  const long more = degree_of(b.space, b.space.denominator);
  const std::string text =
      ", their other coefficients polynomials of degree <= " + std::to_string(*b.highest);
  if (more == 0) return text + " in the other variables";
  const std::string d = denominator_text(b.space.denominator);
  return text + " + " + (more == 1 ? "" : std::to_string(more) + "*") + "j over " +
         (is_identifier(d) ? d : "(" + d + ")") + "^j, " + (b.natural->even ? "2*" : "") +
         "j degrees below the highest one";
}

} // namespace

IntegralBounds::IntegralBounds(const PhaseSpace& p, const std::optional<NaturalHamiltonian>& n,
                               const IntegralOptions& o, bool is_regular)
    : space(p), natural(n), options(o), layered(is_regular && !(n->even && n->polynomial)),
      bounded(is_regular && n->twice_step && !o.coefficients), highest(coefficients(o.degree)) {}

std::optional<long> IntegralBounds::coefficients(long degree) const {
  if (bounded && (!layered || is_small(*this, degree))) return std::nullopt;
  return options.coefficients ? options.coefficients : options.degree;
}

std::string IntegralBounds::searched() const {
  const std::string first =
      "polynomials of degree <= " + std::to_string(options.degree) + " in the momenta";
  if (layered) return first + searched_in_layers(*this);
  const MPoly den = ansatz_denominator(space, options.degree, options.power);
  const long more = degree_of(space, den);
  const std::string over = more > 0 ? ", over " + denominator_text(den) : "";
  if (!space.is_canonical())
    return "polynomials of degree <= " + std::to_string(options.degree + more) +
           " in the phase variables" + over;
  if (!highest) return first;
  return first +
         ", their coefficients polynomials of degree <= " + std::to_string(*highest + more) +
         " in the other variables" + over;
}

} // namespace kov
