#pragma once
// The certificate format kovacic-system/1 as plain data, with its JSON reader and writer: a system,
// a solution of it as functions of z, an identity along it that leads to y'' = r y or to a system, and the
// certificate of that.  docs/theory/system_certificates.md defines every entry (names in
// comments are its rules).  Nothing here is checked beyond syntax and limits.

#include "certify/loops/check.hpp"
#include "certify/strata/certificate.hpp"
#include "proof/text/json_node.hpp"

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
/// At most so many entries.
[[nodiscard]] std::vector<std::string> read_texts(const Node& n, std::size_t most);
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

} // namespace kov::certify
