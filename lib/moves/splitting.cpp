#include "moves/splitting.hpp"

#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/linear.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "exact/variables.hpp"
#include "integrability/parameters.hpp"
#include "literature/literature.hpp"
#include "moves/scalings.hpp"
#include "splitting/families.hpp"
#include "splitting/hypotheses.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace kov {
namespace {

constexpr long largest_weight = 2;
constexpr std::size_t most_scalings = 3; // independent ones, of which combinations are tried
constexpr std::size_t most_candidates = 4;

using Row = std::vector<Rational>;

// Rows from which those columns are eliminated: a basis of the combinations that vanish there, reduced.
std::vector<Row> vanishing_at(std::vector<Row> rows, const std::vector<std::size_t>& columns,
                              const std::vector<std::size_t>& others) {
  const std::size_t used = row_reduce(rows, columns).size();
  rows.erase(rows.begin(), rows.begin() + static_cast<long>(used));
  rows.resize(row_reduce(rows, others).size());
  return rows;
}

// Weights >= 0 of parameters, 0 for the moments.
std::vector<Weights> scalings_that_keep_moments(const System& s, const FreeBody& body) {
  const std::vector<std::size_t> moments = used_by_any(body.moments);
  std::vector<std::size_t> others;
  for (const std::size_t p : s.field.parameters)
    if (!is_among(p, moments) && uses(*s.field.hamiltonian, p)) others.push_back(p);
  std::vector<Row> rows;
  for (const auto& weights : scalings(s)) {
    rows.emplace_back();
    for (const MFraction& w : weights)
      rows.back().push_back(is_zero(w) ? Rational(0) : to_rational(w));
  }
  rows = vanishing_at(std::move(rows), moments, others);
  rows.resize(std::min(rows.size(), most_scalings));
  std::vector<Weights> all;
  long combinations = 1;
  for (std::size_t k = 0; k < rows.size(); ++k)
    combinations *= largest_weight + 1;
  for (long n = 1; n < combinations; ++n) {
    Weights w;
    bool fits = true;
    for (const std::size_t p : others) {
      Rational sum(0);
      long digits = n;
      for (const Row& row : rows) {
        sum = sum + Rational(digits % (largest_weight + 1)) * row[p];
        digits /= largest_weight + 1;
      }
      fits = fits && is_integer(sum) && sign(sum) >= 0 && sum <= Rational(largest_weight);
      if (fits && !is_zero(sum)) w[p] = to_long(sum.num());
    }
    if (fits) all.push_back(std::move(w));
  }
  return all;
}

// The parameter with A = x or A = 1/x; -x where it is negative.
std::optional<std::size_t> parameter_of(const System& s, const MFraction& moment) {
  const auto used = used_variables(moment);
  if (used.size() != 1) return std::nullopt;
  const MFraction x =
      Rational(assumed_sign(s, used.front())) * MFraction::variable(moment.ring(), used.front());
  return moment == x || moment * x == MFraction(moment.ring(), Rational(1))
             ? std::optional(used.front())
             : std::nullopt;
}

/// The family under names that nobody else uses: x1 ... x6, and q0, q1, ... for the variables of its ring, or for their
/// opposites where they are negative.  A moment
/// that is not a parameter of its own (a number, or twice another one) is made one, y1, y2 or y3: what holds for all of
/// its values holds for that of the system.
class Renamed {
public:
  Renamed(const System& s, const FreeBody& body) : s_(s), body_(body) {
    std::vector<std::string> names{"x1", "x2", "x3", "x4", "x5", "x6"};
    place_.resize(s.ring()->size());
    for (std::size_t i = 0; i < place_.size(); ++i) {
      place_[i] = names.size();
      names.push_back("q" + std::to_string(i));
    }
    for (std::size_t k = 0; k < 6; ++k)
      place_[body.coordinates[k]] = k;
    first_moment_ = names.size();
    for (const char* name : {"y1", "y2", "y3"})
      names.emplace_back(name);
    ring_ = make_ring(names);
    hamiltonian_ = MFraction(moved(s.field.hamiltonian->num()), moved(s.field.hamiltonian->den()));
    free_the_moments();
  }

  // The axis of the largest moment first.  An odd permutation is followed by x -> -x, and is a rotation
  // then.
  [[nodiscard]] EulerFamily family(const Weights& small,
                                   const std::array<std::size_t, 3>& axes) const {
    EulerFamily f{s_.title, hamiltonian_, {}, {}, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      f.coordinates[k] = axes[k];
      f.coordinates[k + 3] = axes[k] + 3;
    }
    const bool is_odd = (axes[1] + 3 - axes[0]) % 3 != 1;
    if (is_odd) {
      Substitution turned;
      for (std::size_t k = 0; k < 6; ++k)
        turned[k] = -MFraction::variable(ring_, k);
      f.hamiltonian = substitute(hamiltonian_, turned);
    }
    for (const auto& [p, weight] : small)
      f.small[place_[p]] = weight;
    for (const std::size_t p : s_.field.parameters)
      if (assumed_sign(s_, p) != 0) f.positive.push_back(ring_->name(place_[p]));
    for (std::size_t k = 0; k < 3; ++k)
      f.positive.push_back(ring_->name(first_moment_ + k));
    return f;
  }

  // Takes f from the ring of the conditions: A, B, C are the moments in that order.
  [[nodiscard]] MPoly before(const MPoly& f, const std::array<std::size_t, 3>& axes) const {
    MFraction sum(s_.ring());
    for (long t = 0; t < f.length(); ++t) {
      MFraction term(s_.ring(), Rational(f.coefficient(t)));
      const auto e = f.exponents(t);
      for (std::size_t i = 0; i < e.size(); ++i)
        if (e[i] > 0) term *= pow(value(f.ring()->name(i), axes), static_cast<long>(e[i]));
      sum += term;
    }
    return sum.num();
  }
  [[nodiscard]] std::size_t parameter(const std::string& name) const {
    return std::stoul(name.substr(1));
  }

private:
  void free_the_moments() {
    std::vector<std::size_t> own;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto p = parameter_of(s_, body_.moments[k]);
      if (p && !is_among(*p, own)) {
        own.push_back(*p);
        continue;
      }
      const MFraction m = body_.moments[k];
      const MFraction x = MFraction::variable(ring_, k);
      const MFraction inverse(moved(m.den()), moved(m.num()));
      const MFraction y = MFraction::variable(ring_, first_moment_ + k);
      hamiltonian_ += Rational(1, 2) * x * x * (MFraction(ring_, Rational(1)) / y - inverse);
    }
  }
  [[nodiscard]] MPoly moved(const MPoly& f) const {
    MPoly sum(ring_);
    for (long t = 0; t < f.length(); ++t) {
      const auto e = f.exponents(t);
      std::vector<unsigned long> there(ring_->size(), 0);
      bool opposite = false;
      for (std::size_t i = 0; i < e.size(); ++i) {
        there[place_[i]] = e[i];
        opposite = opposite != (e[i] % 2 != 0 && assumed_sign(s_, i) < 0);
      }
      sum += MPoly::term(ring_, opposite ? -f.coefficient(t) : f.coefficient(t), there);
    }
    return sum;
  }
  [[nodiscard]] MFraction value(const std::string& name,
                                const std::array<std::size_t, 3>& axes) const {
    const std::size_t moment = std::string("ABC").find(name);
    if (moment != std::string::npos) return body_.moments[axes[moment]];
    const MFraction x = MFraction::variable(s_.ring(), parameter(name));
    return assumed_sign(s_, parameter(name)) < 0 ? -x : x;
  }

  const System& s_;
  const FreeBody& body_;
  Ring ring_;
  std::vector<std::size_t> place_;
  MFraction hamiltonian_;
  std::size_t first_moment_ = 0;
};

struct Candidate {
  Weights small;
  EulerPerturbation perturbation;

  // Few terms; then little that is small besides.
  [[nodiscard]] auto size() const {
    long sum = 0;
    for (const auto& [p, weight] : small)
      sum += weight;
    return std::tuple(perturbation.first.num().length(), sum);
  }
};

constexpr std::array<std::size_t, 3> first_order{0, 1, 2};

std::vector<Candidate> candidates(const System& s, const FreeBody& body, const Renamed& there) {
  std::vector<Candidate> all;
  for (const Weights& small : scalings_that_keep_moments(s, body))
    tried<DomainError>([&] { // not where no free body is left, or no polynomial
      all.push_back({small, perturbation_of_euler(there.family(small, first_order))});
    });
  std::ranges::stable_sort(
      all, [](const Candidate& a, const Candidate& b) { return a.size() < b.size(); });
  all.resize(std::min(all.size(), most_candidates));
  return all;
}

// The larger moment of two, minus the smaller one, times something positive.
MPoly difference(const System& s, const FreeBody& body, std::size_t larger, std::size_t smaller) {
  const MFraction d = body.moments[larger] - body.moments[smaller];
  return sign_of_monomial(s, d.den()) < 0 ? -d.num() : d.num();
}

// No admitted parameters have their moments in this order, and satisfy the equations.
bool is_empty(const System& s, const FreeBody& body, const std::array<std::size_t, 3>& axes,
              const std::vector<MPoly>& equations, std::vector<Trusted>& trusted) {
  std::vector<Condition> all;
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    const MPoly d = difference(s, body, axes[k], axes[k + 1]);
    if (!is_constant(d))
      all.push_back({d, Sign::positive});
    else if (sign(d.coefficient(0)) < 0)
      return true;
  }
  for (const MPoly& f : equations)
    all.push_back({f, Sign::zero});
  const auto proof = refuted_over_the_reals(s, all);
  if (proof) add_each_once(trusted, *proof);
  return proof.has_value();
}

// The sets where all sums vanish; unset: an identity fails, or they vanish for all moments and directions.
std::optional<OrderOfMoments> order(const System& s, const Renamed& there,
                                    const std::array<std::size_t, 3>& axes, SplittingFinding& found,
                                    const Budget& budget) {
  const SplittingData d =
      splitting_data(perturbation_of_euler(there.family(found.small, axes)), budget);
  if (!all_hold(d.checks) || !all_hold(check_ziglin_hypotheses(d))) return std::nullopt;
  const VanishingConditions conditions = vanishing_conditions(d);
  OrderOfMoments result{axes, {}};
  for (const SplittingFamily& f : classify_families(conditions, budget).families) {
    std::vector<MPoly> equations;
    for (const std::string& name : f.zero)
      equations.push_back(MPoly::variable(s.ring(), there.parameter(name)));
    for (const MPoly& g : f.moments)
      equations.push_back(there.before(g, axes));
    if (f.direction) equations.push_back(there.before(*f.direction, axes));
    if (equations.empty()) return std::nullopt;
    if (!is_empty(s, found.body, axes, equations, found.trusted))
      result.left.push_back(std::move(equations));
  }
  for (const MPoly& f : conditions.nonzero)
    if (MPoly g = there.before(f, axes); !is_among(g, found.nonzero))
      found.nonzero.push_back(std::move(g));
  return result;
}

// Unset: for some order the criterion says nothing.
std::optional<SplittingFinding> finding(const System& s, const FreeBody& body, const Renamed& there,
                                        const Candidate& candidate, const Budget& budget) {
  SplittingFinding found{body, candidate.small, {}, candidate.perturbation.order, {}, {}};
  for (const auto& [name, value] : s.values)
    found.at.emplace_back(name, to_string(value));
  for (const std::string& name : candidate.perturbation.small)
    found.direction.push_back(there.parameter(name));
  auto axes = first_order;
  try {
    do {
      budget.check();
      if (is_empty(s, body, axes, {}, found.trusted)) continue;
      auto one = order(s, there, axes, found, budget);
      if (!one) return std::nullopt;
      found.orders.push_back(*std::move(one));
    } while (std::next_permutation(axes.begin(), axes.end()));
  } catch (const DomainError&) { // a parameter without a sign, or a root, is left
    return std::nullopt;
  }
  return found;
}

bool all_parameters_are_real(const System& s) {
  return std::ranges::all_of(s.field.parameters, [&](std::size_t p) {
    return !uses(*s.field.hamiltonian, p) || s.real.contains(s.ring()->name(p));
  });
}

} // namespace

std::optional<SplittingFinding> find_splitting(const System& s, const Budget& budget) {
  const auto body = free_body(s);
  if (!body || !all_parameters_are_real(s)) return std::nullopt;
  const Renamed there(s, *body);
  for (const Candidate& c : candidates(s, *body, there))
    if (auto found = finding(s, *body, there, c, budget); found && !found->orders.empty())
      return found;
  return std::nullopt;
}

Exclusion exclusion(const System& s, const SplittingFinding& found) {
  Exclusion e;
  e.splitting = std::make_shared<const SplittingFinding>(found);
  for (const auto& [i, j] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 2)})
    if (MPoly d =
            difference(s, found.body, static_cast<std::size_t>(i), static_cast<std::size_t>(j));
        !is_constant(d))
      e.not_all_zero.push_back({std::move(d)});
  for (const MPoly& f : found.nonzero)
    e.not_all_zero.push_back({f});
  e.not_all_zero.emplace_back();
  for (const std::size_t p : found.direction)
    e.not_all_zero.back().push_back(MPoly::variable(s.ring(), p));
  for (const OrderOfMoments& o : found.orders)
    std::ranges::copy(o.left, std::back_inserter(e.not_all_zero));
  const TheoremUsed theorem = used(ziglin_1980());
  e.by.solution = "the doubly asymptotic solutions of the free body";
  e.by.reason = "for small values of " +
                joined(found.direction, [&](std::size_t p) { return s.ring()->name(p); }) +
                " the separatrices of the free body split: a sum of residues is not 0; a change of "
                "scale makes all values small";
  e.by.integrals = theorem.integrals;
  e.by.theorems = {theorem.theorem};
  e.by.trusted = found.trusted;
  e.by.rule = Rule::splitting;
  e.by.trusted.push_back({Trusted::Step::residues});
  return e;
}

} // namespace kov
