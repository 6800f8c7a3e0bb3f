#include "variation/normal.hpp"

#include "exact/error.hpp"
#include "support/random.hpp"
#include "variation/systems.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

using namespace testing;

std::vector<std::string> with(std::vector<std::string> names,
                              const std::vector<std::string>& more) {
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

// X(x + e xi) = X(x) + e J xi + O(e^2): the expansion itself, no derivative taken.
TEST(VariationalEquations, AreTheFirstOrderOfTheFlowInEpsilon) {
  for (const OnManifold& s : all_systems()) {
    const std::size_t n = s.v().dimension();
    std::vector<std::string> names{"epsilon"};
    for (std::size_t i = 0; i < n; ++i)
      names.push_back("xi" + std::to_string(i));
    const Ring wide = make_ring(with(s.v().ring->names(), names));
    const MFraction epsilon = MFraction::variable(wide, "epsilon");
    std::vector<MFraction> xi;
    Substitution moved;
    Substitution solved;
    for (std::size_t i = 0; i < n; ++i) {
      xi.push_back(MFraction::variable(wide, names[i + 1]));
      const std::size_t x = wide->index(s.v().name(i));
      moved[x] = MFraction::variable(wide, x) + epsilon * xi[i];
    }
    for (const auto& [i, value] : s.m.solved)
      solved[wide->index(s.v().ring->name(i))] = transfer(value, wide);
    const LinearSystem linear = variational_equations(s.v(), s.m);
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_EQ(linear.names[i], s.v().name(i));
      const MFraction x = transfer(s.v().components[i], wide);
      const MFraction first = substitute((substitute(x, moved) - x) / epsilon,
                                         {{wide->index("epsilon"), MFraction(wide)}});
      MFraction expected(wide);
      for (std::size_t j = 0; j < n; ++j)
        expected += transfer(linear.a[i][j], wide) * xi[j];
      // both on the manifold: where it is linear by substitution, else as an ideal membership
      const MFraction defect = substitute(first, solved) - expected;
      if (s.m.linear) {
        EXPECT_TRUE(is_zero(defect)) << to_string(defect);
        continue;
      }
      std::vector<MPoly> equations;
      std::vector<std::size_t> main;
      for (const Equation& e : s.m.equations)
        equations.push_back(transfer(e.difference, wide).num());
      for (std::size_t j = 0; j < n; ++j)
        main.push_back(wide->index(s.v().name(j)));
      EXPECT_TRUE(Ideal(wide, main, equations).contains(defect.num())) << to_string(defect);
    }
  }
}

// y_i = df_i . xi with xi' = J xi has y' = C y, for every xi.
TEST(NormalSystem, DifferentialsOfTheEquationsSatisfyIt) {
  for (const OnManifold& s : all_systems()) {
    const NormalSystem normal = normal_system(s.v(), s.m, {});
    const LinearSystem full = variational_equations(s.v(), s.m);
    const std::size_t n = s.v().dimension();
    ASSERT_EQ(normal.equations.size(), normal.system.a.size());
    EXPECT_EQ(normal.system.names.size(), normal.system.a.size());
    std::vector<std::vector<MFraction>> rows; // df_i
    for (const std::size_t i : normal.equations)
      rows.push_back(gradient(s.v(), s.m.equations[i].difference));
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t l = 0; l < n; ++l) { // the coefficient of xi_l
        MFraction left = lie_derivative(s.v(), rows[i][l]);
        for (std::size_t j = 0; j < n; ++j)
          left += rows[i][j] * full.a[j][l];
        for (std::size_t j = 0; j < rows.size(); ++j)
          left -= normal.system.a[i][j] * rows[j][l];
        EXPECT_TRUE(s.m.vanishes_on_curve(s.m.restrict(left)));
      }
  }
}

// The vector field itself solves the variational equations and is tangent to the manifold.
TEST(NormalSystem, TheFieldIsATangentialSolution) {
  for (const OnManifold& s : all_systems()) {
    const LinearSystem full = variational_equations(s.v(), s.m);
    for (std::size_t i = 0; i < s.v().dimension(); ++i) {
      MFraction defect = lie_derivative(s.v(), s.v().components[i]);
      for (std::size_t j = 0; j < s.v().dimension(); ++j)
        defect -= full.a[i][j] * s.v().components[j];
      EXPECT_TRUE(s.m.vanishes_on_curve(s.m.restrict(defect)));
    }
    for (const Equation& e : s.m.equations)
      EXPECT_TRUE(s.m.vanishes_on_curve(s.m.restrict(lie_derivative(s.v(), e.difference))));
  }
}

// Other equations of the same manifold are other coordinates of the normal bundle: with f* = A f
// the matrix is C* = (A' + A C) A^-1, that is C* A = A' + A C.  No complement is chosen anywhere.
TEST(NormalSystem, OtherEquationsGiveAGaugeTransform) {
  const struct {
    std::string equations;
    std::vector<std::vector<std::string>> a; // rows of A in terms of q1, p1
  } table[] = {{R"(["p1 = 0", "q1 = 0"])", {{"0", "1"}, {"1", "0"}}},
               {R"(["q1 + p1 = 0", "2*p1 = 0"])", {{"1", "1"}, {"0", "2"}}},
               {R"(["q1 + q2*p1 = 0", "p1 = 0"])", {{"1", "q2"}, {"0", "1"}}},
               {R"(["q1 + q2*p1 = 0", "p1 + q1 + q2*p1 = 0"])", {{"1", "q2"}, {"1", "1 + q2"}}},
               {R"(["q1 + p1^2 = 0", "p1 = 0"])", {{"1", "0"}, {"0", "1"}}}};
  const OnManifold plain = henon_heiles();
  const NormalSystem c = normal_system(plain.v(), plain.m, {});
  for (const auto& [equations, texts] : table) {
    const OnManifold s = henon_heiles(equations);
    const NormalSystem other = normal_system(s.v(), s.m, {});
    const auto value = [&](const std::string& text) { return formula(s.system, text); };
    ASSERT_EQ(other.system.a.size(), 2U) << equations;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) {
        MFraction left = s.m.restrict(-lie_derivative(s.v(), value(texts[i][j])));
        for (std::size_t l = 0; l < 2; ++l) {
          left += other.system.a[i][l] * value(texts[l][j]);
          left -= value(texts[i][l]) * transfer(c.system.a[l][j], s.v().ring);
        }
        EXPECT_TRUE(s.m.vanishes_on_curve(s.m.restrict(left))) << equations << to_string(left);
      }
  }
}

TEST(NormalSystem, AnEquationTooManyIsLeftOut) {
  const OnManifold s = henon_heiles(R"(["q1 = 0", "p1 = 0", "q1 + 3*p1 = 0"])");
  EXPECT_EQ(normal_system(s.v(), s.m, {}).equations, (std::vector<std::size_t>{0, 1}));
}

TEST(NormalSystem, EquationsAreReadWithoutMultiplicities) {
  const OnManifold s = henon_heiles(R"(["q1^2 = 0", "p1 = 0"])");
  const OnManifold plain = henon_heiles(R"(["q1 = 0", "p1 = 0"])");
  const auto matrix = [](const OnManifold& x) { // as text: the two files have two rings
    std::string text;
    for (const auto& row : normal_system(x.v(), x.m, {}).system.a)
      for (const auto& entry : row)
        text += to_string(entry) + "; ";
    return text;
  };
  EXPECT_EQ(matrix(s), matrix(plain));
}

// c . y is constant for y' = C y, and what is left on its zero level is the original system there.
TEST(Reduction, LinearIntegralsAreIntegralsAndTheirZeroLevelIsTheReducedSystem) {
  const OnManifold s = with_integral();
  for (const SystemClaim& claim : s.system.claims)
    EXPECT_TRUE(is_zero(lie_derivative(s.v(), claim.value)));
  const NormalSystem normal = normal_system(s.v(), s.m, s.system.claims);
  ASSERT_EQ(normal.integrals.size(), 1U); // dE is tangential
  EXPECT_EQ(normal.integrals[0].name, "F");
  const auto& c = normal.integrals[0].coefficients;
  for (std::size_t j = 0; j < 3; ++j) {
    MFraction defect = lie_derivative(s.v(), c[j]);
    for (std::size_t i = 0; i < 3; ++i)
      defect += c[i] * normal.system.a[i][j];
    EXPECT_TRUE(is_zero(s.m.restrict(defect)));
  }
  const ReducedSystem reduced = reduce_by_integrals(s.v(), s.m, normal, {"w", "s"});
  ASSERT_EQ(reduced.eliminations.size(), 1U);
  EXPECT_EQ(reduced.eliminations[0].unknown, "u");
  EXPECT_EQ(reduced.system.names, (std::vector<std::string>{"w", "s"}));
  // u = -x w: w' = x s, s' = (1 - x) w
  const auto is = [&](const MFraction& f, const std::string& text) {
    EXPECT_EQ(s.m.restrict(f), s.m.restrict(formula(s.system, text)));
  };
  is(reduced.system.a[0][0], "0");
  is(reduced.system.a[0][1], "x");
  is(reduced.system.a[1][0], "1 - x");
  is(reduced.system.a[1][1], "0");
}

TEST(Reduction, UnknownsToKeepAreKept) {
  const OnManifold s = with_integral();
  const NormalSystem normal = normal_system(s.v(), s.m, s.system.claims);
  const ReducedSystem kept = reduce_by_integrals(s.v(), s.m, normal, {"u", "w", "s"});
  EXPECT_TRUE(kept.eliminations.empty());
  EXPECT_EQ(kept.system.a, normal.system.a);
  const ReducedSystem other = reduce_by_integrals(s.v(), s.m, normal, {"u"});
  ASSERT_EQ(other.eliminations.size(), 1U);
  EXPECT_EQ(other.eliminations[0].unknown, "w"); // the last one that occurs and may go
  EXPECT_FALSE(other.divisors.empty());          // divided by x
}

TEST(Reduction, AWrongIntegralIsNoticed) {
  const OnManifold s = with_integral();
  NormalSystem normal = normal_system(s.v(), s.m, s.system.claims);
  normal.integrals[0].coefficients[2] = MFraction(s.v().ring, Rational(1));
  EXPECT_THROW((void)reduce_by_integrals(s.v(), s.m, normal, {}), DomainError);
}

// Random patterns of zeros: the blocks are the classes of mutual reachability, each after those
// that it uses.
TEST(Blocks, AreTheStronglyConnectedPartsInOrder) {
  const OnManifold s = henon_heiles();
  test::random_rounds(40, [&](test::Random& random) {
    const auto n = static_cast<std::size_t>(random.between(1, 6));
    LinearSystem linear;
    linear.a.assign(n, std::vector<MFraction>(n, MFraction(s.v().ring)));
    for (auto& row : linear.a)
      for (auto& entry : row)
        if (random.once_in(4)) entry = MFraction::variable(s.v().ring, "q2");
    const auto uses = [&](std::size_t i, std::size_t j) { return !is_zero(linear.a[i][j]); };
    const auto reaches = [&](std::size_t from, std::size_t to) { // depth first
      std::vector<bool> seen(n);
      std::vector<std::size_t> stack{from};
      while (!stack.empty()) {
        const std::size_t i = stack.back();
        stack.pop_back();
        if (i == to) return true;
        if (seen[i]) continue;
        seen[i] = true;
        for (std::size_t j = 0; j < n; ++j)
          if (uses(i, j)) stack.push_back(j);
      }
      return false;
    };
    const auto found = blocks(linear, s.m);
    std::vector<std::size_t> place(n, n);
    for (std::size_t b = 0; b < found.size(); ++b) {
      EXPECT_TRUE(std::is_sorted(found[b].begin(), found[b].end()));
      for (const std::size_t i : found[b]) {
        EXPECT_EQ(place[i], n); // in one block only
        place[i] = b;
      }
    }
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        EXPECT_EQ(place[i] == place[j], reaches(i, j) && reaches(j, i));
        if (uses(i, j)) {
          EXPECT_LE(place[j], place[i]);
        }
      }
  });
}

// y1'' + a1 y1' + a0 y1 = 0 holds identically in y1, y2, where y' = A y.
TEST(ScalarEquation, FollowsFromTheBlock) {
  const auto check = [](const OnManifold& s, const LinearSystem& linear,
                        const std::vector<std::size_t>& block, std::size_t unknown) {
    const auto e = scalar_equation(s.v(), s.m, linear, block, unknown);
    ASSERT_TRUE(e);
    EXPECT_EQ(e->unknown, linear.names[unknown]);
    const std::size_t other = block[0] == unknown ? block[1] : block[0];
    for (const std::size_t l : block) { // the coefficient of y_l
      MFraction sum = lie_derivative(s.v(), linear.a[unknown][l]);
      for (const std::size_t j : {unknown, other})
        sum += linear.a[unknown][j] * linear.a[j][l];
      sum += e->a1 * linear.a[unknown][l];
      if (l == unknown) sum += e->a0;
      EXPECT_TRUE(s.m.vanishes_on_curve(s.m.restrict(sum))) << to_string(sum);
    }
  };
  const OnManifold hh = henon_heiles();
  const LinearSystem plain = normal_system(hh.v(), hh.m, {}).system;
  check(hh, plain, {0, 1}, 0);
  check(hh, plain, {0, 1}, 1);
  const OnManifold mixed = henon_heiles(R"(["q1 + q2*p1 = 0", "p1 = 0"])");
  const LinearSystem other = normal_system(mixed.v(), mixed.m, {}).system;
  check(mixed, other, {0, 1}, 0);
  check(mixed, other, {0, 1}, 1);
  const OnManifold limit_cycle = circle();
  check(limit_cycle, normal_system(limit_cycle.v(), limit_cycle.m, {}).system, {1, 2}, 1);
  const OnManifold integral = with_integral();
  const NormalSystem normal = normal_system(integral.v(), integral.m, integral.system.claims);
  const LinearSystem reduced =
      reduce_by_integrals(integral.v(), integral.m, normal, {"w", "s"}).system;
  check(integral, reduced, {0, 1}, 0);
  check(integral, reduced, {0, 1}, 1);
}

TEST(ScalarEquation, AnUnknownWhoseDerivativeIsItsOwnIsNotCyclic) {
  const OnManifold s = henon_heiles();
  LinearSystem linear;
  linear.names = {"a", "b"};
  const MFraction q = MFraction::variable(s.v().ring, "q2");
  const MFraction none(s.v().ring);
  linear.a = {{q, none}, {q, q}};
  EXPECT_FALSE(scalar_equation(s.v(), s.m, linear, {0, 1}, 0));
  EXPECT_TRUE(scalar_equation(s.v(), s.m, linear, {0, 1}, 1));
}

} // namespace
} // namespace kov
