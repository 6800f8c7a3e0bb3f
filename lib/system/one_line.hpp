#pragma once
// A system file from one formula: H(q, p) or L(q, q') alone.
//
// Which letters move is guessed from their names and shown; a letter that could be the time is asked
// back.  Lists that are given are not guessed.

#include "symbol/reading_note.hpp"

#include <cstdint>
#include <string>
#include <utility>
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

/// A formula as people type it (symbol/pasted.hpp), also with its name: "H = p^2/2 + q^4".
struct OneLine {
  std::string formula, text; ///< the formula that was understood; the system file
  Letters letters;
  bool as_written = true;
  std::vector<ReadingNote> notes{}; ///< what was read in another way than its letters say
};
/// Errors  as letters_of
/// Example read_one_line("H = p^2/2 + 0.5 q^4", Mechanics::hamiltonian).formula  // -> p^2/2 + 1/2*q^4
[[nodiscard]] OneLine read_one_line(const std::string& given, Mechanics kind,
                                    const Letters& letters = {}, const std::string& name = "-H");

/// The [assume] table that says these sentences: "a > 0", "n integer", "m is positive".
/// Example assume_table({"n integer"}).size()  // -> 23
[[nodiscard]] std::string assume_table(const std::vector<std::string>& sentences);

/// A picture to begin with: a person changes this in the file.
struct SceneWishes {
  std::string name = {}; ///< of the scene; empty: that of its file
  std::string energy = "1/8";
  std::vector<std::pair<std::string, std::string>> values = {}; ///< of parameters; 1 otherwise
};
/// The text of a system file with a [[scene]] table: the first coordinate is 0, the second one is drawn with its momentum.
/// Errors  InputError: neither a Hamiltonian nor a Lagrangian, or one degree of freedom
[[nodiscard]] std::string with_scene(const std::string& system, const SceneWishes& wishes);

} // namespace kov
