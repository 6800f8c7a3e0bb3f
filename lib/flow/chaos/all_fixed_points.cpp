#include "flow/chaos/all_fixed_points.hpp"

#include "flow/chaos/periodic_orbit.hpp"
#include "flow/chaos/section_pieces.hpp"
#include "symbol/input_error.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

namespace kov::flow {
namespace {

using Ball = Enclosure;
using Box2 = std::array<Ball, 2>;

template <class R> std::array<R, 2> balls(const DrawnBox& b) {
  return {R::between(b[0][0], b[0][1]), R::between(b[1][0], b[1][1])};
}
double half_width(const DrawnBox& b, std::size_t d) { return (b[d][1] - b[d][0]) / 2; }
double middle_of(const DrawnBox& b, std::size_t d) { return b[d][0] + half_width(b, d); }

bool inside(const DrawnBox& a, const DrawnBox& b) {
  return b[0][0] <= a[0][0] && a[0][1] <= b[0][1] && b[1][0] <= a[1][0] && a[1][1] <= b[1][1];
}
/// The intersection of two closed boxes.
std::optional<DrawnBox> common(const DrawnBox& a, const DrawnBox& b) {
  DrawnBox c;
  for (std::size_t d = 0; d < 2; ++d) {
    c[d] = {std::max(a[d][0], b[d][0]), std::min(a[d][1], b[d][1])};
    if (!(c[d][0] <= c[d][1])) return std::nullopt;
  }
  return c;
}

/// The result of Krawczyk's test for P^n(z) - z over a box.
struct Test {
  Patch patch;                           ///< within the one that was shown to be one
  bool excluded = false, unique = false; ///< no fixed point in the box; exactly one
  std::array<double, 2> shift{};         ///< K - its middle: the middle of that
  std::array<double, 2> spread{};        ///< and its radius
  int index = 0;                         ///< where unique
};

// The sign of the determinants.  If Krawczyk's test succeeds, every matrix in `slope` is regular:
// all determinants have the sign of one of them.
template <class R> int common_index(const std::vector<std::vector<R>>& slope) {
  const auto one = [&](std::size_t i, std::size_t k) { return slope[i][k].middle(); };
  const R det = one(0, 0) * one(1, 1) - one(0, 1) * one(1, 0);
  return det.is_positive() ? 1 : det.is_negative() ? -1 : 0;
}

const Patch& shown(const Patch& p) { return p; }
Patch shown(const PatchOf<DoubleBall>& p) {
  Patch q{p.chart, {within(p.box[0]), within(p.box[1])}, {}, {}};
  for (const auto& x : p.at)
    q.at.emplace_back(around(x.v));
  for (const DoubleBall& y : p.sheet)
    q.sheet.push_back(within(y));
  return q;
}

template <class R>
Test test(EnclosedMapOf<R>& map, const Chart& chart, int period, const DrawnBox& box,
          const std::vector<double>& near) {
  const PatchOf<R> patch = map.patch(chart, balls<R>(box), near);
  const LandingOf<R> l = map(patch, false, period);
  Test t{shown(patch)};
  std::vector<R> value;
  std::vector<std::vector<R>> slope(2, std::vector<R>(2));
  std::vector<double> radius;
  for (std::size_t d = 0; d < 2; ++d) {
    const std::size_t j = chart.free[d];
    t.excluded = t.excluded || !(l.at[j].v - patch.box[d]).contains_zero();
    value.push_back(l.middle[j] - patch.box[d].middle());
    radius.push_back(patch.box[d].radius());
    for (std::size_t k = 0; k < 2; ++k)
      slope[d][k] = l.at[j].d[k] - R(d == k ? 1 : 0);
  }
  if (t.excluded) return t;
  const auto c = approximate_inverse(slope);
  if (!c) throw NotProved::multiplier_one;
  const std::vector<R> shift = krawczyk_shift(*c, value, slope, radius);
  t.unique = shift_inside(shift, radius) && EnclosedMapOf<R>::same_sheet(l, patch);
  for (std::size_t d = 0; d < 2; ++d) {
    t.excluded = t.excluded || !(shift[d] - R(0).widened(R(radius[d]))).contains_zero();
    t.shift[d] = static_cast<double>(shift[d]);
    t.spread[d] = shift[d].radius();
  }
  if (t.unique) t.index = common_index(slope);
  return t;
}

DrawnBox image_of(const DrawnBox& box, const Test& t) {
  DrawnBox b;
  for (std::size_t d = 0; d < 2; ++d) { // rounded outward
    const double m = middle_of(box, d) + t.shift[d];
    const double r = t.spread[d] * (1 + 1e-6) + 1e-15 * (std::abs(box[d][0]) + std::abs(box[d][1]));
    b[d] = {std::max(box[d][0], m - r), std::min(box[d][1], m + r)};
  }
  return b;
}

/// A box in which every fixed point is known.
struct DecidedBox {
  DrawnBox box;   ///< what it decides of the rectangle
  DrawnBox wider; ///< that of its patch
  Patch patch;
  std::optional<CountedPoint> point;
  Box2 at;                     ///< encloses it
  PhasePoint<Ball> there = {}; ///< all of its coordinates
  bool only_sheet = false;     ///< all points of the section over `box` are those of the patch
  bool joined = false;
};
double beginning(const DecidedBox& b) { return b.wider[0][0]; }

// All points of the section over the box are those of the patch: over the whole, or over each quarter.
bool only_sheet(SectionPieces& pieces, const DrawnBox& box, const Patch& patch, int depth) {
  const auto all = pieces.over(balls<DoubleBall>(box));
  if (!all) return false;
  const auto is_of_patch = [&](const SectionPieces::Piece& piece) {
    for (std::size_t k = 0; k < patch.sheet.size(); ++k)
      if (!around(piece.x[patch.chart.rest[k]]).inside(patch.sheet[k])) return false;
    return true;
  };
  if (std::ranges::all_of(*all, is_of_patch)) return true;
  if (depth == 0) return false;
  for (const bool low : {true, false})
    for (const bool left : {true, false}) {
      DrawnBox quarter = box;
      quarter[0][low ? 1 : 0] = middle_of(box, 0);
      quarter[1][left ? 1 : 0] = middle_of(box, 1);
      if (!only_sheet(pieces, quarter, patch, depth - 1)) return false;
    }
  return true;
}

/// The boxes of one sheet: the graphs over two boxes that meet agree at a point of what they have in common, so on all of it.
class OneSheet {
public:
  OneSheet(EnclosedMapOf<DoubleBall>& quick, EnclosedMap& map, std::vector<DecidedBox>& boxes)
      : quick_(quick), map_(map), boxes_(boxes) {
    for (const DecidedBox& b : boxes_)
      widest_ = std::max(widest_, b.wider[0][1] - b.wider[0][0]);
  }

  /// Keeps those that are on the sheet through a point.
  void keep_joined(const std::vector<double>& point, std::vector<DrawnBox>& others) {
    const BallVector exact(point.begin(), point.end());
    const PhasePoint<Ball> through(exact.begin(), exact.end());
    std::deque<std::size_t> grows;
    const auto first = std::ranges::find_if(boxes_, [&](const DecidedBox& b) {
      const double x = point[b.patch.chart.free[0]], y = point[b.patch.chart.free[1]];
      return inside({{{x, x}, {y, y}}}, b.wider) && EnclosedMap::same_sheet(through, b.patch);
    });
    if (first != boxes_.end()) {
      first->joined = true;
      grows.push_back(static_cast<std::size_t>(first - boxes_.begin()));
    }
    for (; !grows.empty(); grows.pop_front())
      for (const std::size_t i : meeting(grows.front()))
        if (!boxes_[i].joined && agrees(i)) {
          boxes_[i].joined = true;
          grows.push_back(i);
        }
    for (const DecidedBox& b : boxes_)
      if (!b.joined) others.push_back(b.box);
    std::erase_if(boxes_, [](const DecidedBox& b) { return !b.joined; });
  }

private:
  EnclosedMapOf<DoubleBall>& quick_;
  EnclosedMap& map_;
  std::vector<DecidedBox>& boxes_; ///< sorted by where they begin
  double widest_ = 0;

  // The others that meet box k.
  [[nodiscard]] std::vector<std::size_t> meeting(std::size_t k) const {
    const DrawnBox& box = boxes_[k].wider;
    const double from = box[0][0] - widest_ * (1 + 1e-9);
    std::vector<std::size_t> all;
    auto l = std::ranges::lower_bound(boxes_, from, {}, beginning);
    for (; l != boxes_.end() && l->wider[0][0] <= box[0][1]; ++l) {
      const auto i = static_cast<std::size_t>(l - boxes_.begin());
      if (i != k && common(box, l->wider)) all.push_back(i);
    }
    return all;
  }

  // With all that are joined and that it meets.
  [[nodiscard]] bool agrees(std::size_t k) const {
    return std::ranges::all_of(meeting(k), [&](std::size_t i) {
      return !boxes_[i].joined || agree(quick_, boxes_[k], boxes_[i]) ||
             agree(map_, boxes_[k], boxes_[i]);
    });
  }

  template <class R>
  static bool agree(EnclosedMapOf<R>& map, const DecidedBox& box, const DecidedBox& other) {
    const auto both = common(box.wider, other.wider);
    if (!both) return true;
    try {
      const Patch p =
          shown(map.patch(box.patch.chart, {R(middle_of(*both, 0)), R(middle_of(*both, 1))},
                          doubles(box.patch.at)));
      return EnclosedMap::same_sheet(p.at, box.patch) && EnclosedMap::same_sheet(p.at, other.patch);
    } catch (const NotProved&) {
      return false;
    }
  }
};

// Inside, outside, or nobody knows.
std::optional<bool> in_rectangle(const Box2& at, const std::array<Box2, 2>& border) {
  bool surely = true;
  for (std::size_t d = 0; d < 2; ++d) {
    if (at[d] < border[d][0] || at[d] > border[d][1]) return false;
    surely = surely && at[d] > border[d][0] && at[d] < border[d][1];
  }
  return surely ? std::optional(true) : std::nullopt;
}

// The points of the boxes, each once.
void count(const std::vector<DecidedBox>& leaves, const std::array<Box2, 2>& border,
           FixedPointsOverSheet& result) {
  std::vector<const DecidedBox*> counted;
  for (const DecidedBox& l : leaves) {
    if (!l.point) continue;
    const auto in = in_rectangle(l.at, border);
    if (in && !*in) continue;
    const auto known =
        [&](const DecidedBox* k) { // unique in a box that contains both, on its sheet
          return l.at[0].inside(k->patch.box[0]) && l.at[1].inside(k->patch.box[1]) &&
                 EnclosedMap::same_sheet(l.there, k->patch);
        };
    const auto apart = [&](const DecidedBox* k) {
      return !(l.at[0] - k->at[0]).contains_zero() || !(l.at[1] - k->at[1]).contains_zero();
    };
    if (std::ranges::any_of(counted, known)) continue;
    if (!in || l.point->index == 0 || !std::ranges::all_of(counted, apart)) {
      result.undecided.push_back(l.box);
      continue;
    }
    counted.push_back(&l);
    result.points.push_back(*l.point);
  }
}

/// Divides the rectangle until each box is decided, or too small.
class SheetSearch {
public:
  SheetSearch(EnclosedMapOf<DoubleBall>& quick, EnclosedMap& map, SectionPieces& pieces,
              const Chart& chart, const RectangleOptions& options,
              const std::array<Box2, 2>& border, const DrawnBox& rectangle,
              std::vector<double> through)
      : quick_(quick), map_(map), pieces_(pieces), chart_(chart), o_(options), border_(border),
        rectangle_(rectangle) {
    result_.through = std::move(through);
  }

  FixedPointsOverSheet run() {
    open_.push_back({rectangle_, result_.through});
    while (!open_.empty() || !enclosed_.empty()) {
      auto& first = enclosed_.empty() ? open_ : enclosed_;
      const OpenBox next = first.front();
      first.pop_front();
      if (++result_.boxes > o_.boxes || (o_.stop != nullptr && o_.stop->load()))
        result_.undecided.push_back(next.box);
      else
        look(next);
    }
    result_.all_sheets =
        result_.undecided.empty() &&
        std::ranges::all_of(leaves_, [](const DecidedBox& l) { return l.only_sheet; });
    std::ranges::sort(leaves_, {}, beginning);
    if (!result_.all_sheets && !result_.through.empty())
      OneSheet(quick_, map_, leaves_).keep_joined(result_.through, result_.undecided);
    count(leaves_, border_, result_);
    return std::move(result_);
  }

private:
  struct OpenBox {
    DrawnBox box;
    std::vector<double> near; ///< a point of the sheet near it
  };
  EnclosedMapOf<DoubleBall>& quick_; ///< most boxes
  EnclosedMap& map_;                 ///< what is left
  SectionPieces& pieces_;
  const Chart chart_;
  const RectangleOptions& o_;
  const std::array<Box2, 2>& border_;
  const DrawnBox rectangle_;
  /// Parts of boxes over which the map was enclosed come first: where the sheet ends it never is.
  std::deque<OpenBox> enclosed_, open_;
  std::vector<DecidedBox> leaves_;
  FixedPointsOverSheet result_;
  // The result for the box that was looked at last: the map was enclosed over it, or why not.
  bool map_enclosed_ = false;
  NotProved why_ = NotProved::not_tried;

  void look(const OpenBox& next) {
    for (const DecidedBox& l : leaves_)
      if (l.point && inside(next.box, l.wider)) {
        DecidedBox same = l;
        same.box = next.box;
        same.point.reset();
        keep(std::move(same));
        return;
      }
    std::vector<double> near = next.near;
    map_enclosed_ = false;
    why_ = NotProved::not_tried;
    if (!near.empty() && decided(quick_, next.box, near)) return;
    if (!map_enclosed_ && without_chart(next.box, near)) return;
    if (part_of(next.box) < 1e-4 && !near.empty() && decided(map_, next.box, near))
      return; // what was left may have been the rounding
    split(next.box, near);
  }

  void keep(DecidedBox leaf) {
    leaf.only_sheet = only_sheet(pieces_, leaf.box, leaf.patch, 2);
    leaves_.push_back(std::move(leaf));
  }

  // No point of the section over the box is fixed, on any sheet: there is none, or each moves.  Otherwise, where the
  // sheet was not found, and there is one, it is looked for there.
  bool without_chart(const DrawnBox& box, std::vector<double>& near) {
    const auto all = pieces_.over(balls<DoubleBall>(box));
    if (!all) return false;
    const bool folded = std::ranges::any_of(*all, [](const auto& piece) { return piece.folded; });
    const bool jumps = why_ == NotProved::end_of_step || why_ == NotProved::no_box;
    if (all->empty() || ((folded || (jumps && part_of(box) < 1.0 / 64)) &&
                         std::ranges::all_of(*all, [&](const auto& piece) {
                           return pieces_.moves(piece, o_.period);
                         })))
      return true;
    if (all->size() != 1) return false;
    std::vector<double> there;
    for (const DoubleBall& x : all->front().x)
      there.push_back(x.mid());
    const auto close = [](double a, double b) { return std::abs(a - b) < 1e-9; };
    if (std::ranges::equal(there, near, close)) return false;
    near = there;
    if (!decided(quick_, box, near)) return false;
    if (result_.through.empty()) result_.through = there;
    return true;
  }

  [[nodiscard]] double part_of(const DrawnBox& box) const {
    return std::max(half_width(box, 0) / half_width(rectangle_, 0),
                    half_width(box, 1) / half_width(rectangle_, 1));
  }

  template <class R>
  bool decided(EnclosedMapOf<R>& map, const DrawnBox& box, std::vector<double>& near) {
    try {
      const Test t = test(map, chart_, o_.period, box, near);
      map_enclosed_ = true;
      near = doubles(t.patch.at);
      if (t.excluded) {
        keep({box, box, t.patch, {}, {}});
        return true;
      }
      return isolated(map, box, t, near);
    } catch (const NotProved& why) { // smaller boxes may do
      why_ = why;
      return false;
    }
  }

  // The box with a margin, around the place where Newton's method goes from its middle.
  template <class R>
  bool isolated(EnclosedMapOf<R>& map, const DrawnBox& box, const Test& t,
                const std::vector<double>& near) {
    DrawnBox wider;
    for (std::size_t d = 0; d < 2; ++d) {
      const double r = half_width(box, d);
      if (!(t.spread[d] < 0.6 * r && std::abs(t.shift[d]) < 4 * r)) return false;
      const double m = middle_of(box, d) + t.shift[d], reach = 1.1 * (std::abs(t.shift[d]) + r);
      wider[d] = {m - reach, m + reach};
    }
    Test whole = test(map, chart_, o_.period, wider, near);
    if (!whole.unique || !inside(box, wider)) return false;
    DecidedBox leaf{box, wider, whole.patch, CountedPoint{}, {}};
    refine(leaf, whole);
    keep(std::move(leaf));
    return true;
  }

  // The fixed point lies in the image of Krawczyk's operator; again and again, while that helps.
  void refine(DecidedBox& leaf, const Test& first) const {
    DrawnBox at = image_of(leaf.wider, first);
    Patch patch = map_.patch(chart_, balls<Ball>(at), doubles(first.patch.at));
    leaf.point->index = first.index;
    for (int i = 0; i < 40; ++i) {
      const Test t = test(map_, chart_, o_.period, at, doubles(patch.at));
      if (!t.unique) break;
      if (leaf.point->index == 0) leaf.point->index = t.index; // sharper here
      patch = t.patch;
      const DrawnBox next = image_of(at, t);
      const double better = std::max(half_width(next, 0) / half_width(at, 0),
                                     half_width(next, 1) / half_width(at, 1));
      at = next;
      if (!(better < 0.9)) break;
    }
    patch = map_.patch(chart_, balls<Ball>(at), doubles(patch.at));
    leaf.at = patch.box;
    leaf.there = patch.at;
    leaf.point->x = doubles(patch.at);
    for (std::size_t j = 0; j < patch.at.size(); ++j)
      leaf.point->error =
          std::max(leaf.point->error, bound_of(patch.at[j].v - Ball(leaf.point->x[j])));
  }

  void split(const DrawnBox& box, const std::vector<double>& near) {
    const auto part = [&](std::size_t d) { return half_width(box, d) / half_width(rectangle_, d); };
    const std::size_t d = part(0) >= part(1) ? 0 : 1;
    const double cut = middle_of(box, d);
    if (!(part(d) > 1e-7 && box[d][0] < cut && cut < box[d][1])) {
      result_.undecided.push_back(box);
      return;
    }
    DrawnBox low = box, high = box;
    low[d][1] = high[d][0] = cut;
    auto& later = map_enclosed_ ? enclosed_ : open_;
    later.push_back({low, near});
    later.push_back({high, near});
  }
};

/// The two coordinates that are drawn.
Chart drawn_chart(const SystemScene& s) {
  const VectorField& v = s.system.field;
  Chart chart;
  for (std::size_t d = 0; d < 2; ++d) {
    std::size_t j = 0;
    while (j < v.dimension() && !(s.plot[d].value == MFraction::variable(v.ring, v.coordinates[j])))
      ++j;
    if (s.sphere || j == v.dimension() || (d == 1 && j == chart.free[0]))
      throw InputError(s.file, 0, 0, 1,
                       "all fixed points in a rectangle need a plot of two coordinates",
                       "plot = [\"y\", \"v\"]");
    chart.free[d] = j;
  }
  for (std::size_t j = 0; j < v.dimension(); ++j)
    if (j != chart.free[0] && j != chart.free[1]) chart.rest.push_back(j);
  return chart;
}

std::vector<std::vector<double>> starts_or_none(const SystemScene& scene,
                                                const std::array<Quantity, 2>& place,
                                                const std::atomic<bool>* stop) {
  try {
    return starts_over(scene, place, stop);
  } catch (const InputError&) { // the level has no point there, as far as the search sees
    return {};
  }
}

// One of five times five.
std::array<Quantity, 2> place_in(const std::array<std::array<Quantity, 2>, 2>& rectangle, int i) {
  std::array<Quantity, 2> place;
  for (std::size_t d = 0; d < 2; ++d) {
    const int k = d == 0 ? i % 5 : i / 5;
    const std::string part = std::to_string(2 * k + 1) + "/10";
    place[d] = rectangle[d][0] + (rectangle[d][1] - rectangle[d][0]) * Quantity(part.c_str());
  }
  return place;
}

} // namespace

FixedPointsInRectangle fixed_points_in(const SystemScene& scene,
                                       const std::array<std::array<Quantity, 2>, 2>& rectangle,
                                       const RectangleOptions& options) {
  const SectionSurface surface(scene);
  const Chart chart = drawn_chart(scene);
  const EnclosureScope scope(options.bits);
  std::array<Box2, 2> border;
  DrawnBox outer;
  std::array<Quantity, 2> middle;
  for (std::size_t d = 0; d < 2; ++d) {
    const auto& [from, to] = rectangle[d];
    if ((to - from).sign() <= 0)
      throw InputError(scene.file, 0, 0, 1,
                       "the rectangle is empty from " + from.text() + " to " + to.text());
    border[d] = {from.as<Ball>(), to.as<Ball>()};
    outer[d] = {std::nextafter(from.as<double>(), -INFINITY),
                std::nextafter(to.as<double>(), INFINITY)};
    middle[d] = (from + to).shifted(-1);
  }
  FixedPointsInRectangle all;
  all.period = options.period;
  EnclosedMapOf<DoubleBall> quick(surface, options.stop);
  EnclosedMap map(surface, options.stop);
  SectionPieces pieces(scene, chart, options.stop);
  auto starts = starts_or_none(scene, middle, options.stop);
  for (int i = 0; starts.empty() && i < 25; ++i) // the level may end before the middle
    starts = starts_or_none(scene, place_in(rectangle, i), options.stop);
  if (starts.empty()) starts.emplace_back(); // perhaps there is no point at all
  for (const auto& x : starts) {
    all.sheets.push_back(SheetSearch(quick, map, pieces, chart, options, border, outer, x).run());
    if (all.sheets.back().all_sheets) break;
  }
  all.stopped = options.stop != nullptr && options.stop->load();
  return all;
}

} // namespace kov::flow
