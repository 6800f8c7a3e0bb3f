// A proof script: which potentials V = (q1^4 + q2^4)/4 + b q1^2 q2^2/2 pass the first-order test
// along the q1 axis?  One call for each stage; everything between the calls is an exact value.

#include "study/study.hpp"

#include <cstdio>

namespace {

kov::study::SystemStudy quartic_potential(const std::string& b) {
  const char* file = R"(
[system]
kind        = "hamiltonian"
coordinates = ["q1", "q2"]
momenta     = ["p1", "p2"]
parameters  = ["b", "h"]
hamiltonian = "(p1^2 + p2^2)/2 + (q1^4 + q2^4)/4 + b*q1^2*q2^2/2"
[[manifold]]
name      = "q1-axis"
equations = ["q2 = 0", "p2 = 0"]
level     = "H = h"
[reduce]
variable = "q2"
change   = "z = q1^4"
)";
  return kov::study::study(kov::parse_document(file, "quartic"), {{"b", b}, {"h", "1/4"}});
}

} // namespace

int main() {
  int wrong = 0;
  for (int b = 0; b <= 10; ++b) {
    const kov::study::SystemStudy study = quartic_potential(std::to_string(b));
    const kov::ManifoldReport& axis = study.manifolds.at(0).first;
    std::printf("b = %2d  %s  r = %s\n", b, to_string(axis.verdict).c_str(),
                to_string(axis.blocks.at(0).equation->r).c_str());
    // Morales-Ramis: lambda = b is one of p(2p - 1), p(2p + 1): 0, 1, 3, 6, 10, ...
    const bool allowed = b == 0 || b == 1 || b == 3 || b == 6 || b == 10;
    wrong += allowed != (axis.verdict == kov::Verdict::no_obstruction);
  }
  return wrong;
}
