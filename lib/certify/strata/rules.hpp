#pragma once
// One checking function for each kind of leaf of docs/theory/strata_certificates.md.  Each refuses
// (throws Refused) or returns; none searches.

#include "certify/equation/facts.hpp"
#include "certify/strata/state.hpp"
#include "exact/truth.hpp"

namespace kov::certify {

/// The ordinary certificates inside a tree, judged by check(): the number of their trusted steps.
/// 6 `number`
std::size_t check_number(const Stratum& s, const ByNumber& leaf, bool abelian);
/// 4 `root`: at all roots x of p.
std::size_t check_root(const Stratum& s, const MPoly& p, const RootStratum& zero);

/// The recurrence of 6 for v = p prod q^e: T_0 = p, ..., T_(m+1) = 0 iff v solves Sym^m.
class InvariantRecurrence {
public:
  /// Refuses unless den = content prod q^order, orders >= 1.
  InvariantRecurrence(const Stratum& s, const MPoly& content,
                      const std::vector<InvariantPlace>& places);
  /// T_(m+1)
  [[nodiscard]] MPoly last(const MPoly& p, long m) const;

private:
  Arithmetic& a_;
  MPoly content_, S_, dS_, theta_, W_;
};

/// den = content prod q^k with content, the leading coefficients and all k as 6 and 7.1 ask.
void need_denominator(const Stratum& s, const MPoly& content,
                      const std::vector<InvariantPlace>& places);
/// The leading coefficient in z.  Requires f != 0.
[[nodiscard]] MPoly lead(const MPoly& f);

void check_invariant(const Stratum& s, const ByInvariant& leaf);
void check_places(const Stratum& s, const ByPlaces& leaf);
/// The answer of the family's criterion on the whole stratum; unknown where it depends on the
/// point, or is not shown.
[[nodiscard]] Truth check_classical(const Stratum& s, const ByClassical& leaf);

} // namespace kov::certify
