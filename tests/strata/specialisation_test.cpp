// The verdict of the tree at random rational points is that of the solver without parameters.

#include "integrability/parameters.hpp"
#include "strata/specialisation.hpp"

namespace kov {
namespace {

using strata::Question;
using strata::StrataAnswer;
using strata::Stratum;
using test::compare;

Question question_of(const std::string& file) {
  System s = read_system(KOV_SOURCE_DIR "/cases/" + file);
  CheckOptions options;
  options.stop_at_r = true;
  const CheckReport report = check_system(s, options);
  for (const auto& b : report.manifolds.at(0).blocks)
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
  q.assumptions.require(x("h") * x("h") - x("A") - MFraction(q.r.ring(), Rational(1)),
                        strata::Sign::zero);
  const StrataAnswer a = decide_strata(q);
  EXPECT_TRUE(a.trusted.empty());
  for (const Stratum& s : a.strata)
    EXPECT_TRUE(s.leaf.abelian == Truth::no || s.leaf.no_equation)
        << strata::to_string(s.conditions);
  EXPECT_GT(compare(q, a, 5), 2);
}

TEST(Specialisation, TheTwoOtherManifoldsWithoutGravity) {
  for (const char* file : {"sliding_top/remark_n.toml", "sliding_top/remark_k.toml"}) {
    const Question q = question_of(file);
    const StrataAnswer a = decide_strata(q);
    EXPECT_TRUE(a.trusted.empty()) << file;
    for (const Stratum& x : a.strata)
      EXPECT_TRUE(x.leaf.abelian != Truth::unknown || x.leaf.no_equation)
          << file << ": " << strata::to_string(x.conditions);
    EXPECT_GT(compare(q, a, 7), 2) << file;
  }
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

} // namespace
} // namespace kov
