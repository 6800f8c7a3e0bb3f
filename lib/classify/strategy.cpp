#include "classify/shares.hpp"
#include "classify/stages.hpp"

namespace kov {

std::span<const PartOfTheWhole> parts_of_the_whole() {
  static constexpr PartOfTheWhole all[] = {
      {"the manifolds of the file, as check studies them", share::stated},
      {"a search for canonical variables in which the system is simpler", share::change},
      {"symmetries of the family", share::symmetries},
      {"rounds in the variables of the file (all of the work, if there are no simpler ones)",
       share::here_first},
      {"rounds in the simpler ones; then in those of the file again", share::there},
      {"of these, one round (all of it: without parameters, or in a last round)", share::round},
      {"of these, the rounds before algebraic constants, if solutions ask for some",
       share::without_constants},
      {"of these, all but a last search for integrals, if the work has ended before",
       share::before_a_last_look},
      {"of these, the rounds before matrices at a point, if blocks may be large",
       share::all_but_points},
  };
  return all;
}

std::span<const Stage> strategy() {
  using namespace stages;
  static constexpr Stage all[] = {
      // what, its part of the work of the round that is left, the same in a last round
      {"what the manifolds of the file exclude", 0, 0, stated, take_stated},
      {"splitting of the separatrices of a free body", 0.3, 0.3, splitting, study_splitting},
      {"a frame in which a parameter is 0", 0.05, 0.05, frames, choose_frame},
      {"the part of lowest order, as a family of its own", 0.4, 0.4, leading, study_leading},
      {"first integrals of low degree", 0.25, 0.25, low_integrals, find_low_integrals},
      {"Darboux points (three parameters or more)", 0.3, 0.3, darboux_points_first,
       study_darboux_points},
      {"one answer for all parameters", 0.1, 0.1, one_answer, try_one_answer},
      {"a search for invariant sets", 0.2, 0.2, search, find_solutions},
      {"along each of them", 0.4, 0.8, found, study_along},
      {"Darboux points", 0.3, 0.3, darboux_points, study_darboux_points},
      {"where exponentials are 0", 0.3, 0.3, faces, study_faces},
      {"common values of exponent differences (one parameter)", 0.1, 0.1, conditions_on_one,
       meet_conditions},
      {"integrals that would contradict", 0.01, 0.01, contradictions, look_for_a_contradiction},
      {"first integrals", 0.3, 0.5, integrals, find_integrals},
      {"first integrals with larger coefficients", 0.5, 0.5, larger_integrals,
       find_larger_integrals},
      {"common values of exponent differences", 1, 1, conditions, meet_conditions},
      {"along invariant sets at H = 0", 0.2, 0.8, at_energy_zero, study_along},
      {"common values of exponent differences", 1, 1, conditions, meet_conditions},
      {"along invariant sets at more levels", 0.5, 0.8, at_all_levels, study_along},
      {"the part of highest order, as a family of its own (rational integrals)", 0.4, 0.4, highest,
       study_highest},
      {"higher variational equations", 0.3, 0.3, higher_orders, study_higher_orders},
      {"first integrals of high degree", 0.5, 0.5, high_integrals, find_high_integrals},
      {"first integrals with one larger option (two seconds for all rounds)", 0.5, 0.5,
       further_integrals, find_further_integrals},
      {"exceptions that take long to write down", 1, 1, exceptions, tell_exceptions},
  };
  return all;
}

} // namespace kov
