// A body on e(3)* with and without [[casimir]] blocks: `check` says the same.

#include "study/study.hpp"

#include <gtest/gtest.h>

namespace kov::study::known_casimirs_test {
namespace {

std::string verdict(const std::string& system, const std::string& casimirs) {
  return to_string(study(parse_document(system + casimirs, "body.toml"), {}).headline.verdict);
}

TEST(KnownCasimirs, AreUsedWhereTheFileDoesNotNameThem) {
  const std::string square = "[[casimir]]\nname = 'F1'\nvalue = 'G1^2 + G2^2 + G3^2'\n";
  const std::string product = "[[casimir]]\nname = 'F2'\nvalue = 'M1*G1 + M2*G2 + M3*G3'\n";
  for (const auto& [hamiltonian, expected] :
       {std::pair("M1^2/2 + M2^2/3 + M3^2/5 + G1", "non-integrable"),
        std::pair("M1^2/2 + M2^2/2 + M3^2 + G1", "no-obstruction")}) {
    const std::string system =
        "[system]\nkind = 'euler-poisson'\ncoordinates = ['M1', 'M2', 'M3', 'G1', 'G2', 'G3']\n"
        "parameters = ['h']\nhamiltonian = '" +
        std::string(hamiltonian) +
        "'\n[[manifold]]\nname = 'pendulum'\nequations = ['M1 = 0', 'M2 = 0', 'G3 = 0']\n"
        "level = ['H = h', 'G1^2 + G2^2 + G3^2 = 1']\n";
    for (const std::string& casimirs : {square + product, product, square, std::string()})
      EXPECT_EQ(verdict(system, casimirs), expected) << hamiltonian << casimirs;
  }
}

} // namespace
} // namespace kov::study::known_casimirs_test
