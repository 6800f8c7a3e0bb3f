#include "flow/chaos/index_grid.hpp"

#include <algorithm>
#include <cmath>

namespace kov::flow {
namespace {

constexpr double turn = 6.283185307179586;
// Neither noise nor a fixed point: the displacement of an edge has a direction.
constexpr double least_displacement = 1e-9;

double size(const Place& u) { return std::hypot(u[0], u[1]); }

// The change of the displacement that the derivatives at x predict for a step.
Place expected(const Displaced& x, const Place& step) {
  return {x.slopes[0][0] * step[0] + x.slopes[0][1] * step[1],
          x.slopes[1][0] * step[0] + x.slopes[1][1] * step[1]};
}

// How far from 0 a straight line from `from` on stays.
double distance_from_zero(const Place& from, const Place& change) {
  const double square = change[0] * change[0] + change[1] * change[1];
  const double along = -(from[0] * change[0] + from[1] * change[1]) / square;
  const double t = square > 0 ? std::clamp(along, 0.0, 1.0) : 0;
  return size({from[0] + t * change[0], from[1] + t * change[1]});
}

// Passages of the straight line from a displacement on through {du = 0, dv > 0}.
int passages_of_line(const Place& a, const Place& change) {
  const bool right = a[0] >= 0, still_right = a[0] + change[0] >= 0;
  if (right == still_right || a[1] - a[0] / change[0] * change[1] <= 0) return 0;
  return right ? 1 : -1;
}

} // namespace

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t j = 0; j < a.size(); ++j)
    most = std::max(most, std::abs(a[j] - b[j]));
  return most;
}

double size_of(const std::vector<double>& a) { return distance(a, std::vector<double>(a.size())); }

IndexGrid::IndexGrid(std::array<bool, 2> turns, int columns, int rows, MapOverPicture& map)
    : turns_(turns), count_{columns, rows}, map_(map) {
  for (int i = 0; i < columns; ++i)
    for (int k = 0; k < rows; ++k) {
      nodes_.push_back(map.over(place(i, k)));
      for (Displaced& x : nodes_.back())
        map.displace(x);
    }
}

// Away from the lines of symmetry, where fixed points like to be.
Place IndexGrid::place(double column, double row) const {
  const Place part{(column + 0.381966) / count_[0], (row + 0.4142) / count_[1]};
  Place u{};
  for (std::size_t d = 0; d < 2; ++d)
    u[d] = turns_[d] ? turn * part[d] : turn / 2 * (part[d] - 0.5);
  return u;
}

std::size_t IndexGrid::number(int column, int row) const {
  const int i = (column + count_[0]) % count_[0], k = (row + count_[1]) % count_[1];
  return static_cast<std::size_t>(i * count_[1] + k);
}

const std::vector<Displaced>& IndexGrid::node(int column, int row) const {
  return nodes_[number(column, row)];
}

// From a to b, the short way round.
Place IndexGrid::between(const Place& a, const Place& b) const {
  Place d{b[0] - a[0], b[1] - a[1]};
  for (std::size_t i = 0; i < 2; ++i)
    if (turns_[i]) d[i] = std::remainder(d[i], turn);
  return d;
}

// Between neighbours the displacement goes by 0 on the same side as the straight line.
bool IndexGrid::is_straight(const Displaced& a, const Displaced& b) const {
  const Place step = between(a.at, b.at), change = between(*a.by, *b.by);
  double bend = 0; // what the derivatives say of the way from the line
  for (const Displaced* end : {&a, &b}) {
    const Place slope = expected(*end, step);
    bend = std::max(bend, size({slope[0] - change[0], slope[1] - change[1]}));
    if (turns_[1] && std::abs((*end->by)[1]) > turn / 4) return false;
  }
  return size(change) < 1.5 &&
         distance_from_zero(*a.by, change) > std::max(bend, least_displacement);
}

bool IndexGrid::is_joined(const Displaced& a, const Displaced& b) const {
  const auto there = map_.follow(a, b.at);
  return there && distance(there->state, b.state) <= 1e-6 * size_of(b.state);
}

std::optional<int> IndexGrid::passages(const Displaced& a, const Displaced& b, int depth) const {
  if (!a.by || !b.by) return std::nullopt;
  if (is_straight(a, b)) return passages_of_line(*a.by, between(*a.by, *b.by));
  if (depth == 0) return std::nullopt;
  const Place step = between(a.at, b.at);
  auto middle = map_.follow(a, {a.at[0] + step[0] / 2, a.at[1] + step[1] / 2});
  if (middle) map_.displace(*middle);
  const auto first = middle ? passages(a, *middle, depth - 1) : std::nullopt;
  const auto second = first ? passages(*middle, b, depth - 1) : std::nullopt;
  return second ? std::optional(*first + *second) : std::nullopt;
}

std::optional<IndexGrid::Edge> IndexGrid::edge(const Displaced& from,
                                               const std::vector<Displaced>& to) const {
  for (std::size_t s = 0; s < to.size(); ++s)
    if (to.size() == 1 || is_joined(from, to[s])) return Edge{s, passages(from, to[s], deepest)};
  return std::nullopt;
}

std::optional<int> IndexGrid::index(int column, int row, std::size_t sheet) const {
  int sum = 0;
  std::array<std::size_t, 2> corner{};
  for (const std::size_t first :
       {0U, 1U}) { // the way to the right and up; that up and to the right
    std::size_t s = sheet;
    std::array<int, 2> at{column, row};
    for (const std::size_t d : {first, 1 - first}) {
      const auto& from = edges_[d][number(at[0], at[1])];
      if (s >= from.size() || !from[s] || !from[s]->passages) return std::nullopt;
      sum += first == 0 ? *from[s]->passages : -*from[s]->passages;
      s = from[s]->to;
      ++at[d];
    }
    corner[first] = s;
  }
  return corner[0] == corner[1] ? std::optional(sum) : std::nullopt;
}

std::vector<IndexGrid::Cell> IndexGrid::cells() {
  const std::array<int, 2> cells{count_[0] - (turns_[0] ? 0 : 1), count_[1] - (turns_[1] ? 0 : 1)};
  for (const std::size_t d : {0U, 1U})
    for (int i = 0; i < count_[0]; ++i)
      for (int k = 0; k < count_[1]; ++k) {
        auto& all = edges_[d].emplace_back();
        for (const Displaced& x : node(i, k))
          all.push_back((d == 0 ? i : k) < cells[d]
                            ? edge(x, node(i + (d == 0 ? 1 : 0), k + (d == 0 ? 0 : 1)))
                            : std::nullopt);
      }
  std::vector<Cell> all;
  for (int i = 0; i < cells[0]; ++i)
    for (int k = 0; k < cells[1]; ++k) {
      const std::array corners{&node(i, k), &node(i + 1, k), &node(i, k + 1), &node(i + 1, k + 1)};
      for (std::size_t s = 0;; ++s) {
        const auto corner =
            std::ranges::find_if(corners, [&](const auto* c) { return c->size() > s; });
        if (corner == corners.end()) break;
        all.push_back({i, k, (**corner)[s], index(i, k, s)});
      }
    }
  return all;
}

bool IndexGrid::contains(const Cell& c, const Displaced& x) const {
  const Place corner = place(c.column, c.row), end = place(c.column + 1, c.row + 1),
              way = between(corner, x.at);
  for (std::size_t d = 0; d < 2; ++d)
    if (way[d] < 0 || way[d] >= end[d] - corner[d]) return false;
  return is_joined(x, c.corner);
}

} // namespace kov::flow
