#pragma once
// The assumptions about the parameters of one equation, before anything is decided: are the
// sentences about parameters, and true of the values that are given?

#include "equation/read_equation.hpp"
#include "parameters/conditions.hpp"
#include "system/formula.hpp"

namespace kov {

/// No root, no I: the formula means a rational function of its names.
[[nodiscard]] bool is_rational_formula(const Expression& e);

/// The assumptions in the ring of the scope, after what is known of it.  Errors  InputError
[[nodiscard]] Assumptions read_assumptions(const EquationText& text, const Scope& scope,
                                           Assumptions known = {});

/// Values are compared exactly, in the number field of the equation's constants.
/// Errors  InputError: a text that is not a sentence, a name that is not a parameter, a sentence
///         that is false of the values given, sentences that contradict each other (as far as this
///         is seen without an equation)
void check_assumptions(const EquationText& text);

/// The value of a formula, exactly; unset where a name in it has none.  Errors  InputError
[[nodiscard]] std::optional<NfElem> constant_value(const Expression& e, const EquationText& text);

/// The names in an assumption, which are then parameters.  Errors  InputError
/// Example names_in_assumption({"A > 0 and B >= C", nullptr, ""})  // -> {A, B, C}
[[nodiscard]] std::vector<std::string> names_in_assumption(const AssumedText& text);

/// Is it prose, which can be quoted but not used?  A sentence, a formula in these names, something
/// with a relation sign and an empty text are not.
/// Example is_prose("as in the paper", {"a"})  // -> yes
/// Example is_prose("2*a", {"a"})  // -> no
[[nodiscard]] bool is_prose(const std::string& text, const std::vector<std::string>& names);

} // namespace kov
