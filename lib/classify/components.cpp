#include "classify/components.hpp"
#include "exact/lists.hpp"

#include <algorithm>
#include <optional>

namespace kov {
namespace {

using Polynomials = std::vector<MPoly>;

/// Splits along factors and puts in what an equation says of a variable in which it is linear.
class Decomposition {
public:
  Decomposition(const Polynomials& nonzero, const Budget& budget) : budget_(budget) {
    for (const MPoly& f : nonzero)
      for (const MFactor& part : factor(f).second)
        nonzero_.push_back(part.base);
  }

  // done: equations that were used; they are told, and nothing else is asked of them.
  void split(Polynomials left, const Polynomials& done) {
    budget_.check();
    std::vector<Polynomials> factors;
    Polynomials simple;
    for (const MPoly& f : left) {
      if (is_zero(f)) continue;
      Polynomials parts = possible_factors(f);
      if (parts.empty()) return; // f vanishes nowhere
      if (parts.size() == 1)
        simple.push_back(std::move(parts.front()));
      else
        factors.push_back(std::move(parts));
    }
    if (factors.empty()) return solve(std::move(simple), done);
    const auto shortest = std::ranges::min_element(
        factors, [](const Polynomials& a, const Polynomials& b) { return length(a) < length(b); });
    const Polynomials cases = *shortest;
    for (auto other = factors.begin(); other != factors.end(); ++other)
      if (other != shortest) simple.push_back(product(*other));
    for (const MPoly& zero : cases) {
      Polynomials branch = simple;
      branch.push_back(zero);
      split(std::move(branch), done);
    }
  }

  std::vector<Polynomials> found;

private:
  // Irreducible, and without those that are known not to vanish.
  [[nodiscard]] Polynomials possible_factors(const MPoly& f) const {
    Polynomials all;
    for (const MFactor& part : factor(f).second)
      if (!is_among(part.base, nonzero_)) all.push_back(part.base);
    return all;
  }
  static long length(const Polynomials& all) {
    long sum = 0;
    for (const MPoly& f : all)
      sum += f.length();
    return sum;
  }
  static MPoly product(const Polynomials& all) {
    MPoly f = all.front();
    for (std::size_t i = 1; i < all.size(); ++i)
      f *= all[i];
    return f;
  }

  // Irreducible equations only, each once.
  void solve(Polynomials simple, const Polynomials& done) {
    if (contradict_each_other(simple)) return;
    if (const auto line = simple.size() < 2 ? std::nullopt : linear_equation(simple))
      return put_in(std::move(simple), *line, done);
    simple.insert(simple.begin(), done.begin(), done.end());
    add_once(found, std::move(simple));
  }
  // Two of them in the same single variable, after equal ones are told apart.
  static bool contradict_each_other(Polynomials& simple) {
    for (std::size_t i = 0; i < simple.size(); ++i)
      simple.erase(std::remove(simple.begin() + static_cast<long>(i) + 1, simple.end(), simple[i]),
                   simple.end());
    std::vector<std::size_t> seen;
    for (const MPoly& f : simple) {
      const auto used = used_variables(f);
      if (used.size() != 1) continue;
      if (is_among(used.front(), seen)) return true;
      seen.push_back(used.front());
    }
    return false;
  }

  struct Line {
    std::size_t equation = 0;
    Substitution value;
  };
  [[nodiscard]] std::optional<Line> linear_equation(const Polynomials& simple) const {
    for (std::size_t i = 0; i < simple.size(); ++i)
      for (const std::size_t x : used_variables(simple[i]))
        if (const auto c = coefficients(simple[i], x);
            c.size() == 2 && (is_constant(c[1]) || possible_factors(c[1]).empty()))
          return Line{i, {{x, -(MFraction(c[0]) / MFraction(c[1]))}}};
    return std::nullopt;
  }

  void put_in(Polynomials simple, const Line& line, Polynomials done) {
    done.push_back(simple[line.equation]);
    simple.erase(simple.begin() + static_cast<long>(line.equation));
    for (MPoly& f : simple)
      f = substitute(f, line.value).num();
    Decomposition there({}, budget_);
    for (const MPoly& f : nonzero_) {
      const MPoly value = substitute(f, line.value).num();
      if (is_zero(value)) return; // there are no such zeros
      for (const MFactor& part : factor(value).second)
        there.nonzero_.push_back(part.base);
    }
    there.split(std::move(simple), done);
    for (Polynomials& one : there.found)
      add_once(found, std::move(one));
  }

  const Budget& budget_;
  Polynomials nonzero_;
};

} // namespace

std::vector<std::vector<MPoly>> components(const std::vector<MPoly>& equations,
                                           const std::vector<MPoly>& nonzero,
                                           const Budget& budget) {
  Decomposition all(nonzero, budget);
  all.split(equations, {});
  return std::move(all.found);
}

} // namespace kov
