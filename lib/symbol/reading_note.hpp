#pragma once
// A part of a pasted text that was read in another way than its letters say, and what was done with it.

#include <cstdint>
#include <string>
#include <vector>

namespace kov {

struct ReadingNote {
  enum class What : std::uint8_t {
    decimal,        ///< of: as written, the exact fraction
    root,           ///< of: the polynomial, the root that is taken
    derivative,     ///< of: what stands for one
    coefficients,   ///< of: the unknown of a list of coefficients
    not_used,       ///< of: a part of a call
    differentiates, ///< of: D, the variable
    euler,          ///< of: theta, the variable
    riccati,        ///< of: the substitution, the linear equation
    bernoulli,      ///< of: the substitution, the linear equation of the first order
    first_order,    ///< of: the equation of the second order that is decided
    homogeneous,    ///< of: the equation that is decided, the right side
    variable,       ///< of: the change after which the coefficients are rational
    names           ///< of: the unknown ("": none), its variable, the parameters: what was inferred
  };
  What what = What::not_used;
  std::vector<std::string> of = {};
  friend bool operator==(const ReadingNote&, const ReadingNote&) = default;
};

/// Example sentence(ReadingNote{ReadingNote::What::decimal, {"0.25", "1/4"}})
///         // -> decimals are exact: 0.25 = 1/4
[[nodiscard]] std::string sentence(const ReadingNote& n);
[[nodiscard]] std::vector<std::string> sentences(const std::vector<ReadingNote>& all);

} // namespace kov
