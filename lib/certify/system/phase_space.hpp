#pragma once
// Polynomials in the phase names with their partial derivatives: system_certificates.md 3.

#include "certify/system/functions.hpp"

#include <algorithm>
#include <functional>

namespace kov::certify {

/// By variable: these, and those on which they depend by inverses and gradients.
[[nodiscard]] inline std::vector<bool> names_behind(const PhaseSystem& s,
                                                    std::vector<std::size_t> left) {
  std::vector<bool> found(s.ring->size(), false);
  const auto visit = [&](const MPoly& f) {
    const auto used = used_variables(f);
    left.insert(left.end(), used.begin(), used.end());
  };
  while (!left.empty()) {
    const std::size_t x = left.back();
    left.pop_back();
    if (found[x]) continue;
    found[x] = true;
    if (x >= s.first_inverse() && x < s.first_parameter()) visit(s.inverses[x - s.first_inverse()]);
    if (x < s.dimension || x >= s.first_inverse()) continue;
    for (const auto& [j, g] : s.functions[x - s.dimension].gradient)
      if (!is_zero(g.p)) {
        left.push_back(j);
        visit(g.p);
      }
  }
  return found;
}

class PhaseSpace {
public:
  PhaseSpace(const PhaseSystem& s, Arithmetic& a) : s_(s), a_(a), in_(s.ring, a) {}

  /// S1; refuses symbols of other kinds than the rule allows.
  void need_symbols() const {
    for (const MPoly& h : s_.inverses)
      need(!is_constant(h) && !uses_inverses(h), "an inverse of a constant, or of an inverse");
    for (const MPoly& r : s_.relations) {
      need(!uses_inverses(r), "a relation has an inverse");
      for (const PhaseFunction& d : gradient({r, {1}}))
        need_cleared(d, {}, "a relation is not preserved");
    }
    for (std::size_t s = 0; s < s_.functions.size(); ++s)
      need_closed(s);
  }
  /// S2: the field, after the bracket is known to be one of Poisson.
  [[nodiscard]] std::vector<PhaseFunction> field() const {
    if (!s_.hamiltonian) return s_.field;
    need_jacobi();
    std::vector<PhaseFunction> x;
    for (std::size_t i = 0; i < s_.dimension; ++i)
      x.push_back(flow(i, *s_.hamiltonian));
    return x;
  }
  /// {x_i, x_j}
  [[nodiscard]] PhaseFunction bracket(std::size_t i, std::size_t j) const {
    for (const PhaseBracket& b : s_.brackets) {
      if (b.first == i && b.second == j) return b.value;
      if (b.first == j && b.second == i) return Functions::negative(b.value);
    }
    return in_.zero();
  }
  /// S3, with what is stated for the relations; refuses `f` with this reason.
  void need_cleared(const PhaseFunction& f, const std::vector<PhaseFunction>& cofactors,
                    const char* why) const {
    PhaseFunction sum = in_.zero();
    need(cofactors.empty() || cofactors.size() == s_.relations.size(),
         "one cofactor for each relation is expected");
    for (std::size_t i = 0; i < cofactors.size(); ++i) {
      need(!uses_inverses(cofactors[i].p), "a cofactor has an inverse");
      sum = in_.plus(sum, in_.times(cofactors[i], {s_.relations[i], {1}}));
    }
    need(scaled(cleared(f.p), sum.n) == scaled(sum.p, f.n), why);
  }
  /// S4; x: field().
  void need_claim(const ClaimedFunction& c, const std::vector<PhaseFunction>& x) const {
    const auto cofactors = [&](std::size_t i) {
      return c.cofactors.empty() ? std::vector<PhaseFunction>{} : c.cofactors[i];
    };
    if (!c.casimir) {
      need(c.cofactors.size() <= 1, "one list of cofactors is expected");
      return need_cleared(along(x, c.value), cofactors(0), "the function is not a first integral");
    }
    need(s_.hamiltonian.has_value(), "a Casimir function of a system without a bracket");
    need(c.cofactors.empty() || c.cofactors.size() == s_.dimension,
         "a list of cofactors for each coordinate is expected");
    for (std::size_t i = 0; i < s_.dimension; ++i)
      need_cleared(flow(i, c.value), cofactors(i), "the function is not a Casimir function");
  }

  [[nodiscard]] PhaseFunction partial(const PhaseFunction& f, std::size_t j) const { ///< d_j f
    a_.charge(static_cast<double>(f.p.length()));
    PhaseFunction sum{derivative(f.p, j), f.n};
    for (std::size_t s = 0; s < s_.functions.size(); ++s)
      if (const PhaseFunction* g = slope(s, j); g && uses(f.p, s_.dimension + s))
        sum = in_.plus(sum, in_.times({derivative(f.p, s_.dimension + s), f.n}, *g));
    for (std::size_t k = 0; k < s_.inverses.size(); ++k) {
      const std::size_t u = s_.first_inverse() + k;
      if (!uses(f.p, u)) continue;
      const PhaseFunction minus_u2{-pow(MPoly::variable(s_.ring, u), 2), {1}};
      const PhaseFunction dh = partial({s_.inverses[k], {1}}, j);
      sum = in_.plus(sum, in_.times({derivative(f.p, u), f.n}, in_.times(minus_u2, dh)));
    }
    return sum;
  }
  [[nodiscard]] std::vector<PhaseFunction> gradient(const PhaseFunction& f) const {
    std::vector<PhaseFunction> df;
    for (std::size_t j = 0; j < s_.dimension; ++j)
      df.push_back(partial(f, j));
    return df;
  }
  /// The derivative along a field.
  [[nodiscard]] PhaseFunction along(const std::vector<PhaseFunction>& x,
                                    const PhaseFunction& f) const {
    return in_.dot(x, gradient(f));
  }
  [[nodiscard]] const Functions& in() const { return in_; }
  /// f times all that its inverses need.
  [[nodiscard]] MPoly cleared(MPoly f) const {
    for (std::size_t k = 0; k < s_.inverses.size(); ++k)
      f = without_inverse(f, s_.first_inverse() + k, s_.inverses[k], a_);
    return f;
  }

  /// By variable: those of `over`, and the functions that relations make algebraic over them, one after
  /// the other, by a leading coefficient that is a unit.
  [[nodiscard]] std::vector<bool>
  algebraic(std::vector<bool> over, const std::function<bool(const MPoly&)>& is_unit) const {
    for (bool again = true; again;) {
      again = false;
      for (const MPoly& r : s_.relations) {
        std::vector<std::size_t> fresh = used_variables(r);
        std::erase_if(fresh, [&](std::size_t i) { return over[i]; });
        if (fresh.size() != 1 || fresh[0] < s_.dimension || fresh[0] >= s_.first_inverse())
          continue;
        if (is_unit(coefficients(r, fresh[0]).back())) over[fresh[0]] = again = true;
      }
    }
    return over;
  }
  /// The entry of the gradient of function s for x_j; null: 0.
  [[nodiscard]] const PhaseFunction* slope(std::size_t s, std::size_t j) const {
    for (const auto& [k, g] : s_.functions[s].gradient)
      if (k == j) return &g;
    return nullptr;
  }

private:
  [[nodiscard]] bool uses_inverses(const MPoly& f) const {
    const auto used = used_variables(f);
    return std::ranges::any_of(
        used, [&](std::size_t i) { return i >= s_.first_inverse() && i < s_.first_parameter(); });
  }
  // Some function has this gradient; a constant without a relation would be a parameter.
  void need_closed(std::size_t s) const {
    const auto entry = [&](std::size_t j) {
      const PhaseFunction* g = slope(s, j);
      return g ? *g : in_.zero();
    };
    const auto has_relation = [&](const MPoly& r) { return uses(r, s_.dimension + s); };
    bool moves = false;
    for (std::size_t i = 0; i < s_.dimension; ++i) {
      moves = moves || !is_zero(entry(i).p);
      for (std::size_t j = i + 1; j < s_.dimension; ++j)
        need_cleared(in_.minus(partial(entry(j), i), partial(entry(i), j)), {},
                     "no function has this gradient");
    }
    need(moves || std::ranges::any_of(s_.relations, has_relation), "a constant without a relation");
  }
  void need_jacobi() const {
    for (std::size_t i = 0; i < s_.dimension; ++i)
      for (std::size_t j = i + 1; j < s_.dimension; ++j)
        for (std::size_t k = j + 1; k < s_.dimension; ++k)
          need_cleared(in_.plus(flow(i, bracket(j, k)),
                                in_.plus(flow(j, bracket(k, i)), flow(k, bracket(i, j)))),
                       {}, "the bracket does not satisfy Jacobi's identity");
  }
  // sum_l {x_i, x_l} d_l f
  [[nodiscard]] PhaseFunction flow(std::size_t i, const PhaseFunction& f) const {
    std::vector<PhaseFunction> row, df;
    for (std::size_t l = 0; l < s_.dimension; ++l) {
      row.push_back(bracket(i, l));
      df.push_back(is_zero(row.back().p) ? in_.zero() : partial(f, l));
    }
    return in_.dot(row, df);
  }

  const PhaseSystem& s_;
  Arithmetic& a_;
  Functions in_;
};

} // namespace kov::certify
