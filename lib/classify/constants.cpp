#include "classify/constants.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/share.hpp"
#include "exact/variables.hpp"
#include "integrability/eigenvalue.hpp"
#include "integrability/parameters.hpp"

#include <algorithm>
#include <utility>

namespace kov {
namespace {

constexpr double part_of_a_search = 0.1; // of the work that is left: three searches at most

ParticularSolutions solutions_of(const Board& b, const KnownSystem& known) {
  return particular_solutions(known.system, known.levels, b.options.search_solutions,
                              part_of_the_work(b.budget(), part_of_a_search));
}

void move_to(System system, KnownSystem& known) {
  known.claims = claims_of(system, std::move(known.claims));
  for (KnownLevel& l : known.levels)
    l.integral = transfer(l.integral, system.ring());
  known.system = std::move(system);
}

// Adjoins a square root of d if that leads to more solutions.
bool adjoin_square_root(const Board& b, KnownSystem& known, const MPoly& d,
                        ParticularSolutions& solutions) {
  KnownSystem larger = known;
  move_to(with_square_root(known.system, d, ""), larger);
  auto more = solutions_of(b, larger);
  const std::size_t constant = larger.system.field.constants.back();
  const auto needs_it = [&](const ManifoldSpec& m) {
    return std::ranges::any_of(m.equations,
                               [&](const Equation& e) { return uses(e.difference, constant); });
  };
  if (std::ranges::none_of(more.manifolds, needs_it)) return false;
  known = std::move(larger);
  solutions = std::move(more);
  return true;
}

bool are_the_same(const ManifoldSpec& a, const ManifoldSpec& b) {
  return std::ranges::equal(a.equations, b.equations, [](const Equation& x, const Equation& y) {
    return x.difference == transfer(y.difference, x.difference.ring());
  });
}

// Keeps the manifolds of the file, and those that have changed: the others are found again.
void keep_new_or_stated(std::vector<ManifoldSpec>& all, const std::vector<ManifoldSpec>& before,
                        std::size_t stated) {
  for (std::size_t k = all.size(); k-- > stated;)
    if (are_the_same(all[k], before[k])) all.erase(all.begin() + static_cast<long>(k));
}

} // namespace

std::optional<KnownSystem> with_constants(const Board& b) {
  KnownSystem known = b.known;
  if (!may_have_large_blocks(known.system)) return std::nullopt;
  ParticularSolutions solutions = solutions_of(b, known);
  for (const MPoly& d : solutions.wanted)
    if (adjoin_square_root(b, known, d, solutions)) break;
  System with_solutions = known.system;
  with_solutions.manifolds = solutions.manifolds;
  CheckOptions check = b.options.check;
  check.decide.budget = part_of_the_work(b.budget(), part_of_a_search);
  System found = with_eigenvalues(std::move(with_solutions), check);
  if (found.adjoined.empty()) return std::nullopt;
  keep_new_or_stated(found.manifolds, solutions.manifolds, known.system.manifolds.size());
  move_to(std::move(found), known);
  return known;
}

namespace {

// In another ring that has the names of its own.
ClassifiedStratum within(const Set& all, ClassifiedStratum x) {
  const auto move = [&](MFraction& f) { f = transfer(f, all.ring()); };
  x.where = x.where.within(all);
  for (auto& row : x.field_components)
    std::ranges::for_each(row, move);
  for (FoundIntegral& f : x.integrals) {
    move(f.value);
    for (LogarithmicTerm& t : f.logarithms)
      t = {transfer(t.times, all.ring()), transfer(MFraction(t.of), all.ring()).num()};
  }
  return x;
}

} // namespace

bool go_on_with(Board& b, KnownSystem larger) {
  SystemClassification result = b.result;
  result.relations.clear();
  result.nonzero.clear();
  std::vector<Round> rounds;
  try {
    const Set all =
        all_parameters(larger.system, level_parameters(larger.system), b.budget().stop, result);
    for (ClassifiedStratum& x : result.strata)
      x = within(all, std::move(x));
    for (const Undecided& p : b.open) {
      Round round{larger, {p.where.within(all), p.tried}};
      if (round.whole.where.is_empty()) continue;
      if (auto solved = in_solved_parameters(round, round.whole)) round = *std::move(solved);
      rounds.push_back(std::move(round));
    }
  } catch (const OutOfBudget& limit) {
    b.result.notes.push_back({ClassificationNote::What::constants, limit.what()});
    return false;
  }
  b.result = std::move(result);
  b.known = std::move(larger);
  b.open.clear();
  std::ranges::reverse(rounds); // the first is next
  b.waiting = std::move(rounds);
  return true;
}

namespace {

bool is_written_in(const SystemClassification& c, const ClassifiedStratum& x,
                   std::size_t constant) {
  const auto& named = x.constants;
  if (is_among(constant, named)) return true;
  try {
    if (any_uses(proper_equations(x.where, c.relations), constant) ||
        any_uses(inequations(x.where), constant))
      return true;
  } catch (const OutOfBudget&) {
    return true;
  }
  return std::ranges::any_of(x.where.statements(), [&](const Statement& d) {
    return any_uses(squares_of(d.says), constant);
  });
}

} // namespace

void forget_unused_constants(const System& s, SystemClassification& c) {
  const auto constants = adjoined_constants(s);
  for (std::size_t k = 0; k < constants.size(); ++k)
    if (std::ranges::none_of(c.strata, [&](const ClassifiedStratum& x) {
          return is_written_in(c, x, constants[k]);
        }))
      std::erase(c.constants, s.adjoined[k]);
}

} // namespace kov
