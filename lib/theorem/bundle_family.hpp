#pragma once
// The family of a certificate of a theorem, and its places (docs/theory/theorem_certificates.md 1, 3, 12).

#include "certify/theorem/family.hpp"
#include "integrability/way_names.hpp"
#include "parameters/complex_proof.hpp"
#include "theorem/place.hpp"

namespace kov {

[[nodiscard]] Json json_conditions(const std::vector<Condition>& all);

/// The same for a writer; all in the ring of the family.
struct PartPlace : certify::StepPlace {
  Json values;                  ///< of the parameters that are put in
  Substitution put;             ///< the same
  std::vector<Condition> given; ///< all that is known there
  Substitution levels{}; ///< of parameters that only the system of a certificate has, in its ring
};

/// A system all of whose parameters are real; its denominators stand beside the assumptions.
[[nodiscard]] System with_real_parameters(System s);

/// A system as a certificate has it, without the parameters that only label levels.
class BundleFamily {
public:
  /// Errors  DomainError
  BundleFamily(System s, std::string name);
  BundleFamily(const BundleFamily&) = delete;
  BundleFamily& operator=(const BundleFamily&) = delete;

  [[nodiscard]] const System& system() const { return s_; }
  [[nodiscard]] const certify::Family& family() const { return family_; }
  [[nodiscard]] const std::string& name() const { return family_.name; }
  [[nodiscard]] const Ring& ring() const { return phase().ring; }
  [[nodiscard]] const certify::PhaseSystem& phase() const { return family_.system; }
  [[nodiscard]] std::vector<std::string> parameters() const;
  [[nodiscard]] const std::vector<Condition>& assumptions() const { return family_.assumptions; }
  /// In the ring of the system; their inverses are names of the family.
  [[nodiscard]] const std::vector<MPoly>& divisors() const { return writer_.divisors(); }
  [[nodiscard]] const std::string& inverse_name(std::size_t k) const {
    return ring()->name(phase().first_inverse() + k);
  }
  [[nodiscard]] Condition moved(const Condition& c) const;
  [[nodiscard]] std::vector<Condition> moved(const std::vector<Condition>& all) const;
  /// All that is known where these conditions hold.
  [[nodiscard]] std::vector<Condition> known_where(const std::vector<Condition>& region) const;
  /// Values of parameters, in the ring of the system.
  [[nodiscard]] Substitution in_system(const Substitution& put) const;
  [[nodiscard]] ComplexProof proof(const Budget& budget) const {
    return {ring(), family_.complex, budget};
  }
  /// Errors  DomainError: another denominator than those of the system
  [[nodiscard]] certify::PhaseFunction written(const MFraction& f);

  /// Errors  DomainError: parameters are put to quotients
  [[nodiscard]] PartPlace placed(const Substitution& put, std::vector<Condition> region) const;
  /// base: the system with these values
  [[nodiscard]] PartPlace placed(const ParameterValues& at, const System& base,
                                 std::vector<Condition> region) const;
  [[nodiscard]] PartPlace placed(const Place& place, const System& base) const {
    return placed(place.at, base, moved(conditions_of(s_, place)));
  }

  [[nodiscard]] Json json() { return Json{members()}; }
  /// With the Lagrangian that the Hamiltonian comes from, if the file gives a polynomial.
  [[nodiscard]] Json json_with_lagrangian();

private:
  void assume();
  [[nodiscard]] Json::Object members() const;

  System s_;
  PhaseWriter writer_;
  certify::Family family_;
};

} // namespace kov
