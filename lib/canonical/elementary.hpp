#pragma once
// Changes of variables that keep the names: an exchange of coordinates and momenta, the square in the
// momenta completed, a shift of the coordinates.
//
// Source  docs/theory/canonical.md (2-4)

#include "canonical/form.hpp"

namespace kov {

/// Pairs (q_i, p_i) -> (p_i, -q_i) such that H becomes quadratic in the momenta, if it is not.
[[nodiscard]] Form with_quadratic_kinetic_term(const Form& form);

/// H = p.G(q)p/2 + A(q).p + V(q): a gauge p -> p + a in which A vanishes, or is short.
[[nodiscard]] Form with_completed_square(const Form& form, const Budget& budget);

/// The coordinates begin at a place (a rest, a centre, a pole) at which H has fewer terms.
[[nodiscard]] Form with_good_origin(const Form& form, const Budget& budget);

/// H is a polynomial of degree <= 2 in the momenta with a regular quadratic part; its matrix d2H/dp2.
[[nodiscard]] std::optional<Matrix> kinetic_matrix(const Form& form);

} // namespace kov
