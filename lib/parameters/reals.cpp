#include "parameters/reals.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <unordered_map>

#include <z3++.h>

namespace kov {
namespace {

z3::expr number(z3::context& z3, const Integer& n) { return z3.real_val(to_string(n).c_str()); }

z3::expr polynomial(z3::context& z3, const MPoly& p) {
  z3::expr sum = z3.real_val(0);
  for (long i = 0; i < p.length(); ++i) {
    z3::expr term = number(z3, p.coefficient(i));
    const auto e = p.exponents(i);
    for (std::size_t k = 0; k < e.size(); ++k)
      for (unsigned long j = 0; j < e[k]; ++j)
        term = term * z3.real_const(p.ring()->name(k).c_str());
    sum = sum + term;
  }
  return sum;
}

z3::expr formula(z3::context& z3, const Condition& c) {
  const z3::expr p = polynomial(z3, c.p);
  const z3::expr zero = z3.real_val(0);
  switch (c.sign) {
  case Sign::zero:
    return p == zero;
  case Sign::nonzero:
    return p != zero;
  case Sign::positive:
    return p > zero;
  default:
    return p >= zero;
  }
}

// Z3 counts its own steps, which take from some ten nanoseconds to a millisecond each: few are enough
// for what is asked here, and more would not be an answer soon.
constexpr double units_per_step = 200,
                 units_per_question = 1e4; // of the meter (docs/theory/work.md)
constexpr double steps_per_work = 2e-3;    // of one search: 2e5 steps

z3::solver limited_solver(z3::context& z3, const Budget& budget) {
  z3::solver solver = z3::tactic(z3, "qfnra-nlsat").mk_solver();
  z3::params limits(z3);
  limits.set("rlimit",
             static_cast<unsigned>(std::clamp(budget.max_work * steps_per_work, 1.0, 4e9)));
  limits.set("ctrl_c", false); // or Z3 takes an interrupt of ours for its own, and nobody sees it
  solver.set(limits);
  return solver;
}

double steps_of(const z3::solver& solver) {
  const z3::stats all = solver.statistics();
  for (unsigned i = 0; i < all.size(); ++i)
    if (all.key(i) == "rlimit count") return all.uint_value(i);
  return 0;
}

// The answer; unknown at the limit of steps.   Errors  OutOfBudget: the clock, or a stop
z3::check_result answer_of(z3::context& z3, z3::solver& solver, const Budget& budget) {
  using namespace std::chrono_literals;
  budget.check();
  std::jthread watcher;
  if (budget.deadline || budget.stop.stop_possible())
    watcher = std::jthread([&](const std::stop_token& done) {
      std::mutex mutex;
      std::unique_lock lock(mutex);
      std::condition_variable_any bell;
      while (!bell.wait_for(lock, done, 5ms, [&] { return done.stop_requested(); }))
        if (budget.is_cut_short()) z3.interrupt();
    });
  const z3::check_result answer = solver.check();
  if (watcher.joinable()) watcher = {}; // no interrupt after this
  charge(units_per_question + units_per_step * steps_of(solver));
  if (answer == z3::unknown) budget.check();
  return answer;
}

Truth ask(const std::vector<Condition>& conditions, const Budget& budget) {
  try {
    z3::context z3;
    z3::solver solver = limited_solver(z3, budget);
    for (const Condition& c : conditions)
      solver.add(formula(z3, c));
    switch (answer_of(z3, solver, budget)) {
    case z3::sat:
      return Truth::yes;
    case z3::unsat:
      return Truth::no;
    default:
      return Truth::unknown;
    }
  } catch (const z3::exception&) {
    budget.check(); // an answer that was cut short is not kept
    return Truth::unknown;
  }
}

// The text of all that decides the answer, and of the work after which there is none.
std::string question(const std::vector<Condition>& conditions, const Budget& budget) {
  std::string text = std::to_string(budget.max_work);
  for (const Condition& c : conditions)
    text += "; " + to_string(c);
  return text;
}

} // namespace

// One search asks the same again and again (four times of five): the answer is kept, with its work, so
// that what was asked before changes no later limit.
Truth has_real_point(const std::vector<Condition>& conditions, const Budget& budget) {
  struct KeptAnswer {
    Truth truth;
    double work;
  };
  constexpr std::size_t most_answers = 10'000;
  static thread_local std::unordered_map<std::string, KeptAnswer> answers;
  std::string key = question(conditions, budget);
  if (const auto known = answers.find(key); known != answers.end()) {
    budget.check();
    charge(known->second.work);
    return known->second.truth;
  }
  const double before = meter();
  const Truth truth = ask(conditions, budget);
  if (answers.size() == most_answers) answers.clear();
  answers.emplace(std::move(key), KeptAnswer{truth, meter() - before});
  return truth;
}

} // namespace kov
