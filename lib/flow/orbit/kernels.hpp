#pragma once
// The compiled kernels: which instruction set, which pack, which set of effects.

#include "flow/number/big_real.hpp"
#include "flow/orbit/stepper.hpp"

#include <cstdint>
#include <string>

namespace kov::flow {

enum class Isa : std::uint8_t { baseline, avx2, avx512 };

/// The best instruction set that both this build and this processor have; the environment variable
/// KOVACIC_ISA = baseline, avx2 or avx512 forbids better ones (for tests and measurements).
[[nodiscard]] Isa best_isa();
/// How many orbits at a time are fastest (measured: docs/accuracy.md): as many as fit into a
/// register, and not more, since packs wider than the registers live in memory.
[[nodiscard]] int best_lanes(Isa isa = best_isa());
[[nodiscard]] std::string to_string(Isa isa);

/// Integrates all orbits of `run` with the kernel for exactly the effects `e`.
///
/// Shape     lanes: 1, 4 or 8 orbits at a time for double (other types have one), 0: best_lanes;
///           the results of an orbit do not depend on it
/// Requires  e is in effect_sets and covers the body; model = model_of(body, e); run.order >= 4
/// Cost      the inner loops allocate nothing
void integrate(const Effects& e, const Model<double>& model, bool sliding, const Run<double>& run,
               int lanes = 0, Isa isa = best_isa());
void integrate(const Effects& e, const Model<Twin1>& model, bool sliding, const Run<Twin1>& run,
               int lanes = 0, Isa isa = best_isa());
void integrate(const Effects& e, const Model<long double>& model, bool sliding,
               const Run<long double>& run);
void integrate(const Effects& e, const Model<BigReal>& model, bool sliding,
               const Run<BigReal>& run);

/// The order with which the orbits together cost least for the given tolerance, measured at their
/// starts.
[[nodiscard]] int choose_order(const Effects& e, const Model<double>& model, const double* starts,
                               std::size_t orbits, double log2_tolerance);

} // namespace kov::flow
