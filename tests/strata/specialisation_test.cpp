// The verdict of the tree at random rational points is that of the solver without parameters.

#include "integrability/parameters.hpp"
#include "strata/decide_strata.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace kov {
namespace {

using strata::Question;
using strata::StrataAnswer;
using strata::Stratum;

// KOV_POINTS=200 for a long run; every stratum gets as many.
int points() {
  const char* n = std::getenv("KOV_POINTS");
  return n != nullptr ? std::atoi(n) : 3;
}

Question question_of(const std::string& file) {
  System s = read_system(KOV_SOURCE_DIR "/cases/sliding_top/" + file);
  CheckOptions options;
  options.stop_at_r = true;
  const CheckReport report = check_system(s, options);
  for (const auto& b : report.manifolds.at(0).blocks)
    if (b.ode) return strata_question(s, *b.ode);
  throw std::runtime_error("no equation");
}

class Points {
public:
  Points(const Question& q, unsigned seed) : q_(q), random_(seed) {}

  // A random point of the stratum that satisfies the assumptions; unset: not found.
  std::optional<std::map<std::size_t, Rational>> in(const Stratum& x) {
    for (int tries = 0; tries < 400; ++tries) {
      std::map<std::size_t, Rational> point;
      Substitution values;
      for (std::size_t i = 0; i < q_.r.ring()->size(); ++i)
        if (i != q_.z) {
          point[i] = Rational(std::uniform_int_distribution<long>(-9, 24)(random_),
                              std::uniform_int_distribution<long>(1, 7)(random_));
          values[i] = MFraction(q_.r.ring(), point[i]);
        }
      bool defined = true;
      for (const auto& [i, value] : x.solved) {
        try {
          const MFraction v = substitute(value, values);
          point[i] = is_zero(v) ? Rational(0) : to_rational(v);
        } catch (const DomainError&) {
          defined = false;
        }
      }
      if (defined && assumed(point) && strata::stratum_at(answer_of(x), point) != nullptr)
        return point;
    }
    return std::nullopt;
  }

private:
  static StrataAnswer answer_of(const Stratum& x) {
    StrataAnswer a;
    a.strata.push_back(x);
    return a;
  }
  bool assumed(const std::map<std::size_t, Rational>& point) const {
    Stratum all;
    all.conditions = q_.assumptions.conditions;
    return strata::stratum_at(answer_of(all), point) != nullptr;
  }

  const Question& q_;
  std::mt19937 random_;
};

MFraction at(const Question& q, const std::map<std::size_t, Rational>& point) {
  Substitution values;
  for (const auto& [i, v] : point)
    values[i] = MFraction(q.r.ring(), v);
  return substitute(q.r, values);
}

std::string text(const Question& q, const std::map<std::size_t, Rational>& point) {
  std::string s;
  for (const auto& [i, v] : point)
    s += q.r.ring()->name(i) + " = " + to_string(v) + "  ";
  return s;
}

void compare(const Question& q, const StrataAnswer& answer, unsigned seed) {
  Points random(q, seed);
  int compared = 0;
  for (const Stratum& x : answer.strata) {
    if (x.leaf.abelian == Truth::unknown) continue;
    for (int k = 0; k < points(); ++k) {
      const auto point = random.in(x);
      if (!point) continue;
      const MFraction r = at(q, *point);
      NormalForm equation;
      if (!is_zero(r)) equation.r = to_rational_function(r, q.z);
      const Decision d = decide(equation);
      if (d.abelian == Truth::unknown) continue;
      ++compared;
      EXPECT_EQ(d.abelian, x.leaf.abelian)
          << "seed " << seed << ": " << text(q, *point) << "\nstratum "
          << strata::to_string(x.conditions) << "\n"
          << x.leaf.reason << "\nbut " << d.reason;
      if (x.leaf.group && d.group) {
        EXPECT_TRUE(*x.leaf.group == *d.group) << text(q, *point) << describe(*d.group);
      }
    }
  }
  EXPECT_GT(compared, 0);
  ::testing::Test::RecordProperty("compared", compared);
}

TEST(Specialisation, Lemma3) {
  const Question q = question_of("lemma3.toml");
  const StrataAnswer a = decide_strata(q);
  EXPECT_TRUE(a.decided());
  EXPECT_TRUE(a.trusted.empty());
  EXPECT_EQ(a.strata.size(), 4U);
  compare(q, a, 3);
}

TEST(Specialisation, Lemma2) {
  const Question q = question_of("lemma2.toml");
  const StrataAnswer a = decide_strata(q);
  EXPECT_EQ(a.abelian(), Truth::no);
  EXPECT_TRUE(a.trusted.empty());
  compare(q, a, 2);
}

TEST(Specialisation, GravityOnTheLevelOfLame) {
  Question q = question_of("gravity.toml");
  const auto x = [&](const char* name) { return MFraction::variable(q.r.ring(), name); };
  q.assumptions.require(x("h") * x("h") - x("A") - MFraction(q.r.ring(), Rational(1)),
                        strata::Sign::zero);
  const StrataAnswer a = decide_strata(q);
  EXPECT_TRUE(a.trusted.empty());
  for (const Stratum& s : a.strata)
    EXPECT_TRUE(s.leaf.abelian == Truth::no || s.leaf.no_equation)
        << strata::to_string(s.conditions);
  compare(q, a, 5);
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
