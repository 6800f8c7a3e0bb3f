#pragma once
// The format kovacic-system/1 as plain data, with its JSON reader and writer, and its judge: a system, a solution of
// it as functions of z, an identity along it that leads to y'' = r y or to a system, and the certificate of that.
// docs/theory/system_certificates.md defines every entry (names in comments are its rules).  Nothing is checked
// beyond syntax and limits when it is read; the judge links lib/exact only and searches for nothing.

#include "certify/loops/check.hpp"
#include "certify/strata/check.hpp"
#include "literature/integral_class.hpp"
#include "proof/algebra/arithmetic.hpp"

#include <set>

namespace kov::certify {

/// p/n in the phase names.
struct PhaseFunction {
  MPoly p;
  Integer n{1};
};

/// A symbol for an analytic function of which only the gradient is known.
struct PhaseSymbol {
  std::string meaning;
  std::vector<std::pair<std::size_t, PhaseFunction>> gradient; ///< by coordinate; others are 0
};
struct PhaseBracket {
  std::size_t first = 0, second = 0; ///< coordinates
  PhaseFunction value;
};

/// S1, S2.  The ring has the coordinates, the functions, the inverses and the parameters, in this
/// order.
struct PhaseSystem {
  Ring ring;
  std::size_t dimension = 0;
  std::vector<PhaseSymbol> functions;
  std::vector<MPoly> inverses; ///< what they are the inverses of
  std::vector<MPoly> relations;
  std::optional<PhaseFunction> hamiltonian;
  std::vector<PhaseBracket> brackets; ///< with a Hamiltonian
  std::vector<PhaseFunction> field;   ///< without one

  [[nodiscard]] std::size_t first_inverse() const { return dimension + functions.size(); }
  [[nodiscard]] std::size_t first_parameter() const { return first_inverse() + inverses.size(); }
  [[nodiscard]] std::vector<std::string> parameters() const {
    return {ring->names().begin() + static_cast<long>(first_parameter()), ring->names().end()};
  }
};

/// S4.  cofactors: one list for an integral, one for each coordinate for a Casimir function.
struct ClaimedFunction {
  bool casimir = false;
  std::string name;
  PhaseFunction value;
  std::vector<std::vector<PhaseFunction>> cofactors;
};

/// p/(n d_1^e_1 ... d_m^e_m) in the field names.
struct CurveFunction {
  MPoly p;
  Integer n{1};
  std::vector<unsigned long> over{}; ///< e_1, e_2, ...; those left out are 0
};
using CurveRow = std::vector<CurveFunction>;

/// w^degree = value.
struct TowerStep {
  unsigned long degree = 2;
  CurveFunction value, derivative;
};

/// C1 to C6.  The ring has the tower from the last to the first, z and the parameters.
struct PhaseCurve {
  Ring ring;
  std::vector<TowerStep> tower; ///< step i has the variable tower.size() - 1 - i of the ring
  std::string manifold;
  std::vector<PhaseFunction> equations, levels;
  PhaseFunction change;
  std::vector<MPoly> denominators;
  std::vector<std::pair<std::size_t, CurveFunction>> values; ///< by variable of the phase ring
  CurveFunction time;                                        ///< dt/dz

  [[nodiscard]] std::size_t z() const { return tower.size(); }
  [[nodiscard]] std::size_t variable(std::size_t step) const { return tower.size() - 1 - step; }
};

struct Annihilator {
  CurveRow row, matrix;
};

/// N1 to N3; with several rows N5.
struct NormalIdentity {
  std::vector<Annihilator> annihilators;
  std::vector<CurveRow> rows; ///< one of y'' = r y
  CurveFunction p, q;         ///< of this one
  std::vector<CurveRow> rests;
  std::vector<CurveRow> vectors; ///< two, or one for each row of a system
  bool is_system = false;
  bool whole = false; ///< on the whole Poisson manifold
};

/// From the system to y'' = r y, or to Y' = A Y.
struct Way {
  std::string title;
  PhaseSystem system;
  std::vector<ClaimedFunction> claims;
  PhaseCurve curve;
  NormalIdentity normal;
};

struct SystemCertificate {
  Way way;
  std::variant<Certificate, StrataCertificate, LoopsCertificate> equation;
  std::optional<CurveFunction> root; ///< where the generator of the field of the equation goes
  bool not_integrable = false;       ///< what is claimed
};

/// Throws InvalidArgument (one sentence, with the path of the offending entry) on anything that is
/// not a certificate of this format or exceeds its limits.
[[nodiscard]] SystemCertificate read_system_certificate(std::string_view text);
/// The object `system` in other data.
[[nodiscard]] PhaseSystem read_phase_system(const Node& n,
                                            const std::vector<std::string>& parameters);
/// "P" or ["P", "n"].
[[nodiscard]] PhaseFunction read_phase_function(const Ring& ring, const Node& n);
/// "P" or ["P", "n", "e_1", ...], with the ring and the denominators of c.
[[nodiscard]] CurveFunction read_curve_function(const PhaseCurve& c, const Node& n);
[[nodiscard]] Json to_json(const CurveFunction& f);
[[nodiscard]] Json to_json(const PhaseFunction& f);
/// The object `system`.
[[nodiscard]] Json to_json(const PhaseSystem& s);

/// The names that values of this format and of kovacic-jets/1 are in (fields.hpp).
struct CurveSetting {
  const Ring* ring = nullptr;
  const PhaseCurve* curve = nullptr;
  const std::vector<std::string>* parameters = nullptr; ///< where the system is read
};
inline void read_entry(const Node& n, PhaseFunction& x, const CurveSetting& s) {
  x = read_phase_function(*s.ring, n);
}
inline Json write_entry(const PhaseFunction& x, const CurveSetting& /*s*/) { return to_json(x); }
inline void read_entry(const Node& n, CurveFunction& x, const CurveSetting& s) {
  x = read_curve_function(*s.curve, n);
}
inline Json write_entry(const CurveFunction& x, const CurveSetting& /*s*/) { return to_json(x); }

[[nodiscard]] std::string write_system_certificate(const SystemCertificate& c);

// ---- the judge

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
