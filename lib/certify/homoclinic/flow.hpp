#pragma once
// Orbits of a polynomial vector field in four coordinates, enclosed step by step, and where they
// cross a section next (docs/theory/chaos.md 1.2, 1.3).

#include "certify/loops/interval.hpp"
#include "certify/system/check.hpp"
#include "exact/flint_matrix.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>
#include <map>

namespace kov::certify {

/// The four coordinates of a point; or twelve numbers: also its derivatives by two others.
using State = std::vector<Interval>;

/// Several polynomials, at points and along series.
class Polynomials {
public:
  explicit Polynomials(const std::vector<PhaseFunction>& all)
      : variables_(all.front().p.ring()->size()) {
    for (const PhaseFunction& f : all) {
      Row row;
      for (long i = 0; i < f.p.length(); ++i) {
        const Monomial m = f.p.exponents(i);
        const Interval c{Rational(f.p.coefficient(i), f.n)};
        if (m == Monomial(variables_))
          row.constant = c;
        else
          row.terms.emplace_back(node(m), c);
      }
      rows_.push_back(std::move(row));
    }
  }

  /// x: the variables, and perhaps more
  [[nodiscard]] State at(const State& x) const {
    State v(x.begin(), x.begin() + static_cast<long>(variables_)), out;
    for (const auto& [a, b] : products_)
      v.push_back(v[a] * v[b]);
    for (const Row& row : rows_) {
      Interval& sum = out.emplace_back(row.constant);
      for (const auto& [i, c] : row.terms)
        arb_addmul(sum.raw(), c.raw(), v[i].raw(), Interval::bits);
    }
    return out;
  }

private:
  friend class OrbitSeries;
  using Monomial = std::vector<unsigned long>;
  struct Row {
    std::vector<std::pair<std::size_t, Interval>> terms; ///< node, coefficient
    Interval constant;
  };

  // The node of m without its last variable, times this variable.
  std::size_t node(const Monomial& m) {
    if (const auto known = place_.find(m); known != place_.end()) return known->second;
    std::size_t x = variables_ - 1;
    while (m[x] == 0)
      --x;
    Monomial rest = m;
    --rest[x];
    std::size_t at = x;
    if (rest != Monomial(variables_)) {
      products_.emplace_back(node(rest), x);
      at = variables_ + products_.size() - 1;
    }
    return place_[m] = at;
  }

  std::size_t variables_;
  std::map<Monomial, std::size_t> place_;
  /// The nodes after the variables, of two earlier ones each.
  std::vector<std::pair<std::size_t, std::size_t>> products_;
  std::vector<Row> rows_;
};

/// Taylor coefficients of the orbit of a field through a state.
class OrbitSeries {
public:
  OrbitSeries(const Polynomials& field, const State& x, std::size_t order)
      : size_(x.size()), nodes_(size_ + field.products_.size()) {
    static_assert(sizeof(Interval) == sizeof(arb_struct)); // rows are vectors of arb_struct
    for (std::size_t i = 0; i < size_; ++i)
      nodes_[i].push_back(x[i]);
    for (std::size_t k = 0; k < order; ++k) {
      for (std::size_t i = 0; i < field.products_.size(); ++i) {
        const auto [a, b] = field.products_[i];
        arb_dot(nodes_[size_ + i].emplace_back().raw(), nullptr, 0, nodes_[a].front().raw(), 1,
                nodes_[b][k].raw(), -1, static_cast<long>(k) + 1, Interval::bits);
      }
      for (std::size_t i = 0; i < size_; ++i) {
        const auto& [terms, constant] = field.rows_[i];
        Interval sum = k == 0 ? constant : Interval();
        for (const auto& [node, c] : terms)
          arb_addmul(sum.raw(), c.raw(), nodes_[node][k].raw(), Interval::bits);
        nodes_[i].push_back(sum / Interval(static_cast<long>(k) + 1));
      }
    }
  }

  [[nodiscard]] std::size_t nodes() const { return nodes_.size(); }
  [[nodiscard]] State coefficient(std::size_t k) const {
    State x;
    for (std::size_t i = 0; i < size_; ++i)
      x.push_back(nodes_[i][k]);
    return x;
  }
  /// The polynomial of this degree at the interval t.
  [[nodiscard]] State at(const Interval& t, long degree) const {
    State x(size_);
    for (std::size_t i = 0; i < size_; ++i)
      _arb_poly_evaluate_horner(x[i].raw(), nodes_[i].front().raw(), degree + 1, t.raw(),
                                Interval::bits);
    return x;
  }

private:
  std::size_t size_;
  std::vector<std::vector<Interval>> nodes_;
};

/// The orbits of a box during a step of time: the polynomial, a box that contains them, and the next
/// coefficient over it.
class FlowStep {
public:
  /// budget: the products that may still be made
  FlowStep(const Polynomials& field, const State& x, int way, double& budget)
      : field_(field), way_(way), budget_(budget), series_(field, x, order) {
    spend();
  }

  /// A length that may be right.
  [[nodiscard]] double guess() const {
    double size = 1e-300;
    for (const Interval& c : series_.coefficient(order))
      size = std::max(size, c.most().about());
    return std::min(longest, 0.9 * std::pow(std::ldexp(1.0, room_bits) / size, 1.0 / order));
  }
  /// Proves that the box holds the orbits during `length`: the Picard operator maps the functions that stay in
  /// the box into themselves if the polynomial and the remainder do.
  [[nodiscard]] bool contains(double length) {
    length_ = std::ldexp(std::floor(std::ldexp(length, 30)), -30); // exact in all that follows
    box_ = series_.at(duration(), order);
    const Interval room = power_of_two(room_bits);
    for (Interval& c : box_)
      c = c.wider(room);
    spend();
    last_ = OrbitSeries(field_, box_, order + 1).coefficient(order + 1);
    const Interval reach = power(Interval::exactly(length_), order + 1);
    return std::ranges::all_of(last_, [&](const Interval& c) { return (c * reach).most() < room; });
  }
  [[nodiscard]] const State& box() const { return box_; }
  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] int way() const { return way_; }
  [[nodiscard]] Interval duration() const { ///< from 0 to the end of the step
    return Interval::from_zero(Interval::exactly(way_ * length_));
  }
  /// The orbits at the times t within the step.
  [[nodiscard]] State at(const Interval& t) const {
    const Interval reach = power(t, order + 1);
    State x = series_.at(t, order);
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = x[i] + reach * last_[i];
    return x;
  }
  [[nodiscard]] State end() const { return at(Interval::exactly(way_ * length_)); }

private:
  static constexpr int order = 22;
  static constexpr long room_bits = -72; // binary logarithm of what a polynomial is widened by
  static constexpr double longest = 0.5;

  void spend() {
    budget_ -= static_cast<double>(series_.nodes()) * order * order;
    need_within(budget_ > 0, "the work is above the limit");
  }

  const Polynomials& field_;
  int way_;
  double& budget_;
  OrbitSeries series_;
  double length_ = 0;
  State box_, last_;
};

/// The partial derivatives by the four coordinates.
[[nodiscard]] inline std::vector<PhaseFunction> gradient(const PhaseFunction& f) {
  std::vector<PhaseFunction> all;
  for (std::size_t i = 0; i < 4; ++i)
    all.push_back({derivative(f.p, i), f.n});
  return all;
}

/// The section of an energy level by a function: its next crossing in the wanted direction.
class SectionFlow {
public:
  SectionFlow(const PhaseFunction& hamiltonian, const PhaseFunction& section,
              const std::optional<PhaseFunction>& where, bool rising)
      : field_(canonical_field(hamiltonian)), with_derivatives_(variations(hamiltonian)),
        section_({section}), gradient_(gradient(section)),
        side_({where ? *where : PhaseFunction{MPoly(section.p.ring(), Integer(1)), Integer(1)}}),
        rising_(rising) {}

  /// Moves x, with derivatives, to the next wanted crossing of its orbits (way -1: the one before), and
  /// `thin`, the orbit of the middle, along with it; off: the box of starts minus its middle.  Throws Refused.
  void to_crossing(State& x, State& thin, const std::array<Interval, 2>& off, int way) {
    bool leaving = true;
    for (int n = 0; n < most_steps; ++n) {
      FlowStep wide(with_derivatives_, x, way, budget_), narrow(field_, thin, way, budget_);
      State end;
      const bool lands = sure_step(wide, x, end, leaving) == Seen::crossing;
      need(narrow.contains(wide.length()), "a step of the middle orbit is not enclosed");
      x = lands ? landing(wide) : std::move(end);
      thin = lands ? landing(narrow) : narrow.end();
      for (std::size_t i = 0; i < 4; ++i) // (1.3) by the mean value theorem
        x[i] = x[i].meet(thin[i] + x[4 + i] * off[0] + x[8 + i] * off[1]);
      if (lands) return;
    }
    throw Refused{"an orbit does not return"};
  }

private:
  static constexpr int most_steps = 600;  // of a return
  static constexpr int most_lengths = 80; // tried for one step
  static constexpr double shorter = 0.7;
  static constexpr int landing_rounds = 12;
  enum class Seen : unsigned char { nothing, crossing, unknown };

  static std::vector<PhaseFunction> canonical_field(const PhaseFunction& h) {
    const auto d = gradient(h);
    return {d[2], d[3], {-d[0].p, h.n}, {-d[1].p, h.n}};
  }
  // x' = X(x), and u' = (dX/dx) u of two u.
  static std::vector<PhaseFunction> variations(const PhaseFunction& h) {
    auto names = h.p.ring()->names();
    for (int k = 0; k < 8; ++k)
      names.push_back("u " + std::to_string(k)); // no name of a file
    const Ring ring = make_ring(names);
    auto all = canonical_field({in_ring(h.p, ring), h.n});
    for (const std::size_t u : {4, 8})
      for (std::size_t i = 0; i < 4; ++i) {
        MPoly sum(ring);
        for (std::size_t j = 0; j < 4; ++j)
          sum += derivative(all[i].p, j) * MPoly::variable(ring, u + j);
        all.push_back({sum, h.n});
      }
    return all;
  }

  static Interval along(const State& gradient, const Interval* x) {
    Interval sum;
    for (std::size_t i = 0; i < 4; ++i)
      sum = sum + gradient[i] * x[i];
    return sum;
  }
  // d(section)/dt, positive at a wanted crossing.
  [[nodiscard]] Interval rate(const State& x) const {
    const Interval r = along(gradient_.at(x), field_.at(x).data());
    return rising_ ? r : -r;
  }
  // The sign of the section's function, which grows through a wanted crossing as the orbit is followed.
  [[nodiscard]] int height(const State& x, int way) const {
    const int s = section_.at(x)[0].sign();
    return (way > 0) == rising_ ? s : -s;
  }

  // (1.2) `leaving`: the orbits start on the section and have not left it for sure.
  [[nodiscard]] Seen look(const FlowStep& s, const State& start, const State& end,
                          bool& leaving) const {
    const int side = side_.at(s.box())[0].sign(), r = rate(s.box()).sign();
    if (section_.at(s.box())[0].sign() != 0 || side < 0 || r < 0) {
      leaving = false;
      return Seen::nothing;
    }
    if (r == 0) return Seen::unknown;
    if (leaving) return Seen::nothing; // 0 at the start, and monotone since
    const int a = height(start, s.way()), b = height(end, s.way());
    if (a < 0 && b > 0) return side > 0 ? Seen::crossing : Seen::unknown;
    return a != 0 && a == b ? Seen::nothing : Seen::unknown;
  }
  // A step that is long, enclosed, and known to cross or not.
  [[nodiscard]] Seen sure_step(FlowStep& s, const State& x, State& end, bool& leaving) const {
    double length = s.guess();
    for (int tries = 0; tries < most_lengths; ++tries, length *= shorter) {
      if (!s.contains(length)) continue;
      end = s.end();
      const Seen seen = look(s, x, end, leaving);
      if (seen != Seen::unknown) return seen;
    }
    throw Refused{"a step of an orbit is not enclosed"};
  }

  // Interval Newton for the time; the derivatives are those of the crossing by the chart.
  [[nodiscard]] State landing(const FlowStep& s) const {
    Interval t = s.duration();
    State x = s.box();
    for (int round = 0; round < landing_rounds; ++round) {
      const Interval m = t.middle(), value = section_.at(s.at(m))[0];
      t = t.meet(m - (rising_ ? value : -value) / rate(x));
      x = s.at(t);
    }
    const State field = field_.at(x), slope = gradient_.at(x);
    const Interval signed_rate = rising_ ? rate(x) : -rate(x);
    for (std::size_t u = 4; u < x.size(); u += 4) {
      const Interval later = along(slope, &x[u]) / signed_rate;
      for (std::size_t i = 0; i < 4; ++i)
        x[u + i] = x[u + i] - field[i] * later;
    }
    return x;
  }

  Polynomials field_, with_derivatives_, section_, gradient_, side_;
  bool rising_;
  double budget_ = max_homoclinic_work;
};

} // namespace kov::certify
