#pragma once
// Why something is not proved; what is returned then says it.

#include <cstdint>
#include <string>

namespace kov::flow {

/// Thrown by the proofs in numbers.
enum class NotProved : std::uint8_t {
  not_tried,
  no_time,
  enclosure_lost,
  no_box,
  no_return, ///< within max_steps_of_a_return
  end_of_step,
  section_piece,
  section_value,
  another_sheet,
  multiplier_one,
  left_by_newton, ///< the point, orbit or crossing that the search had found
  krawczyk,
  smaller_period,
  no_orbit,
  no_crossing,
  not_hyperbolic,
  no_cones,
  tangent,
  outside,
  leaves_sheet,
  refused ///< the certificate, by our own checker
};
inline constexpr int max_steps_of_a_return = 3000;

/// Example to_string(NotProved::tangent)  // -> the manifolds are tangent, or nearly
[[nodiscard]] std::string to_string(NotProved why);

} // namespace kov::flow
