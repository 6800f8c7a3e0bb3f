#pragma once
// Certificates of the equations y'' = r(z) y behind the verdict of a manifold.  What lib/certify
// can check ends with the group; the way from the system to r and the theorem that follows are
// trusted steps, named and counted.

#include "integrability/check.hpp"

namespace kov {

struct NamedCertificate {
  std::string name; ///< "manifold", "manifold-level", "manifold-special", "manifold-level-2", ...
  std::string json;
  std::string none; ///< why there is none
};

/// One for each equation that was decided with a certificate (Options::want_certificate).  Those
/// that force "non-integrable" go on to that statement.
[[nodiscard]] std::vector<NamedCertificate> certificates(const System& s, const ManifoldReport& m);

} // namespace kov
