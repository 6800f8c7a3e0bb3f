// The kernels against the vector field that lib/system derives, exactly, from the system files of
// the paper.

#include "flow/number/dual.hpp"
#include "flow/orbit/jets.hpp"
#include "support.hpp"

#include "support/source_dir.hpp"
#include "system/system.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kov::flow {
namespace {

using DualRational = Dual<Rational>;

Rational dice(std::mt19937& gen) {
  std::uniform_int_distribution<long> pick(1, 19);
  return (pick(gen) % 2 == 0 ? Rational(1) : Rational(-1)) * Rational(pick(gen)) /
         Rational(pick(gen));
}

std::string text(const Rational& q) { return "(" + to_string(q) + ")"; }

// A body with principal axes and everything else, and its values for the parameters of a system
// file.
struct Sample {
  Body<Rational> body;
  State<Rational> x;
  std::vector<std::pair<std::string, Rational>> parameters;
  Sample(std::mt19937& gen, bool gyrostat) {
    for (int i = 0; i < 3; ++i) {
      body.inertia[i][i] = Rational(4 + i) / Rational(3);
      body.lever[i] = dice(gen);
      if (gyrostat) body.gyrostat[i] = dice(gen);
      x.omega[i] = dice(gen);
      x.gamma[i] = dice(gen);
    }
    body.mass = Rational(3) / Rational(2);
    body.gravity = Rational(7) / Rational(5);
    body.sliding = true;
    const char* moments[] = {"A", "B", "C"};
    for (int i = 0; i < 3; ++i) {
      parameters.emplace_back(moments[i], body.inertia[i][i]);
      parameters.emplace_back("L" + std::to_string(i + 1), body.lever[i]);
      if (gyrostat) parameters.emplace_back("B" + std::to_string(i + 1), body.gyrostat[i]);
    }
    parameters.emplace_back("m", body.mass);
    parameters.emplace_back("g", body.gravity);
  }
};

// M' and Gamma' by the kernel: its first Taylor coefficients, pushed forward by the map Omega -> M.
std::vector<Rational> by_kernel(const Sample& s) {
  constexpr Effects e{true, true, true, false, false};
  const Model<Rational> model = model_of(s.body, e);
  std::vector<Rational> memory(static_cast<std::size_t>(Jet<Rational>::count) * 3);
  Jet<Rational> jet{};
  for (int i = 0; i < Jet<Rational>::count; ++i)
    jet.s[i] = memory.data() + static_cast<std::ptrdiff_t>(i) * 3;
  for (int i = 0; i < 3; ++i) {
    jet.s[i][0] = s.x.omega[i];
    jet.s[3 + i][0] = s.x.gamma[i];
  }
  jets<e, Rational>(model, jet, 1);
  Body<DualRational> body;
  State<DualRational> x;
  for (int i = 0; i < 3; ++i) {
    body.inertia[i][i] = DualRational(s.body.inertia[i][i]);
    body.lever[i] = DualRational(s.body.lever[i]);
    x.omega[i] = DualRational(s.x.omega[i], jet.s[i][1], Rational());
    x.gamma[i] = DualRational(s.x.gamma[i], jet.s[3 + i][1], Rational());
  }
  body.mass = DualRational(s.body.mass);
  body.sliding = true;
  const Vec<DualRational> m = momentum(body, x);
  return {m[0].d[0], m[1].d[0], m[2].d[0], jet.s[3][1], jet.s[4][1], jet.s[5][1]};
}

// The same by the symbolic side.
std::vector<Rational> by_system(const std::string& file, const Sample& s) {
  ParameterValues settings;
  for (const auto& [name, value] : s.parameters)
    settings.emplace_back(name, text(value));
  const System system = read_system(kov::test::in_source("/cases/sliding_top/") + file, settings);
  const Vec<Rational> m = momentum(s.body, s.x);
  Substitution at;
  for (int i = 0; i < 3; ++i) {
    at.emplace(system.field.coordinates[i], formula(system, text(m[i])));
    at.emplace(system.field.coordinates[3 + i], formula(system, text(s.x.gamma[i])));
  }
  std::vector<Rational> out;
  for (const MFraction& component : system.field.components)
    out.push_back(to_rational(substitute(component, at)));
  return out;
}

TEST(SymbolicField, TheKernelIsTheFieldOfTheSystemFiles) {
  std::mt19937 gen(11);
  for (const bool gyrostat : {false, true})
    for (int trial = 0; trial < 5; ++trial) {
      const Sample s(gen, gyrostat);
      EXPECT_EQ(by_kernel(s), by_system(gyrostat ? "gyrostat.toml" : "sliding_top.toml", s));
    }
}

} // namespace
} // namespace kov::flow
