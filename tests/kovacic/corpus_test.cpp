// Every parameter-free equation of the public corpus, if that is there.

#include "kovacic/reader.hpp"
#include "kovacic/solve.hpp"
#include "support/source_dir.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdlib>
#include <fstream>

namespace kov::kovacic::corpus_test {
namespace {

// The parts of the group's name that this room can see.
std::string shape_of(const Outcome& outcome) {
  if (const auto* pair = std::get_if<ExponentialPair>(&outcome))
    return pair->every_line ? "every line" : "two lines";
  if (std::holds_alternative<Exponential>(outcome)) return "one line";
  if (case_of(outcome) == 2) return "imprimitive";
  if (const auto* algebraic = std::get_if<Algebraic>(&outcome)) {
    switch (algebraic->group) {
    case Primitive::tetrahedral:
      return "A4";
    case Primitive::octahedral:
      return "S4";
    case Primitive::icosahedral:
      return "A5";
    }
  }
  return std::holds_alternative<NoLiouvillian>(outcome) ? "SL2" : "unable";
}

std::string shape_of(const std::string& group) {
  if (group == "trivial" || group == "C_1" || group == "C_2") return "every line";
  if (group == "D" || group.substr(0, 2) == "C_") return "two lines";
  if (group == "B" || group == "Ga" || group.substr(0, 2) == "T_") return "one line";
  if (group == "Dinf" || group.substr(0, 2) == "D_") return "imprimitive";
  return group == "SL2" ? group : group.substr(0, 2);
}

RationalFunction equation_of(const nlohmann::json& entry) {
  std::string all;
  for (const char* key : {"r", "p", "q"})
    if (entry.contains(key)) all += entry[key].get<std::string>() + " ";
  Field k = testing::field_of(all);
  if (entry.contains("r")) return testing::read(entry["r"], k);
  return normal_form(testing::read(entry["p"], k), testing::read(entry["q"], k)).r;
}

TEST(Corpus, EveryEquationWithoutParameters) {
  const char* path = std::getenv("KOV_CORPUS");
  std::ifstream file(path != nullptr ? path : test::in_source("/tests/corpus/public.jsonl"));
  if (!file) GTEST_SKIP() << "no corpus at hand (set KOV_CORPUS)";
  int count = 0;
  double slowest = 0;
  for (std::string line; std::getline(file, line);) {
    const auto entry = nlohmann::json::parse(line);
    if (entry.contains("parameters")) continue;
    SCOPED_TRACE(entry["id"].get<std::string>());
    const auto start = std::chrono::steady_clock::now();
    const Outcome outcome = solve(equation_of(entry), Budget::of_seconds(60));
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (seconds > 0.05) std::cout << entry["id"] << ": " << seconds << " s\n";
    slowest = std::max(slowest, seconds);
    if (const auto* why = std::get_if<Unable>(&outcome)) ADD_FAILURE() << why->detail;
    EXPECT_EQ(case_of(outcome), entry["expected"]["kovacic_case"].get<int>());
    EXPECT_EQ(shape_of(outcome), shape_of(entry["expected"]["group"].get<std::string>()));
    ++count;
  }
  EXPECT_GT(count, 100);
  std::cout << count << " equations, slowest " << slowest << " s\n";
}

} // namespace
} // namespace kov::kovacic::corpus_test
