#pragma once
// What the tests of the paper share.  Formulas are typed as printed, with the corrections of the
// list of errata that stands beside each; they are compared as exact functions, never as text.

#include "support/checked.hpp"
#include "support/source_dir.hpp"

#include <gtest/gtest.h>

namespace kov::lemmas {

inline System sliding_top(const std::string& file, const ParameterValues& values = {}) {
  return read_system(test::in_source("/cases/sliding_top/") + file, values);
}

/// The stages of the one manifold of a file, without the group.
inline ManifoldReport stages(const System& s) {
  CheckOptions options;
  options.stop_at_r = true;
  EXPECT_EQ(s.manifolds.size(), 1U);
  ManifoldReport m = test::checked(study::FileStudy(s), options);
  EXPECT_FALSE(m.failure) << m.failure->message;
  return m;
}

inline testing::AssertionResult equal(const MFraction& a, const MFraction& b) {
  if (a == b) return testing::AssertionSuccess();
  return testing::AssertionFailure() << brief(a) << "  is not  " << brief(b);
}

/// Equality of functions on the phase curve.
inline testing::AssertionResult equal_on_curve(const ManifoldReport& m, const MFraction& a,
                                               const MFraction& b) {
  if (m.manifold->vanishes_on_curve(a - b)) return testing::AssertionSuccess();
  return testing::AssertionFailure() << brief(a) << "  is not  " << brief(b) << "  on the curve";
}

inline const AlgebraicOde& equation(const ManifoldReport& m) {
  for (const auto& b : m.blocks)
    if (b.ode) return *b.ode;
  throw InvalidArgument("no equation was found");
}

inline const NormalVariationalEquation& scalar(const ManifoldReport& m) {
  for (const auto& b : m.blocks)
    if (!b.scalar.empty()) return b.scalar.front();
  throw InvalidArgument("no scalar equation was found");
}

} // namespace kov::lemmas
