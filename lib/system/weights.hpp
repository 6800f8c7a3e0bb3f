#pragma once
// Weight-homogeneous expansion: x_i counts w_i, parameters count 0.
//
//   f = f_m + f_(m+1) + ...,  E[f_k] = k f_k for the Euler field E = sum w_i x_i d/dx_i.
//
// If {x_i, x_j} is homogeneous of degree w_i + w_j - s for all i, j, then {f, g} has the lowest
// term {f_m, g_n}, of degree m + n - s, wherever that is not 0; so lowest terms of first integrals
// are first integrals of the system of the lowest term of H ([PrzybylskaMaciejewski2024] Lemma 1).
// Then the lowest system must be integrable if the whole one is.

#include "system/system.hpp"

namespace kov {

using Weights = std::map<std::size_t, long>;

struct WeightTerm {
  long degree = 0;
  MFraction value;
};

/// The first `count` nonzero terms, fewer if f is the sum of fewer (at most `depth` degrees are
/// looked at beyond the lowest one).  Requires f != 0.
/// Given   const Ring ring = make_ring({"x", "y"});
/// Given   const MFraction x = MFraction::variable(ring, "x"), y = MFraction::variable(ring, "y");
/// Example weight_expansion(x / (MFraction(ring, 1) - y), {{0, 1}, {1, 2}}, 2)
///         // -> {{1, x}, {3, x*y}}
[[nodiscard]] std::vector<WeightTerm> weight_expansion(const MFraction& f, const Weights& weights,
                                                       long count, long depth = 64);

/// The sum of the terms of least weight, and of those of largest.  Requires f != 0.
[[nodiscard]] MPoly lowest_part(const MPoly& f, const Weights& weights);
[[nodiscard]] MPoly highest_part(const MPoly& f, const Weights& weights);

/// s as above; unset if the bracket is not homogeneous.
[[nodiscard]] std::optional<long> structure_weight(const VectorField& v, const Weights& weights);

/// The lowest-order field: components of degree w_j + k with the least k that occurs.
struct LowestSystem {
  long degree = 0; ///< k
  std::vector<MFraction> components;
  std::vector<WeightTerm> hamiltonian; ///< the expansion of H, if there is one
  std::optional<long> structure;       ///< s
  bool is_hamiltonian = false; ///< the components are J grad of the lowest term of H (checked)
};
/// The lowest system for the weights of the file.  Errors  InvalidArgument: no weights, or the field is 0
[[nodiscard]] LowestSystem lowest_system(const System& s, long terms = 2);

} // namespace kov
