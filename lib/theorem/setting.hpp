#pragma once
// The setting of a proof, to be read before its first line: the systems that its steps are about, and
// the files that it was read from.

#include "theorem/theorem.hpp"

namespace kov {

/// The step is about a stratum of the theorem's system: it brings tables of its own, or a step on trust.
[[nodiscard]] bool is_of_stratum(const TheoremNode& n);
/// The parameters of the theorem's system need not be real, or steps are about strata of them.
[[nodiscard]] bool is_of_strata(const Theorem& t);
/// The file of the step with what the node adds to it: constants, levels, manifolds, integrals, and its
/// conditions as assumptions.   Errors  InputError
[[nodiscard]] Entry document_of(const TheoremNode& n, const std::string& directory);
/// The theorem's system, with its constants.   Errors  InputError
[[nodiscard]] System system_of(const Theorem& t, const std::string& directory,
                               const ParameterValues& at = {});
/// "a \"b\"" as TOML writes it.
[[nodiscard]] std::string toml_text(const std::string& s);
/// The same of a list of texts.
[[nodiscard]] std::string toml_list(const std::vector<std::string>& all);

/// The theorem's file and those that its steps name, each once, in the order of the steps; a system
/// with its names, its bracket and its equations, as written.  A file that cannot be read again is left
/// out.
[[nodiscard]] std::vector<InputFile> input_files(const Theorem& t);

/// SHA-256, in hexadecimal.
/// Example sha256("abc").substr(0, 16)  // -> ba7816bf8f01cfea
[[nodiscard]] std::string sha256(const std::string& bytes);

/// "Let g = 0, A > 0, A + B >= C, and L real. ": values, then what the file assumes, in parameters
/// only; or nothing.
[[nodiscard]] std::string assumptions_of(const System& s);
/// `system "Heavy top"`: by its title; by its file if it has none.
[[nodiscard]] std::string titled(const System& s);

} // namespace kov
