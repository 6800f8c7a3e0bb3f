#pragma once
// Orbits of a polynomial vector field in four coordinates, enclosed step by step, and where they
// cross a section next (docs/theory/chaos.md 1.2, 1.3).

#include "certify/homoclinic/interval.hpp"
#include "certify/system/certificate.hpp"

#include <map>

namespace kov::certify {

using Point = std::array<Interval, 4>;
/// A point; or three: with its derivatives by the two coordinates of a chart.
using Jet = std::vector<Point>;

/// Several polynomials, at points and along series.
class Polynomials {
public:
  explicit Polynomials(const std::vector<PhaseFunction>& all);
  [[nodiscard]] std::vector<Interval> at(const Point& x) const;

private:
  friend class Series;
  using Monomial = std::array<unsigned long, 4>;
  struct Row {
    std::vector<std::pair<std::size_t, Interval>> terms; ///< node, coefficient
    Interval constant;
  };
  [[nodiscard]] std::size_t node(const Monomial& m);

  std::map<Monomial, std::size_t> place_;
  /// The nodes after the four coordinates, of two earlier ones each.
  std::vector<std::pair<std::size_t, std::size_t>> products_;
  std::vector<Row> rows_;
};

/// Taylor coefficients of the orbit through a point, with derivatives.
class Series {
public:
  Series(const Polynomials& field, const Jet& x, int order);
  [[nodiscard]] Jet coefficient(int k) const;
  /// The polynomial of this degree at the interval t.
  [[nodiscard]] Jet at(const Interval& t, int degree) const;
  [[nodiscard]] double largest(int k) const;
  [[nodiscard]] std::size_t nodes() const { return nodes_.front().size(); }

private:
  using Row = std::vector<Interval>;
  void multiply(const Polynomials& field, int k);
  void integrate(const Polynomials& field, int k);
  std::vector<std::vector<Row>> nodes_; ///< [part][node]
};

/// The products that may still be made.
struct FlowBudget {
  double left;
  void spend(double products) {
    left -= products;
    need_within(left > 0, "the work is above the limit");
  }
};

/// The orbits of a box during a step of time: the polynomial, a box that contains them, and the next
/// coefficient over it.
class FlowStep {
public:
  static constexpr int order = 22;
  FlowStep(const Polynomials& field, const Jet& x, int way, FlowBudget& budget);
  /// A length that may be right.
  [[nodiscard]] double guess() const;
  /// Proves that the box holds the orbits during `length`.
  [[nodiscard]] bool contains(double length);
  [[nodiscard]] const Jet& box() const { return box_; }
  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] int way() const { return way_; }
  [[nodiscard]] Interval duration() const; ///< from 0 to the end of the step
  /// The orbits at the times t within the step.
  [[nodiscard]] Jet at(const Interval& t) const;
  [[nodiscard]] Jet end() const { return at(Interval::exactly(way_ * length_)); }

private:
  const Polynomials& field_;
  int way_;
  FlowBudget& budget_;
  Series series_;
  double length_ = 0;
  Jet box_, last_;
};

/// The section of an energy level by a function: its next crossing in the wanted direction.
class SectionFlow {
public:
  SectionFlow(const PhaseFunction& hamiltonian, const PhaseFunction& section,
              const std::optional<PhaseFunction>& where, bool rising);
  /// Moves x to the next wanted crossing of its orbits (way -1: the one before), and `thin`, the
  /// orbit of the middle, along with it; off: the box of starts minus its middle.  Throws Refused.
  void to_crossing(Jet& x, Jet& thin, const std::array<Interval, 2>& off, int way);

private:
  enum class Seen : unsigned char { nothing, crossing, unknown };
  [[nodiscard]] Interval rate(const Point& x) const;
  [[nodiscard]] int height(const Point& x, int way) const;
  [[nodiscard]] Seen look(const FlowStep& s, const Jet& start, const Jet& end, bool& leaving) const;
  [[nodiscard]] Seen sure_step(FlowStep& s, const Jet& x, Jet& end, bool& leaving) const;
  [[nodiscard]] Jet landing(const FlowStep& s) const;

  Polynomials field_, section_, gradient_, side_;
  bool rising_;
  FlowBudget budget_;
};

/// (1.3) x made smaller by the mean value theorem from the orbit of the middle.
void tighten(Jet& x, const Jet& thin, const std::array<Interval, 2>& off);

/// The partial derivative by coordinate i.
[[nodiscard]] PhaseFunction partial(const PhaseFunction& f, std::size_t i);

} // namespace kov::certify
