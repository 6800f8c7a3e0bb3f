#include "classify/stage_integrals.hpp"

#include "classify/growth.hpp"
#include "classify/take_integrals.hpp"
#include "exact/lists.hpp"
#include "integrability/parameters.hpp"

#include <algorithm>

namespace kov::stages {
namespace {

constexpr long low_degree = 2;        // of the integrals that are looked for first
constexpr double at_once = 0.01;      // of the work of that search: for the full degree
constexpr long most_coefficients = 8; // the degree of their coefficients

// Darboux: logarithms come after the solutions, as they do not contradict what these exclude.
IntegralSearch search(const System& s, long degree, bool with_darboux, const Budget& budget,
                      std::optional<long> coefficients = {}) {
  IntegralOptions options;
  options.degree = degree;
  options.until_integrable = true;
  options.budget = budget;
  options.darboux = with_darboux;
  options.coefficients = coefficients;
  return kov::find_integrals(s, options);
}

// Sets without integrals cut no pieces, also where a limit has kept them apart.
void note_what_is_open(Round& round, const IntegralSearch& search) {
  const auto nothing = [](const IntegralsOfSet& set) { return set.found() == 0; };
  const auto empty = std::find_if(search.sets.rbegin(), search.sets.rend(), nothing);
  if (search.elsewhere || empty == search.sets.rend()) return;
  const auto limited = std::find_if(search.sets.rbegin(), search.sets.rend(),
                                    [&](const auto& s) { return nothing(s) && !s.open.empty(); });
  note(round, "first integrals", searched_text(limited == search.sets.rend() ? *empty : *limited));
}

void take(Board& b, Round& round, IntegralSearch search, bool is_the_last_word) {
  common_equations_first(round.system, search.sets);
  std::vector<Piece> met;
  for (const IntegralsOfSet& set : search.sets)
    if (set.found() > 0 || is_enough(round.system, set))
      take_integrals(b, round, set, search.not_covered, met);
  const bool finds = search.elsewhere && is_enough(round.system, *search.elsewhere);
  if (search.elsewhere && (is_the_last_word || finds))
    take_elsewhere(b, round, *search.elsewhere, search.not_covered);
  if (is_the_last_word) note_what_is_open(round, search);
  std::move(met.begin(), met.end(), std::back_inserter(round.pieces));
}

// Each parameter has finitely many values.
bool is_at_a_point(const Round& round) {
  const auto levels = level_parameters(round.system);
  const auto equations = round.whole.where.equations();
  const auto& all = round.system.field.parameters;
  return std::ranges::all_of(all, [&](std::size_t t) {
    return is_among(t, levels) || std::ranges::any_of(equations, [&](const MPoly& f) {
             return used_variables(f) == std::vector{t};
           });
  });
}

std::optional<long> larger(const Board& b, const Round& round) {
  return larger_coefficients(round.system, b.options.degree, most_coefficients);
}

} // namespace

std::vector<Task> low_integrals(const Board& /*b*/, const Round& round) {
  return one_if(!round.pieces.empty() && !round.integrals_known, "integrals of low degree");
}
std::vector<Task> integrals(const Board& /*b*/, const Round& round) {
  return one_if(!round.pieces.empty() && !round.integrals_known, "integrals");
}
std::vector<Task> larger_integrals(const Board& b, const Round& round) {
  return one_if(!round.pieces.empty() && is_small(round) && larger(b, round), "larger integrals");
}
std::vector<Task> high_integrals(const Board& b, const Round& round) {
  return one_if(!round.pieces.empty() && b.options.degree < b.options.degree_at_points &&
                    is_small(round) && is_at_a_point(round),
                "integrals of high degree");
}
std::vector<Task> contradictions(const Board& b, const Round& round) {
  return one_if((round.pieces.empty() || round.only_special_values) && !round.integrals_known &&
                    b.result.strata.size() > round.decided,
                "integrals that would contradict");
}

// Without parameters there is one linear system for each degree: those of full degree, too, are often found at once.
IntegralSearch search_first(const Board& b, const Round& round, const Budget& budget) {
  if (is_at_numbers(round)) {
    auto all = search(round.system, b.options.degree, false, part_of_the_work(budget, at_once));
    if (all.finished() && !all.sets.empty() && is_enough(round.system, all.sets.front()))
      return all;
  }
  return search(round.system, std::min(b.options.degree, low_degree), false, budget);
}

void find_low_integrals(Board& b, Round& round, const Task& /*task*/, const Budget& budget) {
  IntegralSearch found = search_first(b, round, budget);
  common_equations_first(round.system, found.sets);
  std::vector<Piece> none;
  for (const IntegralsOfSet& set : found.sets)
    if (is_enough(round.system, set)) take_integrals(b, round, set, found.not_covered, none);
  std::move(none.begin(), none.end(), std::back_inserter(round.pieces));
  if (found.elsewhere && is_enough(round.system, *found.elsewhere))
    take_elsewhere(b, round, *found.elsewhere, found.not_covered);
}

void find_integrals(Board& b, Round& round, const Task& /*task*/, const Budget& budget) {
  IntegralSearch found = search(round.system, b.options.degree, true, budget);
  round.integrals_known = found.finished();
  round.integrals_unless = found.not_covered;
  take(b, round, std::move(found), true);
}

void find_larger_integrals(Board& b, Round& round, const Task& /*task*/, const Budget& budget) {
  IntegralSearch found = search(round.system, b.options.degree, true, budget, larger(b, round));
  if (!found.finished()) round.limited = true; // once more, with more work
  round.integrals_known = found.finished();
  round.integrals_unless = found.not_covered;
  take(b, round, std::move(found), true);
}

void find_high_integrals(Board& b, Round& round, const Task& /*task*/, const Budget& budget) {
  IntegralSearch found = search(round.system, b.options.degree_at_points, true, budget);
  round.integrals_known = found.finished();
  round.integrals_unless = found.not_covered;
  const bool finished = found.finished();
  take(b, round, std::move(found), finished);
}

void look_for_a_contradiction(Board& b, Round& round, const Task& /*task*/, const Budget& budget) {
  for (const IntegralsOfSet& set :
       search(round.system, std::min(b.options.degree, low_degree), false, budget).sets)
    if (is_enough(round.system, set))
      contradict_nothing(b, round, conditions_of(round.system, set, {}), set);
}

} // namespace kov::stages
