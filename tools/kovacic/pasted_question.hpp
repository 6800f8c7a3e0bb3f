#pragma once
// Equations and formulas of the command line, which forgives what files do not (symbol/pasted.hpp).

#include "equation/understood.hpp"

#include <optional>
#include <string>
#include <vector>

namespace kov::cli {

/// What options said, and how it was understood.
struct PastedQuestion {
  EquationText text;
  std::vector<std::string> read_as; ///< "r = 2*x", an equation: what was read in another way
  std::vector<ReadingNote> notes;
  std::optional<std::string> right_side;
};

/// The formulas of -r, -e, --p, --q, --minpoly.
struct FormulaOptions {
  std::optional<std::string> r, ode, p, q, minpoly;
};

/// `given` has the variable, the parameters and the values.  Throws InputError.
[[nodiscard]] PastedQuestion read_options(const FormulaOptions& options, EquationText given);

/// "-e read as y'' = x*y" and the notes, on standard error: for commands whose answer does not show them.
void tell(const PastedQuestion& question);

} // namespace kov::cli
