#pragma once
// From the variational equation along the curve to y'' = r y or Y' = A Y: the rules N1 to N5 of
// system_certificates.md.

#include "certify/system/along_curve.hpp"

namespace kov::certify {

/// A parameter, or an algebraic constant: a function with an empty gradient.
[[nodiscard]] inline bool is_constant_of(const PhaseSystem& s, std::size_t k) {
  return k >= s.first_parameter() || (k >= s.dimension && k < s.first_inverse() &&
                                      s.functions[k - s.dimension].gradient.empty());
}

class NormalRules {
public:
  /// N1, and N2, N3 for y'' = r y.  rule: is set to the one that was last begun
  NormalRules(const Way& w, const AlongCurve& x, std::string& rule)
      : w_(w), n_(w.normal), x_(x), in_(x.algebra()), rule_(rule) {
    rule_ = "N1";
    for (const PhaseFunction& f : x_.field())
      jacobian_.push_back(x_.at(x_.space().gradient(f)));
    for (const Annihilator& l : n_.annihilators)
      need_length(l.row);
    for (const Annihilator& l : n_.annihilators)
      need(equal(nabla(l.row), combination(l.matrix)), "the annihilators do not span a subsystem");
    rule_ = "N2";
    for (const CurveRow& row : n_.rows)
      need_length(row);
    if (n_.is_system) return;
    const CurveRow &row = n_.rows.front(), first = nabla(row);
    CurveRow sum = nabla(first);
    for (std::size_t k = 0; k < sum.size(); ++k)
      sum[k] = in_.plus(sum[k], in_.plus(in_.times(n_.p, first[k]), in_.times(n_.q, row[k])));
    need(equal(sum, combination(n_.rests.front())), "the row does not satisfy its equation");
    rule_ = "N3";
    need_vectors({row, first});
  }

  /// N4, for r in z, parameters and constants; of each group one member is not 0.
  void need_equation(const Fraction& r, const std::vector<std::vector<MPoly>>& generic) const {
    rule_ = "N4";
    const auto at = values_of(r.den.ring());
    need_r(in_.evaluate(r.num, at), in_.evaluate(r.den, at));
    const auto has_inverse = [&](const MPoly& f) {
      return !is_zero(in_.norm(in_.evaluate(f, at)));
    };
    for (const auto& group : generic)
      need(std::ranges::any_of(group, has_inverse), "the equation excludes this system");
  }
  /// N4, for r over Q(a), with a in the place of the generator.
  void need_equation(const Poly& num, const Poly& den,
                     const std::optional<CurveFunction>& a) const {
    rule_ = "N4";
    const CurveFunction root = root_of(num.field()->is_rational() ? den.field() : num.field(), a);
    need_r(value(num, root), value(den, root));
  }
  /// N4, what an equation assumes of the constants of the system.
  void need_assumptions(const StrataCertificate& c) const {
    const auto at = values_of(c.ring);
    const auto is_constant = [&](std::size_t i) {
      const auto k = w_.system.ring->find(c.ring->name(i));
      return i > 0 && k && *k < w_.system.first_parameter();
    };
    const auto of_constants = [&](const MPoly& f) {
      const auto used = used_variables(f);
      return std::ranges::any_of(used, is_constant);
    };
    const auto value = [&](const MPoly& f) { return in_.evaluate(f, at); };
    for (std::size_t i = 1; i < at.size(); ++i)
      need(!is_constant(i) || !(c.real[i] || c.rational[i]) || (at[i] && number(*at[i])),
           "a constant that is not seen to be real, or rational");
    for (const Condition& x : c.assumptions)
      need(!of_constants(x.p) || holds(value(x.p), x.sign),
           "an assumption about a constant does not hold");
    for (const Membership& m : c.memberships) {
      if (!of_constants(m.value.num) && !of_constants(m.value.den)) continue;
      const auto num = number(value(m.value.num)), den = number(value(m.value.den));
      need(num && den && sign(*den) != 0 && is_integer(*num / *den) == m.integral,
           "an assumption about a constant does not hold");
    }
  }
  /// N5, for Y' = A Y over Q(a) likewise: den nabla w_i = sum num_j w_j, modulo the annihilators.
  void need_system(const LoopsCertificate& c, const std::optional<CurveFunction>& a) const {
    rule_ = "N5";
    need(n_.is_system && n_.rows.size() == c.rows.size(), "the rows are those of another system");
    const CurveFunction root = root_of(c.field, a);
    for (std::size_t i = 0; i < n_.rows.size(); ++i) {
      const CurveFunction den = value(c.rows[i].den, root);
      CurveRow left = nabla(n_.rows[i]);
      for (CurveFunction& x : left)
        x = in_.times(den, x);
      for (std::size_t j = 0; j < n_.rows.size(); ++j) {
        const CurveFunction num = value(c.rows[i].num[j], root);
        for (std::size_t k = 0; k < left.size(); ++k)
          left[k] = in_.minus(left[k], in_.times(num, n_.rows[j][k]));
      }
      need(equal(left, combination(n_.rests[i])), "the rows do not satisfy the system");
    }
    need_vectors(n_.rows);
  }

private:
  void need_length(const CurveRow& a) const {
    need(a.size() == w_.system.dimension, "a row has not one entry for each coordinate");
  }
  [[nodiscard]] bool equal(const CurveRow& a, const CurveRow& b) const {
    return std::ranges::equal(a, b, [&](const auto& f, const auto& g) { return in_.equal(f, g); });
  }
  // D a + T a J
  [[nodiscard]] CurveRow nabla(const CurveRow& a) const {
    CurveRow result;
    for (std::size_t k = 0; k < a.size(); ++k) {
      CurveRow column;
      for (const CurveRow& row : jacobian_)
        column.push_back(row[k]);
      result.push_back(
          in_.plus(in_.derivative(a[k]), in_.times(w_.curve.time, in_.dot(a, column))));
    }
    return result;
  }
  // sum_l c_l lambda_l
  [[nodiscard]] CurveRow combination(const CurveRow& c) const {
    need(c.size() == n_.annihilators.size(), "one coefficient for each annihilator is expected");
    CurveRow sum;
    for (std::size_t k = 0; k < w_.system.dimension; ++k) {
      CurveRow column;
      for (const Annihilator& l : n_.annihilators)
        column.push_back(l.row[k]);
      sum.push_back(in_.dot(c, column));
    }
    return sum;
  }

  // ---- N3

  void need_vectors(const std::vector<CurveRow>& rows) const {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      need_length(n_.vectors[i]);
      const CurveRow b = tangent(n_.vectors[i]);
      for (const Annihilator& l : n_.annihilators)
        need(is_zero(in_.dot(l.row, b).p), "N3: a vector is not in the subsystem");
      for (std::size_t j = 0; j < rows.size(); ++j)
        need(in_.equal(in_.dot(rows[j], b), in_.integer(i == j ? 1 : 0)),
             "N3: the vectors do not show that the rows are independent");
    }
  }
  // b_i
  [[nodiscard]] CurveRow tangent(const CurveRow& given) const {
    if (!w_.system.hamiltonian || n_.whole) return given;
    CurveRow b(given.size(), in_.zero());
    for (const PhaseBracket& x : w_.system.brackets) {
      const CurveFunction p = x_.at(x.value);
      b[x.first] = in_.plus(b[x.first], in_.times(p, given[x.second]));
      b[x.second] = in_.minus(b[x.second], in_.times(p, given[x.first]));
    }
    return b;
  }

  // ---- N4

  void need_r(const CurveFunction& num, const CurveFunction& den) const {
    need(!n_.is_system, "one row is expected");
    const CurveFunction r = in_.minus(in_.plus(in_.over(in_.times(n_.p, n_.p), Integer(4)),
                                               in_.over(in_.derivative(n_.p), Integer(2))),
                                      n_.q);
    need(!is_zero(in_.norm(den)), "the denominator of r has no inverse on the curve");
    need(in_.equal(in_.times(r, den), num), "r is not p^2/4 + p'/2 - q");
  }
  // The values of z, of the parameters and of the constants in R.
  [[nodiscard]] CurveAlgebra::Values values_of(const Ring& ring) const {
    const PhaseSystem& s = w_.system;
    CurveAlgebra::Values at(ring->size());
    for (std::size_t i = 0; i < at.size(); ++i) {
      const auto k = s.ring->find(ring->name(i));
      if (ring->name(i) == w_.curve.ring->name(w_.curve.z()))
        at[i] = in_.variable(w_.curve.z());
      else if (k && is_constant_of(s, *k))
        at[i] = x_.values()[*k];
    }
    return at;
  }
  [[nodiscard]] static std::optional<Rational> number(const CurveFunction& f) {
    if (!is_constant(f.p) || std::ranges::any_of(f.over, [](auto e) { return e > 0; }))
      return std::nullopt;
    return Rational(is_zero(f.p) ? Integer(0) : f.p.coefficient(0), f.n);
  }
  // An element with parameters in it, and nothing of the tower, is a condition on them.
  [[nodiscard]] bool holds(const CurveFunction& f, Sign s) const {
    if (s == Sign::nonzero) return !is_zero(in_.norm(f));
    for (std::size_t i = 0; i < w_.curve.z(); ++i)
      if (uses(f.p, i)) return false;
    const auto c = number(f);
    return !c || allows(s, sign(*c));
  }

  // f(z) with a in the place of the generator of its field
  [[nodiscard]] CurveFunction value(const Poly& f, const CurveFunction& a) const {
    CurveFunction sum = in_.zero();
    for (long i = degree(f); i >= 0; --i) {
      CurveFunction c = in_.zero();
      const NfElem x = f.coeff(i);
      for (long j = x.field()->degree() - 1; j >= 0; --j)
        c = in_.plus(in_.times(c, a), in_.over(in_.integer(x.coeff(j).num()), x.coeff(j).den()));
      sum = in_.plus(in_.times(sum, in_.variable(w_.curve.z())), c);
    }
    return sum;
  }
  [[nodiscard]] CurveFunction root_of(const Field& k, const std::optional<CurveFunction>& a) const {
    need(k->is_rational() != a.has_value(),
         "a root is given for a field that has none, or missing");
    if (!a) return in_.zero();
    CurveFunction m = in_.zero();
    const auto c = k->minpoly_coefficients();
    for (std::size_t j = c.size(); j-- > 0;)
      m = in_.plus(in_.times(m, *a), in_.integer(c[j]));
    need(is_zero(m.p) && is_zero(in_.derivative(*a).p),
         "the root is not a root of the minimal polynomial");
    return *a;
  }

  const Way& w_;
  const NormalIdentity& n_;
  const AlongCurve& x_;
  const CurveAlgebra& in_;
  std::string& rule_;
  std::vector<CurveRow> jacobian_;
};

} // namespace kov::certify
