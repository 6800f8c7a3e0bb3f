#include "certify/system/on_curve.hpp"

#include "certify/equation/facts.hpp"

#include <algorithm>

namespace kov::certify {

OnCurve::OnCurve(const Way& w, Arithmetic& a)
    : w_(w), a_(a), space_(w.system, a), algebra_(w.curve, a), values_(w.system.ring->size()) {
  const Ring& names = w.system.ring;
  for (std::size_t i = w.system.first_parameter(); i < names->size(); ++i)
    values_[i] = algebra_.variable(w.curve.ring->index(names->name(i)));
  for (const auto& [i, value] : w.curve.values)
    values_[i] = algebra_.reduced(value);
}

void OnCurve::need_claims() {
  space_.need_symbols();
  rule_ = "S2";
  field_ = space_.field();
  rule_ = "S4";
  for (const ClaimedFunction& c : w_.claims)
    space_.need_claim(c, field_);
}

CurveFunction OnCurve::at(const PhaseFunction& f) const {
  return algebra_.over(algebra_.evaluate(f.p, values_), f.n);
}

// d/dt of a coordinate or a function along the curve; unset: it has no value there.
std::optional<CurveFunction> OnCurve::velocity(std::size_t variable) const {
  if (variable < w_.system.dimension) return at(field_[variable]);
  const std::size_t s = variable - w_.system.dimension;
  CurveFunction sum = algebra_.zero();
  for (const auto& [j, g] : w_.system.functions[s].gradient) {
    if (is_zero(g.p)) continue;
    for (const std::size_t i : used_variables(g.p))
      if (!values_[i]) return std::nullopt;
    sum = algebra_.plus(sum, algebra_.times(at(g), at(field_[j])));
  }
  return sum;
}

void OnCurve::need_functions() const {
  const PhaseSystem& s = w_.system;
  for (const MPoly& r : s.relations)
    need(is_zero(at({r, Integer(1)}).p), "a relation does not hold on the curve");
  for (std::size_t i = 0; i < s.first_parameter(); ++i) {
    if (!values_[i]) {
      need(i < s.first_inverse(), "an inverse has no value on the curve");
      continue;
    }
    if (i >= s.first_inverse()) {
      const CurveFunction h = at({s.inverses[i - s.first_inverse()], Integer(1)});
      need(algebra_.equal(algebra_.times(*values_[i], h), algebra_.integer(1)),
           "the value of an inverse is none");
      continue;
    }
    const auto v = velocity(i);
    need(v && algebra_.equal(algebra_.derivative(*values_[i]), algebra_.times(w_.curve.time, *v)),
         "the curve is not a solution of the system");
  }
}

void OnCurve::need_curve() {
  rule_ = "C2";
  algebra_.need_derivation();
  rule_ = "C4";
  for (const PhaseFunction& x : field_)
    static_cast<void>(at(x)); // has a value
  need_functions();
  rule_ = "C5";
  need(algebra_.equal(at(w_.curve.change), algebra_.variable(w_.curve.z())),
       "the change of variable is not z on the curve");
  rule_ = "C6";
  for (const auto* all : {&w_.curve.equations, &w_.curve.levels})
    for (const PhaseFunction& f : *all)
      need(is_zero(at(f).p), "an equation or a level does not hold on the curve");
}

OnCurve::Row OnCurve::jacobian_row(std::size_t i) const {
  Row row;
  for (std::size_t k = 0; k < w_.system.dimension; ++k)
    row.push_back(at(space_.partial(field_[i], k)));
  return row;
}

CurveFunction OnCurve::dot(const Row& a, const Row& b) const {
  CurveFunction sum = algebra_.zero();
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!is_zero(a[i].p) && !is_zero(b[i].p)) sum = algebra_.plus(sum, algebra_.times(a[i], b[i]));
  return sum;
}

// D a + T a J
OnCurve::Row OnCurve::nabla(const Row& a) const {
  Row result;
  for (std::size_t k = 0; k < a.size(); ++k) {
    Row column;
    for (const Row& row : jacobian_)
      column.push_back(row[k]);
    result.push_back(
        algebra_.plus(algebra_.derivative(a[k]), algebra_.times(w_.curve.time, dot(a, column))));
  }
  return result;
}

// sum_l c_l lambda_l
OnCurve::Row OnCurve::combination(const Row& c, std::size_t entries) const {
  const auto& all = w_.normal.annihilators;
  need(c.size() == all.size(), "one coefficient for each annihilator is expected");
  Row sum(entries, algebra_.zero());
  for (std::size_t l = 0; l < all.size(); ++l)
    for (std::size_t k = 0; k < entries; ++k)
      if (!is_zero(c[l].p) && !is_zero(all[l].row[k].p))
        sum[k] = algebra_.plus(sum[k], algebra_.times(c[l], all[l].row[k]));
  return sum;
}

OnCurve::Row OnCurve::tangent(const Row& given) const {
  if (!w_.system.hamiltonian) return given;
  Row b(given.size(), algebra_.zero());
  for (const PhaseBracket& x : w_.system.brackets) {
    const CurveFunction p = at(x.value);
    b[x.first] = algebra_.plus(b[x.first], algebra_.times(p, given[x.second]));
    b[x.second] = algebra_.minus(b[x.second], algebra_.times(p, given[x.first]));
  }
  return b;
}

bool OnCurve::equal(const Row& a, const Row& b) const {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!algebra_.equal(a[i], b[i])) return false;
  return true;
}

void OnCurve::need_length(const Row& a) const {
  need(a.size() == w_.system.dimension, "a row has not one entry for each coordinate");
}

void OnCurve::need_normal() {
  rule_ = "N1";
  const NormalIdentity& n = w_.normal;
  for (std::size_t i = 0; i < w_.system.dimension; ++i)
    jacobian_.push_back(jacobian_row(i));
  for (const Annihilator& l : n.annihilators)
    need_length(l.row);
  for (const Annihilator& l : n.annihilators)
    need(equal(nabla(l.row), combination(l.matrix, l.row.size())),
         "the annihilators do not span a subsystem");
  rule_ = "N2";
  need_length(n.row);
  const Row first = nabla(n.row);
  Row sum = nabla(first);
  for (std::size_t k = 0; k < sum.size(); ++k)
    sum[k] = algebra_.plus(
        sum[k], algebra_.plus(algebra_.times(n.p, first[k]), algebra_.times(n.q, n.row[k])));
  need(equal(sum, combination(n.rest, sum.size())), "the row does not satisfy its equation");
  rule_ = "N3";
  for (std::size_t i = 0; i < 2; ++i) {
    need_length(n.vectors[i]);
    const Row b = tangent(n.vectors[i]);
    for (const Annihilator& l : n.annihilators)
      need(is_zero(dot(l.row, b).p), "a vector is not in the subsystem");
    need(algebra_.equal(dot(n.row, b), algebra_.integer(i == 0 ? 1 : 0)) &&
             algebra_.equal(dot(first, b), algebra_.integer(i == 0 ? 0 : 1)),
         "the vectors do not show that the row and its derivative are independent");
  }
}

void OnCurve::need_r(const CurveFunction& num, const CurveFunction& den) const {
  const NormalIdentity& n = w_.normal;
  const CurveFunction r =
      algebra_.minus(algebra_.plus(algebra_.over(algebra_.times(n.p, n.p), Integer(4)),
                                   algebra_.over(algebra_.derivative(n.p), Integer(2))),
                     n.q);
  need(!is_zero(den.p), "the denominator of r is 0 on the curve");
  need(algebra_.equal(algebra_.times(r, den), num), "r is not p^2/4 + p'/2 - q");
}

// What z, parameters and constants are in R.
std::vector<std::optional<CurveFunction>> OnCurve::values_of(const Ring& ring) const {
  const Ring& names = w_.system.ring;
  const Ring& field = w_.curve.ring;
  std::vector<std::optional<CurveFunction>> at(ring->size());
  for (std::size_t i = 0; i < at.size(); ++i) {
    const std::string& name = ring->name(i);
    const auto k = names->find(name);
    if (name == field->name(w_.curve.z()))
      at[i] = algebra_.variable(w_.curve.z());
    else if (k && *k >= w_.system.first_parameter())
      at[i] = values_[*k];
    else if (k && *k >= w_.system.dimension && *k < w_.system.first_inverse() &&
             w_.system.functions[*k - w_.system.dimension].gradient.empty())
      at[i] = values_[*k];
  }
  return at;
}

void OnCurve::need_equation(const Fraction& r, const std::vector<std::vector<MPoly>>& generic) {
  rule_ = "N4";
  const auto at = values_of(r.den.ring());
  need_r(algebra_.evaluate(r.num, at), algebra_.evaluate(r.den, at));
  const auto is_not_zero = [&](const MPoly& f) { return !is_zero(algebra_.evaluate(f, at).p); };
  for (const auto& group : generic)
    need(std::any_of(group.begin(), group.end(), is_not_zero), "the equation excludes this system");
}

// f(z) with a in the place of the generator of its field
CurveFunction OnCurve::value(const Poly& f, const CurveFunction& a) const {
  CurveFunction sum = algebra_.zero();
  const CurveFunction z = algebra_.variable(w_.curve.z());
  for (long i = kov::degree(f); i >= 0; --i) {
    CurveFunction c = algebra_.zero();
    const NfElem x = f.coeff(i);
    for (long j = x.field()->degree() - 1; j >= 0; --j) {
      const Rational q = x.coeff(j);
      const CurveFunction constant{MPoly(w_.curve.ring, q.num()), q.den(), {}};
      c = algebra_.plus(algebra_.times(c, a), constant);
    }
    sum = algebra_.plus(algebra_.times(sum, z), c);
  }
  return sum;
}

void OnCurve::need_equation(const Poly& num, const Poly& den,
                            const std::optional<CurveFunction>& a) {
  rule_ = "N4";
  const Field& k = num.field()->is_rational() ? den.field() : num.field();
  need(k->is_rational() != a.has_value(), "a root is given for a field that has none, or missing");
  if (a) {
    CurveFunction m = algebra_.zero();
    const auto c = k->minpoly_coefficients();
    for (std::size_t j = c.size(); j-- > 0;)
      m = algebra_.plus(algebra_.times(m, *a), {MPoly(w_.curve.ring, c[j]), Integer(1), {}});
    need(is_zero(m.p) && is_zero(algebra_.derivative(*a).p),
         "the root is not a root of the minimal polynomial");
  }
  const CurveFunction root = a ? *a : algebra_.zero();
  need_r(value(num, root), value(den, root));
}

std::vector<std::string> OnCurve::moving() {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < w_.system.first_inverse(); ++i) {
    if (values_[i]) continue;
    const auto v = velocity(i);
    if (!v || !is_zero(v->p)) names.push_back(w_.system.ring->name(i));
  }
  return names;
}

} // namespace kov::certify
