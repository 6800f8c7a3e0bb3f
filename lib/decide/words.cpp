#include "decide/words.hpp"

#include "exact/error.hpp"
#include "exact/letters.hpp"
#include "exact/overloaded.hpp"

#include <algorithm>

namespace kov {
namespace {

std::string argument(const ByFormula& by, const std::string& variable) {
  const std::string text =
      std::string("by the formula for ") + to_string(by.known.family) +
      "'s equation: " + FreshLetters(names_in_text(variable)).in(by.known.answer->reason);
  return by.engines && !by.engines->detail.empty()
             ? text + " (no search: " + by.engines->detail + ")"
             : text;
}

std::string argument(const Because& because, const std::string& variable) {
  return std::visit(Overloaded{[](std::monostate) { return std::string(); },
                               [&](const ByEngines& by) { return reason(*by.proof, variable); },
                               [](const ByKovacic&) {
                                 return std::string(
                                     "Kovacic's algorithm excludes its cases 1, 2 and 3");
                               },
                               [&](const ByFormula& by) { return argument(by, variable); }},
                    because);
}

std::string third_opinion(const ThirdOpinion& t) {
  return t.accepted ? "the judge accepts its certificate" : "no certificate: " + t.no_certificate;
}

std::string cases(int asked, int found) {
  return "case " + std::to_string(asked) + " does not occur, the equation belongs to case " +
         std::to_string(found) + ": ";
}

} // namespace

std::string to_string(const Withdrawn& why) {
  return std::visit(
      Overloaded{[](const MethodsDisagree& x) {
                   return "the methods disagree: the engines find case " +
                          std::to_string(x.engines) + ", Kovacic's algorithm finds case " +
                          std::to_string(x.kovacic);
                 },
                 [](const CertificateRefused& x) {
                   return "an answer was found" + (x.found ? ", G = " + describe(*x.found) : "") +
                          ", and our own checker refuses its certificate: " + x.by_checker;
                 }},
      why);
}

std::string to_string(const SolutionsMissing& why) {
  return why.why == SolutionsMissing::Why::not_asked_for ? "not asked for" : why.limit;
}

std::string name(const kovacic::Step& s) {
  if (s.number == whole_algorithm) return "Kovacic's algorithm";
  constexpr const char* steps[] = {"necessary conditions", "step 1, exponent sets",
                                   "step 2, families", "step 3, polynomials"};
  const std::string step = steps[std::clamp(s.number, 0, 3)];
  return s.kovacic_case == 0 ? step : "case " + std::to_string(s.kovacic_case) + ", " + step;
}

std::string reason(const Decision& d) { return reason(d, d.variable); }

std::string reason(const Decision& d, const std::string& variable) {
  if (d.withdrawn) return "undecided: " + to_string(*d.withdrawn);
  std::string text = argument(d.because, variable);
  if (d.third_opinion) text += "; " + third_opinion(*d.third_opinion);
  if (d.second_opinion)
    text += "; Kovacic's algorithm agrees: case " + std::to_string(*d.second_opinion);
  if (d.only_case && d.kovacic_case && *d.only_case != *d.kovacic_case)
    text = cases(*d.only_case, *d.kovacic_case) + text;
  return text;
}

namespace {

// Counts what is printed.
class CountedPaper {
public:
  CountedPaper(std::size_t most_bytes, const Budget& budget) : most_(most_bytes), budget_(budget) {}

  std::string operator()(std::string text) {
    budget_.check();
    used_ += text.size();
    if (most_ > 0 && used_ > most_)
      throw OutOfBudget("size limit: they take more than " + std::to_string(most_ >> 20) + " MiB");
    return text;
  }

private:
  std::size_t most_, used_ = 0;
  const Budget& budget_;
};

std::string omega_text(const ExponentialSolution& s, const std::string& variable) {
  const auto& [theta, p] = s;
  std::string text = to_string(theta, variable);
  if (degree(p) > 0)
    text = (is_zero(theta) ? "" : text + " + ") +
           to_string(RationalFunction::from_coprime(derivative(p), p), variable);
  return text;
}

} // namespace

std::vector<PrintedSolution> printed_solutions(const Decision& d, std::size_t most_bytes,
                                               const Budget& budget) {
  CountedPaper paper(most_bytes, budget);
  std::vector<PrintedSolution> all;
  for (const LiouvillianSolution& s : d.solutions) {
    PrintedSolution& out = all.emplace_back();
    if (s.exponential) {
      out.y = paper(text(s, d.variable, budget));
      out.omega = paper(omega_text(*s.exponential, d.variable));
    }
    for (const RationalFunction& c : s.minimal_polynomial)
      out.minimal_polynomial.push_back(paper(to_string(c, d.variable)));
  }
  return all;
}

} // namespace kov
