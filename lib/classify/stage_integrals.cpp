#include "classify/stages.hpp"

#include "classify/growth.hpp"
#include "classify/take_integrals.hpp"
#include "exact/lists.hpp"
#include "exact/share.hpp"
#include "exact/tried.hpp"
#include "integrability/parameters.hpp"

#include <algorithm>

namespace kov::stages {
namespace {

constexpr long low_degree = 2;        // of the integrals that are looked for first
constexpr double at_once = 0.01;      // of the work of that search: for the full degree
constexpr long most_coefficients = 8; // the degree of their coefficients

// The work of all searches with one larger option: a multiple of what was done before, and units, or half of that
// work.
constexpr double times_the_work = 10, least_further = 3e7, most_further = 3e8;
constexpr long far_coefficients = 12;

// Darboux: logarithms come after the solutions, as they do not contradict what these exclude.
IntegralSearch search(const System& s, IntegralOptions options, bool with_darboux,
                      const Budget& budget) {
  options.until_integrable = true;
  options.budget = budget;
  options.darboux = with_darboux;
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
  std::vector<Undecided> met;
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

struct FurtherSearch {
  const char* name;
  IntegralOptions options;
};
std::vector<FurtherSearch> further_searches(const Board& b, const Round& round) {
  const long degree = is_at_numbers(round) ? b.options.degree : low_degree;
  return {
      {"integrals over the square of the denominator", {.degree = b.options.degree, .power = 2}},
      {"integrals with large coefficients", {.degree = degree, .coefficients = far_coefficients}},
      {"integrals of a higher degree", {.degree = b.options.degree_at_points}}};
}

// Other functions than the usual options do.
bool looks_further(const Board& b, const Round& round, const IntegralOptions& options) {
  const IntegralOptions usual{.degree = b.options.degree};
  if (options.coefficients && is_bounded_by_a_theorem(round.system, usual)) return false;
  return searched_class(round.system, options) != searched_class(round.system, usual);
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
std::vector<Task> further_integrals(const Board& b, const Round& round) {
  std::vector<Task> tasks;
  const bool may_go_further = b.options.degree < b.options.degree_at_points && !round.last;
  if (may_go_further && !round.pieces.empty())
    for (const FurtherSearch& further : further_searches(b, round))
      if (further.options.degree <= b.options.degree || high_integrals(b, round).empty())
        tasks.push_back({further.name});
  return tasks;
}
std::vector<Task> contradictions(const Board& b, const Round& round) {
  return one_if((round.pieces.empty() || round.only_special_values) && !round.integrals_known &&
                    b.result.strata.size() > round.decided,
                "integrals that would contradict");
}

// Without parameters there is one linear system for each degree: those of full degree, too, are often found at once.
IntegralSearch search_first(const Board& b, const Round& round, const Budget& budget) {
  if (is_at_numbers(round)) {
    const bool fields = !round.system.field.poisson.has_value();
    auto all = search(round.system, {.degree = b.options.degree}, fields,
                      part_of_the_work(budget, at_once));
    if (all.finished()) return all;
  }
  return search(round.system, {.degree = std::min(b.options.degree, low_degree)}, false, budget);
}

// Integrals known at all parameters of a piece that do not suffice.
void keep_what_was_found(const Round& round, const IntegralSearch& found, Undecided& piece) {
  const auto holds = [&](const IntegralsOfSet& set) {
    return std::ranges::all_of(set.equations,
                               [&](const MPoly& f) { return piece.where.vanishes(f); }) &&
           std::ranges::all_of(set.inequations,
                               [&](const MPoly& f) { return piece.where.is_nonzero(f); });
  };
  const bool is_covered = std::ranges::all_of(
      found.not_covered, [&](const MPoly& f) { return piece.where.is_nonzero(f); });
  if (is_covered)
    for (const IntegralsOfSet& set : found.sets)
      if (holds(set)) keep_integrals(round.system, set, piece);
}

void find_low_integrals(Board& b, Round& round, const Task& /*task*/, const Budget& budget) {
  IntegralSearch found = search_first(b, round, budget);
  common_equations_first(round.system, found.sets);
  std::vector<Undecided> none;
  for (const IntegralsOfSet& set : found.sets)
    if (is_enough(round.system, set)) take_integrals(b, round, set, found.not_covered, none);
  std::move(none.begin(), none.end(), std::back_inserter(round.pieces));
  if (found.elsewhere && is_enough(round.system, *found.elsewhere))
    take_elsewhere(b, round, *found.elsewhere, found.not_covered);
  for (Undecided& piece : round.pieces) // else they are told by nobody
    tried<OutOfBudget>([&] { keep_what_was_found(round, found, piece); });
}

void find_integrals(Board& b, Round& round, const Task& /*task*/, const Budget& budget) {
  IntegralSearch found = search(round.system, {.degree = b.options.degree}, true, budget);
  round.integrals_known = found.finished();
  round.integrals_unless = found.not_covered;
  take(b, round, std::move(found), true);
}

void find_larger_integrals(Board& b, Round& round, const Task& /*task*/, const Budget& budget) {
  IntegralSearch found = search(
      round.system, {.degree = b.options.degree, .coefficients = larger(b, round)}, true, budget);
  if (!found.finished()) round.limited = true; // once more, with more work
  round.integrals_known = found.finished();
  round.integrals_unless = found.not_covered;
  take(b, round, std::move(found), true);
}

void find_high_integrals(Board& b, Round& round, const Task& /*task*/, const Budget& budget) {
  IntegralSearch found = search(round.system, {.degree = b.options.degree_at_points}, true, budget);
  round.integrals_known = found.finished();
  round.integrals_unless = found.not_covered;
  const bool finished = found.finished();
  take(b, round, std::move(found), finished);
}

void find_further_integrals(Board& b, Round& round, const Task& task, const Budget& budget) {
  const auto all = further_searches(b, round);
  const auto& further = *std::ranges::find(all, task.name, &FurtherSearch::name);
  if (!looks_further(b, round, further.options)) return;
  const bool is_wider = further.options.degree > b.options.degree;
  const double begin = meter();
  const double before = begin - b.begin;
  if (!b.further)
    b.further =
        std::clamp(times_the_work * before, least_further, std::max(most_further, before / 2));
  IntegralSearch found =
      search(round.system, further.options, true, at_most(budget, *b.further / (is_wider ? 1 : 2)));
  *b.further -= meter() - begin;
  const bool finished = found.finished();
  take(b, round, std::move(found), finished && is_wider);
  if (finished && !is_wider) note(round, task.name, "nothing that decides");
}

void look_for_a_contradiction(Board& b, Round& round, const Task& /*task*/, const Budget& budget) {
  for (const IntegralsOfSet& set :
       search(round.system, {.degree = std::min(b.options.degree, low_degree)}, false, budget).sets)
    if (is_enough(round.system, set))
      contradict_nothing(b, round, conditions_of(round.system, set, {}), set);
}

} // namespace kov::stages
