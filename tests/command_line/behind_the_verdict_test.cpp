// What fails behind a verdict (solutions, certificate, special functions, second opinion, layout) costs
// this part only: the verdict stays, with one sentence on the part.  What contradicts it does not.

#include "equations/answer.hpp"
#include "equations/present.hpp"
#include "systems/case_file.hpp"

#include "classify/classify.hpp"
#include "decide/afterwards.hpp"
#include "support/own_folder.hpp"
#include "symbol/notations.hpp"
#include "system/system.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <fstream>
#include <new>
#include <random>

#include <sys/mman.h>

namespace kov::cli::behind_the_verdict_test {
namespace {

using test::own_folder;

constexpr const char* sentence = "an error of the program in ";

struct Asked {
  const char* ode;
  const char* group; ///< null: with parameters
  std::vector<std::string> parameters = {};
};

// One of each kind of group, some with a factor of the given equation, some with parameters.
const std::vector<Asked>& questions() {
  static const std::vector<Asked> all{
      {"y'' = z*y", "SL2"},
      {"y'' = (z^2+3)*y", "Borel"},
      {"y'' + 2/z*y' + y = 0", "Gm"},
      {"y'' + 2*I*y' - y = 0", "cyclic"},
      {"y'' = (16*z-3)/(16*z^2)*y", "Dinf"},
      {"y'' = (-3/(16*z^2) - 2/(9*(z-1)^2) + 3/(16*z*(z-1)))*y", "A4"},
      {"y'' = (1 - c/z^2)*y", nullptr, {"c"}}};
  return all;
}

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

// Looks at parts, in this process and its workers.
std::atomic<int>& looks() {
  static auto* shared = new (::mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE,
                                    MAP_SHARED | MAP_ANONYMOUS, -1, 0)) std::atomic<int>{0};
  return *shared;
}

// Throws at the k-th look; 0: never.
template <class E> PartObserver failing_at(int k) {
  looks() = 0;
  return [k](std::string_view part) {
    if (++looks() == k) throw E("injected into " + std::string(part));
  };
}

struct Observed {
  explicit Observed(PartObserver o) { observe_parts(std::move(o)); }
  ~Observed() { observe_parts({}); }
  Observed(const Observed&) = delete;
  Observed& operator=(const Observed&) = delete;
};

void expect_same_verdict(const Answer& a, const Answer& whole, const std::string& what) {
  ASSERT_FALSE(a.result.is_null()) << what << ": " << a.internal;
  for (const char* key : {"group", "identity_component", "abelian", "case"})
    EXPECT_EQ(a.result.at(key), whole.result.at(key)) << what;
}

Json without_time(Json result) {
  result.erase("seconds");
  return result;
}

// A proof and a comparison that were asked for are missing then; what is told early, and again at the
// end, misses nothing.
void expect_failure_is_told(const Answer& a, const Answer& whole, const Settings& settings,
                            const std::string& what) {
  expect_same_verdict(a, whole, what);
  if (without_time(a.result) == without_time(whole.result)) return;
  const std::string all = dump(a.result);
  EXPECT_NE(all.find(sentence), std::string::npos) << what << ": " << all;
  const bool asked_for = all.find("no_certificate") != std::string::npos ||
                         all.find("algorithm stopped") != std::string::npos;
  EXPECT_TRUE(a.exit == whole.exit || (asked_for && a.exit == exit_undecided)) << what << all;
  const std::string missing = a.result.value("no_certificate", ""); // present() says it
  EXPECT_NE((presented(settings, a, "") + missing).find("injected"), std::string::npos) << what;
}

// Matrices take long, and are asked for of one equation.
std::vector<std::pair<const char*, Settings>> ways_to_ask(const Asked& q) {
  Settings plain, proved, compared, all;
  proved.certificate = "proof.json";
  compared.second_opinion = true;
  all.method = "all";
  all.trace = true;
  all.polynomial_of_y = true;
  std::vector<std::pair<const char*, Settings>> ways{{"plain", plain}, {"proved", proved}};
  if (&q == &questions().front()) ways.emplace_back("compared", compared);
  if (std::string(q.group == nullptr ? "" : q.group) == "A4") ways.emplace_back("all", all);
  return ways;
}

TEST(BehindTheVerdict, AnErrorInAnyPartLeavesTheVerdict) {
  for (const Asked& q : questions())
    for (const auto& [name, settings] : ways_to_ask(q)) {
      const Observed counted(failing_at<InternalError>(0));
      const Answer whole = answer(q, settings);
      const int all = looks();
      ASSERT_NE(whole.exit, exit_internal) << q.ode << ", " << name << ": " << whole.internal;
      if (q.group != nullptr) {
        ASSERT_EQ(whole.result.at("group").at("type"), q.group) << q.ode;
        ASSERT_GT(all, 3) << q.ode;
      }
      for (int k = 1; k <= all; ++k) {
        const Observed failing(failing_at<InternalError>(k));
        const std::string what = std::string(q.ode) + ", " + name + ", " + std::to_string(k);
        expect_failure_is_told(answer(q, settings), whole, settings, what);
      }
    }
}

// The text, the page and the scripts; the sentence is a comment in them.
TEST(BehindTheVerdict, AnErrorInTheLayoutLeavesTheVerdict) {
  for (const char* format : {"text", "json", "tex", "sympy", "maxima", "sage"}) {
    Settings settings;
    settings.format = format;
    const Answer whole = answer(questions().front(), settings);
    const Observed failing(failing_at<std::runtime_error>(1));
    const std::string text = presented(settings, whole, "");
    EXPECT_NE(text.find("SL2"), std::string::npos) << text;
    EXPECT_NE(text.find(std::string(sentence) + "the layout: injected"), std::string::npos) << text;
  }
}

TEST(BehindTheVerdict, AContradictionWithdrawsTheVerdict) {
  for (const Asked& q : questions()) {
    const Observed failing(failing_at<Contradiction>(2));
    const Answer a = answer(q, {});
    if (a.exit != exit_internal) continue; // fewer parts
    EXPECT_TRUE(a.result.is_null() || a.result.at("group").is_null()) << q.ode;
  }
  const Observed failing(failing_at<Contradiction>(1));
  EXPECT_EQ(answer(questions().front(), {}).exit, exit_internal);
}

// Libraries end the process where they give up.
TEST(BehindTheVerdict, ACrashLeavesTheVerdict) {
  for (const char* part : {"the solutions", "the search for special functions"}) {
    const Observed crashing([&](std::string_view p) {
      if (p == part) std::raise(SIGSEGV);
    });
    const Answer a = answer(questions().front(), {});
    EXPECT_EQ(a.exit, exit_decided) << part << ": " << a.internal;
    EXPECT_EQ(a.result.at("group").at("type"), "SL2");
    EXPECT_NE(dump(a.result).find("signal 11"), std::string::npos);
  }
}

// The lines of a batch are answered by the same jobs, and take their verdicts from them.
TEST(BehindTheVerdict, ALineOfABatchKeepsIt) {
  Settings settings;
  settings.in_a_batch = true;
  settings.special_functions = true;
  for (const bool crash : {false, true}) {
    const Observed failing([&](std::string_view p) {
      if (p != "the search for special functions") return;
      if (crash) std::raise(SIGSEGV);
      throw InternalError("injected");
    });
    Solver solver(fixed_question([&] {
                    Question q;
                    q.text.r = parse_expression("1/(z^3-2)", "-r");
                    return q;
                  }),
                  settings);
    solver.begin("");
    std::optional<Solver::Line> line;
    while (!line) {
      Worker::wait({&solver.worker()}, -1);
      line = solver.finished();
    }
    EXPECT_EQ(line->exit, exit_decided) << line->text;
    EXPECT_NE(line->text.find("\"SL2\""), std::string::npos) << line->text;
    EXPECT_NE(line->text.find(sentence), std::string::npos) << line->text;
  }
}

// ---- the searches behind the verdict meet equations of all kinds

Answer answer(const RationalFunction& r) {
  const std::string text = "y'' = (" + to_string(r) + ")*y";
  return answer(Asked{text.c_str(), nullptr}, {});
}

void expect_no_failure(const RationalFunction& r) {
  const Answer a = answer(r);
  ASSERT_EQ(a.exit, exit_decided) << to_string(r) << ": " << a.internal;
  EXPECT_FALSE(a.result.contains("failed")) << a.result;
  EXPECT_FALSE(a.result.at("group").is_null()) << a.result;
}

TEST(BehindTheVerdict, SimplePolesHaveVerdicts) {
  const Poly z = Poly::z();
  for (const long c : {1, -2})
    for (const long a : {2, -1, -5})
      expect_no_failure({Poly(c), z * (z - Poly(1)) * (z - Poly(a))});
  for (const long n : {2, 3, 4})
    for (const long a : {2, -1})
      expect_no_failure({Poly(1), pow(z, static_cast<unsigned long>(n)) - Poly(a)});
}

// Heun's equations: four regular places, differences of exponents 0, 1/2, 1, 3/2, 2 or a third.
TEST(BehindTheVerdict, RandomHeunEquationsHaveVerdicts) {
  std::mt19937 random(20261126);
  const Poly z = Poly::z();
  const std::vector<Rational> differences{Rational(0),    Rational(1, 2), Rational(1),
                                          Rational(3, 2), Rational(2),    Rational(1, 3)};
  for (int round = 0; round < 12; ++round) {
    const auto residue = [&] {
      const Rational d = differences[random() % differences.size()];
      return NfElem((d * d - Rational(1)) / Rational(4));
    };
    const Poly x = z, y = z - Poly(1), w = z - Poly(static_cast<long>(2 + random() % 4));
    RationalFunction r(0);
    for (const Poly& p : {x, y, w})
      r += RationalFunction(Poly(residue()), p * p);
    const Poly above = scale(z, residue()) + Poly(static_cast<long>(random() % 7) - 3);
    r += RationalFunction(above, x * y * w);
    expect_no_failure(r);
  }
}

// ---- systems

constexpr const char* henon_heiles = R"toml(format = "equation/1"
[system]
kind = "hamiltonian"
coordinates = ["x", "y"]
momenta = ["px", "py"]
hamiltonian = "(px^2 + py^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3"
[[manifold]]
name = "plane"
equations = ["x = 0", "px = 0"]
level = ["H = 1/12"]
)toml";

Json without_times(Json rounds) {
  for (Json& round : rounds)
    round.erase("seconds");
  return rounds;
}

std::string system_file() {
  const std::string path = own_folder() + "henon_heiles.toml";
  std::ofstream(path) << henon_heiles;
  return path;
}

TEST(BehindTheVerdict, AnErrorBehindTheVerdictOnASystemLeavesIt) {
  Settings settings;
  settings.format = "json";
  settings.second_opinion = true;
  settings.certificate = own_folder() + "proofs";
  const std::string path = system_file();
  const CaseReport whole = check_case(settings, path);
  const auto verdict = [](const CaseReport& r) {
    return r.json.at(0).at("manifolds").at(0).at("verdict").get<std::string>();
  };
  ASSERT_EQ(verdict(whole), "non-integrable");
  const Observed counted(failing_at<InternalError>(0));
  (void)check_case(settings, path);
  const int all = looks();
  EXPECT_GT(all, 4);
  for (int k = 1; k <= all; k += 3) { // matrices take long
    const Observed failing(failing_at<InternalError>(k));
    const CaseReport r = check_case(settings, path);
    EXPECT_EQ(r.exit, whole.exit) << k;
    EXPECT_EQ(verdict(r), "non-integrable") << r.text;
    if (without_times(r.json) == without_times(whole.json)) continue; // nothing is missing
    EXPECT_NE(r.json.dump().find(sentence), std::string::npos) << k << r.text;
  }
}

// A stage of the classification that fails leaves what those before it have proved.
TEST(BehindTheVerdict, AClassificationKeepsWhatWasProved) {
  const System s = read_system(parse_document(
      "system = {kind = 'hamiltonian', coordinates = ['x', 'y'], momenta = ['u', 'v'], "
      "parameters = ['a'], hamiltonian = '(u^2 + v^2)/2 + a*x^2*y + y^3/3'}",
      "cubic.toml"));
  std::size_t proved = 0;
  for (int k = 1;; ++k) {
    ASSERT_LT(k, 100);
    int stages = 0;
    bool failed = false;
    std::size_t before = 0;
    ClassifyOptions options;
    options.so_far = [&](const SystemClassification& c) {
      before = static_cast<std::size_t>(
          std::count_if(c.strata.begin(), c.strata.end(),
                        [](const auto& x) { return x.status != StratumStatus::open; }));
      failed = ++stages == k;
      if (failed) throw InternalError("injected");
    };
    try {
      const SystemClassification c = classify_system(s, options);
      if (!failed) break;
      EXPECT_GT(before, 0U);
      ++proved;
      EXPECT_EQ(before, static_cast<std::size_t>(
                            std::count_if(c.strata.begin(), c.strata.end(), [](const auto& x) {
                              return x.status != StratumStatus::open;
                            })));
      ASSERT_FALSE(c.notes.empty());
      const std::string last = kov::sentence(c.notes.back());
      EXPECT_NE(last.find(sentence), std::string::npos) << last;
    } catch (const InternalError&) {
      EXPECT_EQ(before, 0U) << k; // nothing was proved: the error is the answer
    }
  }
  EXPECT_GT(proved, 0U);
}

} // namespace
} // namespace kov::cli::behind_the_verdict_test
