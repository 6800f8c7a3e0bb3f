// Claims about systems whose parameters obey assumptions: what is false for general parameters may
// hold for those that are assumed.

#include "system/assumed_values.hpp"
#include "system/claims.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov::assumed_claims_test {
namespace {

ClaimResult momentum(const std::string& factor, const std::string& conditions) {
  const System s = read_system_as_assumed(
      parse_document("[system]\nkind = 'hamiltonian'\ncoordinates = ['q', 'y']\n"
                     "momenta = ['p', 'w']\nparameters = ['a', 'b', 'c']\n"
                     "hamiltonian = '(p^2 + w^2)/2 + y^3*q*(" +
                         factor + ")'\n[assume]\nconditions = [" + conditions +
                         "]\n[[integral]]\nvalue = 'p'\n",
                     "test.toml"),
      {});
  return decide_claim(s, s.claims.front());
}

// p is an integral wherever the assumptions hold.
TEST(AssumedClaims, AreNotRefutedWhereTheyHold) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"a*b - 1", "'a*b = 1'"},
      {"a^2 - b^2", "'a^2 = b^2'"},
      {"a - b", "'a^2 - 2*a*b + b^2 = 0'"},
      {"a", "'a^2 = 0'"},
      {"a - b", "'(a - b)*(a + b) = 0', 'a + b != 0'"},
      {"a - b", "'a^2 = b^2', 'a > 0', 'b > 0'"},
      {"a - b", "'a*c = b*c', 'c != 0'"},
      {"a - 2", "'a^2 = 4', 'a > 0'"},
      {"a^2 - 2", "'a^2 = 2'"},
      {"a - b", "'a >= b', 'b >= a'"},
      {"a - b", "'(a - b)*(a - c) = 0', 'a != c'"},
      {"a - b", "'a = b'"}};
  for (const auto& [factor, conditions] : cases) {
    const ClaimResult r = momentum(factor, conditions);
    EXPECT_TRUE(r.proved || !r.open.empty()) << factor << "; " << conditions << ": " << r.detail;
  }
  EXPECT_TRUE(momentum("a - b", "'a = b'").proved);
}
TEST(AssumedClaims, AreRefutedWhereTheyAreFalse) {
  for (const char* conditions : {"", "'a != b'", "'a > b'", "'a >= b'", "'a > 0', 'b > 0'",
                                 "'a^2 = 4'", "'a + b > c', 'b + c > a', 'a + c > b'"}) {
    const ClaimResult r = momentum("a - b", conditions);
    EXPECT_TRUE(!r.proved && r.open.empty()) << conditions << ": " << r.detail;
  }
}

} // namespace
} // namespace kov::assumed_claims_test
