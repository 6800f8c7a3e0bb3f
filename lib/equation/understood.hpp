#pragma once
// From an equation as it was pasted (symbol/pasted.hpp) to a linear homogeneous one with rational coefficients:
//
//   operators       D^2 - x, theta^2 + x
//   a right side    y'' + y = sin(x): the homogeneous equation is kept, sin(x) stands beside it
//   first order     Riccati's, Bernoulli's and linear equations (first_order_form.hpp)
//   functions       sin(x), exp(2 x), tanh(x), sqrt(x) in the coefficients: another variable (function_change.hpp)
//
// Every step is told.

#include "elementary/whole.hpp"
#include "equation/read_equation.hpp"
#include "symbol/reading_note.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kov {

struct Understood {
  EquationText text;                     ///< ode, or p and q in another variable
  std::string given;                     ///< the equation, as it was read
  std::string read_as;                   ///< "": as it was written
  std::vector<ReadingNote> notes;        ///< what was done
  std::optional<std::string> right_side; ///< y'' + p y' + q y = this
  /// The equation before that, where it has a right side, initial values, or is of the first order.
  std::optional<elementary::WholeEquation> whole;
};

/// `given` has the parameters, values and the variable, as far as they are known.
/// Errors   InputError, also for what could be meant in two ways
/// Given    const EquationText no_names;
/// Given    const Understood airy = understood("y'' = x y", "-e", no_names);
/// Given    const Understood riccati = understood("y' = y^2 + x", "-e", no_names);
/// Example  airy.read_as  // -> y'' = x*y
/// Example  riccati.read_as  // -> y' = y^2 + x
/// Example  read_equation(riccati.text).normal_form.r  // -> -z
/// Example  understood("y'' = yx", "-e", no_names).read_as  // -> throws InputError
[[nodiscard]] Understood understood(const std::string& ode, const std::string& name,
                                    const EquationText& given);

/// Is another equation decided than the given one: another variable, no right side, a linear one?
[[nodiscard]] bool is_another_equation(const std::vector<ReadingNote>& notes);

} // namespace kov
