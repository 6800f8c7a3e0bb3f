#pragma once
// Monodromy matrices with proven radii.
//
// Y is the fundamental matrix with Y(base) = 1; continued along a loop it becomes Y M.  The matrix
// of "loop 1, then loop 2" is M_2 M_1.

#include "linode/normal_form.hpp"
#include "monodromy/ball_matrix.hpp"
#include "monodromy/loops.hpp"
#include "monodromy/singular_points.hpp"

namespace kov::monodromy {

struct LoopMatrix {
  SingularPoint place;
  BallMatrix matrix;
};

struct Monodromy {
  Point base;
  std::vector<LoopMatrix> loops; ///< in the order of loops.hpp
  /// Along the large circle, counterclockwise; for a base inside it is not computed.
  std::optional<BallMatrix> large_circle;
  std::vector<std::string> self_tests; ///< what was tested, and held (self_tests.hpp)
  long bits = 0;                       ///< of the precision that was enough

  [[nodiscard]] long size() const noexcept {
    return loops.empty() ? 0 : loops.front().matrix.size();
  }
};

struct Request {
  long digits = 30; ///< every radius at most 10^-digits
  std::optional<Point> base;
  Budget budget;
};

/// Errors   InvalidArgument (the base); OutOfBudget when the accuracy is not reached within the
///          budget or at all; InternalError when a self-test fails
/// Source   docs/theory/monodromy.md
[[nodiscard]] Monodromy monodromy(const DifferentialSystem& s, const Request& request = {});
/// The same for y'' + p y' + q y = 0 and the vector (y, y').
[[nodiscard]] Monodromy monodromy(const RationalFunction& p, const RationalFunction& q,
                                  const Request& request = {});

/// An upper bound of all radii.
[[nodiscard]] Ball largest_radius(const Monodromy& m);
/// The matrices of the unknowns with these indices, where they are a diagonal block of the system
/// (differential_system.hpp).
[[nodiscard]] Monodromy diagonal_block(const Monodromy& m, const std::vector<std::size_t>& indices);
/// The tree of loops that `monodromy` uses.
[[nodiscard]] LoopTree loops_of(const std::vector<SingularPoint>& places,
                                const std::optional<Point>& base);

} // namespace kov::monodromy
