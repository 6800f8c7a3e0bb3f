#pragma once
// The verdict in a word: of a curve, of a file, of a classification.

#include <cstdint>
#include <string>

namespace kov {

enum class Verdict : std::uint8_t {
  non_integrable,
  no_obstruction,
  depends, ///< on the parameters: decided everywhere, not everywhere the same
  undecided,
  integrable,
  failed ///< what the file calls an invariant manifold is none
};
/// Example to_string(Verdict::no_obstruction)  // -> no-obstruction
[[nodiscard]] std::string to_string(Verdict v);

} // namespace kov
