#include "special/lame_polynomials.hpp"
#include "exact/ideal.hpp"
#include <gtest/gtest.h>
#include <chrono>
#include <iostream>
namespace kov {
TEST(Scratch, Print) {
  const Ring ring = make_ring({"B", "g2", "g3"});
  const auto v = [&](const char* n) { return MFraction::variable(ring, std::string_view(n)); };
  const LameParameters<MFraction> p{v("B"), v("g2"), v("g3")};
  for (long m = 1; m <= 5; ++m) std::cout << to_string(brioschi(m, p)) << "\n";
  for (long n = 0; n <= 2; ++n) std::cout << to_factored_string(lame_hermite(n, p).w_squared) << "\n";
  for (const auto& [n, d, m] : std::vector<std::tuple<long, long, long>>{{1,6,8},{1,4,8},{3,4,8},{5,4,8},{7,6,8},{5,6,8},{1,10,12},{3,10,12},{7,10,12},{9,10,12},{11,10,12},{1,6,12},{-1,6,12},{5,6,12},{7,6,12},{11,6,12},{11,6,8},{13,6,8},{13,6,12}}) {
    auto t0 = std::chrono::steady_clock::now();
    const auto c = invariant_conditions(Rational(n, d), m, p);
    auto t1 = std::chrono::steady_clock::now();
    std::cout << n << "/" << d << " m=" << m << ": " << c.size() << " conditions, "
              << std::chrono::duration<double>(t1 - t0).count() << " s\n";
    std::vector<MPoly> gens;
    for (const auto& f : c) { gens.push_back(f.num()); std::string s = to_factored_string(f); if (s.size() < 200) std::cout << "   " << s << "\n"; else std::cout << "   (" << s.size() << ")\n"; }
    const MPoly disc = (pow(v("g2"), 3) - Rational(27) * pow(v("g3"), 2)).num();
    try {
    Ideal ideal(ring, {0, 1, 2}, gens, {disc}, Budget::of_seconds(5));
    std::cout << "  saturated " << std::chrono::duration<double>(std::chrono::steady_clock::now() - t1).count() << "s unit " << ideal.is_unit() << " dim " << ideal.dimension() << "\n";
    for (const auto& g : ideal.basis()) std::cout << "      " << to_factored_string(ideal.from_kpoly(g)) << "\n";
    } catch (const Error& e) { std::cout << e.what() << "\n"; }
  }
}
}
