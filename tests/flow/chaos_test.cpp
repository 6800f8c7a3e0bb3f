// What is proved about the section map: enclosures against orbits in many digits that other code computes, known
// periodic orbits, homoclinic points where they are, and none where the system is integrable.

#include "flow/chaos/homoclinic.hpp"
#include "flow/chaos/krawczyk.hpp"
#include "flow/scene/system_section.hpp"
#include "support.hpp"
#include "support/source_dir.hpp"

#include "symbol/document.hpp"
#include "symbol/input_error.hpp"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

namespace kov::flow::chaos_test {
namespace {

SystemScene scene_of(const std::string& hamiltonian, const std::string& section,
                     const std::string& energy, const std::string& more = "grid = [9, 9]") {
  return read_system_scenes(
             parse_document(
                 "format = \"equation/1\"\n[system]\nkind = \"hamiltonian\"\n"
                 "coordinates = [\"x\", \"y\"]\nmomenta = [\"u\", \"v\"]\nhamiltonian = \"" +
                     hamiltonian + "\"\n[[scene]]\nsection = \"" + section +
                     "\"\nlevels = { H = \"" + energy +
                     "\" }\nplot = [\"y\", \"v\"]\nrange = [[-1, 1], [-1, 1]]\n"
                     "crossings = 1\n" +
                     more + "\n",
                 "test.toml"))
      .front();
}

const char* const henon_heiles = "(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3";

SystemScene henon_heiles_at(const std::string& energy, const std::string& more = "grid = [9, 9]") {
  return scene_of(henon_heiles, "x", energy, more);
}

Enclosure ball(const std::string& decimal) {
  Enclosure e;
  arb_set_str(e.raw(), decimal.c_str(), Enclosure::bits());
  return e.widened(Enclosure(1e-28)); // the error of that orbit is far below
}

// Time, y and v of the next crossing, in 40 digits, by the integrator of the pictures.
std::array<Enclosure, 3> crossing_of(const std::string& energy, const std::string& y,
                                     const std::string& v) {
  SystemScene s = henon_heiles_at(energy, "seeds = [[\"" + y + "\", \"" + v +
                                              "\"]]\ndigits = 40\n"
                                              "tolerance = \"10^-36\"");
  const SystemSection r = simulate(s);
  EXPECT_EQ(r.points.size(), 1U);
  std::istringstream text(r.points.at(0).digits);
  std::array<std::string, 3> part;
  text >> part[0] >> part[1] >> part[2];
  return {ball(part[0]), ball(part[1]), ball(part[2])};
}

bool meet(const Enclosure& a, const Enclosure& b) { return arb_overlaps(a.raw(), b.raw()) != 0; }

std::string dyadic(long n, int k) { return std::to_string(n) + "/2^" + std::to_string(k); }

// Boxes of width 2^-28 around random places, and four orbits in each.
TEST(EnclosedMap, ContainsOrbitsThatOtherCodeComputes) {
  const EnclosureScope scope(128);
  const SystemScene scene = henon_heiles_at("1/8");
  const SectionSurface surface(scene);
  EnclosedMap map(surface, nullptr);
  std::mt19937 gen(5);
  std::uniform_int_distribution<long> place(-200, 200), inside(-15, 15);
  int boxes = 0;
  for (int tries = 0; tries < 40 && boxes < 12; ++tries) {
    const long y0 = place(gen), v0 = place(gen); // over 2^10
    const double y = std::ldexp(static_cast<double>(y0), -10),
                 v = std::ldexp(static_cast<double>(v0), -10);
    const double u2 = 2.0 / 8 - v * v - y * y + 2 * y * y * y / 3;
    if (u2 < 0.01) continue;
    ++boxes;
    const Chart chart{{1, 3}, {0, 2}};
    const Enclosure radius(std::ldexp(1.0, -29));
    const Patch p = map.patch(chart, {Enclosure(y).widened(radius), Enclosure(v).widened(radius)},
                              {0, y, std::sqrt(u2), v});
    const Landing l = map(p);
    std::array<std::array<Enclosure, 2>, 2> start, image;
    for (int k = 0; k < 4; ++k) {
      const long dy = inside(gen), dv = inside(gen); // over 2^33: inside of the box
      const auto text = [](long base, long part) { return dyadic(base * (1L << 23) + part, 33); };
      const auto next = crossing_of("1/8", text(y0, dy), text(v0, dv));
      EXPECT_TRUE(meet(l.time, next[0]));
      EXPECT_TRUE(meet(l.at[1].v, next[1]));
      EXPECT_TRUE(meet(l.at[3].v, next[2]));
      start[k % 2] = {Enclosure(std::ldexp(static_cast<double>(dy), -33)),
                      Enclosure(std::ldexp(static_cast<double>(dv), -33))};
      image[k % 2] = {next[1], next[2]};
      if (k % 2 == 0) continue; // and the difference of two, by the mean value theorem
      const Enclosure a = start[1][0] - start[0][0], b = start[1][1] - start[0][1];
      EXPECT_TRUE(meet(image[1][0] - image[0][0], l.at[1].d[0] * a + l.at[1].d[1] * b));
      EXPECT_TRUE(meet(image[1][1] - image[0][1], l.at[3].d[0] * a + l.at[3].d[1] * b));
    }
    EXPECT_LT(l.at[1].d[0].radius(), 1e-2); // and says something
  }
  EXPECT_EQ(boxes, 12);
}

TEST(EnclosedMap, TheInverseGoesBack) {
  const EnclosureScope scope(128);
  const SystemScene scene = henon_heiles_at("1/6");
  const SectionSurface surface(scene);
  EnclosedMap map(surface, nullptr);
  const Chart chart{{1, 3}, {0, 2}};
  for (const double y : {-0.2, 0.1, 0.3}) {
    const double v = 0.1, u = std::sqrt(1.0 / 3 - v * v - y * y + 2 * y * y * y / 3);
    const Patch p = map.patch(chart, {Enclosure(y), Enclosure(v)}, {0, y, u, v});
    const Landing there = map(p);
    const Patch q = map.patch(chart, {there.at[1].v, there.at[3].v}, doubles(there.at));
    const Landing back = map(q, true);
    EXPECT_TRUE(meet(back.at[1].v, p.box[0]));
    EXPECT_TRUE(meet(back.at[3].v, p.box[1]));
    EXPECT_TRUE((back.time + there.time).contains_zero());
    // and the derivatives are inverse to each other
    const auto d = [&](const Landing& l, std::size_t i, std::size_t j) { return l.at[i].d[j]; };
    const Enclosure one = d(back, 1, 0) * d(there, 1, 0) + d(back, 1, 1) * d(there, 3, 0);
    const Enclosure zero = d(back, 1, 0) * d(there, 1, 1) + d(back, 1, 1) * d(there, 3, 1);
    EXPECT_TRUE(meet(one, Enclosure(1)));
    EXPECT_TRUE(zero.contains_zero());
    EXPECT_LT(one.radius(), 1e-9);
  }
}

TEST(EnclosedMap, ASheetHoldsOnePointOverEachPlace) {
  const EnclosureScope scope(128);
  const SystemScene scene = henon_heiles_at("1/8");
  const SectionSurface surface(scene);
  EnclosedMap map(surface, nullptr);
  const Chart chart{{1, 3}, {0, 2}};
  const Patch p = map.patch(chart, {Enclosure(0.1), Enclosure(0)}, {0, 0.1, 0.49, 0});
  EXPECT_TRUE(p.at[2].v.inside(p.sheet[1]));
  EXPECT_TRUE(p.sheet[1].is_positive()); // the other sheet, u < 0, is not in it
  EXPECT_THROW((void)map.patch(chart, {Enclosure(-2), Enclosure(0)}, {0, -2, 0.5, 0}), NotProved);
}

// ---- periodic orbits ----

TEST(PeriodicOrbits, OfHenonAndHeiles) {
  const PeriodicOrbits found = periodic_orbits(henon_heiles_at("1/8"));
  int elliptic = 0, hyperbolic = 0;
  for (const PeriodicOrbit& o : found.orbits) {
    EXPECT_TRUE(o.proved) << to_string(o.why);
    elliptic += o.stability == Stability::elliptic ? 1 : 0;
    hyperbolic += o.stability == Stability::hyperbolic ? 1 : 0;
  }
  EXPECT_EQ(elliptic, 4);
  EXPECT_EQ(hyperbolic, 3); // images of each other under the turns by 120 degrees
}

// An oscillator beside another: every orbit has a known period and multipliers.
TEST(PeriodicOrbits, TheTraceOfUncoupledOscillators) {
  const SystemScene s = scene_of("(u^2 + v^2)/2 + x^2/2 + y^2", "x", "1/2");
  const PeriodicOrbits found = periodic_orbits(s);
  ASSERT_EQ(found.orbits.size(), 1U);
  EXPECT_TRUE(found.orbits[0].proved);
  EXPECT_NEAR(found.orbits[0].trace, 2 * std::cos(2 * M_PI * std::sqrt(2)), 1e-12);
  EXPECT_NEAR(found.orbits[0].time, 2 * M_PI, 1e-12);
  EXPECT_EQ(found.orbits[0].stability, Stability::elliptic);
}

TEST(PeriodicOrbits, OfPeriodThreeAreProvedWithTheirLeastPeriod) {
  PeriodicOptions o;
  o.period = 3;
  o.columns = o.rows = 12;
  const PeriodicOrbits found = periodic_orbits(henon_heiles_at("1/6"), o);
  int proved = 0;
  for (const PeriodicOrbit& orbit : found.orbits) {
    EXPECT_EQ(orbit.points.size(), 3U);
    proved += orbit.proved ? 1 : 0;
  }
  EXPECT_GE(proved, 1);
}

// With the fixed point that is tried first instead of a grid.
SystemScene sliding_top() {
  const std::string file = kov::test::in_source("/cases/sections/sliding_top.toml");
  SystemScene s = read_system_scenes(read_document(file)).front();
  s.columns = s.rows = 0;
  s.range.reset();
  s.seeds = {{Quantity("-15218/10000"), Quantity("0")}};
  return s;
}

// Six coordinates and a quotient: boxes of naive enclosures would be as large as the numbers.  The values are those of
// the program for rigid bodies (fixed_points_test.cpp).
TEST(PeriodicOrbits, OfTheSlidingTop) {
  const SystemScene s = sliding_top();
  const PeriodicOrbits found = periodic_orbits(s);
  ASSERT_GE(found.orbits.size(), 1U);
  const PeriodicOrbit& o = found.orbits.front();
  ASSERT_TRUE(o.proved) << to_string(o.why);
  EXPECT_EQ(o.stability, Stability::hyperbolic);
  EXPECT_NEAR(o.time, 3.623605246, 1e-8);
  EXPECT_NEAR(o.multiplier()[0], 1.704237933123, 1e-11);
  EXPECT_LT(o.error, 1e-15);
}

// tr = 2 at resonance: nothing isolated, and no kind without a proof.
TEST(PeriodicOrbits, NoKindWhereTheMultipliersAreOne) {
  const PeriodicOrbits found =
      periodic_orbits(scene_of("(u^2 + v^2)/2 + x^2/2 + y^2/2", "x", "1/2"));
  for (const PeriodicOrbit& o : found.orbits)
    EXPECT_FALSE(o.proved);
}

TEST(SectionSurface, RefusesWhatIsNoSectionMap) {
  EXPECT_THROW((void)periodic_orbits(henon_heiles_at("1/8", "grid = [3, 3]\ndirection = \"both\"")),
               InputError);
  SystemScene s = henon_heiles_at("1/8");
  s.levels[0].function.value = MFraction::variable(s.system.ring(), "y"); // no integral
  EXPECT_THROW((void)periodic_orbits(s), InputError);
  s.levels.clear();
  EXPECT_THROW((void)periodic_orbits(s), InputError);
}

// ---- homoclinic points ----

TEST(Homoclinic, OfHenonAndHeilesAtOneEighth) {
  const Homoclinic found = homoclinic(henon_heiles_at("1/8"));
  ASSERT_TRUE(found.proof) << to_string(found.why);
  const HomoclinicProof& p = *found.proof;
  EXPECT_EQ(p.fixed.stability, Stability::hyperbolic);
  EXPECT_GT(p.sine, 0.1);
  EXPECT_GT(p.stretch_unstable, 1);
  EXPECT_GT(p.stretch_stable, 1);
  // The quick integrator sees the orbit come near the fixed point, too.
  const auto& last = p.orbit.back().drawn;
  const auto& fixed = p.fixed.points[0].drawn;
  EXPECT_LT(std::hypot(last[0] - fixed[0], last[1] - fixed[1]), 2 * p.reach);
  EXPECT_LT(p.reach, 1e-3);
  double farthest = 0;
  for (const PeriodicPoint& z : p.orbit)
    farthest = std::max(farthest, std::hypot(z.drawn[0] - fixed[0], z.drawn[1] - fixed[1]));
  EXPECT_GT(farthest, 0.1);
}

// The first figure of arXiv:2504.17291: a multiplier of 1.7 only, so that many returns are enclosed together.  It takes
// half a minute.
TEST(Homoclinic, OfTheSlidingTop) {
  const Homoclinic found = homoclinic(sliding_top());
  ASSERT_TRUE(found.proof) << to_string(found.why);
  const HomoclinicProof& p = *found.proof;
  EXPECT_EQ(p.fixed.stability, Stability::hyperbolic);
  EXPECT_NEAR(p.fixed.multiplier()[0], 1.704237933123, 1e-11);
  EXPECT_GT(p.sine, 0.5);
  EXPECT_LT(p.orbit.size(), 75U);
  EXPECT_LT(p.error, 1e-5);
}

TEST(Homoclinic, OfAPointOfPeriodTwo) {
  HomoclinicOptions o;
  o.period = 2;
  const Homoclinic found = homoclinic(henon_heiles_at("1/6"), o);
  ASSERT_TRUE(found.proof) << to_string(found.why);
  EXPECT_EQ(found.proof->fixed.points.size(), 2U);
  EXPECT_GT(found.proof->sine, 0.1);
}

// Integrable: hyperbolic orbits whose manifolds coincide, cut obliquely; separable; with a second integral of degree 4.
TEST(Homoclinic, NoneInIntegrableSystems) {
  const std::vector<SystemScene> all{
      scene_of("(u^2 + v^2)/2 + x^2/2 - y^2/2 + y^4/4", "x", "1/2"),
      scene_of("(u^2 + v^2)/2 + ((3*x + 4*y)/5)^2/2 - ((3*y - 4*x)/5)^2/2 + ((3*y - 4*x)/5)^4/4",
               "3*x + 4*y", "1/2"),
      scene_of("(u^2 + v^2)/2 + ((3*x + 4*y)/5)^2/2 - ((3*y - 4*x)/5)^2/2 + ((3*y - 4*x)/5)^4/4",
               "x + y", "1/2"),
      scene_of("(u^2 + v^2)/2 - (x^2 + y^2)/2 + x^4 + 6*x^2*y^2 + y^4", "x", "1/10"),
      scene_of("(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y + y^3/3", "x", "1/13"),
      scene_of("(u^2 + v^2)/2 + (x^2 + 3*y^2)/2 + x^2*y + 2*y^3", "x", "1/10")};
  HomoclinicOptions o;
  o.most_returns = 5000;
  std::size_t hyperbolic = 0;
  for (const SystemScene& s : all) {
    const Homoclinic found = homoclinic(s, o);
    EXPECT_FALSE(found.proof) << s.section.text;
    EXPECT_NE(found.why, NotProved::refused);
    hyperbolic += found.hyperbolic.size();
  }
  EXPECT_GE(hyperbolic, 3U); // or nothing was tried
}

// ---- Krawczyk's test ----

TEST(Krawczyk, KnowsAZeroFromATangency) {
  const EnclosureScope scope(128);
  const auto holds = [](const Enclosure& value, const Enclosure& slope, double radius) {
    const auto c = approximate_inverse(BallMatrix{{slope}});
    if (!c) return false;
    return shift_inside(krawczyk_shift(*c, {value}, {{slope}}, {radius}), {radius});
  };
  EXPECT_TRUE(holds(Enclosure(1e-8), Enclosure::between(1.9, 2.1), 1e-7));
  EXPECT_FALSE(holds(Enclosure(1e-8), Enclosure::between(-0.1, 2.1), 1e-7)); // may be 0
  EXPECT_FALSE(holds(Enclosure(1e-6), Enclosure::between(1.9, 2.1), 1e-7));  // is not in the box
  Enclosure nothing = Enclosure(1) / Enclosure(0);
  EXPECT_FALSE(holds(nothing, Enclosure(1), 1e-7));
  EXPECT_FALSE(holds(Enclosure(0), nothing, 1e-7));
}

} // namespace
} // namespace kov::flow::chaos_test
