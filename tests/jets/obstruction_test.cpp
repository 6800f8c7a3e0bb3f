#include "jets/obstruction.hpp"

#include <gtest/gtest.h>
#include <chrono>

namespace kov::jets {
namespace {

System system_of(const std::string& potential, const std::string& parameters = "") {
  return read_system(parse_document(
      "system = {kind = 'hamiltonian', coordinates = ['q1', 'q2'], momenta = ['p1', 'p2'], "
      "parameters = [" + parameters + "], hamiltonian = '(p1^2 + p2^2)/2 + " + potential + "'}\n"
      "manifold = [{name = 'N', equations = ['q1 = 0', 'p1 = 0']}]",
      "test.toml"));
}

HigherOrders look(const std::string& potential, int order, const std::string& parameters = "") {
  const System s = system_of(potential, parameters);
  HigherOptions options;
  options.order = order;
  const auto t = std::chrono::steady_clock::now();
  auto r = higher_orders(s, s.manifolds.front(), options);
  std::cout << potential << "  up to " << order << "  "
            << std::chrono::duration<double>(std::chrono::steady_clock::now() - t).count() << " s\n   ";
  if (r.obstruction) {
    const auto& o = *r.obstruction;
    std::cout << "VE_" << o.logarithm.order << " rho " << to_string(o.rho1) << " " << to_string(o.rho2) << " R = " << to_factored_string(o.logarithm.form)
      << (o.energy ? " at E = " + to_string(*o.energy) : "") << "\n   where ";
    for (const auto& list : o.not_all_zero) { std::cout << "{"; for (const auto& p : list) std::cout << to_string(p) << ";  "; std::cout << "} "; }
    std::cout << "\n";
  } else std::cout << "open: " << r.open << "\n";
  return r;
}

TEST(HigherOrders, Show) {
  const std::string hh = "(A*q1^2 + B*q2^2)/2 + q1^2*q2 + ";
  look(hh + "2/3*q2^3", 3, "'A', 'B'");
  look(hh + "1/3*q2^3", 3, "'A', 'B'");
  look("(A*q1^2 + A*q2^2)/2 + q1^2*q2 + 1/3*q2^3", 6, "'A'");
  look(hh + "6/3*q2^3", 6, "'A', 'B'");
  look("(A*q1^2 + 16*A*q2^2)/2 + q1^2*q2 + 16/3*q2^3", 6, "'A'");
  look(hh + "1/5*q2^3", 3, "'A', 'B'");
  look("(q1^2 + q2^2)/2 + q1^2*q2 + 1/5*q2^3", 3);
  look("(q1^2 + q2^2)/2 + q1^2*q2 + 16/3*q2^3", 3);
  look("q2^3/3 + 1/2*q1^2*q2 + a*q1^3", 3, "'a'");
  look("q2^3/3 + 1/2*q1^2*q2", 3);
  look("q2^3/3 + 5/2*q1^2*q2", 5);
  look("q2^4/4 + 1/2*q1^2*q2^2 + al*q1^3*q2 + be*q1^4/4", 3, "'al', 'be'");
  look("(A*q1^2 + B*q2^2)/2 + q2^4/2 + 3*q1^2*q2^2 + c*q1^4/2", 3, "'A','B','c'");
  look("(A*q1^2 + B*q2^2)/2 + q2^4/2 + 6*q1^2*q2^2 + 8*q1^4", 3, "'A','B'");
  look("(-11*B*q1^2 + B*q2^2)/2 + q2^4/2 + 6*q1^2*q2^2 + 8*q1^4", 5, "'B'");
  look("(4*B*q1^2 + B*q2^2)/2 + q2^4/2 + 6*q1^2*q2^2 + 8*q1^4", 5, "'B'");
  look("(A*q1^2 + B*q2^2)/2 + q2^4/2 + 6*q1^2*q2^2 + 4*q1^4", 3, "'A','B'");
}

} // namespace
} // namespace kov::jets
