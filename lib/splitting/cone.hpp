#pragma once
// Signs of polynomials on an open orthant, with certificates that a reader checks by expanding.
//
// Each variable is written as a rational function, with positive coefficients, of new variables
// that range over all positive numbers (0 < a < b < c: a, b = a + u, c = a + u + v).  A polynomial
// whose coefficients in the new variables all have one sign has that sign.  On an equation g = 0 a
// rational multiple of g may be added first.  "0" means: not seen, nothing is claimed.

#include "exact/multivariate.hpp"

#include <string>
#include <vector>

namespace kov {

/// f = q g + (f - q g): where g = 0 the sign of f is that of the bracket.
struct SignIdentity {
  MPoly f;
  Rational q;
  MPoly g;
};
/// "b - a = 1*(b - c) + (c - a)"
[[nodiscard]] std::string to_string(const SignIdentity& i);

class Cone {
public:
  explicit Cone(Substitution values) : values_(std::move(values)) {}

  /// +1 or -1 when f has that sign on the whole cone, else 0.
  [[nodiscard]] int sign(const MPoly& f) const;
  /// The same on the part of the cone where all g vanish; `used` receives the identities.
  [[nodiscard]] int sign(const MPoly& f, const std::vector<MPoly>& zero,
                         std::vector<SignIdentity>* used) const;

private:
  [[nodiscard]] int sign_of_irreducible(const MPoly& f, const std::vector<MPoly>& zero,
                                        std::vector<SignIdentity>* used) const;

  Substitution values_;
};

} // namespace kov
