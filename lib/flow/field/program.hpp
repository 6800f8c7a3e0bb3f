#pragma once
// A graph as a list of instructions for a machine whose registers are series (machine.hpp).
//
// Every node that is needed has a register.  What is fixed is computed once; the rest for every order, level by
// level: a node's level is one more than that of what it is made of, so that the products of one level are
// independent of each other.  Up to four of them are one instruction: the machine sums them in one loop, and the
// processor works on all of them at once.

#include "flow/field/graph.hpp"
#include "flow/field/instruction.hpp"

namespace kov::flow {

struct Program {
  std::vector<Instruction> once, each;
  std::vector<SumTerm> terms;
  std::vector<Rational> numbers;
  std::vector<std::uint32_t> outputs; ///< the registers of the roots
};

/// Which node has which register; several programs may share one, and then the later ones use what the earlier
/// ones have computed.
class Registers {
public:
  /// The variables `inputs` (indices of the ring) get the registers 0, 1, ...
  explicit Registers(std::vector<std::size_t> inputs);
  [[nodiscard]] std::uint32_t count() const noexcept { return count_; }
  [[nodiscard]] const std::vector<std::size_t>& inputs() const noexcept { return inputs_; }
  /// The register of a variable.  Errors  InvalidArgument
  [[nodiscard]] std::uint32_t input(std::size_t variable) const;
  /// For inputs, the registers of their low parts, beyond their digits: x is the sum of both.
  [[nodiscard]] const std::map<std::uint32_t, std::uint32_t>& low() const noexcept {
    return low_of_;
  }

private:
  friend class Compiler;
  std::vector<std::size_t> inputs_;
  std::map<std::size_t, std::uint32_t> input_of_;
  std::map<NodeId, std::uint32_t> of_;
  std::map<std::uint32_t, std::uint32_t> inverse_of_;  ///< of a quotient: the register of 1/b_0
  std::map<std::uint32_t, std::uint32_t> weighted_of_; ///< of a power p: that of k p_k
  std::map<std::uint32_t, std::uint32_t> low_of_;
  std::uint32_t count_ = 0;
};

/// The instructions that compute the roots from what has registers.  series: a variable with a rule is computed, too, and
/// differences that become small (Graph::is_difference) with all digits of their variables; at a point both are given.
[[nodiscard]] Program compile(const Graph& g, const std::vector<NodeId>& roots,
                              Registers& registers, bool series = false);
/// The instructions that compute the series of the roots from the inputs alone.
[[nodiscard]] Program compile_again(const Graph& g, const std::vector<NodeId>& roots,
                                    Registers& registers);

} // namespace kov::flow
