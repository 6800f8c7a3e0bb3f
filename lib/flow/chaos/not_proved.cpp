#include "flow/chaos/not_proved.hpp"

#include <array>

namespace kov::flow {

std::string to_string(NotProved why) {
  static const std::array<std::string, static_cast<std::size_t>(NotProved::refused) + 1> all{
      "not tried",
      "there was no time left",
      "the enclosure of an orbit is lost",
      "the orbit could not be contained in a box",
      "the orbit did not return within " + std::to_string(max_steps_of_a_return) + " steps",
      "a crossing could not be separated from the end of a step",
      "a piece of the section surface could not be enclosed",
      "the equations of the section have no value",
      "the orbit may return on another sheet of the level",
      "a multiplier is 1, or nearly",
      "Newton's method left what the search had found",
      "Krawczyk's test failed on every box that was tried",
      "a smaller period is not excluded",
      "no hyperbolic periodic orbit was found",
      "no crossing of the manifolds was found",
      "the orbit is not proved to be hyperbolic",
      "no parallelogram around the hyperbolic point keeps cones",
      "the manifolds are tangent, or nearly",
      "the crossing may lie outside of the parallelogram, or be the fixed point",
      "the manifold may leave its sheet",
      "our own checker refuses the certificate"};
  return all.at(static_cast<std::size_t>(why));
}

} // namespace kov::flow
