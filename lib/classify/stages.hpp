#pragma once
// The stages of the strategy: for each the tasks that it has in a round, and what does one of them.
//
// Source  docs/theory/moves.md

#include "classify/stage.hpp"

namespace kov::stages {

using Tasks = std::vector<Task>(const Board& b, const Round& round);
using Run = void(Board& b, Round& round, const Task& task, const Budget& budget);

// Theorems about the whole family, before it is studied along solutions

/// A free body with three different moments, perturbed: its separatrices split.
Tasks splitting;
Run study_splitting;
/// A rotation takes most parameters to some at which one of them is 0: only these are studied.
Tasks frames;
Run choose_frame;
/// Lowest parts of integrals are integrals of the system of the lowest part of H, which is classified.
Tasks leading;
Run study_leading;
/// Highest parts of rational integrals are integrals of the system of the highest part of H: for what is left.
Tasks highest;
Run study_highest;

// Particular solutions, and the variational equations along them

/// The results of `check` for the file's manifolds.
Tasks stated;
Run take_stated;
/// If little work is enough for all parameters the answer is one for all of them.  Otherwise a
/// rescaling leaves fewer parameters, and what is excluded does not cut them along many sets.
Tasks one_answer;
Run try_one_answer;
Tasks search;
Run find_solutions;
/// found: in the last round only those whose share was too small: the others have said what they can.
Tasks found, at_energy_zero, at_all_levels;
Run study_along;
/// The sets where two conditions hold together at finitely many values of a difference only.
Tasks conditions, conditions_on_one;
Run meet_conditions;

// Points of a potential, faces of exponentials, and higher orders

/// first: beside many parameters solutions cost much, and Darboux points leave few of their values.
Tasks darboux_points, darboux_points_first;
Run study_darboux_points;
Tasks faces;
Run study_faces;
Tasks higher_orders;
Run study_higher_orders;
/// Exclusions with exceptions that take long to write down.
Tasks exceptions;
Run tell_exceptions;

// First integrals on what is open

/// Integrals of low degree: where they are enough no particular solution needs to be studied.
Tasks low_integrals;
Run find_low_integrals;
Tasks integrals;
Run find_integrals;
/// With coefficients as large as the potential asks for.
Tasks larger_integrals;
Run find_larger_integrals;
/// At single points of the parameters, at last.
Tasks high_integrals;
Run find_high_integrals;
/// With one option larger than asked for, at last.  All of these together do no more than ten times the work
/// that was done before, and a second or two.
Tasks further_integrals;
Run find_further_integrals;
/// Everything is excluded: integrals of low degree would say that something is wrong.
Tasks contradictions;
Run look_for_a_contradiction;

} // namespace kov::stages
