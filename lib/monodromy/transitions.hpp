#pragma once
// Transition matrices along paths.  A vertex that several paths share is expanded once.

#include "monodromy/expansion.hpp"
#include "monodromy/loops.hpp"

#include <map>

namespace kov::monodromy {

class Transitions {
public:
  Transitions(const EmbeddedSystem& s, long bits, Budget budget)
      : system_(s), bits_(bits), budget_(std::move(budget)) {}

  /// Says that `along(path)` will be asked.
  void announce(const Path& path);
  /// Expands at every vertex announced.
  void compute();
  /// The value at the end of the path of the solution that is 1 at its start.
  [[nodiscard]] BallMatrix along(const Path& path) const {
    return along(path, BallMatrix::identity(system_.size()));
  }
  /// The same for the solution that is `start` there.
  [[nodiscard]] BallMatrix along(const Path& path, BallMatrix start) const;

private:
  struct Before {
    bool operator()(const Point& a, const Point& b) const;
  };
  using Values = std::map<Point, BallMatrix, Before>;

  const EmbeddedSystem& system_;
  long bits_;
  Budget budget_;
  std::map<Point, Values, Before> values_; ///< by vertex, then by joint
};

} // namespace kov::monodromy
