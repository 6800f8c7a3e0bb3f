// Only the effects of a scene: what nothing drawn or watched depends on costs nothing, since the same program
// runs; effect_instructions_test.py counts its instructions.

#include "flow/scene/effects_needed.hpp"
#include "flow/scene/section_stage.hpp"
#include "flow/scene/system_section.hpp"

#include "symbol/document.hpp"

#include <gtest/gtest.h>

namespace kov::flow::only_effects_test {
namespace {

struct Text {
  std::string coordinates = "'x', 'y'", momenta = "'u', 'v'", head, extra, scene;
  std::string hamiltonian = "(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3";
  std::string states = "['1/5', 0, '3/10', '1/10'], [0, '1/10', '2/5', '-1/10'], ['-1/10', '3/10', "
                       "'1/4', '1/5'], ['1/7', '-1/5', '1/3', 0]";
};

SystemScene scene_of(const Text& t, int crossings = 100) {
  return read_system_scenes(
             parse_document("[system]\nkind = 'hamiltonian'\ncoordinates = [" + t.coordinates +
                                "]\nmomenta = [" + t.momenta + "]\n" + t.head + "hamiltonian = '" +
                                t.hamiltonian + "'\n" + t.extra + "[scene]\n" + t.scene +
                                "section = 'x'\nplot = ['y', 'v']\nstates = [" + t.states +
                                "]\ncrossings = " + std::to_string(crossings) + "\n",
                            "test.toml"))
      .front();
}

std::map<std::string, Text> absent_effects() {
  const std::string h = Text{}.hamiltonian;
  std::map<std::string, Text> all;
  all["a term that is zero"].hamiltonian = h + " + 0*x^3*y + (1/3 - 1/3)*y^4";
  Text& p = all["parameters that are zero"];
  p.head = "parameters = ['a', 'b']\n";
  p.hamiltonian = h + " + a*x^4 + b*x^3*y^2";
  p.scene = "set = {a = 0, b = 0}\n";
  Text& root = all["roots that cancel"] = p;
  root.scene = "set = {a = 'sqrt(2) - sqrt(2)', b = 'pi - pi'}\n";
  all["functions that nothing uses"].extra =
      "[[system.function]]\nname = 's'\nmeans = 'sin(x)'\nderivative = {x = 'c'}\n"
      "[[system.function]]\nname = 'c'\nmeans = 'cos(x)'\nderivative = {x = '-s'}\n";
  Text& still = all["a coordinate that nothing depends on"];
  still.coordinates += ", 'z'";
  still.momenta += ", 'w'";
  still.states = "['1/5', 0, 0, '3/10', '1/10', 0], [0, '1/10', 0, '2/5', '-1/10', 0], ['-1/10', "
                 "'3/10', 0, '1/4', '1/5', 0], ['1/7', '-1/5', 0, '1/3', 0, 0]";
  return all;
}

TEST(OnlyEffects, AbsentOnesLeaveTheSameProgramAndThePoints) {
  const SystemScene plain = scene_of({});
  const SystemSection wanted = simulate(plain);
  const Stage stage(plain, nullptr);
  for (const auto& [what, text] : absent_effects()) {
    const SystemScene scene = scene_of(text), less = without_idle_coordinates(scene);
    const Stage other(less, nullptr);
    EXPECT_EQ(other.field.variables().size(), stage.field.variables().size()) << what;
    EXPECT_EQ(other.field.numbers().size(), 0U) << what;
    EXPECT_EQ(other.integrals.size(), stage.integrals.size()) << what;
    EXPECT_EQ(other.field.cost(), stage.field.cost()) << what;
    const SystemSection s = simulate(scene);
    ASSERT_EQ(s.points.size(), wanted.points.size()) << what;
    for (std::size_t i = 0; i < s.points.size(); ++i)
      EXPECT_EQ(s.points[i].at, wanted.points[i].at) << what;
    for (std::size_t i = 0; i < s.orbits.size(); ++i)
      EXPECT_EQ(s.orbits[i].steps, wanted.orbits[i].steps) << what;
  }
}

// ---- what must stay ----

TEST(OnlyEffects, WhatIsDrawnWatchedOrCoupledStays) {
  Text coupled = absent_effects().at("a coordinate that nothing depends on");
  coupled.hamiltonian += " + w^2/2 + z^2/2"; // H is watched
  EXPECT_EQ(without_idle_coordinates(scene_of(coupled)).system.field.dimension(), 6U);
  Text drawn = absent_effects().at("a coordinate that nothing depends on");
  drawn.scene = "where = 'z + 1'\n";
  EXPECT_EQ(without_idle_coordinates(scene_of(drawn)).system.field.dimension(), 5U);
  Text exponents = absent_effects().at("a coordinate that nothing depends on");
  exponents.scene = "indicator = 'lyapunov'\n"; // of every direction
  EXPECT_EQ(without_idle_coordinates(scene_of(exponents)).system.field.dimension(), 6U);
  Text used;
  used.hamiltonian += " + c/100";
  used.extra = absent_effects().at("functions that nothing uses").extra;
  EXPECT_EQ(watched(scene_of(used)).size(), 2U); // H, s^2 + c^2 - 1
  Text watching;
  watching.extra = used.extra + "[[integral]]\nname = 'J'\nvalue = '" + Text{}.hamiltonian + "'\n";
  EXPECT_EQ(watched(scene_of(watching)).size(), 1U);
}

TEST(OnlyEffects, AFieldWithoutAHamiltonian) {
  const auto scene = [](const std::string& more, const std::string& field,
                        const std::string& states) {
    return read_system_scenes(
               parse_document("[system]\nkind = 'vector-field'\ncoordinates = ['x', 'y'" + more +
                                  "]\n[system.field]\nx = 'y'\ny = '-x - x^3'\n" + field +
                                  "[scene]\nsection = 'x'\nplot = ['x', 'y']\nstates = [" + states +
                                  "]\ncrossings = 30\n",
                              "test.toml"))
        .front();
  };
  const SystemSection alone = simulate(scene("", "", "[1, 0]"));
  const SystemSection beside =
      simulate(scene(", 'z', 'w'", "z = 'w*z + x'\nw = '-w^2 - 1'\n", "[1, 0, 2, 3]"));
  ASSERT_EQ(alone.points.size(), beside.points.size());
  for (std::size_t i = 0; i < alone.points.size(); ++i)
    EXPECT_EQ(alone.points[i].at, beside.points[i].at);
}

} // namespace
} // namespace kov::flow::only_effects_test
