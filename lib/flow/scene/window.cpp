#include "flow/scene/window.hpp"

#include "flow/scene/starts.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace kov::flow {
namespace {

constexpr int window_cells = 21;             // of a side of the box
constexpr double smallest_window = 1.0 / 64; // half of a side
constexpr double largest_window = 64;
constexpr int times_fitted = 2;

using Side = std::array<double, 2>;
using Box = std::array<Side, 2>;
using Cell = std::array<int, 2>;

bool is_outside(const Cell& c) {
  return std::ranges::any_of(c, [](int i) { return i < 0 || i >= window_cells; });
}

/// The cells over which the level has a point, as far as they hang together with the one nearest to the middle.
class PartOfLevel {
public:
  PartOfLevel(Places& places, const Box& box) : box_(box), has_(window_cells * window_cells) {
    for (int i = 0; i < window_cells; ++i)
      for (int k = 0; k < window_cells; ++k)
        has_[at({i, k})] = !places.over({middle(0, i), middle(1, k)}).empty();
    std::vector<Cell> open;
    if (const auto first = nearest()) open.push_back(*first);
    while (!open.empty()) {
      const Cell c = open.back();
      open.pop_back();
      if (is_outside(c) || !has_[at(c)]) continue;
      has_[at(c)] = false;
      for (std::size_t j = 0; j < 2; ++j) {
        first_[j] = std::min(first_[j], c[j]);
        last_[j] = std::max(last_[j], c[j]);
        for (const int step : {-1, 1}) {
          open.push_back(c);
          open.back()[j] += step;
        }
      }
    }
  }

  [[nodiscard]] bool is_empty() const { return last_[0] < 0; }
  [[nodiscard]] bool reaches_the_end(std::size_t j) const {
    return first_[j] == 0 || last_[j] == window_cells - 1;
  }
  /// With half a cell around it.
  [[nodiscard]] Side side(std::size_t j) const {
    return {middle(j, first_[j] - 1), middle(j, last_[j] + 1)};
  }

private:
  [[nodiscard]] double middle(std::size_t j, int i) const {
    return box_[j][0] + (i + 0.5) / window_cells * (box_[j][1] - box_[j][0]);
  }
  static std::size_t at(const Cell& c) {
    return static_cast<std::size_t>(c[0] * window_cells + c[1]);
  }
  [[nodiscard]] std::optional<Cell> nearest() const {
    std::optional<Cell> best;
    const auto distance = [](const Cell& c) {
      return std::hypot(c[0] - (window_cells - 1) / 2.0, c[1] - (window_cells - 1) / 2.0);
    };
    for (int i = 0; i < window_cells; ++i)
      for (int k = 0; k < window_cells; ++k)
        if (has_[at({i, k})] && (!best || distance({i, k}) < distance(*best))) best = {i, k};
    return best;
  }

  Box box_;
  std::vector<bool> has_;
  Cell first_{window_cells, window_cells}, last_{-1, -1};
};

// A little outside, with two digits of the size of the side.
Quantity rounded_out(double x, bool up, double size) {
  const int digits = 1 - static_cast<int>(std::floor(std::log10(size)));
  const double unit = std::pow(10.0, digits);
  const double whole = up ? std::ceil(x * unit) : std::floor(x * unit);
  const auto power = [](int n) { return "10^" + std::to_string(n); };
  const std::string text = std::to_string(static_cast<long long>(whole));
  return Quantity((digits > 0 ? text + "/" + power(digits) : text + "*" + power(-digits)).c_str());
}

Box box_over_level(Places& places) {
  constexpr Side usual{-1, 1};
  Box box{usual, usual};
  for (double s = 1; s >= smallest_window && PartOfLevel(places, box).is_empty();
       s /= 2) // none: a small level
    box = {Side{-s / 2, s / 2}, Side{-s / 2, s / 2}};
  if (PartOfLevel(places, box).is_empty()) box = {usual, usual};
  std::array<bool, 2> endless{};
  for (bool grown = true; grown;) {
    grown = false;
    const PartOfLevel part(places, box);
    for (std::size_t j = 0; j < 2; ++j)
      if (box[j][1] < largest_window && !endless[j] &&
          (part.is_empty() || part.reaches_the_end(j))) {
        box[j] = {2 * box[j][0], 2 * box[j][1]};
        grown = true;
      }
  }
  if (PartOfLevel(places, box).is_empty()) return {usual, usual};
  for (int i = 0; i <= times_fitted; ++i) {
    const PartOfLevel part(places, box);
    for (std::size_t j = 0; j < 2; ++j) {
      endless[j] = endless[j] || (i == 0 && part.reaches_the_end(j));
      box[j] = endless[j] ? usual : part.side(j);
    }
    if (part.is_empty()) return {usual, usual};
  }
  return box;
}

} // namespace

std::array<std::array<Quantity, 2>, 2> window_over_level(const SystemScene& scene) {
  const Field field = field_of_starts(scene);
  Places places(scene, field);
  const Box box = box_over_level(places);
  std::array<std::array<Quantity, 2>, 2> window;
  for (std::size_t j = 0; j < 2; ++j)
    for (const bool up : {false, true})
      window[j][up ? 1 : 0] = rounded_out(box[j][up ? 1 : 0], up, box[j][1] - box[j][0]);
  return window;
}

} // namespace kov::flow
