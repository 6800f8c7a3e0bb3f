#pragma once
// The scene of a body as one of the general engine.

#include "flow/scene/system_scene.hpp"

namespace kov::flow {

/// The body on e(3), in own units: coordinates N = M - B, then Gamma, along axes of which the third is the section's;
/// l and L/G are the longitude of N and its height over its length.  (The general engine takes the units of a system as
/// they are; but N = 10^120 in the units of a scene is allowed, and its cube is no double.)
///
/// Errors  InputError: own_units.hpp
[[nodiscard]] SystemScene system_of(const Scene& scene);

/// (N, Gamma) of a state, along those axes.
template <class R>
std::vector<R> coordinates_of(const Body<R>& b, const State<R>& x, const SectionRule& rule) {
  const Vec<R> n = turned_to(minus(momentum(b, x), b.gyrostat), rule.axis);
  const Vec<R> gamma = turned_to(x.gamma, rule.axis);
  return {n[0], n[1], n[2], gamma[0], gamma[1], gamma[2]};
}

/// The states over (l, L/G), one for each G, ascending, whichever way the section is crossed there.
[[nodiscard]] std::vector<std::vector<double>> states_over(const BodyScene& b, double l, double y);

/// The state over (l, L/G) near another one, to the last digit.
template <class R>
std::vector<R> refined_state(const BodyScene& b, const R& l, const R& y,
                             const std::vector<double>& near) {
  const Body<R> body = b.own.body<R>();
  return coordinates_of(body,
                        refine_point(body, b.own.levels<R>(), b.own.section, l, y,
                                     std::hypot(near[0], near[1], near[2])),
                        b.own.section);
}

} // namespace kov::flow
