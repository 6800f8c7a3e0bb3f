#pragma once
// The headline of an answer in words: "NON-INTEGRABLE at order 3, except where C = A (Morales-Ramis-Simo: ...)".

#include "study/study.hpp"

namespace kov::study {

struct HeadlineWords {
  std::string verdict;      ///< "NON-INTEGRABLE at order 3"
  std::string except = {};  ///< "except where C = A": nothing is known there; empty: no exceptions
  std::string because = {}; ///< "Morales-Ramis: not integrable with ..."; empty: nothing is proved
};
/// NON-INTEGRABLE, NO OBSTRUCTION, DEPENDS ON THE PARAMETERS, ...
/// Example headline(Verdict::no_obstruction)  // -> NO OBSTRUCTION
[[nodiscard]] std::string headline(Verdict v);
/// By the first variational equation.
[[nodiscard]] HeadlineWords in_words(const ManifoldReport& m);
/// By all orders.
[[nodiscard]] HeadlineWords in_words(const CurveStudy& m);
/// By all manifolds together, some of which exclude something or not.
[[nodiscard]] HeadlineWords in_words(Verdict together, bool excludes);
[[nodiscard]] std::string one_line(const HeadlineWords& h);

} // namespace kov::study
