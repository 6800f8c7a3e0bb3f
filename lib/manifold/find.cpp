#include "manifold/find.hpp"

#include "exact/error.hpp"
#include "exact/finite_algebra.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"
#include "manifold/directions.hpp"
#include "manifold/lines.hpp"
#include "manifold/rests.hpp"
#include "manifold/subspace.hpp"

#include <algorithm>
#include <functional>
#include <random>
#include <set>

namespace kov {
namespace {

/// Coordinates and function symbols with their derivatives: one polynomial system for the searches.
struct Extended {
  std::vector<std::size_t> variables;
  std::vector<MFraction> components;
};

Extended extend(const VectorField& v) {
  Extended x{v.coordinates, v.components};
  for (const auto& f : v.functions) {
    x.variables.push_back(f.variable);
    x.components.push_back(lie_derivative(v, MFraction::variable(v.ring, f.variable)));
  }
  return x;
}

Equation zero_equation(const Ring& ring, std::size_t i) {
  return {MFraction::variable(ring, i), ring->name(i) + " = 0"};
}

std::vector<std::uint32_t> masks(const MPoly& f, const std::vector<std::size_t>& variables) {
  std::set<std::uint32_t> all;
  for (long t = 0; t < f.length(); ++t) {
    const auto e = f.exponents(t);
    std::uint32_t mask = 0;
    for (std::size_t i = 0; i < variables.size(); ++i)
      if (e[variables[i]] > 0) mask |= std::uint32_t{1} << i;
    all.insert(mask);
  }
  return {all.begin(), all.end()};
}

constexpr std::size_t most_for_subspaces = 16;  // 2^n subsets
constexpr std::size_t most_for_involutions = 8; // about n! / (n/2)! pairings with signs
constexpr std::size_t most_for_all_involutions = 6;
constexpr std::size_t most_candidates = 50000;
constexpr std::size_t most_intersections = 24;

void require_few(const char* what, std::size_t n, std::size_t most) {
  if (n > most)
    throw OutOfBudget(std::string(what) + " are looked for among at most " + std::to_string(most) +
                      " variables, here are " + std::to_string(n));
}

std::vector<FoundManifold> coordinate_subspaces(const VectorField& v, const Extended& x,
                                                const Budget& budget) {
  std::vector<FoundManifold> found;
  const std::size_t n = x.variables.size();
  require_few("coordinate subspaces", n, most_for_subspaces);
  std::vector<std::vector<std::uint32_t>> num, den;
  for (const auto& c : x.components) {
    num.push_back(masks(c.num(), x.variables));
    den.push_back(is_zero(c) ? std::vector<std::uint32_t>{0} : masks(c.den(), x.variables));
  }
  for (std::uint32_t set = 1; set + 1 < (std::uint32_t{1} << n); ++set) {
    if (set % 1024 == 0) budget.check();
    bool invariant = true;
    for (std::size_t i = 0; i < n && invariant; ++i) {
      const auto meets = [&](std::uint32_t m) { return (m & set) != 0; };
      if ((set >> i & 1U) != 0 && !std::ranges::all_of(num[i], meets)) invariant = false;
      if (std::ranges::all_of(den[i], meets)) invariant = false; // not defined there
    }
    if (!invariant) continue;
    FoundManifold m;
    m.kind = "coordinate subspace";
    for (std::size_t i = 0; i < n; ++i)
      if ((set >> i & 1U) != 0) m.equations.push_back(zero_equation(v.ring, x.variables[i]));
    found.push_back(std::move(m));
  }
  return found;
}

/// Sets {x_i = c_i, i in S} with some c_i != 0: values are added until every X_i, i in S, vanishes.
/// If one does not, a factor of degree 1 in one more coordinate, and otherwise in parameters,
/// gives the next value.
class ShiftedSubspaces {
public:
  ShiftedSubspaces(const VectorField& v, const Budget& budget) : v_(v), budget_(budget) {}

  std::vector<FoundManifold> run() {
    if (!v_.functions.empty()) return {}; // what they are at the values is not known
    for (const std::size_t i : v_.coordinates)
      extend({{i, MFraction(v_.ring)}});
    for (const MFraction& c : v_.components)
      for (const Substitution& value : roots(c))
        extend(value);
    return std::move(found_);
  }

private:
  // Values of one coordinate at which f vanishes, whatever the others are.
  [[nodiscard]] std::vector<Substitution> roots(const MFraction& f) const {
    std::vector<Substitution> all;
    if (is_zero(f)) return all;
    for (const auto& [base, power] : factor(f.num()).second)
      for (const std::size_t i : v_.coordinates) {
        const auto c = coefficients(base, i);
        const bool linear = c.size() == 2 && is_constant(c[0]) && used_variables(c[1]).empty();
        if (linear) all.push_back({{i, MFraction(-c[0], c[1])}});
      }
    return all;
  }
  [[nodiscard]] bool is_constant(const MPoly& f) const { return !uses_any(f, v_.coordinates); }

  void extend(const Substitution& values) {
    budget_.check();
    if (values.size() >= v_.dimension() || seen_.size() >= most_tried ||
        !seen_.insert(text(values)).second)
      return;
    const auto left = first_that_moves(values);
    if (!left) return;
    if (is_zero(*left)) return add(values);
    for (const Substitution& more : roots(*left)) {
      Substitution longer = values;
      longer.insert(more.begin(), more.end());
      extend(longer);
    }
  }

  // X_i at the values, i in S, that is not 0 there; 0: all are.  Unset: a pole.
  [[nodiscard]] std::optional<MFraction> first_that_moves(const Substitution& values) const {
    try {
      for (std::size_t j = 0; j < v_.dimension(); ++j)
        if (values.count(v_.coordinates[j]))
          if (MFraction f = substitute(v_.components[j], values); !is_zero(f)) return f;
      return MFraction(v_.ring);
    } catch (const DomainError&) {
      return std::nullopt;
    }
  }

  [[nodiscard]] std::string text(const Substitution& values) const {
    std::string all;
    for (const auto& [i, c] : values)
      all += v_.ring->name(i) + " = " + to_string(c) + ";";
    return all;
  }

  void add(const Substitution& values) {
    FoundManifold m;
    m.kind = "coordinates at constant values";
    bool shifted = false;
    for (const auto& [i, c] : values) {
      shifted = shifted || !is_zero(c);
      m.equations.push_back(
          {MFraction::variable(v_.ring, i) - c, v_.ring->name(i) + " = " + to_string(c)});
    }
    if (shifted) found_.push_back(std::move(m));
  }

  static constexpr std::size_t most_tried = 500;
  const VectorField& v_;
  const Budget& budget_;
  std::set<std::string> seen_;
  std::vector<FoundManifold> found_;
};

// u = exp(a·q): the vector a, if its entries are constants of the field.
std::optional<std::vector<MFraction>> exponent(const VectorField& v, const FunctionSymbol& u) {
  std::vector<MFraction> a;
  for (const MFraction& slope : u.gradient) {
    a.push_back(slope / MFraction::variable(v.ring, u.variable));
    for (const std::size_t i : used_variables(a.back()))
      if (!is_among(i, v.parameters)) return std::nullopt;
  }
  return a;
}

/// sigma(x)_j = sign_j x_pi(j), an involution.  For exponentials the sign -1 means 1/x_pi(j), as a
/// reflection of the coordinates does it.
struct Involution {
  std::vector<std::size_t> image;
  std::vector<int> sign;
};

using MayMap = std::function<bool(std::size_t, std::size_t)>; ///< x_j to +-x_k

void involutions(std::size_t j, Involution& s, const MayMap& may_map,
                 std::vector<Involution>& all) {
  const std::size_t n = s.image.size();
  while (j < n && s.sign[j] != 0)
    ++j;
  if (all.size() == most_candidates)
    throw OutOfBudget("too many involutions would have to be tried");
  if (j == n) {
    all.push_back(s);
    return;
  }
  for (const int e : {1, -1}) {
    s.image[j] = j;
    s.sign[j] = e;
    if (may_map(j, j)) involutions(j + 1, s, may_map, all);
    for (std::size_t k = j + 1; k < n; ++k) {
      if (s.sign[k] != 0 || !may_map(j, k) || !may_map(k, j)) continue;
      s.image[j] = k;
      s.image[k] = j;
      s.sign[j] = s.sign[k] = e;
      involutions(j + 1, s, may_map, all);
      s.sign[k] = 0;
    }
    s.sign[j] = 0;
  }
}

// Which of the variables are exponentials of linear forms in the coordinates.
std::vector<bool> exponentials(const VectorField& v, const Extended& x) {
  std::vector<bool> all(x.variables.size(), false);
  for (std::size_t j = v.coordinates.size(); j < all.size(); ++j)
    all[j] = exponent(v, v.functions[j - v.coordinates.size()]).has_value();
  return all;
}

std::vector<Involution> involutions(std::size_t n) {
  Involution s{std::vector<std::size_t>(n), std::vector<int>(n, 0)};
  std::vector<Involution> all;
  involutions(
      0, s, [](std::size_t, std::size_t) { return true; }, all);
  return all;
}

// The same on coordinates and momenta.
Involution twice(const Involution& a) {
  Involution s = a;
  for (const std::size_t j : a.image)
    s.image.push_back(j + a.image.size());
  s.sign.insert(s.sign.end(), a.sign.begin(), a.sign.end());
  return s;
}

std::vector<Involution> of_coordinates(const VectorField& v) {
  const std::size_t n = v.coordinates.size();
  if (n <= most_for_all_involutions || n % 2 != 0) return involutions(n);
  return mapped<Involution>(involutions(n / 2), [&](const Involution& a) { return twice(a); });
}

// [i][j]: function i depends on coordinate j.
std::vector<std::vector<bool>> dependence(const VectorField& v) {
  std::vector<std::vector<bool>> all;
  for (const FunctionSymbol& f : v.functions) {
    all.emplace_back();
    for (const MFraction& slope : f.gradient)
      all.back().push_back(!is_zero(slope));
  }
  return all;
}

// On the coordinates it is a; a function of some of them goes to one of their images.
void add_continuations(const Involution& a, const std::vector<std::vector<bool>>& dependence,
                       std::vector<Involution>& all) {
  const std::size_t n = a.image.size();
  Involution s = a;
  s.image.resize(n + dependence.size());
  s.sign.resize(n + dependence.size(), 0);
  const MayMap may_map = [&](std::size_t j, std::size_t k) {
    if (j < n || k < n) return j < n && k < n;
    for (std::size_t i = 0; i < n; ++i)
      if (dependence[j - n][i] != dependence[k - n][a.image[i]]) return false;
    return true;
  };
  involutions(n, s, may_map, all);
}

// Few variables: all signed permutations.  More: those that permute coordinates; more than six: those
// that act alike on coordinates and momenta.
std::vector<Involution> candidates(const VectorField& v, const Extended& x) {
  if (x.variables.size() <= most_for_all_involutions) return involutions(x.variables.size());
  const std::size_t n = v.coordinates.size();
  if (n > most_for_involutions && (n % 2 != 0 || n / 2 > most_for_involutions))
    require_few("fixed sets of involutions", n, most_for_involutions);
  const auto depends = dependence(v);
  std::vector<Involution> all;
  for (const Involution& a : of_coordinates(v))
    add_continuations(a, depends, all);
  return all;
}

/// The values of the components at a point modulo a prime; unset when a denominator vanishes.
class ModularField {
public:
  ModularField(const VectorField& v, const Extended& x) : x_(&x), point_(v.ring->size()) {
    nmod_init(&mod_, 2147483629UL);
    std::mt19937_64 generator(20240501);
    for (auto& c : point_)
      c = 1 + generator() % (mod_.n - 1);
    is_exponential_ = exponentials(v, x);
  }
  [[nodiscard]] std::optional<std::vector<ulong>> at(const Involution& s) const {
    std::vector<ulong> p(point_);
    for (std::size_t j = 0; j < s.image.size(); ++j) {
      const ulong c = point_[x_->variables[s.image[j]]];
      p[x_->variables[j]] = s.sign[j] > 0        ? c
                            : is_exponential_[j] ? nmod_inv(c, mod_)
                                                 : nmod_neg(c, mod_);
    }
    std::vector<ulong> values;
    for (const auto& f : x_->components) {
      if (is_zero(f)) {
        values.push_back(0);
        continue;
      }
      const ulong d = evaluate(f.den(), p);
      if (d == 0) return std::nullopt;
      values.push_back(nmod_div(evaluate(f.num(), p), d, mod_));
    }
    return values;
  }
  [[nodiscard]] bool respects(const Involution& s, const std::vector<ulong>& here) const {
    const auto there = at(s);
    if (!there) return false;
    for (std::size_t j = 0; j < s.image.size(); ++j) {
      const ulong c = here[s.image[j]];
      if ((*there)[j] != (s.sign[j] > 0 ? c : reflected(c, j, s.image[j]))) return false;
    }
    return true;
  }

private:
  // The derivative of -x_k, or of 1/x_k, where that of x_k is c.
  [[nodiscard]] ulong reflected(ulong c, std::size_t j, std::size_t k) const {
    if (!is_exponential_[j]) return nmod_neg(c, mod_);
    const ulong inverse = nmod_inv(point_[x_->variables[k]], mod_);
    return nmod_neg(nmod_mul(c, nmod_mul(inverse, inverse, mod_), mod_), mod_);
  }
  [[nodiscard]] ulong evaluate(const MPoly& f, const std::vector<ulong>& p) const {
    return fmpz_mpoly_evaluate_all_nmod(f.raw(), p.data(), f.ctx(), mod_);
  }
  const Extended* x_;
  std::vector<ulong> point_;
  std::vector<bool> is_exponential_;
  nmod_t mod_{};
};

// x_j = sigma(x)_j, j the smaller of two that are exchanged.
Equation fixed_equation(const VectorField& v, const Extended& x, const Involution& s, std::size_t j,
                        bool is_exponential) {
  const std::size_t k = s.image[j];
  const MFraction a = MFraction::variable(v.ring, x.variables[j]);
  const MFraction b = MFraction::variable(v.ring, x.variables[k]);
  const std::string from = v.ring->name(x.variables[j]);
  const std::string to = v.ring->name(x.variables[k]);
  if (s.sign[j] > 0) return {a - b, from + " = " + to};
  if (!is_exponential) return {a + b, from + " = -" + to};
  const MFraction one(v.ring, Rational(1)); // of a^2 = 1 the part a = 1
  return j == k ? Equation{a - one, from + " = 1"}
                : Equation{a * b - one, from + "*" + to + " = 1"};
}

std::optional<FoundManifold> fixed_set(const VectorField& v, const Extended& x,
                                       const Involution& s) {
  FoundManifold m;
  std::string moved;
  bool swaps = false;
  const auto is_exponential = exponentials(v, x);
  for (std::size_t j = 0; j < s.image.size(); ++j) {
    const std::size_t k = s.image[j];
    if (k == j && s.sign[j] > 0) continue;
    const std::string image = (s.sign[j] > 0       ? ""
                               : is_exponential[j] ? "1/"
                                                   : "-") +
                              v.ring->name(x.variables[k]);
    moved += (moved.empty() ? "" : ", ") + v.ring->name(x.variables[j]) + " -> " + image;
    if (k == j && !is_exponential[j]) {
      m.equations.push_back(zero_equation(v.ring, x.variables[j]));
      continue;
    }
    swaps = true;
    if (k >= j) m.equations.push_back(fixed_equation(v, x, s, j, is_exponential[j]));
  }
  if (m.equations.empty() || !swaps) return std::nullopt; // sign changes give coordinate subspaces
  m.kind = "fixed points of " + moved;
  return m;
}

std::vector<FoundManifold> fixed_sets(const VectorField& v, const Extended& x,
                                      const Budget& budget) {
  std::vector<FoundManifold> found;
  const std::size_t n = x.variables.size();
  const std::vector<Involution> all = candidates(v, x);
  const ModularField field(v, x);
  Involution identity{std::vector<std::size_t>(n), std::vector<int>(n, 1)};
  for (std::size_t j = 0; j < n; ++j)
    identity.image[j] = j;
  const auto here = field.at(identity);
  if (!here) return found;
  for (const auto& candidate : all) { // a filter only: what passes is proved below
    budget.check();
    if (field.respects(candidate, *here))
      if (auto m = fixed_set(v, x, candidate)) found.push_back(*std::move(m));
  }
  return found;
}

// "q2 = 2*q1 + a, p2 = 2*p1"
FoundManifold on_line(const VectorField& v, const Line& line) {
  const std::size_t i = line.dependent, free = 1 - i;
  const auto x = [&](std::size_t j) { return MFraction::variable(v.ring, v.coordinates[j]); };
  FoundManifold m;
  m.kind = (i == 1 ? "line of slope " + to_string(line.slope) : "line of constant " + v.name(0)) +
           (is_zero(line.offset) ? "" : " off the origin");
  for (const auto& [j, value] : {std::pair(i, line.slope * x(free) + line.offset),
                                 std::pair(i + 2, line.ratio * x(free + 2))})
    m.equations.push_back({x(j) - value, v.name(j) + " = " + to_string(value)});
  return m;
}

// exp(a·q) and exp(b·q) in a constant ratio: (a - b)·q' = 0, and the ratio is such that this stays.
std::optional<FoundManifold> constant_ratio(const VectorField& v, const FunctionSymbol& f,
                                            const FunctionSymbol& g) {
  const auto a = exponent(v, f);
  const auto b = exponent(v, g);
  if (!a || !b) return std::nullopt;
  MFraction speed(v.ring);
  for (std::size_t j = 0; j < v.dimension(); ++j)
    speed += ((*a)[j] - (*b)[j]) * v.components[j];
  const MFraction force = lie_derivative(v, speed);
  const MFraction by_f = derivative(force, f.variable);
  const MFraction by_g = derivative(force, g.variable);
  if (is_zero(speed) || is_zero(by_f) || is_zero(by_g)) return std::nullopt;
  const MFraction x = MFraction::variable(v.ring, f.variable);
  const MFraction y = MFraction::variable(v.ring, g.variable);
  if (!is_zero(force - by_f * x - by_g * y)) return std::nullopt;
  const MFraction ratio = -(by_f / by_g);
  if (used_variables(speed.num()).empty() || uses(ratio, f.variable) || uses(ratio, g.variable))
    return std::nullopt;
  FoundManifold m;
  m.kind = "exponentials in a constant ratio";
  m.equations = {{MFraction(speed.num()), to_string(speed.num()) + " = 0"},
                 {y - ratio * x, v.ring->name(g.variable) + " = " + to_string(ratio * x)}};
  return m;
}

std::vector<FoundManifold> constant_ratios(const VectorField& v) {
  std::vector<FoundManifold> found;
  for (std::size_t i = 0; i < v.functions.size(); ++i)
    for (std::size_t j = i + 1; j < v.functions.size(); ++j)
      if (auto m = constant_ratio(v, v.functions[i], v.functions[j]))
        found.push_back(*std::move(m));
  return found;
}

// Integrals that are independent on the set: the rank of their gradients along it grows with each at
// one point with random rational coordinates (not more than the rank, and almost always the rank).
std::vector<std::size_t> independent_integrals(const VectorField& v,
                                               const std::vector<MFraction>& integrals,
                                               const Substitution& solved) {
  std::mt19937 generator(7);
  std::uniform_int_distribution<int> number(2, 97);
  Substitution point;
  for (std::size_t i = 0; i < v.ring->size(); ++i)
    point[i] = MFraction(v.ring, Rational(number(generator), 3));
  Matrix rows;
  std::vector<std::size_t> independent;
  for (std::size_t k = 0; k < integrals.size(); ++k) {
    try {
      const MFraction g = substitute(integrals[k], solved);
      std::vector<MFraction> row;
      for (std::size_t j = 0; j < v.dimension(); ++j)
        row.push_back(solved.count(v.coordinates[j]) ? MFraction(v.ring)
                                                     : substitute(partial(v, g, j), point));
      rows.push_back(std::move(row));
      if (v.dimension() - null_space(rows, v.dimension(), v.ring).size() == rows.size())
        independent.push_back(k);
      else
        rows.pop_back();
    } catch (const DomainError&) {
      continue; // not defined on the set, or not at this point
    }
  }
  return independent;
}

bool is_constant_of(const VectorField& v, std::size_t i) {
  const auto in = [i](const std::vector<std::size_t>& all) { return is_among(i, all); };
  return in(v.parameters) || in(v.constants);
}

// The equations are x = c, x = c y or x y = 1; one that divides by 0 with the others is left out, the
// set being empty.
Substitution solve(const VectorField& v, const FoundManifold& m) {
  Substitution solved;
  for (const auto& e : m.equations)
    try {
      const MFraction f = substitute(e.difference, solved);
      if (is_zero(f)) continue;
      const auto used = used_variables(f);
      const auto first =
          std::ranges::find_if(used, [&](std::size_t i) { return !is_constant_of(v, i); });
      if (first == used.end()) continue;
      const std::size_t i = *first;
      const MFraction x = MFraction::variable(f.ring(), i);
      const Substitution step{{i, x - f / derivative(f, i)}};
      Substitution all = step;
      for (const auto& [j, value] : solved)
        all[j] = substitute(value, step);
      solved = std::move(all);
    } catch (const DomainError&) {
      continue;
    }
  return solved;
}

} // namespace

namespace {

// A coordinate that nothing contains, whether or not functions depend on it.
bool is_ignorable(const VectorField& v, const std::vector<MFraction>& integrals, std::size_t x) {
  return is_among(x, v.coordinates) && !any_uses(v.components, x) && !any_uses(integrals, x) &&
         std::ranges::none_of(v.functions,
                              [&](const FunctionSymbol& f) { return any_uses(f.gradient, x); }) &&
         !any_uses(v.relations, x);
}

// An equation between coordinates on which nothing depends: where a set with it is invariant, so is
// the larger one without it.
bool says_nothing(const VectorField& v, const std::vector<MFraction>& integrals,
                  const Equation& e) {
  const auto used = used_variables(e.difference);
  return !used.empty() && std::ranges::all_of(used, [&](std::size_t i) {
    return is_ignorable(v, integrals, i) || is_constant_of(v, i);
  });
}

/// Collects what is proved, and the limits that were met.
class Prover {
public:
  Prover(const VectorField& v, const std::vector<MFraction>& integrals, const Budget& budget)
      : v_(v), integrals_(integrals), budget_(budget) {}

  template <class Search> void look(Search search) {
    std::vector<FoundManifold> all;
    try {
      all = search();
    } catch (const OutOfBudget& limit) {
      result_.left_out.emplace_back(limit.what());
    }
    for (auto& m : all)
      try {
        prove(m);
      } catch (const OutOfBudget& limit) {
        result_.left_out.push_back(joined(m.equations, &Equation::text) + ": " + limit.what());
      }
  }
  FoundManifolds result() && { return std::move(result_); }

  // Lines in subspaces of two degrees of freedom.
  void look_inside(std::vector<MPoly>& wanted) {
    const auto subspaces = result_.proved;
    for (const FoundManifold& m : subspaces)
      if (m.dimension == 4 && !m.equilibria && v_.dimension() > 4)
        for (const FieldOnSubspace& there : fields_on_subspace(v_, solve(v_, m)))
          look([&] { return lines_inside(m, there, wanted); });
  }

  // Sets whose levels are not curves yet, two at a time, and again what comes out.
  void intersect() {
    for (std::size_t i = 1; i < result_.proved.size() && i < most_intersections; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const FoundManifold& a = result_.proved[i];
        const FoundManifold& b = result_.proved[j];
        if (a.equilibria || b.equilibria || a.leaf_dimension() <= 1 || b.leaf_dimension() <= 1)
          continue;
        look([&] { return std::vector<FoundManifold>{both(a, b)}; });
      }
  }

private:
  [[nodiscard]] std::vector<FoundManifold> lines_inside(const FoundManifold& m,
                                                        const FieldOnSubspace& there,
                                                        std::vector<MPoly>& wanted) const {
    const Lines lines = find_lines(there.field, budget_);
    wanted.insert(wanted.end(), lines.wanted.begin(), lines.wanted.end());
    std::vector<FoundManifold> all;
    for (const Line& line : lines.lines) {
      FoundManifold inside = on_line(there.field, line);
      for (const auto* more : {&m.equations, &there.roots})
        inside.equations.insert(inside.equations.end(), more->begin(), more->end());
      all.push_back(std::move(inside));
    }
    return all;
  }
  [[nodiscard]] FoundManifold both(const FoundManifold& a, const FoundManifold& b) const {
    FoundManifold m;
    m.kind = "intersection of two invariant sets";
    m.equations = a.equations;
    for (const Equation& e : b.equations) // those that say something new
      if (!is_zero(substitute(e.difference, solve(v_, m)))) m.equations.push_back(e);
    return m;
  }

  // Coordinates that the field does not contain, but an integral does: the energy of a system whose
  // time is a coordinate.
  [[nodiscard]] int coordinates_beside(const Ideal& ideal,
                                       const std::vector<std::size_t>& independent) const {
    const auto& main = ideal.main();
    return static_cast<int>(std::ranges::count_if(v_.coordinates, [&](std::size_t x) {
      return !is_among(x, main) && std::ranges::any_of(independent, [&](std::size_t k) {
        return uses(integrals_[k], x);
      });
    }));
  }

  void prove(FoundManifold& m) {
    budget_.check();
    std::erase_if(m.equations, [&](const Equation& e) { return says_nothing(v_, integrals_, e); });
    if (m.equations.empty()) return;
    auto generators = mapped<MPoly>(m.equations, [&](const auto& e) { return e.difference.num(); });
    const Ideal ideal = relation_ideal(v_, generators, {}, budget_);
    if (ideal.is_unit() || pole_along(v_, ideal) || invariance_failure(v_, m.equations, ideal))
      return;
    std::string key;
    for (const auto& g : ideal.basis())
      key += to_string(ideal.from_kpoly(g)) + ";";
    if (!seen_.insert(key).second) return;
    m.dimension = ideal.dimension();
    if (m.dimension == 0) return;
    m.equilibria = std::ranges::all_of(
        v_.components, [&](const MFraction& c) { return is_zero_modulo(c, ideal); });
    m.independent = independent_integrals(v_, integrals_, solve(v_, m));
    m.integrals = static_cast<int>(m.independent.size());
    m.dimension += coordinates_beside(ideal, m.independent);
    result_.proved.push_back(std::move(m));
  }

  const VectorField& v_;
  const std::vector<MFraction>& integrals_;
  const Budget& budget_;
  std::set<std::string> seen_;
  FoundManifolds result_;
};

} // namespace

std::string text_in_file(const Equation& e) {
  if (e.text.find('\'') == std::string::npos) return e.text;
  return to_string(MFraction(e.difference.num())) + " = 0";
}

FoundManifolds find_manifolds(const VectorField& v, const std::vector<MFraction>& integrals,
                              const Budget& budget) {
  const Extended x = extend(v);
  Prover prover(v, integrals, budget);
  prover.look([&] { return coordinate_subspaces(v, x, budget); });
  prover.look([&] { return fixed_sets(v, x, budget); });
  prover.look([&] {
    std::vector<FoundManifold> all;
    for (auto& equations : parts_at_rest(v, budget))
      all.push_back({std::move(equations), "a part at rest", 0, 0, {}, false});
    return all;
  });
  Lines lines;
  prover.look([&] {
    lines = find_lines(v, budget);
    std::vector<FoundManifold> all;
    for (const Line& line : lines.lines) // axes are coordinate subspaces
      if (!is_zero(line.slope) || !is_zero(line.offset) || !is_zero(line.ratio))
        all.push_back(on_line(v, line));
    return all;
  });
  std::vector<MPoly> wanted;
  if (v.dimension() > 4 || !v.functions.empty())
    prover.look([&] {
      const Directions directions = find_directions(v, integrals, budget);
      wanted = directions.wanted;
      std::vector<FoundManifold> all;
      for (const auto& equations : directions.lines)
        all.push_back({equations, "line through the origin", 0, 0, {}, false});
      return all;
    });
  prover.look_inside(wanted);
  prover.look([&] { return ShiftedSubspaces(v, budget).run(); });
  prover.look([&] { return constant_ratios(v); });
  prover.intersect();
  FoundManifolds found = std::move(prover).result();
  found.special = std::move(lines.special);
  found.wanted = std::move(wanted);
  auto& proved = found.proved;
  std::ranges::stable_sort(proved, [](const FoundManifold& a, const FoundManifold& b) {
    const auto rank = [](const FoundManifold& m) {
      return std::tuple(m.equilibria, m.leaf_dimension() != 1, -m.dimension);
    };
    return rank(a) < rank(b);
  });
  return found;
}

} // namespace kov
