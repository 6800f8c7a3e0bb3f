#pragma once
// The places of the fixed points of a map of a surface over the picture: cells of a grid, and their indices.
//
// The index of a cell is the number of zeros of the displacement P(u) - u in it, each counted with
// the sign of det(DP - 1): +1 for elliptic and inverse hyperbolic points, -1 for hyperbolic ones.
// It is the number of times that the displacement turns around 0 while u goes round the cell.  What is counted on an
// edge are its passages through the half-line {du = 0, dv > 0}, from right to left positive (so u may be an angle; two
// angles need a displacement in v below a quarter turn).  The sum over the edges of a cell is its index.
//
// An edge is halved until, between neighbours, the derivatives at both ends say that the
// displacement passes 0 on the same side as the straight line between them: a map that turns much
// faster between two samples than at both of them deceives this, so an index is evidence and no
// proof.  Where the map jumps, leaves the level, or has a fixed point on the edge (a curve of them,
// say) no halving helps: the two cells there have no index, and say so.
//
// Several sheets of the surface may lie over a place: each cell is one of one of them, which its edges follow.

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace kov::flow {

/// An angle in radian, or [-pi/2, pi/2] over the side of the picture (over the latitudes of a sphere).
using Place = std::array<double, 2>;

/// A point of the surface and its displacement.
struct Displaced {
  Place at{};
  std::vector<double> state{};   ///< all coordinates
  std::optional<Place> by{};     ///< angles in [-pi, pi]; nothing where the map is not defined
  std::array<Place, 2> slopes{}; ///< of by[0], by[1] by the place
};

/// A map of a surface over the picture.
class MapOverPicture {
public:
  virtual ~MapOverPicture() = default;
  /// One point on each sheet over a place.
  [[nodiscard]] virtual std::vector<Displaced> over(const Place& u) = 0;
  /// The point over a place on the sheet of one near it.
  [[nodiscard]] virtual std::optional<Displaced> follow(const Displaced& from, const Place& to) = 0;
  /// Sets `by` and `slopes`.
  virtual void displace(Displaced& x) = 0;
};

class IndexGrid {
public:
  struct Cell {
    int column = 0, row = 0;
    Displaced corner; ///< one of its four
    std::optional<int> index;
  };

  /// turns: which coordinate is an angle.  Samples the map at the nodes.
  IndexGrid(std::array<bool, 2> turns, int columns, int rows, MapOverPicture& map);
  /// Counts on all edges.
  ///
  /// Cost  1 to 2^deepest values of the map for each of the 2 columns * rows edges of a sheet
  [[nodiscard]] std::vector<Cell> cells();

  /// The place of a node, or between nodes.
  [[nodiscard]] Place place(double column, double row) const;
  [[nodiscard]] const std::vector<Displaced>& node(int column, int row) const;
  /// The cell has this point in it.
  [[nodiscard]] bool contains(const Cell& c, const Displaced& x) const;

  static constexpr int deepest = 7; ///< an edge is halved so often

private:
  /// From a point of a node to that of the next one on its sheet.
  struct Edge {
    std::size_t to = 0;
    std::optional<int> passages;
  };
  std::array<bool, 2> turns_;
  std::array<int, 2> count_;
  MapOverPicture& map_;
  std::vector<std::vector<Displaced>> nodes_;
  std::array<std::vector<std::vector<std::optional<Edge>>>, 2> edges_; ///< to the right; up
  [[nodiscard]] std::size_t number(int column, int row) const;
  [[nodiscard]] Place between(const Place& a, const Place& b) const;
  [[nodiscard]] bool is_straight(const Displaced& a, const Displaced& b) const;
  [[nodiscard]] bool is_joined(const Displaced& a, const Displaced& b) const;
  [[nodiscard]] std::optional<int> passages(const Displaced& a, const Displaced& b,
                                            int depth) const;
  [[nodiscard]] std::optional<Edge> edge(const Displaced& from,
                                         const std::vector<Displaced>& to) const;
  [[nodiscard]] std::optional<int> index(int column, int row, std::size_t sheet) const;
};

/// The largest difference of two points.
[[nodiscard]] double distance(const std::vector<double>& a, const std::vector<double>& b);
/// The largest coordinate.
[[nodiscard]] double size_of(const std::vector<double>& a);

} // namespace kov::flow
