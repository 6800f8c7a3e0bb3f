#include "classify/stages.hpp"

#include "classify/darboux_points.hpp"
#include "classify/faces.hpp"
#include "study/study.hpp"

#include <utility>

namespace kov::stages {
namespace {

bool is_looked_at(const Board& b, const Round& round) {
  return !round.pieces.empty() && b.options.search_solutions;
}

} // namespace

std::vector<Task> darboux_points_first(const Board& b, const Round& round) {
  return one_if(is_looked_at(b, round) && has_many_parameters(round.system, round.levels),
                "Darboux points");
}
std::vector<Task> darboux_points(const Board& b, const Round& round) {
  return one_if(is_looked_at(b, round) && !has_many_parameters(round.system, round.levels),
                "Darboux points");
}

void study_darboux_points(Board& b, Round& round, const Task& /*task*/, const Budget& budget) {
  for (const Exclusion& e : exclusions_by_darboux_points(round.system, budget))
    exclude(b, round, e);
}

std::vector<Task> faces(const Board& b, const Round& round) {
  return one_if(is_looked_at(b, round) && exponential_coordinates(round.studied().system),
                "where exponentials are 0");
}

void study_faces(Board& b, Round& round, const Task& /*task*/, const Budget& budget) {
  CheckOptions check = b.options.check;
  check.decide.budget = budget;
  for (Exclusion& e : exclusions_at_faces(round.studied().system, check))
    exclude(b, round, round.before(std::move(e)));
}

std::vector<Task> higher_orders(const Board& b, const Round& round) {
  std::vector<Task> all;
  if (b.options.order > 1 && !round.pieces.empty())
    for (const ManifoldSpec& m : round.solutions)
      all.push_back({"orders 2.." + std::to_string(b.options.order) + " along " + m.name, m});
  return all;
}

void study_higher_orders(Board& b, Round& round, const Task& task, const Budget& budget) {
  Options decide = b.options.check.decide;
  decide.budget = budget;
  const System& s = round.studied().system;
  study::HigherOrders h = study::higher_orders(s, *task.along, b.options.order, decide);
  const std::string order = "VE_" + std::to_string(h.excluded ? h.excluded->by.order : h.up_to);
  const std::string why = h.excluded              ? order + " excludes no more"
                          : h.planes.open.empty() ? "no logarithm at infinity up to " + order
                                                  : h.planes.open;
  if (h.excluded) {
    h.excluded->constants = adjoined_constants(s);
    h.excluded->along = round.before(*task.along);
    Exclusion e = round.before(*std::move(h.excluded));
    study::CurveStudy found;
    found.first.name = task.along->name;
    found.higher = std::move(h);
    e.from = std::make_shared<const study::Evidence>(s, std::move(found));
    exclude(b, round, e);
  }
  note(round, task.name, why);
}

std::vector<Task> exceptions(const Board& /*b*/, const Round& round) {
  return one_if(!round.late.empty(), "exceptions");
}

void tell_exceptions(Board& b, Round& round, const Task& /*task*/, const Budget& /*budget*/) {
  for (const Exclusion& e : std::exchange(round.late, {}))
    exclude(b, round, e);
}

} // namespace kov::stages
