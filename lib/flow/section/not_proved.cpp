#include "flow/section/not_proved.hpp"

namespace kov::flow {

std::string to_string(NotProved why) {
  switch (why) {
  case NotProved::not_tried:
    return "not tried";
  case NotProved::no_time:
    return "there was no time left";
  case NotProved::enclosure_lost:
    return "the enclosure of an orbit is lost";
  case NotProved::no_box:
    return "the orbit could not be contained in a box";
  case NotProved::no_return:
    return "the orbit did not return within " + std::to_string(max_steps_of_a_return) + " steps";
  case NotProved::end_of_step:
    return "a crossing could not be separated from the end of a step";
  case NotProved::section_piece:
    return "a piece of the section surface could not be enclosed";
  case NotProved::section_value:
    return "the equations of the section have no value";
  case NotProved::another_sheet:
    return "the orbit may return on another sheet of the level";
  case NotProved::multiplier_one:
    return "a multiplier is 1, or nearly";
  case NotProved::left_by_newton:
    return "Newton's method left what the search had found";
  case NotProved::krawczyk:
    return "Krawczyk's test failed on every box that was tried";
  case NotProved::smaller_period:
    return "a smaller period is not excluded";
  case NotProved::no_orbit:
    return "no hyperbolic periodic orbit was found";
  case NotProved::no_crossing:
    return "no crossing of the manifolds was found";
  case NotProved::not_hyperbolic:
    return "the orbit is not proved to be hyperbolic";
  case NotProved::no_cones:
    return "no parallelogram around the hyperbolic point keeps cones";
  case NotProved::tangent:
    return "the manifolds are tangent, or nearly";
  case NotProved::outside:
    return "the crossing may lie outside of the parallelogram, or be the fixed point";
  case NotProved::refused:
    return "our own checker refuses the certificate";
  case NotProved::leaves_sheet:
    return "the manifold may leave its sheet";
  }
  return "";
}

} // namespace kov::flow
