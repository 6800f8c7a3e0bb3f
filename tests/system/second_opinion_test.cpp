// The derivatives on which everything rests, computed a second time by GiNaC: the equations of
// motion of canonical systems from the Hamiltonian, and the Jacobian of each field.

#include "support/source_dir.hpp"
#include "symbol/ginac_door.hpp"
#include "system/system.hpp"

#include <filesystem>
#include <gtest/gtest.h>

namespace kov::second_opinion_test {
namespace {

class SecondOpinion : public testing::TestWithParam<std::string> {
protected:
  SymbolTable symbols;
  GiNaC::ex ginac(const MFraction& f) {
    return to_ginac(parse_expression(to_string(f), "field"), symbols);
  }
  // Compared at a rational point: GiNaC's normal() takes minutes on the larger fields.
  void expect_equal(const VectorField& v, const GiNaC::ex& theirs, const GiNaC::ex& ours,
                    const std::string& what) {
    GiNaC::exmap point;
    for (std::size_t i = 0; i < v.ring->size(); ++i)
      point[symbols[v.ring->name(i)]] = GiNaC::numeric(static_cast<long>(7 * i * i + 11), 13);
    EXPECT_TRUE(theirs.subs(point).is_equal(ours.subs(point))) << what;
  }
};

TEST_P(SecondOpinion, JacobianByGinac) {
  const System s = read_system(read_document(GetParam()), {});
  if (!s.field.functions.empty()) GTEST_SKIP() << "has function symbols";
  for (const MFraction& component : s.field.components)
    for (std::size_t j = 0; j < s.field.dimension(); ++j) {
      const GiNaC::ex theirs = ginac(component).diff(symbols[s.field.name(j)]);
      expect_equal(s.field, theirs, ginac(partial(s.field, component, j)),
                   "d/d" + s.field.name(j) + " of " + to_string(component));
    }
}

TEST_P(SecondOpinion, EquationsOfMotionByGinac) {
  const System s = read_system(read_document(GetParam()), {});
  if (!s.field.functions.empty() || !s.field.hamiltonian || !s.field.poisson)
    GTEST_SKIP() << "no Hamiltonian system without function symbols";
  const GiNaC::ex h = ginac(*s.field.hamiltonian);
  for (std::size_t i = 0; i < s.field.dimension(); ++i) {
    GiNaC::ex theirs = 0;
    for (std::size_t j = 0; j < s.field.dimension(); ++j)
      theirs += ginac((*s.field.poisson)[i][j]) * h.diff(symbols[s.field.name(j)]);
    expect_equal(s.field, theirs, ginac(s.field.components[i]), s.field.name(i));
  }
}

std::vector<std::string> case_files() {
  std::vector<std::string> files;
  for (const char* folder : {"/cases/classics", "/cases/sliding_top"})
    for (const auto& entry : std::filesystem::directory_iterator(test::in_source(folder)))
      if (entry.path().extension() == ".toml" &&
          is_system_document(read_document(entry.path().string())))
        files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

INSTANTIATE_TEST_SUITE_P(Cases, SecondOpinion, testing::ValuesIn(case_files()),
                         [](const auto& test) {
                           return std::filesystem::path(test.param).stem().string();
                         });

} // namespace
} // namespace kov::second_opinion_test
