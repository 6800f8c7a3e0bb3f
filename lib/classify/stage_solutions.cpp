#include "classify/stages.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/share.hpp"
#include "integrability/parameters.hpp"
#include "integrability/specialise.hpp"
#include "study/curve.hpp"
#include "study/study.hpp"

#include <algorithm>

namespace kov::stages {
namespace {

constexpr double part_of_the_search = 0.2; // of one answer for all parameters
constexpr double part_along_them = 0.4;

bool is_of_the_file(const Board& b, const std::string& manifold) {
  const auto& all = b.known.system.manifolds;
  return std::ranges::any_of(all, [&](const ManifoldSpec& m) { return m.name == manifold; });
}

// Would it be the same study again?
bool is_done(const Board& b, const Round& round, const ManifoldSpec& m) {
  const auto& all = b.stated.all;
  return b.is_as_stated && !round.at_scale && !round.last && is_the_first(b, round) &&
         std::ranges::any_of(
             all, [&](const StatedSolution& x) { return x.finished && x.name == m.name; });
}

std::vector<Task> worth_trying(const Round& round, const std::vector<ManifoldSpec>& all) {
  std::vector<Task> tasks;
  if (round.pieces.empty()) return tasks;
  for (const ManifoldSpec& m : all)
    if (!round.last || is_among(m.name, round.cut)) tasks.push_back({m.name, m});
  return tasks;
}

// In any ring: a function of one that has no such name does not use it.
bool uses(const MFraction& f, const std::string& name) {
  const auto i = f.ring() ? f.ring()->find(name) : std::nullopt;
  return i && kov::uses(f, *i);
}

// The adjoined constants that occur in the equations of the set or along it.
std::vector<std::size_t> constants_in(const System& s, const ManifoldSpec& m,
                                      const ManifoldReport& report) {
  auto all = adjoined_constants(s);
  std::erase_if(all, [&](std::size_t c) {
    const std::string& name = s.ring()->name(c);
    const auto in_it = [&](const Equation& e) { return uses(e.difference, name); };
    const auto along_it = [&](const BlockReport& block) {
      return block.ode && uses(block.ode->r, name);
    };
    return std::ranges::none_of(m.equations, in_it) && std::ranges::none_of(m.levels, in_it) &&
           std::ranges::none_of(report.blocks, along_it);
  });
  return all;
}

// The study along m, a manifold that the file need not name.
std::shared_ptr<const study::Evidence> evidence(System s, const ManifoldSpec& m,
                                                ManifoldReport report) {
  const auto named = [&](const ManifoldSpec& known) { return known.name == m.name; };
  if (std::ranges::none_of(s.manifolds, named)) s.manifolds.push_back(m);
  study::CurveStudy found;
  found.first = std::move(report);
  return std::make_shared<const study::Evidence>(std::move(s), std::move(found));
}

// The system with as many parameters 1 as possible; false: there is none.
bool change_scale(Round& round) {
  try {
    round.scale = scaled(round.system);
    if (!round.scale) return false;
    auto claims = kov::at_values(round.claims, round.scale->values);
    auto levels = at_values(round.levels, round.scale->values, claims);
    round.at_scale = {round.scale->system, std::move(claims), std::move(levels)};
    return true;
  } catch (const DomainError&) { // something has no value there
    round.scale.reset();
    return false;
  }
}

} // namespace

std::vector<Task> stated(const Board& b, const Round& /*round*/) {
  if (b.begun || b.stated.all.empty()) return {};
  return {{"the manifolds of the file"}};
}

void take_stated(Board& b, Round& round, const Task& /*task*/, const Budget& /*budget*/) {
  for (const StatedSolution& one : b.stated.all) {
    b.result.spent.push_back(one.spent);
    const auto named = [&](const ManifoldSpec& m) { return m.name == one.name; };
    const auto& all = round.system.manifolds;
    const auto along = std::ranges::find_if(all, named);
    for (const Exclusion& x : one.exclusions) {
      Exclusion e = in_ring(x, round.system.ring());
      if (along != all.end()) e.along = *along;
      exclude_or_defer(b, round, std::move(e));
    }
    note(round, "along " + one.name, one.outcome);
  }
}

std::vector<Task> one_answer(const Board& b, const Round& round) {
  Round scaled_round = round;
  if (round.pieces.empty() || !b.options.search_solutions || !change_scale(scaled_round)) return {};
  return {{"one answer for all parameters"}};
}

namespace {

void study_once(Board& b, Round& trial, const Task& task, const Budget& budget) {
  find_solutions(b, trial, task, part_of_the_work(budget, part_of_the_search));
  const std::vector<Task> along = found(b, trial);
  const Budget for_all = part_of_the_work(budget, part_along_them);
  for (std::size_t i = 0; i < along.size() && !trial.pieces.empty(); ++i)
    study_along(b, trial, along[i],
                part_of_the_work(for_all, 1 / static_cast<double>(along.size() - i)));
}

} // namespace

void try_one_answer(Board& b, Round& round, const Task& task, const Budget& budget) {
  const SystemClassification before = b.result;
  Round trial = round;
  std::string limit;
  try {
    study_once(b, trial, task, budget);
  } catch (const OutOfBudget& reached) { // what was found so far may not cover the round
    limit = reached.what();
  }
  const std::size_t equations = round.whole.where.equations().size();
  const bool done = limit.empty() && std::ranges::all_of(trial.pieces, [&](const Undecided& p) {
                      return p.where.is_algebraic() && p.where.equations().size() > equations;
                    });
  if (done) {
    round = std::move(trial);
    round.studied_at_once = true;
    return;
  }
  b.result = before;
  static_cast<void>(change_scale(round));
  if (!limit.empty()) note(round, task.name, limit);
}

std::vector<Task> search(const Board& /*b*/, const Round& round) {
  if (round.pieces.empty() || round.studied_at_once) return {};
  return {{"solutions"}};
}

void find_solutions(Board& b, Round& round, const Task& /*task*/, const Budget& budget) {
  auto solutions = particular_solutions(round.studied().system, round.studied().levels,
                                        b.options.search_solutions, budget);
  round.at_all_levels = std::move(solutions.at_all_levels);
  round.special = std::move(solutions.special);
  if (round.scale)
    for (auto& equations : round.special)
      equations = round.scale->before(std::move(equations));
  round.at_energy_zero = std::move(solutions.at_energy_zero);
  round.solutions = std::move(solutions.manifolds);
  for (const std::string& limit : solutions.left_out)
    note(round, limit, "");
  for (Undecided& p : round.pieces)
    if (round.solutions.empty() && p.tried.empty())
      note(p, "invariant manifolds",
           b.options.search_solutions ? "none was found" : "the file has none");
}

std::vector<Task> found(const Board& b, const Round& round) {
  if (round.studied_at_once) return {};
  auto tasks = worth_trying(round, round.solutions);
  std::erase_if(tasks, [&](const Task& t) { return is_done(b, round, *t.along); });
  return tasks;
}
std::vector<Task> at_energy_zero(const Board& /*b*/, const Round& round) {
  return worth_trying(round, round.at_energy_zero);
}
std::vector<Task> at_all_levels(const Board& /*b*/, const Round& round) {
  return worth_trying(round, round.at_all_levels);
}

void study_along(Board& b, Round& round, const Task& task, const Budget& budget) {
  const ManifoldSpec& m = *task.along;
  CheckOptions check = b.options.check;
  check.decide.budget = budget;
  const KnownSystem& known = round.studied();
  const auto from = evidence(known.system, m, study_curve(known.system, m, known.claims, check));
  const ManifoldReport& report = from->curve().first;
  if (budget.is_spent()) {
    round.limited = true;
    if (!round.last) round.cut.push_back(m.name);
  }
  if (report.failure && is_of_the_file(b, m.name) && is_the_first(b, round))
    add_once(b.result.notes, {ClassificationNote::What::manifold,
                              m.name + " was not used: " + report.failure->message});
  const auto constants = constants_in(known.system, m, report);
  for (Exclusion& x : exclusions(known.system, report, level_parameters(known.system))) {
    x.constants = constants;
    x.along = round.before(m);
    x.from = from;
    exclude_or_defer(b, round, round.before(std::move(x)));
  }
  note(round, "along " + report.name, outcome(report));
}

std::vector<Task> conditions(const Board& /*b*/, const Round& round) {
  const bool some =
      std::ranges::any_of(round.pieces, [](const Undecided& p) { return !p.where.is_algebraic(); });
  return some ? std::vector<Task>{{"common values of exponent differences"}} : std::vector<Task>{};
}

// With one parameter the common values are numbers, and cheaper than integrals for all parameters.
std::vector<Task> conditions_on_one(const Board& b, const Round& round) {
  const auto free = round.system.field.parameters.size() - level_parameters(round.system).size();
  return free == 1 ? conditions(b, round) : std::vector<Task>{};
}

void meet_conditions(Board& b, Round& round, const Task& /*task*/, const Budget& /*budget*/) {
  std::vector<Undecided> left;
  for (const Undecided& piece : round.pieces) {
    auto parts = met(b, round, piece);
    std::move(parts.begin(), parts.end(), std::back_inserter(left));
  }
  round.pieces = std::move(left);
}

} // namespace kov::stages
