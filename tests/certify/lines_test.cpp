// Many certificates at once, for comparison with the Python checker: KOV_CERTIFICATE_LINES names a
// file of JSON lines {"text": certificate, ...}; one letter per line (a, r, m) goes to that name +
// ".cpp".  Not set: nothing to do.

#include "certify/equation/check.hpp"
#include "certify/jets/check.hpp"
#include "certify/loops/check.hpp"
#include "certify/system/check.hpp"
#include "certify/theorem/check.hpp"
#include "exact/error.hpp"
#include "proof/text/json.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace kov::certify::lines_test {
namespace {

char verdict(const std::string& text) {
  try {
    if (format_of(text) == "kovacic-strata/1") {
      const auto verdict = check_strata(read_strata_certificate(text));
      return std::holds_alternative<StrataAccepted>(verdict) ? 'a' : 'r';
    }
    if (format_of(text) == "kovacic-system/1") {
      const auto verdict = check_way(read_system_certificate(text));
      return std::holds_alternative<SystemAccepted>(verdict) ? 'a' : 'r';
    }
    if (format_of(text) == "kovacic-jets/1") {
      const auto verdict = check_jets(read_jets_certificate(text));
      return std::holds_alternative<JetsAccepted>(verdict) ? 'a' : 'r';
    }
    if (format_of(text) == "kovacic-loops/1") {
      const auto verdict = check_loops(read_loops_certificate(text));
      return std::holds_alternative<Accepted>(verdict) ? 'a' : 'r';
    }
    if (format_of(text) == "kovacic-theorem/1")
      return std::holds_alternative<TheoremAccepted>(check_theorem(text)) ? 'a' : 'r';
    const Certificate c = read_certificate(text);
    return std::holds_alternative<Accepted>(check(c)) ? 'a' : 'r';
  } catch (const Error&) {
    return 'm';
  }
}

TEST(Lines, Verdicts) {
  const char* name = std::getenv("KOV_CERTIFICATE_LINES");
  if (!name) GTEST_SKIP();
  std::ifstream in(name);
  std::ofstream out(std::string(name) + ".cpp");
  std::string line;
  for (long n = 1; std::getline(in, line); ++n) {
    const auto start = std::chrono::steady_clock::now();
    const Json entry = parse_json(line);
    for (const auto& [key, value] : *entry.object())
      if (key == "text") out << verdict(*value.text()) << '\n';
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    if (time.count() > 2) std::cout << "line " << n << ": " << time.count() << " s\n";
  }
}

} // namespace
} // namespace kov::certify::lines_test
