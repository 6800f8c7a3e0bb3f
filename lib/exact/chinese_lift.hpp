#pragma once
// Constants of K from their residues modulo several completely split primes.

#include "exact/modular.hpp"

#include <optional>
#include <vector>

namespace kov {

/// Collects residues of a fixed list of elements of K and reconstructs them.
///
/// Given   ChineseLift lift(rationals(), 1); lift.add({PrimeIdeal{101, 0}}, {{51}});
/// Example lift.reconstruct()  // -> {1/2}
class ChineseLift {
public:
  ChineseLift(Field k, std::size_t count);

  /// Shape  ideals: all [K:Q] prime ideals above one prime; residues[i][j]: element j modulo ideal
  /// i
  void add(const std::vector<PrimeIdeal>& ideals,
           const std::vector<std::vector<mp_limb_t>>& residues);

  /// The elements, if every coordinate has numerator and denominator below sqrt(modulus/2).
  /// A success is a guess: verify it exactly.
  [[nodiscard]] std::optional<std::vector<NfElem>> reconstruct() const;

  [[nodiscard]] std::size_t primes() const noexcept { return primes_; }

private:
  Field k_;
  std::size_t count_;
  std::size_t primes_ = 0;
  Integer modulus_{1};
  std::vector<Integer> coordinates_; ///< element j, coordinate i at j*d + i
};

/// True for 1, 2, 3, 4, 6, 8, 12, 16, 24, ...: the numbers of primes at which a try to reconstruct
/// is worth its cost, so that all tries together cost a constant factor.
[[nodiscard]] bool worth_a_try(std::size_t primes) noexcept;

} // namespace kov
