// The sets that are open after a round: where equations hold the system is a special one, and all
// is done again.

#include "classify/board.hpp"
#include "classify/darboux_points.hpp"
#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/share.hpp"
#include "exact/tried.hpp"
#include "integrability/parameters.hpp"
#include "integrability/specialise.hpp"
#include "study/curve.hpp"

#include <algorithm>
#include <utility>

namespace kov {
namespace {

constexpr double part_to_compare = 0.05; // of the work that is left: two systems, for integrals
constexpr double part_along_a_curve = 0.1;

std::vector<Undecided> cut_along(const Round& round, const Undecided& piece,
                                 const std::vector<MPoly>& equations) {
  const CutParts cut = split(piece.where, {.zero = equations}, may_vanish(round.system));
  std::vector<Undecided> parts;
  for (const auto* sets : {&cut.inside, &cut.outside})
    for (const Set& set : *sets)
      parts.push_back(piece.on(set));
  return parts;
}

// Sets of parameters with solutions of their own are studied by themselves.
std::vector<Undecided> cut_where_there_is_more(const Round& round) {
  std::vector<Undecided> all = round.pieces;
  for (const std::vector<MPoly>& equations : round.special) {
    std::vector<Undecided> parts;
    for (Undecided& piece : all)
      try {
        auto cut = cut_along(round, piece, equations);
        std::move(cut.begin(), cut.end(), std::back_inserter(parts));
      } catch (const OutOfBudget& limit) { // left whole
        note(piece, "special solutions", limit.what());
        parts.push_back(std::move(piece));
      }
    all = std::move(parts);
  }
  return all;
}

std::vector<Undecided> by_factors(const Round& round, const Undecided& piece) {
  std::vector<Undecided> parts;
  for (const Set& set : kov::by_factors(piece.where, may_vanish(round.system)))
    parts.push_back(piece.on(set));
  return parts;
}

Substitution solved_parameters(const System& s, const Set& where) {
  const auto& all = s.field.parameters;
  Substitution values;
  for (const auto& [i, value] : solve(where).values)
    if (is_among(i, all)) values[i] = value;
  return values;
}

// Errors  DomainError: something has no value there
std::optional<Round> in_parameters(const Round& round, const Undecided& piece) {
  const Substitution solved = solved_parameters(round.system, piece.where);
  if (solved.empty()) return std::nullopt;
  const Substitution values = with_functions(round.system, solved);
  System special = kov::at_values(round.system, values);
  for (const MPoly& p : piece.where.inequations())
    if (MFraction f = substitute(p, values); !is_constant(f))
      special.assumptions.push_back({Sign::nonzero, std::move(f)});
  auto claims = kov::at_values(round.claims, values);
  auto levels = at_values(round.levels, values, claims);
  return Round{{std::move(special), std::move(claims), std::move(levels)}, piece};
}

// A special Hamiltonian may have another form, and integrals of another one.
bool looks_at_the_same(const Board& b, const System& s, const System& special) {
  IntegralOptions options;
  options.degree = b.options.degree;
  options.budget = part_of_the_work(b.budget(), part_to_compare);
  try {
    return searched_class(s, options) == searched_class(special, options);
  } catch (const InvalidArgument&) { // nothing can be looked at
    return true;
  }
}

std::vector<Exclusion> along_the_curve(const Board& b, const Round& round, const ManifoldSpec& m) {
  CheckOptions check = b.options.check;
  check.decide.budget = part_of_the_work(b.budget(), part_along_a_curve);
  check.along_the_curve = true;
  const KnownSystem& known = round.studied();
  auto all = exclusions(known.system, study_curve(known.system, m, known.claims, check),
                        level_parameters(known.system));
  for (Exclusion& e : all) {
    e.along = round.before(m);
    e = round.before(std::move(e));
  }
  return all;
}

void again(Board& b, const Round& round, Undecided piece);

// Rules that exclude rational first integrals only, or those near curves at which Darboux's have
// logarithms, come after all others.
void leave_open_at_last(Board& b, const Round& round, Undecided piece) {
  Round last = round;
  last.pieces = {std::move(piece)};
  const std::size_t equations = last.pieces.front().where.equations().size();
  const auto exclude_all = [&](const std::vector<Exclusion>& all) {
    for (const Exclusion& e : all)
      exclude(b, last, e);
  };
  try {
    if (b.options.search_solutions)
      exclude_all(exclusions_by_multiple_points_of_parts(round.system));
    if (!round.system.field.poisson)
      for (const ManifoldSpec& m : round.solutions)
        if (!last.pieces.empty()) exclude_all(along_the_curve(b, round, m));
  } catch (const OutOfBudget& limit) {
    note(last, "near a curve", limit.what());
  }
  for (const Undecided& left : last.pieces)
    for (Undecided& part : met(b, round, left)) {
      const bool is_smaller = part.where.equations().size() > equations;
      is_smaller ? again(b, round, std::move(part)) : b.open.push_back(std::move(part));
    }
}

bool is_whole(const Round& round, const Undecided& piece) {
  return piece.where.equations().size() == round.whole.where.equations().size();
}

// With the work that is left when all special values have had theirs.
void once_more(Board& b, const Round& round, Undecided piece) {
  if (round.only_special_values && !is_whole(round, piece)) { // no stage has looked at it
    b.waiting.push_back({{round.system, round.claims, round.levels}, std::move(piece)});
    return;
  }
  if (!round.limited || round.last) return leave_open_at_last(b, round, std::move(piece));
  Round next{{round.system, round.claims, round.levels}, std::move(piece)};
  next.integrals_known = round.integrals_known;
  next.last = true;
  next.cut = round.cut;
  b.later.push_back(std::move(next));
}

// Integrals are known where the search before has looked at the same functions.
bool has_known_integrals(const Board& b, const Round& round, const Undecided& piece,
                         const Round& next) {
  const auto& unless = round.integrals_unless;
  return round.integrals_known && next.system.field.poisson &&
         std::ranges::all_of(unless, [&](const MPoly& p) { return piece.where.is_nonzero(p); }) &&
         looks_at_the_same(b, round.system, next.system);
}

// The next attempt on a piece, or the reason why there is none.
struct Next {
  std::vector<Undecided> parts;
  std::optional<Round> special;
  std::string why_not, at = "equations between the parameters";
};
Next next_on(const Board& b, const Round& round, const Undecided& piece) {
  Next next;
  try {
    next.parts = by_factors(round, piece);
    if (next.parts.size() > 1) return next;
    b.budget().check();
    next.special = in_parameters(round, piece);
    if (next.special)
      next.special->integrals_known = has_known_integrals(b, round, piece, *next.special);
    return next;
  } catch (const DomainError& e) {
    return {{}, {}, e.what()};
  } catch (const OutOfBudget& e) {
    if (is_over(b.budget()) && !b.ended.empty()) return {{}, {}, e.what(), b.ended};
    return {{}, {}, e.what()};
  }
}

void again(Board& b, const Round& round, Undecided piece) {
  if (is_outside_of_the_domain(round.system, piece.where) ||
      is_ruled_out_by_an_order(b, piece.where))
    return;
  Next next = next_on(b, round, piece);
  if (next.parts.size() > 1) {
    for (Undecided& part : next.parts)
      again(b, round, std::move(part));
  } else if (!next.why_not.empty()) {
    note(piece, next.at, next.why_not);
    b.open.push_back(std::move(piece));
  } else if (next.special) {
    if (!follows_another(b, piece)) b.waiting.push_back(*std::move(next.special));
  } else {
    once_more(b, round, std::move(piece));
  }
}

} // namespace

std::vector<KnownLevel> at_values(std::vector<KnownLevel> levels, const Substitution& values,
                                  const std::vector<ClaimReport>& claims) {
  std::erase_if(levels,
                [&](const KnownLevel& l) { return l.claim && !claims[*l.claim].result.proved; });
  for (KnownLevel& l : levels)
    l.integral = substitute(l.integral, values);
  return levels;
}

void go_on(Board& b, const Round& round) {
  const std::size_t later = b.waiting.size();
  for (Undecided& piece : cut_where_there_is_more(round))
    again(b, round, std::move(piece));
  std::reverse(b.waiting.begin() + static_cast<long>(later), b.waiting.end()); // the first is next
}

std::optional<Round> in_solved_parameters(const Round& round, const Undecided& piece) {
  // else the constant stays
  return tried<DomainError, OutOfBudget>([&] { return in_parameters(round, piece); });
}

} // namespace kov
