#pragma once
// The judge of certificates of matrices of loops: accepts one or names the first rule that fails.
// It links lib/exact only and continues along the polygons by itself (docs/theory/loop_certificates.md).

#include "certify/equation/check.hpp"
#include "certify/loops/certificate.hpp"

namespace kov::certify {

/// Never throws.  Rejected::step is the rule.
/// Cost  a Taylor series of about `bits` terms for each segment and each unknown
[[nodiscard]] std::variant<Accepted, Rejected> check_loops(const LoopsCertificate& c);

/// The lines of section 5.  Requires a certificate that was accepted.
[[nodiscard]] std::vector<std::string> statement(const LoopsCertificate& c);

} // namespace kov::certify
