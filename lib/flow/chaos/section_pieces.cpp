#include "flow/chaos/section_pieces.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "system/in_ring.hpp"

#include <algorithm>
#include <cmath>

namespace kov::flow {
namespace {

// The coordinate that f = 0 gives as a polynomial of the others, and that polynomial.
std::optional<std::pair<std::size_t, MFraction>>
linear_in_one(const MFraction& f, const std::vector<std::size_t>& coordinates) {
  for (const std::size_t x : coordinates) {
    const auto c = coefficients(f.num(), x);
    if (c.size() == 2 && is_constant(c[1])) return {{x, -(MFraction(c[0]) / MFraction(c[1]))}};
  }
  return std::nullopt;
}

std::string fresh(std::string name, const std::vector<std::string>& names) {
  while (is_among(name, names))
    name += "_";
  return name;
}

// X(X(sigma)) = a sigma + b X(sigma), where b has no pole all over {sigma = X(sigma) = 0}: this set is invariant then.
std::optional<std::array<MFraction, 2>> linear_equation(const SystemScene& s) {
  const VectorField& v = s.system.field;
  const MFraction& sigma = s.section.value;
  if (!is_constant(sigma.den())) return std::nullopt;
  const auto solved = linear_in_one(sigma, v.coordinates);
  if (!solved) return std::nullopt;
  const Substitution on_section{{solved->first, solved->second}};
  const MFraction first = lie_derivative(v, sigma), second = lie_derivative(v, first);
  try {
    const MFraction first0 = substitute(first, on_section),
                    second0 = substitute(second, on_section);
    if (is_zero(first0)) return std::nullopt;
    const MFraction b = second0 / first0;
    if (!is_constant(gcd(b.den(), first0.num()))) return std::nullopt;
    const MFraction a = (second - second0 - b * (first - first0)) / sigma;
    KOV_ENSURE(is_zero(second - a * sigma - b * first));
    return std::array{a, b};
  } catch (const DomainError&) { // the section is where the field has a pole
    return std::nullopt;
  }
}

// The same system with xi' = eta, eta' = a xi + b eta, and the section xi = 0.
std::optional<SystemScene> with_ratio(const SystemScene& s) {
  const auto ab = linear_equation(s);
  if (!ab) return std::nullopt;
  auto names = s.system.ring()->names();
  for (const char* name : {"xi", "eta"})
    names.push_back(fresh(name, names));
  const Ring ring = make_ring(names);
  SystemScene wide = s;
  wide.system = in_ring(s.system, ring);
  wide.system.kind = SystemKind::vector_field;
  VectorField& v = wide.system.field;
  v.hamiltonian.reset();
  v.poisson.reset();
  const std::size_t xi = names.size() - 2, eta = names.size() - 1;
  const MFraction x = MFraction::variable(ring, xi), y = MFraction::variable(ring, eta);
  for (FunctionSymbol& f : v.functions)
    f.gradient.resize(f.gradient.size() + 2, MFraction(ring));
  v.coordinates.insert(v.coordinates.end(), {xi, eta});
  v.components.push_back(y);
  v.components.push_back(transfer((*ab)[0], ring) * x + transfer((*ab)[1], ring) * y);
  wide.section.value = x;
  for (SceneFormula& f : wide.plot)
    f.value = transfer(f.value, ring);
  if (wide.where) wide.where->value = transfer(wide.where->value, ring);
  wide.levels.clear();
  wide.start.clear();
  wide.written.reset();
  return wide;
}

DoubleBall ball_of(const Integer& n) {
  Enclosure e;
  arb_set_fmpz(e.raw(), n.raw());
  return double_ball(e);
}
DoubleBall ball_of(const Quantity& q) { return double_ball(q.as<Enclosure>()); }

} // namespace

SectionPieces::SectionPieces(const SystemScene& scene, const Chart& chart,
                             const std::atomic<bool>* stop)
    : chart_(chart), dimension_(scene.system.field.dimension()) {
  for (const std::size_t j : chart.free)
    inputs_.push_back(scene.system.field.coordinates[j]);
  inputs_.push_back(0);
  for (const auto& [variable, value] : scene.values) {
    inputs_.push_back(variable);
    values_.push_back(ball_of(value));
  }
  // not where a denominator vanishes on the section, more than one coordinate is left, or formulas are too large
  known_ = tried<DomainError, InvalidArgument, OutOfBudget>([&] {
    solve(scene, chart);
    plain_ = std::make_unique<Map>(scene, stop);
    if (const auto wide = with_ratio(scene)) ratio_ = std::make_unique<Map>(*wide, stop);
  });
}

// Coordinates that the equations give as polynomials of the others are put in, until one equation is left.
void SectionPieces::solve(const SystemScene& scene, const Chart& chart) {
  const VectorField& v = scene.system.field;
  std::vector<std::pair<MFraction, Quantity>> equations{{scene.section.value, Quantity("0")}};
  for (const auto& level : scene.levels)
    equations.emplace_back(level.function.value, level.value);
  std::vector<std::size_t> left;
  for (const std::size_t j : chart.rest)
    left.push_back(v.coordinates[j]);
  std::vector<std::pair<std::size_t, MFraction>> others;
  while (equations.size() > 1) {
    std::optional<std::pair<std::size_t, MFraction>> found;
    auto e = equations.begin();
    for (; e != equations.end() && !found; ++e)
      if (e->second.is_zero()) found = linear_in_one(e->first, left);
    if (!found) throw InvalidArgument("no equation is linear");
    equations.erase(e - 1);
    left.erase(std::ranges::find(left, found->first));
    const Substitution put{{found->first, found->second}};
    for (auto& [f, target] : equations)
      f = substitute(f, put);
    for (auto& [x, f] : others)
      f = substitute(f, put);
    others.push_back(*found);
  }
  inputs_[2] = left.at(0);
  const auto place = [&](std::size_t x) {
    return static_cast<std::size_t>(std::ranges::find(v.coordinates, x) - v.coordinates.begin());
  };
  unknown_ = place(left[0]);
  const auto& [f, target] = equations[0];
  target_ = ball_of(target);
  for (const MPoly& c : coefficients(f.num(), left[0]))
    numerator_.push_back(coefficient(c));
  for (const MPoly& c : coefficients(f.den(), left[0]))
    denominator_.push_back(coefficient(c));
  for (const auto& [x, g] : others) {
    Polynomial p = polynomial(g.num());
    const Ball below = polynomial(g.den()).at(std::vector<Ball>(inputs_.size()));
    for (auto& term : p.terms)
      term.c /= below;
    others_.emplace_back(place(x), p);
  }
}

// ---- polynomials in balls ----

SectionPieces::Polynomial SectionPieces::polynomial(const MPoly& f) const {
  Polynomial p;
  for (long i = 0; i < f.length(); ++i) {
    const auto all = f.exponents(i);
    Polynomial::Term term{ball_of(f.coefficient(i)), {}};
    unsigned long seen = 0, sum = 0;
    for (const std::size_t x : inputs_) {
      term.exponents.push_back(static_cast<int>(all[x]));
      seen += all[x];
    }
    for (const unsigned long e : all)
      sum += e;
    if (seen != sum) throw InvalidArgument("another variable");
    p.terms.push_back(std::move(term));
  }
  return p;
}

DoubleBall SectionPieces::Polynomial::at(const std::vector<Ball>& x) const {
  Ball sum(0);
  for (const Term& term : terms) {
    Ball product = term.c;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (term.exponents[i] > 0) product *= power(x[i], term.exponents[i]);
    sum += product;
  }
  return sum;
}

SectionPieces::Polynomial SectionPieces::Polynomial::derivative(std::size_t i) const {
  Polynomial d;
  for (const Term& term : terms)
    if (term.exponents[i] > 0) {
      d.terms.push_back({term.c * Ball(term.exponents[i]), term.exponents});
      --d.terms.back().exponents[i];
    }
  return d;
}

SectionPieces::Coefficient SectionPieces::coefficient(const MPoly& f) const {
  const Polynomial p = polynomial(f);
  return {p, {p.derivative(0), p.derivative(1)}};
}

// Encloses the coefficient by the mean value theorem, and term by term.
DoubleBall SectionPieces::Coefficient::over(const std::vector<Ball>& box,
                                            const std::vector<Ball>& middle) const {
  Ball mean = f.at(middle);
  for (std::size_t d = 0; d < 2; ++d)
    mean += slope[d].at(box) * (box[d] - middle[d]);
  const auto both = intersection(mean, f.at(box));
  return both ? *both : mean;
}

// ---- the pieces ----

namespace {

// The values of a polynomial and of its derivative.
std::array<DoubleBall, 2> horner(const std::vector<DoubleBall>& c, const DoubleBall& x) {
  std::array<DoubleBall, 2> v{DoubleBall(0), DoubleBall(0)};
  for (std::size_t k = c.size(); k-- > 0;) {
    v[1] = v[1] * x + v[0];
    v[0] = v[0] * x + c[k];
  }
  return v;
}

bool may_vanish(const std::vector<DoubleBall>& c, double low, double high) {
  const DoubleBall x = DoubleBall::between(low, high);
  const auto over = horner(c, x);
  if (!over[0].contains_zero()) return false;
  const DoubleBall m = x.middle();
  return (horner(c, m)[0] + over[1] * (x - m)).contains_zero();
}

// All real zeros lie below it in modulus (Lagrange); nothing if the leading coefficient may vanish.
std::optional<double> bound_of_zeros(const std::vector<DoubleBall>& c) {
  const std::size_t n = c.size() - 1;
  if (!std::ranges::all_of(c, [](const DoubleBall& x) { return x.finite(); })) return std::nullopt;
  if (!(c[n].is_positive() || c[n].is_negative())) return std::nullopt;
  double most = 0;
  for (std::size_t k = 1; k <= n; ++k)
    most = std::fmax(most, std::pow((c[n - k] / c[n]).most() * (1 + 1e-9), 1 / double(k)));
  most = 2 * most * (1 + 1e-9) + 1e-200;
  if (!(most < 1e100)) return std::nullopt;
  return most;
}

// A simple zero, as far as its box is known.
DoubleBall sharper(const std::vector<DoubleBall>& c, DoubleBall x) {
  for (int i = 0; i < 8; ++i) {
    const DoubleBall slope = horner(c, x)[1], m = x.middle();
    if (slope.contains_zero()) break;
    const auto both = intersection(m - horner(c, m)[0] / slope, x);
    if (!both || !(both->radius() < 0.9 * x.radius())) break;
    x = *both;
  }
  return x;
}

} // namespace

std::vector<DoubleBall> SectionPieces::equation_over(const std::array<Ball, 2>& box) {
  std::vector<Ball> x{box[0], box[1], Ball(0)};
  x.insert(x.end(), values_.begin(), values_.end());
  std::vector<Ball> middle = x;
  for (std::size_t d = 0; d < 2; ++d)
    middle[d] = x[d].middle();
  std::vector<Ball> c(std::max(numerator_.size(), denominator_.size()), Ball(0));
  for (std::size_t k = 0; k < numerator_.size(); ++k)
    c[k] = numerator_[k].over(x, middle);
  for (std::size_t k = 0; k < denominator_.size(); ++k)
    c[k] -= target_ * denominator_[k].over(x, middle);
  return c;
}

SectionPieces::Piece SectionPieces::piece(const std::array<Ball, 2>& box,
                                          const Ball& unknown) const {
  std::vector<Ball> x{box[0], box[1], unknown};
  x.insert(x.end(), values_.begin(), values_.end());
  std::vector<Ball> all(dimension_);
  all[unknown_] = unknown;
  for (std::size_t d = 0; d < 2; ++d)
    all[chart_.free[d]] = box[d];
  for (const auto& [j, f] : others_)
    all[j] = f.at(x);
  return {std::move(all)};
}

std::array<DoubleBall, 2> SectionPieces::rate_and_side(const Piece& p) {
  const auto v = plain_->map.values(PhasePoint<Ball>(p.x.begin(), p.x.end()));
  return {plain_->map.rate(v), v.side.v};
}

// False: the rate has the other sign all over the piece, or `where` is negative.
bool SectionPieces::is_crossed(const Piece& p) {
  const auto [rate, side] = rate_and_side(p);
  return !rate.is_negative() && !side.is_negative();
}

// In ever smaller parts of an interval that holds all, while that helps.
std::vector<SectionPieces::Interval> SectionPieces::zeros(const std::array<Ball, 2>& box,
                                                          const std::vector<Ball>& equation) {
  const double most = *bound_of_zeros(equation);
  std::vector<Interval> found{{-most, most}};
  double length = 2 * most;
  for (int round = 0; round < 5 && !found.empty(); ++round) {
    std::vector<Interval> next;
    const auto look = [&](auto&& self, double low, double high, int parts) -> void {
      if (!may_vanish(equation, low, high)) return;
      if (parts > 1) {
        const double m = low + (high - low) / 2;
        self(self, low, m, parts / 2);
        return self(self, m, high, parts / 2);
      }
      if (!is_crossed(piece(box, Ball::between(low, high)))) return;
      if (!next.empty() && next.back().high == low)
        next.back().high = high;
      else
        next.push_back({low, high});
    };
    double left = 0;
    for (const Interval& i : found)
      look(look, i.low, i.high, 16);
    for (const Interval& i : next)
      left += i.high - i.low;
    found = std::move(next);
    if (left > 0.7 * length) break;
    length = left;
  }
  return found;
}

std::optional<std::vector<SectionPieces::Piece>>
SectionPieces::over(const std::array<Ball, 2>& box) {
  if (!known_) return std::nullopt;
  const std::vector<Ball> c = equation_over(box);
  std::vector<Piece> all;
  if (c.size() == 1 && !c[0].contains_zero()) return all;
  if (c.size() < 2 || !bound_of_zeros(c)) return std::nullopt;
  for (const Interval& i : zeros(box, c)) {
    const Ball x = sharper(c, Ball::between(i.low, i.high));
    Piece p = piece(box, x);
    if (!is_crossed(p)) continue;
    p.folded = horner(c, x)[1].contains_zero() || rate_and_side(p)[0].contains_zero();
    all.push_back(std::move(p));
  }
  return all;
}

bool SectionPieces::moves(const Piece& piece, int turns) {
  std::vector<Ball> start = piece.x;
  Map& m = ratio_ ? *ratio_ : *plain_;
  if (ratio_) // xi = 0, eta = +-1: a fixed point has the same eta again
    start.insert(start.end(), {Ball(0), Ball(plain_->surface.rising() ? 1 : -1)});
  return tried<NotProved>([&] { // else smaller boxes may do
    const auto l = m.map.landing_from(start, turns);
    for (std::size_t j = 0; j < start.size(); ++j)
      if (!(l.at[j].v - start[j]).contains_zero()) return true;
    return false;
  });
}

} // namespace kov::flow
