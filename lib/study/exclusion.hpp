#pragma once
// From the answer along one particular solution, in the parameters and the levels, to the
// parameters that it excludes.
//
// One level is enough: a condition p(parameters, level) != 0 holds for some level unless all
// coefficients of p vanish, and a difference that depends on the level is not special for all of
// them.
//
// Source  docs/theory/classify.md (1, 2)

#include "integrability/report.hpp"
#include "jets/obstruction.hpp"
#include "quadratures/obstruction.hpp"
#include "study/classification.hpp"

namespace kov {

/// The system is not integrable where all of this holds, in the ring of the system.
struct Exclusion : Cut {
  ExclusionReason by = {};
  std::vector<std::size_t> constants = {}; ///< algebraic, in which the reason may be written
  std::optional<ManifoldSpec> along = {};  ///< the invariant set of the solutions, if there is one
  std::shared_ptr<const study::Evidence> from = {}; ///< the study along it
  std::shared_ptr<const SplittingFinding> splitting = {};
};

/// All that the report proves.  levels: the parameters of which one may choose the value.
[[nodiscard]] std::vector<Exclusion> exclusions(const System& s, const ManifoldReport& report,
                                                const std::vector<std::size_t>& levels);

/// The same; where the verdict says that no parameters are left, just that.
[[nodiscard]] std::vector<Exclusion> exclusions_of_verdict(const System& s,
                                                           const ManifoldReport& report,
                                                           const std::vector<std::size_t>& levels);

/// The exclusion by an obstruction of higher order along m; nothing if there is none.
[[nodiscard]] std::optional<Exclusion> exclusion_of(const System& s, const ManifoldSpec& m,
                                                    const jets::HigherOrders& orders);

/// The same by quadratures, of a system without parameters.
[[nodiscard]] Exclusion exclusion_of(const ManifoldSpec& m, const QuadratureObstruction& o);

} // namespace kov
