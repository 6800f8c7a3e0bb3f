#include "manifold/lines.hpp"

#include "exact/error.hpp"

#include <algorithm>
#include <tuple>

namespace kov {
namespace {

constexpr int most_branches = 400;
constexpr std::size_t most_special = 4;
constexpr long most_terms = 400; // in the product of two equations, or in conditions

/// Rational zeros of polynomials in some unknowns, one unknown after the other.
class Solver {
public:
  Solver(Ring ring, std::vector<std::size_t> unknowns, const Budget& budget)
      : ring_(std::move(ring)), unknowns_(std::move(unknowns)), budget_(budget) {}

  void solve(const std::vector<MPoly>& equations) { solve(equations, {}, 1); }

  std::vector<Substitution> solutions;     ///< of generic parameters, for all unknowns
  std::vector<std::vector<MPoly>> special; ///< without unknowns

private:
  void solve(const std::vector<MPoly>& equations, const Substitution& known, int eliminations) {
    budget_.check();
    if (++branches_ > most_branches) return;
    std::vector<MPoly> conditions;
    std::vector<std::vector<MPoly>> left; // each equation by its factors with unknowns
    for (const MPoly& e : equations) {
      if (is_zero(e)) continue;
      auto factors = factors_with_unknowns(e);
      if (factors.empty())
        conditions.push_back(e);
      else
        left.push_back(std::move(factors));
    }
    if (std::any_of(conditions.begin(), conditions.end(),
                    [](const MPoly& c) { return is_constant(c); }))
      return;
    if (left.empty()) return finish(known, std::move(conditions));
    const auto next = std::min_element(
        left.begin(), left.end(), [&](const auto& a, const auto& b) { return cost(a) < cost(b); });
    if (std::get<0>(cost(*next)) == 2 && eliminations > 0)
      return eliminate(equations, left, known, eliminations - 1);
    for (const MPoly& f : *next)
      branch(equations, f, known, eliminations);
  }

  // f = c1 u + c0 = 0: u = -c0/c1, or both vanish.
  void branch(std::vector<MPoly> equations, const MPoly& f, const Substitution& known,
              int eliminations) {
    const std::size_t u = linear_unknown(f);
    if (u == none) return;
    const auto c = coefficients(f, u);
    if (!factors_with_unknowns(c[1]).empty()) {
      auto both = equations;
      both.push_back(c[0]);
      both.push_back(c[1]);
      std::erase_if(both, [&](const MPoly& e) { return divides(f, e); });
      solve(both, known, eliminations);
    }
    const Substitution step{{u, -(MFraction(c[0]) / MFraction(c[1]))}};
    const auto values = with(step, known);
    if (!values) return;
    for (MPoly& e : equations)
      e = substitute(e, step).num();
    solve(equations, *values, eliminations);
  }

  // Two equations without a linear factor give one without one of the unknowns.
  void eliminate(std::vector<MPoly> equations, const std::vector<std::vector<MPoly>>& left,
                 const Substitution& known, int eliminations) {
    for (const std::size_t u : unknowns_)
      for (std::size_t j = 1; j < left.size(); ++j) {
        const MPoly a = product(left[0]), b = product(left[j]);
        if (degree(a, u) < 1 || degree(b, u) < 1 || a.length() * b.length() > most_terms) continue;
        const MPoly r = resultant(a, b, u);
        if (!is_zero(r)) equations.push_back(r);
      }
    solve(equations, known, eliminations);
  }

  // What is free gets the values 0 and 1.
  void finish(const Substitution& known, std::vector<MPoly> conditions) {
    if (!conditions.empty()) {
      long terms = 0;
      for (const MPoly& c : conditions)
        terms += c.length();
      if (special.size() < most_special && terms <= most_terms &&
          std::find(special.begin(), special.end(), conditions) == special.end())
        special.push_back(std::move(conditions));
      return;
    }
    const auto free = std::find_if(unknowns_.begin(), unknowns_.end(),
                                   [&](std::size_t u) { return !known.contains(u); });
    if (free == unknowns_.end()) return solutions.push_back(known);
    for (const long value : {0, 1}) {
      const Substitution step{{*free, MFraction(ring_, Rational(value))}};
      if (const auto values = with(step, known)) finish(*values, {});
    }
  }

  // One value more in those that are known; unset: one of them is infinite then.
  static std::optional<Substitution> with(const Substitution& step, const Substitution& known) {
    Substitution values = step;
    try {
      for (const auto& [i, value] : known)
        values[i] = substitute(value, step);
    } catch (const DomainError&) {
      return std::nullopt;
    }
    return values;
  }

  [[nodiscard]] std::vector<MPoly> factors_with_unknowns(const MPoly& e) const {
    std::vector<MPoly> all;
    if (is_constant(e)) return all;
    for (const MFactor& f : factor(e).second)
      if (std::any_of(unknowns_.begin(), unknowns_.end(),
                      [&](std::size_t u) { return uses(f.base, u); }))
        all.push_back(f.base);
    std::sort(all.begin(), all.end(), [&](const MPoly& a, const MPoly& b) {
      return (linear_unknown(a) == none) > (linear_unknown(b) == none);
    });
    return all;
  }
  // In one unknown the rational zeros are those of linear factors, and nothing is lost; of others those
  // with linear factors only come first.
  [[nodiscard]] std::tuple<int, std::size_t, long> cost(const std::vector<MPoly>& factors) const {
    long terms = 0;
    for (const MPoly& f : factors)
      terms += f.length();
    const int rank = has_one_unknown(factors) ? 0 : linear_unknown(factors.front()) != none ? 1 : 2;
    return {rank, factors.size(), terms};
  }
  [[nodiscard]] bool has_one_unknown(const std::vector<MPoly>& factors) const {
    return std::count_if(unknowns_.begin(), unknowns_.end(), [&](std::size_t u) {
             return std::any_of(factors.begin(), factors.end(),
                                [&](const MPoly& f) { return uses(f, u); });
           }) == 1;
  }
  // With a slope that has no unknowns, if there is one.
  [[nodiscard]] std::size_t linear_unknown(const MPoly& f) const {
    std::size_t found = none;
    for (const std::size_t u : unknowns_) {
      if (degree(f, u) != 1) continue;
      const MPoly slope = coefficients(f, u)[1];
      const bool plain = std::none_of(unknowns_.begin(), unknowns_.end(),
                                      [&](std::size_t w) { return uses(slope, w); });
      if (plain) return u;
      if (found == none) found = u;
    }
    return found;
  }
  [[nodiscard]] MPoly product(const std::vector<MPoly>& factors) const {
    MPoly all(ring_, Integer(1));
    for (const MPoly& f : factors)
      all = all * f;
    return all;
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  Ring ring_;
  std::vector<std::size_t> unknowns_;
  const Budget& budget_;
  int branches_ = 0;
};

/// One chart: the line, and what has to vanish on it.
class Chart {
public:
  Chart(const VectorField& v, std::size_t dependent) : v_(v), dependent_(dependent) {
    auto names = v.ring->names();
    for (const char* unknown : {"slope of the line", "offset of the line", "ratio of the momenta"})
      names.emplace_back(unknown);
    ring_ = make_ring(names);
    const std::size_t first = v.ring->size();
    offset_ = first + 1;
    ratio_ = first + 2;
    unknowns_ = {offset_, ratio_};
    if (dependent == 1) unknowns_.insert(unknowns_.begin(), first);
  }

  void find(Lines& all, const Budget& budget) const {
    const auto equations = invariance();
    if (!equations) return;
    Solver solver(ring_, unknowns_, budget);
    solver.solve(*equations);
    for (const Substitution& x : solver.solutions)
      all.lines.push_back({dependent_, dependent_ == 1 ? back(x.at(v_.ring->size())) : zero(),
                           back(x.at(offset_)), back(x.at(ratio_))});
    for (const auto& list : solver.special) {
      std::vector<MPoly> here;
      for (const MPoly& p : list)
        here.push_back(back(MFraction(p)).num());
      all.special.push_back(std::move(here));
    }
  }

private:
  // The coefficients of x_free and p_free; unset where the field has a pole on every line.
  [[nodiscard]] std::optional<std::vector<MPoly>> invariance() const {
    const std::size_t free = 1 - dependent_;
    const MFraction slope = dependent_ == 1 ? unknown(v_.ring->size()) : MFraction(ring_);
    const Substitution line{
        {v_.coordinates[dependent_], slope * unknown(v_.coordinates[free]) + unknown(offset_)},
        {v_.coordinates[dependent_ + 2], unknown(ratio_) * unknown(v_.coordinates[free + 2])}};
    std::vector<MPoly> all;
    try {
      for (const std::size_t part : {0U, 2U}) {
        const MFraction along = part == 0 ? slope : unknown(ratio_);
        const MFraction f =
            substitute(component(dependent_ + part) - along * component(free + part), line);
        add_coefficients(f.num(), {v_.coordinates[free], v_.coordinates[free + 2]}, all);
      }
    } catch (const DomainError&) {
      return std::nullopt;
    }
    return all;
  }
  static void add_coefficients(const MPoly& f, const std::vector<std::size_t>& variables,
                               std::vector<MPoly>& all) {
    std::vector<MPoly> parts{f};
    for (const std::size_t i : variables) {
      std::vector<MPoly> finer;
      for (const MPoly& p : parts)
        for (MPoly& c : coefficients(p, i))
          if (!is_zero(c)) finer.push_back(std::move(c));
      parts = std::move(finer);
    }
    std::move(parts.begin(), parts.end(), std::back_inserter(all));
  }
  [[nodiscard]] MFraction component(std::size_t i) const {
    return transfer(v_.components[i], ring_);
  }
  [[nodiscard]] MFraction unknown(std::size_t i) const { return MFraction::variable(ring_, i); }
  [[nodiscard]] MFraction back(const MFraction& f) const { return transfer(f, v_.ring); }
  [[nodiscard]] MFraction zero() const { return MFraction(v_.ring); }

  const VectorField& v_;
  std::size_t dependent_;
  Ring ring_;
  std::size_t offset_ = 0, ratio_ = 0;
  std::vector<std::size_t> unknowns_;
};

} // namespace

Lines find_lines(const VectorField& v, const Budget& budget) {
  Lines all;
  if (v.dimension() != 4 || !v.functions.empty()) return all;
  for (const std::size_t dependent : {1U, 0U})
    Chart(v, dependent).find(all, budget);
  return all;
}

} // namespace kov
