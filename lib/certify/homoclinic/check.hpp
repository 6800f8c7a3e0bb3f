#pragma once
// The judge of certificates of homoclinic points: accepts one or names the first section of
// docs/theory/chaos.md that fails.  It encloses all orbits again, by code of its own.

#include "certify/equation/check.hpp"
#include "certify/homoclinic/certificate.hpp"

namespace kov::certify {

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
