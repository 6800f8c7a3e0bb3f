#include "classify/stage_moves.hpp"

#include "moves/splitting.hpp"

#include <algorithm>

namespace kov::stages {
namespace {

// Each piece satisfies more equations than the round: there the system is a special one, and is better
// studied by itself.
bool has_only_special_values(const Round& round) {
  const std::size_t equations = round.whole.where.equations().size();
  return std::all_of(round.pieces.begin(), round.pieces.end(), [&](const Piece& p) {
    return p.special.empty() && p.where.equations().size() > equations;
  });
}

} // namespace

std::vector<Task> splitting(const Board& b, const Round& round) {
  return one_if(!round.pieces.empty() && b.options.search_solutions && !round.last &&
                    free_body(round.system),
                "splitting of separatrices");
}

void study_splitting(Board& b, Round& round, const Task& task, const Budget& budget) {
  if (const auto found = find_splitting(round.system, budget)) {
    exclude(b, round, exclusion(round.system, *found));
    round.only_special_values = has_only_special_values(round);
  } else {
    note(round, task.name, "the criterion says nothing for all directions");
  }
}

} // namespace kov::stages
