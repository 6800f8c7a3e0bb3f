#pragma once
// A NODE proves that a set has no point, or that a condition holds at each of its points:
// theorem_certificates.md 2.

#include "proof/condition/set.hpp"

#include <functional>

namespace kov::certify {

/// Reads NODEs.  Requires that the set and the number stay alive.
class SetProof {
public:
  /// Takes nodes of other kinds, with the set of their points.
  using Part = std::function<void(const Node&, ConditionSet&)>;

  /// set: with more conditions in between, not copied for each node.
  SetProof(ConditionSet& set, std::size_t& nodes_left) : set_(set), left_(nodes_left) {}

  /// Refuses a node that does not prove that there is no point.
  void absent(const Node& n, const Part& part = {}) { absent(n, part, max_depth); }
  /// The same for the points at which the condition does not hold: so it holds at each point.
  void show(const Condition& c, const Node& n);
  /// Not all of these are 0.
  void show_some(const std::vector<MPoly>& all, const Node& n);

private:
  void absent(const Node& n, const Part& part, int depth);
  void absent_with(Condition more, const Node& n, const Part& part, int depth);
  void contradiction(const Node& n);
  [[nodiscard]] SignTerm term(const Node& n) const;

  static constexpr int max_depth = 64;

  ConditionSet& set_;
  std::size_t& left_;
};

} // namespace kov::certify
