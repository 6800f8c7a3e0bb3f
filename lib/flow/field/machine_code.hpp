#pragma once
// A Tape as code of the processor: what run_order does, without a decision for each instruction and order.
//
// The low orders are straight code; of the others the products of one level are one loop, as many as there are registers
// for.  A factor that several of them share is loaded once.  Every number is rounded as by the machine (machine.hpp): the results are the same to
// the last bit.
//
// There is such code where the processor has AVX2 and FMA, or AVX-512, and the system lets a program write code (Linux on
// x86-64); elsewhere the machine does the work.

#include "flow/field/machine.hpp"

#include <utility>
#include <vector>

namespace kov::flow {

class MachineCode {
public:
  MachineCode() = default; ///< none
  MachineCode(MachineCode&& o) noexcept { swap(o); }
  MachineCode& operator=(MachineCode&& o) noexcept {
    swap(o);
    return *this;
  }
  ~MachineCode();
  /// Places of variables, and of their derivatives.
  using Moving = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  /// For packs of 4 or 8 lanes; the tape may be gone afterwards, but not its numbers.
  /// Given  the code is called for the orders first <= k < to with first < to <= end
  MachineCode(const Tape<double>& tape, const Moving& moving, int lanes, int first, int end);
  /// Null if there is none.
  [[nodiscard]] Tape<double>::Code code() const noexcept { return code_; }

private:
  void swap(MachineCode& o) noexcept {
    std::swap(code_, o.code_);
    std::swap(pages_, o.pages_);
    std::swap(size_, o.size_);
  }
  Tape<double>::Code code_ = nullptr;
  void* pages_ = nullptr;
  std::size_t size_ = 0;
};

} // namespace kov::flow
