#include "classify/board.hpp"

#include "classify/bounded.hpp"
#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "study/contradiction.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr std::size_t most_compared = 8; // integrable strata with one exclusion

// The same as contradict_nothing, where the integrals came first.
void contradict_no_integrals(const Board& b, const Round& round, const Exclusion& e) {
  const auto& strata = b.result.strata;
  std::size_t looked_at = 0;
  for (std::size_t i = round.decided; i < strata.size() && looked_at < most_compared; ++i) {
    const ClassifiedStratum& x = strata[i];
    if (x.status != StratumStatus::integrable || has_logarithms(x.integrals)) continue;
    ++looked_at;
    study::refuse_contradiction(round.system, e.by,
                                study::complete_integrals(round.system, x.integrals), x.where, e);
  }
}

// Less is excluded, for later: of "p and q both vanish" only p = 0 is kept, a larger set, which is
// studied again by itself.
Exclusion with_simple_exceptions(Exclusion e) {
  for (auto& list : e.not_all_zero)
    if (list.size() > 1)
      list = {*std::ranges::min_element(
          list, [](const MPoly& p, const MPoly& q) { return p.length() < q.length(); })};
  return e;
}

// The parts at the common values; where the denominators vanish nothing is concluded.
std::vector<Undecided> at_those_values(const Round& round, const Undecided& piece,
                                       const CommonValues& common, const MPoly& denominators) {
  const MayVanish possible = may_vanish(round.system);
  const CutParts parts = split(piece.where, {.zero = {denominators}}, possible);
  auto all = mapped<Undecided>(parts.inside, [&](const Set& special) { return piece.on(special); });
  for (const Set& where : parts.outside)
    for (const Rational& value : common.values) {
      const MFraction difference = common.square - MFraction(common.square.ring(), value);
      for (Set& there : split(where, {.zero = {difference.num()}}, possible).inside)
        all.push_back(piece.on(std::move(there)));
    }
  return all;
}

std::vector<Undecided> at_common_values(Board& b, const Round& round, const Undecided& piece) {
  const auto& all = piece.where.statements();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (const auto common = common_values(all[i], all[j])) {
        add_each_once(b.result.trusted, {{Trusted::Step::common_values}});
        return at_those_values(round, piece, *common,
                               squares_of(all[i].says).front().den() *
                                   squares_of(all[j].says).front().den());
      }
  if (const auto bounded = bounded_values(round.system, piece.where)) {
    add_each_once(b.result.trusted, bounded->trusted);
    MPoly denominators = bounded->values.square.den();
    for (const Statement& s : all)
      for (const MFraction& square : squares_of(s.says))
        denominators = denominators * square.den();
    return at_those_values(round, piece, bounded->values, squarefree_part(denominators));
  }
  return {piece};
}

} // namespace

ManifoldSpec Round::before(ManifoldSpec m) const {
  if (!at_scale) return m;
  const auto coordinates = system.field.coordinates;
  for (Equation& e : m.levels)
    for (const KnownLevel& there : at_scale->levels) {
      const MFraction value = there.integral - e.difference;
      const auto here = std::ranges::find(levels, there.level, &KnownLevel::level);
      const bool is_level = is_zero(value) || std::ranges::none_of(coordinates, [&](std::size_t i) {
                              return uses(value, i);
                            });
      if (here == levels.end() || !is_level) continue;
      e.difference = here->integral - value;
      break;
    }
  return m;
}

bool may_have_large_blocks(const System& s) { return s.field.dimension() >= 5; }
bool is_the_first(const Board& b, const Round& round) {
  return round.system.field.parameters.size() == b.known.system.field.parameters.size();
}
bool is_small(const Round& round) { return round.system.field.dimension() <= 4; }
bool is_at_numbers(const Round& round) {
  return round.system.field.parameters.size() <= round.levels.size();
}

std::vector<std::size_t> adjoined_constants(const System& s) {
  const auto& all = s.field.constants; // those that were adjoined are the last ones
  KOV_ENSURE(s.adjoined.size() <= all.size());
  return {all.end() - static_cast<long>(s.adjoined.size()), all.end()};
}

void note(Round& round, const std::string& what, const std::string& outcome) {
  for (Undecided& p : round.pieces)
    note(p, what, outcome);
}

void exclude(Board& b, Round& round, const Exclusion& e) {
  contradict_no_integrals(b, round, e);
  if (!exclude(round.pieces, e, round.system, b.result))
    round.late.push_back(with_simple_exceptions(e)); // nothing is concluded for now
}

void exclude_or_defer(Board& b, Round& round, Exclusion e) {
  if (std::ranges::any_of(e.statements,
                          [](const Statement& s) { return squares_of(s.says).size() > 1; }))
    round.late.push_back(std::move(e));
  else
    exclude(b, round, e);
}

bool has_logarithms(const std::vector<FoundIntegral>& integrals) {
  return std::ranges::any_of(integrals,
                             [](const FoundIntegral& f) { return !f.logarithms.empty(); });
}

void contradict_nothing(const Board& b, const Round& round, const Exclusion& where,
                        const IntegralsOfSet& set) {
  if (set.only_declared_relations) return;
  const auto integrals = study::complete_integrals(round.system, set.integrals);
  for (std::size_t i = round.decided; i < b.result.strata.size(); ++i) {
    const ClassifiedStratum& x = b.result.strata[i];
    if (x.status == StratumStatus::excluded)
      study::refuse_contradiction(round.system, x.by.front(), integrals, x.where, where);
  }
}

std::vector<Undecided> met(Board& b, const Round& round, const Undecided& piece) {
  try {
    return at_common_values(b, round, piece);
  } catch (const OutOfBudget&) { // it stays whole
    return {piece};
  }
}

} // namespace kov
