#pragma once
// Stages of the strategy: points of a potential, faces of exponentials, and higher orders.

#include "classify/stage.hpp"

namespace kov::stages {

/// Beside many parameters solutions cost much, and Darboux points leave few of their values: then
/// these come first.
[[nodiscard]] std::vector<Task> darboux_points_first(const Board& b, const Round& round);
[[nodiscard]] std::vector<Task> darboux_points(const Board& b, const Round& round);
void study_darboux_points(Board& b, Round& round, const Task& task, const Budget& budget);

[[nodiscard]] std::vector<Task> faces(const Board& b, const Round& round);
void study_faces(Board& b, Round& round, const Task& task, const Budget& budget);

[[nodiscard]] std::vector<Task> higher_orders(const Board& b, const Round& round);
void study_higher_orders(Board& b, Round& round, const Task& task, const Budget& budget);

/// Exclusions with exceptions that take long to write down.
[[nodiscard]] std::vector<Task> exceptions(const Board& b, const Round& round);
void tell_exceptions(Board& b, Round& round, const Task& task, const Budget& budget);

} // namespace kov::stages
