#include "literature/trusted.hpp"

#include <algorithm>

namespace kov {

std::string sentence(const Trusted& t) {
  using Step = Trusted::Step;
  switch (t.step) {
  case Step::refuted_by_z3:
    return "Z3: no real parameters satisfy the assumptions" + t.of;
  case Step::no_root_by_z3:
    return "Z3: no real root of " + t.of + " satisfies the conditions";
  case Step::composition:
    return "that the steps give the statement, of which there is no certificate: " + t.of;
  case Step::solver:
    return "the solver: " + t.of;
  case Step::uncertified_strata:
    return "strata without a certificate: " + t.of;
  case Step::uncertified_answer:
    return "the solver, without a certificate" + t.of;
  case Step::closed_answer:
    return "the classical criterion of a known equation, without a certificate";
  case Step::necessary_conditions:
    return "necessary conditions of undecided strata";
  case Step::exponential_families:
    return "the families of exponential solutions, which have no certificate";
  case Step::solved_for_the_energy:
    return "the conditions solved for the parameter, which have no certificate";
  case Step::way_to_r:
    return "the way from the system to r(z)" + t.of;
  case Step::way_to_matrices:
    return "the way from the system to " + t.of;
  case Step::enclosures:
    return "the enclosures of the monodromy matrices of " + t.of;
  case Step::whole_variation:
    return "that the blocks are all of the variational equation" + t.of;
  case Step::series:
    return "the series of the higher variational equations";
  case Step::group_of_normal_equation:
    return "the group of the normal equation";
  case Step::quadratures:
    return "higher variational equations by quadratures, along " + t.of;
  case Step::residues:
    return "the sums of residues at doubly asymptotic solutions of the free body";
  case Step::part_of_h:
    return "the " + t.of + " part of H, and from one leaf to the whole phase space";
  case Step::exponential_coordinates:
    return "exponentials as coordinates, also where they are 0";
  case Step::darboux_eigenvalues:
    return "the list of admissible eigenvalues at Darboux points";
  case Step::darboux_logarithm:
    return "the logarithm at multiple Darboux points";
  case Step::common_values:
    return "the common values of two exponent differences";
  case Step::gap:
  case Step::by_author:
    return t.of;
  }
  return "";
}

std::vector<std::string> sentences(const std::vector<Trusted>& all) {
  std::vector<std::string> texts(all.size());
  std::ranges::transform(all, texts.begin(), [](const Trusted& t) { return sentence(t); });
  return texts;
}

} // namespace kov
