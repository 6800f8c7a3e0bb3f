// Families with parameters: what is recognised, and every specialisation against the engines.

#include "closed/generic_form.hpp"

#include "closed/arithmetic.hpp"
#include "decide/decide.hpp"
#include "decide/words.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kov::generic_form_test {
namespace {

const Ring& ring() {
  static const Ring r = make_ring({"z", "a", "b", "c", "d"});
  return r;
}
MFraction var(const char* name) { return MFraction::variable(ring(), std::string_view(name)); }
MFraction num(long n, long d = 1) { return {ring(), Rational(n, d)}; }
const MFraction z() { return var("z"); }

std::optional<strata::GenericForm> generic_form(const MFraction& r) {
  return strata::generic_form(r, 0, ParametrisedSet(ring(), {}));
}

std::string value(const strata::GenericForm& f, const std::string& name) {
  for (const auto& [key, text] : f.numbers)
    if (key == name) return text;
  return "";
}

strata::GenericForm family(const MFraction& r, Classical name) {
  auto found = generic_form(r);
  if (!found) throw InternalError("nothing is recognised in " + to_string(r));
  EXPECT_EQ(found->answer.form.family, name) << to_string(r);
  return *std::move(found);
}

// At random parameter values one part holds, and the engines must say what it says.
void expect_specialisations(const MFraction& r, std::uint32_t seed) {
  const auto generic = generic_form(r);
  ASSERT_TRUE(generic);
  std::mt19937 gen(seed);
  for (int i = 0; i < 12; ++i) {
    Substitution at;
    for (std::size_t j = 1; j < ring()->size(); ++j)
      at[j] = num(static_cast<long>(gen() % 15) - 7, 1 + static_cast<long>(gen() % 3));
    if (std::ranges::any_of(generic->generic,
                            [&](const MPoly& g) { return is_zero(substitute(g, at)); }))
      continue;
    const RationalFunction special = to_rational_function(substitute(r, at), 0);
    if (is_zero(special)) continue;
    Options options;
    options.want_solutions = false;
    const Decision d = decide({.r = special, .p = RationalFunction()}, options);
    const auto value = [&](const MFraction& f) { return NfElem(to_rational(substitute(f, at))); };
    int there = 0;
    for (const strata::Part& p : generic->answer.parts) {
      if (!std::ranges::all_of(p.where, [&](const Statement& s) { return is_so(s, value); }))
        continue;
      ++there;
      EXPECT_EQ(p.abelian, d.abelian) << to_string(special) << ": " << reason(d);
      if (p.group && d.group) {
        EXPECT_EQ(p.group->type, d.group->type) << to_string(special) << ": " << describe(*d.group);
      }
    }
    EXPECT_EQ(there, 1) << to_string(special);
  }
}

TEST(GenericForm, BesselWhittakerWeber) {
  const MFraction bessel = (num(4) * var("a") * var("a") - num(1)) / (num(4) * z() * z()) - num(1);
  EXPECT_EQ(value(family(bessel, Classical::bessel), "m"), "a");
  EXPECT_TRUE(family(bessel, Classical::bessel).generic.empty());
  const MFraction whittaker =
      num(1, 4) - var("a") / z() + (var("b") * var("b") - num(1, 4)) / (z() * z());
  EXPECT_EQ(value(family(whittaker, Classical::whittaker), "k"), "a");
  EXPECT_EQ(value(family(whittaker, Classical::whittaker), "m"), "b");
  const MFraction weber = z() * z() / num(4) - num(1, 2) - var("a");
  EXPECT_EQ(value(family(weber, Classical::weber), "a_1"), "2*a + 1");
  EXPECT_EQ(family(weber, Classical::weber).abelian(), Truth::no);
  const MFraction airy = z() + var("a");
  EXPECT_EQ(family(airy, Classical::airy).abelian(), Truth::no);
  const MFraction moved =
      var("a") + var("b") / (z() - var("c")) + var("d") / ((z() - var("c")) * (z() - var("c")));
  EXPECT_EQ(value(family(moved, Classical::whittaker), "k"), "sqrt(b^2/(4*a))");
  const MFraction inner = num(1) / pow(z() - var("c"), 4) + var("d") / pow(z() - var("c"), 2);
  EXPECT_EQ(value(family(inner, Classical::bessel), "m"), "sqrt((4*d + 1)/4)");
  const MFraction ramified = var("b") / z() + var("d") / (z() * z());
  EXPECT_EQ(value(family(ramified, Classical::bessel), "m"), "sqrt(4*d + 1)");
  std::uint32_t seed = 1;
  for (const MFraction& r : {bessel, whittaker, weber, airy, moved, inner, ramified})
    expect_specialisations(r, seed++);
}

TEST(GenericForm, RegularOnes) {
  EXPECT_EQ(family(var("a") / (z() * z()), Classical::euler).abelian(), Truth::yes);
  // Gauss: exponents c - 1, a + b - c, a - b
  const MFraction p = (var("c") - (var("a") + var("b") + num(1)) * z()) / (z() * (num(1) - z()));
  const MFraction q = -(var("a") * var("b")) / (z() * (num(1) - z()));
  const MFraction gauss = p * p / num(4) + derivative(p, 0) / num(2) - q;
  EXPECT_EQ(value(family(gauss, Classical::riemann), "l"), "c - 1");
  EXPECT_EQ(value(family(gauss, Classical::riemann), "m"), "a + b - c");
  EXPECT_EQ(value(family(gauss, Classical::riemann), "n"), "a - b");
  EXPECT_TRUE(family(gauss, Classical::riemann).generic.empty());
  const MFraction three = var("a") / pow(z() - var("b"), 2) + num(2) / pow(z(), 2) +
                          var("c") / (z() * (z() - var("b")));
  EXPECT_EQ(family(three, Classical::riemann).generic.size(), 1U); // b != 0
  std::uint32_t seed = 20;
  for (const MFraction& r : {gauss, three, MFraction(var("a") / (z() * z()))})
    expect_specialisations(r, seed++);
}

TEST(GenericForm, OneExponentIsFree) { // a homogeneous potential of degree 3
  const MFraction p = (num(4) * (num(1) - z()) - num(3) * z()) / (num(6) * z() * (num(1) - z()));
  const MFraction q = var("a") / (num(6) * z() * (num(1) - z()));
  const MFraction r = p * p / num(4) + derivative(p, 0) / num(2) - q;
  const strata::GenericForm f = family(r, Classical::riemann);
  EXPECT_EQ(value(f, "n"), "sqrt((24*a + 1)/36)");
  EXPECT_EQ(f.abelian(), Truth::unknown);
  expect_specialisations(r, 40);
}

TEST(GenericForm, NothingElse) {
  EXPECT_FALSE(generic_form(num(0)));
  EXPECT_FALSE(generic_form(num(1) / (pow(z(), 5) - var("a"))));
  EXPECT_FALSE(generic_form(z() + var("a") / z()));
}

} // namespace
} // namespace kov::generic_form_test
