#pragma once
// The formulas of a system as its file writes them.
//
// A rational function in lowest terms has forgotten how it was written: the Hamiltonian of the double pendulum, one
// quotient of two short lines, has hundreds of terms there.  So the trees of the formulas become nodes of a graph,
// names of definitions the nodes of what they stand for, and the graph knows of which function each of them is.

#include "flow/field/graph.hpp"
#include "system/read_system.hpp"

namespace kov::flow {

class Written {
public:
  /// The definitions, the Hamiltonian and the field of this document, which `scope` and `s` have been read from.
  /// All of them must outlive this.
  Written(const Entry& document, const SystemScope& scope, const System& s);
  /// One more formula, which has this value.
  void add(const Expression& e, const MFraction& value);
  /// Makes those nodes of these functions.
  [[nodiscard]] const Graph& graph() const noexcept { return graph_; }

private:
  NodeId of(const Expression& e);
  NodeId of_name(const Expression& e);
  NodeId of_power(const Expression& e);

  const SystemScope& scope_;
  Graph graph_;
  std::map<std::string, Expression> definitions_;
  std::map<std::string, NodeId> defined_;
};

} // namespace kov::flow
