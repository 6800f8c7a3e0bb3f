#include "flow/chaos/periodic_orbit.hpp"

#include "exact/number_field.hpp"
#include "support.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kov::flow::quantity_test {
namespace {

using namespace test;

std::string term(long n, long d, long p) {
  return std::to_string(n) + "/" + std::to_string(d) + "*10^" +
         (p < 0 ? "(" + std::to_string(p) + ")" : std::to_string(p));
}

Rational power_of_ten(long p) {
  const Integer n = pow(Integer(10), static_cast<unsigned long>(std::abs(p)));
  return p < 0 ? Rational(Integer(1), n) : Rational(n);
}

// Formulas whose value in double is 0 where it is not, or not 0 where it is.
const std::pair<const char*, int> signs[] = {{"10^30+8/9-10^30", 1},
                                             {"10^30-8/9-10^30", -1},
                                             {"1/10+2/10-3/10", 0},
                                             {"1/3*3-1", 0},
                                             {"10^-400", 1},
                                             {"-1/10^400", -1},
                                             {"10^400-10^400", 0},
                                             {"sqrt(2)*sqrt(3)-sqrt(6)", 0},
                                             {"sqrt(2)*sqrt(3)-sqrt(6)+10^-300", 1},
                                             {"1/(sqrt(2)-1)-1-sqrt(2)", 0},
                                             {"sqrt(5+2*sqrt(6))-sqrt(2)-sqrt(3)", 0},
                                             {"10^20+pi-10^20-pi", 0},
                                             {"pi*(1/pi)-1", 0},
                                             {"sqrt(pi^2)-pi", 0},
                                             {"pi-314159265358979/10^14", 1},
                                             {"sqrt(1/9-1/9)", 0}};

TEST(Quantity, SignsAreExact) {
  for (const auto& [text, sign] : signs)
    EXPECT_EQ(Quantity(text).sign(), sign) << text;
}

TEST(Quantity, RoundedValuesAreThoseOfTheFormula) {
  EXPECT_EQ(Quantity("10^30+8/9-10^30").as<double>(), 8.0 / 9);
  EXPECT_EQ(Quantity("(10^30+pi)-10^30").as<double>(), M_PI);
  EXPECT_EQ(Quantity("1/10+2/10-3/10").as<double>(), 0);
  EXPECT_DOUBLE_EQ(Quantity("10^-400").shifted(1329).as<double>(),
                   std::ldexp(1e-200, 665) * std::ldexp(1e-200, 664));
  EXPECT_EQ(Quantity("10^400").shifted(-1300).as<double>(), Quantity("10^400/2^1300").as<double>());
  const std::string long_number(6000, '7');
  EXPECT_TRUE(std::isinf(Quantity(long_number.c_str()).as<double>()));
  EXPECT_EQ(Quantity((long_number + "/" + long_number + "0").c_str()).as<double>(), 0.1);
}

// Random rational formulas with terms that cancel, beside exact arithmetic.
TEST(Quantity, RandomFormulas) {
  std::mt19937_64 random(2026);
  const auto number = [&](long most) { return static_cast<long>(random() % most) + 1; };
  for (int i = 0; i < 300; ++i) {
    std::string text = "0";
    Rational value;
    std::vector<std::pair<std::string, Rational>> terms;
    for (long k = number(4); k > 0; --k) {
      const long n = number(1000), d = number(1000), p = number(60) - 30;
      terms.emplace_back(term(n, d, p), Rational(n) / Rational(d) * power_of_ten(p));
    }
    for (const auto& [t, v] : terms) {
      text += "+" + t;
      value += v;
    }
    const bool all = random() % 2 == 0; // and away again, all or all but one
    for (std::size_t k = all ? 0 : 1; k < terms.size(); ++k) {
      text += "-" + terms[k].first;
      value -= terms[k].second;
    }
    const Quantity q(text.c_str());
    EXPECT_EQ(q.sign(), value < Rational(0) ? -1 : Rational(0) < value ? 1 : 0) << text;
    EXPECT_EQ(q.as<double>(), Quantity(to_string(value).c_str()).as<double>()) << text;
  }
}

TEST(Quantity, WhatIsNoNumberIsRefused) {
  for (const char* text :
       {"1/(1/10+2/10-3/10)", "sqrt(1/10+2/10-3/10-10^-100)", "2^(1+10^-60)",
        "(sqrt(2)*sqrt(3)-sqrt(6))^-1", "2^10000", "x", "sin(1)", "((10^9999)^9999)^99"})
    EXPECT_THROW((void)Quantity(text), InputError) << text;
}

std::string scene_with(const std::string& body) {
  return "format = \"scene/1\"\n[body]\n" + body +
         "\n[levels]\nH = \"3/2\"\nF2 = \"1/20\"\n[orbits]\nseeds = [[\"pi/2\", 0]]\ncrossings = "
         "2\n";
}

// A term is there exactly if its number is not 0, whatever the number looks like in double.
TEST(Effects, AreThereByExactSigns) {
  const std::string inertia = "inertia = [1, \"2/3\", \"1/2\"]\n";
  const auto energy = [](const std::string& body) {
    return to_string(*system_of(parse_scene(scene_with(body), "test")).system.field.hamiltonian);
  };
  const auto matters = [&](const std::string& before, const std::string& number,
                           const std::string& after) {
    const std::string nothing = energy(before + "\"0\"" + after);
    return energy(before + "\"" + number + "\"" + after) != nothing;
  };
  for (const auto& [text, sign] : signs) {
    const bool there = sign != 0;
    EXPECT_EQ(matters(inertia + "tip = \"fixed\"\nlever = [1, 0, 0]\ngravity = ", text, ""), there);
    EXPECT_EQ(matters(inertia + "tip = \"sliding\"\nlever = [0, ", text, ", 1]"), there) << text;
    EXPECT_EQ(matters(inertia + "tip = \"fixed\"\ngyrostat = [0, 0, ", text, "]"), there) << text;
  }
}

// The same number, written so that its double is 0: the same periodic orbit, with the same
// multipliers.
TEST(Effects, AProvedFixedPointBelongsToTheSystemOfTheScene) {
  const Scene s = parse_scene(scene_with("inertia = [1, \"2/3\", \"1/2\"]\ntip = "
                                         "\"sliding\"\nlever = [\"10^30+8/9-10^30\", 0, 0]"),
                              "test");
  const SystemScene scene = system_of(s);
  const SectionSurface surface(scene);
  QuickMap quick(surface);
  const EnclosureScope scope(128);
  EnclosedMap map(surface, nullptr);
  PeriodicOrbit guess;
  guess.points.push_back({test::states_over(scene, M_PI / 2, 0).back()});
  const PeriodicOrbit p = prove_orbit(map, quick, guess);
  EXPECT_TRUE(p.proved) << to_string(p.why);
  EXPECT_NEAR(p.trace, 2 * 0.911505023, 1e-8); // of docs/gallery.md, with the lever 8/9
}

// What a scene must be is decided exactly, too.
TEST(Scene, ConditionsAreExact) {
  const auto refuses = [](const std::string& text) {
    EXPECT_THROW((void)parse_scene(text, "test"), InputError) << text;
  };
  const auto accepts = [](const std::string& text) {
    EXPECT_NO_THROW((void)parse_scene(text, "test")) << text;
  };
  const std::string tip = "tip = \"fixed\"\n";
  accepts(scene_with(tip + "inertia = [1, \"1/3\", \"2/3\"]")); // flat: equality holds
  refuses(scene_with(tip + "inertia = [\"1+10^-30\", \"1/3\", \"2/3\"]"));
  accepts(scene_with(tip + "inertia = [\"1-10^-30\", \"1/3\", \"2/3\"]"));
  refuses(scene_with(tip + "inertia = [\"1/10+2/10-3/10\", 1, 1]"));
  refuses(scene_with(tip + "inertia = [[1, \"10^-30\", 0], [0, 1, 0], [0, 0, 1]]"));
  refuses(scene_with(tip + "inertia = [1, 1, 1]\nmass = \"1/10+2/10-3/10\""));
  accepts(scene_with(tip + "inertia = [1, 1, 1]\nmass = \"10^-400\""));
  const std::string body = scene_with(tip + "inertia = [1, 1, 1]");
  refuses(body + "[section]\nangle = \"pi/2+10^-13\"\n");
  accepts(body + "[section]\nangle = \"3*pi/4-pi/4\"\n");
  accepts(body + "[section]\nangle = \"3*pi/2\"\n");
}

} // namespace
} // namespace kov::flow::quantity_test
