#include "integrability/missing.hpp"

namespace kov {

std::string sentence(const Missing& m) {
  using What = Missing::What;
  switch (m.what) {
  case What::limit:
  case What::undefined:
  case What::program_error:
  case What::elsewhere:
    return m.of;
  case What::no_change:
    return m.of.empty() ? "no change of variable was found" : m.of;
  case What::no_change_on_all_components:
    return "the phase curve has several components, " + m.more +
           " = 0 on it: study one of them, with one factor = 0 among the equations; on all "
           "together " +
           sentence(Missing{What::no_change, m.of});
  case What::parameters_in_r:
    return "r depends on " + m.of + "; give values with --set to decide single equations";
  case What::only_where:
    return "decided only where " + m.of + " is not zero: " + m.more;
  case What::relations_fall_apart:
    return "the relations of the functions fall apart for some parameters";
  case What::large_block:
    return "a normal block of order " + m.of +
           ": not reducible to second order by the invariant manifold, linear first integrals or "
           "block "
           "structure";
  case What::not_on_the_leaf:
    return "not seen on the symplectic leaves: nothing was concluded from it";
  case What::refused_way:
    return "an answer was found, and our own checker refuses the way from the system to r(z): " +
           m.of;
  case What::other_blocks:
    return "the normal system has other blocks at this level";
  case What::no_curve:
    return "at these values " + m.of;
  }
  return "";
}

std::string sentence(const NoWay& n) {
  const bool by_checker = n.why == NoWay::Why::refused || n.why == NoWay::Why::too_large;
  return (by_checker ? "the checker refuses it, " : "") + n.of;
}

std::string sentence(const LeftOut& l) {
  using What = LeftOut::What;
  switch (l.what) {
  case What::coupling:
    return l.of;
  case What::parameters:
    return "the parameters for which " + l.of + " is zero were not studied";
  case What::component:
    return "the component of the phase curve where " + l.of + " = 0 was not studied";
  case What::components:
    return "whether the phase curve has components that were not studied: " + l.of;
  }
  return "";
}

} // namespace kov
