#pragma once
// Stages of the strategy: first integrals on what is open.

#include "classify/stage.hpp"

namespace kov::stages {

[[nodiscard]] std::vector<Task> low_integrals(const Board& b, const Round& round);
[[nodiscard]] std::vector<Task> integrals(const Board& b, const Round& round);
[[nodiscard]] std::vector<Task> larger_integrals(const Board& b, const Round& round);
[[nodiscard]] std::vector<Task> high_integrals(const Board& b, const Round& round);
/// With one option larger than asked for, at last.
[[nodiscard]] std::vector<Task> further_integrals(const Board& b, const Round& round);
/// Everything is excluded: integrals of low degree would say that something is wrong.
[[nodiscard]] std::vector<Task> contradictions(const Board& b, const Round& round);

/// Integrals of low degree: where they are enough no particular solution needs to be studied.
void find_low_integrals(Board& b, Round& round, const Task& task, const Budget& budget);
void find_integrals(Board& b, Round& round, const Task& task, const Budget& budget);
/// With coefficients as large as the potential asks for.
void find_larger_integrals(Board& b, Round& round, const Task& task, const Budget& budget);
/// At single points of the parameters, at last.
void find_high_integrals(Board& b, Round& round, const Task& task, const Budget& budget);
/// All of these together do no more than ten times the work that was done before, and a second or two.
void find_further_integrals(Board& b, Round& round, const Task& task, const Budget& budget);
void look_for_a_contradiction(Board& b, Round& round, const Task& task, const Budget& budget);

} // namespace kov::stages
