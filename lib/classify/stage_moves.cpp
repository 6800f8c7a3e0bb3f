#include "classify/stages.hpp"

#include "classify/variables.hpp"
#include "exact/lists.hpp"
#include "integrability/parameters.hpp"
#include "moves/frames.hpp"
#include "moves/leading.hpp"
#include "moves/splitting.hpp"

#include <algorithm>

namespace kov::stages {
namespace {

// Each piece satisfies more equations than the round: there the system is a special one, and is better
// studied by itself.
bool has_only_special_values(const Round& round) {
  const std::size_t equations = round.whole.where.equations().size();
  return std::ranges::all_of(round.pieces, [&](const Undecided& p) {
    return p.where.is_algebraic() && p.where.equations().size() > equations;
  });
}

// Do the equations of the piece, where they hold, hold in the frame too?  There the system is the
// same one.
bool stays_in(const Undecided& piece, const Equivalence& e) {
  const auto equations = piece.where.equations();
  return std::ranges::all_of(equations, [&](const MPoly& f) {
    const auto there = pulled_back(e, f);
    return there && piece.where.vanishes(*there);
  });
}

std::size_t free_parameters(const System& s) {
  return s.field.parameters.size() - level_parameters(s).size();
}

} // namespace

std::vector<Task> frames(const Board& b, const Round& round) {
  const VectorField& v = round.system.field;
  return one_if(!round.pieces.empty() && b.options.search_solutions && !round.last && v.poisson &&
                    v.hamiltonian && v.functions.empty() && free_parameters(round.system) >= 2,
                "a frame");
}

void choose_frame(Board& b, Round& round, const Task& /*task*/, const Budget& budget) {
  const auto frame = find_frame(round.system, budget);
  if (!frame) return;
  const MPoly vanishing = MPoly::variable(round.system.ring(), frame->vanishing);
  std::vector<Undecided> left;
  std::vector<Follower> followers;
  for (const Undecided& piece : round.pieces) {
    const CutParts parts = split(piece.where, {.zero = {vanishing}}, may_vanish(round.system));
    if (parts.inside.empty() || !piece.where.is_algebraic() || !stays_in(piece, frame->to)) {
      left.push_back(piece);
      continue;
    }
    for (const Set& inside : parts.inside)
      left.push_back(piece.on(inside));
    const Set of = piece.where.plain().where_zero(vanishing);
    for (const Set& outside : parts.outside) {
      // a sum of two real squares, one of which is not 0
      if (frame->to.real) {
        followers.push_back({piece.on(outside.where_nonzero(frame->to.square)), of, frame->to});
        continue;
      }
      const CutParts isotropic =
          split(outside, {.zero = {frame->to.square}}, may_vanish(round.system));
      for (const Set& set : isotropic.inside)
        left.push_back(piece.on(set));
      for (const Set& set : isotropic.outside)
        followers.push_back({piece.on(set), of, frame->to});
    }
  }
  round.pieces = std::move(left);
  round.only_special_values = has_only_special_values(round);
  std::move(followers.begin(), followers.end(), std::back_inserter(b.followers));
}

namespace {

bool has_leading_part(const Board& b, const Round& round, Order order) {
  return !round.pieces.empty() && b.options.search_solutions && b.options.leading_parts &&
         has_bracket_of_e3(round.system.field) && free_parameters(round.system) > 0 &&
         leading_part(round.system, order);
}

} // namespace

std::vector<Task> leading(const Board& b, const Round& round) {
  return one_if(!round.last && has_leading_part(b, round, Order::lowest),
                "the part of lowest order");
}
std::vector<Task> highest(const Board& b, const Round& round) {
  return one_if(!round.last && has_leading_part(b, round, Order::highest),
                "the part of highest order");
}

namespace {

// Polynomials that must not vanish in most of them come first: special values of some are not cut
// out of the rest.
std::vector<Preimage> said_by_all(const System& s, const LeadingPart& part,
                                  const std::vector<ClassifiedStratum>& strata) {
  std::vector<Preimage> all;
  for (const ClassifiedStratum& x : strata)
    if (auto here = said_by(s, part, x)) all.push_back(*std::move(here));
  using List = std::vector<MPoly>;
  const auto frequency = [&](const List& f) {
    return std::ranges::count_if(all,
                                 [&](const Preimage& c) { return is_among(f, c.not_all_zero); });
  };
  for (Preimage& c : all) {
    auto sorted = c.not_all_zero;
    std::ranges::stable_sort(
        sorted, [&](const List& f, const List& g) { return frequency(f) > frequency(g); });
    c.not_all_zero = std::move(sorted);
  }
  return all;
}

void study_part(Board& b, Round& round, const Task& task, Order order, const Budget& budget) {
  const auto part = leading_part(round.system, order);
  ClassifyOptions options = b.options;
  options.check.decide.budget = budget;
  options.leading_parts = false;
  options.so_far = {};
  const StatedSolutions none;
  const SystemClassification c = classify_in_these_variables(part->system, options, none);
  const auto said = said_by_all(round.system, *part, c.strata);
  const auto take_strata = [&] {
    for (const Preimage& here : said)
      for (Undecided& piece : cut(round.pieces, here, may_vanish(round.system))) {
        ClassifiedStratum y = here.stratum;
        y.where = std::move(piece.where);
        b.result.strata.push_back(std::move(y));
      }
  };
  take_strata();
  std::vector<Undecided> left;
  for (const Undecided& piece : round.pieces)
    std::ranges::move(met(b, round, piece), std::back_inserter(left));
  round.pieces = std::move(left);
  take_strata(); // at common values
  note(round, task.name, "says nothing here");
  round.only_special_values = has_only_special_values(round);
}

} // namespace

void study_leading(Board& b, Round& round, const Task& task, const Budget& budget) {
  study_part(b, round, task, Order::lowest, budget);
}
void study_highest(Board& b, Round& round, const Task& task, const Budget& budget) {
  study_part(b, round, task, Order::highest, budget);
}

std::vector<Task> splitting(const Board& b, const Round& round) {
  return one_if(!round.pieces.empty() && b.options.search_solutions && !round.last &&
                    free_body(round.system),
                "splitting of separatrices");
}

void study_splitting(Board& b, Round& round, const Task& task, const Budget& budget) {
  if (auto found = find_splitting(round.system, budget)) {
    for (const auto& [i, value] : solve(round.whole.where).values) // they are put into the system
      found->at.emplace_back(round.system.ring()->name(i), to_string(value));
    exclude(b, round, exclusion(round.system, *found));
    round.only_special_values = has_only_special_values(round);
  } else {
    note(round, task.name, "the criterion says nothing for all directions");
  }
}

} // namespace kov::stages
