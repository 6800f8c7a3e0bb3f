#include "spectrum/solve_for_energy.hpp"
#include "exact/lists.hpp"

#include <algorithm>

namespace kov::spectrum {
namespace {

// The numbers of the condition in a ring that has N, and square roots as names of their own.
struct TermsOfCondition {
  Ring ring;
  std::size_t n = 0;
  std::size_t energy = 0;
  std::vector<MFraction> squares;      ///< of the numbers that depend on E
  std::vector<MFraction> numbers;      ///< the others
  std::vector<std::size_t> irrational; ///< names that stand for square roots of numbers
};

std::string free_name(const Ring& ring, std::string name) {
  while (ring->find(name))
    name += '_';
  return name;
}

TermsOfCondition terms(const SumIn& condition, std::size_t energy) {
  const Ring& ring = condition.squares.front().ring();
  std::vector<std::string> names = ring->names();
  names.push_back(free_name(ring, "N"));
  std::vector<std::pair<std::size_t, std::string>> roots;
  for (std::size_t i = 0; i < condition.squares.size(); ++i) {
    const MFraction& f = condition.squares[i];
    if (uses(f, energy) || square_root(f)) continue;
    roots.emplace_back(i, "sqrt(" + to_string(f) + ")");
    add_once(names, roots.back().second);
  }
  TermsOfCondition t;
  t.ring = make_ring(names);
  t.n = ring->size();
  t.energy = energy;
  for (std::size_t i = 0; i < condition.squares.size(); ++i) {
    const MFraction& f = condition.squares[i];
    const auto root = std::ranges::find_if(roots, [&](const auto& r) { return r.first == i; });
    if (uses(f, energy))
      t.squares.push_back(transfer(f, t.ring));
    else if (root != roots.end()) {
      t.numbers.push_back(MFraction::variable(t.ring, root->second));
      if (is_constant(f)) t.irrational.push_back(t.ring->index(root->second));
    } else
      t.numbers.push_back(transfer(*square_root(f), t.ring));
  }
  return t;
}

// prod (c - s1 x1 - s2 x2) over all signs, in the squares: 0 exactly where some choice of signs gives c.
MFraction norm(const MFraction& c, const std::vector<MFraction>& squares) {
  if (squares.size() == 1) return c * c - squares[0];
  const MFraction sum = squares[0] + squares[1];
  const MFraction difference = squares[0] - squares[1];
  return c * c * c * c - Rational(2) * c * c * sum + difference * difference;
}

// a + step N for all integers N; its negatives are the same numbers.
bool is_symmetric(const Residues& r) { return is_integer(Rational(2) * r.a / r.step); }

Series series_of(const TermsOfCondition& t, const MPoly& equation) {
  Series s;
  s.equation = equation;
  s.n = t.n;
  s.every_energy = !uses(equation, t.energy);
  if (const auto c = coefficients(equation, t.energy); c.size() == 2)
    s.value = -MFraction(c[0]) / MFraction(c[1]);
  return s;
}

// An irreducible polynomial in N alone: has it an integer root?
bool has_integer_root(const MPoly& f, std::size_t n) {
  const auto c = coefficients(f, n);
  return c.size() == 2 && is_integer(to_rational(MFraction(c[0]) / MFraction(c[1])));
}

// The solutions of one equation after another, each once.
class EnergySolutions {
public:
  EnergySolutions(const TermsOfCondition& t, const Residues& r) : t_(t) {
    if (is_symmetric(r)) mirror_ = Rational(-2) * r.a / r.step;
  }

  /// false: every E solves it, for all parameters.
  bool add(const MPoly& f) {
    for (const MFactor& x : factor(f).second) {
      auto used = used_variables(x.base);
      if (used == std::vector<std::size_t>{t_.n}) {
        if (has_integer_root(x.base, t_.n)) return false;
      } else if (is_in_numbers(used)) {
        if (!has_irrational_root(x.base)) return false;
      } else if (!is_known(x.base)) {
        all.push_back(series_of(t_, x.base));
      }
    }
    return true;
  }

  std::vector<Series> all;

private:
  // In N and roots of numbers alone.
  [[nodiscard]] bool is_in_numbers(const std::vector<std::size_t>& used) const {
    return std::ranges::all_of(
        used, [&](std::size_t i) { return i == t_.n || is_among(i, t_.irrational); });
  }
  // c1 N + c0 + c2 s with one square root s that is irrational.
  [[nodiscard]] bool has_irrational_root(const MPoly& f) const {
    const auto used = used_variables(f);
    return used.size() == 2 && degree(f, used[0]) == 1 && degree(f, used[1]) == 1 &&
           f.length() <= 3 && is_constant(coefficients(f, t_.n).back());
  }

  // Up to the sign, and up to the mirror N -> -N - 2a/s, which exchanges a choice and its negative.
  [[nodiscard]] bool is_known(const MPoly& f) const {
    return std::ranges::any_of(all, [&](const Series& s) {
      if (s.equation == f) return true;
      if (!mirror_) return false;
      const MFraction n(t_.ring, *mirror_);
      const MPoly g = substitute(f, {{t_.n, n - MFraction::variable(t_.ring, t_.n)}}).num();
      return s.equation == g || s.equation == -g;
    });
  }

  const TermsOfCondition& t_;
  std::optional<Rational> mirror_; ///< N -> mirror - N
};

} // namespace

std::vector<Series> solve_for_energy(const SumIn& condition, std::size_t energy) {
  const TermsOfCondition t = terms(condition, energy);
  if (t.squares.empty() || t.squares.size() > 2) return {};
  std::vector<Series> all;
  const std::size_t signs = std::size_t{1} << t.numbers.size();
  for (const Residues& r : condition.classes) {
    EnergySolutions solutions(t, r);
    for (const bool negative : {false, true}) {
      if (negative && is_symmetric(r)) continue;
      for (std::size_t pick = 0; pick < signs; ++pick) {
        // The negative of a choice: N becomes its mirror.
        if (pick >= (signs + 1) / 2 && is_symmetric(r)) continue;
        MFraction c =
            r.step * MFraction::variable(t.ring, t.n) + MFraction(t.ring, negative ? -r.a : r.a);
        for (std::size_t i = 0; i < t.numbers.size(); ++i)
          c += Rational((pick >> i & 1U) != 0 ? -1 : 1) * t.numbers[i];
        const MFraction f = norm(c, t.squares);
        if (is_zero(f) || !solutions.add(f.num())) return {};
      }
    }
    all.insert(all.end(), solutions.all.begin(), solutions.all.end());
  }
  return all;
}

} // namespace kov::spectrum
