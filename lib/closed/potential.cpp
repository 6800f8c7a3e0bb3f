#include "closed/potential.hpp"

#include "exact/error.hpp"
#include "linode/normal_form.hpp"

#include <algorithm>

namespace kov {
namespace {

void check(long k) {
  if (k == 0) throw InvalidArgument("the degree 0 is not covered: phi'^2 = (2/k)(1 - phi^k)");
  if (k > 1000000 || k < -1000000)
    throw InvalidArgument("the degree " + std::to_string(k) + " is out of range");
}

} // namespace

Rational EigenvalueFamily::at(const Integer& p) const {
  const Rational root = u + v * Rational(p);
  return c + root * root / w;
}

std::vector<Rational> EigenvalueFamily::polynomial() const {
  return {v * v / w, Rational(2) * u * v / w, u * u / w + c};
}

bool EigenvalueFamily::contains(const Rational& lambda) const {
  const auto root = exact_sqrt((lambda - c) * w);
  return root && (is_integer((*root - u) / v) || is_integer((-*root - u) / v));
}

EigenvalueTable eigenvalue_table(long k) {
  check(k);
  EigenvalueTable table;
  table.k = k;
  const ThirdExponents third = abelian_third_exponents(Rational(1, k), Rational(1, 2));
  table.all = third.all;
  const Rational c(-(k - 2) * (k - 2), 8 * k);
  for (const ExponentClass& nu : third.classes)
    table.families.push_back({c, Rational(2 * std::abs(k)) * nu.nu.a,
                              Rational(2 * std::abs(k)) * nu.nu.step, Rational(8 * k), nu.by});
  return table;
}

SquaredExponents potential_exponents(long k, const NfElem& lambda) {
  check(k);
  const NfElem square = NfElem((k - 2) * (k - 2)) + NfElem(8 * k) * lambda;
  return {NfElem(Rational(1, k) * Rational(1, k)), NfElem(Rational(1, 4)),
          square / NfElem(4 * k * k)};
}

// z = phi^k: z' = k phi^(k-1) phi', so that with phi'^2 = (2/k)(1-z)
//   z'^2 = 2k z^2 phi^-2 (1-z),
//   z'' = k(k-1) phi^(k-2) phi'^2 + k phi^(k-1) phi'',  phi'' = -phi^(k-1):
//   z'' = z phi^-2 (2(k-1)(1-z) - k z);
// xi_zz + (z''/z'^2) xi_z + lambda phi^(k-2)/z'^2 xi = 0, phi^(k-2)/z'^2 = 1/(2k z (1-z)).
RationalFunction potential_equation(long k, const NfElem& lambda) {
  check(k);
  const Poly z = Poly::z();
  const Poly one(1);
  const Poly below = scale(z * (one - z), NfElem(2 * k));
  const RationalFunction p(scale(one - z, NfElem(2 * (k - 1))) - scale(z, NfElem(k)), below);
  const RationalFunction q(Poly(lambda), below);
  return normal_form(p, q).r;
}

} // namespace kov
