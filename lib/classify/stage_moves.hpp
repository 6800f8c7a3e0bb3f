#pragma once
// Stages of the strategy: theorems about the whole family, before it is studied along solutions.
//
// Source  docs/theory/moves.md

#include "classify/stage.hpp"

namespace kov::stages {

/// A free body with three different moments, perturbed: its separatrices split.
[[nodiscard]] std::vector<Task> splitting(const Board& b, const Round& round);
void study_splitting(Board& b, Round& round, const Task& task, const Budget& budget);

/// A rotation takes most parameters to some at which one of them is 0: only these are studied.
[[nodiscard]] std::vector<Task> frames(const Board& b, const Round& round);
void choose_frame(Board& b, Round& round, const Task& task, const Budget& budget);

/// Lowest parts of integrals are integrals of the system of the lowest part of H, which is classified.
[[nodiscard]] std::vector<Task> leading(const Board& b, const Round& round);
void study_leading(Board& b, Round& round, const Task& task, const Budget& budget);
/// Highest parts of rational integrals are integrals of the system of the highest part of H: for what is left.
[[nodiscard]] std::vector<Task> highest(const Board& b, const Round& round);
void study_highest(Board& b, Round& round, const Task& task, const Budget& budget);

} // namespace kov::stages
