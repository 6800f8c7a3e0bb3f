#pragma once
// A system file from one formula: H(q, p) or L(q, q') alone.
//
// Which letters move is guessed from their names and shown; a letter that could be the time is asked
// back.  Lists that are given are not guessed.

#include <cstdint>
#include <string>
#include <vector>

namespace kov {

enum class Mechanics : std::uint8_t { hamiltonian, lagrangian };

/// The roles of the letters, which a formula does not say.  Empty lists are guessed.
struct Letters {
  std::vector<std::string> coordinates = {};
  std::vector<std::string> rates = {}; ///< momenta or velocities, in the order of the coordinates
  std::vector<std::string> parameters = {};
};

/// The letters of a formula.  Momenta: px or p_x of x; p1 of q1, x1, or of x, y, z in this order; p of q, x, or
/// another letter that is alone.  Velocities: xdot, x_dot, vx, x'.  A momentum or velocity whose coordinate
/// does not occur has a cyclic one, if the others show how it is called.  All other letters are parameters.
///
/// name    what messages call the formula, e.g. "-H"
/// Errors  InputError: no letter looks like a momentum (velocity); the letter t, which is not declared; a
///         declared letter that is twice there, or a letter that lists leave out
/// Example letters_of("p1^2/2 + p2^2/2 + q1^2*q2 + b*q2^3/3", Mechanics::hamiltonian).parameters  // -> {b}
/// Example letters_of("(px^2 + py^2)/2 - k/sqrt(x^2 + y^2)", Mechanics::hamiltonian).coordinates  // -> {x, y}
/// Example letters_of("m*xdot^2/2 - m*g*x", Mechanics::lagrangian).rates  // -> {xdot}
/// Example letters_of("a*x", Mechanics::hamiltonian).parameters  // -> throws InputError
[[nodiscard]] Letters letters_of(const std::string& formula, Mechanics kind,
                                 const Letters& given = {}, const std::string& name = "-H");

/// "coordinates q1, q2; momenta p1, p2; parameters b"
[[nodiscard]] std::string in_words(const Letters& letters, Mechanics kind);

/// A system file (docs/guide/system-files.md): a text that parse_document reads.
[[nodiscard]] std::string system_text(const std::string& formula, Mechanics kind,
                                      const Letters& letters);

} // namespace kov
