#include "integrability/one_level.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"
#include "integrability/parameters.hpp"

#include <algorithm>

namespace kov {
namespace {

using Conditions = std::vector<Condition>;
using strata::Stratum;

// "c h + d > 0": a half-line for all values of the other parameters.
bool is_half_line(const Assumption& a, std::size_t h) {
  return a.is_ordered() && is_constant(MFraction(a.value.den())) && degree(a.value.num(), h) == 1 &&
         is_constant(MFraction(coefficients(a.value.num(), h)[1]));
}

// p(h, ...) > 0 in levels alone, for all parameters the same.
bool is_open(const Assumption& a, const std::vector<std::size_t>& levels) {
  const auto used = used_variables(a.value);
  return a.is(Sign::positive) && !used.empty() &&
         std::ranges::all_of(used, [&](std::size_t i) { return is_among(i, levels); });
}

// Some numbers for the levels from `k` on satisfy all of these: then an open set does.
bool have_a_point(const std::vector<MFraction>& positive, const std::vector<std::size_t>& levels,
                  std::size_t k = 0) {
  if (std::ranges::any_of(positive, [](const MFraction& f) {
        return is_zero(f) || (is_constant(f) && sign(to_rational(f)) < 0);
      }))
    return false;
  if (k == levels.size()) return true;
  constexpr std::pair<long, long> numbers[] = {{1, 2}, {1, 1}, {-1, 2}, {-1, 1},
                                               {2, 1}, {5, 1}, {-3, 1}};
  for (const auto& [n, d] : numbers)
    try {
      const MFraction x(positive.front().ring(), Rational(Integer(n), Integer(d)));
      std::vector<MFraction> there;
      for (const MFraction& f : positive)
        there.push_back(substitute(f, {{levels[k], x}}));
      if (have_a_point(there, levels, k + 1)) return true;
    } catch (const DomainError&) {
      continue; // a denominator is 0
    }
  return false;
}

// The levels in strict inequalities that only levels satisfy, and that have a point.
std::vector<std::size_t> levels_of_an_open_set(const System& s,
                                               const std::vector<std::size_t>& levels) {
  constexpr std::size_t most = 3;
  std::vector<MFraction> positive;
  std::vector<std::size_t> all;
  for (const Assumption& a : s.assumptions) {
    if (!is_open(a, levels)) continue;
    positive.push_back(a.value);
    add_each_once(all, used_variables(a.value));
  }
  return !positive.empty() && all.size() <= most && have_a_point(positive, all)
             ? all
             : std::vector<std::size_t>{};
}

bool is_dense(const System& s, const std::vector<std::size_t>& levels,
              const std::vector<std::size_t>& in_open_set, std::size_t h) {
  std::vector<const Assumption*> all;
  for (const Assumption& a : s.assumptions)
    if (uses(a.value, h) && !a.is(Sign::nonzero) && !a.is(Sort::real)) all.push_back(&a);
  if (all.empty()) return true;
  if (is_among(h, in_open_set) &&
      std::ranges::all_of(all, [&](const auto* a) { return is_open(*a, levels); }))
    return true;
  const auto used = used_variables(all.front()->value);
  const bool alone =
      std::ranges::none_of(used, [&](std::size_t i) { return i != h && is_among(i, levels); });
  return all.size() == 1 && alone && is_half_line(*all.front(), h);
}

/// The strata of one answer at chosen levels.
class ChoiceOfLevels {
public:
  ChoiceOfLevels(const System& s, const strata::StrataAnswer& answer)
      : s_(s), answer_(answer), levels_(free_levels(s)), known_(of_the_others()),
        region_(s.ring(), known_) {}

  std::optional<std::vector<LevelChoice>> operator()() {
    std::vector<Substitution> choices{{}}; // general levels
    for (const Stratum& x : answer_.strata)
      if (x.leaf.abelian == Truth::no)
        if (auto at = choice(x); at && !is_among(*at, choices)) choices.push_back(*std::move(at));
    for (const Substitution& at : choices)
      if (is_enough({at})) return std::vector<LevelChoice>{values(at)};
    if (choices.size() == 1 || !is_enough(choices)) return std::nullopt;
    for (std::size_t k = choices.size(); k-- > 0;) {
      auto fewer = choices;
      fewer.erase(fewer.begin() + static_cast<long>(k));
      if (is_enough(fewer)) choices = std::move(fewer);
    }
    return mapped<LevelChoice>(choices, [&](const Substitution& at) { return values(at); });
  }

private:
  static constexpr int most_questions = 300;

  [[nodiscard]] Assumptions of_the_others() const {
    System others = s_;
    for (const std::size_t h : levels_)
      forget_assumptions(h, others);
    return assumptions_on(others, s_.ring());
  }

  [[nodiscard]] MFraction here(const MFraction& f, const Substitution& at = {}) const {
    if (is_zero(f)) return MFraction(s_.ring());
    return substitute(transfer(f, s_.ring()), at);
  }
  [[nodiscard]] bool uses_level(const MFraction& f) const {
    return std::ranges::any_of(levels_, [&](std::size_t h) { return !is_zero(f) && uses(f, h); });
  }
  [[nodiscard]] bool is_nonzero(const MPoly& p) const {
    return !is_zero(p) && (is_constant(p) || region_.implies_nonzero(p));
  }
  // The coefficients of f by the powers of the levels: f is 0 for general levels where all of these
  // are.
  [[nodiscard]] std::vector<MPoly> parts(const MFraction& f) const {
    if (is_zero(f)) return {};
    return nonzero_coefficients(f.num(), levels_);
  }

  // The levels that the equations of a stratum give as functions of the other parameters.
  [[nodiscard]] std::optional<Substitution> choice(const Stratum& x) const {
    Substitution at;
    for (const auto& [i, value] : x.solved) {
      const std::string& name = answer_.question->r.ring()->name(i);
      const auto h = s_.ring()->find(name);
      if (!h || !is_among(*h, levels_)) continue;
      at[*h] = here(value);
      if (uses_level(at[*h]) || !is_nonzero(at[*h].den())) return std::nullopt;
    }
    if (at.empty() || !is_admitted(at)) return std::nullopt;
    return at;
  }
  // Do the assumptions about these levels hold there?
  [[nodiscard]] bool is_admitted(const Substitution& at) const {
    return std::ranges::all_of(s_.assumptions, [&](const Assumption& a) {
      if (std::ranges::none_of(at, [&](const auto& x) { return uses(a.value, x.first); }))
        return true;
      const MFraction there = substitute(a.value, at);
      if (uses_level(there)) return false;
      const auto used = used_variables(there);
      if (a.is(Sort::real))
        return std::ranges::all_of(used, [&](std::size_t i) { return region_.is_real(i); });
      if (is_zero(there)) return a.is(Sign::nonnegative);
      if (a.is(Sign::nonzero)) return is_nonzero(there.num());
      return a.is_ordered() &&
             region_.exact_sign_of(there.num()) * region_.exact_sign_of(there.den()) > 0;
    });
  }

  // Conditions on the other parameters that the stratum needs there; unset: it is not met.
  [[nodiscard]] std::optional<Conditions> met(const Stratum& x, const Substitution& at) const {
    Conditions all;
    for (const Condition& c : x.conditions) {
      const auto in_levels = parts(here(MFraction(c.p), at));
      if (c.sign == Sign::zero) {
        for (const MPoly& p : in_levels) {
          if (is_nonzero(p)) return std::nullopt;
          all.push_back({p, Sign::zero});
        }
      } else if (c.sign == Sign::nonzero) {
        if (in_levels.empty()) return std::nullopt;
        if (in_levels.size() == 1 && !is_constant(in_levels[0]))
          all.push_back({in_levels[0], Sign::nonzero});
      }
    }
    return all;
  }
  [[nodiscard]] bool is_everywhere(const Stratum& x, const Substitution& at) const {
    return std::ranges::all_of(x.conditions, [&](const Condition& c) {
      const auto in_levels = parts(here(MFraction(c.p), at));
      if (c.sign == Sign::zero) return in_levels.empty();
      return c.sign == Sign::nonzero &&
             std::ranges::any_of(in_levels, [&](const MPoly& p) { return is_nonzero(p); });
    });
  }

  // For all other parameters one of these levels is not abelian.
  [[nodiscard]] bool is_enough(const std::vector<Substitution>& choices) {
    for (const Substitution& at : choices)
      if (std::ranges::any_of(answer_.strata, [&](const Stratum& x) {
            return x.leaf.abelian == Truth::no && is_everywhere(x, at);
          }))
        return true;
    if (!answer_.unvisited.empty()) return false;
    std::vector<std::vector<Conditions>> left;
    for (const Substitution& at : choices) {
      left.emplace_back();
      for (const Stratum& x : answer_.strata)
        if (x.leaf.abelian != Truth::no)
          if (auto where = met(x, at)) left.back().push_back(*std::move(where));
    }
    questions_ = 0;
    return is_empty(left, 0, known_);
  }
  // No parameters are left by all of these levels.
  [[nodiscard]] bool is_empty(const std::vector<std::vector<Conditions>>& left, std::size_t k,
                              const Assumptions& where) {
    if (++questions_ > most_questions) return false;
    if (k > 0 && ParametrisedSet(s_.ring(), where).is_empty_exactly()) return true;
    return k < left.size() && std::ranges::all_of(left[k], [&](const Conditions& more) {
             Assumptions both = where;
             both.conditions.insert(both.conditions.end(), more.begin(), more.end());
             return is_empty(left, k + 1, both);
           });
  }

  [[nodiscard]] LevelChoice values(const Substitution& at) const {
    LevelChoice all;
    for (const auto& [h, value] : at)
      all.push_back({s_.ring()->name(h), to_string(value)});
    return all;
  }

  const System& s_;
  const strata::StrataAnswer& answer_;
  std::vector<std::size_t> levels_;
  Assumptions known_; ///< of the other parameters
  ParametrisedSet region_;
  int questions_ = 0;
};

} // namespace

std::vector<std::size_t> free_levels(const System& s) {
  const auto levels = level_parameters(s);
  const auto open = levels_of_an_open_set(s, levels);
  std::vector<std::size_t> free;
  for (const std::size_t h : levels)
    if (is_dense(s, levels, open, h)) free.push_back(h);
  return free;
}

std::optional<std::vector<LevelChoice>> level_that_decides(const System& s,
                                                           const strata::StrataAnswer& answer) {
  if (answer.strata.empty()) return std::nullopt;
  return ChoiceOfLevels(s, answer)();
}

} // namespace kov
