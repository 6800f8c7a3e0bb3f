#include "study/pieces.hpp"

#include "exact/error.hpp"
#include "exact/ideal.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "exact/variables.hpp"
#include "integrability/parameters.hpp"

#include <algorithm>
#include <map>
#include <memory>

namespace kov {
namespace {

constexpr std::size_t most_pieces = 200; // of one round of solutions
constexpr double set_work = 1e6;         // in the ideals of sets of parameters

// told: as an assumption, if it is none of the file.
void keep_nonzero(const MPoly& p, const std::string& told, Set& all, SystemClassification& c) {
  for (const MFactor& f : factor(p).second)
    c.nonzero.push_back(f.base);
  all = all.where_nonzero(p);
  add_sentence(c.assumptions, told);
}

ClassifiedStratum stratum(Set where, const Exclusion& e) {
  return {.where = std::move(where),
          .status = StratumStatus::excluded,
          .by = {e.by},
          .constants = e.constants,
          .along = e.along,
          .from = e.from,
          .splitting = e.splitting};
}

void exclude(const Undecided& piece, const Exclusion& e, const MayVanish& possible,
             std::vector<Undecided>& left, SystemClassification& c) {
  CutParts parts = split(piece.where, e, possible);
  if (parts.inside.empty()) return left.push_back(piece);
  for (Set& outside : parts.outside)
    left.push_back(piece.on(std::move(outside)));
  for (Set& inside : parts.inside)
    c.strata.push_back(stratum(std::move(inside), e));
}

} // namespace

void add_sentence(std::vector<std::string>& all, const std::string& one) {
  if (!one.empty()) add_once(all, one);
}

void note(Undecided& piece, const std::string& what, const std::string& outcome) {
  std::erase_if(piece.tried, [&](const Tried& a) { return a.what == what; });
  piece.tried.push_back({what, outcome});
}

SystemClassification nothing_known(const System& s) {
  SystemClassification c;
  c.liouville = s.field.poisson.has_value();
  return c;
}

// A number that is not 0, by the equations of the algebraic constants.
static bool is_number_but_0(const System& s, const MPoly& p, const std::vector<MPoly>& relations,
                            const Budget& budget) {
  std::vector<MPoly> all{p};
  for (const MPoly& r : relations)
    if (uses_only(r, s.field.constants)) all.push_back(r);
  return uses_only(p, s.field.constants) &&
         Ideal(s.ring(), s.field.constants, all, {}, budget).contains(MPoly(s.ring(), Integer(1)));
}

Set all_parameters(const System& s, const std::vector<std::size_t>& levels,
                   const std::stop_token& stop, SystemClassification& told) {
  std::vector<std::size_t> parameters = s.field.constants;
  for (const std::size_t i : s.field.parameters)
    if (!is_among(i, levels)) parameters.push_back(i);
  Budget budget;
  budget.max_work = set_work;
  budget.stop = stop;
  Set all(s.ring(), parameters, budget);
  const auto in_parameters = [&](const MPoly& p) { return uses_only(p, parameters); };
  for (const MPoly& p : s.field.relations)
    if (in_parameters(p)) {
      all = all.where_zero(p);
      told.relations.push_back(p);
    }
  told.known = assumptions_on(s, s.ring());
  for (const Assumption& a : s.assumptions) {
    if (!in_parameters(a.value.num()) || !in_parameters(a.value.den())) continue; // of a level
    if (a.is(Sign::zero)) all = all.where_zero(a.value.num());
    if (a.is_nonzero()) keep_nonzero(a.value.num(), "", all, told);
    keep_nonzero(a.value.den(), "", all, told);
  }
  for (const MPoly& p : s.domain.nonzero())
    if (in_parameters(p) && !all.is_nonzero(p)) {
      const bool is_known =
          sign_that_follows(s, p) != 0 || is_number_but_0(s, p, told.relations, budget);
      keep_nonzero(p, is_known ? "" : to_string(p) + " != 0", all, told);
    }
  for (const auto& list : s.domain.lists())
    if (list.size() > 1 &&
        std::ranges::none_of(list, [&](const MPoly& p) { return all.is_nonzero(p); }))
      add_sentence(told.assumptions, in_words(list));
  if (all.is_empty() || contradicts_itself(s))
    throw InvalidArgument("no parameter value satisfies the relations and assumptions");
  return all;
}

MayVanish may_vanish(const System& s) {
  struct Less {
    bool operator()(const MPoly& f, const MPoly& g) const { return compare(f, g) < 0; }
  };
  const auto known = std::make_shared<std::map<MPoly, bool, Less>>();
  return [&s, known](const MPoly& p) {
    const auto at = known->find(p);
    if (at != known->end()) return at->second;
    return known->emplace(p, !not_excluded(s, {p}).empty()).first->second;
  };
}

bool exclude(std::vector<Undecided>& pieces, const Exclusion& e, const System& s,
             SystemClassification& c) {
  bool done = true;
  const MayVanish possible = may_vanish(s);
  std::vector<Undecided> left;
  for (Undecided& piece : pieces) {
    const bool room = left.size() <= most_pieces;
    if (room && tried<OutOfBudget>([&] { exclude(piece, e, possible, left, c); })) continue;
    left.push_back(std::move(piece));
    done = done && !room;
  }
  pieces = std::move(left);
  return done;
}

namespace {

// Attempts with the same outcome together, in the order in which the first of them were made.
std::vector<std::string> in_words(const std::vector<Tried>& tried) {
  constexpr std::size_t most_named = 4;
  std::vector<std::string> all;
  std::vector<bool> done(tried.size());
  for (std::size_t i = 0; i < tried.size(); ++i) {
    if (done[i]) continue;
    std::string text = tried[i].what;
    std::size_t same = 1;
    for (std::size_t k = i + 1; k < tried.size() && !tried[i].outcome.empty(); ++k) {
      if (tried[k].outcome != tried[i].outcome) continue;
      done[k] = true;
      if (++same <= most_named) text += "; " + tried[k].what;
    }
    if (same > most_named) text += "; and " + std::to_string(same - most_named) + " more";
    all.push_back(text + (tried[i].outcome.empty() ? "" : ": " + tried[i].outcome));
  }
  return all;
}

} // namespace

void leave_open(Undecided piece, SystemClassification& c) {
  ClassifiedStratum x{std::move(piece.where), StratumStatus::open, std::move(piece.integrals)};
  x.open_after = in_words(piece.tried);
  c.strata.push_back(std::move(x));
}

bool is_outside_of_the_domain(const System& s, const Set& where) {
  try {
    return s.domain.excludes([&](const MPoly& p) {
      const auto used = used_variables(p);
      const auto& own = where.parameters();
      return std::ranges::all_of(used, [&](std::size_t i) { return is_among(i, own); }) &&
             where.vanishes(p);
    });
  } catch (const OutOfBudget&) {
    return false; // it stays, and nothing is proved of it
  }
}

void finish(const System& s, SystemClassification& c) {
  std::erase_if(c.strata,
                [&](const ClassifiedStratum& x) { return is_outside_of_the_domain(s, x.where); });
  for (const Assumption& a : s.assumptions)
    add_sentence(c.assumptions, a.text);
  for (const std::string& constant : s.adjoined)
    add_sentence(c.constants, constant);
  for (const ClassifiedStratum& x : c.strata)
    for (const ExclusionReason& o : x.by) {
      c.excluded.push_back(o.integrals);
      add_each_once(c.theorems, o.theorems);
      add_sentence(c.assumptions, o.unchecked);
      add_each_once(c.trusted, o.trusted);
    }
  c.excluded = at_once(c.excluded);
  const auto rank = [](const ClassifiedStratum& x) { return static_cast<int>(x.status); };
  std::ranges::stable_sort(c.strata,
                           [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
}

} // namespace kov
