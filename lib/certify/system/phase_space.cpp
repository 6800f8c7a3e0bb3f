#include "certify/system/phase_space.hpp"

#include "certify/equation/facts.hpp"

#include <algorithm>

namespace kov::certify {

void PhaseSpace::need_symbols() const {
  for (const MPoly& h : s_.inverses)
    need(!is_constant(h) && !uses_inverses(h), "an inverse of a constant, or of an inverse");
  for (const MPoly& r : s_.relations) {
    need(!uses_inverses(r), "a relation has an inverse");
    for (std::size_t j = 0; j < s_.dimension; ++j)
      need_cleared(partial({r, Integer(1)}, j), {}, "a relation is not preserved");
  }
  for (std::size_t s = 0; s < s_.functions.size(); ++s)
    need_closed(s);
}

// Some function has this gradient; a constant without a relation would be a parameter.
void PhaseSpace::need_closed(std::size_t s) const {
  const auto entry = [&](std::size_t j) {
    const PhaseFunction* g = gradient(s, j);
    return g ? *g : in_.zero();
  };
  const auto has_relation = [&](const MPoly& r) { return uses(r, s_.dimension + s); };
  bool moves = false;
  for (std::size_t i = 0; i < s_.dimension; ++i) {
    moves = moves || !is_zero(entry(i).p);
    for (std::size_t j = i + 1; j < s_.dimension; ++j) {
      const PhaseFunction second = partial(entry(i), j);
      need_cleared(in_.plus(partial(entry(j), i), {-second.p, second.n}), {},
                   "no function has this gradient");
    }
  }
  need(moves || std::ranges::any_of(s_.relations, has_relation), "a constant without a relation");
}

std::vector<bool> PhaseSpace::algebraic(std::vector<bool> over,
                                        const std::function<bool(const MPoly&)>& is_unit) const {
  for (bool again = true; again;) {
    again = false;
    for (const MPoly& r : s_.relations) {
      std::vector<std::size_t> fresh = used_variables(r);
      std::erase_if(fresh, [&](std::size_t i) { return over[i]; });
      if (fresh.size() != 1 || fresh[0] < s_.dimension || fresh[0] >= s_.first_inverse()) continue;
      if (is_unit(coefficients(r, fresh[0]).back())) over[fresh[0]] = again = true;
    }
  }
  return over;
}

std::vector<bool> PhaseSpace::arguments(std::size_t s) const {
  std::vector<bool> found(s_.ring->size(), false);
  std::vector<std::size_t> left{s_.dimension + s};
  while (!left.empty()) {
    const std::size_t x = left.back();
    left.pop_back();
    if (found[x]) continue;
    found[x] = true;
    const auto visit = [&](const MPoly& f) {
      const auto used = used_variables(f);
      left.insert(left.end(), used.begin(), used.end());
    };
    if (x >= s_.first_inverse() && x < s_.first_parameter())
      visit(s_.inverses[x - s_.first_inverse()]);
    if (x < s_.dimension || x >= s_.first_inverse()) continue;
    for (const auto& [j, g] : s_.functions[x - s_.dimension].gradient)
      if (!is_zero(g.p)) {
        left.push_back(j);
        visit(g.p);
      }
  }
  std::fill(found.begin() + static_cast<std::ptrdiff_t>(s_.dimension), found.end(), false);
  return found;
}

bool PhaseSpace::uses_inverses(const MPoly& f) const {
  for (std::size_t i = s_.first_inverse(); i < s_.first_parameter(); ++i)
    if (uses(f, i)) return true;
  return false;
}

const PhaseFunction* PhaseSpace::gradient(std::size_t s, std::size_t j) const {
  for (const auto& [k, g] : s_.functions[s].gradient)
    if (k == j) return &g;
  return nullptr;
}

PhaseFunction PhaseSpace::partial(const PhaseFunction& f, std::size_t j) const {
  a_.charge(static_cast<double>(f.p.length()));
  PhaseFunction sum{derivative(f.p, j), f.n};
  for (std::size_t s = 0; s < s_.functions.size(); ++s)
    if (const PhaseFunction* g = gradient(s, j); g && uses(f.p, s_.dimension + s))
      sum = in_.plus(sum, in_.times({derivative(f.p, s_.dimension + s), f.n}, *g));
  for (std::size_t k = 0; k < s_.inverses.size(); ++k) {
    const std::size_t u = s_.first_inverse() + k;
    if (!uses(f.p, u)) continue;
    const PhaseFunction minus_u2{-pow(MPoly::variable(s_.ring, u), 2), Integer(1)};
    const PhaseFunction dh = partial({s_.inverses[k], Integer(1)}, j);
    sum = in_.plus(sum, in_.times({derivative(f.p, u), f.n}, in_.times(minus_u2, dh)));
  }
  return sum;
}

PhaseFunction PhaseSpace::bracket(std::size_t i, std::size_t j) const {
  for (const PhaseBracket& b : s_.brackets) {
    if (b.first == i && b.second == j) return b.value;
    if (b.first == j && b.second == i) return {-b.value.p, b.value.n};
  }
  return in_.zero();
}

PhaseFunction PhaseSpace::flow(std::size_t i, const PhaseFunction& f) const {
  std::vector<PhaseFunction> row;
  std::vector<PhaseFunction> df;
  for (std::size_t l = 0; l < s_.dimension; ++l) {
    row.push_back(bracket(i, l));
    df.push_back(is_zero(row.back().p) ? in_.zero() : partial(f, l));
  }
  return product(row, df);
}

void PhaseSpace::need_jacobi() const {
  for (std::size_t i = 0; i < s_.dimension; ++i)
    for (std::size_t j = i + 1; j < s_.dimension; ++j)
      for (std::size_t k = j + 1; k < s_.dimension; ++k)
        need_cleared(in_.plus(flow(i, bracket(j, k)),
                              in_.plus(flow(j, bracket(k, i)), flow(k, bracket(i, j)))),
                     {}, "the bracket does not satisfy Jacobi's identity");
}

std::vector<PhaseFunction> PhaseSpace::field() const {
  if (!s_.hamiltonian) return s_.field;
  need_jacobi();
  std::vector<PhaseFunction> x;
  for (std::size_t i = 0; i < s_.dimension; ++i)
    x.push_back(flow(i, *s_.hamiltonian));
  return x;
}

MPoly PhaseSpace::cleared(MPoly f) const {
  for (std::size_t k = 0; k < s_.inverses.size(); ++k)
    f = without_inverse(f, s_.first_inverse() + k, s_.inverses[k], a_);
  return f;
}

void PhaseSpace::need_cleared(const PhaseFunction& f, const std::vector<PhaseFunction>& cofactors,
                              const char* why) const {
  PhaseFunction sum = in_.zero();
  if (!cofactors.empty()) {
    need(cofactors.size() == s_.relations.size(), "one cofactor for each relation is expected");
    for (const PhaseFunction& c : cofactors)
      need(!uses_inverses(c.p), "a cofactor has an inverse");
    std::vector<PhaseFunction> relations;
    for (const MPoly& r : s_.relations)
      relations.push_back({r, Integer(1)});
    sum = product(cofactors, relations);
  }
  const MPoly rest = cleared(f.p);
  need(scaled(rest, sum.n) == scaled(sum.p, f.n), why);
}

void PhaseSpace::need_claim(const ClaimedFunction& c, const std::vector<PhaseFunction>& x) const {
  const auto cofactors = [&](std::size_t i) {
    return c.cofactors.empty() ? std::vector<PhaseFunction>{} : c.cofactors[i];
  };
  if (!c.casimir) {
    need(c.cofactors.size() <= 1, "one list of cofactors is expected");
    std::vector<PhaseFunction> df;
    for (std::size_t j = 0; j < s_.dimension; ++j)
      df.push_back(partial(c.value, j));
    return need_cleared(product(x, df), cofactors(0), "the function is not a first integral");
  }
  need(s_.hamiltonian.has_value(), "a Casimir function of a system without a bracket");
  need(c.cofactors.empty() || c.cofactors.size() == s_.dimension,
       "a list of cofactors for each coordinate is expected");
  for (std::size_t i = 0; i < s_.dimension; ++i)
    need_cleared(flow(i, c.value), cofactors(i), "the function is not a Casimir function");
}

} // namespace kov::certify
