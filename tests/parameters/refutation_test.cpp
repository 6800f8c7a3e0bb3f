// Proofs of signs: what is found is accepted by the checker, and what has a point is not refuted.

#include "parameters/combination.hpp"
#include "parameters/refutation.hpp"
#include "proof/condition/show.hpp"

#include <gmock/gmock.h>

namespace kov::refutation_test {
namespace {

const Ring& ring() {
  static const Ring r = make_ring({"A", "B", "C", "g", "x", "y"});
  return r;
}

Condition is(const char* f, Sign sign) { return {certify::read_polynomial(ring(), f), sign}; }

// Found, and accepted.
bool refuted(std::vector<Condition> given, int depth = 6) {
  const auto node = refutation(ring(), given, depth);
  if (!node) return false;
  certify::Arithmetic arithmetic;
  std::size_t nodes = 100000;
  const std::string text = certify::to_string(*node);
  const Json json = certify::parse_json(text, 512);
  certify::ConditionSet set(ring(), arithmetic);
  for (const Condition& c : given)
    set.assume(c);
  certify::SetProof(set, nodes).absent(certify::Node(json, "node", rationals()));
  return true;
}

TEST(Refutation, CombinationsOfInequalities) {
  EXPECT_TRUE(refuted(
      {is("A - B", Sign::positive), is("B - C", Sign::positive), is("C - A", Sign::nonnegative)}));
  EXPECT_FALSE(refuted({is("A - B", Sign::nonnegative), is("B - C", Sign::nonnegative),
                        is("C - A", Sign::nonnegative)}));
}

TEST(Refutation, EquationsArePutIn) {
  EXPECT_TRUE(refuted({is("A - 4*B + C", Sign::zero), is("B + C - A", Sign::nonnegative),
                       is("B - C", Sign::positive), is("C", Sign::positive)}));
  EXPECT_FALSE(refuted({is("A - 4*B + C", Sign::zero), is("B + C - A", Sign::nonnegative),
                        is("B - C", Sign::nonnegative), is("C", Sign::nonnegative)}));
  EXPECT_TRUE(refuted(
      {is("2*x + 3*y - 1", Sign::zero), is("x - y", Sign::zero), is("5*x - 1", Sign::nonzero)}));
}

TEST(Refutation, SumsOfSquares) {
  EXPECT_TRUE(refuted({is("x^2 + y^2", Sign::zero), is("x", Sign::nonzero)}));
  EXPECT_FALSE(refuted({is("x^2 - y^2", Sign::zero), is("x", Sign::nonzero)}));
  EXPECT_FALSE(refuted({is("x^2 + A^2 - 4*A*C + 4*C^2", Sign::positive),
                        is("-g^2*x^2 - A^2 + 4*A*C - 4*C^2", Sign::nonnegative)}));
}

TEST(Refutation, Products) {
  EXPECT_TRUE(refuted(
      {is("2*A*x - 2*B*x", Sign::zero), is("A - B", Sign::positive), is("x", Sign::nonzero)}));
  EXPECT_FALSE(refuted(
      {is("2*A*x - 2*B*x", Sign::zero), is("A + B", Sign::positive), is("x", Sign::nonzero)}));
}

// A >= B >= C and C = A leave no room between them.
TEST(Refutation, OrdersThatAreNotStrict) {
  const auto ordered = [](const char* equation, const char* nonzero) {
    return std::vector{is("A - B", Sign::nonnegative), is("B - C", Sign::nonnegative),
                       is(equation, Sign::zero), is(nonzero, Sign::nonzero)};
  };
  for (const auto& [equation, nonzero] :
       {std::pair("C - A", "A - B"), std::pair("A - C", "3*C - 3*B"),
        std::pair("2*A - 2*C", "B - A")})
    EXPECT_TRUE(refuted(ordered(equation, nonzero), 0)) << equation << ", " << nonzero;
  EXPECT_FALSE(refuted(ordered("C - A", "A")));
  EXPECT_FALSE(refuted(ordered("B - A", "B - C")));
}

int sign(std::vector<Condition> known, const char* p) {
  const auto found = sign_follows(std::move(known), certify::read_polynomial(ring(), p));
  return found ? found->sign : 0;
}

// Each sign holds at all points of the conditions, and no sign is said where it does not.
TEST(Signs, ThatFollowFromOthers) {
  const std::vector chain{is("C", Sign::positive), is("B - C", Sign::positive),
                          is("A - B", Sign::nonnegative)};
  const std::vector triangle{is("A + B - C", Sign::positive), is("B + C - A", Sign::positive),
                             is("C + A - B", Sign::positive)};
  const std::vector weak{is("A + B - C", Sign::nonnegative), is("B + C - A", Sign::nonnegative),
                         is("C + A - B", Sign::nonnegative)};
  for (const char* p : {"A", "B", "C", "A + B", "A - C"})
    EXPECT_EQ(sign(chain, p), 1) << p;
  for (const char* p : {"A", "B", "C", "A + B + C"})
    EXPECT_EQ(sign(triangle, p), 1) << p;
  for (const char* p : {"A", "B", "A + B + C"})
    EXPECT_EQ(sign(weak, p), 0) << p;
  EXPECT_EQ(sign(chain, "-A"), -1);
  EXPECT_EQ(sign(chain, "A - B"), 0);
  EXPECT_EQ(sign({is("-C", Sign::nonnegative), is("C - A - 1", Sign::positive)}, "A"), -1);
  EXPECT_EQ(sign({is("B - C - 1", Sign::positive), is("C", Sign::nonnegative)}, "B"), 1);
  EXPECT_EQ(sign({is("A - B^2", Sign::positive)}, "A"), 1);
  EXPECT_EQ(sign({is("A - B^2", Sign::nonnegative)}, "A"), 0);
  EXPECT_EQ(sign({is("A*B", Sign::positive), is("B", Sign::positive)}, "A"), 1);
  EXPECT_EQ(sign({is("A*B", Sign::positive)}, "A"), 0);
  EXPECT_EQ(sign({is("x^2 + y^2", Sign::nonzero)}, "x"), 0);
}

TEST(Combination, IsExact) {
  const auto q = [](long a) { return Rational(a); };
  EXPECT_TRUE(nonnegative_combination({{q(1), q(-1)}}, {true, false}).has_value());
  EXPECT_FALSE(nonnegative_combination({{q(1), q(1)}}, {true, false}).has_value());
  EXPECT_FALSE(nonnegative_combination({{q(0), q(1)}}, {false, true}).has_value());
}

// What classify leaves out: squares of real parameters that are not 0, beside conditions that do not matter.
TEST(Refutation, SetsWithoutRealPoints) {
  const Ring r = make_ring({"A", "B", "C", "L1", "L2", "L3"}), other = make_ring({"L3", "L1"});
  const auto is = [&](const char* f, Sign sign) {
    return Condition{certify::read_polynomial(r, f), sign};
  };
  const Condition elsewhere{certify::read_polynomial(other, "L1^2 + L3^2"), Sign::zero};
  std::vector<Condition> set{is("A - C", Sign::zero), is("16*C - 17*B", Sign::zero),
                             is("B - A", Sign::nonzero), is("L3", Sign::nonzero)};
  EXPECT_FALSE(is_refuted_exactly(set));
  set.push_back(elsewhere);
  EXPECT_TRUE(is_refuted_exactly(set));
  set.back() = is("L1^2 - L3^2", Sign::zero);
  EXPECT_FALSE(is_refuted_exactly(set));
  set.back() = is("L1^2 + 2*L1*L3 + 2*L3^2", Sign::zero); // (L1 + L3)^2 + L3^2
  static_cast<void>(is_refuted_exactly(set));             // found or not, never wrong
  EXPECT_TRUE(is_refuted_exactly({is("A", Sign::positive), is("A + 1", Sign::zero)}));
  EXPECT_FALSE(is_refuted_exactly({is("A^2", Sign::zero)}));
  EXPECT_FALSE(is_refuted_exactly({}));
}

} // namespace
} // namespace kov::refutation_test
