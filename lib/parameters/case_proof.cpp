#include "parameters/case_proof.hpp"

#include "proof/algebra/arithmetic.hpp"

#include <algorithm>

namespace kov {
namespace {

bool is_unit_condition(const Condition& c) {
  return certify::excludes_zero(c.sign) && !is_zero(c.p);
}

/// base = ratio (condition)
struct KnownUnit {
  std::size_t condition = 0;
  Rational ratio;
};
std::optional<KnownUnit> known_unit(const std::vector<Condition>& given, const MPoly& base) {
  for (std::size_t i = 0; i < given.size(); ++i) {
    const MPoly& p = given[i].p;
    if (!is_unit_condition(given[i]) || p.length() != base.length()) continue;
    const Rational ratio(base.coefficient(0), p.coefficient(0));
    if (certify::scaled(base, ratio.den()) == certify::scaled(p, ratio.num()))
      return KnownUnit{i, ratio};
  }
  return std::nullopt;
}

bool is_equation(const std::vector<Condition>& given, const MPoly& f) {
  return std::ranges::any_of(
      given, [&](const Condition& c) { return c.sign == Sign::zero && (c.p == f || c.p == -f); });
}

} // namespace

// content prod base^e = 0, base = ratio (condition): prod (condition)^e is a multiple of the equation.
Json CaseProof::product(const Conditions& given, std::size_t i) {
  const auto [content, factors] = factor(given[i].p);
  Rational scale(content);
  std::vector<Json> powers;
  for (const MFactor& f : factors) {
    const KnownUnit unit = *known_unit(given, f.base);
    for (long e = 0; e < f.exponent; ++e)
      scale = scale * unit.ratio;
    powers.push_back(json_list(
        {json_text(std::to_string(unit.condition)), json_text(std::to_string(f.exponent))}));
  }
  const Rational by = Rational(-1) / scale; // prod (condition)^e + by f = 0
  std::vector<Json> term{json_text(to_string(by.den())), json_text("1")};
  term.insert(term.end(), powers.begin(), powers.end());
  return Json{Json::Object{{"node", json_text("empty")},
                           {"terms", json_list({json_list(std::move(term))})},
                           {"zeros", json_list({json_list({json_text(std::to_string(i)),
                                                           json_text(to_string(by.num()))})})}}};
}

// The one with the fewest factors of which nothing is known, if one of them is news.
std::optional<CaseProof::Equation> CaseProof::best(const Conditions& given) const {
  std::optional<Equation> found;
  const auto look = [&](const MPoly& f, std::optional<std::size_t> condition) {
    if (is_zero(f) || (found && found->unknown.empty())) return;
    Equation e{f, condition, {}};
    for (const MFactor& x : factor(f).second)
      if (!known_unit(given, x.base)) {
        if (is_equation(given, x.base)) return;
        e.unknown.push_back(x.base);
      }
    if (!found || e.unknown.size() < found->unknown.size()) found = std::move(e);
  };
  for (std::size_t i = 0; i < given.size(); ++i)
    if (given[i].sign == Sign::zero) look(given[i].p, i);
  if (found && found->unknown.size() <= 1) return found;
  for (const MPoly& f : proof_.consequences(given))
    look(certify::primitive(f), std::nullopt);
  return found;
}

std::optional<Json> CaseProof::by_cases(const Conditions& given, int depth) const {
  if (const auto e = best(given); e && depth > 0) return along(*e, given, depth);
  return proof_.contradiction(given);
}

std::optional<Json> CaseProof::along(const Equation& e, Conditions given, int depth) const {
  if (e.condition) return factors_of(e, 0, std::move(given), depth);
  auto otherwise = given;
  otherwise.push_back({e.f, Sign::nonzero});
  auto nonzero = proof_.contradiction(otherwise);
  if (!nonzero) return std::nullopt;
  given.push_back({e.f, Sign::zero});
  auto zero = factors_of({e.f, given.size() - 1, e.unknown}, 0, given, depth);
  if (!zero) return std::nullopt;
  return json_zero_node(e.f, *std::move(nonzero), *std::move(zero));
}

std::optional<Json> CaseProof::factors_of(const Equation& e, std::size_t next, Conditions given,
                                          int depth) const {
  if (next == e.unknown.size()) return product(given, *e.condition);
  const MPoly& base = e.unknown[next];
  auto here = given;
  here.push_back({base, Sign::zero});
  auto zero = by_cases(here, depth - 1);
  if (!zero) return std::nullopt;
  given.push_back({base, Sign::nonzero});
  auto nonzero = factors_of(e, next + 1, std::move(given), depth);
  if (!nonzero) return std::nullopt;
  return json_zero_node(base, *std::move(nonzero), *std::move(zero));
}

std::optional<Json> CaseProof::shown(Conditions given, const MPoly& f, Sign sign) const {
  const bool nowhere = sign == Sign::nonzero;
  given.push_back({f, nowhere ? Sign::zero : Sign::nonzero});
  return nowhere && !is_constant(f) ? refutation(given) : proof_.contradiction(given);
}

} // namespace kov
