#pragma once
// The stable and unstable manifolds of a hyperbolic fixed point of the section map in double, and where they cross:
// guesses for homoclinic.hpp, and what pictures show.

#include "flow/chaos/return_map.hpp"

namespace kov::flow {

/// p + A (xi, eta) in a chart around a hyperbolic fixed point of Q = P^turns.
struct LocalFrame {
  Chart chart;
  std::vector<double> near;   ///< all coordinates of p
  std::array<double, 2> at{}; ///< chart coordinates of p
  std::array<std::array<double, 2>, 2> axes{};
  double stretch_unstable = 2, stretch_stable = 2; ///< of Q, and of its inverse
  double reach = 0;                                ///< where the arcs begin
  int turns = 1;
};

/// An orbit of Q from near p along the unstable manifold, to near p along the stable one.
struct HomoclinicGuess {
  double xi = 0, eta = 0;
  std::vector<std::vector<double>> orbit; ///< z_0 ... z_n
  std::size_t middle = 0;                 ///< where the arcs crossed
};

class ManifoldArcs {
public:
  /// most_returns: of the map, in all
  ManifoldArcs(QuickMap& map, const LocalFrame& frame, long most_returns,
               const std::atomic<bool>* stop)
      : map_(map), frame_(frame), left_(most_returns), stop_(stop) {}
  /// Up to `most`, of the shortest orbits that there are.
  [[nodiscard]] std::vector<HomoclinicGuess> guesses(std::size_t most);
  using Curve = std::vector<std::array<double, 2>>;
  [[nodiscard]] const std::vector<Curve>& curves(bool stable) const {
    return curves_[stable ? 1 : 0];
  }

private:
  struct Sample {
    double start;                          ///< xi or eta
    std::vector<std::array<double, 2>> at; ///< drawn, by level
    std::vector<double> end;
    bool lost = false;
  };
  struct Arc { // a half of a manifold: one fundamental segment and its images
    bool stable;
    std::vector<Sample> samples; ///< by rising |start|
  };
  struct Segment {
    std::size_t arc, sample;
    int level;
    std::array<double, 2> a, b;
  };
  [[nodiscard]] PhasePoint<double> start_of(bool stable, double along) const;
  [[nodiscard]] std::optional<PhasePoint<double>> image(bool stable, double along, int level) const;
  [[nodiscard]] Sample sampled(bool stable, double along, int levels);
  [[nodiscard]] bool stopped() const { return left_ <= 0 || (stop_ != nullptr && stop_->load()); }
  void extend(Arc& arc, int level);
  [[nodiscard]] std::optional<HomoclinicGuess> refined(const Segment& u, const Segment& s);
  void add_segments(const Arc& arc, std::size_t number, int level, std::vector<Segment>& all) const;
  QuickMap& map_;
  LocalFrame frame_;
  long left_; ///< returns that may still be computed
  const std::atomic<bool>* stop_;
  double size_ = 1; ///< of the picture
  std::vector<Arc> arcs_;
  std::vector<Curve> curves_[2];
};

} // namespace kov::flow
