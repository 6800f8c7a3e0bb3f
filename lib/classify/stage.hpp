#pragma once
// The search as a list: what is tried on an open set, in this order, and for which part of the work.
//
// Source  docs/theory/classify.md (7)

#include "classify/board.hpp"

#include <span>

namespace kov {

struct Task {
  std::string name;
  std::optional<ManifoldSpec> along = {};
};

/// A stage with one task, if it applies.
[[nodiscard]] inline std::vector<Task> one_if(bool applies, const char* name) {
  return applies ? std::vector<Task>{{name}} : std::vector<Task>{};
}

struct Stage {
  const char* name;
  /// Share of the round's remaining work for all tasks of this stage; 0 for a stage that only
  /// collects known results.
  double part;
  double at_last; ///< the same in a last round, which has all the work that is left
  std::vector<Task> (*tasks)(const Board&, const Round&); ///< none: it does not apply
  void (*run)(Board&, Round&, const Task&, const Budget&);
};
/// A step of the whole study (the rounds, and what lies before, between and after them), with its
/// part of all work that is left.
struct PartOfTheWhole {
  const char* name;
  double part;
};
[[nodiscard]] std::span<const PartOfTheWhole> parts_of_the_whole();

/// The stages of one round: a system on the sets of its parameters that are open.
[[nodiscard]] std::span<const Stage> strategy();

} // namespace kov
