#pragma once
// The places of the fixed points of a map on the section: cells of a grid, and their indices.
//
// The index of a cell is the number of zeros of the displacement P(u) - u in it, each counted with
// the sign of det(DP - 1): +1 for elliptic and inverse hyperbolic points, -1 for hyperbolic ones.
// It is the number of times that the displacement turns around 0 while u goes round the cell.  l is
// an angle, so the displacement lies on a cylinder; what is counted on an edge are its passages
// through the half-line {dl = 0, dy > 0}, from right to left positive.  The sum over the edges of a
// cell is its index.
//
// An edge is halved until, between neighbours, the derivatives at both ends say that the
// displacement passes 0 on the same side as the straight line between them: a map that turns much
// faster between two samples than at both of them deceives this, so an index is evidence and no
// proof.  Where the map jumps, leaves the level, or has a fixed point on the edge (a curve of them,
// say) no halving helps: the two cells there have no index, and say so.

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace kov::flow {

/// A place of the section: l in radian, and the latitude asin(L/G), in which the poles are not
/// crowded.
struct Latitude {
  double l = 0, y = 0;
};

struct Displaced {
  Latitude at, by;                ///< by.l in [-pi, pi]
  std::array<double, 4> slopes{}; ///< d by.l/dl, d by.l/dy, d by.y/dl, d by.y/dy
};

class IndexGrid {
public:
  /// Nothing where the map is not defined.
  using Map = std::function<std::optional<Displaced>(const Latitude&)>;

  /// Samples the map at the nodes.
  IndexGrid(int columns, int rows, Map map);
  /// Counts on all edges.
  ///
  /// Cost  1 to 2^deepest values of the map for each of the 2 columns * rows edges
  void count();

  /// The place of a node, or between nodes; columns go round in l.
  [[nodiscard]] Latitude place(double column, double row) const;
  [[nodiscard]] const std::optional<Displaced>& node(int column, int row) const;
  /// The index of the cell with the node in its lower left corner, row < rows - 1; after count().
  [[nodiscard]] std::optional<int> index(int column, int row) const;
  /// The cell has a corner where the map is defined.
  [[nodiscard]] bool on_level(int column, int row) const;
  /// The cell that contains a place, by its lower left corner; nothing beyond the outermost rows.
  [[nodiscard]] std::optional<std::array<int, 2>> cell_of(const Latitude& u) const;

  static constexpr int deepest = 7; ///< an edge is halved so often

private:
  int columns_, rows_;
  Map map_;
  std::vector<std::optional<Displaced>> nodes_;
  std::vector<std::optional<int>> across_, up_; ///< passages from a node to the next in l; in y
  [[nodiscard]] std::size_t number(int column, int row) const;
  [[nodiscard]] std::optional<int> passages(const std::optional<Displaced>& a,
                                            const std::optional<Displaced>& b, int depth) const;
};

} // namespace kov::flow
