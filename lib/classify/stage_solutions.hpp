#pragma once
// Stages of the strategy: particular solutions, and the variational equations along them.

#include "classify/stage.hpp"

namespace kov::stages {

/// The results of `check` for the file's manifolds.
[[nodiscard]] std::vector<Task> stated(const Board& b, const Round& round);
void take_stated(Board& b, Round& round, const Task& task, const Budget& budget);

/// If little work is enough for all parameters the answer is one for all of them.  Otherwise a
/// rescaling leaves fewer parameters, and what is excluded does not cut them along many sets.
[[nodiscard]] std::vector<Task> one_answer(const Board& b, const Round& round);
void try_one_answer(Board& b, Round& round, const Task& task, const Budget& budget);

[[nodiscard]] std::vector<Task> search(const Board& b, const Round& round);
void find_solutions(Board& b, Round& round, const Task& task, const Budget& budget);

/// In the last round only those whose share was too small: the others have said what they can.
[[nodiscard]] std::vector<Task> found(const Board& b, const Round& round);
[[nodiscard]] std::vector<Task> at_energy_zero(const Board& b, const Round& round);
[[nodiscard]] std::vector<Task> at_all_levels(const Board& b, const Round& round);
void study_along(Board& b, Round& round, const Task& task, const Budget& budget);

/// The sets where two conditions hold together at finitely many values of a difference only.
[[nodiscard]] std::vector<Task> conditions(const Board& b, const Round& round);
[[nodiscard]] std::vector<Task> conditions_on_one(const Board& b, const Round& round);
void meet_conditions(Board& b, Round& round, const Task& task, const Budget& budget);

} // namespace kov::stages
