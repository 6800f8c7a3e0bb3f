#pragma once
// The verdict of a tree of strata against the solver without parameters, at random rational points.

#include "decide/words.hpp"
#include "strata/decide_strata.hpp"
#include "strata/words.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace kov::test {

using strata::Question;
using strata::StrataAnswer;
using strata::Stratum;

// KOV_POINTS=200 for a long run; every stratum gets as many.
inline int points() {
  const char* n = std::getenv("KOV_POINTS");
  return n != nullptr ? std::atoi(n) : 3;
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

inline MFraction at(const Question& q, const std::map<std::size_t, Rational>& point) {
  Substitution values;
  for (const auto& [i, v] : point)
    values[i] = MFraction(q.r.ring(), v);
  return substitute(q.r, values);
}

inline std::string text(const Question& q, const std::map<std::size_t, Rational>& point) {
  std::string s;
  for (const auto& [i, v] : point)
    s += q.r.ring()->name(i) + " = " + to_string(v) + "  ";
  return s;
}

// How many points were compared.
inline int compare(const Question& q, const StrataAnswer& answer, unsigned seed) {
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
      EXPECT_EQ(d.abelian, x.leaf.abelian) << "seed " << seed << ": " << text(q, *point)
                                           << "\nstratum " << to_string(x.conditions) << "\n"
                                           << reason(x.leaf) << "\nbut " << reason(d);
      if (x.leaf.group && d.group) {
        EXPECT_TRUE(x.leaf.group->type == d.group->type &&
                    (!x.leaf.group->n || *x.leaf.group == *d.group))
            << text(q, *point) << describe(*d.group);
      }
    }
  }
  ::testing::Test::RecordProperty("compared", compared);
  return compared;
}

} // namespace kov::test
