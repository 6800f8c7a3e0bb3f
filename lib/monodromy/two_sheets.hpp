#pragma once
// A system on a curve w^2 = F(z) as one over the z-plane: Y on one sheet is S + w D, on the other
// S - w D, and
//
//   S' = B_1 S + B_0 D,   D' = B_0/F S + (B_1 - F'/(2F)) D,   T' = -F'/(2F) T + c/F,   c' = 0,
//
// where t = w T is the time.  docs/theory/monodromy.md 11.3

#include "monodromy/ball_matrix.hpp"
#include "monodromy/differential_system.hpp"

#include <optional>

namespace kov::monodromy {

/// dY/dt = (even + w odd) Y, w = dz/dt, w^2 = f.
struct EllipticSystem {
  std::vector<std::vector<RationalFunction>> even, odd;
  Poly f;

  [[nodiscard]] std::size_t size() const noexcept { return even.size(); }
};

/// If S and D fall apart by the sign of w, only one part for each unknown is kept.
class TwoSheets {
public:
  /// Errors  InvalidArgument: not square matrices of one size; more than largest_size of the S_i
  ///         and D_i are needed
  explicit TwoSheets(const EllipticSystem& s);

  [[nodiscard]] const DifferentialSystem& system() const noexcept { return system_; }
  /// The index of T; c is the next one.
  [[nodiscard]] long time() const noexcept { return time_; }
  /// S_i and D_i are both there.
  [[nodiscard]] bool is_double(std::size_t i) const { return parts(i).size() == 2; }
  /// Y on the sheet `sign` w, where the matrix of the z-plane leads the solution that is 1 on the
  /// sheet w and, where both sheets are continued together, 0 on the other.
  [[nodiscard]] BallMatrix on_sheet(const BallMatrix& m, const ComplexBall& w, int sign,
                                    long bits) const;

private:
  struct Part {
    bool is_d;
    long at; ///< index in the system
  };
  [[nodiscard]] std::vector<Part> parts(std::size_t i) const;

  std::size_t n_;
  std::vector<std::optional<long>> place_; ///< of S_1, ..., S_n, D_1, ..., D_n
  long time_ = 0;
  DifferentialSystem system_;
};

} // namespace kov::monodromy
