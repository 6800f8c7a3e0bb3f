#pragma once
// The format kovacic-homoclinic/1 as plain data, and its judge, which accepts one or names the first section of
// docs/theory/chaos.md that fails: a canonical Hamiltonian of two degrees of freedom, a section of a level, and
// guesses of a fixed point of the section map and of an orbit that is homoclinic to it.  Section 6 there defines
// every entry.  The judge encloses all orbits again, by code of its own.

#include "certify/equation/check.hpp"
#include "certify/system/check.hpp"

#include <array>

namespace kov::certify {

using FourNumbers = std::array<Rational, 4>;

struct HomoclinicCertificate {
  Ring ring; ///< q1, q2, p1, p2
  PhaseFunction hamiltonian, section;
  std::optional<PhaseFunction> where;
  Rational level;
  bool rising = true;
  long period = 1;
  FourNumbers point;
  std::array<std::size_t, 2> chart{};
  std::array<std::array<Rational, 2>, 2> axes; ///< A
  Rational reach, xi, eta;
  std::vector<FourNumbers> orbit; ///< z_1 ... z_(n-1)
};

/// Throws InvalidArgument (one sentence, with the path of the offending entry) on anything that is
/// not a certificate of this format or exceeds its limits.
[[nodiscard]] HomoclinicCertificate read_homoclinic_certificate(std::string_view text);

struct HomoclinicAccepted {
  std::size_t trusted = 0;             ///< the theorem of Smale and Moser
  std::array<double, 2> fixed_point{}; ///< in the chart, rounded
};

/// Never throws.  Rejected::step is the section.
/// Cost  a few enclosures of the whole orbit
[[nodiscard]] std::variant<HomoclinicAccepted, Rejected>
check_homoclinic(const HomoclinicCertificate& c);

/// The statement, line by line.  Requires a certificate that was accepted, with what was found.
[[nodiscard]] std::vector<std::string> statement(const HomoclinicCertificate& c,
                                                 const HomoclinicAccepted& found);

} // namespace kov::certify
