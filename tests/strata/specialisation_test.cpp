// The verdict of the tree at random rational points is that of the solver without parameters.

#include "integrability/parameters.hpp"
#include "strata/specialisation.hpp"
#include "support/checked.hpp"
#include "support/source_dir.hpp"

namespace kov::specialisation_test {
namespace {

using strata::Question;
using strata::StrataAnswer;
using strata::Stratum;
using test::compare;

Question question_of(const std::string& file, const ParameterValues& values = {}) {
  System s = read_system(test::in_source("/cases/") + file, values);
  CheckOptions options;
  options.stop_at_r = true;
  for (const auto& b : test::checked(study::FileStudy(s), options).blocks)
    if (b.ode) return strata_question(s, *b.ode);
  throw std::runtime_error("no equation");
}

TEST(Specialisation, Lemma3) {
  const Question q = question_of("sliding_top/lemma3.toml");
  const StrataAnswer a = decide_strata(q);
  EXPECT_TRUE(a.decided());
  EXPECT_TRUE(a.trusted.empty());
  EXPECT_EQ(a.strata.size(), 4U);
  EXPECT_GT(compare(q, a, 3), 2);
}

TEST(Specialisation, Lemma2) {
  const Question q = question_of("sliding_top/lemma2.toml");
  const StrataAnswer a = decide_strata(q);
  EXPECT_EQ(a.abelian(), Truth::no);
  EXPECT_TRUE(a.trusted.empty());
  EXPECT_GT(compare(q, a, 2), 2);
}

TEST(Specialisation, GravityOnTheLevelOfLame) {
  Question q = question_of("sliding_top/gravity.toml");
  const auto x = [&](const char* name) { return MFraction::variable(q.r.ring(), name); };
  q.assumptions.require(x("h") * x("h") - x("A") - MFraction(q.r.ring(), Rational(1)), Sign::zero);
  const StrataAnswer a = decide_strata(q);
  EXPECT_TRUE(a.trusted.empty());
  for (const Stratum& s : a.strata)
    EXPECT_TRUE(s.leaf.abelian == Truth::no || s.leaf.no_equation()) << to_string(s.conditions);
  EXPECT_GT(compare(q, a, 5), 2);
}

TEST(Specialisation, TheTwoOtherManifoldsWithoutGravity) {
  for (const char* file : {"sliding_top/remark_n.toml", "sliding_top/remark_k.toml"}) {
    const Question q = question_of(file);
    const StrataAnswer a = decide_strata(q);
    EXPECT_TRUE(a.trusted.empty()) << file;
    for (const Stratum& x : a.strata)
      EXPECT_TRUE(x.leaf.abelian != Truth::unknown || x.leaf.no_equation())
          << file << ": " << to_string(x.conditions);
    EXPECT_GT(compare(q, a, 7), 2) << file;
  }
}

MFraction variable(const Question& q, const char* name) {
  return MFraction::variable(q.r.ring(), name);
}

MFraction number(const Question& q, const Rational& n) { return MFraction(q.r.ring(), n); }

using NamedPoint = std::map<std::string, Rational>;

// unknown also where no stratum contains the point
Truth abelian_at(const Question& q, const StrataAnswer& a, const NamedPoint& point) {
  std::map<std::size_t, Rational> values;
  for (const auto& [name, value] : point)
    values[q.r.ring()->index(name)] = value;
  const Stratum* x = strata::stratum_at(a, values);
  return x == nullptr ? Truth::unknown : x->leaf.abelian;
}

// Lame with n(n+1) = 12/beta: for beta = 6, 2, 1 n is an integer, and every A, B, g3 passes.
TEST(Specialisation, HenonHeilesOfIntegerLameDegree) {
  for (const char* beta : {"6", "2", "1"}) {
    const Question q = question_of("classics/henon_heiles.toml", {{"beta", beta}});
    const StrataAnswer a = decide_strata(q);
    EXPECT_EQ(a.abelian(), Truth::yes) << beta;
    EXPECT_TRUE(a.trusted.empty());
    EXPECT_GT(compare(q, a, 11), 8) << beta;
  }
}

// beta = 16: n = 1/2, only B = 16 A; beta = 3: n = (sqrt(17) - 1)/2.
TEST(Specialisation, HenonHeilesOfOtherLameDegrees) {
  const Question half = question_of("classics/henon_heiles.toml", {{"beta", "16"}});
  const StrataAnswer a = decide_strata(half);
  EXPECT_EQ(abelian_at(half, a, {{"A", 1}, {"B", 16}, {"g3", 1}}), Truth::yes);
  EXPECT_EQ(abelian_at(half, a, {{"A", 1}, {"B", 1}, {"g3", 1}}), Truth::no);
  EXPECT_GT(compare(half, a, 12), 8);

  const Question irrational = question_of("classics/henon_heiles.toml", {{"beta", "3"}});
  const StrataAnswer b = decide_strata(irrational);
  EXPECT_EQ(abelian_at(irrational, b, {{"A", 1}, {"B", 1}, {"g3", 1}}), Truth::no);
  EXPECT_GT(compare(irrational, b, 13), 5);
}

// Delta^2 = (8 e + 1)/16 at infinity has to be bounded: -1 < e < 4.
TEST(Specialisation, QuarticPotential) {
  Question q = question_of("classics/quartic_potential.toml");
  const MFraction e = variable(q, "e");
  q.assumptions.require(e + number(q, 1), Sign::positive);
  q.assumptions.require(number(q, 4) - e, Sign::positive);
  const StrataAnswer a = decide_strata(q);
  EXPECT_TRUE(a.decided());
  for (const Rational& value :
       {Rational(0), Rational(1), Rational(3), Rational(3, 8), Rational(7, 72), Rational(247, 72)})
    EXPECT_EQ(abelian_at(q, a, {{"e", value}, {"h", 1}}), Truth::yes) << to_string(value);
  EXPECT_EQ(abelian_at(q, a, {{"e", 2}, {"h", 1}}), Truth::no);
  EXPECT_GT(compare(q, a, 14), 20);
}

// Delta^2 = 17/4 + 4/(mu - 1) at infinity; mu = 1 + 4/(p^2 + p - 4) is 3, 3/2, 5/4, ...
TEST(Specialisation, SwingingAtwood) {
  Question q = question_of("classics/swinging_atwood.toml");
  q.assumptions.require(variable(q, "mu") - number(q, Rational(5, 4)), Sign::positive);
  const StrataAnswer a = decide_strata(q);
  EXPECT_TRUE(a.decided());
  EXPECT_EQ(abelian_at(q, a, {{"mu", 3}, {"h", 1}}), Truth::yes);
  EXPECT_EQ(abelian_at(q, a, {{"mu", Rational(3, 2)}, {"h", 1}}), Truth::yes);
  for (const Rational& value : {Rational(2), Rational(5), Rational(4, 3)})
    EXPECT_EQ(abelian_at(q, a, {{"mu", value}, {"h", 1}}), Truth::no) << to_string(value);
  EXPECT_GT(compare(q, a, 15), 4);
}

// y'' = (z^200 + a/z^2) y is solvable where Delta = sqrt(1 + 4 a) is an odd multiple of 101.
TEST(Specialisation, AnOpenExponentBesideALargeIrregularOrder) {
  const Ring ring = make_ring({"z", "a"});
  Question q{.r = MFraction(ring), .assumptions = {}, .generic = {}};
  const MFraction z = MFraction::variable(ring, std::size_t{0});
  const MFraction a = MFraction::variable(ring, std::size_t{1});
  q.r = a / (z * z);
  MFraction power(ring, Rational(1));
  for (int i = 0; i < 200; ++i)
    power *= z;
  q.r += power;
  const StrataAnswer answer = decide_strata(q);
  const Stratum* there = strata::stratum_at(answer, {{1, Rational(2550)}});
  EXPECT_TRUE(there == nullptr || there->leaf.abelian != Truth::no);
  EXPECT_NE(answer.abelian(), Truth::no);
}

// y'' = (w' + w^2 + e) y has the solution exp(int w) where e = 0, and others elsewhere.
TEST(Specialisation, TheGroupIsKnownWhereItIsWanted) {
  const Ring ring = make_ring({"z", "a", "b"});
  const auto named = [&](const char* name) { return MFraction::variable(ring, name); };
  const MFraction z = named("z"), a = named("a"), b = named("b"), one(ring, Rational(1));
  const std::vector<MFraction> exact{a * z * z + z, z * z * z + a * z - one / z,
                                     a + one / (z - one), a / (z * z) + one / z,
                                     b * z * z + one / (z - a)};
  const std::vector<MFraction> more{b, b * z, (a - one) * b, (a + b) * z, a * b / (z - one)};
  strata::StrataLimits limits;
  limits.decide.want_group = true;
  int told = 0, borel = 0;
  for (const MFraction& w : exact)
    for (const MFraction& e : more) {
      Question q{.r = derivative(w, 0) + w * w + e, .assumptions = {}, .generic = {}};
      const StrataAnswer answer = decide_strata(q, limits);
      for (const auto& [x, y] : std::vector<std::pair<long, long>>{
               {1, 0}, {2, 0}, {-2, 0}, {1, 3}, {2, -2}, {-1, 1}, {3, 2}, {0, 1}}) {
        const Stratum* s = strata::stratum_at(answer, {{1, Rational(x)}, {2, Rational(y)}});
        if (s == nullptr || !s->leaf.group || !s->leaf.parts.empty()) continue;
        const MFraction r =
            substitute(q.r, {{1, MFraction(ring, Rational(x))}, {2, MFraction(ring, Rational(y))}});
        const Decision d = decide({to_rational_function(r, 0), 0});
        if (!d.group) continue;
        EXPECT_EQ(s->leaf.group->type, d.group->type)
            << to_string(q.r) << " at a = " << x << ", b = " << y;
        ++told;
        borel += d.group->type == GroupType::Borel ? 1 : 0;
      }
    }
  EXPECT_GT(told, 120);
  EXPECT_GT(borel, 30);
}

} // namespace
} // namespace kov::specialisation_test
