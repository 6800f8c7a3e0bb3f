#include "classify/classify.hpp"

#include "classify/almost_all.hpp"
#include "classify/bounded.hpp"
#include "classify/darboux_points.hpp"
#include "classify/faces.hpp"
#include "classify/growth.hpp"
#include "classify/scale.hpp"
#include "classify/solutions.hpp"
#include "classify/stated.hpp"
#include "classify/variables.hpp"
#include "decide/afterwards.hpp"
#include "integrability/eigenvalue.hpp"
#include "integrability/parameters.hpp"
#include "integrability/specialise.hpp"
#include "integrability/study.hpp"
#include "strata/words.hpp"
#include "study/curve.hpp"
#include "study/exclusion.hpp"
#include "study/parameter_split.hpp"
#include "study/pieces.hpp"
#include "system/relations.hpp"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <utility>

namespace kov {
namespace {

using Clock = Budget::Clock;

bool decides_something(const SystemClassification& c) {
  return c.almost_all || std::any_of(c.strata.begin(), c.strata.end(),
                                     [](const auto& s) { return s.status != StratumStatus::open; });
}

constexpr std::size_t least_dimension = 5;   // where a normal part may have order four
constexpr std::size_t most_compared = 8;     // integrable strata with one exclusion
constexpr long low_degree = 2;               // of the integrals that are looked for first
constexpr long most_coefficients = 8;        // the degree of their coefficients
constexpr double part_with_parameters = 0.5; // of the time that is left: special values need some
constexpr double part_for_almost_all = 0.2;
constexpr double part_without_constants = 0.25; // of the time, before algebraic constants are used

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// With what is known of it.
struct KnownSystem {
  System system;
  std::vector<ClaimReport> claims;
  std::vector<KnownLevel> levels;
};

/// One system with its solutions and integrals, on some pieces of the parameters.
struct Round : KnownSystem {
  Piece whole;
  std::vector<Piece> pieces = {whole};
  std::vector<ManifoldSpec> at_energy_zero = {}, at_all_levels = {}; ///< solutions for what is left
  std::vector<std::vector<MPoly>> special = {}; ///< where there may be more solutions
  std::vector<Exclusion> late = {}; ///< with exceptions that take long to tell: for what is left
  std::vector<ManifoldSpec> solutions = {};
  bool integrals_known = false;             ///< for all of these parameters, from a round before,
  std::vector<MPoly> integrals_unless = {}; ///< but not where one of these vanishes
  std::size_t decided = 0;                  ///< strata that were there before
  bool limited = false;                     ///< some stage ended by its share of the time
  std::vector<std::string> cut = {};        ///< the solutions whose share was too small
  bool last = false;                        ///< after all others, with all the time that is left
  /// Where some parameters are not 0 the solutions are those of a system where they are 1.
  std::optional<ScaledSystem> scale = {};
  std::optional<KnownSystem> at_scale = {};

  [[nodiscard]] const KnownSystem& studied() const { return at_scale ? *at_scale : *this; }
  [[nodiscard]] Exclusion before(Exclusion e) const {
    return scale ? scale->before(std::move(e)) : e;
  }
};

class Composition {
public:
  Composition(const System& s, const ClassifyOptions& options, const StatedSolutions& stated)
      : options_(options), stated_(stated) {
    start_ = Clock::now();
    const bool search = options.search_solutions && !stated.decided;
    const System known = search ? with_found_integrals(s, share(0.1)) : s;
    LevelledSystem levelled = with_levels(known, claims_of_all(known));
    if (options.adjoin_constants && !stated.decided) adjoin_constants(levelled);
    is_as_stated_ = levelled.claims.size() == s.claims.size() && levelled.system.adjoined.empty();
    system_ = without_levels_fixed(std::move(levelled.system));
    claims_ = std::move(levelled.claims);
    levels_ = std::move(levelled.levels);
    const auto notes = std::move(result_.notes);
    result_ = nothing_known(system_);
    result_.notes = notes;
  }

  [[nodiscard]] bool has_new_constants() const { return !system_.adjoined.empty(); }

  SystemClassification run() {
    Round first{{system_, claims_, levels_}, {everywhere(), {}}};
    if (!system_.adjoined.empty()) first = in_solved_parameters(std::move(first));
    waiting_.push_back(std::move(first));
    try {
      while (!waiting_.empty() || !later_.empty()) {
        auto& from = waiting_.empty() ? later_ : waiting_;
        Round next = std::move(from.back());
        from.pop_back();
        study(std::move(next));
      }
      finish();
    } catch (const OutOfBudget& limit) {
      keep_what_was_proved(limit.what());
    } catch (const Contradiction&) {
      throw;
    } catch (const Error& error) {
      if (!decides_something(so_far_)) throw;
      keep_what_was_proved(failure_of("the stage '" + so_far_.at_work + "'", error.what()));
    }
    return std::move(result_);
  }

  /// With what can be said of almost all parameters, where nothing else can.
  SystemClassification completed() {
    const bool may_have_large_blocks = system_.field.dimension() >= least_dimension &&
                                       system_.field.parameters.size() > levels_.size();
    const Budget whole = options_.check.decide.budget;
    if (may_have_large_blocks)
      options_.check.decide.budget = part_of_the_work(whole, 1 - part_for_almost_all);
    SystemClassification all = run();
    options_.check.decide.budget = whole;
    if (!may_have_large_blocks || !is_open_in_general(all) || work_is_done()) return all;
    std::string missing;
    try {
      missing = failure_of("the matrices at a point", [&] { add_almost_all(all, whole); });
    } catch (const OutOfBudget& limit) {
      missing = limit.what();
    }
    if (!missing.empty()) all.notes.push_back("almost all parameters: " + missing);
    return all;
  }

private:
  void add_almost_all(SystemClassification& all, const Budget& whole) const {
    const auto solutions = particular_solutions(system_, levels_, options_.search_solutions,
                                                part_of_the_work(whole, 0.1));
    auto found = almost_all(system_, solutions.manifolds, claims_, level_parameters(system_),
                            options_.check);
    if (!found) return;
    all.almost_all = std::move(found);
    const ExclusionReason& by = all.almost_all->by;
    for (const auto& [to, from] :
         {std::pair(&all.theorems, &by.theorems), std::pair(&all.trusted, &by.trusted)})
      for (const std::string& text : *from)
        add_once(*to, text);
    add_once(all.assumptions, by.unchecked);
  }

  void keep_what_was_proved(const std::string& why) {
    result_ = std::move(so_far_);
    result_.at_work.clear();
    result_.notes.push_back(why + ": the rest counts as open");
  }

  // Those of the file are decided.
  [[nodiscard]] std::vector<ClaimReport> claims_of_all(const System& known) const {
    std::vector<ClaimReport> all = stated_.claims;
    for (std::size_t k = all.size(); k < known.claims.size(); ++k)
      all.push_back(
          {known.claims[k], decide_claim(known, known.claims[k], options_.check.decide.budget)});
    return all;
  }

  static bool is_open_in_general(const SystemClassification& c) {
    return std::any_of(c.strata.begin(), c.strata.end(), [&](const ClassifiedStratum& s) {
      return s.status == StratumStatus::open && s.special.empty() &&
             s.where.equations().size() <= c.relations.size();
    });
  }

  // Of all solutions, for all parameters: later there are the parameters, but no new constants.
  void adjoin_constants(LevelledSystem& known) const {
    if (known.system.field.dimension() < least_dimension) return;
    auto solutions =
        particular_solutions(known.system, known.levels, options_.search_solutions, share(0.1));
    for (const MPoly& d : solutions.wanted)
      if (adjoin_square_root(known, d, solutions)) break;
    System with_solutions = known.system;
    with_solutions.manifolds = solutions.manifolds;
    CheckOptions check = options_.check;
    check.decide.budget = share(0.1);
    System found = with_eigenvalues(std::move(with_solutions), check);
    if (found.adjoined.empty()) return;
    keep_new_or_stated(found.manifolds, solutions.manifolds, known.system.manifolds.size());
    move_to(std::move(found), known);
  }

  static void move_to(System system, LevelledSystem& known) {
    known.claims = claims_of(system, std::move(known.claims));
    for (KnownLevel& l : known.levels)
      l.integral = transfer(l.integral, system.ring());
    known.system = std::move(system);
  }

  // Where it leads to more solutions.
  bool adjoin_square_root(LevelledSystem& known, const MPoly& d,
                          ParticularSolutions& solutions) const {
    LevelledSystem larger = known;
    move_to(with_square_root(known.system, d, ""), larger);
    auto more = particular_solutions(larger.system, larger.levels, true, share(0.1));
    const std::size_t constant = larger.system.field.constants.back();
    const auto needs_it = [&](const ManifoldSpec& m) {
      return std::any_of(m.equations.begin(), m.equations.end(),
                         [&](const Equation& e) { return uses(e.difference, constant); });
    };
    if (std::none_of(more.manifolds.begin(), more.manifolds.end(), needs_it)) return false;
    known = std::move(larger);
    solutions = std::move(more);
    return true;
  }

  // The others are found again.
  static void keep_new_or_stated(std::vector<ManifoldSpec>& all,
                                 const std::vector<ManifoldSpec>& before, std::size_t stated) {
    const auto text = [](const ManifoldSpec& m) {
      std::string t;
      for (const Equation& e : m.equations)
        t += e.text + "; ";
      return t;
    };
    for (std::size_t k = all.size(); k-- > stated;)
      if (text(all[k]) == text(before[k])) all.erase(all.begin() + static_cast<long>(k));
  }

  // ---- the whole set

  // What the file assumes of a level says nothing of the system: any level will do.
  System without_levels_fixed(System s) {
    const auto levels = level_parameters(s);
    std::erase_if(s.assumptions, [&](const Assumption& a) {
      const bool of_a_level = std::any_of(levels.begin(), levels.end(),
                                          [&](std::size_t i) { return uses(a.value, i); });
      if (of_a_level) {
        is_as_stated_ = false;
        result_.notes.push_back(
            (stated_.all.empty() ? "not used" : "used along the file's manifolds only") +
            std::string(", as the statement is about all levels: ") + a.text);
      }
      return of_a_level;
    });
    for (const std::size_t i : levels)
      forget_assumptions(i, s);
    for (ReduceSpec& r : s.reductions)
      r.energy.clear(); // all levels at once
    return s;
  }

  ParameterSet everywhere() {
    return all_parameters(system_, level_parameters(system_), options_.check.decide.budget.stop,
                          result_);
  }

  // Of the time of the round, as long as it has some.
  [[nodiscard]] Budget share(double part) const {
    const Budget& all = options_.check.decide.budget;
    return part_of_the_work(round_budget_ && !is_over(*round_budget_) ? *round_budget_ : all, part);
  }
  static bool is_over(const Budget& b) { return b.is_spent() || b.is_cut_short(); }
  [[nodiscard]] bool work_is_done() const { return is_over(options_.check.decide.budget); }

  // ---- one round

  void study(Round round) {
    const std::size_t decided = round.decided = result_.strata.size();
    const bool is_first = std::exchange(begun_, true) == false;
    round_budget_ = part_of_the_work(options_.check.decide.budget,
                                     round.last || is_at_numbers(round) ? 1 : part_with_parameters);
    if (is_first) take_stated(round);
    if (!round.pieces.empty() && !round.integrals_known && begins(round, "integrals of low degree"))
      try_integrals_of_low_degree(round, decided);
    // beside many parameters solutions cost much, and Darboux points leave few of their values
    const bool first = has_many_parameters(round.system, round.levels);
    if (first && begins(round, "Darboux points")) try_darboux_points(round);
    if (!round.pieces.empty() && begins(round, "solutions")) try_solutions_at_some_scale(round);
    if (!first && begins(round, "Darboux points")) try_darboux_points(round);
    if (begins(round, "faces")) try_faces(round);
    if (round.pieces.empty())
      look_for_a_contradiction(round, decided);
    else if (begins(round, "integrals"))
      try_integrals(round, decided, options_.degree);
    if (const auto more = larger_coefficients(round.system, options_.degree, most_coefficients);
        more && !round.pieces.empty() && is_small(round) && begins(round, "larger integrals"))
      try_integrals(round, decided, options_.degree, more);
    meet_conditions(round);
    try_what_is_left(round, round.at_energy_zero);
    meet_conditions(round);
    try_what_is_left(round, round.at_all_levels);
    if (options_.order > 1 && !round.pieces.empty() && begins(round, "higher orders"))
      try_higher_orders(round);
    if (options_.degree < options_.degree_at_points && is_small(round) && is_at_a_point(round) &&
        begins(round, "integrals of high degree"))
      try_integrals(round, decided, options_.degree_at_points);
    if (begins(round, "exceptions"))
      for (const Exclusion& e : std::exchange(round.late, {}))
        exclude(round, e);
    cut_where_there_is_more(round);
    tell(round, "");
    const std::size_t later = waiting_.size();
    for (Piece& piece : round.pieces)
      again(round, std::move(piece));
    std::reverse(waiting_.begin() + static_cast<long>(later), waiting_.end()); // the first is next
  }

  // As many parameters as possible are made 1.
  void change_scale(Round& round) const {
    if (!options_.search_solutions) return;
    try {
      round.scale = scaled(round.system);
      if (!round.scale) return;
      auto claims = kov::at_values(round.claims, round.scale->values);
      auto levels = at_values(round.levels, round.scale->values, claims);
      round.at_scale = {round.scale->system, std::move(claims), std::move(levels)};
    } catch (const DomainError&) { // something has no value there
      round.scale.reset();
    }
  }

  // Sets of parameters with solutions of their own are studied by themselves.
  static void cut_where_there_is_more(Round& round) {
    for (const std::vector<MPoly>& equations : round.special) {
      std::vector<Piece> parts;
      for (Piece& piece : round.pieces)
        try {
          auto cut = cut_along(piece, equations, may_vanish(round.system));
          std::move(cut.begin(), cut.end(), std::back_inserter(parts));
        } catch (const OutOfBudget&) { // left whole
          parts.push_back(std::move(piece));
        }
      round.pieces = std::move(parts);
    }
  }
  static std::vector<Piece> cut_along(const Piece& piece, const std::vector<MPoly>& equations,
                                      const MayVanish& possible) {
    const SetParts cut = split_set(piece.where, equations, {}, possible);
    std::vector<Piece> parts;
    for (const auto* sets : {&cut.inside, &cut.outside})
      for (const ParameterSet& set : *sets)
        if (auto part = on_part(piece, set)) parts.push_back(*std::move(part));
    return parts;
  }

  // Tells what is known; false: the stage is to be left out.
  bool begins(Round& round, const std::string& stage) {
    std::string name = stage;
    for (const MPoly& p : round.whole.where.equations())
      name += ", " + to_string(p) + " = 0";
    tell(round, name);
    const auto& skip = options_.skip;
    if (std::find(skip.begin(), skip.end(), name) == skip.end()) return true;
    for (Piece& p : round.pieces)
      note(p, name, "left out, as it did not end in time");
    return false;
  }

  // What is proved so far, the rest open.
  void tell(const Round& round, const std::string& next) {
    SystemClassification kept = result_;
    result_.at_work = next;
    for (const Piece& piece : round.pieces)
      leave_open(piece);
    for (const auto* rounds : {&waiting_, &later_})
      for (const Round& later : *rounds)
        leave_open(later.whole);
    finish();
    so_far_ = std::exchange(result_, std::move(kept));
    so_far_.complete = false;
    const Unmetered words;
    if (options_.so_far) options_.so_far(so_far_);
  }

  // Where little time is enough for all parameters the answer is one for all of them.  Else what is
  // excluded would cut the parameters along many sets, which fewer parameters do not have.
  void try_solutions_at_some_scale(Round& round) {
    Round scaled_round = round;
    change_scale(scaled_round);
    if (!scaled_round.scale) return try_solutions(round);
    const SystemClassification before = result_;
    const auto whole = round_budget_;
    round_budget_ = share(0.1);
    Round trial = round;
    try_solutions(trial);
    round_budget_ = whole;
    const std::size_t equations = round.whole.where.equations().size();
    const bool done = std::all_of(trial.pieces.begin(), trial.pieces.end(), [&](const Piece& p) {
      return p.special.empty() && p.where.equations().size() > equations;
    });
    if (done) {
      round = std::move(trial);
      return;
    }
    result_ = before;
    round = std::move(scaled_round);
    try_solutions(round);
  }

  void try_solutions(Round& round) {
    const auto start = Clock::now();
    const auto solutions = particular_solutions(round.studied().system, round.studied().levels,
                                                options_.search_solutions, share(0.2));
    result_.stages.emplace_back("invariant manifolds", seconds_since(start));
    round.at_all_levels = solutions.at_all_levels;
    round.special = solutions.special;
    if (round.scale)
      for (auto& equations : round.special)
        equations = round.scale->before(std::move(equations));
    round.at_energy_zero = solutions.at_energy_zero;
    round.solutions = solutions.manifolds;
    auto manifolds = worth_trying(round, solutions.manifolds);
    std::erase_if(manifolds, [&](const ManifoldSpec& m) { return is_done(round, m); });
    std::size_t left = manifolds.size();
    for (const ManifoldSpec& m : manifolds) {
      if (round.pieces.empty()) return;
      const double part = round.last ? 0.8 : 0.4;
      if (begins(round, m.name)) try_solution(round, m, part / static_cast<double>(left));
      --left;
    }
    for (Piece& p : round.pieces) {
      for (const std::string& limit : solutions.left_out)
        note(p, limit, "");
      if (solutions.manifolds.empty() && p.tried.empty())
        note(p, "invariant manifolds",
             options_.search_solutions ? "none was found" : "the file has none");
    }
  }

  // What `check` proves of the file's manifolds.
  void take_stated(Round& round) {
    for (const StatedSolution& one : stated_.all) {
      result_.stages.emplace_back(one.name, one.seconds);
      for (const Exclusion& x : one.exclusions) {
        Exclusion e = in_ring(x, round.system.ring());
        if (e.unless && e.unless->squares.size() > 1)
          round.late.push_back(std::move(e));
        else
          exclude(round, e);
      }
      for (Piece& p : round.pieces)
        note(p, "along " + one.name, one.outcome);
    }
  }

  // Not where it would be the same study again.
  [[nodiscard]] bool is_done(const Round& round, const ManifoldSpec& m) const {
    return is_as_stated_ && !round.at_scale && !round.last && is_the_first(round) &&
           std::any_of(stated_.all.begin(), stated_.all.end(),
                       [&](const StatedSolution& x) { return x.finished && x.name == m.name; });
  }

  // In the last round only those whose time was too short: the others have said what they can.
  static std::vector<ManifoldSpec> worth_trying(const Round& round, std::vector<ManifoldSpec> all) {
    if (round.last)
      std::erase_if(all, [&](const ManifoldSpec& m) {
        return std::find(round.cut.begin(), round.cut.end(), m.name) == round.cut.end();
      });
    return all;
  }

  void try_what_is_left(Round& round, const std::vector<ManifoldSpec>& solutions) {
    const auto manifolds = worth_trying(round, solutions);
    const double part = round.last ? 0.8 : 0.2;
    for (const ManifoldSpec& m : manifolds)
      if (!round.pieces.empty() && begins(round, m.name))
        try_solution(round, m, part / static_cast<double>(manifolds.size()));
  }

  // Where two conditions hold together at finitely many values of a difference only.
  void meet_conditions(Round& round) {
    std::vector<Piece> left;
    for (const Piece& piece : round.pieces) {
      auto parts = met(round, piece);
      std::move(parts.begin(), parts.end(), std::back_inserter(left));
    }
    round.pieces = std::move(left);
  }

  std::vector<Piece> at_common_values(const Round& round, const Piece& piece) {
    for (std::size_t i = 0; i < piece.special.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (const auto common = common_values(piece.special[i], piece.special[j])) {
          add_once(result_.trusted, "the common values of two exponent differences");
          return at_those_values(round, piece, *common,
                                 piece.special[i].squares.front().den() *
                                     piece.special[j].squares.front().den());
        }
    if (const auto bounded = bounded_values(round.system, piece.where, piece.special)) {
      add_once(result_.trusted, bounded->trusted);
      MPoly denominators = bounded->values.square.den();
      for (const DifferenceCondition& c : piece.special)
        for (const MFraction& square : c.squares)
          denominators = denominators * square.den();
      return at_those_values(round, piece, bounded->values, squarefree_part(denominators));
    }
    return {piece};
  }

  // Where the denominators vanish nothing is concluded.
  static std::vector<Piece> at_those_values(const Round& round, const Piece& piece,
                                            const CommonValues& common, const MPoly& denominators) {
    const MayVanish possible = may_vanish(round.system);
    const SetParts parts = split_set(piece.where, {denominators}, {}, possible);
    std::vector<Piece> all;
    for (const ParameterSet& special : parts.inside)
      all.push_back({special, piece.special, piece.tried});
    for (const ParameterSet& where : parts.outside)
      for (const Rational& value : common.values) {
        const MFraction difference = common.square - MFraction(common.square.ring(), value);
        for (const ParameterSet& there : split_set(where, {difference.num()}, {}, possible).inside)
          if (auto part = on_part(piece, there)) all.push_back(*std::move(part));
      }
    return all;
  }

  void try_solution(Round& round, const ManifoldSpec& m, double part) {
    const auto start = Clock::now();
    CheckOptions check = options_.check;
    check.decide.budget = share(part);
    const KnownSystem& known = round.studied();
    const ManifoldReport report = study_curve(known.system, m, known.claims, check);
    if (is_over(check.decide.budget)) {
      round.limited = true;
      if (!round.last) round.cut.push_back(m.name);
    }
    result_.stages.emplace_back(m.name, seconds_since(start));
    if (report.failure && is_of_the_file(m.name) && is_the_first(round))
      add_once(result_.notes,
               "the file's manifold " + m.name + " was not used: " + report.failure->message);
    for (Exclusion& x : exclusions(known.system, report, level_parameters(known.system))) {
      Exclusion e = round.before(std::move(x));
      if (e.unless && e.unless->squares.size() > 1)
        round.late.push_back(std::move(e));
      else
        exclude(round, e);
    }
    for (Piece& p : round.pieces)
      note(p, "along " + report.name, outcome(report));
  }

  [[nodiscard]] static bool is_at_numbers(const Round& round) {
    return round.system.field.parameters.size() <= round.levels.size();
  }

  // Two degrees of freedom: of more variables there are very many monomials.
  [[nodiscard]] static bool is_small(const Round& round) {
    return round.system.field.dimension() <= 4;
  }

  // Each parameter has finitely many values.
  [[nodiscard]] static bool is_at_a_point(const Round& round) {
    const auto levels = level_parameters(round.system);
    const auto equations = round.whole.where.equations();
    const auto& all = round.system.field.parameters;
    return !round.pieces.empty() && std::all_of(all.begin(), all.end(), [&](std::size_t t) {
      return std::find(levels.begin(), levels.end(), t) != levels.end() ||
             std::any_of(equations.begin(), equations.end(),
                         [&](const MPoly& f) { return used_variables(f) == std::vector{t}; });
    });
  }

  void try_higher_orders(Round& round) {
    const auto start = Clock::now();
    std::size_t left = round.solutions.size();
    for (const ManifoldSpec& m : round.solutions) {
      if (round.pieces.empty()) break;
      Options decide = options_.check.decide;
      decide.budget = share(0.3 / static_cast<double>(left--));
      std::string why;
      if (auto e =
              exclusion_of_higher_order(round.studied().system, m, options_.order, decide, why))
        exclude(round, round.before(*std::move(e)));
      for (Piece& p : round.pieces)
        note(p, "orders 2.." + std::to_string(options_.order) + " along " + m.name, why);
    }
    result_.stages.emplace_back("higher orders", seconds_since(start));
  }

  void try_darboux_points(Round& round) {
    if (round.pieces.empty() || !options_.search_solutions) return;
    const auto start = Clock::now();
    try {
      for (const Exclusion& e : exclusions_by_darboux_points(round.system, share(0.3)))
        exclude(round, e);
    } catch (const OutOfBudget& limit) {
      for (Piece& p : round.pieces)
        note(p, "Darboux points", limit.what());
    }
    result_.stages.emplace_back("Darboux points", seconds_since(start));
  }

  void try_faces(Round& round) {
    if (round.pieces.empty() || !options_.search_solutions) return;
    const auto start = Clock::now();
    CheckOptions check = options_.check;
    check.decide.budget = share(0.3);
    try {
      for (Exclusion& e : exclusions_at_faces(round.studied().system, check))
        exclude(round, round.before(std::move(e)));
    } catch (const OutOfBudget& limit) {
      for (Piece& p : round.pieces)
        note(p, "where exponentials are 0", limit.what());
    }
    result_.stages.emplace_back("where exponentials are 0", seconds_since(start));
  }

  // Later rounds have fewer parameters.
  [[nodiscard]] bool is_the_first(const Round& round) const {
    return round.system.field.parameters.size() == system_.field.parameters.size();
  }
  [[nodiscard]] bool is_of_the_file(const std::string& manifold) const {
    return std::any_of(system_.manifolds.begin(), system_.manifolds.end(),
                       [&](const ManifoldSpec& m) { return m.name == manifold; });
  }

  void exclude(Round& round, const Exclusion& e) {
    contradict_no_integrals(round, e);
    if (!kov::exclude(round.pieces, e, round.system, result_))
      round.late.push_back(with_simple_exceptions(e)); // nothing is concluded for now
  }

  // Less is excluded, for later: of "p and q both vanish" only p = 0 is kept, a larger set, which is
  // studied again by itself.
  static Exclusion with_simple_exceptions(Exclusion e) {
    for (auto& list : e.not_all_zero)
      if (list.size() > 1)
        list = {*std::min_element(list.begin(), list.end(), [](const MPoly& a, const MPoly& b) {
          return a.length() < b.length();
        })};
    return e;
  }

  // ---- first integrals

  // Darboux: logarithms come after the solutions, as they do not contradict what these exclude.
  IntegralSearch search_integrals(const System& s, long degree, double part, bool with_darboux,
                                  std::optional<long> coefficients = {}) {
    const auto start = Clock::now();
    IntegralOptions options;
    options.degree = degree;
    options.until_integrable = true;
    options.budget = share(part);
    options.darboux = with_darboux;
    options.coefficients = coefficients;
    IntegralSearch search = find_integrals(s, options);
    result_.stages.emplace_back("first integrals of degree <= " + std::to_string(degree),
                                seconds_since(start));
    return search;
  }

  // Where they are enough no particular solution needs to be studied.
  void try_integrals_of_low_degree(Round& round, std::size_t decided) {
    if (round.integrals_known) return;
    IntegralSearch search =
        search_integrals(round.system, std::min(options_.degree, low_degree), 0.25, false);
    common_equations_first(round.system, search.sets);
    for (const IntegralsOfSet& set : search.sets)
      if (is_enough(round.system, set)) {
        std::vector<Piece> none;
        take_integrals(round, set, search.not_covered, decided, none);
        std::move(none.begin(), none.end(), std::back_inserter(round.pieces));
      }
    if (search.elsewhere && is_enough(round.system, *search.elsewhere))
      take_elsewhere(round, *search.elsewhere, search.not_covered);
  }

  void try_integrals(Round& round, std::size_t decided, long degree,
                     std::optional<long> coefficients = {}) {
    const bool is_known = round.integrals_known && degree == options_.degree && !coefficients;
    if (round.pieces.empty() || is_known) return;
    IntegralSearch search = search_integrals(round.system, degree, 0.5, true, coefficients);
    if (coefficients && !search.finished()) round.limited = true; // once more, with more time
    common_equations_first(round.system, search.sets);
    round.integrals_known = search.finished();
    round.integrals_unless = search.not_covered;
    std::vector<Piece> met;
    for (const IntegralsOfSet& set : search.sets)
      if (set.found() > 0 || is_enough(round.system, set))
        take_integrals(round, set, search.not_covered, decided, met);
    const bool finds = search.elsewhere && is_enough(round.system, *search.elsewhere);
    const bool is_the_last_word = degree == options_.degree || search.finished();
    if (search.elsewhere && (is_the_last_word || finds))
      take_elsewhere(round, *search.elsewhere, search.not_covered);
    if (is_the_last_word) note_what_is_open(round, search);
    std::move(met.begin(), met.end(), std::back_inserter(round.pieces));
  }

  // Sets without integrals cut no pieces, also where a limit has kept them apart.
  static void note_what_is_open(Round& round, const IntegralSearch& search) {
    const auto nothing = [](const IntegralsOfSet& set) { return set.found() == 0; };
    const auto empty = std::find_if(search.sets.rbegin(), search.sets.rend(), nothing);
    if (search.elsewhere || empty == search.sets.rend()) return;
    const auto limited = std::find_if(search.sets.rbegin(), search.sets.rend(),
                                      [&](const auto& s) { return nothing(s) && !s.open.empty(); });
    for (Piece& piece : round.pieces)
      note(piece, "first integrals",
           searched_text(limited == search.sets.rend() ? *empty : *limited));
  }

  // Everything is excluded: integrals of low degree would say that something is wrong.
  void look_for_a_contradiction(const Round& round, std::size_t decided) {
    if (round.integrals_known || result_.strata.size() == decided) return;
    for (const IntegralsOfSet& set :
         search_integrals(round.system, std::min(options_.degree, low_degree), 0.1, false).sets)
      if (is_enough(round.system, set))
        contradict_nothing(conditions_of(round.system, set, {}), set, round.system, decided);
  }

  static bool is_enough(const System& s, const IntegralsOfSet& set) {
    return set.integrable(s.field);
  }
  // Sets are cut along their equations in this order: what several have in common leaves few parts.
  static void common_equations_first(const System& s, std::vector<IntegralsOfSet>& sets) {
    const auto frequency = [&](const MPoly& p) {
      return std::count_if(sets.begin(), sets.end(), [&](const IntegralsOfSet& set) {
        const auto& all = set.equations;
        return is_enough(s, set) && std::find(all.begin(), all.end(), p) != all.end();
      });
    };
    for (IntegralsOfSet& set : sets) {
      auto sorted = set.equations;
      std::stable_sort(sorted.begin(), sorted.end(),
                       [&](const MPoly& p, const MPoly& q) { return frequency(p) > frequency(q); });
      set.equations = std::move(sorted);
    }
  }
  // They are no meromorphic functions, and contradict no theorem on these.
  static bool has_logarithms(const std::vector<FoundIntegral>& integrals) {
    return std::any_of(integrals.begin(), integrals.end(),
                       [](const FoundIntegral& f) { return !f.logarithms.empty(); });
  }

  // At special values where the relations fall apart the integrals may depend on one another.
  static Exclusion conditions_of(const System& s, const IntegralsOfSet& set,
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

  // Pieces inside the set go to `met`, or are done with.
  void take_integrals(Round& round, const IntegralsOfSet& set,
                      const std::vector<MPoly>& not_covered, std::size_t decided,
                      std::vector<Piece>& met) {
    const Exclusion where = conditions_of(round.system, set, not_covered);
    const bool enough = is_enough(round.system, set);
    if (enough) {
      contradict_nothing(where, set, round.system, decided);
      integrable(round, set, where, decided);
    }
    std::vector<Piece> left;
    for (Piece& piece : round.pieces) {
      try {
        const SetParts parts =
            split_set(piece.where, where.zero, where.not_all_zero, may_vanish(round.system));
        for (const ParameterSet& inside : parts.inside)
          if (auto part = on_part(piece, inside); part && !enough) {
            note(*part, "first integrals", searched_text(set));
            met.push_back(*std::move(part));
          }
        for (const ParameterSet& outside : parts.outside)
          if (auto part = on_part(piece, outside)) left.push_back(*std::move(part));
      } catch (const OutOfBudget&) {
        met.push_back(std::move(piece));
      }
    }
    round.pieces = std::move(left);
  }

  // The pieces that met no set.
  void take_elsewhere(Round& round, const IntegralsOfSet& set,
                      const std::vector<MPoly>& not_covered) {
    std::vector<Piece> left;
    for (Piece& piece : round.pieces) {
      const bool covered = std::all_of(not_covered.begin(), not_covered.end(),
                                       [&](const MPoly& p) { return piece.where.is_nonzero(p); });
      if (covered && is_enough(round.system, set)) {
        result_.strata.push_back({std::move(piece.where), std::move(piece.special),
                                  StratumStatus::integrable, integrals_of(round.system, set),
                                  fields_of(round.system, set)});
        continue;
      }
      if (covered) note(piece, "first integrals", searched_text(set));
      left.push_back(std::move(piece));
    }
    round.pieces = std::move(left);
  }

  std::vector<FoundIntegral> integrals_of(const System& s, const IntegralsOfSet& set) {
    if (set.only_declared_relations)
      add_once(result_.assumptions,
               "the function symbols satisfy no algebraic relations but those declared");
    if (!s.field.poisson) return set.integrals;
    std::vector<FoundIntegral> integrals;
    for (const std::size_t i : set.commuting)
      integrals.push_back(set.integrals[i]);
    return integrals;
  }

  static std::vector<std::string> fields_of(const System& s, const IntegralsOfSet& set) {
    std::vector<std::string> all;
    for (const auto& y : set.fields)
      all.push_back(field_text(s.field, y));
    return all;
  }

  // The whole set, as it was found: no excluded stratum meets it.  Where a search before has found
  // integrals on some of it, only what is left.
  void integrable(const Round& round, const IntegralsOfSet& set, const Exclusion& where,
                  std::size_t decided) {
    const auto integrals = integrals_of(round.system, set);
    const auto add = [&](const Piece& piece) {
      const SetParts parts =
          split_set(piece.where, where.zero, where.not_all_zero, may_vanish(round.system));
      for (const ParameterSet& inside : parts.inside)
        if (auto part = on_part(piece, inside))
          result_.strata.push_back({std::move(part->where), std::move(part->special),
                                    StratumStatus::integrable, integrals,
                                    fields_of(round.system, set)});
    };
    if (!has_logarithms(set.integrals) && !meets_integrable(round.system, where, decided))
      return add(round.whole);
    for (const Piece& piece : round.pieces)
      add(piece);
  }

  [[nodiscard]] bool meets_integrable(const System& s, const Exclusion& where,
                                      std::size_t decided) const {
    return std::any_of(
        result_.strata.begin() + static_cast<long>(decided), result_.strata.end(),
        [&](const ClassifiedStratum& x) {
          return x.status == StratumStatus::integrable &&
                 !split_set(x.where, where.zero, where.not_all_zero, may_vanish(s)).inside.empty();
        });
  }

  static std::string searched_text(const IntegralsOfSet& set) {
    std::string known;
    for (const FoundIntegral& f : set.integrals)
      known += (known.empty() ? "" : ", ") + (f.hamiltonian          ? std::string("H")
                                              : f.logarithms.empty() ? brief(f.value, 60)
                                                                     : to_string(f));
    const std::string text = set.searched + ": ";
    const std::string others =
        known.empty() ? "none found" : "none found beside functions of " + known;
    if (!set.open.empty()) return text + others + " (" + set.open + ")";
    return text + others +
           (set.complete_for_smooth || set.complete ? ", and there is none of this kind" : "");
  }

  // Our own check: a theorem on integrals and one on variational equations cannot contradict.
  void contradict_nothing(const Exclusion& where, const IntegralsOfSet& set, const System& s,
                          std::size_t decided) const {
    if (set.only_declared_relations || has_logarithms(set.integrals)) return;
    for (std::size_t i = decided; i < result_.strata.size(); ++i) {
      const ClassifiedStratum& x = result_.strata[i];
      if (x.status != StratumStatus::excluded || !x.by.front().unchecked.empty() ||
          !x.by.front()
               .integrals.without.empty()) // the integrals may be others than those excluded
        continue;
      const auto both = split_set(x.where, where.zero, where.not_all_zero, may_vanish(s)).inside;
      for (const ParameterSet& common : both) {
        const auto piece = on_part({x.where, x.special, {}}, common);
        refuse_both(piece);
      }
    }
  }

  static void refuse_both(const std::optional<Piece>& integrable_and_not) {
    if (integrable_and_not && integrable_and_not->special.empty())
      throw Contradiction("some parameters are proved to be integrable and not to be");
  }

  // The same where the integrals came first.
  void contradict_no_integrals(const Round& round, const Exclusion& e) const {
    const System& s = round.system;
    if (!e.by.unchecked.empty() || !e.by.integrals.without.empty() || !s.field.functions.empty())
      return;
    std::size_t looked_at = 0;
    for (std::size_t i = round.decided; i < result_.strata.size() && looked_at < most_compared;
         ++i) {
      const ClassifiedStratum& x = result_.strata[i];
      if (x.status != StratumStatus::integrable || has_logarithms(x.integrals)) continue;
      ++looked_at;
      try {
        for (const ParameterSet& common :
             split_set(x.where, e.zero, e.not_all_zero, may_vanish(s)).inside) {
          auto piece = on_part({x.where, x.special, {}}, common);
          if (piece && e.unless) piece = with_condition(*std::move(piece), negation(*e.unless));
          refuse_both(piece);
        }
      } catch (const OutOfBudget&) { // not compared
      }
    }
  }

  // ---- the next round

  // Where equations hold the system is a special one, and all is done again.
  void again(const Round& round, Piece piece) {
    if (is_outside_of_the_domain(round.system, piece.where)) return;
    try {
      if (auto parts = by_factors(round, piece); parts.size() > 1) {
        for (Piece& part : parts)
          again(round, std::move(part));
        return;
      }
      if (work_is_done()) {
        note(piece, "the work limit was reached", "");
        return leave_open(std::move(piece));
      }
      const Substitution values = solved_parameters(round.system, piece.where);
      if (values.empty()) return once_more(round, std::move(piece));
      Round next = in_parameters(round, piece, values);
      const auto& unless = round.integrals_unless;
      const bool covered = std::all_of(unless.begin(), unless.end(),
                                       [&](const MPoly& p) { return piece.where.is_nonzero(p); });
      next.integrals_known = round.integrals_known && covered && next.system.field.poisson &&
                             looks_at_the_same(round.system, next.system);
      waiting_.push_back(std::move(next));
    } catch (const DomainError& e) {
      note(piece, "the equations of the parameters", e.what());
      leave_open(std::move(piece));
    } catch (const OutOfBudget& e) {
      note(piece, "the equations of the parameters", e.what());
      leave_open(std::move(piece));
    }
  }

  static Substitution solved_parameters(const System& s, const ParameterSet& where) {
    Substitution values;
    for (const auto& [i, value] : solve(where).values)
      if (is_parameter(s, i)) values[i] = value;
    return values;
  }

  static Round in_parameters(const Round& round, const Piece& piece, const Substitution& solved) {
    const Substitution values = with_functions(round.system, solved);
    System special = kov::at_values(round.system, values);
    for (const MPoly& p : piece.where.inequations())
      assume_nonzero(special, substitute(p, values));
    auto claims = kov::at_values(round.claims, values);
    auto levels = at_values(round.levels, values, claims);
    return {{std::move(special), std::move(claims), std::move(levels)}, piece};
  }

  // Where an eigenvalue gives a parameter: rational functions are in the place of an algebraic one.
  static Round in_solved_parameters(Round all) {
    try {
      const Substitution values = solved_parameters(all.system, all.whole.where);
      if (!values.empty()) return in_parameters(all, all.whole, values);
    } catch (const DomainError&) {
    } catch (const OutOfBudget&) {
    }
    return all;
  }

  static std::vector<Piece> by_factors(const Round& round, const Piece& piece) {
    std::vector<Piece> parts;
    for (const ParameterSet& set : kov::by_factors(piece.where, may_vanish(round.system)))
      if (auto part = on_part(piece, set)) parts.push_back(*std::move(part));
    return parts;
  }

  // With the time that is left when all special values have had theirs.
  void once_more(const Round& round, Piece piece) {
    if (!round.limited || round.last) return leave_open_at_last(round, std::move(piece));
    Round next{{round.system, round.claims, round.levels}, std::move(piece)};
    next.integrals_known = round.integrals_known;
    next.last = true;
    next.cut = round.cut;
    later_.push_back(std::move(next));
  }

  // A special Hamiltonian may have another form, and integrals of another one.
  [[nodiscard]] bool looks_at_the_same(const System& s, const System& special) const {
    IntegralOptions options;
    options.degree = options_.degree;
    options.budget = share(0.05);
    try {
      return searched_class(s, options) == searched_class(special, options);
    } catch (const InvalidArgument&) { // nothing can be looked at
      return true;
    }
  }

  static std::vector<KnownLevel> at_values(std::vector<KnownLevel> levels,
                                           const Substitution& values,
                                           const std::vector<ClaimReport>& claims) {
    std::erase_if(levels,
                  [&](const KnownLevel& l) { return l.claim && !claims[*l.claim].result.proved; });
    for (KnownLevel& l : levels)
      l.integral = substitute(l.integral, values);
    return levels;
  }

  static bool is_parameter(const System& s, std::size_t i) {
    const auto& all = s.field.parameters;
    return std::find(all.begin(), all.end(), i) != all.end();
  }

  static void assume_nonzero(System& s, const MFraction& value) {
    if (is_constant(value)) return;
    Assumption a;
    a.relation = Assumption::Relation::nonzero;
    a.value = value;
    s.assumptions.push_back(std::move(a));
  }

  // What excludes rational first integrals only, or those near curves at which Darboux's have
  // logarithms, comes after all others.
  void leave_open_at_last(const Round& round, Piece piece) {
    std::vector<Piece> pieces{std::move(piece)};
    const auto exclude_all = [&](const std::vector<Exclusion>& all) {
      for (const Exclusion& e : all) {
        contradict_no_integrals(round, e);
        kov::exclude(pieces, e, round.system, result_);
      }
    };
    if (options_.search_solutions)
      exclude_all(exclusions_by_multiple_points_of_parts(round.system));
    if (!round.system.field.poisson)
      for (const ManifoldSpec& m : round.solutions)
        if (!pieces.empty()) exclude_all(along_the_curve(round, m));
    for (Piece& left : pieces)
      for (Piece& part : met(round, left)) {
        const bool is_smaller = part.where.equations().size() > left.where.equations().size();
        is_smaller ? again(round, std::move(part)) : leave_open(std::move(part));
      }
  }
  [[nodiscard]] std::vector<Piece> met(const Round& round, const Piece& piece) {
    try {
      return at_common_values(round, piece);
    } catch (const OutOfBudget&) {
      return {piece};
    }
  }
  [[nodiscard]] std::vector<Exclusion> along_the_curve(const Round& round,
                                                       const ManifoldSpec& m) const {
    CheckOptions check = options_.check;
    check.decide.budget = share(0.1);
    check.along_the_curve = true;
    const KnownSystem& known = round.studied();
    auto all = exclusions(known.system, study_curve(known.system, m, known.claims, check),
                          level_parameters(known.system));
    for (Exclusion& e : all)
      e = round.before(std::move(e));
    return all;
  }
  void leave_open(Piece piece) { kov::leave_open(std::move(piece), result_); }

  // ---- the theorem

  void finish() {
    kov::finish(system_, result_);
    result_.seconds = seconds_since(start_);
  }

  ClassifyOptions options_;
  const StatedSolutions& stated_;
  bool is_as_stated_ = false;          ///< the system is that of the file, but for names of levels
  bool begun_ = false;                 ///< some round is done, or at work
  std::optional<Budget> round_budget_; ///< for the round at work
  System system_;                      ///< with names for levels
  std::vector<ClaimReport> claims_;
  std::vector<KnownLevel> levels_;
  std::vector<Round> waiting_; ///< parts of the parameters that were not studied yet
  std::vector<Round> later_;   ///< those that their time did not suffice for
  SystemClassification result_;
  SystemClassification so_far_; ///< what result_ was at the end of a stage, the rest open
  Clock::time_point start_;
};

} // namespace

namespace {

bool is_word_of(const std::string& text, const std::string& word) {
  const auto is_part = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const bool begins = at == 0 || !is_part(text[at - 1]);
    const std::size_t end = at + word.size();
    if (begins && (end == text.size() || !is_part(text[end]))) return true;
  }
  return false;
}

bool speaks_of(const SystemClassification& c, const std::string& constant) {
  const auto any = [&](const std::vector<std::string>& texts) {
    return std::any_of(texts.begin(), texts.end(),
                       [&](const std::string& text) { return is_word_of(text, constant); });
  };
  return std::any_of(c.strata.begin(), c.strata.end(), [&](const ClassifiedStratum& s) {
    return any(conditions(c, s)) || any({integrals_text(s)}) || any(s.fields) ||
           any(s.open_after) ||
           std::any_of(s.by.begin(), s.by.end(), [&](const ExclusionReason& why) {
             return any({why.solution, why.level, why.reason, why.unchecked}) || any(why.trusted);
           });
  });
}

} // namespace

SystemClassification classify_in_these_variables(const System& s, const ClassifyOptions& options,
                                                 const StatedSolutions& stated) {
  Composition composition(s, options, stated);
  if (!composition.has_new_constants()) return composition.completed();
  ClassifyOptions plain = options;
  plain.adjoin_constants = false;
  plain.check.decide.budget = part_of_the_work(options.check.decide.budget, part_without_constants);
  auto without = Composition(s, plain, stated).run();
  if (without.status() != ClassificationStatus::open) return without;
  SystemClassification result;
  const auto complete = [&] { result = composition.completed(); };
  if (!decides_something(without)) {
    complete();
  } else if (auto failed = failure_of("the study with new constants", complete); !failed.empty()) {
    without.notes.push_back(std::move(failed));
    return without;
  }
  std::erase_if(result.constants,
                [&](const std::string& c) { return !speaks_of(result, c.substr(0, c.find(' '))); });
  return result;
}

} // namespace kov
