#include "verdict/decide.hpp"

#include "exact/error.hpp"
#include "galois/classify.hpp"
#include "galois/solutions.hpp"

namespace kov {
namespace {

Solution printed(const LiouvillianSolution& s, const std::string& variable) {
  Solution out;
  out.note = s.note;
  if (s.exponential) {
    out.kind = "exponential";
    out.y = s.text;
    const auto& [theta, p] = *s.exponential;
    out.omega = to_string(theta, variable);
    if (degree(p) > 0)
      out.omega = (is_zero(theta) ? "" : out.omega + " + ") +
                  to_string(RationalFunction::from_coprime(derivative(p), p), variable);
  } else {
    out.kind = "minimal-polynomial";
    for (const RationalFunction& c : s.minimal_polynomial)
      out.minimal_polynomial.push_back(to_string(c, variable));
  }
  return out;
}

} // namespace

Decision decide(const NormalForm& equation, const Options& options) {
  const auto start = Budget::Clock::now();
  Decision d;
  d.r = equation.r;
  d.variable = options.variable;
  const Classification c = classify(equation.r, options.budget);
  d.group = c.group;
  d.component = c.component;
  d.abelian = c.abelian;
  d.reason = c.reason;
  d.undecided = c.undecided;
  if (c.group) d.kovacic_case = kovacic_case(*c.group);
  if (options.want_solutions) {
    try {
      for (const LiouvillianSolution& s : solutions(c, equation.r, d.variable, options.budget))
        d.solutions.push_back(printed(s, d.variable));
    } catch (const OutOfBudget& limit) {
      d.reason += "; solutions not printed: " + std::string(limit.what());
    }
  }
  d.seconds = std::chrono::duration<double>(Budget::Clock::now() - start).count();
  return d;
}

} // namespace kov
