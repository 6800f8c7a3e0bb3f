#include "certify/jets/motion.hpp"

#include "certify/equation/facts.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

Motion::Motion(const JetsCertificate& c, Arithmetic& a)
    : c_(c), arithmetic_(a), a_(c.field, a), s_(a_) {}

// Refuses a constant with c1 or c2 in it, or with e unless that is allowed.
void Motion::need_free(const CurveFunction& given, bool of_e) const {
  const CurveFunction f = a_.reduced(given);
  need(!uses(f.p, c_.c1()) && !uses(f.p, c_.c2()) && (of_e || !uses(f.p, c_.e())),
       "a constant has a variable in it");
}

CurveFunction Motion::dot(const std::array<CurveFunction, 2>& a,
                          const std::array<CurveFunction, 2>& b) const {
  CurveFunction sum = a_.zero();
  for (std::size_t i = 0; i < 2; ++i)
    sum = a_.plus(sum, a_.times(c_.line.masses[i], a_.times(a[i], b[i])));
  return sum;
}

void Motion::need_line() {
  rule_ = "J1";
  for (const MPoly& d : c_.field.denominators)
    for (const std::size_t i : {c_.e(), c_.c1(), c_.c2()})
      need(!uses(d, i), "a denominator has a variable in it");
  for (const TowerStep& step : c_.field.tower)
    need_free(step.value, false);
  for (const auto* two :
       {&c_.line.start, &c_.line.across, &c_.line.along, &c_.line.masses, &c_.line.inertias})
    for (const CurveFunction& f : *two)
      need_free(f, false);
  MPoly v = restricted(); // n H - n (a1 p1^2 + a2 p2^2)/2
  const CurveFunction one = a_.integer(1);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto c = coefficients(v, 2 + c_.others + i);
    need(c.size() == 3 && is_zero(c[1]), "H is not a natural Hamiltonian");
    for (std::size_t k = 0; k < 4 + 2 * c_.others; ++k)
      need(!uses(c[2], k), "H is not a natural Hamiltonian");
    Table inertia = chart_potential(c[2]);
    CurveFunction twice = inertia.count({0, 0}) ? inertia.at({0, 0}) : a_.zero();
    twice = a_.over(a_.times(a_.integer(2), twice), c_.hamiltonian.n);
    need(equal(a_.times(twice, c_.line.masses[i]), one), "a mass is not that of H");
    v = c[0];
  }
  need(is_zero(dot(c_.line.across, c_.line.along).p), "the axes are not orthogonal");
  need(equal(a_.times(c_.line.inertias[0], dot(c_.line.across, c_.line.across)), one) &&
           equal(a_.times(c_.line.inertias[1], dot(c_.line.along, c_.line.along)), one),
       "an inertia is not that of the axis");
  potential_ = chart_potential(v);
  for (auto& [e, k] : potential_)
    k = a_.over(k, c_.hamiltonian.n);
  const auto minus = [&](const CurveFunction& f) { return a_.times(a_.integer(-1), f); };
  across_ = s_.derivative(potential_, 0, minus(c_.line.inertias[0]));
  along_ = s_.derivative(potential_, 1, minus(c_.line.inertias[1]));
  need(column(across_, 0).empty(), "the force does not point along the line");
}

MPoly Motion::restricted() const {
  const std::size_t n = 2 + c_.others;
  std::vector<std::size_t> zero;
  for (std::size_t l = 2; l < n; ++l)
    zero.insert(zero.end(), {l, l + n});
  const auto at_zero = [&](MPoly f) {
    for (const std::size_t i : zero)
      f = is_zero(f) ? f : coefficients(f, i)[0];
    return f;
  };
  for (const std::size_t i : zero)
    need(is_zero(at_zero(kov::derivative(c_.hamiltonian.p, i))), "the subspace is not invariant");
  return at_zero(c_.hamiltonian.p);
}

// A polynomial in q1, q2, parameters and constants, at q = start + x across + y along.
Table Motion::chart_potential(const MPoly& v) const {
  std::array<std::vector<Table>, 2> powers;
  for (std::size_t i = 0; i < 2; ++i) {
    Table q = s_.plus({}, {{{0, 0}, c_.line.start[i]}});
    q = s_.plus(q, {{{1, 0}, c_.line.across[i]}});
    q = s_.plus(q, {{{0, 1}, c_.line.along[i]}});
    powers[i] = {{{{0, 0}, a_.integer(1)}}, q};
  }
  const auto power = [&](std::size_t i, unsigned long n) {
    need_within(n <= max_jet_degree, "the degree of the potential is too large");
    while (powers[i].size() <= n)
      powers[i].push_back(s_.times(powers[i].back(), powers[i][1]));
    return powers[i][n];
  };
  std::vector<std::optional<CurveFunction>> at(c_.phase->size());
  for (std::size_t i = 4 + 2 * c_.others; i < at.size(); ++i)
    at[i] = a_.variable(c_.field.ring->index(c_.phase->name(i)));
  Table sum;
  for (long k = 0; k < v.length(); ++k) {
    auto e = v.exponents(k);
    for (std::size_t i = 2; i < 4 + 2 * c_.others; ++i)
      need(e[i] == 0, "H is not a natural Hamiltonian");
    const Table q = s_.times(power(0, e[0]), power(1, e[1]));
    e[0] = e[1] = 0;
    const MPoly term = MPoly::term(c_.phase, v.coefficient(k), e);
    sum = s_.plus(std::move(sum), s_.times({{{0, 0}, a_.evaluate(term, at)}}, q));
  }
  return sum;
}

CurveRow Motion::column(const Table& f, long power_of_x) const {
  CurveRow all;
  for (const auto& [e, k] : f) {
    if (e.first != power_of_x) continue;
    all.resize(static_cast<std::size_t>(e.second) + 1, a_.zero()); // in ascending order of y
    all.back() = k;
  }
  return all;
}

// f(y), as the forces are: in the time t.
LocalSeries Motion::polynomial_at(const CurveRow& f) const {
  LocalSeries sum;
  for (std::size_t b = f.size(); b-- > 0;) {
    sum = s_.times(sum, y_);
    if (!is_zero(f[b].p))
      sum = s_.plus(sum, {0, {a_.times(c_.time_scale, f[b])}, LocalSeries::exact});
  }
  return sum;
}

LocalSeries Motion::read(const JetSeries& x, long degree_in_c) const {
  if (!x) return {};
  LocalSeries series{x->low, x->terms, x->low + static_cast<long>(x->terms.size())};
  for (CurveFunction& f : series.c) {
    f = a_.reduced(f);
    for (long k = 0; k < f.p.length(); ++k) {
      const auto e = f.p.exponents(k);
      need(static_cast<long>(e[c_.c1()] + e[c_.c2()]) == degree_in_c,
           "a series is not homogeneous in c1 and c2");
    }
  }
  return s_.trimmed(std::move(series));
}

LocalSeries Motion::acceleration(const LocalSeries& x) const {
  return s_.derivative(s_.derivative(x, c_.turns), c_.turns);
}

// x'' = force, as far as x is given, and that is beyond the last root.
void Motion::need_solution(const LocalSeries& x, const LocalSeries& force, long last_root) const {
  if (x.is_exact_zero()) return need(force.is_exact_zero(), "a series is not 0");
  need(x.end > last_root, "a series ends before the last resonance");
  const LocalSeries rest = s_.minus(acceleration(x), force);
  need(rest.start() >= x.end - 2 * c_.turns, "a series is not a solution as far as it is given");
}

void Motion::need_place() {
  rule_ = "J2";
  const CurveRow v = potential(), w = normal();
  degree_ = static_cast<long>(v.size()) - 1;
  const long k = degree_, d = c_.turns;
  need(k >= 3, "the potential on the line is of degree < 3");
  need(static_cast<long>(w.size()) <= k - 1, "the normal equation is irregular at infinity");
  need(2 * d % (k - 2) == 0, "the number of turns is wrong");
  first_ = -2 * d / (k - 2);
  last_ = 2 * d - first_;
  need_free(c_.time_scale, false);
  const CurveFunction scaled = a_.times(c_.time_scale, tangential().back());
  const Integer square(d * d);
  need(equal(scaled, a_.over(a_.integer(first_ * (first_ - d)), square)), "the time is not scaled");
  y_ = read(c_.solution, 0);
  need(!y_.c.empty() && y_.low == first_ && equal(y_.c[0], a_.integer(1)),
       "the solution does not begin as it must");
  need_solution(y_, polynomial_at(tangential()), last_);
  need(equal(s_.coefficient(y_, last_), a_.variable(c_.e())), "e is not a coefficient");
}

void Motion::need_normal() {
  rule_ = "J3";
  const LocalSeries w = polynomial_at(normal());
  for (std::size_t i = 0; i < 2; ++i) {
    u_[i] = read(c_.normal[i], 0);
    need(!u_[i].c.empty() && u_[i].low == c_.normal[i]->low, "a solution does not begin with 1");
  }
  need(u_[0].low + u_[1].low == c_.turns && u_[0].low < u_[1].low, "the exponents are wrong");
  for (const LocalSeries& u : u_) {
    need(equal(u.c[0], a_.integer(1)), "a solution does not begin with 1");
    need_solution(u, s_.times(w, u), u_[1].low);
  }
}

Rational Motion::difference() const { return {u_[1].low - u_[0].low, c_.turns}; }

void Motion::need_jets() {
  rule_ = "J4";
  const auto k = static_cast<std::size_t>(c_.order);
  GradedSeries x(k + 1), y(k + 1);
  y[0] = y_;
  x[1] = s_.plus(s_.times(a_.variable(c_.c1()), u_[0]), s_.times(a_.variable(c_.c2()), u_[1]));
  for (std::size_t j = 2; j < k; ++j) {
    x[j] = read(c_.across[j - 2], static_cast<long>(j));
    y[j] = read(c_.along[j - 2], static_cast<long>(j));
  }
  forces_x_ = s_.value(across_, x, y);
  forces_y_ = s_.value(along_, x, y);
  for (std::size_t j = 2; j < k; ++j) {
    need_solution(x[j], s_.times(c_.time_scale, forces_x_[j]), u_[1].low);
    need_solution(y[j], s_.times(c_.time_scale, forces_y_[j]), last_);
  }
}

// The derivative by the variable i, in which f is a polynomial.
CurveFunction Motion::by(const CurveFunction& f, std::size_t i) const {
  return a_.reduced({kov::derivative(f.p, i), f.n, f.over});
}

void Motion::need_residues() {
  rule_ = "J5";
  const LocalSeries f = s_.times(c_.time_scale, forces_x_.back());
  const CurveFunction form = a_.reduced(c_.form);
  for (long k = 0; k < form.p.length(); ++k) {
    const auto e = form.p.exponents(k);
    need(static_cast<long>(e[c_.c1()] + e[c_.c2()]) == c_.order + 1, "the form has another degree");
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const CurveFunction residue = s_.coefficient(f, u_[i], -c_.turns);
    const CurveFunction slope = by(form, i == 0 ? c_.c1() : c_.c2());
    need(is_zero(a_.plus(residue, slope).p), "the form is not that of the residues");
  }
}

CurveFunction Motion::entry(long i) const {
  const CurveFunction form = a_.reduced(c_.form);
  if (i < 0 || i > c_.order + 1) return a_.zero();
  const auto by_c1 = coefficients(form.p, c_.c1());
  if (static_cast<std::size_t>(i) >= by_c1.size()) return a_.zero();
  const auto by_c2 = coefficients(by_c1[static_cast<std::size_t>(i)], c_.c2());
  const auto rest = static_cast<std::size_t>(c_.order + 1 - i);
  if (rest >= by_c2.size()) return a_.zero();
  return a_.reduced({by_c2[rest], form.n, form.over});
}

// The columns of c1 R_2, c2 R_2 - c1 R_1, c2 R_1 (jets.md 2.5), or an entry of R.
void Motion::need_minor() {
  rule_ = "J6";
  const auto& columns = c_.obstruction.columns;
  const long n = c_.order + 1;
  CurveFunction minor = a_.zero();
  if (std::holds_alternative<ByHomogeneity>(c_.group)) {
    need(columns.size() == 1, "one column is expected");
    minor = entry(columns[0]);
  } else {
    need(columns.size() == 3 && columns[0] < columns[1] && columns[1] < columns[2],
         "three columns are expected");
    std::array<std::array<CurveFunction, 3>, 3> m;
    for (std::size_t k = 0; k < 3; ++k) {
      const long j = columns[k];
      m[k] = {a_.times(a_.integer(n - j + 1), entry(j - 1)),
              a_.times(a_.integer(n - 2 * j), entry(j)), a_.times(a_.integer(j + 1), entry(j + 1))};
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &b = m[(k + 1) % 3], &c = m[(k + 2) % 3];
      minor =
          a_.plus(minor, a_.times(m[k][0], a_.minus(a_.times(b[1], c[2]), a_.times(b[2], c[1]))));
    }
  }
  const CurveFunction& value = c_.obstruction.value; // as it is shown: w^2 may be a parameter
  need_free(value, true);
  need(!is_zero(value.p), "the obstruction is 0");
  for (std::size_t i = 0; i < c_.field.tower.size(); ++i)
    need(!uses(value.p, i), "the value has an algebraic constant in it");
  need(equal(a_.times(a_.reduced(c_.obstruction.cofactor), minor),
             a_.power(value, static_cast<unsigned long>(c_.obstruction.power))),
       "the obstruction has another value");
}

// y_t^2/(2 A scale) + v(y): of s^0.  1/(A scale) = -k v_k/(sigma (sigma - 1)).
CurveFunction Motion::energy() const {
  const CurveRow v = potential();
  const CurveFunction down = a_.over(a_.times(a_.integer(-degree_ * c_.turns * c_.turns), v.back()),
                                     Integer(2 * first_ * (first_ - c_.turns)));
  const LocalSeries slope = s_.derivative(y_, c_.turns);
  CurveFunction sum = a_.times(down, s_.coefficient(slope, slope, 0));
  LocalSeries value;
  for (std::size_t b = v.size(); b-- > 0;) {
    value = s_.times(value, y_);
    if (!is_zero(v[b].p)) value = s_.plus(value, {0, {v[b]}, LocalSeries::exact});
  }
  return a_.plus(sum, s_.coefficient(value, 0));
}

} // namespace kov::certify
