// One question in one choice of variables: rounds of the strategy until nothing is open, or the work is
// done.

#include "classify/almost_all.hpp"
#include "classify/constants.hpp"
#include "classify/shares.hpp"
#include "classify/stage.hpp"
#include "classify/stages.hpp"
#include "classify/variables.hpp"
#include "decide/afterwards.hpp"
#include "exact/lists.hpp"
#include "exact/share.hpp"
#include "exact/tried.hpp"
#include "exact/variables.hpp"
#include "integrability/eigenvalue.hpp"
#include "integrability/parameters.hpp"
#include "moves/discrete.hpp"
#include "parameters/signs.hpp"

#include <algorithm>
#include <utility>

namespace kov {
namespace {

using Clock = Budget::Clock;

constexpr double integrals_before = 0.1; // of degree <= 2, for levels
constexpr double solutions_at_points = 0.1;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The budget of the whole is less for a while.
class WithPart {
public:
  WithPart(Board& b, double part) : budget_(b.options.check.decide.budget), whole_(budget_) {
    budget_ = part_of_the_work(whole_, part);
  }
  WithPart(const WithPart&) = delete;
  WithPart& operator=(const WithPart&) = delete;
  ~WithPart() { budget_ = whole_; }

private:
  Budget& budget_;
  Budget whole_;
};

// ---- the question

// Claims of the file are decided already; the others are decided here.
std::vector<ClaimReport> claims_of_all(const Board& b, const System& known) {
  std::vector<ClaimReport> all = b.stated.claims;
  for (std::size_t k = all.size(); k < known.claims.size(); ++k)
    all.push_back({known.claims[k], decide_claim(known, known.claims[k], b.budget())});
  return all;
}

// Assumptions of the file about a level say nothing of the system: any level will do.
System without_levels_fixed(Board& b, System s) {
  const auto levels = level_parameters(s);
  std::erase_if(s.assumptions, [&](const Assumption& a) {
    const bool of_a_level = uses_any(a.value, levels);
    if (of_a_level) {
      b.is_as_stated = false;
      using What = ClassificationNote::What;
      b.result.notes.push_back(
          {b.stated.all.empty() ? What::not_used : What::used_on_manifolds, a.text});
    }
    return of_a_level;
  });
  for (const std::size_t i : levels)
    forget_assumptions(i, s);
  for (ReduceSpec& r : s.reductions)
    r.energy.clear(); // all levels at once
  return s;
}

Board board_of(const System& s, const ClassifyOptions& options, const StatedSolutions& stated) {
  Board b{.options = options, .stated = stated};
  const bool search = options.search_solutions && !stated.decided;
  const System known =
      search ? with_found_integrals(s, part_of_the_work(b.budget(), integrals_before)) : s;
  LevelledSystem levelled = with_levels(known, claims_of_all(b, known));
  b.result = nothing_known(s);
  b.result.no_parameters = s.field.parameters.size() == level_parameters(s).size();
  b.is_as_stated = levelled.claims.size() == s.claims.size();
  b.known = {without_levels_fixed(b, std::move(levelled.system)), std::move(levelled.claims),
             std::move(levelled.levels)};
  return b;
}

// ---- one round

// Tells what is proved so far, with the rest open.
void tell(Board& b, const Round& round, const std::string& next) {
  SystemClassification now = b.result;
  now.at_work = next;
  now.complete = false;
  const auto open = [&](const std::vector<Undecided>& pieces) {
    for (const Undecided& piece : pieces)
      leave_open(piece, now);
  };
  open(b.open);
  open(round.pieces);
  for (const Follower& f : b.followers)
    leave_open(f.piece, now);
  for (const auto* rounds : {&b.waiting, &b.later})
    for (const Round& later : *rounds)
      leave_open(later.whole, now);
  finish(b.known.system, now);
  b.so_far = std::move(now);
  const Unmetered words;
  if (b.options.so_far) b.options.so_far(b.so_far);
}

// Tells what is known; false: the task is to be left out.
bool begins(Board& b, Round& round, const std::string& task) {
  std::string name = task;
  for (const MPoly& p : round.whole.where.equations())
    name += ", " + to_string(p) + " = 0";
  tell(b, round, name);
  const auto& skip = b.options.skip;
  if (!is_among(name, skip)) return true;
  note(round, name, "left out, as it did not end in time");
  return false;
}

// A part of the work of the round, as long as it has some; then of that of the whole.
Budget part_of_the_round(const Board& b, const Budget& of_the_round, double part) {
  return part_of_the_work(of_the_round.is_spent() ? b.budget() : of_the_round, part);
}

// The first task that a limit of the whole has stopped, or kept from beginning.
void note_the_end(Board& b, const Task& task) {
  if (is_over(b.budget()) && b.ended.empty()) b.ended = task.name;
}

// A limit is an attempt: what the task had begun to change is as it was.
void run(const Stage& stage, const Task& task, Board& b, Round& round, const Budget& budget) {
  const auto start = Clock::now();
  const double work = meter();
  const SystemClassification result = b.result;
  const Round before = round;
  try {
    stage.run(b, round, task, budget);
  } catch (const OutOfBudget& limit) {
    b.result = result;
    round = before;
    round.limited = true;
    note(round, task.name, limit.what());
    note_the_end(b, task);
  }
  b.result.spent.push_back({task.name, meter() - work, seconds_since(start)});
}

void study(Board& b, Round round) {
  round.decided = b.result.strata.size();
  const Budget budget =
      part_of_the_work(b.budget(), round.last || is_at_numbers(round) ? 1 : share::round);
  for (const Stage& stage : strategy()) {
    // special values are studied by themselves; what excludes the others is compared with integrals
    if (round.only_special_values && stage.run != stages::look_for_a_contradiction) continue;
    const std::vector<Task> tasks = stage.tasks(b, round);
    for (std::size_t i = 0; i < tasks.size() && (i == 0 || !round.pieces.empty()); ++i) {
      if (is_over(b.budget())) {
        note_the_end(b, tasks[i]);
        break;
      }
      if (stage.part > 0 && !begins(b, round, tasks[i].name)) continue;
      const double part = round.last ? stage.at_last : stage.part;
      run(stage, tasks[i], b, round,
          part_of_the_round(b, budget, part / static_cast<double>(tasks.size() - i)));
    }
    b.begun = true;
  }
  tell(b, round, "");
  go_on(b, round);
}

void study_all(Board& b) {
  while (!b.waiting.empty() || !b.later.empty() || !b.followers.empty()) {
    if (b.waiting.empty() && b.later.empty()) {
      settle_followers(b);
      continue;
    }
    auto& from = b.waiting.empty() ? b.later : b.waiting;
    Round next = std::move(from.back());
    from.pop_back();
    study(b, std::move(next));
  }
}

// ---- the theorem

void keep_what_was_proved(Board& b, const std::string& why) {
  b.result = std::move(b.so_far);
  b.result.at_work.clear();
  b.result.notes.push_back({ClassificationNote::What::rest_is_open, why});
}

std::optional<KnownSystem> constants_at_hand(const Board& b) {
  if (!b.options.adjoin_constants || b.stated.decided) return std::nullopt;
  return tried<OutOfBudget>([&] { return with_constants(b); }); // else without them
}

std::string limit_in_words(const Budget& budget) {
  try {
    budget.check();
    return {};
  } catch (const OutOfBudget& limit) {
    return limit.what();
  }
}

// Symmetries of the family: one set of each orbit is studied, and the others follow.
void find_symmetries(Board& b) {
  const System& s = b.known.system;
  if (s.field.parameters.size() < b.known.levels.size() + 2) return;
  try {
    for (const FamilySymmetry& y :
         family_symmetries(s, part_of_the_work(b.budget(), share::symmetries))) {
      const auto is_known = [&](const Equivalence& e) { return e.parameters == y.parameters; };
      if (!y.parameters.empty() && keeps_assumptions(s, y) &&
          std::ranges::none_of(b.symmetries, is_known))
        b.symmetries.push_back(equivalence(s, y));
    }
  } catch (const OutOfBudget&) { // then each set is studied
    b.symmetries.clear();
  }
}

// The whole set, then what is left of it with algebraic constants that its solutions ask for.
void study_whole(Board& b) {
  Round first{
      b.known,
      {all_parameters(b.known.system, level_parameters(b.known.system), b.budget().stop, b.result),
       {}}};
  const std::optional<KnownSystem> larger = constants_at_hand(b);
  b.waiting.push_back(std::move(first));
  if (b.options.search_solutions) find_symmetries(b);
  {
    const WithPart less(b, larger ? share::without_constants : 1);
    study_all(b);
  }
  if (!larger || b.open.empty() || !go_on_with(b, *larger)) return;
  b.is_as_stated = false;
  b.ended.clear();
  study_all(b);
}

// b^2 + c^2 = 0, c != 0 with real parameters: an equation whose left side has a sign there.
void leave_out_sets_without_real_points(const System& s, SystemClassification& c) {
  const Assumptions known = assumptions_on(s, s.ring());
  if (known.real.empty() && known.conditions.empty()) return;
  std::erase_if(c.strata, [&](const ClassifiedStratum& x) {
    const SignProver signs(x.where.ring(), known.conditions, x.where.inequations(), known.real);
    const auto equations = x.where.equations();
    return std::ranges::any_of(equations, [&](const MPoly& f) { return signs.is_never_zero(f); });
  });
}

// If the work has ended before each set had its turn: integrals of low degree are found for all
// sets in one search, and what they cut is not open.
void look_for_integrals_once_more(Board& b) {
  Round round{
      b.known,
      {all_parameters(b.known.system, level_parameters(b.known.system), b.budget().stop, b.result),
       {}}};
  round.pieces = b.open;
  const SystemClassification before = b.result;
  try {
    stages::find_low_integrals(b, round, {}, b.budget());
    b.open = std::move(round.pieces);
  } catch (const OutOfBudget&) { // they stay open
    b.result = before;
  }
}

void finish(Board& b, const std::string& limit) {
  if (!b.open.empty() && !limit.empty())
    b.result.notes.push_back({ClassificationNote::What::rest_is_open, limit});
  for (Undecided& piece : b.open)
    leave_open(std::move(piece), b.result);
  leave_out_sets_without_real_points(b.known.system, b.result);
  std::erase_if(b.result.strata, [&](const ClassifiedStratum& x) {
    return x.status == StratumStatus::integrable && is_ruled_out_by_an_order(b, x.where);
  });
  finish(b.known.system, b.result);
  forget_unused_constants(b.known.system, b.result);
}

void study_within_limits(Board& b) {
  try {
    std::string limit;
    {
      const WithPart most(b, share::before_a_last_look);
      study_whole(b);
      limit = limit_in_words(b.budget());
    }
    if (!limit.empty() && !b.ended.empty()) limit += " in the stage '" + b.ended + "'";
    if (!b.open.empty() && !limit.empty()) look_for_integrals_once_more(b);
    finish(b, limit);
  } catch (const OutOfBudget& limit) {
    keep_what_was_proved(b, limit.what());
  } catch (const Contradiction&) {
    throw;
  } catch (const Error& error) {
    if (!decides_something(b.so_far)) throw;
    keep_what_was_proved(b, failure_of("the stage '" + b.so_far.at_work + "'", error.what()));
  }
}

// ---- almost all parameters, where nothing else can be said

bool is_open_in_general(const SystemClassification& c) {
  return std::ranges::any_of(c.strata, [&](const ClassifiedStratum& s) {
    return s.status == StratumStatus::open && s.where.is_algebraic() &&
           s.where.equations().size() <= c.relations.size();
  });
}

bool may_be_too_large(const KnownSystem& known) {
  return may_have_large_blocks(known.system) &&
         known.system.field.parameters.size() > known.levels.size();
}

void add_almost_all(Board& b) {
  const auto& [system, claims, levels] = b.known;
  const auto solutions = particular_solutions(system, levels, b.options.search_solutions,
                                              part_of_the_work(b.budget(), solutions_at_points));
  auto found =
      almost_all(system, solutions.manifolds, claims, level_parameters(system), b.options.check);
  if (!found) return;
  b.result.almost_all = std::move(found);
  const ExclusionReason& by = b.result.almost_all->by;
  add_each_once(b.result.theorems, by.theorems);
  add_each_once(b.result.trusted, by.trusted);
  add_sentence(b.result.assumptions, by.unchecked);
}

void study_almost_all(Board& b) {
  std::string missing;
  try {
    missing = failure_of("the matrices at a point", [&] { add_almost_all(b); });
  } catch (const OutOfBudget& limit) {
    missing = limit.what();
  }
  if (!missing.empty()) b.result.notes.push_back({ClassificationNote::What::almost_all, missing});
}

} // namespace

SystemClassification classify_in_these_variables(const System& s, const ClassifyOptions& options,
                                                 const StatedSolutions& stated) {
  const auto start = Clock::now();
  Board b = board_of(s, options, stated);
  const bool large = may_be_too_large(b.known);
  {
    const WithPart less(b, large ? share::all_but_points : 1);
    study_within_limits(b);
  }
  if (large && is_open_in_general(b.result) && !b.budget().is_spent()) study_almost_all(b);
  b.result.seconds = seconds_since(start);
  return std::move(b.result);
}

} // namespace kov
