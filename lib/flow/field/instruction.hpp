#pragma once
// One instruction of the machine (machine.hpp); made by compile (program.hpp).

#include <cstddef>
#include <cstdint>

namespace kov::flow {

inline constexpr std::size_t group = 4;

struct Instruction {
  enum class Op : std::uint8_t { products, squares, sum, scaled, quotient, root, copy, power };
  Op op = Op::sum;
  std::uint8_t count = 1; ///< products, squares: how many
  std::uint32_t out[group]{}, a[group]{}, b[group]{};
  ///< registers; sum: a[0] first term, b[0] end of the terms, a[1] the number that is added at order 0 (or none);
  ///< if b[1] > b[0], order 0 is a[2] times the terms from b[0] on, those from b[2] on after a[1];
  ///< scaled: a number a[0] times the series b[0]; quotient: out[1] keeps 1/b_0; root: of the series a[0], out[1]
  ///< keeps 1/(2 r_0); power: out[0] = r^exponent for
  ///< r = sqrt(a), a[0] the series a, b[0] that of r, of which order 0 is read, out[1] keeps 1/r_0^2, out[2] k p_k; numbers
  ///< a[1] = exponent/2 and a[2] = a[1] + 1; root and copy leave the coefficient of order 0 as it is
  int exponent = 0; ///< power
  static constexpr std::uint32_t none = ~0U;
  /// Is a[n] a register?
  [[nodiscard]] bool is_register(std::size_t n) const {
    return op != Op::sum && (op != Op::power || n == 0);
  }
};

struct SumTerm {
  std::uint32_t reg = 0, number = 0;
};

} // namespace kov::flow
