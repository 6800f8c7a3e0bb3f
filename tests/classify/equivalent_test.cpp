// A decision does not depend on the notation.  It is never contradicted, and seldom lost: what the
// search can undo cheaply (lib/canonical) it undoes.
//
// A small sample in the suite; all pairs: tools/attack --minutes 20 'Equivalent.*'.

#include "classify/classify.hpp"

#include "equivalent.hpp"
#include "support/points.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>

namespace kov::test::equivalent_test {
namespace {

ClassifyOptions within(double seconds) {
  ClassifyOptions options;
  options.check.decide.budget.give(1e8 * seconds);
  options.change_variables = std::getenv("KOV_AS_WRITTEN") == nullptr;
  return options;
}

const std::vector<Point>& points() {
  static const std::vector<Point> all{{{"a", 0}}, {{"a", 1}}, {{"a", Rational(-2, 3)}}};
  return all;
}

std::vector<std::string> statuses(const std::string& text, double seconds) {
  const auto c = classify_system(read_text(text), within(seconds));
  std::vector<std::string> all;
  for (const Point& p : points())
    all.push_back(status_at(c, p));
  return all;
}

const std::vector<std::string>& known(const Potential& p) {
  static std::map<std::string, std::vector<std::string>> all;
  const auto found = all.find(p.text);
  if (found != all.end()) return found->second;
  return all[p.text] = statuses(plain_text(p), 20);
}

// Is something decided for the one and open for the other?
bool is_lost(const Potential& p, const std::string& other) {
  const auto& before = known(p);
  const auto after = statuses(other, 20);
  bool lost = false;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i] == "open") continue;
    if (after[i] == "open")
      lost = true;
    else
      EXPECT_EQ(before[i], after[i]) << i << '\n' << other;
  }
  if (lost && std::getenv("KOV_SHOW_LOST")) std::cout << "lost: " << other << '\n';
  return lost;
}

TEST(Equivalent, CanonicalChangesLoseNothing) {
  random_rounds(4, [](Random& random) {
    const Potential& p = random.one_of(potentials());
    const std::string other = canonical_text(p, random);
    EXPECT_FALSE(is_lost(p, other)) << other;
  });
}

// Of three coordinate systems for each potential.
TEST(Equivalent, CurvilinearCoordinatesLoseLittle) {
  long lost = 0, asked = 0;
  random_rounds(3, [&](Random& random) {
    const Potential& p = random.one_of(potentials());
    ++asked;
    if (is_lost(p, curvilinear_text(p, static_cast<std::size_t>(random.between(0, 2))))) ++lost;
  });
  EXPECT_LE(lost * 48, asked * 10) << lost << " of " << asked << " are lost";
}

} // namespace
} // namespace kov::test::equivalent_test
