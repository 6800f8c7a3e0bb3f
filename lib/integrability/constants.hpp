#pragma once
// From Q(z, algebraic constants) to K(z) with one number field K = Q(theta).

#include "exact/multivariate.hpp"
#include "system/vector_field.hpp"

#include <map>
#include <optional>

namespace kov {

/// The relations without parameters determine the constants: they are algebraic numbers.
[[nodiscard]] bool constants_are_numbers(const VectorField& v);

/// The algebraic constants of a system in one field; Q if there are none.
class ConstantField {
public:
  /// The relations among the constants alone must define a field.
  /// Errors  InvalidArgument: relations with parameters, not finitely many values, or not a field
  static ConstantField make(const VectorField& v);

  [[nodiscard]] const Field& field() const noexcept { return field_; }
  /// The generator of the field, a linear combination of the constants.  Requires a field other than Q
  [[nodiscard]] const MFraction& generator() const { return generator_.value(); }
  /// Requires that f uses only z and the constants; otherwise InvalidArgument, naming the variable.
  [[nodiscard]] RationalFunction convert(const MFraction& f, std::size_t z) const;

private:
  Field field_ = rationals();
  std::optional<MFraction> generator_;
  std::map<std::size_t, NfElem> values_;
};

/// Q(theta) for a root theta of f in Q[x]: an integral multiple generates.  Returns the field and
/// theta in it.  Requires f irreducible (checked; InvalidArgument).
/// Example pow(field_of_root(2*z*z - 1, "s").second, 2)  // -> 1/2
/// Example field_of_root(z*z - 1, "s").second  // -> throws InvalidArgument
[[nodiscard]] std::pair<Field, NfElem> field_of_root(const Poly& f, const std::string& name);

} // namespace kov
