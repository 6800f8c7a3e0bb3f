#include "certify/system/on_curve.hpp"

#include "certify/equation/facts.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

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
  rule_ = "C7";
  need_no_constant_in_disguise();
}

bool OnCurve::is_known(const MPoly& f) const {
  const auto used = used_variables(f);
  return std::ranges::all_of(used, [&](std::size_t i) { return values_[i].has_value(); });
}

void OnCurve::need_no_constant_in_disguise() {
  const PhaseSystem& s = w_.system;
  fixed_.assign(s.ring->size(), true);
  std::fill(fixed_.begin() + static_cast<std::ptrdiff_t>(s.dimension),
            fixed_.begin() + static_cast<std::ptrdiff_t>(s.first_parameter()), false);
  fixed_ = space_.algebraic(fixed_, [&](const MPoly& f) {
    return is_known(f) && algebra_.is_unit(algebra_.norm(at({f, Integer(1)})), {});
  });
  for (std::size_t f = 0; f < s.functions.size(); ++f) {
    if (fixed_[s.dimension + f]) continue;
    const auto& gradient = s.functions[f].gradient;
    need(std::ranges::any_of(gradient, [](const auto& entry) { return !is_zero(entry.second.p); }),
         "a constant that no relation fixes");
    need(!values_[s.dimension + f] || moves(s.functions[f], false) || moves(s.functions[f], true),
         "a function has the value of a constant: no derivative has an inverse on the curve");
  }
  need_own_names();
}

// A name in the values that are shown is not another one of the system.
void OnCurve::need_own_names() const {
  const Ring &names = w_.system.ring, &field = w_.curve.ring;
  const auto seen = seen_by_functions(true);
  for (const auto& [i, value] : w_.curve.values) {
    if (!seen[i]) continue;
    for (const std::string& x : names_in(w_.curve, value)) {
      const auto k = names->find(x);
      if (!k || *k >= w_.system.first_inverse()) continue;
      const std::size_t w = field->index(x);
      need(values_[*k] ? algebra_.equal(*values_[*k], algebra_.variable(w)) : w == w_.curve.z(),
           "a name of the tower is another one of the system");
    }
  }
}

// Has a derivative an inverse at each point at which the gradient is not 0?  divided: the entries and what is
// derived from them are divided by the factor of the entry that has no functions in it: where that is 0 the
// entry is.
bool OnCurve::moves(const PhaseSymbol& f, bool divided) const {
  constexpr int max_order = 8;
  constexpr std::size_t max_derivatives = 5000; // of one order
  struct Derivative {
    std::size_t entry, last; // of the gradient; the coordinate of the last derivation
    PhaseFunction value;
  };
  std::vector<Derivative> layer, next;
  std::vector<std::vector<MPoly>> factors;
  std::vector<MPoly> common;
  std::set<std::size_t> left;
  const auto without = [&](std::size_t entry, const PhaseFunction& g) {
    if (is_constant(common[entry])) return g;
    const Content c = content(g.p);
    return c.factor == common[entry] || c.factor == -common[entry]
               ? PhaseFunction{c.rest, Integer(1)}
               : g;
  };
  for (const auto& [j, g] : f.gradient) {
    const std::size_t entry = factors.size();
    common.push_back(divided && !is_zero(g.p) ? content(g.p).factor
                                              : MPoly(w_.system.ring, Integer(1)));
    auto& factor = factors.emplace_back();
    if (is_zero(g.p)) continue;
    if (const MPoly c = content(g.p, true).factor; !is_constant(c))
      factor.push_back(at({c, Integer(1)}).p);
    left.insert(entry);
    layer.push_back({entry, 0, without(entry, g)});
  }
  for (int order = 1;; ++order, layer = std::exchange(next, {})) {
    for (const Derivative& d : layer) {
      if (!is_known(d.value.p)) continue;
      const MPoly norm = algebra_.norm(at(d.value));
      if (is_constant(common[d.entry]) && algebra_.is_unit(norm, {})) return true;
      if (left.contains(d.entry) && algebra_.is_unit(norm, factors[d.entry])) left.erase(d.entry);
    }
    if (left.empty() || order == max_order) return left.empty();
    for (const Derivative& d : layer)
      for (std::size_t j = d.last; j < w_.system.dimension; ++j)
        if (auto slope = space_.partial(d.value, j); !is_zero(slope.p))
          next.push_back({d.entry, j, without(d.entry, slope)});
    need_within(next.size() <= max_derivatives, "too many derivatives of a function");
  }
}

// f = factor * rest up to a number: coordinates and parameters in the factor (constant: parameters), nothing of
// it in the rest; the factor is 1 if there are no such two.
OnCurve::Content OnCurve::content(const MPoly& f, bool constant) const {
  const PhaseSystem& s = w_.system;
  std::map<std::vector<unsigned long>, MPoly> parts;
  for (long t = 0; t < f.length(); ++t) {
    auto own = f.exponents(t), others = own;
    for (std::size_t i = 0; i < own.size(); ++i)
      ((i < s.dimension && !constant) || i >= s.first_parameter() ? own : others)[i] = 0;
    MPoly& part = parts.try_emplace(own, s.ring).first->second;
    part = part + MPoly::term(s.ring, f.coefficient(t), others);
  }
  const MPoly c = primitive(parts.begin()->second);
  MPoly rest(s.ring);
  for (const auto& [own, part] : parts) {
    const MPoly other = primitive(part);
    if (!(other == c) && !(other == -c)) return {MPoly(s.ring, Integer(1)), f};
    rest = rest + *a_.quotient(part, c) * MPoly::term(s.ring, Integer(1), own);
  }
  return {c, rest};
}

std::vector<bool> OnCurve::seen_by_functions(bool fixed) const {
  std::vector<bool> seen(w_.system.ring->size(), false);
  for (std::size_t f = 0; f < w_.system.functions.size(); ++f) {
    const std::size_t s = w_.system.dimension + f;
    if (!values_[s] || (fixed_[s] && !fixed)) continue;
    seen[s] = true;
    const auto arguments = space_.arguments(f);
    for (std::size_t j = 0; j < w_.system.dimension; ++j)
      seen[j] = seen[j] || (arguments[j] && values_[j]);
  }
  return seen;
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
  if (!w_.system.hamiltonian || w_.normal.whole) return given;
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
  for (const Row& w : n.rows)
    need_length(w);
  if (n.is_system) return;
  const Row &w = n.rows.front(), first = nabla(w);
  Row sum = nabla(first);
  for (std::size_t k = 0; k < sum.size(); ++k)
    sum[k] = algebra_.plus(sum[k],
                           algebra_.plus(algebra_.times(n.p, first[k]), algebra_.times(n.q, w[k])));
  need(equal(sum, combination(n.rests.front(), sum.size())),
       "the row does not satisfy its equation");
  rule_ = "N3";
  need_vectors({w, first});
}

void OnCurve::need_vectors(const std::vector<Row>& rows) const {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    need_length(w_.normal.vectors[i]);
    const Row b = tangent(w_.normal.vectors[i]);
    for (const Annihilator& l : w_.normal.annihilators)
      need(is_zero(dot(l.row, b).p), "N3: a vector is not in the subsystem");
    for (std::size_t j = 0; j < rows.size(); ++j)
      need(algebra_.equal(dot(rows[j], b), algebra_.integer(i == j ? 1 : 0)),
           "N3: the vectors do not show that the rows are independent");
  }
}

// den nabla w_i = sum num_j w_j, modulo the annihilators
void OnCurve::need_system(const LoopsCertificate& c, const std::optional<CurveFunction>& a) {
  rule_ = "N5";
  const NormalIdentity& n = w_.normal;
  need(n.is_system && n.rows.size() == c.rows.size(), "the rows are those of another system");
  const CurveFunction root = root_of(c.field, a);
  for (std::size_t i = 0; i < n.rows.size(); ++i) {
    const CurveFunction den = value(c.rows[i].den, root);
    Row left = nabla(n.rows[i]);
    for (CurveFunction& x : left)
      x = algebra_.times(den, x);
    for (std::size_t j = 0; j < n.rows.size(); ++j) {
      const CurveFunction num = value(c.rows[i].num[j], root);
      for (std::size_t k = 0; k < left.size(); ++k)
        left[k] = algebra_.minus(left[k], algebra_.times(num, n.rows[j][k]));
    }
    need(equal(left, combination(n.rests[i], left.size())), "the rows do not satisfy the system");
  }
  need_vectors(n.rows);
}

void OnCurve::need_r(const CurveFunction& num, const CurveFunction& den) const {
  const NormalIdentity& n = w_.normal;
  need(!n.is_system, "one row is expected");
  const CurveFunction r =
      algebra_.minus(algebra_.plus(algebra_.over(algebra_.times(n.p, n.p), Integer(4)),
                                   algebra_.over(algebra_.derivative(n.p), Integer(2))),
                     n.q);
  need(!is_zero(algebra_.norm(den)), "the denominator of r has no inverse on the curve");
  need(algebra_.equal(algebra_.times(r, den), num), "r is not p^2/4 + p'/2 - q");
}

// The values of z, of the parameters and of the constants in R.
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
  const auto has_inverse = [&](const MPoly& f) {
    return !is_zero(algebra_.norm(algebra_.evaluate(f, at)));
  };
  for (const auto& group : generic)
    need(std::ranges::any_of(group, has_inverse), "the equation excludes this system");
}

std::optional<Rational> OnCurve::number(const CurveFunction& f) const {
  if (!is_constant(f.p) || std::ranges::any_of(f.over, [](auto e) { return e > 0; }))
    return std::nullopt;
  return Rational(is_zero(f.p) ? Integer(0) : f.p.coefficient(0), f.n);
}

// An element with parameters in it, and nothing of the tower, is a condition on them.
bool OnCurve::holds(const CurveFunction& f, Sign sign) const {
  if (sign == Sign::nonzero) return !is_zero(algebra_.norm(f));
  for (std::size_t i = 0; i < w_.curve.z(); ++i)
    if (uses(f.p, i)) return false;
  const auto c = number(f);
  return !c || (sign == Sign::zero ? kov::sign(*c) == 0
                                   : kov::sign(*c) >= (sign == Sign::positive ? 1 : 0));
}

void OnCurve::need_assumptions(const StrataCertificate& c) {
  const auto at = values_of(c.ring);
  const Ring& names = w_.system.ring;
  std::vector<bool> is_constant(c.ring->size(), false);
  for (std::size_t i = 1; i < is_constant.size(); ++i) {
    const auto k = names->find(c.ring->name(i));
    is_constant[i] = k && *k < w_.system.first_parameter();
  }
  const auto of_constants = [&](const MPoly& f) {
    const auto used = used_variables(f);
    return std::ranges::any_of(used, [&](std::size_t i) { return is_constant[i]; });
  };
  const auto value = [&](const MPoly& f) { return algebra_.evaluate(f, at); };
  for (std::size_t i = 1; i < is_constant.size(); ++i)
    need(!is_constant[i] || !(c.real[i] || c.rational[i]) || (at[i] && number(*at[i])),
         "a constant that is not seen to be real, or rational");
  for (const Condition& x : c.assumptions)
    need(!of_constants(x.p) || holds(value(x.p), x.sign),
         "an assumption about a constant does not hold");
  for (const Membership& m : c.memberships) {
    if (!of_constants(m.value.num) && !of_constants(m.value.den)) continue;
    const auto num = number(value(m.value.num)), den = number(value(m.value.den));
    need(num && den && kov::sign(*den) != 0 && is_integer(*num / *den) == m.integral,
         "an assumption about a constant does not hold");
  }
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
  const CurveFunction root = root_of(num.field()->is_rational() ? den.field() : num.field(), a);
  need_r(value(num, root), value(den, root));
}

CurveFunction OnCurve::root_of(const Field& k, const std::optional<CurveFunction>& a) const {
  need(k->is_rational() != a.has_value(), "a root is given for a field that has none, or missing");
  if (a) {
    CurveFunction m = algebra_.zero();
    const auto c = k->minpoly_coefficients();
    for (std::size_t j = c.size(); j-- > 0;)
      m = algebra_.plus(algebra_.times(m, *a), {MPoly(w_.curve.ring, c[j]), Integer(1), {}});
    need(is_zero(m.p) && is_zero(algebra_.derivative(*a).p),
         "the root is not a root of the minimal polynomial");
  }
  return a ? *a : algebra_.zero();
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
