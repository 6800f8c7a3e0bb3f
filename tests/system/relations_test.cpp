// The relations of functions and constants describe one system, or are refused.

#include "system/relations.hpp"

#include "exact/error.hpp"
#include "system/read_system.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace kov::relations_test {
namespace {

using testing::HasSubstr;

// Constants s, t and a parameter a, functions r = sqrt(...) by their relations.
std::string file(const std::string& relations, const std::string& set = "") {
  return "system = {kind = 'hamiltonian', coordinates = ['x', 'y'], momenta = ['u', 'v'], "
         "parameters = ['a'], constants = ['s', 't'], hamiltonian = '(u^2+v^2)/2 + s*x*y + t*a', "
         "relations = [" +
         relations + "]}\n[set]\n" + set;
}

std::string refusal(const std::string& text) {
  try {
    static_cast<void>(read_system(parse_document(text, "file.toml")));
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(Relations, OfOneSystem) {
  for (const char* good :
       {"'s^2 = 2', 't^2 = 3'", "'s^2 = a', 't^2 = 1 - a'", "'s^3 = 2', 't = s^2'",
        "'s^2 = -1', 't^2 = 3*s'", "'s^4 = a^2 + 1', 't^2 = s'", "'s = 2', 't = a'",
        "'s^2 = a^2 + 1', 't*s = 1'", "'s^3 = 3*s + 1', 't = 0'"})
    EXPECT_EQ(refusal(file(good)), "") << good;
}

// Distances from many points: proved at numbers, not in general, where the polynomials are immense.
TEST(Relations, OfManyRoots) {
  VectorField v;
  v.ring = make_ring({"x", "y", "r1", "r2", "r3", "r4", "a"});
  v.coordinates = {0, 1};
  v.parameters = {6};
  const auto x = [&](std::size_t i) { return MFraction::variable(v.ring, i); };
  for (std::size_t i = 2; i < 6; ++i) {
    const MFraction dx = x(0) - Rational(static_cast<long>(i)) * x(6);
    v.functions.push_back({i, v.ring->name(i), {dx / x(i), x(1) / x(i)}});
    v.relations.push_back((x(i) * x(i) - dx * dx - x(1) * x(1)).num());
    v.components = {x(i), x(i)};
  }
  EXPECT_FALSE(reducible_relations(v));
  v.relations.back() = (x(5) * x(5) - Rational(4) * x(2) * x(2)).num(); // r4 = 2 r1 or -2 r1
  EXPECT_TRUE(reducible_relations(v));
}

TEST(Relations, OfSeveralSystemsAreRefused) {
  for (const char* bad :
       {"'s^2 = 256', 't = 1'", "'s^2 = 5*s + 6', 't = 1'", "'s^3 = 2*s', 't = 1'",
        "'s^2 = a^2', 't = 1'", "'s^2 = 2', 't^2 = 8'", "'s^2 = a', 't^2 = 4*a'",
        "'s^2 = -1', 't^2 = -4'", "'s^4 = -4', 't = 1'", "'s^2 = 0', 't = 1'",
        "'s*t = 0', 's + t = 1'", "'s^2 = a', 't^2 = a^3'", "'s^2 = 2', 't^4 = 2'"})
    EXPECT_THAT(refusal(file(bad)), HasSubstr("several solutions")) << bad;
}

TEST(Relations, AConstantCanHaveAValue) {
  EXPECT_EQ(refusal(file("'s^2 = 256', 't = 1'", "s = '-16'")), "");
  EXPECT_THAT(refusal(file("'s^2 = 256', 't = 1'", "s = '4'")), HasSubstr("does not hold"));
  EXPECT_THAT(refusal(file("'s^2 = a', 't = 1'", "a = '4'")), HasSubstr("(s - 2)*(s + 2)"));
  EXPECT_EQ(refusal(file("'s^2 = a', 't = 1'", "a = '4'\ns = '2'")), "");
}

// x r = 0: r = 0, or any r above x = 0.
TEST(Relations, ComponentsAboveSpecialCoordinates) {
  const Ring ring = make_ring({"x", "r"});
  const MFraction x = MFraction::variable(ring, "x"), r = MFraction::variable(ring, "r");
  VectorField v;
  v.ring = ring;
  v.coordinates = {0};
  v.functions = {{1, "r", {MFraction(ring)}}};
  v.components = {r};
  v.relations = {(x * r).num()};
  EXPECT_THAT(reducible_relations(v).value(), HasSubstr("solution"));
  v.relations = {(r * r - x).num()};
  EXPECT_FALSE(reducible_relations(v));
}

// A function r with r^2 = p in the variables x, y and parameters a, b; and a second one.
std::string special(const std::vector<std::string>& squares) {
  const Ring ring = make_ring({"x", "y", "r", "q", "a", "b"});
  const auto x = [&](const std::string& name) { return MFraction::variable(ring, name); };
  const MFraction X = x("x"), Y = x("y"), a = x("a"), b = x("b"), one(ring, Rational(1));
  const std::map<std::string, MFraction> known{
      {"ellipse", X * X + a * Y * Y},
      {"square at 1", X * X + (a + a) * X * Y * Y + Y * Y * Y * Y},
      {"never", X * X * X + a * Y},
      {"left", (X - a) * (X - a) + Y * Y},
      {"right", (X + a) * (X + a) + Y * Y},
      {"circle", X * X + Y * Y},
      {"two", X * X + a * Y * Y + b},
      {"inverse", a * X * X + b * Y * Y}};
  VectorField v;
  v.ring = ring;
  v.coordinates = {0, 1};
  v.parameters = {4, 5};
  const char* const names[] = {"r", "q"};
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const MFraction f = known.at(squares[i]), r = x(names[i]);
    const MFraction half = one / (r + r);
    v.functions.push_back({2 + i, names[i], {half * derivative(f, 0), half * derivative(f, 1)}});
    v.relations.push_back((r * r - f).num());
  }
  v.components = {one, one};
  std::string text;
  for (const MPoly& g : where_relations_fall_apart(v))
    text += (text.empty() ? "" : ", ") + to_factored_string(MFraction(g));
  return text;
}

TEST(Relations, SpecialValues) {
  EXPECT_EQ(special({"circle"}), "");
  EXPECT_EQ(special({"never"}), "a"); // r^2 = x^3 is one curve, but its branch points meet
  EXPECT_EQ(special({"ellipse"}), "a");
  EXPECT_THAT(special({"square at 1"}), testing::AllOf(HasSubstr("(a - 1)"), HasSubstr("(a + 1)")));
  EXPECT_THAT(special({"left", "right"}), HasSubstr("a"));
  EXPECT_THAT(special({"circle", "ellipse"}), HasSubstr("a - 1"));
  EXPECT_THAT(special({"inverse"}), testing::AllOf(HasSubstr("a"), HasSubstr("b")));
  EXPECT_NE(special({"two"}), "");
}

// r^2 = x^2 + y^2 + a and q^2 = u^2 + v^2 + b, or + a b: a product is special where a factor is.
TEST(Relations, SpecialValuesOfProducts) {
  const Ring ring = make_ring({"x", "y", "u", "v", "r", "q", "a", "b"});
  const auto x = [&](const char* name) { return MFraction::variable(ring, name); };
  const MFraction half = MFraction(ring, Rational(Integer(1), Integer(2)));
  const auto special_of = [&](const MFraction& f, const MFraction& g) {
    VectorField v;
    v.ring = ring;
    v.coordinates = {0, 1, 2, 3};
    v.parameters = {6, 7};
    v.components.assign(4, MFraction(ring, Rational(1)));
    for (const auto& [square, root] : {std::pair(f, 4), std::pair(g, 5)}) {
      const MFraction r = MFraction::variable(ring, static_cast<std::size_t>(root));
      FunctionSymbol symbol{static_cast<std::size_t>(root), ring->name(root), {}};
      for (std::size_t i = 0; i < 4; ++i)
        symbol.gradient.push_back(half / r * derivative(square, i));
      v.functions.push_back(std::move(symbol));
      v.relations.push_back((r * r - square).num());
    }
    return where_relations_fall_apart(v);
  };
  const MFraction sphere = x("x") * x("x") + x("y") * x("y") + x("a");
  const MFraction other = x("u") * x("u") + x("v") * x("v") + x("b");
  EXPECT_TRUE(special_of(sphere, other).empty());
  const auto all = special_of(sphere, x("u") * x("u") + x("b") * x("v") * x("v"));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(to_string(all.front()), "b");
  const auto both = special_of(x("x") * x("x") + x("a") * x("y") * x("y"),
                               x("u") * x("u") + x("b") * x("v") * x("v"));
  ASSERT_EQ(both.size(), 1U);
  EXPECT_EQ(to_string(both.front()), "a*b");
}

} // namespace
} // namespace kov::relations_test
