#pragma once
// The certificate format kovacic-homoclinic/1 as plain data, with its JSON reader: a canonical
// Hamiltonian of two degrees of freedom, a section of a level, and guesses of a fixed point of the
// section map and of an orbit that is homoclinic to it.  docs/theory/chaos.md 6 defines every entry.
// Nothing here is checked beyond syntax and limits.

#include "certify/system/certificate.hpp"

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

} // namespace kov::certify
