#pragma once
// The equation in the variable z - c, c the barycentre of the poles: there it is over Q again if it is
// a translate of an equation over Q, and its numbers are small again.
//
// Source  docs/theory/normal_form.md, 1.6

#include "linode/normal_form.hpp"

#include <optional>
#include <string>

namespace kov {

/// The equation in x = z - centre.
struct Centred {
  NfElem centre;
  NormalForm equation;
};

/// Unset where the move gains nothing: the equation is over Q and c is not a long number, or r(x + c) or
/// p(x + c) is not over Q.  If r is a polynomial, its zeros stand for the poles.
/// Given   const NfElem s = NfElem::generator(make_field({-2, 0, 1}, "s"));
/// Given   const RationalFunction moved(Poly(2), pow(z - Poly(s), 2));
/// Example centred({moved, 0})->equation.r  // -> 2/z^2
/// Example centred({moved, 0})->centre  // -> s
/// Example centred({moved, RationalFunction(Poly(s))}).has_value()  // -> no
[[nodiscard]] std::optional<Centred> centred(const NormalForm& equation);

/// f(z + c)
/// Given   const RationalFunction f(z, z - Poly(1));
/// Example moved_by(f, NfElem(1))  // -> (z + 1)/z
[[nodiscard]] RationalFunction moved_by(const RationalFunction& f, const NfElem& c);

/// z - c, as a formula for the variable: "(z - 2)".
/// Example centred_variable("z", NfElem(2))  // -> (z - 2)
[[nodiscard]] std::string centred_variable(const std::string& variable, const NfElem& centre);

} // namespace kov
