#pragma once
// A Hamiltonian system on its way to a simpler form.
//
// All variables, those of the user and those that a change brings, live in one ring.  The names of the
// user's variables stand for the current ones in `field`, and for the user's in `forward`.

#include "canonical/change.hpp"

namespace kov {

struct Form {
  VectorField field;              ///< canonical: coordinates, then momenta
  std::vector<MFraction> forward; ///< the current variables as functions of the user's
  std::map<std::size_t, MFraction> functions = {}; ///< symbols that the user does not have

  [[nodiscard]] std::size_t degrees() const { return field.dimension() / 2; }
  [[nodiscard]] std::size_t q(std::size_t i) const { return field.coordinates[i]; }
  [[nodiscard]] std::size_t p(std::size_t i) const { return field.coordinates[degrees() + i]; }
  [[nodiscard]] MFraction variable(std::size_t i) const {
    return MFraction::variable(field.ring, i);
  }
  /// Is f free of everything that moves?
  [[nodiscard]] bool is_constant_of_motion(const MFraction& f) const;
  /// The number of terms of the Hamiltonian and of the relations.
  [[nodiscard]] long length() const;
};

/// The system as it is; unset: it is not a canonical one.
[[nodiscard]] std::optional<Form> form_of(const System& s);

/// x_i = old[i](new variables), new x_k = now[k](old variables): a change among the variables that are
/// there.  Requires that old[i] contains no function symbols, wherever a function depends on x_i.
/// Errors  DomainError: something has no value
[[nodiscard]] Form changed(const Form& form, const Substitution& old, const Substitution& now);

/// Symbols that nothing depends on are left out, and changed variables get names of their own.
[[nodiscard]] CanonicalChange finished(const System& s, const Form& form);

} // namespace kov
