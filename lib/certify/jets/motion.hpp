#pragma once
// The equations of motion around a line of configurations and the series that solve them: the rules
// J1 to J6 of docs/theory/jet_certificates.md.

#include "certify/jets/series.hpp"

namespace kov::certify {

class Motion {
public:
  /// rule: is set to the one that was last begun
  Motion(const JetsCertificate& c, Arithmetic& a, std::string& rule)
      : c_(c), rule_(rule), a_(c.field, a), s_(a_) {}

  void need_line() { ///< J1
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
    const Integer& below = c_.system.hamiltonian->n;
    const CurveFunction one = a_.integer(1);
    for (std::size_t i = 0; i < 2; ++i) {
      const auto c = coefficients(v, c_.system.dimension / 2 + i);
      need(c.size() == 3 && is_zero(c[1]), "H is not a natural Hamiltonian");
      for (std::size_t k = 0; k < c_.system.dimension; ++k)
        need(!uses(c[2], k), "H is not a natural Hamiltonian");
      const CurveFunction twice = a_.over(a_.times(a_.integer(2), in_chart(c[2])), below);
      need(a_.equal(a_.times(twice, c_.line.masses[i]), one), "a mass is not that of H");
      v = c[0];
    }
    need(is_zero(dot(c_.line.across, c_.line.along).p), "the axes are not orthogonal");
    need(a_.equal(a_.times(c_.line.inertias[0], dot(c_.line.across, c_.line.across)), one) &&
             a_.equal(a_.times(c_.line.inertias[1], dot(c_.line.along, c_.line.along)), one),
         "an inertia is not that of the axis");
    potential_ = a_.over(in_chart(v), below);
    across_ = a_.minus(a_.zero(), a_.times(c_.line.inertias[0], by(potential_, c_.c1())));
    along_ = a_.minus(a_.zero(), a_.times(c_.line.inertias[1], by(potential_, c_.c2())));
    need(is_zero(coefficient(across_, c_.c1(), 0).p), "the force does not point along the line");
  }

  void need_place() { ///< J2
    rule_ = "J2";
    degree_ = kov::degree(potential().p, c_.c2());
    const long k = degree_, d = c_.turns;
    need(k >= 3, "the potential on the line is of degree < 3");
    need(kov::degree(normal().p, c_.c2()) <= k - 2, "the normal equation is irregular at infinity");
    need(2 * d % (k - 2) == 0, "the number of turns is wrong");
    first_ = -2 * d / (k - 2);
    last_ = 2 * d - first_;
    need_free(c_.time_scale, false);
    const CurveFunction scaled = a_.times(c_.time_scale, coefficient(tangential(), c_.c2(), k - 1));
    need(a_.equal(scaled, a_.over(a_.integer(first_ * (first_ - d)), Integer(d * d))),
         "the time is not scaled");
    y_ = read(c_.solution, 0);
    need(!y_.c.empty() && y_.low == first_ && a_.equal(y_.c[0], a_.integer(1)),
         "the solution does not begin as it must");
    need_solution(y_, scaled_time(along_the_line(tangential())), last_);
    need(a_.equal(s_.coefficient(y_, last_), a_.variable(c_.e())), "e is not a coefficient");
  }

  void need_normal() { ///< J3
    rule_ = "J3";
    const LocalSeries w = scaled_time(along_the_line(normal()));
    for (std::size_t i = 0; i < 2; ++i) {
      u_[i] = read(c_.normal[i], 0);
      need(!u_[i].c.empty() && u_[i].low == c_.normal[i].low, "a solution does not begin with 1");
    }
    need(u_[0].low + u_[1].low == c_.turns && u_[0].low < u_[1].low, "the exponents are wrong");
    for (const LocalSeries& u : u_) {
      need(a_.equal(u.c[0], a_.integer(1)), "a solution does not begin with 1");
      need_solution(u, s_.times(w, u), u_[1].low);
    }
  }

  void need_jets() { ///< J4
    rule_ = "J4";
    const auto k = static_cast<std::size_t>(c_.order);
    GradedSeries x(k + 1), y(k + 1);
    y[0] = y_;
    x[1] = s_.plus(s_.times(a_.variable(c_.c1()), u_[0]), s_.times(a_.variable(c_.c2()), u_[1]));
    for (std::size_t j = 2; j < k; ++j) {
      x[j] = read(c_.across[j - 2], static_cast<long>(j));
      y[j] = read(c_.along[j - 2], static_cast<long>(j));
    }
    const GradedSeries forces_x = value(across_, x, y), forces_y = value(along_, x, y);
    for (std::size_t j = 2; j < k; ++j) {
      need_solution(x[j], scaled_time(forces_x[j]), u_[1].low);
      need_solution(y[j], scaled_time(forces_y[j]), last_);
    }
    last_force_ = scaled_time(forces_x.back());
  }

  void need_residues() { ///< J5
    rule_ = "J5";
    form_ = a_.reduced(c_.form);
    need_degree(form_, c_.order + 1, "the form has another degree");
    for (std::size_t i = 0; i < 2; ++i) {
      const CurveFunction residue = s_.coefficient(last_force_, u_[i], -c_.turns);
      const CurveFunction slope = by(form_, i == 0 ? c_.c1() : c_.c2());
      need(is_zero(a_.plus(residue, slope).p), "the form is not that of the residues");
    }
  }

  /// J6: the columns of c1 R_2, c2 R_2 - c1 R_1, c2 R_1 (jets.md 2.5), or an entry of R.
  void need_minor() {
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
                a_.times(a_.integer(n - 2 * j), entry(j)),
                a_.times(a_.integer(j + 1), entry(j + 1))};
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
    need(a_.equal(a_.times(a_.reduced(c_.obstruction.cofactor), minor),
                  a_.power(value, static_cast<unsigned long>(c_.obstruction.power))),
         "the obstruction has another value");
  }

  [[nodiscard]] const CurveAlgebra& algebra() const { return a_; }
  [[nodiscard]] long degree() const { return degree_; } ///< k of the potential on the line
  /// rho2 - rho1
  [[nodiscard]] Rational difference() const { return {u_[1].low - u_[0].low, c_.turns}; }
  /// v, g = -A v' or w in time of the system, polynomials in y = c2.
  [[nodiscard]] CurveFunction potential() const { return coefficient(potential_, c_.c1(), 0); }
  [[nodiscard]] CurveFunction tangential() const { return coefficient(along_, c_.c1(), 0); }
  [[nodiscard]] CurveFunction normal() const { return coefficient(across_, c_.c1(), 1); }
  /// The coefficient of c1^i c2^(order + 1 - i) in the form.
  [[nodiscard]] CurveFunction entry(long i) const {
    return coefficient(coefficient(form_, c_.c1(), i), c_.c2(), c_.order + 1 - i);
  }
  /// The value of H on the solution, a polynomial in e: y_t^2/(2 A scale) + v(y) at s^0, with 1/(A scale) =
  /// -k v_k/(sigma (sigma - 1)).
  [[nodiscard]] CurveFunction energy() const {
    const CurveFunction v = potential();
    const CurveFunction down = a_.over(
        a_.times(a_.integer(-degree_ * c_.turns * c_.turns), coefficient(v, c_.c2(), degree_)),
        Integer(2 * first_ * (first_ - c_.turns)));
    const LocalSeries slope = s_.derivative(y_, c_.turns);
    return a_.plus(a_.times(down, s_.coefficient(slope, slope, 0)),
                   s_.coefficient(along_the_line(v), 0));
  }
  /// The derivative by the variable i, in which f is a polynomial.
  [[nodiscard]] CurveFunction by(const CurveFunction& f, std::size_t i) const {
    return a_.reduced({derivative(f.p, i), f.n, f.over});
  }

private:
  // Refuses a constant with c1 or c2 in it, or with e unless that is allowed.
  void need_free(const CurveFunction& given, bool of_e) const {
    const CurveFunction f = a_.reduced(given);
    need(!uses(f.p, c_.c1()) && !uses(f.p, c_.c2()) && (of_e || !uses(f.p, c_.e())),
         "a constant has a variable in it");
  }
  [[nodiscard]] CurveFunction dot(const std::array<CurveFunction, 2>& a,
                                  const std::array<CurveFunction, 2>& b) const {
    const auto part = [&](std::size_t i) {
      return a_.times(c_.line.masses[i], a_.times(a[i], b[i]));
    };
    return a_.plus(part(0), part(1));
  }

  // The Hamiltonian on the invariant subspace.
  [[nodiscard]] MPoly restricted() const {
    const std::size_t n = c_.system.dimension / 2;
    std::vector<std::size_t> zero;
    for (std::size_t l = 2; l < n; ++l)
      zero.insert(zero.end(), {l, l + n});
    const auto at_zero = [&](MPoly f) {
      for (const std::size_t i : zero)
        f = is_zero(f) ? f : coefficients(f, i)[0];
      return f;
    };
    const MPoly& h = c_.system.hamiltonian->p;
    for (const std::size_t i : zero)
      need(is_zero(at_zero(derivative(h, i))), "the subspace is not invariant");
    return at_zero(h);
  }
  // A polynomial in q1, q2, parameters and constants at q = start + x across + y along, with c1 and c2 for x
  // and y, which do not occur in it.
  [[nodiscard]] CurveFunction in_chart(const MPoly& v) const {
    const Ring& phase = c_.system.ring;
    std::vector<std::optional<CurveFunction>> at(phase->size());
    for (std::size_t i = 0; i < 2; ++i) {
      need_within(kov::degree(v, i) <= max_jet_degree, "the degree of the potential is too large");
      at[i] = a_.plus(a_.reduced(c_.line.start[i]),
                      a_.plus(a_.times(c_.line.across[i], a_.variable(c_.c1())),
                              a_.times(c_.line.along[i], a_.variable(c_.c2()))));
    }
    for (std::size_t i = 2; i < c_.system.dimension; ++i)
      need(!uses(v, i), "H is not a natural Hamiltonian");
    for (std::size_t i = c_.system.dimension; i < at.size(); ++i)
      at[i] = a_.variable(c_.field.ring->index(phase->name(i)));
    return a_.evaluate(v, at);
  }

  [[nodiscard]] CurveFunction coefficient(const CurveFunction& f, std::size_t variable,
                                          long k) const {
    const auto c = coefficients(f.p, variable);
    return k < 0 || k >= static_cast<long>(c.size())
               ? a_.zero()
               : a_.reduced({c[static_cast<std::size_t>(k)], f.n, f.over});
  }
  // f(y) on the solution of the line, f a polynomial in y = c2.
  [[nodiscard]] LocalSeries along_the_line(const CurveFunction& f) const {
    LocalSeries sum;
    for (long b = kov::degree(f.p, c_.c2()); b >= 0; --b)
      sum = s_.plus(s_.times(sum, y_), s_.constant(coefficient(f, c_.c2(), b)));
    return sum;
  }
  // f(x, y), f a polynomial in x = c1, y = c2.
  [[nodiscard]] GradedSeries value(const CurveFunction& f, const GradedSeries& x,
                                   const GradedSeries& y) const {
    const auto degree_in = [&](std::size_t i) {
      return static_cast<std::size_t>(std::max(0L, kov::degree(f.p, i)));
    };
    const auto xs = s_.powers(x, degree_in(c_.c1())), ys = s_.powers(y, degree_in(c_.c2()));
    GradedSeries sum(x.size());
    for (std::size_t a = 0; a < xs.size(); ++a) {
      const CurveFunction row = coefficient(f, c_.c1(), static_cast<long>(a));
      for (std::size_t b = 0; b < ys.size(); ++b) {
        const CurveFunction k = coefficient(row, c_.c2(), static_cast<long>(b));
        if (is_zero(k.p)) continue;
        const GradedSeries term = s_.times(xs[a], ys[b]);
        for (std::size_t j = 0; j < sum.size(); ++j)
          sum[j] = s_.plus(sum[j], s_.times(k, term[j]));
      }
    }
    return sum;
  }
  // Forces in the time t.
  [[nodiscard]] LocalSeries scaled_time(const LocalSeries& force) const {
    return s_.times(c_.time_scale, force);
  }

  void need_degree(const CurveFunction& f, long degree_in_c, const char* why) const {
    for (long k = 0; k < f.p.length(); ++k) {
      const auto e = f.p.exponents(k);
      need(static_cast<long>(e[c_.c1()] + e[c_.c2()]) == degree_in_c, why);
    }
  }
  [[nodiscard]] LocalSeries read(LocalSeries series, long degree_in_c) const {
    for (CurveFunction& f : series.c) {
      f = a_.reduced(f);
      need_degree(f, degree_in_c, "a series is not homogeneous in c1 and c2");
    }
    return s_.trimmed(std::move(series));
  }
  // x'' = force, as far as x is given, and that is beyond the last root.
  void need_solution(const LocalSeries& x, const LocalSeries& force, long last_root) const {
    if (x.is_exact_zero()) return need(force.is_exact_zero(), "a series is not 0");
    need(x.end > last_root, "a series ends before the last resonance");
    const LocalSeries acceleration = s_.derivative(s_.derivative(x, c_.turns), c_.turns);
    need(s_.minus(acceleration, force).start() >= x.end - 2 * c_.turns,
         "a series is not a solution as far as it is given");
  }

  const JetsCertificate& c_;
  std::string& rule_;
  CurveAlgebra a_;
  SeriesAlgebra s_;
  CurveFunction potential_, across_, along_; ///< V, and the forces in time of the system
  long degree_ = 0;
  long first_ = 0, last_ = 0; ///< d sigma and d (2 - sigma)
  LocalSeries y_;
  std::array<LocalSeries, 2> u_;
  LocalSeries last_force_;
  CurveFunction form_;
};

} // namespace kov::certify
