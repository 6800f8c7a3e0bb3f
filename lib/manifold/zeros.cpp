#include "manifold/zeros.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr int most_branches = 400;
constexpr std::size_t most_special = 4;
constexpr long most_terms = 400; // in the product of two equations, or in conditions
constexpr std::size_t none = static_cast<std::size_t>(-1);

std::optional<MPoly> root_of_square(const MPoly& f) {
  if (is_zero(f)) return f;
  const auto [content, factors] = factor(f);
  if (sign(content) < 0) return std::nullopt;
  const auto whole = exact_sqrt(content);
  if (!whole) return std::nullopt;
  MPoly root(f.ring(), *whole);
  for (const MFactor& g : factors) {
    if (g.exponent % 2 != 0) return std::nullopt;
    root *= pow(g.base, static_cast<unsigned long>(g.exponent / 2));
  }
  return root;
}

// r_2^k f without powers of the root above the first.
MPoly reduced_by(const QuadraticConstant& root, MPoly f) {
  const auto& [i, relation] = root;
  const MPoly x = MPoly::variable(f.ring() ? f.ring() : relation.ring(), i);
  const auto r = coefficients(relation, i);
  for (long d = degree(f, i); d >= 2; d = degree(f, i))
    f = r[2] * f - coefficients(f, i).back() * pow(x, static_cast<unsigned long>(d - 2)) * relation;
  return f;
}

// f = a + b x for the root x of the relation.
std::pair<MFraction, MFraction> linear_in_root(const QuadraticConstant& root, const MPoly& f) {
  const auto r = coefficients(root.relation, root.variable);
  const MFraction trace = -MFraction(r[1], r[2]), norm(r[0], r[2]); // x^2 = trace x - norm
  const auto c = coefficients(f, root.variable);
  MFraction a(f.ring()), b(f.ring());
  for (std::size_t k = c.size(); k-- > 0;) {
    const MFraction next = a + b * trace;
    a = MFraction(c[k]) - b * norm;
    b = next;
  }
  return {a, b};
}

// Writes f with the root in the numerator only, and linear.
MFraction in_lowest_terms(const QuadraticConstant& root, const MFraction& f) {
  if (!uses(f, root.variable)) return f;
  const auto r = coefficients(root.relation, root.variable);
  const MFraction trace = -MFraction(r[1], r[2]), norm(r[0], r[2]);
  const auto [a, b] = linear_in_root(root, f.num());
  const auto [c, d] = linear_in_root(root, f.den());
  const MFraction size = c * c + c * d * trace + d * d * norm; // (c + d x)(c + d x~)
  const MFraction x = MFraction::variable(f.num().ring(), root.variable);
  // (a + b x)(c + d trace - d x)
  return (a * (c + d * trace) + b * d * norm + (b * c - a * d) * x) / size;
}

// Up to a square; squares of large primes stay.
MPoly without_squares(const MPoly& f) {
  const auto [content, factors] = factor(f);
  Integer number = content;
  for (const long p : {2, 3, 5, 7, 11, 13}) {
    const Integer square(p * p);
    while (floor_div(number, square) * square == number)
      number = floor_div(number, square);
  }
  MPoly left(f.ring(), number);
  for (const MFactor& g : factors)
    if (g.exponent % 2 != 0) left *= g.base;
  return left;
}

} // namespace

void ZeroSearch::solve(const std::vector<MPoly>& given, const Substitution& known,
                       int eliminations) {
  budget_.check();
  if (++branches_ > most_branches) return;
  const std::vector<MPoly> equations = simplified(given);
  const auto units = factors_of_nonzero(known);
  if (!units) return;
  std::vector<MPoly> conditions;
  std::vector<std::vector<MPoly>> left; // each equation by its factors with unknowns
  for (const MPoly& e : equations) {
    if (is_zero(e)) continue;
    auto factors = factors_with_unknowns(e);
    const bool has_zeros = !factors.empty();
    std::erase_if(factors, [&](const MPoly& f) { return is_among(f, *units); });
    if (has_zeros && factors.empty()) return;
    if (factors.empty())
      conditions.push_back(e);
    else
      left.push_back(std::move(factors));
  }
  if (std::ranges::any_of(conditions, [](const MPoly& c) { return is_constant(c); })) return;
  if (left.empty()) return finish(known, std::move(conditions));
  const auto next = std::ranges::min_element(
      left, [&](const auto& a, const auto& b) { return cost(a) < cost(b); });
  if (std::get<0>(cost(*next)) >= 2 && eliminations > 0)
    return eliminate(equations, left, known, eliminations - 1);
  for (const MPoly& f : *next)
    linear_unknown(f) == none ? at_roots(equations, f, known, eliminations)
                              : branch(equations, f, known, eliminations);
}

// f = c1 u + c0 = 0: u = -c0/c1, or both vanish.
void ZeroSearch::branch(std::vector<MPoly> equations, const MPoly& f, const Substitution& known,
                        int eliminations) {
  const std::size_t u = linear_unknown(f);
  const auto c = coefficients(f, u);
  if (!factors_with_unknowns(c[1]).empty()) {
    auto both = equations;
    both.push_back(c[0]);
    both.push_back(c[1]);
    std::erase_if(both, [&](const MPoly& e) { return divides(f, e); });
    solve(both, known, eliminations);
  }
  at(std::move(equations), u, -(MFraction(c[0]) / MFraction(c[1])), known, eliminations);
}

void ZeroSearch::at(std::vector<MPoly> equations, std::size_t unknown, const MFraction& value,
                    const Substitution& known, int eliminations) {
  const Substitution step{{unknown, value}};
  const auto values = with(step, known);
  if (!values) return;
  for (MPoly& e : equations)
    e = substitute(e, step).num();
  solve(equations, *values, eliminations);
}

// f of degree 2 in one unknown, by the constants or not at all.
void ZeroSearch::at_roots(const std::vector<MPoly>& equations, const MPoly& f,
                          const Substitution& known, int eliminations) {
  if (!has_one_unknown({f})) return;
  const std::size_t u = *std::ranges::find_if(unknowns_, [&](std::size_t i) { return uses(f, i); });
  if (degree(f, u) != 2) return;
  const auto c = coefficients(f, u);
  const MPoly d = reduced(c[1] * c[1] - MPoly(ring_, Integer(4)) * c[0] * c[2]);
  if (const auto root = root_of(d)) {
    const MFraction two_c(MPoly(ring_, Integer(2)) * c[2]);
    for (const MFraction& signed_root : {*root, -*root})
      at(equations, u, (signed_root - MFraction(c[1])) / two_c, known, eliminations);
  } else if (wanted.size() < most_special && !uses_constants(d)) {
    MPoly squarefree = without_squares(d);
    add_once(wanted, std::move(squarefree));
  }
}

// Writes f with exponents below 2 in the constants, times a number or a function of the parameters.
MPoly ZeroSearch::reduced(MPoly f) const {
  for (const QuadraticConstant& c : constants_)
    f = reduced_by(c, std::move(f));
  return f;
}

// If an equation is u^2 + ... in an unknown u, the others get exponents below 2 in it: r^2 = x^2 + y^2
// has r^3 found where (x^2 + y^2) r was.
std::vector<MPoly> ZeroSearch::simplified(std::vector<MPoly> equations) const {
  for (MPoly& e : equations)
    e = reduced(std::move(e));
  std::vector<const MPoly*> used; // each gives one of its squares
  for (const std::size_t u : unknowns_) {
    const MPoly* by = nullptr;
    for (const MPoly& e : equations)
      if (degree(e, u) == 2 && is_constant(coefficients(e, u)[2]) && !is_among(&e, used) &&
          (by == nullptr || e.length() < by->length()))
        by = &e;
    if (by == nullptr) continue;
    used.push_back(by);
    const QuadraticConstant root{u, *by};
    for (MPoly& e : equations)
      if (&e != by) e = reduced_by(root, std::move(e));
  }
  return equations;
}

// Unset where one of them is 0.
std::optional<std::vector<MPoly>> ZeroSearch::factors_of_nonzero(const Substitution& known) const {
  std::vector<MPoly> all;
  for (const MPoly& f : nonzero) {
    const MPoly here = reduced(substitute(f, known).num());
    if (is_zero(here)) return std::nullopt;
    auto factors = factors_with_unknowns(here);
    std::move(factors.begin(), factors.end(), std::back_inserter(all));
  }
  return all;
}

bool ZeroSearch::uses_constants(const MPoly& f) const {
  return std::ranges::any_of(constants_,
                             [&](const QuadraticConstant& c) { return uses(f, c.variable); });
}

// A square root of d, by one of the constants if need be.
std::optional<MFraction> ZeroSearch::root_of(const MPoly& d) const {
  if (const auto root = root_of_square(d)) return MFraction(*root);
  for (const auto& [i, relation] : constants_) {
    const auto r = coefficients(relation, i);
    const MPoly of_constant = r[1] * r[1] - MPoly(ring_, Integer(4)) * r[0] * r[2];
    const auto k = root_of_square(d * of_constant);
    if (!k) continue;
    const MPoly root = MPoly(ring_, Integer(2)) * r[2] * MPoly::variable(ring_, i) + r[1];
    return MFraction(*k * root, of_constant);
  }
  return std::nullopt;
}

// Two equations without a linear factor give one without one of the unknowns.
void ZeroSearch::eliminate(std::vector<MPoly> equations,
                           const std::vector<std::vector<MPoly>>& left, const Substitution& known,
                           int eliminations) {
  for (const std::size_t u : unknowns_)
    for (std::size_t j = 1; j < left.size(); ++j) {
      const MPoly a = product(left[0]), b = product(left[j]);
      if (degree(a, u) < 1 || degree(b, u) < 1 || a.length() * b.length() > most_terms) continue;
      const MPoly r = resultant(a, b, u);
      if (!is_zero(r)) equations.push_back(r);
    }
  solve(equations, known, eliminations);
}

// Free unknowns get the values 0 and 1.
void ZeroSearch::finish(const Substitution& known, std::vector<MPoly> conditions) {
  if (!conditions.empty()) {
    if (std::ranges::any_of(conditions, [&](const MPoly& c) { return uses_constants(c); })) return;
    long terms = 0;
    for (const MPoly& c : conditions)
      terms += c.length();
    if (special.size() < most_special && terms <= most_terms && !is_among(conditions, special))
      special.push_back(std::move(conditions));
    return;
  }
  const auto free =
      std::ranges::find_if(unknowns_, [&](std::size_t u) { return !known.contains(u); });
  if (free == unknowns_.end()) {
    Substitution zero = known;
    for (auto& [i, value] : zero)
      for (const QuadraticConstant& c : constants_)
        value = in_lowest_terms(c, value);
    return zeros.push_back(std::move(zero));
  }
  for (const long value : {0, 1}) {
    const Substitution step{{*free, MFraction(ring_, Rational(value))}};
    if (const auto values = with(step, known)) finish(*values, {});
  }
}

// One value more in those that are known; unset: one of them is infinite then.
std::optional<Substitution> ZeroSearch::with(const Substitution& step, const Substitution& known) {
  Substitution values = step;
  try {
    for (const auto& [i, value] : known)
      values[i] = substitute(value, step);
  } catch (const DomainError&) {
    return std::nullopt;
  }
  return values;
}

std::vector<MPoly> ZeroSearch::factors_with_unknowns(const MPoly& e) const {
  std::vector<MPoly> all;
  if (is_constant(e)) return all;
  for (const MFactor& f : factor(e).second)
    if (uses_any(f.base, unknowns_)) all.push_back(f.base);
  std::ranges::sort(all, [&](const MPoly& a, const MPoly& b) {
    return (linear_unknown(a) == none) > (linear_unknown(b) == none);
  });
  return all;
}
// In one unknown the rational zeros are those of linear factors, and nothing is lost; of the others those
// with linear factors only come first.
std::tuple<int, std::size_t, long> ZeroSearch::cost(const std::vector<MPoly>& factors) const {
  long terms = 0;
  for (const MPoly& f : factors)
    terms += f.length();
  const int rank = has_one_unknown(factors)                  ? 0
                   : linear_unknown(factors.front()) != none ? 1
                   : linear_unknown(factors.back()) != none  ? 2
                                                             : 3;
  return {rank, rank == 2 ? 0 : factors.size(), terms};
}
bool ZeroSearch::has_one_unknown(const std::vector<MPoly>& factors) const {
  return std::ranges::count_if(unknowns_, [&](std::size_t u) { return any_uses(factors, u); }) == 1;
}
// An unknown in which f is linear, with a slope that has no unknowns if there is one.
std::size_t ZeroSearch::linear_unknown(const MPoly& f) const {
  std::size_t found = none;
  for (const std::size_t u : unknowns_) {
    if (degree(f, u) != 1) continue;
    const MPoly slope = coefficients(f, u)[1];
    const bool plain = !uses_any(slope, unknowns_);
    if (plain) return u;
    if (found == none) found = u;
  }
  return found;
}
MPoly ZeroSearch::product(const std::vector<MPoly>& factors) const {
  MPoly all(ring_, Integer(1));
  for (const MPoly& f : factors)
    all = all * f;
  return all;
}

} // namespace kov
