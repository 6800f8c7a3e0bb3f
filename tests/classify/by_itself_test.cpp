// The theorems about tops, from the system and its assumptions alone.

#include "classify/classify.hpp"
#include "support/points.hpp"
#include "support/random.hpp"
#include "support/source_dir.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace kov::by_itself_test {
namespace {

using test::Random;

struct Body {
  std::array<Rational, 3> moments, centre;
};

// The status at a body, with the other parameters as given.
std::string at(const SystemClassification& c, const Body& b, test::Point more) {
  for (std::size_t i = 0; i < 3; ++i) {
    more[std::string(1, static_cast<char>('A' + i))] = b.moments[i];
    more["L" + std::to_string(i + 1)] = b.centre[i];
  }
  return test::status_at(c, more);
}

Body with_axes_moved(Random& random, const Body& b) {
  std::array<std::size_t, 3> to{0, 1, 2};
  std::shuffle(to.begin(), to.end(), random.bits());
  Body moved;
  for (std::size_t i = 0; i < 3; ++i) {
    moved.moments[i] = b.moments[to[i]];
    moved.centre[i] = (random.once_in(2) ? Rational(-1) : Rational(1)) * b.centre[to[i]];
  }
  return moved;
}

const Rational zero(0), one(1);

struct Known {
  Body body;
  std::string status;
};

void expect_all(const SystemClassification& c, const std::vector<Known>& all,
                const test::Point& more) {
  Random random(5);
  for (const Known& x : all)
    for (int k = 0; k < 4; ++k) {
      const Body b = with_axes_moved(random, x.body);
      EXPECT_EQ(at(c, b, more), x.status)
          << to_string(b.moments[0]) << ", " << to_string(b.moments[1]) << ", "
          << to_string(b.moments[2]) << "; " << to_string(b.centre[0]) << ", "
          << to_string(b.centre[1]) << ", " << to_string(b.centre[2]);
    }
}

const std::vector<Known> of_both{
    {{{Rational(2), Rational(3), Rational(4)}, {zero, zero, zero}}, "integrable"},
    {{{one, one, Rational(3, 2)}, {zero, zero, zero}}, "integrable"},
    {{{one, one, Rational(3, 2)}, {zero, zero, one}}, "integrable"}, // Lagrange
    {{{one, one, one}, {one, Rational(2), Rational(-3)}}, "integrable"},
    {{{one, one, Rational(3, 2)}, {one, zero, one}}, "excluded"},
    {{{one, one, Rational(3, 2)}, {one, Rational(2), Rational(3)}}, "excluded"},
    {{{one, one, Rational(3, 2)}, {one, Rational(2), zero}}, "excluded"},
    {{{Rational(2), Rational(3), Rational(4)}, {one, zero, zero}}, "excluded"},
    {{{Rational(2), Rational(3), Rational(4)}, {one, one, one}}, "excluded"},
    {{{Rational(5), Rational(4), Rational(2)}, {one, zero, zero}}, "excluded"}, // C = 2 (A - B)
};

SystemClassification classified(const char* file) {
  return classify_system(read_system(read_document(test::in_source(file))));
}

TEST(ByItself, TheHeavyTopHasFourCases) {
  const auto c = classified("/cases/classics/heavy_top.toml");
  expect_all(c, of_both, {});
  expect_all(
      c,
      {{{{Rational(2), Rational(2), one}, {one, Rational(2), zero}}, "integrable"}, // Kovalevskaya
       {{{Rational(2), Rational(2), one}, {zero, zero, one}}, "integrable"},
       {{{Rational(2), Rational(2), one}, {one, zero, one}}, "excluded"},
       {{{Rational(4), Rational(4), one}, {one, zero, zero}}, "excluded"}}, // Goryachev, Chaplygin
      {});
}

// Kirchhoff's equations with moments 2, 3, 4 and the potential k G1^2 + c G3^2: Clebsch's condition is c = -k.
TEST(ByItself, ClebschsConditionIsNotLost) {
  const auto c = classify_system(read_system(parse_document(
      "[system]\nkind = 'euler-poisson'\ncoordinates = ['M1', 'M2', 'M3', 'G1', 'G2', 'G3']\n"
      "parameters = ['k', 'c']\n"
      "hamiltonian = 'M1^2/4 + M2^2/6 + M3^2/8 + k*G1^2 + c*G3^2'\n"
      "[assume]\nk = 'real'\nc = 'real'\n",
      "kirchhoff.toml")));
  for (const long k : {-2, 0, 1, 3})
    for (const long d : {-1, 0, 2}) {
      const test::Point point{{"k", Rational(k)}, {"c", Rational(d - k)}};
      EXPECT_EQ(test::status_at(c, point), d == 0 ? "integrable" : "excluded") << k << ", " << d;
    }
}

// Nearly a minute: by tools/attack only, each time with another order of the axes in the file.
TEST(ByItself, TheSlidingTopIsIntegrableAsInThePaper) {
  test::random_rounds(std::getenv("KOV_RANDOM_SEED") != nullptr ? 1 : 0, [](Random& /*random*/) {
    const auto c = classified("/cases/sliding_top/sliding_top.toml");
    for (const Rational& g : {zero, one, Rational(-3)}) {
      const test::Point more{{"m", Rational(2)}, {"g", g}};
      expect_all(c, of_both, more);
      expect_all(c,
                 {{{{Rational(2), Rational(2), one}, {one, Rational(2), zero}}, "excluded"},
                  {{{Rational(2), Rational(2), one}, {zero, zero, one}}, "integrable"}},
                 more);
    }
  });
}

} // namespace
} // namespace kov::by_itself_test
