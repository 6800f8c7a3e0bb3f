#include "monodromy/loops.hpp"

#include "exact/error.hpp"

#include <algorithm>
#include <numeric>

namespace kov::monodromy {
namespace {

constexpr long circle_vertices = 8;
constexpr long large_circle_vertices = 12;
constexpr std::size_t longest_path = 20000;
constexpr long grid_below = 6; // a vertex is rounded to 1/64 ... 1/32 of its distance

// A fraction of a distance.
Real part(long n, long d) { return Real(n) / Real(d); }

// |step|/distance to the nearest singularity, at most about this.
const Real& largest_ratio() {
  static const Real ratio = part(21, 50);
  return ratio;
}

Point rounded(const Point& p, const Real& distance) {
  return to_grid(p, exponent(distance) - grid_below);
}

class Landscape {
public:
  explicit Landscape(const std::vector<ComplexBall>& s) {
    for (const ComplexBall& z : s)
      points_.push_back(point(z));
    find_centre();
    for (std::size_t i = 0; i < points_.size(); ++i)
      isolation_.push_back(nearest(points_[i], i));
  }

  [[nodiscard]] std::size_t size() const noexcept { return points_.size(); }
  [[nodiscard]] const Point& operator[](std::size_t i) const { return points_[i]; }
  [[nodiscard]] const Point& centre() const noexcept { return centre_; }
  /// All singularities are this near to the centre.  Positive.
  [[nodiscard]] const Real& spread() const noexcept { return spread_; }
  /// The distance of singularity i to the next one; of the only one: 2.
  [[nodiscard]] const Real& isolation(std::size_t i) const { return isolation_[i]; }
  [[nodiscard]] Real distance(const Point& p) const { return nearest(p, points_.size()); }

private:
  [[nodiscard]] Real nearest(const Point& p, std::size_t but) const {
    std::optional<Real> least;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (i != but) {
        const Real d = abs(points_[i] - p);
        if (!least || d < *least) least = d;
      }
    return least ? *least : Real(2);
  }

  void find_centre() {
    Point low = points_.front(), high = low;
    for (const Point& p : points_) {
      low = {min(low.x, p.x), min(low.y, p.y)};
      high = {max(high.x, p.x), max(high.y, p.y)};
    }
    const Real size = max(high.x - low.x, high.y - low.y);
    const Point middle = part(1, 2) * (low + high);
    centre_ = rounded(middle, Real(0) < size ? size : Real(1));
    for (const Point& p : points_)
      spread_ = max(spread_, abs(p - centre_));
    if (points_.size() == 1) spread_ = Real(1);
  }

  std::vector<Point> points_;
  std::vector<Real> isolation_;
  Point centre_;
  Real spread_;
};

// The point of the segment from a to b that is nearest to p, as a distance.
Real distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point d = b - a, e = p - a;
  const Real along = (d.x * e.x + d.y * e.y) / (d.x * d.x + d.y * d.y);
  return abs(e - max(Real(0), min(Real(1), along)) * d);
}

// How freely b sees the singularities: 1 is best.
Real clearance(const Landscape& land, const Point& b) {
  Real least(1);
  for (std::size_t i = 0; i < land.size(); ++i)
    for (std::size_t j = 0; j < land.size(); ++j)
      if (i != j) least = min(least, distance_to_segment(land[j], b, land[i]) / land.isolation(j));
  return least;
}

struct Candidate {
  Point base;
  Real clearance;
};

// Far below the centre, or in another one of n directions when that sees the singularities far
// better; on a grid of spread/2^bits.
Candidate best_of_directions(const Landscape& land, long n, long bits) {
  std::optional<Candidate> best;
  for (long k = 0; k < n; ++k) {
    const Point down{Real(0), Real(-3) * land.spread()};
    const Point b = to_grid(land.centre() + turned(down, k, n), exponent(land.spread()) - bits);
    const Real c = clearance(land, b);
    if (!best || best->clearance < part(1, 2) * c) best = {b, c};
  }
  return *best;
}

// Few directions and short numbers, unless all of them look along lines through singularities.
Point choose_base(const Landscape& land) {
  Candidate best = best_of_directions(land, 12, 2);
  for (const auto& [directions, bits] : {std::pair(23L, 8L), std::pair(97L, 12L)}) {
    if (part(1, 1000) < best.clearance) break;
    const Candidate other = best_of_directions(land, directions, bits);
    if (best.clearance < other.clearance) best = other;
  }
  return best.base;
}

class Walker {
public:
  explicit Walker(const Landscape& land) : land_(land) {}

  /// The path from a straight to b.  Every vertex is rounded by a small part of its own distance to the
  /// singularities, so that none of them lies between the path and the segment.
  [[nodiscard]] Path straight(const Point& a, const Point& b) const {
    Path path{{a}, {}};
    const Real length = abs(b - a);
    const Real to_b = land_.distance(b);
    for (Real x; Real(0) < length;) {
      const Real here = land_.distance(path.vertices.back());
      if (length - x < largest_ratio() * (here + to_b)) {
        extend(path, rounded(b, to_b));
        break;
      }
      x = x + stride(a, b, x, here);
      const Point next = a + (x / length) * (b - a);
      extend(path, rounded(next, land_.distance(next)));
    }
    return path;
  }

  /// The closed polygon with n vertices about the centre through the first vertex.
  [[nodiscard]] Path around(const Point& centre, const Point& first, long n) const {
    Path path{{first}, {}};
    for (long k = 1; k < n; ++k) {
      const Point next = centre + turned(first - centre, k, n);
      extend(path, rounded(next, land_.distance(next)));
    }
    extend(path, first);
    return path;
  }

private:
  // The root t of t = ratio (R(x) + R(x + t)), nearly.
  [[nodiscard]] Real stride(const Point& a, const Point& b, const Real& x, const Real& here) const {
    const Real length = abs(b - a);
    Real t = largest_ratio() * here;
    for (int i = 0; i < 4; ++i)
      t = largest_ratio() * (here + land_.distance(a + ((x + t) / length) * (b - a)));
    return t;
  }

  void extend(Path& path, const Point& next) const {
    if (path.vertices.size() > longest_path)
      throw OutOfBudget("the singularities are too near to each other for a path between them");
    const Point& last = path.vertices.back();
    const Real r = land_.distance(last), s = land_.distance(next);
    path.joints.push_back(rounded(last + (r / (r + s)) * (next - last), min(r, s)));
    path.vertices.push_back(next);
  }

  const Landscape& land_;
};

// --- what is claimed of a loop, with balls

void require(bool proved) {
  if (!proved)
    throw OutOfBudget("the singularities are too near to each other for loops around each of them");
}

ComplexBall difference(const Point& a, const ComplexBall& b) {
  ComplexBall d;
  acb_sub(d.raw(), exact(a).raw(), b.raw(), plan_bits);
  return d;
}

Ball modulus(const ComplexBall& z) {
  Ball r;
  acb_abs(r.raw(), z.raw(), plan_bits);
  return r;
}

// arg (b - s)/(a - s)
Ball turn(const Point& a, const ComplexBall& b_minus_s, const ComplexBall& s) {
  ComplexBall quotient;
  acb_div(quotient.raw(), b_minus_s.raw(), difference(a, s).raw(), plan_bits);
  Ball angle;
  acb_arg(angle.raw(), quotient.raw(), plan_bits);
  return angle;
}

std::vector<Point> polygon(const Path& path) {
  std::vector<Point> all{path.vertices.front()};
  for (std::size_t k = 0; k < path.joints.size(); ++k) {
    all.push_back(path.joints[k]);
    all.push_back(path.vertices[k + 1]);
  }
  return all;
}

// Every segment of the closed polygon has s on its left, and seen from s they turn by 2 pi
// together.
void ensure_turns_once(const Path& circle, const ComplexBall& s) {
  const std::vector<Point> points = polygon(circle);
  Ball sum, one_turn;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    ComplexBall turn;
    acb_div(turn.raw(), difference(points[k + 1], s).raw(), difference(points[k], s).raw(),
            plan_bits);
    require(arb_is_positive(acb_imagref(turn.raw())) != 0);
    Ball angle;
    acb_arg(angle.raw(), turn.raw(), plan_bits);
    arb_add(sum.raw(), sum.raw(), angle.raw(), plan_bits);
  }
  arb_const_pi(one_turn.raw(), plan_bits);
  arb_mul_2exp_si(one_turn.raw(), one_turn.raw(), 1);
  arb_sub(sum.raw(), sum.raw(), one_turn.raw(), plan_bits);
  Ball one;
  arb_one(one.raw());
  arb_abs(sum.raw(), sum.raw());
  require(arb_lt(sum.raw(), one.raw()) != 0); // a multiple of 2 pi
}

// The path, and on to s, is homotopic to the segment from its first point to s: every other
// singularity sees both turn by the same angle, which is known up to a multiple of 2 pi.
void ensure_straight(const Path& path, std::size_t i, const std::vector<ComplexBall>& all) {
  const std::vector<Point> points = polygon(path);
  for (std::size_t j = 0; j < all.size(); ++j) {
    if (j == i) continue;
    ComplexBall target;
    acb_sub(target.raw(), all[i].raw(), all[j].raw(), plan_bits);
    Ball sum = turn(points.back(), target, all[j]);
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      const Ball one = turn(points[k], difference(points[k + 1], all[j]), all[j]);
      arb_add(sum.raw(), sum.raw(), one.raw(), plan_bits);
    }
    const Ball direct = turn(points.front(), target, all[j]);
    arb_sub(sum.raw(), sum.raw(), direct.raw(), plan_bits);
    arb_abs(sum.raw(), sum.raw());
    Ball one;
    arb_one(one.raw());
    require(arb_lt(sum.raw(), one.raw()) != 0);
  }
}

// All other singularities are outside the disc about s that holds the circle.
void ensure_alone(const Path& circle, std::size_t i, const std::vector<ComplexBall>& all) {
  for (std::size_t j = 0; j < all.size(); ++j) {
    if (j == i) continue;
    ComplexBall apart;
    acb_sub(apart.raw(), all[j].raw(), all[i].raw(), plan_bits);
    for (const auto* points : {&circle.vertices, &circle.joints})
      for (const Point& p : *points)
        require(arb_lt(modulus(difference(p, all[i])).raw(), modulus(apart).raw()) != 0);
  }
}

class LoopBuilder {
public:
  LoopBuilder(const std::vector<ComplexBall>& s, const std::optional<Point>& base)
      : singularities_(s), land_(s), walker_(land_), base_(base ? *base : choose_base(land_)),
        chosen_(!base) {
    outside_ = Real(2) * land_.spread() < abs(base_ - land_.centre());
  }

  [[nodiscard]] LoopTree tree() const {
    for (const ComplexBall& s : singularities_)
      if (acb_contains_zero(difference(base_, s).raw()) != 0) {
        require(!chosen_);
        throw InvalidArgument("the base point is a singularity: choose another --base, or none");
      }
    LoopTree t{base_, {}, {}};
    for (const std::size_t i : order())
      t.loops.push_back(loop(i));
    if (outside_) {
      t.large_circle = walker_.around(land_.centre(), base_, large_vertices());
      for (const ComplexBall& s : singularities_)
        ensure_turns_once(*t.large_circle, s);
    }
    return t;
  }

private:
  // atan2 of the direction of s, turned so that the centre is in direction 0 for a base outside.
  [[nodiscard]] Real angle(const Point& s) const {
    const Point d = s - base_;
    if (!outside_) return atan2(d.y, d.x);
    const Point c = land_.centre() - base_;
    return atan2(d.y * c.x - d.x * c.y, d.x * c.x + d.y * c.y);
  }

  [[nodiscard]] std::vector<std::size_t> order() const {
    std::vector<Real> angles;
    for (std::size_t i = 0; i < land_.size(); ++i)
      angles.push_back(angle(land_[i]));
    std::vector<std::size_t> order(land_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, [&](std::size_t i, std::size_t j) { return angles[i] < angles[j]; });
    for (std::size_t k = 0; k + 1 < order.size(); ++k) {
      const Real gap = angles[order[k + 1]] - angles[order[k]];
      if (!(Real(0) < gap) || exponent(gap) < -plan_bits / 2) {
        require(!chosen_);
        throw InvalidArgument("the base point sees two singularities in one direction; choose "
                              "another one, for instance off the line through them");
      }
    }
    return order;
  }

  [[nodiscard]] Loop loop(std::size_t i) const {
    const Point& s = land_[i];
    const Real away = abs(base_ - s);
    const Real radius = part(1, 2) * land_.isolation(i);
    const bool inside = !(radius < away);
    const Path approach =
        inside ? Path{{base_}, {}} : walker_.straight(base_, s + (radius / away) * (base_ - s));
    Loop l{i, approach, walker_.around(s, approach.vertices.back(), circle_vertices)};
    ensure_straight(l.approach, i, singularities_);
    ensure_turns_once(l.circle, singularities_[i]);
    ensure_alone(l.circle, i, singularities_);
    return l;
  }

  // So many that a step is short beside the distance to the singularities.
  [[nodiscard]] long large_vertices() const {
    const Real radius = abs(base_ - land_.centre());
    return Real(5) * land_.spread() < Real(2) * radius ? large_circle_vertices
                                                       : 2 * large_circle_vertices;
  }

  const std::vector<ComplexBall>& singularities_;
  Landscape land_;
  Walker walker_;
  Point base_;
  bool chosen_; ///< by us
  bool outside_ = false;
};

} // namespace

Path reversed(Path path) {
  std::ranges::reverse(path.vertices);
  std::ranges::reverse(path.joints);
  return path;
}

LoopTree loop_tree(const std::vector<ComplexBall>& singularities,
                   const std::optional<Point>& base) {
  if (singularities.empty()) return {base ? *base : Point{}, {}, {}};
  return LoopBuilder(singularities, base).tree();
}

} // namespace kov::monodromy
