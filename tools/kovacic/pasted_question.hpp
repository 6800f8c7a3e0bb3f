#pragma once
// Equations and formulas of the command line, which forgives what files do not (symbol/pasted.hpp).

#include "equation/understood.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace kov::cli {

using Json = nlohmann::ordered_json;

/// What options said, and how it was understood.
struct PastedQuestion {
  EquationText text;
  std::string given;                ///< the equation, as it was read; "": only formulas were given
  std::vector<std::string> read_as; ///< "r = 2*x", an equation: what was read in another way
  std::vector<ReadingNote> notes;
  std::optional<std::string> right_side;
  std::optional<elementary::WholeEquation> whole;
};

/// The formulas of -r, -e, --p, --q, --minpoly.
struct FormulaOptions {
  std::optional<std::string> r, ode, p, q, minpoly;
};

/// `given` has the variable, the parameters and the values.  Throws InputError.
[[nodiscard]] PastedQuestion read_options(const FormulaOptions& options, EquationText given);

/// How the question was read, as the members read_as and notes of a JSON answer, and as lines above a text.
[[nodiscard]] Json reading_json(const PastedQuestion& question);
[[nodiscard]] std::string reading_text(const Json& reading);

} // namespace kov::cli
