#include "certify/homoclinic/flow.hpp"

#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {
namespace {

constexpr long room_of_a_step = -72; // binary logarithm of what a Taylor polynomial is widened by
constexpr int most_steps = 600;      // of a return
constexpr int most_lengths = 80;     // tried for one step
constexpr double longest_step = 0.5;
constexpr double shorter = 0.7;
constexpr int landing_rounds = 12;

Rational quotient(const Integer& c, const Integer& n) { return {c, n}; }

} // namespace

PhaseFunction partial(const PhaseFunction& f, std::size_t i) { return {derivative(f.p, i), f.n}; }

// ---- polynomials ----

Polynomials::Polynomials(const std::vector<PhaseFunction>& all) {
  for (const PhaseFunction& f : all) {
    Row row;
    for (long i = 0; i < f.p.length(); ++i) {
      const auto e = f.p.exponents(i);
      const Monomial m{e[0], e[1], e[2], e[3]};
      Interval c(quotient(f.p.coefficient(i), f.n));
      if (m == Monomial{})
        row.constant = c;
      else
        row.terms.emplace_back(node(m), std::move(c));
    }
    rows_.push_back(std::move(row));
  }
}

std::size_t Polynomials::node(const Monomial& m) {
  const auto known = place_.find(m);
  if (known != place_.end()) return known->second;
  std::size_t x = 0;
  while (m[x] == 0)
    ++x;
  Monomial rest = m;
  --rest[x];
  std::size_t at = x;
  if (rest != Monomial{}) {
    const std::size_t before = node(rest);
    at = 4 + products_.size();
    products_.emplace_back(before, x);
  }
  return place_[m] = at;
}

std::vector<Interval> Polynomials::at(const Point& x) const {
  std::vector<Interval> v(x.begin(), x.end()), out;
  for (const auto& [a, b] : products_)
    v.push_back(v[a] * v[b]);
  for (const Row& row : rows_) {
    Interval sum = row.constant;
    for (const auto& [i, c] : row.terms)
      arb_addmul(sum.raw(), c.raw(), v[i].raw(), Interval::bits);
    out.push_back(std::move(sum));
  }
  return out;
}

// ---- series ----

Series::Series(const Polynomials& field, const Jet& x, int order)
    : nodes_(x.size(), std::vector<Row>(4 + field.products_.size())) {
  for (std::size_t part = 0; part < x.size(); ++part) {
    for (Row& row : nodes_[part])
      row.reserve(static_cast<std::size_t>(order) + 1);
    for (std::size_t i = 0; i < 4; ++i)
      nodes_[part][i].push_back(x[part][i]);
  }
  for (int k = 0; k < order; ++k) {
    multiply(field, k);
    integrate(field, k);
  }
}

namespace {

// sum += the coefficient k of f g
void add_coefficient(Interval& sum, const std::vector<Interval>& f, const std::vector<Interval>& g,
                     int k) {
  static_assert(sizeof(Interval) == sizeof(arb_struct)); // rows are vectors of arb_struct
  arb_dot(sum.raw(), sum.raw(), 0, f.front().raw(), 1, g[static_cast<std::size_t>(k)].raw(), -1,
          k + 1, Interval::bits);
}

} // namespace

void Series::multiply(const Polynomials& field, int k) {
  for (std::size_t i = 0; i < field.products_.size(); ++i) {
    const auto [a, b] = field.products_[i];
    for (std::size_t part = 0; part < nodes_.size(); ++part) {
      Interval sum;
      add_coefficient(sum, nodes_[0][a], nodes_[part][b], k);
      if (part > 0) add_coefficient(sum, nodes_[part][a], nodes_[0][b], k);
      nodes_[part][4 + i].push_back(std::move(sum));
    }
  }
}

void Series::integrate(const Polynomials& field, int k) {
  const auto at = static_cast<std::size_t>(k);
  for (std::size_t part = 0; part < nodes_.size(); ++part)
    for (std::size_t i = 0; i < 4; ++i) {
      const Polynomials::Row& row = field.rows_[i];
      Interval sum = k == 0 && part == 0 ? row.constant : Interval();
      for (const auto& [node, c] : row.terms)
        arb_addmul(sum.raw(), c.raw(), nodes_[part][node][at].raw(), Interval::bits);
      arb_div_si(sum.raw(), sum.raw(), k + 1, Interval::bits);
      nodes_[part][i].push_back(std::move(sum));
    }
}

Jet Series::coefficient(int k) const {
  Jet x(nodes_.size());
  for (std::size_t part = 0; part < x.size(); ++part)
    for (std::size_t i = 0; i < 4; ++i)
      x[part][i] = nodes_[part][i][static_cast<std::size_t>(k)];
  return x;
}

Jet Series::at(const Interval& t, int degree) const {
  Jet x = coefficient(degree);
  for (std::size_t part = 0; part < x.size(); ++part)
    for (std::size_t i = 0; i < 4; ++i)
      for (int k = degree; k-- > 0;)
        x[part][i] = x[part][i] * t + nodes_[part][i][static_cast<std::size_t>(k)];
  return x;
}

double Series::largest(int k) const {
  double most = 0;
  for (const Point& p : coefficient(k))
    for (const Interval& c : p)
      most = std::max(most, c.most().about());
  return most;
}

// ---- a step ----

namespace {

// Products of a series of the order of a step.
double price(std::size_t parts, std::size_t nodes) {
  return static_cast<double>(parts * nodes) * FlowStep::order * FlowStep::order;
}

} // namespace

FlowStep::FlowStep(const Polynomials& field, const Jet& x, int way, FlowBudget& budget)
    : field_(field), way_(way), budget_(budget), series_(field, x, order) {
  budget_.spend(price(x.size(), series_.nodes()));
}

double FlowStep::guess() const {
  const double size = std::max(series_.largest(order), 1e-300);
  return std::min(longest_step,
                  0.9 * std::pow(std::ldexp(1.0, room_of_a_step) / size, 1.0 / order));
}

Interval FlowStep::duration() const {
  return Interval::from_zero(Interval::exactly(way_ * length_));
}

// The Picard operator maps the functions that stay in the box into themselves if the polynomial and
// the remainder do.
bool FlowStep::contains(double length) {
  length_ = std::ldexp(std::floor(std::ldexp(length, 30)), -30); // exact in all that follows
  box_ = series_.at(duration(), order);
  const Interval room = power_of_two(room_of_a_step);
  for (Point& p : box_)
    for (Interval& c : p)
      c = c.wider(room);
  budget_.spend(price(box_.size(), series_.nodes()));
  last_ = Series(field_, box_, order + 1).coefficient(order + 1);
  const Interval reach = power(Interval::exactly(length_), order + 1);
  return std::ranges::all_of(last_, [&](const Point& p) {
    return std::ranges::all_of(p, [&](const Interval& c) { return (c * reach).most() < room; });
  });
}

Jet FlowStep::at(const Interval& t) const {
  const Interval reach = power(t, order + 1);
  Jet x = series_.at(t, order);
  for (std::size_t part = 0; part < x.size(); ++part)
    for (std::size_t i = 0; i < 4; ++i)
      x[part][i] = x[part][i] + reach * last_[part][i];
  return x;
}

// ---- the section ----

namespace {

std::vector<PhaseFunction> canonical_field(const PhaseFunction& h) {
  std::vector<PhaseFunction> x{partial(h, 2), partial(h, 3), partial(h, 0), partial(h, 1)};
  for (std::size_t i = 2; i < 4; ++i)
    x[i].p = -x[i].p;
  return x;
}

std::vector<PhaseFunction> gradient(const PhaseFunction& f) {
  return {partial(f, 0), partial(f, 1), partial(f, 2), partial(f, 3)};
}

Interval along(const std::vector<Interval>& gradient, const Point& x) {
  Interval sum;
  for (std::size_t i = 0; i < 4; ++i)
    sum = sum + gradient[i] * x[i];
  return sum;
}

} // namespace

SectionFlow::SectionFlow(const PhaseFunction& hamiltonian, const PhaseFunction& section,
                         const std::optional<PhaseFunction>& where, bool rising)
    : field_(canonical_field(hamiltonian)), section_({section}), gradient_(gradient(section)),
      side_({where ? *where : PhaseFunction{MPoly(section.p.ring(), Integer(1)), Integer(1)}}),
      rising_(rising), budget_{max_homoclinic_work} {}

// d(section)/dt, positive at a wanted crossing.
Interval SectionFlow::rate(const Point& x) const {
  const auto v = field_.at(x);
  const Interval r = along(gradient_.at(x), {v[0], v[1], v[2], v[3]});
  return rising_ ? r : -r;
}

// The sign of the section's function, which grows through a wanted crossing as the orbit is followed.
int SectionFlow::height(const Point& x, int way) const {
  const int s = section_.at(x)[0].sign();
  return (way > 0) == rising_ ? s : -s;
}

// (1.2) `leaving`: the orbits start on the section and have not left it for sure.
SectionFlow::Seen SectionFlow::look(const FlowStep& s, const Jet& start, const Jet& end,
                                    bool& leaving) const {
  const Point& box = s.box()[0];
  const int side = side_.at(box)[0].sign(), r = rate(box).sign();
  if (section_.at(box)[0].sign() != 0 || side < 0 || r < 0) {
    leaving = false;
    return Seen::nothing;
  }
  if (r == 0) return Seen::unknown;
  if (leaving) return Seen::nothing; // 0 at the start, and monotone since
  const int a = height(start[0], s.way()), b = height(end[0], s.way());
  if (a < 0 && b > 0) return side > 0 ? Seen::crossing : Seen::unknown;
  return a != 0 && a == b ? Seen::nothing : Seen::unknown;
}

// A step that is long, enclosed, and known to cross or not.
SectionFlow::Seen SectionFlow::sure_step(FlowStep& s, const Jet& x, Jet& end, bool& leaving) const {
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
Jet SectionFlow::landing(const FlowStep& s) const {
  Interval t = s.duration();
  Jet x = s.box();
  for (int round = 0; round < landing_rounds; ++round) {
    const Interval m = t.middle(), value = section_.at(s.at(m)[0])[0];
    t = t.meet(m - (rising_ ? value : -value) / rate(x[0]));
    x = s.at(t);
  }
  const auto field = field_.at(x[0]), slope = gradient_.at(x[0]);
  const Interval signed_rate = rising_ ? rate(x[0]) : -rate(x[0]);
  for (std::size_t part = 1; part < x.size(); ++part) {
    const Interval later = along(slope, x[part]) / signed_rate;
    for (std::size_t i = 0; i < 4; ++i)
      x[part][i] = x[part][i] - field[i] * later;
  }
  return x;
}

void SectionFlow::to_crossing(Jet& x, Jet& thin, const std::array<Interval, 2>& off, int way) {
  bool leaving = true;
  for (int n = 0; n < most_steps; ++n) {
    FlowStep wide(field_, x, way, budget_), narrow(field_, thin, way, budget_);
    Jet end;
    const Seen seen = sure_step(wide, x, end, leaving);
    need(narrow.contains(wide.length()), "a step of the middle orbit is not enclosed");
    const bool lands = seen == Seen::crossing;
    x = lands ? landing(wide) : std::move(end);
    thin = lands ? landing(narrow) : narrow.end();
    tighten(x, thin, off);
    if (lands) return;
  }
  throw Refused{"an orbit does not return"};
}

void tighten(Jet& x, const Jet& thin, const std::array<Interval, 2>& off) {
  for (std::size_t i = 0; i < 4; ++i)
    x[0][i] = x[0][i].meet(thin[0][i] + x[1][i] * off[0] + x[2][i] * off[1]);
}

} // namespace kov::certify
