#include "manifold/rests.hpp"

#include "exact/error.hpp"
#include "exact/finite_algebra.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "exact/variables.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace kov {
namespace {

constexpr long most_rests = 40; // with multiplicities
constexpr std::size_t most_places = 16;

/// Variables of a ring in classes that are united.
class Classes {
public:
  explicit Classes(std::size_t n) : of_(n) { std::iota(of_.begin(), of_.end(), std::size_t{0}); }
  [[nodiscard]] std::size_t operator()(std::size_t i) const {
    while (of_[i] != i)
      i = of_[i];
    return i;
  }
  void unite(std::size_t i, std::size_t j) { of_[(*this)(i)] = (*this)(j); }

private:
  std::vector<std::size_t> of_;
};

/// One part of the system, and the places where it rests.
class Part {
public:
  Part(const VectorField& v, const std::vector<std::size_t>& members, const Classes& classes)
      : v_(v) {
    for (const std::size_t j : members)
      equations_.push_back(v.components[j].num());
    const std::size_t name = classes(v.coordinates[members.front()]);
    for (const MPoly& r : v.relations)
      if (const auto used = used_variables(r);
          std::ranges::any_of(used, [&](std::size_t i) { return classes(i) == name; }))
        equations_.push_back(r);
    for (const std::size_t j : members)
      nonzero_.push_back(v.components[j].den());
    for (const std::size_t i : v.main_variables())
      if (!is_among(i, v.constants) &&
          std::ranges::any_of(equations_, [&](const MPoly& f) { return uses(f, i); }))
        variables_.push_back(i);
  }

  [[nodiscard]] std::vector<std::vector<Equation>> rests(const Budget& budget) const {
    if (std::ranges::any_of(v_.constants, [&](std::size_t c) {
          return std::ranges::any_of(equations_, [&](const MPoly& f) { return uses(f, c); });
        }))
      return {};
    Ideal ideal(v_.ring, variables_, equations_, nonzero_, budget);
    if (ideal.is_unit() || ideal.dimension() != 0) return {};
    const FiniteAlgebra algebra(std::move(ideal), most_rests);
    std::vector<Substitution> places{{}};
    for (const std::size_t i : variables_) {
      std::vector<Substitution> longer;
      for (const MFraction& value : values(algebra, i))
        for (Substitution place : places) {
          place[i] = value;
          if (longer.size() < most_places && may_rest(place)) longer.push_back(std::move(place));
        }
      places = std::move(longer);
    }
    std::vector<std::vector<Equation>> all;
    for (const Substitution& place : places) {
      all.emplace_back();
      for (const auto& [i, value] : place)
        all.back().push_back(
            {MFraction::variable(v_.ring, i) - value, v_.ring->name(i) + " = " + to_string(value)});
    }
    return all;
  }

private:
  // Without parameters below: a place for all of them.
  [[nodiscard]] std::vector<MFraction> values(const FiniteAlgebra& algebra, std::size_t i) const {
    const auto element = algebra.evaluate(MFraction::variable(v_.ring, i));
    if (!element) return {};
    MFraction f(v_.ring), power(v_.ring, Rational(1));
    for (const MFraction& c : algebra.minimal_polynomial(*element)) {
      f += c * power;
      power *= MFraction::variable(v_.ring, i);
    }
    std::vector<MFraction> all;
    for (const MFactor& factor_of : factor(f.num()).second)
      if (const auto c = coefficients(factor_of.base, i);
          c.size() == 2 && is_constant(MFraction(c[1])))
        all.push_back(-MFraction(c[0], c[1]));
    return all;
  }
  // No equation is a number that is not 0 there.
  [[nodiscard]] bool may_rest(const Substitution& place) const {
    return std::ranges::all_of(equations_, [&](const MPoly& f) {
      const MFraction there = substitute(MFraction(f), place);
      return is_zero(there) || uses_any(there, variables_);
    });
  }

  const VectorField& v_;
  std::vector<MPoly> equations_, nonzero_;
  std::vector<std::size_t> variables_;
};

Classes classes_of(const VectorField& v) {
  Classes classes(v.ring->size());
  const auto main = v.main_variables();
  const auto unite = [&](std::size_t i, const MFraction& f) {
    for (const std::size_t j : used_variables(f))
      if (is_among(j, main) && !is_among(j, v.constants)) classes.unite(i, j);
  };
  for (std::size_t j = 0; j < v.dimension(); ++j)
    unite(v.coordinates[j], v.components[j]);
  for (const FunctionSymbol& f : v.functions)
    for (std::size_t j = 0; j < v.dimension(); ++j)
      if (!is_zero(f.gradient[j])) {
        classes.unite(f.variable, v.coordinates[j]);
        unite(f.variable, f.gradient[j]);
      }
  for (const MPoly& r : v.relations)
    for (const std::size_t i : used_variables(r))
      if (is_among(i, main) && !is_among(i, v.constants)) unite(i, MFraction(r));
  return classes;
}

/// Indices of coordinates.
std::vector<std::vector<std::size_t>> members(const VectorField& v, const Classes& classes) {
  std::map<std::size_t, std::vector<std::size_t>> all;
  for (std::size_t j = 0; j < v.dimension(); ++j)
    all[classes(v.coordinates[j])].push_back(j);
  std::vector<std::vector<std::size_t>> lists;
  for (auto& [name, list] : all)
    lists.push_back(std::move(list));
  return lists;
}

} // namespace

std::vector<std::vector<Equation>> parts_at_rest(const VectorField& v, const Budget& budget) {
  const Classes classes = classes_of(v);
  const auto parts = members(v, classes);
  std::vector<std::vector<Equation>> all;
  if (parts.size() < 2) return all;
  for (const auto& part : parts)
    tried<InvalidArgument, DomainError>([&] { // too many rests, or none that is defined
      for (auto& place : Part(v, part, classes).rests(budget))
        all.push_back(std::move(place));
    });
  return all;
}

} // namespace kov
