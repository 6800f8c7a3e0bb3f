#include "classify/take_integrals.hpp"

#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"
#include "integrability/specialise.hpp"
#include "system/relations.hpp"

#include <algorithm>

namespace kov {
namespace {

std::vector<FoundIntegral> integrals_of(Board& b, const System& s, const IntegralsOfSet& set) {
  if (set.only_declared_relations) add_sentence(b.result.assumptions, only_declared_relations);
  if (!s.field.poisson) return set.integrals;
  std::vector<FoundIntegral> integrals;
  for (const std::size_t i : set.commuting)
    integrals.push_back(set.integrals[i]);
  return integrals;
}

std::vector<std::string> fields_of(const System& s, const IntegralsOfSet& set) {
  return mapped<std::string>(set.fields, [&](const auto& y) { return field_text(s.field, y); });
}

// The stratum of the set with these integrals.
ClassifiedStratum stratum(Board& b, const Round& round, Set where, const IntegralsOfSet& set) {
  const System& s = round.system;
  ClassifiedStratum x{std::move(where), StratumStatus::integrable, integrals_of(b, s, set),
                      fields_of(s, set), set.fields};
  for (const std::size_t c : adjoined_constants(s)) {
    const auto in_it = [&](const MFraction& f) { return uses(f, c); };
    const bool is_in_integrals = std::ranges::any_of(x.integrals, [&](const FoundIntegral& f) {
      return uses(f.value, c) || !f.logarithms.empty();
    });
    const bool is_in_fields = std::ranges::any_of(
        set.fields, [&](const auto& y) { return std::ranges::any_of(y, in_it); });
    if (is_in_integrals || is_in_fields) x.constants.push_back(c);
  }
  return x;
}

bool meets_integrable(const Board& b, const Round& round, const Exclusion& where) {
  const auto& strata = b.result.strata;
  return std::any_of(strata.begin() + static_cast<long>(round.decided), strata.end(),
                     [&](const ClassifiedStratum& x) {
                       return x.status == StratumStatus::integrable &&
                              !split(x.where, where, may_vanish(round.system)).inside.empty();
                     });
}

// The whole set, as it was found: no excluded stratum meets it.  Where a search before has found
// integrals on some of it, only what is left.
void integrable(Board& b, const Round& round, const IntegralsOfSet& set, const Exclusion& where) {
  const auto add = [&](const Undecided& piece) {
    for (Set& inside : split(piece.where, where, may_vanish(round.system)).inside)
      b.result.strata.push_back(stratum(b, round, std::move(inside), set));
  };
  if (!has_logarithms(set.integrals) && !meets_integrable(b, round, where)) return add(round.whole);
  for (const Undecided& piece : round.pieces)
    add(piece);
}

} // namespace

void keep_integrals(const System& s, const IntegralsOfSet& set, Undecided& piece) {
  const auto constants = adjoined_constants(s);
  std::vector<FoundIntegral> all;
  std::ranges::copy_if(set.integrals, std::back_inserter(all), [&](const FoundIntegral& f) {
    return !f.hamiltonian && f.logarithms.empty() && !uses_any(f.value, constants);
  });
  if (all.size() > piece.integrals.size()) piece.integrals = std::move(all);
}

bool is_enough(const System& s, const IntegralsOfSet& set) { return set.integrable(s.field); }

void common_equations_first(const System& s, std::vector<IntegralsOfSet>& sets) {
  const auto frequency = [&](const MPoly& p) {
    return std::ranges::count_if(sets, [&](const IntegralsOfSet& set) {
      const auto& all = set.equations;
      return is_enough(s, set) && is_among(p, all);
    });
  };
  for (IntegralsOfSet& set : sets) {
    auto sorted = set.equations;
    std::ranges::stable_sort(
        sorted, [&](const MPoly& p, const MPoly& q) { return frequency(p) > frequency(q); });
    set.equations = std::move(sorted);
  }
}

// At special values where the relations fall apart the integrals may depend on one another.
Exclusion conditions_of(const System& s, const IntegralsOfSet& set,
                        const std::vector<MPoly>& not_covered) {
  Exclusion where;
  where.zero = set.equations;
  for (const auto* list : {&set.inequations, &not_covered})
    for (const MPoly& p : *list)
      where.not_all_zero.push_back({p});
  try {
    if (auto special = where_relations_fall_apart(s.field); !special.empty())
      where.not_all_zero.push_back(std::move(special));
  } catch (const OutOfBudget&) {
    where.not_all_zero.emplace_back(); // they may be special everywhere: nothing is concluded
  }
  return where;
}

void take_integrals(Board& b, Round& round, const IntegralsOfSet& set,
                    const std::vector<MPoly>& not_covered, std::vector<Undecided>& met) {
  const Exclusion where = conditions_of(round.system, set, not_covered);
  const bool enough = is_enough(round.system, set);
  if (enough) {
    contradict_nothing(b, round, where, set);
    integrable(b, round, set, where);
  }
  std::vector<Undecided> left;
  for (Undecided& piece : round.pieces)
    try {
      std::vector<Undecided> inside, outside;
      CutParts parts = split(piece.where, where, may_vanish(round.system));
      for (Set& set_inside : parts.inside)
        if (!enough) {
          inside.push_back(piece.on(std::move(set_inside)));
          note(inside.back(), "first integrals", searched_text(set));
          keep_integrals(round.system, set, inside.back());
        }
      for (Set& set_outside : parts.outside)
        outside.push_back(piece.on(std::move(set_outside)));
      std::move(inside.begin(), inside.end(), std::back_inserter(met));
      std::move(outside.begin(), outside.end(), std::back_inserter(left));
    } catch (const OutOfBudget& limit) { // it stays whole
      note(piece, "first integrals", limit.what());
      met.push_back(std::move(piece));
    }
  round.pieces = std::move(left);
}

void take_elsewhere(Board& b, Round& round, const IntegralsOfSet& set,
                    const std::vector<MPoly>& not_covered) {
  std::vector<Undecided> left;
  for (Undecided& piece : round.pieces) {
    const bool covered =
        std::ranges::all_of(not_covered, [&](const MPoly& p) { return piece.where.is_nonzero(p); });
    if (covered && is_enough(round.system, set)) {
      b.result.strata.push_back(stratum(b, round, std::move(piece.where), set));
      continue;
    }
    if (covered) note(piece, "first integrals", searched_text(set));
    left.push_back(std::move(piece));
  }
  round.pieces = std::move(left);
}

std::string searched_text(const IntegralsOfSet& set) {
  std::string known = joined(set.integrals, [&](const FoundIntegral& f) {
    return f.hamiltonian          ? std::string("H")
           : f.logarithms.empty() ? brief(f.value, 60)
                                  : to_string(f);
  });
  const std::string text = set.searched + ": ";
  const std::string others =
      known.empty() ? "none found" : "none found beside functions of " + known;
  if (!set.open.empty()) return text + others + " (" + set.open + ")";
  return text + others +
         (set.complete_for_smooth || set.complete ? ", and there is none of this kind" : "");
}

} // namespace kov
