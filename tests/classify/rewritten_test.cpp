// What is decided does not depend on how the question is written: 60 pairs and more.
//
// A small sample in the suite; all pairs: tools/attack --minutes 20 'Rewritten.*'.

#include "classify/classify.hpp"

#include "rewritten.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>

namespace kov::test::rewritten_test {
namespace {

// The status, and the number of sets of each kind: names and forms of the sets may differ.
std::string answer(const std::string& text) {
  ClassifyOptions options;
  options.check.decide.budget.give(6e9);
  return to_string(
      classify_system(read_system(parse_document(text, "rewritten.toml")), options).status());
}

const std::string& plain_answer(const Question& q) {
  static std::map<const Question*, std::string> all;
  const auto known = all.find(&q);
  return known != all.end() ? known->second : all[&q] = answer(text_of(q, writings(q).front()));
}

void expect_nothing_lost(const Question& q, const Writing& w) {
  const std::string text = text_of(q, w);
  EXPECT_EQ(answer(text), plain_answer(q)) << text;
}

TEST(Rewritten, ThereAreSixtyPairs) {
  std::size_t pairs = 0;
  for (const Question& q : questions())
    pairs += writings(q).size() - 1;
  EXPECT_GE(pairs, 60U);
}

// Of tops whose separatrices split: a tenth of a second each.
TEST(Rewritten, TopsLoseNothing) {
  for (const Question& q : {questions()[0], questions()[1]})
    for (const Writing& w : writings(q))
      EXPECT_EQ(answer(text_of(q, w)), "non-integrable") << text_of(q, w);
}

// Of a family with a symmetry that exchanges P and Q: what holds for all parameters holds for those in an order,
// to which no symmetry leads.
TEST(Rewritten, AnOrderLosesNothing) {
  const auto classified = [](const std::string& hamiltonian, const std::string& order) {
    ClassifyOptions options;
    options.check.decide.budget.give(6e9);
    return classify_system(
        read_system(parse_document(
            "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
            "parameters = ['P', 'Q']\nhamiltonian = '" +
                hamiltonian + "'\n[assume]\nconditions = ['P > 0', 'Q > 0'" + order + "]\n",
            "ordered.toml")),
        options);
  };
  const auto number = [](const SystemClassification& c, StratumStatus status) {
    return std::count_if(c.strata.begin(), c.strata.end(),
                         [&](const ClassifiedStratum& x) { return x.status == status; });
  };
  const auto is_integrable_at = [](const SystemClassification& c, long p, long q) {
    return std::any_of(c.strata.begin(), c.strata.end(), [&](const ClassifiedStratum& x) {
      const Ring& ring = x.where.ring();
      const Substitution point{{ring->index("P"), MFraction(ring, Rational(p))},
                               {ring->index("Q"), MFraction(ring, Rational(q))}};
      const auto vanishes = [&](const MPoly& f) { return is_zero(substitute(f, point)); };
      const auto &zero = x.where.equations(), &nonzero = x.where.inequations();
      return x.status == StratumStatus::integrable &&
             std::all_of(zero.begin(), zero.end(), vanishes) &&
             std::none_of(nonzero.begin(), nonzero.end(), vanishes);
    });
  };
  for (const char* hamiltonian : {"(u^2 + v^2)/2 + P*x^2 + Q*y^2 + x^4 + 6*x^2*y^2 + y^4",
                                  "(P*u^2 + Q*v^2)/2 + (x^2 + y^2)^2"}) {
    const SystemClassification all = classified(hamiltonian, "");
    EXPECT_EQ(number(all, StratumStatus::open), 0) << hamiltonian;
    for (const char* order : {", 'P >= Q'", ", 'P > Q'"}) {
      const SystemClassification ordered = classified(hamiltonian, order);
      EXPECT_EQ(number(ordered, StratumStatus::open), 0) << hamiltonian << order;
      for (long p = 1; p <= 4; ++p)
        for (long q = 1; q <= p; ++q) {
          if (q == p && std::string(order).find(">=") == std::string::npos) continue;
          EXPECT_EQ(is_integrable_at(ordered, p, q), is_integrable_at(all, p, q))
              << hamiltonian << order << p << q;
        }
    }
  }
}

TEST(Rewritten, NothingIsLost) {
  random_rounds(3, [](Random& random) {
    const Question& q = random.one_of(questions());
    expect_nothing_lost(q, random.one_of(writings(q)));
  });
}

} // namespace
} // namespace kov::test::rewritten_test
