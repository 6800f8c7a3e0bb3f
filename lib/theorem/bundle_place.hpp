#pragma once
// Families and changes of variables, as a certificate of a theorem has them
// (docs/theory/theorem_certificates.md 1, 3, 4).

#include "certify/theorem/fact.hpp"
#include "integrability/way_names.hpp"
#include "parameters/refutation.hpp"
#include "theorem/place.hpp"

namespace kov {

/// A system with real parameters, and what is assumed of them.
class FamilyWriter {
public:
  /// Errors  DomainError: a system that is not a family of the format
  FamilyWriter(const System& s, std::string name, const std::vector<Assumption>& assumed);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] Json json();
  [[nodiscard]] Json function(const MFraction& f);
  [[nodiscard]] const Ring& ring() const { return writer_.ring(); }
  [[nodiscard]] const std::vector<MPoly>& divisors() const {
    return writer_.divisors();
  } ///< in the ring of the system
  [[nodiscard]] std::string inverse_name(std::size_t k) const;
  [[nodiscard]] const std::vector<Condition>& assumptions() const { return assumptions_; }
  [[nodiscard]] const System& system() const { return s_; }
  [[nodiscard]] std::vector<std::string> parameters() const;
  /// A condition on the parameters, in the ring.
  [[nodiscard]] Condition moved(const Condition& c) const;

private:
  [[nodiscard]] Json lagrangian();

  System s_;
  std::string name_;
  PhaseWriter writer_;
  std::vector<Condition> assumptions_;
};

[[nodiscard]] Json json_conditions(const std::vector<Condition>& all);

/// Y of a place.
struct BundleTarget {
  std::vector<std::string> coordinates, parameters;
  std::vector<std::pair<std::string, MPoly>> inverses; ///< that the system uses
  std::vector<certify::AskedCondition> asked;          ///< of its parameters, in this order
};
[[nodiscard]] BundleTarget target_of(const FamilyWriter& y, const std::vector<Condition>& region,
                                     bool real);
/// The rule for the certificate of a system.
/// Errors  DomainError, InvalidArgument
[[nodiscard]] certify::Said said_by(const std::string& certificate);
/// Errors  DomainError: it does not say "not integrable" of all its points
[[nodiscard]] BundleTarget target_of(const certify::Said& said);

/// The members MAP of a step, with the values of levels that the map leaves open.
/// region: conditions in the ring of X, besides its assumptions; at: parameters that are put in.
/// Errors  DomainError: what is not shown; OutOfBudget
[[nodiscard]] Json::Object map_members(const FamilyWriter& x, const ParameterValues& at,
                                       const System& base, const PlaceMap& map,
                                       const std::vector<Condition>& region, const BundleTarget& y,
                                       const Budget& budget);
/// [[name, FUNCTION], ...] in the order of the parameters, and the equations n p - P = 0.
[[nodiscard]] std::pair<Json, std::vector<Condition>>
at_members(const FamilyWriter& x, const ParameterValues& at, const System& base);

} // namespace kov
