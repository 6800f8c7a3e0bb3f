#pragma once
// Equations that a file assumes, as values of parameters: "b = 1", "c = 2*a".

#include "system/system.hpp"

namespace kov {

/// read_system, where each assumed equation that is linear in a parameter, with a number as slope,
/// gives that parameter its value: what is proved then holds where the equation does, and needs it.
/// Given   const Entry file = parse_document("system = {kind = 'hamiltonian', coordinates = ['q'], "
///             "momenta = ['p'], parameters = ['a', 'b'], hamiltonian = 'p^2/2 + b*q^2'}\n"
///             "assume = {conditions = ['b = a + 1']}", "file.toml");
/// Example to_string(*read_system_as_assumed(file).field.hamiltonian)  // -> (2*q^2*a + 2*q^2 + p^2)/2
[[nodiscard]] System read_system_as_assumed(const Entry& document, ParameterValues values = {});

} // namespace kov
