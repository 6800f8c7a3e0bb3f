#include "integrals/known.hpp"

#include "exact/error.hpp"
#include "exact/tried.hpp"

#include <algorithm>

namespace kov {
namespace {

// At no parameter value f is the zero polynomial.
bool is_nowhere_zero(const KnownIntegrals& s, const MPoly& f) {
  const auto all = s.space->coefficients(f, nullptr);
  return std::ranges::any_of(all, [&](const auto& c) { return s.where.is_nonzero(c.second); });
}

MPoly some_coefficient(const KnownIntegrals& s, const MPoly& f) {
  for (const auto& [m, c] : s.space->coefficients(f, nullptr))
    if (!is_zero(s.where.restrict(c))) return c;
  return MPoly(f.ring(), Integer(1));
}

} // namespace

std::vector<MPoly> special_conditions(const KnownIntegrals& s, const DarbouxPolynomial& f) {
  if (!is_zero(f.cofactor) && !s.where.vanishes(f.cofactor.den()))
    if (auto poles = s.where.doubtful_factors(f.cofactor.den()); !poles.empty()) return poles;
  if (f.equations.empty())
    return is_nowhere_zero(s, f.polynomial)
               ? std::vector<MPoly>{}
               : s.where.doubtful_factors(some_coefficient(s, f.polynomial));
  const MPoly equation = s.where.restrict(f.equations.front()).num();
  return is_zero(equation) ? std::vector<MPoly>{} : s.where.doubtful_factors(equation);
}

bool is_darboux(const KnownIntegrals& s, const PolynomialField& x, const DarbouxPolynomial& f) {
  const MFraction value(f.polynomial);
  return is_nowhere_zero(s, f.polynomial) &&
         (is_zero(f.cofactor) || s.where.is_nonzero(f.cofactor.den())) &&
         s.space->vanishes(s.where,
                           MFraction(x.multiplier) * lie_derivative(s.space->field, value) -
                               f.cofactor * value);
}

std::vector<std::pair<KnownIntegrals, EchelonForm>>
kernel_parts(const KnownIntegrals& s, const EchelonForm& e, const Budget& budget) {
  return tried<OutOfBudget>([&] {
    std::vector<std::pair<KnownIntegrals, EchelonForm>> parts;
    for_each_kernel(
        s.where, e,
        [&](const Set& set, const EchelonForm& done) { parts.emplace_back(s.on(set), done); },
        budget);
    return parts;
  });
}

namespace {

std::optional<MFraction> product_of_powers(const FoundIntegral& f) {
  constexpr long highest = 12;
  if (f.logarithms.empty() || !is_zero(f.value)) return std::nullopt;
  Integer den(1);
  for (const LogarithmicTerm& t : f.logarithms) {
    if (!is_constant(t.times)) return std::nullopt;
    den = lcm(den, to_rational(t.times).den());
  }
  MFraction product(f.value.ring(), Rational(1));
  for (const LogarithmicTerm& t : f.logarithms) {
    const Rational power = to_rational(t.times) * Rational(den);
    if (abs(power) > Rational(highest)) return std::nullopt;
    product *= pow(MFraction(t.of), to_long(power.num()));
  }
  return product;
}

} // namespace

std::vector<FoundIntegral> logarithmic_integrals(const KnownIntegrals& s,
                                                 const LogarithmicAnsatz& ansatz,
                                                 const EchelonForm& kernel) {
  std::vector<FoundIntegral> all;
  const std::size_t first = ansatz.polynomials.size();
  for (const auto& vector : kernel_basis(s.where, kernel)) {
    FoundIntegral f{.value = MFraction(s.space->field.ring)};
    for (const auto& [j, c] : without_denominators(s.space->field.ring, vector))
      if (j < first)
        f.logarithms.push_back({MFraction(c), ansatz.polynomials[j].polynomial});
      else
        f.value += MFraction(c * ansatz.monomials[j - first], ansatz.below);
    if (const auto product = product_of_powers(f)) f = {.value = *product};
    f.degree = degree_in_momenta(*s.space, f.value.num());
    all.push_back(std::move(f));
  }
  return all;
}

FieldAnsatz::FieldAnsatz(const KnownIntegrals& s, long degree, std::size_t denominator)
    : numerators(monomials(s.space->field.ring, s.space->variables, degree)),
      below(s.space->field.ring, Rational(1)), cofactor(s.space->field.ring) {
  for (std::size_t i = 0; i < s.darboux.size(); ++i)
    if (denominator == i + 1 || denominator == s.darboux.size() + 1) {
      below *= MFraction(s.darboux[i].polynomial);
      cofactor += s.darboux[i].cofactor;
    }
}

std::vector<std::vector<MFraction>> FieldAnsatz::fields(const KnownIntegrals& s,
                                                        const EchelonForm& kernel) const {
  std::vector<std::vector<MFraction>> all;
  for (const auto& vector : kernel_basis(s.where, kernel)) {
    all.emplace_back(s.space->variables.size(), MFraction(s.space->field.ring));
    for (const auto& [j, c] : vector)
      all.back()[j / numerators.size()] += c * MFraction(numerators[j % numerators.size()]) / below;
  }
  return all;
}

} // namespace kov
