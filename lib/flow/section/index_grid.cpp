#include "flow/section/index_grid.hpp"

#include <algorithm>
#include <cmath>

namespace kov::flow {
namespace {

constexpr double turn = 6.283185307179586;
// Neither noise nor a fixed point: the displacement of an edge has a direction.
constexpr double least_displacement = 1e-9;

double wrapped(double angle) { return std::remainder(angle, turn); }
double size(const Latitude& u) { return std::hypot(u.l, u.y); }

// From a to b, the short way round in l.
Latitude between(const Latitude& a, const Latitude& b) { return {wrapped(b.l - a.l), b.y - a.y}; }

// The change of the displacement that the derivatives at x predict for a step.
Latitude expected(const Displaced& x, const Latitude& step) {
  return {x.slopes[0] * step.l + x.slopes[1] * step.y, x.slopes[2] * step.l + x.slopes[3] * step.y};
}

// How far from 0 a straight line from `from` on stays.
double distance(const Latitude& from, const Latitude& change) {
  const double square = change.l * change.l + change.y * change.y;
  const double along = -(from.l * change.l + from.y * change.y) / square;
  const double t = square > 0 ? std::clamp(along, 0.0, 1.0) : 0;
  return size({from.l + t * change.l, from.y + t * change.y});
}

// Between neighbours the displacement goes by 0 on the same side as the straight line.
bool is_straight(const Displaced& a, const Displaced& b) {
  const Latitude step = between(a.at, b.at), change = between(a.by, b.by);
  double bend = 0; // what the derivatives say of the way from the line
  for (const Displaced* end : {&a, &b}) {
    const Latitude slope = expected(*end, step);
    bend = std::max(bend, size({slope.l - change.l, slope.y - change.y}));
  }
  return size(change) < 1.5 && distance(a.by, change) > std::max(bend, least_displacement);
}

// Passages of the straight line from a's displacement to b's through {dl = 0, dy > 0}.
int passages_of_line(const Latitude& a, const Latitude& b) {
  const Latitude change = between(a, b);
  const bool right = a.l >= 0, still_right = a.l + change.l >= 0;
  if (right == still_right || a.y - a.l / change.l * change.y <= 0) return 0;
  return right ? 1 : -1;
}

std::optional<int> sum(const std::optional<int>& a, const std::optional<int>& b) {
  return a && b ? std::optional(*a + *b) : std::nullopt;
}

std::optional<int> negative(const std::optional<int>& a) {
  return a ? std::optional(-*a) : std::nullopt;
}

} // namespace

IndexGrid::IndexGrid(int columns, int rows, Map map)
    : columns_(columns), rows_(rows), map_(std::move(map)) {
  for (int i = 0; i < columns; ++i)
    for (int k = 0; k < rows; ++k)
      nodes_.push_back(map_(place(i, k)));
}

// Away from the lines of symmetry, where fixed points like to be.
Latitude IndexGrid::place(double column, double row) const {
  return {turn * (column + 0.381966) / columns_, turn / 2 * ((row + 0.4142) / rows_ - 0.5)};
}

std::size_t IndexGrid::number(int column, int row) const {
  return static_cast<std::size_t>(column % columns_ * rows_ + row);
}

const std::optional<Displaced>& IndexGrid::node(int column, int row) const {
  return nodes_[number(column, row)];
}

std::optional<int> IndexGrid::passages(const std::optional<Displaced>& a,
                                       const std::optional<Displaced>& b, int depth) const {
  if (!a || !b) return std::nullopt;
  if (is_straight(*a, *b)) return passages_of_line(a->by, b->by);
  if (depth == 0) return std::nullopt;
  const Latitude step = between(a->at, b->at);
  const std::optional<Displaced> middle = map_({a->at.l + step.l / 2, a->at.y + step.y / 2});
  const std::optional<int> first = passages(a, middle, depth - 1);
  return first ? sum(first, passages(middle, b, depth - 1)) : std::nullopt;
}

void IndexGrid::count() {
  for (int i = 0; i < columns_; ++i)
    for (int k = 0; k < rows_; ++k) {
      across_.push_back(passages(node(i, k), node(i + 1, k), deepest));
      up_.push_back(k + 1 < rows_ ? passages(node(i, k), node(i, k + 1), deepest) : std::nullopt);
    }
}

std::optional<int> IndexGrid::index(int column, int row) const {
  const auto &below = across_[number(column, row)], &above = across_[number(column, row + 1)];
  const auto &left = up_[number(column, row)], &right = up_[number(column + 1, row)];
  return sum(sum(below, right), sum(negative(above), negative(left)));
}

bool IndexGrid::on_level(int column, int row) const {
  return node(column, row) || node(column + 1, row) || node(column, row + 1) ||
         node(column + 1, row + 1);
}

std::optional<std::array<int, 2>> IndexGrid::cell_of(const Latitude& u) const {
  const double row = (u.y / (turn / 2) + 0.5) * rows_ - 0.4142;
  if (row < 0 || row >= rows_ - 1) return std::nullopt;
  const double column = u.l / turn * columns_ - 0.381966;
  const int i = static_cast<int>(std::floor(column)) % columns_;
  return std::array{i < 0 ? i + columns_ : i, static_cast<int>(row)};
}

} // namespace kov::flow
