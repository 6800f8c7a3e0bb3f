#include "kovacic/solve.hpp"

#include "exact/overloaded.hpp"
#include "kovacic/case1.hpp"
#include "kovacic/case2.hpp"
#include "kovacic/case3.hpp"
#include "kovacic/necessary.hpp"

namespace kov::kovacic {
namespace {

void note_condition(Trace* trace, int number, bool possible, const std::string& why) {
  note(trace, number, 0,
       "Case " + std::to_string(number) + (possible ? " is possible." : " is excluded. " + why));
}

Outcome cases(const Singularities& s, const Budget& budget, Trace* trace) {
  const Conditions possible = necessary_conditions(s);
  note_condition(trace, 1, possible.case1, possible.why_not1);
  if (possible.case1)
    if (auto found = case1(s, budget, trace)) return *found;
  note_condition(trace, 2, possible.case2, possible.why_not2);
  if (possible.case2)
    if (auto found = case2(s, budget, trace)) return *found;
  note_condition(trace, 3, possible.case3, possible.why_not3);
  if (possible.case3)
    if (auto found = case3(s, budget, trace)) return *found;
  note(trace, 0, 3, "None of the three cases holds: the Galois group is SL(2, C).");
  return NoLiouvillian{};
}

template <class F> Outcome within_budget(Trace* trace, F&& f) {
  try {
    return f();
  } catch (const OutOfBudget& limit) {
    note(trace, 0, 0, std::string("Stopped: ") + limit.what() + ".");
    return Unable{Unable::Why::budget, limit.what()};
  }
}

} // namespace

Outcome solve(const Singularities& s, const Budget& budget, Trace* trace) {
  return within_budget(trace, [&] { return cases(s, budget, trace); });
}

Outcome solve(const RationalFunction& r, const Budget& budget, Trace* trace) {
  if (is_zero(r)) // 1 and z
    return ExponentialPair{RationalFunction(Poly::z()), NfElem(1), true};
  return within_budget(trace, [&] { return cases(singularities(r, budget), budget, trace); });
}

Outcome solve(const NormalForm& equation, const Budget& budget, Trace* trace) {
  return solve(equation.r, budget, trace);
}

std::optional<int> case_of(const Outcome& outcome) {
  return std::visit(Overloaded{[](const Exponential&) { return std::optional(1); },
                               [](const ExponentialPair&) { return std::optional(1); },
                               [](const Imprimitive&) { return std::optional(2); },
                               [](const ImprimitiveTriple&) { return std::optional(2); },
                               [](const Algebraic&) { return std::optional(3); },
                               [](const NoLiouvillian&) { return std::optional(4); },
                               [](const Unable&) { return std::optional<int>(); }},
                    outcome);
}

} // namespace kov::kovacic
