#include "parameters/set.hpp"

#include "exact/error.hpp"
#include "exact/factor.hpp"
#include "exact/finite_algebra.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "parameters/conditions.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace kov {

Set::Set(Ring ring, std::vector<std::size_t> parameters, Budget budget)
    : ring_(std::move(ring)), parameters_(std::move(parameters)), budget_(std::move(budget)) {}

namespace {

// The equations say what some parameters are, as polynomials in the others: all others are free.
bool is_graph(const Ideal& ideal) {
  return std::ranges::all_of(ideal.basis(), [](const KPoly& f) {
    const Monomial& lead = f.begin()->first;
    return std::accumulate(lead.begin(), lead.end(), 0UL) == 1;
  });
}

std::vector<MPoly> numerators(const Ideal& ideal) {
  return mapped<MPoly>(ideal.basis(), [&](const KPoly& f) { return ideal.from_kpoly(f).num(); });
}

} // namespace

// The inequations as functions where the equations hold: their product is smaller then; and a prime ideal needs none.
Ideal Set::ideal_of(const std::vector<MPoly>& equations) const {
  Ideal ideal(ring_, parameters_, equations, {}, budget_);
  std::vector<MPoly> factors;
  for (const MPoly& g : nonzero_) {
    const MPoly here = ideal.normal_form(MFraction(g)).num();
    if (is_zero(here)) return {ring_, parameters_, {MPoly(ring_, Integer(1))}, {}, budget_};
    for (MFactor& x : factor(here).second)
      add_once(factors, std::move(x.base));
  }
  if (factors.empty() || is_graph(ideal)) return ideal;
  return {ring_, parameters_, numerators(ideal), factors, budget_};
}

void Set::add_equation(MPoly p) {
  auto all = equations(); // a basis of what was there: less work than the equations as they came
  all.push_back(std::move(p));
  known_.clear();
  factors_.reset();
  ideal_.emplace(ideal_of(all));
}

// I : (f g)^infinity = (I : f^infinity) : g^infinity, and a prime ideal without f stays as it is.
void Set::add_inequations(const std::vector<MPoly>& p) {
  nonzero_.insert(nonzero_.end(), p.begin(), p.end());
  std::erase_if(known_, [](const auto& entry) { return !entry.second; });
  factors_.reset();
  if (!ideal_ || p.empty()) return;
  const bool is_prime = is_graph(*ideal_);
  if (is_prime && std::ranges::none_of(p, [&](const MPoly& f) { return is_zero(restrict(f)); }))
    return;
  ideal_.emplace(ring_, parameters_, equations(), p, budget_);
}

Set Set::where_zero(const MPoly& p) const {
  Set s = *this;
  const MFraction here = restrict(p);
  if (is_zero(here)) {
    s.add_equation(p);
    return s;
  }
  MPoly product(ring_, Integer(1));
  for (const MPoly& f : irreducible_parts(here.num()))
    product *= f;
  s.add_equation(std::move(product));
  return s;
}

Set Set::where_nonzero(const MPoly& p) const {
  Set s = *this;
  std::vector<MPoly> fresh;
  for (const MFactor& f : factor(p).second)
    if (!s.irreducible_is_nonzero(f.base)) fresh.push_back(f.base);
  s.add_inequations(fresh);
  return s;
}

bool Set::is_empty() const { return ideal_ && ideal_->is_unit(); }

MFraction Set::restrict(const MPoly& f) const {
  if (!ideal_ || is_zero(f)) return f;
  return ideal_->normal_form(MFraction(f));
}

// The irreducible factors of the inequations, as functions on a graph.
const std::vector<MPoly>& Set::factors_of_inequations() const {
  if (factors_) return *factors_;
  factors_.emplace();
  for (const MPoly& g : nonzero_)
    for (MFactor& x : factor(restrict(g).num()).second)
      factors_->push_back(std::move(x.base));
  return *factors_;
}

bool Set::irreducible_is_nonzero(const MPoly& f) const {
  if (is_among(f, nonzero_)) return true;
  if (!ideal_) return false; // without equations f vanishes somewhere else, by the Nullstellensatz
  const auto [place, is_new] = known_.try_emplace(to_string(f), false);
  if (!is_new) return place->second;
  if (is_empty()) return place->second = true;
  if (!is_graph(*ideal_)) {
    auto all = equations();
    all.push_back(f);
    return place->second = ideal_of(all).is_unit();
  }
  // a polynomial in the free parameters vanishes only where others do: by the Nullstellensatz each of its
  // factors divides one of theirs
  const MFraction here = restrict(f);
  if (is_zero(here)) return false;
  const auto& known = factors_of_inequations();
  const auto factors = factor(here.num()).second;
  return place->second = std::ranges::all_of(
             factors, [&](const MFactor& x) { return is_among(x.base, known); });
}

bool Set::vanishes(const MPoly& f) const {
  return is_zero(restrict(f)) || where_nonzero(f).is_empty(); // the ideal need not be radical
}

bool Set::is_nonzero(const MPoly& f) const { return !is_zero(f) && doubtful_factors(f).empty(); }

std::vector<MPoly> Set::doubtful_factors(const MPoly& f) const {
  std::vector<MPoly> doubtful;
  if (is_constant(f)) return doubtful;
  for (const MFactor& x : factor(f).second)
    if (!irreducible_is_nonzero(x.base)) doubtful.push_back(x.base);
  return doubtful;
}

std::vector<MPoly> Set::equations() const {
  return ideal_ ? numerators(*ideal_) : std::vector<MPoly>{};
}

std::vector<MPoly> Set::proper_inequations() const {
  if (!ideal_) return nonzero_;
  std::vector<MPoly> proper, factors;
  for (const MPoly& f : nonzero_) {
    const MFraction here = restrict(f);
    if (is_constant(here)) continue;
    if (is_graph(*ideal_)) { // polynomials in the free parameters: said are those with a new factor
      bool is_new = false;
      for (MFactor& x : factor(here.num()).second)
        if (!is_among(x.base, factors)) {
          factors.push_back(std::move(x.base));
          is_new = true;
        }
      if (is_new) proper.push_back(f);
      continue;
    }
    auto equations = this->equations();
    equations.push_back(f);
    // at a limit: true, and said though it may follow
    if (!tried<OutOfBudget>(
            [&] { return Ideal(ring_, parameters_, equations, proper, budget_).is_unit(); }))
      proper.push_back(f);
  }
  return proper;
}

// ---- conditions that no polynomial says

Set Set::within(const Set& all) const {
  const auto here = [&](const MPoly& p) { return transfer(MFraction(p), all.ring()).num(); };
  Set there = all;
  for (const MPoly& p : equations())
    there = there.where_zero(here(p));
  for (const MPoly& p : nonzero_)
    there = there.where_nonzero(here(p));
  for (Statement s : statements_) {
    for (MFraction& square : squares_of(s.says))
      square = transfer(square, all.ring());
    there.statements_.push_back(std::move(s));
  }
  return there;
}

Set Set::with_inequations(const std::vector<MPoly>& nonzero) const {
  Set other = plain();
  for (const MPoly& f : equations())
    other = other.where_zero(f);
  for (const MPoly& f : nonzero)
    other = other.where_nonzero(f);
  other.statements_ = statements_;
  return other;
}

Set Set::without_statements() const {
  Set larger = *this;
  larger.statements_.clear();
  return larger;
}

std::optional<Set> Set::where(const Statement& s) const {
  const auto here = on_set(s, *this);
  if (const auto* known = std::get_if<bool>(&here))
    return *known ? std::optional(*this) : std::nullopt;
  const auto& left = std::get<Statement>(here);
  Set part = *this;
  std::erase_if(part.statements_, [&](const Statement& x) { return implies(left, x); });
  for (const Statement& x : part.statements_) {
    if (implies(x, left)) return part;
    if (implies(x, negation(left))) return std::nullopt;
  }
  part.statements_.push_back(left);
  return part;
}

std::optional<Set> Set::where(const std::vector<Statement>& all) const {
  std::optional<Set> part = *this;
  for (const Statement& s : all)
    if (part) part = part->where(s);
  return part;
}

Cut moved(Cut cut, const std::function<MFraction(const MFraction&)>& move) {
  const auto move_all = [&](std::vector<MPoly>& all) {
    for (MPoly& p : all)
      p = move(MFraction(p)).num();
  };
  move_all(cut.zero);
  std::ranges::for_each(cut.not_all_zero, move_all);
  for (Statement& s : cut.statements)
    for (MFraction& square : squares_of(s.says))
      square = move(square);
  return cut;
}

Cut cut_of(const Set& where) {
  Cut cut{where.equations(), {}, where.statements()};
  for (const MPoly& p : where.inequations())
    cut.not_all_zero.push_back({p});
  return cut;
}

namespace {

// f as a function on the set, where its denominator does not vanish identically.
std::optional<MFraction> restricted(const MFraction& f, const Set& where) {
  const MFraction den = where.restrict(f.den());
  if (is_zero(den)) return std::nullopt;
  return where.restrict(f.num()) / den;
}

// The rational numbers among the values of f, and perhaps some more, where the equations of the set
// leave finitely many values to all that f uses; unset: they do not, or no limit suffices.
std::optional<std::vector<Rational>> rational_values(const MFraction& f, const Set& where) {
  constexpr long most_points = 24;
  const auto equations = where.equations();
  std::set<std::size_t> used;
  for (const MPoly& p : equations)
    for (const std::size_t i : used_variables(p))
      used.insert(i);
  for (const MPoly& part : {f.num(), f.den()})
    for (const std::size_t i : used_variables(part))
      if (!used.contains(i)) return std::nullopt;
  try {
    const Ideal points(f.ring(), {used.begin(), used.end()}, equations);
    if (points.dimension() != 0) return std::nullopt;
    const FiniteAlgebra algebra(points, most_points);
    const auto element = algebra.evaluate(f);
    if (!element) return std::nullopt;
    std::vector<NfElem> coefficients;
    for (const MFraction& c : algebra.minimal_polynomial(*element))
      coefficients.emplace_back(to_rational(c));
    std::vector<Rational> values;
    for (const Factor& factor : irreducible_factors(Poly::from_coefficients(coefficients)))
      if (degree(factor.base) == 1) values.push_back(to_rational(-factor.base.coeff(0)));
    return values;
  } catch (const InvalidArgument&) { // more points than that
    return std::nullopt;
  } catch (const OutOfBudget&) {
    return std::nullopt;
  }
}

} // namespace

std::variant<bool, Statement> on_set(const Statement& s, const Set& where) {
  const auto* some = std::get_if<SomeIn>(&s.says);
  if (!some) return s;
  const auto is_special = [&](const Rational& square) {
    const auto root = exact_sqrt(square);
    return root && (!some->classes || contains(*some->classes, *root));
  };
  const auto has_root = [](const Rational& square) { return exact_sqrt(square).has_value(); };
  SomeIn left = *some;
  left.squares.clear();
  for (const MFraction& square : some->squares) {
    const auto here = restricted(square, where);
    if (!here) return s;
    const bool number = is_number(*here);
    const auto values = number ? std::vector{is_zero(*here) ? Rational(0) : to_rational(*here)}
                               : rational_values(*here, where);
    const bool may_be = !values || std::ranges::any_of(*values, is_special);
    if (number && may_be) {
      if (--left.count == 0) return s.holds;
    } else if (!number &&
               (may_be || (some->or_all_rational && std::ranges::any_of(*values, has_root)))) {
      left.squares.push_back(*here);
    } else if (!number || !has_root(values->front())) {
      left.or_all_rational = false;
    }
  }
  if (left.squares.size() < left.count) // of none all are rational
    return (left.squares.empty() && left.or_all_rational) == s.holds;
  return Statement{std::move(left), s.holds};
}

} // namespace kov
