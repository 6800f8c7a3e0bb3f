#include "integrability/check.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

const std::string cases = std::string(KOV_SOURCE_DIR) + "/cases/sliding_top/";

TEST(SlidingTop, Explore) {
  for (const char* set : {"sample", "symbolic"}) {
    Settings settings;
    if (std::string(set) == "symbolic") settings = {{"A", "A"}};
    const System s = read_system(cases + "lemma3_sample.toml", {});
    const CheckReport report = check_system(s);
    for (const auto& c : report.claims)
      std::cout << c.claim.name << " " << c.result.proved << " " << c.result.detail << "\n";
    for (const auto& m : report.manifolds) {
      std::cout << m.name << " " << to_string(m.verdict) << "\n";
      for (const auto& r : m.reasons)
        std::cout << "  reason " << r << "\n";
      for (std::size_t i = 0; i < m.variational.a.size(); ++i)
        for (std::size_t j = 0; j < m.variational.a.size(); ++j)
          if (!is_zero(m.variational.a[i][j]))
            std::cout << "  ve " << m.variational.names[i] << "," << m.variational.names[j] << " = "
                      << to_string(m.variational.a[i][j]) << "\n";
      for (const auto& i : m.normal.integrals) {
        std::cout << "  integral " << i.name << ":";
        for (const auto& c : i.coefficients)
          std::cout << " " << to_string(c);
        std::cout << "\n";
      }
      for (const auto& e : m.reduced.eliminations)
        std::cout << "  eliminated " << e.unknown << " by " << e.integral << "\n";
      for (const auto& b : m.blocks) {
        for (const auto& e : b.scalar)
          std::cout << "  " << e.unknown << ": a1 = " << to_string(e.a1)
                    << "\n     a0 = " << to_string(e.a0) << "\n";
        if (b.ode)
          std::cout << "  " << b.ode->change << "\n p = " << to_string(*b.ode->p)
                    << "\n q = " << to_string(*b.ode->q) << "\n r = " << to_string(b.ode->r)
                    << "\n";
      }
    }
    std::cout << report.seconds << " s\n";
  }
}

} // namespace
} // namespace kov
