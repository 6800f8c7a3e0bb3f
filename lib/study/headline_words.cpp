#include "study/headline_words.hpp"

#include "integrability/conclude.hpp"

namespace kov::study {

std::string headline(Verdict v) {
  switch (v) {
  case Verdict::non_integrable:
    return "NON-INTEGRABLE";
  case Verdict::integrable:
    return "INTEGRABLE";
  case Verdict::no_obstruction:
    return "NO OBSTRUCTION";
  case Verdict::depends:
    return "DEPENDS ON THE PARAMETERS";
  case Verdict::undecided:
    return "UNDECIDED";
  case Verdict::failed:
    return "NOT STUDIED";
  }
  return "";
}

HeadlineWords in_words(const ManifoldReport& m) {
  if (m.failure) // a value that should vanish, or a set that is no curve
    return {is_zero(m.failure->value) ? headline(Verdict::failed) : "NOT AN INVARIANT MANIFOLD",
            {},
            m.failure->message};
  const std::string words = headline(m.verdict), of = m.by ? m.by->id() : "";
  if (m.verdict == Verdict::non_integrable) return {words, {}, of + ": " + statement(m)};
  if (m.verdict == Verdict::no_obstruction)
    return {
        words, {}, "the first-order test of " + of + " passes; this does not prove integrability"};
  const bool depends = m.verdict == Verdict::depends;
  std::string except = exceptions(m, !depends); // a limit left these parameters
  if (except.empty()) return {words, {}, depends ? of : ""};
  return {headline(Verdict::non_integrable), std::move(except), of + ": " + statement(m)};
}

HeadlineWords in_words(const CurveStudy& m) {
  if (m.together) // each set by one of its exclusions
    return {headline(Verdict::non_integrable),
            {},
            "not integrable with " + first_integrals(m.together->excluded)};
  if (!m.higher || !m.higher->excluded) return in_words(m.first);
  const ExclusionReason& by = m.higher->excluded->by;
  return {headline(Verdict::non_integrable) + " at order " + std::to_string(by.order),
          exceptions(*m.higher, m.headline.verdict == Verdict::undecided),
          by.theorems.front()->name + ": " + statement(by) +
              (by.level.empty() ? "" : ", " + sentence(by.level))};
}

HeadlineWords in_words(Verdict together, bool excludes) {
  if (together == Verdict::no_obstruction)
    return {headline(together),
            {},
            "the tests pass along all of them; this does not prove integrability"};
  const bool in_part = together == Verdict::undecided && excludes;
  return {headline(together) + (in_part ? " IN PART" : "")};
}

std::string one_line(const HeadlineWords& h) {
  const std::string except = h.except.empty() ? "" : "; nothing is known about the exceptions";
  return h.verdict + (h.except.empty() ? "" : ", " + h.except) +
         (h.because.empty() ? "" : " (" + h.because + except + ")");
}

} // namespace kov::study
