#pragma once
// The judge of certificates of the whole way: accepts one or names the first rule that fails.  It
// links lib/exact only and searches for nothing (docs/theory/system_certificates.md).

#include "certify/strata/check.hpp"
#include "certify/system/certificate.hpp"
#include "literature/integral_class.hpp"
#include "proof/algebra/arithmetic.hpp"

#include <set>

namespace kov::certify {

/// A leaf of the inner certificate that says "not abelian", or where it is.
struct LeafOfWay {
  std::vector<Condition> path; ///< the conditions on the way to it
  std::size_t trusted = 0;
  IntegralClass integrals;                   ///< excluded by this leaf
  std::optional<OneDifference> difference{}; ///< of a criterion, in the names of the leaf
};

struct SystemAccepted {
  std::size_t trusted = 0;     ///< steps of the inner certificate that are taken on faith
  bool not_integrable = false; ///< at all admitted points
  bool somewhere = false;      ///< at some admitted points, as far as the leaves say
  IntegralClass integrals;     ///< section 7: which first integrals are excluded
  /// By phase variable: functions that have a value, and the coordinates with a value on which they depend;
  /// the same of those functions that no relation fixes (C7).
  std::vector<bool> seen_by_functions, seen_by_free_functions;
  std::vector<LeafOfWay> leaves, criteria; ///< those that say "not abelian", and "where"
  std::vector<std::string> lines;          ///< the statement of the inner certificate
};

/// Never throws.  Rejected::step is the rule.
/// Cost  counted polynomial products (Arithmetic)
[[nodiscard]] std::variant<SystemAccepted, Rejected> check_way(const SystemCertificate& c);

/// The way alone, to y'' = (num/den) y: what the rules up to N4 have against it, or nothing.  Names
/// of r: z, parameters and algebraic constants of the system.
[[nodiscard]] std::optional<Rejected> objection(const Way& w, const Fraction& r);
/// The same of a certificate, but for what is inside it.
[[nodiscard]] std::optional<Rejected> objection(const SystemCertificate& c);

/// "(p)/(n*(d_1)^2*(d_2))", as it was given.
[[nodiscard]] std::string shown_element(const PhaseCurve& c, const CurveFunction& f);
/// "w^2 = z": a step of the tower.
[[nodiscard]] std::string shown_step(const PhaseCurve& c, std::size_t i);
/// "p", or "(p)/n".
[[nodiscard]] std::string to_string(const PhaseFunction& f);
/// "the phase curve with z = q1 on 'N': q2 = 0, p2 = 0; levels H - h = 0"
[[nodiscard]] std::string phase_curve(const SystemCertificate& c);
/// Bracket and Hamiltonian, or the field; the functions, the inverses, the relations: a line each.
[[nodiscard]] std::vector<std::string> shown_system(const PhaseSystem& s);
/// "for functions with s = 0, c = 1 there, where q1 = 0, w^2 = z", if there are some: with the names of the
/// tower that are in it.
struct FunctionsThere {
  std::vector<std::string> text;
  std::string short_text;              ///< without the tower
  std::set<std::string> names, chosen; ///< in it; in what is seen by free functions
};
[[nodiscard]] FunctionsThere functions_there(const SystemCertificate& c,
                                             const SystemAccepted& found);
/// The names in an element as it was given, and in the steps of the tower that it uses.
[[nodiscard]] std::set<std::string> names_in(const PhaseCurve& c, const CurveFunction& f);
/// Is f, in the phase names, 0 along the curve?  false: a name has no value.  Requires a certificate that was
/// accepted.
[[nodiscard]] bool holds_on_curve(const Way& w, const MPoly& f, Arithmetic& a);
/// The lines of section 8.  Requires a certificate that was accepted, with what was found.
[[nodiscard]] std::vector<std::string> statement(const SystemCertificate& c,
                                                 const SystemAccepted& found);

} // namespace kov::certify
