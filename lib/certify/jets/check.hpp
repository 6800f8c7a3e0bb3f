#pragma once
// The judge of certificates of higher variational equations: accepts one or names the first rule
// that fails.  It links lib/exact only and searches for nothing (docs/theory/jet_certificates.md).

#include "certify/equation/check.hpp"
#include "certify/jets/certificate.hpp"

namespace kov::certify {

struct JetsAccepted {
  std::size_t trusted = 0; ///< steps of the inner certificate that are taken on faith
  Rational energy;         ///< with ByGroup
};

/// Never throws.  Rejected::step is the rule.
/// Cost  counted polynomial products (Arithmetic)
[[nodiscard]] std::variant<JetsAccepted, Rejected> check_jets(const JetsCertificate& c);

/// The lines of section 5.  Requires a certificate that was accepted, with what was found.
[[nodiscard]] std::vector<std::string> statement(const JetsCertificate& c,
                                                 const JetsAccepted& found);

} // namespace kov::certify
