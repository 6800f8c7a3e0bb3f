#include "monodromy/monodromy.hpp"

#include "monodromy/imprecise.hpp"
#include "monodromy/magnitude.hpp"
#include "monodromy/self_tests.hpp"
#include "monodromy/transitions.hpp"

namespace kov::monodromy {
namespace {

constexpr long dear_bits = 1200; // beyond,
constexpr long pilot_bits = 160; // a cheap first run tells what the radii lose on the way
constexpr long spare_bits = 48;
constexpr long most_bits = 1L << 22;
constexpr int most_attempts = 24;

// 10^-digits <= 2^-bits
long bits_for(long digits) { return digits * 3322 / 1000 + 2; }

// The matrix of one loop: to the circle, around, and back, step by step.  (The inverse of the
// enclosure of a large matrix would lose twice its size.)
BallMatrix around(const Loop& loop, const Transitions& t) {
  const BallMatrix there = t.along(loop.approach);
  return t.along(reversed(loop.approach), t.along(loop.circle, there));
}

Monodromy attempt(const DifferentialSystem& s, const std::vector<SingularPoint>& places,
                  const LoopTree& tree, long bits, const Budget& budget) {
  const EmbeddedSystem embedded(s, 2 * bits + 256);
  Transitions t(embedded, bits, budget);
  for (const Loop& loop : tree.loops) {
    t.announce(loop.approach);
    t.announce(loop.circle);
  }
  if (tree.large_circle) t.announce(*tree.large_circle);
  t.compute();
  Monodromy m{tree.base, {}, {}, {}, bits};
  for (const Loop& loop : tree.loops)
    m.loops.push_back({places[loop.singularity], around(loop, t)});
  if (tree.large_circle) m.large_circle = t.along(*tree.large_circle);
  return m;
}

// How many bits more are needed; 0 when the radii are small enough.
long missing_bits(const Monodromy& m, long wanted) {
  const Ball radius = largest_radius(m);
  if (arb_is_finite(radius.raw()) == 0) return m.bits;
  Magnitude bound;
  arb_get_mag(bound.raw(), radius.raw());
  return is_zero(bound) ? 0 : std::max(0L, exponent(bound) + wanted);
}

Monodromy accurate(const DifferentialSystem& s, const std::vector<SingularPoint>& places,
                   const LoopTree& tree, const Request& request) {
  const long wanted = bits_for(request.digits);
  long bits = wanted + spare_bits;
  if (bits > dear_bits) bits = pilot_bits;
  for (int k = 0; k < most_attempts && bits < most_bits; ++k) {
    long missing = 0;
    try {
      Monodromy m = attempt(s, places, tree, bits, request.budget);
      missing = missing_bits(m, wanted);
      if (missing == 0) return m;
    } catch (const Imprecise&) {
      missing = bits; // twice the bits
    }
    bits += missing + spare_bits;
  }
  throw OutOfBudget("the matrices could not be computed to " + std::to_string(request.digits) +
                    " digits");
}

} // namespace

LoopTree loops_of(const std::vector<SingularPoint>& places, const std::optional<Point>& base) {
  std::vector<ComplexBall> points;
  for (const SingularPoint& p : places)
    points.push_back(p.at);
  return loop_tree(points, base);
}

Monodromy diagonal_block(const Monodromy& m, const std::vector<std::size_t>& indices) {
  const auto part = [&](const BallMatrix& whole) {
    BallMatrix block(static_cast<long>(indices.size()));
    for (std::size_t i = 0; i < indices.size(); ++i)
      for (std::size_t j = 0; j < indices.size(); ++j)
        acb_set(block.entry(static_cast<long>(i), static_cast<long>(j)),
                whole.entry(static_cast<long>(indices[i]), static_cast<long>(indices[j])));
    return block;
  };
  Monodromy block{m.base, {}, {}, {}, m.bits};
  for (const LoopMatrix& l : m.loops)
    block.loops.push_back({l.place, part(l.matrix)});
  if (m.large_circle) block.large_circle = part(*m.large_circle);
  return block;
}

Ball largest_radius(const Monodromy& m) {
  Ball most;
  const auto include = [&](const BallMatrix& matrix) {
    const Ball one = largest_radius(matrix);
    if (arb_lt(most.raw(), one.raw()) != 0) most = one;
  };
  for (const LoopMatrix& l : m.loops)
    include(l.matrix);
  if (m.large_circle) include(*m.large_circle);
  return most;
}

Monodromy monodromy(const DifferentialSystem& s, const Request& request) {
  const auto places = singular_points(s, plan_bits, request.budget);
  Monodromy m = accurate(s, places, loops_of(places, request.base), request);
  m.self_tests = tested_identities(s, m);
  return m;
}

Monodromy monodromy(const RationalFunction& p, const RationalFunction& q, const Request& request) {
  Monodromy m = monodromy(companion(p, q), request);
  for (std::string& passed : tested_traces(normal_form(p, q), m, request.budget))
    m.self_tests.push_back(std::move(passed));
  return m;
}

} // namespace kov::monodromy
