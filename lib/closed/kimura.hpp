#pragma once
// Which Riemann equations with three places have a finite primitive group: the table of Schwarz
// (1873) and Kimura (1969), computed from the three polyhedral groups.
//
// An irreducible equation with exponent differences (l, m, n) has local monodromies with traces
// -2 cos(pi l), ..., and an irreducible pair of matrices of SL(2) is determined up to conjugation
// by the traces of A, B and AB.  So the group is A4, S4 or A5 exactly when the triple of traces
// occurs in that group.  A class is an orbit of triples under permutations, signs and integer
// shifts of even sum; all this does not change the group up to the scalars -1, which every one of
// them has.
//
// Source  [Kimura1969]; proof in docs/theory/kimura.md

#include "exact/integer.hpp"
#include "galois/group.hpp"
#include "parameters/statement.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace kov {

using ExponentTriple = std::array<Rational, 3>;

/// One row of the table.
struct SchwarzClass {
  ExponentTriple exponents; ///< the member of least sum in [0, 1]^3, descending
  bool even = true;         ///< integer shifts must have even sum; false: any shift
  GroupType group = GroupType::A5;
};

/// The rows, sorted by group, then by exponents.  Made once.
[[nodiscard]] const std::vector<SchwarzClass>& schwarz_classes();

/// The row of a triple of rational exponent differences; null if there is none.
/// Requires  an irreducible equation (a row's triples are irreducible by themselves)
/// Example schwarz_class({Rational(4, 3), Rational(3, 2), Rational(1, 5)})->group  // -> A5
/// Example schwarz_class({Rational(1, 2), Rational(1, 3), Rational(1, 7)})  // -> none
[[nodiscard]] const SchwarzClass* schwarz_class(const ExponentTriple& exponents);

/// q modulo 2 and sign, in [0, 1].
[[nodiscard]] Rational folded(const Rational& q);

/// Why an equation of Riemann has an abelian identity component.
struct AbelianRiemann {
  const SchwarzClass* row = nullptr; ///< of a finite primitive group
  bool dihedral = false;             ///< two exponents in 1/2 + Z; else (without a row) reducible
};
/// Example sentence(AbelianRiemann{})  // -> reducible: l +- m +- nu is an odd integer
[[nodiscard]] std::string sentence(const AbelianRiemann& a);

/// All nu for which one set of exponent differences has an abelian identity component.
struct ExponentClass {
  Residues nu; ///< modulo 1, and a in [0, 1/2], or modulo 2 and in [0, 1]
  AbelianRiemann by;
};
struct ThirdExponents {
  bool all = false; ///< every nu, rational or not
  std::vector<ExponentClass> classes;

  [[nodiscard]] Classes nu() const;
};
/// The third exponents nu (complex numbers, up to sign) for which the equation with rational
/// exponent differences l, m, nu has an abelian identity component: the closed answer in families.
/// Example abelian_third_exponents(Rational(1, 2), Rational(1, 2)).all  // -> yes
[[nodiscard]] ThirdExponents abelian_third_exponents(const Rational& l, const Rational& m);

} // namespace kov
