#pragma once
// The compiled steppers of fields: which instruction set, which pack.

#include "flow/field/field.hpp"

namespace kov::flow {

enum class Isa : std::uint8_t { baseline, avx2, avx512 };

/// The best instruction set that both this build and this processor have; the environment variable
/// KOVACIC_ISA = baseline, avx2 or avx512 forbids better ones (for tests and measurements).
[[nodiscard]] Isa best_isa();
/// How many orbits at a time are fastest (measured: docs/accuracy.md): as many as fit into a
/// register, and not more, since packs wider than the registers live in memory.
[[nodiscard]] int best_lanes(Isa isa = best_isa());
[[nodiscard]] std::string to_string(Isa isa);

/// Integrates all orbits of `run`.
///
/// Shape     lanes: 1, 4 or 8 orbits at a time for double (other types have one), 0: best_lanes; the results of an
///           orbit do not depend on it
/// Requires  the tapes are for run.order; 4 <= run.order <= max_degree
void integrate_field(const FieldTapes<double>& tapes, const FieldRun<double>& run, int lanes = 0,
                     Isa isa = best_isa());
void integrate_field(const FieldTapes<Twin1>& tapes, const FieldRun<Twin1>& run, int lanes = 0,
                     Isa isa = best_isa());
void integrate_field(const FieldTapes<long double>& tapes, const FieldRun<long double>& run);
void integrate_field(const FieldTapes<BigReal>& tapes, const FieldRun<BigReal>& run);

/// The scales of the motion, as a few of the orbits show them.
struct Scales {
  std::vector<double> of; ///< the size of each variable, a power of 2
  std::vector<double>
      path; ///< states along the orbits, one after the other: for the sizes of functions
};
/// Follows a few of the orbits for some hundred steps, not beyond t_end, and not far away from where they start.
/// Shape  starts: f.variables() numbers for each orbit
[[nodiscard]] Scales scales_of(const Field& f, const std::vector<double>& starts, double t_end);
/// The order with which the field costs least for this tolerance, measured at these states.
[[nodiscard]] int choose_order(const Field& f, const Scales& scales, double log2_tolerance);

} // namespace kov::flow
