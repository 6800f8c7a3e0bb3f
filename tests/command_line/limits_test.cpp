// A limit may fall at any moment: then there is a result, a part of one, or one clear sentence on the
// limit, and never an internal error.

#include "clock.hpp"
#include "commands.hpp"
#include "equations/answer.hpp"
#include "systems/case_file.hpp"

#include "classify/classify.hpp"
#include "support/own_folder.hpp"
#include "symbol/notations.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <set>

namespace kov::cli::limits_test {
namespace {

using test::clock_jumps_at;
using test::clock_readings;
using test::own_folder;

constexpr double long_time = 1000; // so that there are deadlines

Settings with_deadlines() {
  Settings s;
  s.timeout = long_time;
  s.format = "json";
  return s;
}

// About `count` moments of those from 1 to `all`, the first ones and the last one among them.
std::set<long> moments(long all, long count) {
  std::set<long> some;
  for (long k = 1; k <= all && k <= count / 3; ++k)
    some.insert(k);
  for (long i = 1; i <= count; ++i)
    some.insert(std::max(1L, all * i / count));
  return some;
}

void check_limit_text(const std::string& all, const std::string& what) {
  EXPECT_EQ(all.find("internal"), std::string::npos) << what << ": " << all;
  EXPECT_EQ(all.find("an error of the program"), std::string::npos) << what << ": " << all;
}

// ---- solve

struct Asked {
  const char* ode;
  std::vector<std::string> parameters = {};
};

Answer answer(const Asked& q, const Settings& settings) {
  Solver solver(fixed_question([&] {
                  Question question;
                  question.text.ode = parse_ode(q.ode, "-e");
                  question.text.parameters = q.parameters;
                  return question;
                }),
                settings);
  return solver.answer("");
}

std::vector<Settings> ways_to_ask() {
  std::vector<Settings> all(3, with_deadlines());
  all[1].certificate = "proof.json";
  all[1].method = "all";
  all[2].second_opinion = true;
  return all;
}

TEST(Limits, AtAnyMomentOfSolve) {
  const std::vector<Asked> questions{{"y'' = z*y"},
                                     {"y'' + 2*I*y' - y = 0"},
                                     {"y'' = (16*z-3)/(16*z^2)*y"},
                                     {"y'' = (-3/(16*z^2) - 2/(9*(z-1)^2) + 3/(16*z*(z-1)))*y"},
                                     {"y'' = (1 - c/z^2)*y", {"c"}},
                                     {"y'' = (z^2 + a*z + b)*y", {"a", "b"}}};
  long cut_short = 0;
  for (const Asked& q : questions)
    for (const Settings& settings : ways_to_ask()) {
      clock_jumps_at(0);
      const Answer whole = answer(q, settings);
      ASSERT_NE(whole.exit, exit_internal) << q.ode << ": " << whole.internal;
      for (const long k : moments(clock_readings(), 12)) {
        clock_jumps_at(k);
        const Answer a = answer(q, settings);
        const std::string what = std::string(q.ode) + " at " + std::to_string(k);
        ASSERT_TRUE(a.exit == exit_decided || a.exit == exit_undecided)
            << what << ": " << a.internal;
        check_limit_text(dump(a.result), what);
        if (a.exit == exit_undecided) {
          ++cut_short;
          EXPECT_FALSE(a.result.at("undecided").is_null()) << what;
        }
        if (!a.result.at("group").is_null() && !whole.result.at("group").is_null()) {
          EXPECT_EQ(a.result.at("group"), whole.result.at("group")) << what;
        }
      }
    }
  EXPECT_GT(cut_short, 20); // the clock does jump
}

// ---- systems

struct Written {
  const char* name;
  const char* text;
};

constexpr Written henon_heiles{"henon_heiles.toml", R"toml(format = "equation/1"
[system]
kind = "hamiltonian"
coordinates = ["x", "y"]
momenta = ["px", "py"]
parameters = ["a"]
hamiltonian = "(px^2 + py^2)/2 + a*(x^2 + y^2)/2 + x^2*y - y^3/3"
[[manifold]]
name = "plane"
equations = ["x = 0", "px = 0"]
level = ["H = 1/12"]
)toml"};

constexpr Written polar{"polar.toml", R"toml(format = "equation/1"
[system]
kind = "lagrangian"
coordinates = ["r", "t"]
velocities = ["vr", "vt"]
parameters = ["a"]
lagrangian = "(vr^2 + r^2*vt^2)/2 - r^3*cos(t)*(a*sin(t)^2 + cos(t)^2)"
)toml"};

constexpr Written field{"field.toml", R"toml(format = "equation/1"
[system]
kind = "vector-field"
coordinates = ["x", "y", "z"]
parameters = ["b"]
[system.field]
x = "y*z"
y = "x*z - b*x"
z = "x*y"
)toml"};

std::string path_of(const Written& w) {
  const std::string path = own_folder() + w.name;
  std::ofstream(path) << w.text;
  return path;
}

TEST(Limits, AtAnyMomentOfCheck) {
  Settings settings = with_deadlines();
  settings.second_opinion = true;
  settings.certificate = own_folder() + "proofs";
  settings.order = 3;
  const std::string path = path_of(henon_heiles);
  clock_jumps_at(0);
  (void)check_case(settings, path);
  for (const long k : moments(clock_readings(), 20)) {
    clock_jumps_at(k);
    const CaseReport r = check_case(settings, path);
    EXPECT_NE(r.exit, exit_internal) << k << ": " << r.text;
    check_limit_text(r.text, std::to_string(k));
  }
}

std::string contents(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Every answer has the same shape: a status, a statement and strata.
void check_classification(const std::string& path, long count) {
  Settings settings = with_deadlines();
  settings.output = own_folder() + "answer.json";
  ClassifyArguments arguments;
  arguments.file = path;
  arguments.degree = 2;
  settings.order = 1;
  clock_jumps_at(0);
  ASSERT_NE(classify(settings, arguments), exit_internal);
  const Json whole = Json::parse(contents(settings.output));
  for (const long k : moments(clock_readings(), count)) {
    clock_jumps_at(k);
    const int exit = classify(settings, arguments);
    EXPECT_TRUE(exit == exit_decided || exit == exit_undecided) << path << " at " << k;
    const Json j = Json::parse(contents(settings.output));
    for (const auto& [key, value] : whole.items())
      EXPECT_TRUE(j.contains(key)) << path << " at " << k << ": no " << key;
    check_limit_text(j.dump(), path + " at " + std::to_string(k));
  }
}

TEST(Limits, AtAnyMomentOfClassify) {
  for (const Written& w : {henon_heiles, polar, field})
    check_classification(path_of(w), 12);
}

// Also for those who ask the library.
TEST(Limits, BeforeTheFirstStageAllParametersAreOpen) {
  for (const Written& w : {henon_heiles, polar, field}) {
    ClassifyOptions options;
    options.check.decide.budget.deadline = Budget::Clock::now() - std::chrono::seconds(1);
    const SystemClassification c = classify_system(read_system(path_of(w)), options);
    EXPECT_EQ(c.status(), Verdict::undecided) << w.name;
    ASSERT_FALSE(c.strata.empty()) << w.name;
    for (const ClassifiedStratum& s : c.strata)
      EXPECT_EQ(s.status, StratumStatus::open) << w.name;
  }
}

} // namespace
} // namespace kov::cli::limits_test
