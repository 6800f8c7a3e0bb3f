// The table of Morales-Ruiz and Ramis for homogeneous potentials, computed, against the print.

#include "closed/potential.hpp"

#include "decide/decide.hpp"
#include "decide/words.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace kov::potential_test {
namespace {

Rational q(long n, long d = 1) { return {Integer(n), Integer(d)}; }

// [MoralesRamis2001], table (1), as printed: lambda = f(k, p).
using Family = Rational (*)(const Rational& k, const Rational& p);
std::vector<Family> published(long k) {
  std::vector<Family> rows{
      [](const Rational& d, const Rational& p) { return p + p * (p - q(1)) * d / q(2); },
      [](const Rational& d, const Rational& p) {
        return q(1, 2) * ((d - q(1)) / d + p * (p + q(1)) * d);
      }};
  const auto add = [&](Family f) { rows.push_back(f); };
  if (k == -5) {
    add([](const Rational&, const Rational& p) {
      const Rational s = q(10, 3) + q(10) * p;
      return q(49, 40) - q(1, 40) * s * s;
    });
    add([](const Rational&, const Rational& p) {
      const Rational s = q(4) + q(10) * p;
      return q(49, 40) - q(1, 40) * s * s;
    });
  }
  if (k == -4)
    add([](const Rational&, const Rational& p) {
      const Rational s = q(4, 3) + q(4) * p;
      return q(9, 8) - q(1, 8) * s * s;
    });
  if (k == -3) {
    add([](const Rational&, const Rational& p) {
      const Rational s = q(2) + q(6) * p;
      return q(25, 24) - q(1, 24) * s * s;
    });
    add([](const Rational&, const Rational& p) {
      const Rational s = q(3, 2) + q(6) * p;
      return q(25, 24) - q(1, 24) * s * s;
    });
    add([](const Rational&, const Rational& p) {
      const Rational s = q(6, 5) + q(6) * p;
      return q(25, 24) - q(1, 24) * s * s;
    });
    add([](const Rational&, const Rational& p) {
      const Rational s = q(12, 5) + q(6) * p;
      return q(25, 24) - q(1, 24) * s * s;
    });
  }
  if (k == 3) {
    add([](const Rational&, const Rational& p) {
      const Rational s = q(2) + q(6) * p;
      return q(-1, 24) + q(1, 24) * s * s;
    });
    add([](const Rational&, const Rational& p) {
      const Rational s = q(3, 2) + q(6) * p;
      return q(-1, 24) + q(1, 24) * s * s;
    });
    add([](const Rational&, const Rational& p) {
      const Rational s = q(6, 5) + q(6) * p;
      return q(-1, 24) + q(1, 24) * s * s;
    });
    add([](const Rational&, const Rational& p) {
      const Rational s = q(12, 5) + q(6) * p;
      return q(-1, 24) + q(1, 24) * s * s;
    });
  }
  if (k == 4)
    add([](const Rational&, const Rational& p) {
      const Rational s = q(4, 3) + q(4) * p;
      return q(-1, 8) + q(1, 8) * s * s;
    });
  if (k == 5) {
    add([](const Rational&, const Rational& p) {
      const Rational s = q(10, 3) + q(10) * p;
      return q(-9, 40) + q(1, 40) * s * s;
    });
    add([](const Rational&, const Rational& p) {
      const Rational s = q(4) + q(10) * p;
      return q(-9, 40) + q(1, 40) * s * s;
    });
  }
  return rows;
}

TEST(Potential, TheTableIsThePublishedOne) {
  for (long k = -12; k <= 12; ++k) {
    if (k == 0) continue;
    const EigenvalueTable table = eigenvalue_table(k);
    EXPECT_EQ(table.all, k == 2 || k == -2) << k;
    if (table.all) continue;
    const auto print = published(k);
    for (const Family f : print) // every printed value is in one of our families, ...
      for (long p = -12; p <= 12; ++p) {
        const Rational lambda = f(q(k), q(p));
        EXPECT_TRUE(std::any_of(table.families.begin(), table.families.end(),
                                [&](const auto& x) { return x.contains(lambda); }))
            << k << ": " << to_string(lambda);
      }
    for (const EigenvalueFamily& ours : table.families) // ... and the other way round
      for (long p = -4; p <= 4; ++p) {
        const Rational lambda = ours.at(Integer(p));
        EXPECT_TRUE(ours.contains(lambda));
        EXPECT_TRUE(std::any_of(print.begin(), print.end(),
                                [&](const Family f) {
                                  for (long i = -12; i <= 12; ++i)
                                    if (f(q(k), q(i)) == lambda) return true;
                                  return false;
                                }))
            << k << ": " << to_string(lambda);
      }
    // k = 1, -1: the two general rows are one
    EXPECT_EQ(table.families.size(), std::abs(k) == 1 ? 1 : print.size()) << k;
  }
}

TEST(Potential, TheEquationHasTheseExponents) {
  for (long k = -6; k <= 6; ++k)
    for (const Rational& lambda : {q(0), q(1), q(2, 3), q(-5, 7)})
      if (k != 0) {
        EXPECT_EQ(potential_equation(k, NfElem(lambda)),
                  riemann_equation(potential_exponents(k, NfElem(lambda))));
      }
}

TEST(Potential, TheEnginesAgree) {
  Options options;
  options.want_solutions = false;
  for (const long k : {-7L, -5L, -4L, -3L, -2L, -1L, 1L, 2L, 3L, 4L, 5L, 6L}) {
    const EigenvalueTable table = eigenvalue_table(k);
    std::vector<Rational> values{q(1, 3), q(2), q(-3, 5)};
    for (const EigenvalueFamily& f : table.families)
      for (long p = -2; p <= 2; ++p)
        values.push_back(f.at(Integer(p)));
    for (const Rational& lambda : values) {
      const bool listed =
          table.all || std::any_of(table.families.begin(), table.families.end(),
                                   [&](const auto& f) { return f.contains(lambda); });
      const Decision d =
          decide({.r = potential_equation(k, NfElem(lambda)), .p = RationalFunction()}, options);
      EXPECT_EQ(d.abelian, truth(listed)) << k << ", " << to_string(lambda) << ": " << reason(d);
    }
  }
}

} // namespace
} // namespace kov::potential_test
