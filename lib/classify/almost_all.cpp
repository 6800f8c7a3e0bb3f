#include "classify/almost_all.hpp"

#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "exact/share.hpp"
#include "exact/tried.hpp"
#include "integrability/parameters.hpp"
#include "integrability/specialise.hpp"
#include "manifold/invariant_manifold.hpp"
#include "study/curve.hpp"
#include "study/exclusion.hpp"
#include "variation/normal.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr int most_points = 2;
constexpr std::size_t most_solutions = 4; // they are ranked

// Different numbers, the same each time.
Substitution point(const System& s, const std::vector<std::size_t>& levels, int attempt) {
  constexpr long numbers[] = {2, 3, 5, 7, 11, 13, 17, 19};
  Substitution values;
  std::size_t k = static_cast<std::size_t>(attempt);
  for (const std::size_t i : s.field.parameters)
    if (!is_among(i, levels))
      values[i] = MFraction(s.ring(), Rational(numbers[k++ % std::size(numbers)]));
  return values;
}

// The point and its neighbours satisfy the assumptions: they are inequalities that hold there.
bool is_inside(const System& s, const Substitution& values) {
  return std::ranges::all_of(s.assumptions, [&](const Assumption& a) {
    if (!a.value.ring() || a.is(Sort::real)) return true;
    const MFraction there = substitute(a.value, values);
    return is_constant(there) && a.holds_near(to_rational(there));
  });
}

// The differentials of the equations and the levels are independent on the curve but for points:
// with the parameters it moves, by the implicit function theorem.
bool is_transverse(const System& s, const InvariantManifold& m) {
  const auto& main = m.curve->main();
  for (const std::size_t i :
       s.field.coordinates) // time is left out as it is not a function on the curve
    if (!is_among(i, main)) return false;
  Matrix rows;
  std::vector<MPoly> divisors;
  for (const auto* equations : {&m.equations, &m.levels})
    for (const Equation& e : *equations) {
      const auto row = restricted_gradient(s.field, m, e.difference);
      if (!combination(m, rows, row, divisors)) rows.push_back(row);
    }
  return rows.size() + 1 == s.field.dimension();
}

std::string text_of(const System& s, const Substitution& values) {
  return joined(
      values, [&](const auto& x) { return s.ring()->name(x.first) + " = " + to_string(x.second); });
}

std::optional<AlmostAll> at_point(const System& s, const ManifoldSpec& solution,
                                  const std::vector<ClaimReport>& claims,
                                  const Substitution& values, const CheckOptions& options) {
  const auto in_general = prove_invariant(s.field, solution, options.decide.budget);
  if (!std::holds_alternative<InvariantManifold>(in_general)) return std::nullopt;
  const System there = at_values(s, values);
  const ManifoldReport report =
      study_curve(there, at_values(solution, values), at_values(claims, values), options);
  if (!report.matrices || !report.manifold || !is_transverse(there, *report.manifold))
    return std::nullopt;
  auto found = exclusions_of_verdict(there, report, level_parameters(there));
  if (found.empty()) return std::nullopt;
  return AlmostAll{text_of(s, values), std::move(found.front().by)};
}

} // namespace

std::optional<AlmostAll> almost_all(const System& s, const std::vector<ManifoldSpec>& solutions,
                                    const std::vector<ClaimReport>& claims,
                                    const std::vector<std::size_t>& levels,
                                    const CheckOptions& options) {
  for (int attempt = 0; attempt < most_points; ++attempt) {
    const Substitution numbers = point(s, levels, attempt);
    if (numbers.empty()) return std::nullopt;
    const Substitution values = with_functions(s, numbers);
    for (std::size_t k = 0; k < std::min(solutions.size(), most_solutions); ++k)
      try {
        CheckOptions share = options;
        share.decide.budget = part_of_the_work(options.decide.budget, 0.4);
        auto found = tried<DomainError, InvalidArgument>([&] { // something has no value there
          return is_inside(s, values) ? at_point(s, solutions[k], claims, values, share)
                                      : std::nullopt;
        });
        if (found) return found;
      } catch (const OutOfBudget&) { // what was not computed says nothing
        return std::nullopt;
      }
  }
  return std::nullopt;
}

} // namespace kov
