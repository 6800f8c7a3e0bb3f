#pragma once
// Certificates of the equations y'' = r(z) y behind the verdict of a manifold, with the way from the
// system to r where it can be written (way.hpp).  Where it cannot, what lib/certify can check is the
// group; the way and the theorem that follows are trusted steps, named and counted.

#include "integrability/report.hpp"

namespace kov {

struct NamedCertificate {
  std::string name; ///< "manifold", "manifold-level", "manifold-special", "manifold-level-2", ...
  std::string json;
  std::string none; ///< why there is none
};

/// One for each equation that was decided with a certificate (Options::want_certificate).  Those
/// that force "non-integrable" go on to that statement.
/// Given   const System system = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['q1', 'q2'], momenta = ['p1', 'p2'], parameters = ['h'], "
///             "hamiltonian = '(p1^2 + p2^2)/2 + q1^2*q2 + q2^3/2'}\n"
///             "manifold = [{name = 'N', equations = ['q1 = 0', 'p1 = 0'], level = ['H = h']}]",
///             "cubic.toml"), {{"h", "1"}});
/// Given   CheckOptions options; options.decide.want_certificate = true;
/// Given   const ManifoldReport report = check_manifold(system, system.manifolds.front(), {}, options);
/// Example certificates(system, report).front().name  // -> N
[[nodiscard]] std::vector<NamedCertificate> certificates(const System& s, const ManifoldReport& m);

} // namespace kov
