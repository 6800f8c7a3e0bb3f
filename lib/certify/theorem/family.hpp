#pragma once
// Families of systems X(p), and what is left of one where some parameters are functions of the others:
// theorem_certificates.md 1, 3, 12.

#include "certify/system/phase_space.hpp"
#include "certify/system/terms.hpp"
#include "certify/theorem/tower.hpp"
#include "proof/condition/show.hpp"

#include <map>
#include <memory>
#include <set>

namespace kov::certify {

/// A Hamiltonian that comes from a Lagrangian, (L1) to (L3): quadratic in the velocities, which come after the
/// names of phase space in the ring.
struct LagrangianForm {
  PhaseFunction value;
  std::vector<std::size_t> momenta;      ///< coordinates, one for each velocity
  std::vector<PhaseFunction> velocities; ///< on phase space
};
/// LAGRANGIAN, checked.
/// Errors  InvalidArgument, Refused
[[nodiscard]] LagrangianForm read_lagrangian(const Node& n, const PhaseSystem& s, Arithmetic& a);
/// "  H is the energy of the Lagrangian L = ..., M1 = dL/dOmega1"
[[nodiscard]] std::string shown_lagrangian(const LagrangianForm& l, const PhaseSystem& s);

/// Values of parameters of X that are functions of the others.
using ParameterFunctions = std::map<std::size_t, PhaseFunction>;

/// X: the parameters are real, but for those that are said to be complex.
struct Family {
  std::string name;
  PhaseSystem system;
  Conditions assumptions; ///< in the ring of the system
  std::optional<LagrangianForm> lagrangian{};
  std::vector<bool> complex{}; ///< by variable of the ring

  /// A Hamiltonian system without functions and relations, with real parameters.
  [[nodiscard]] bool is_plain() const;
  /// The points with these conditions.
  [[nodiscard]] ConditionSet where(const Conditions& given, Arithmetic& a) const;

  [[nodiscard]] bool is_parameter(std::size_t i) const { return i >= system.first_parameter(); }
  /// The parameters, by variable of the ring, but for those that are put in.
  [[nodiscard]] std::vector<bool> parameters(const ParameterFunctions& at = {}) const;
  /// Conditions on parameters that are called alike.
  [[nodiscard]] Conditions renamed(Conditions all) const {
    for (Condition& c : all)
      c.p = in_ring(c.p, system.ring);
    return all;
  }
  [[nodiscard]] Conditions region(const Node& n) const {
    return read_conditions(system.ring, n, parameters());
  }
};

/// FAMILY, with S1 and S2.
[[nodiscard]] Family read_family(const Node& n, Arithmetic& a);

/// A condition to be shown of the parameters of Y.  `real` beside the signs: the value is real.
struct AskedCondition {
  bool real = false;
  Sign sign = Sign::nonzero;
  MPoly f;
  std::vector<MPoly> group{}; ///< if there are some: not all of them are 0
};

/// Y.  Requires that the system stays alive.
struct Target {
  const PhaseSystem* system = nullptr;
  std::vector<AskedCondition> asked;
  const Way* way = nullptr;          ///< of a certificate, with the values of its functions
  std::set<std::string> chosen = {}; ///< names on which these values depend
};
[[nodiscard]] Target target_of(const Family& f, const Conditions& region, bool real);

/// The place of a step: the parameters of X that are put in, and the conditions besides.
struct StepPlace {
  const Family* family = nullptr;
  ParameterFunctions at;
  Conditions region;

  /// n p - P = 0 for each parameter put in, then the region.
  [[nodiscard]] Conditions conditions() const;
};

/// X at a place, in its own names and some more.
class Here {
public:
  /// The inverses of X are in the tower; of `more` nothing is known yet.
  Here(const StepPlace& x, const std::vector<std::string>& more, Arithmetic& a);
  Here(const Here&) = delete;
  Here& operator=(const Here&) = delete;

  [[nodiscard]] const Ring& ring() const { return ring_; }
  [[nodiscard]] const Functions& in() const { return in_; }
  [[nodiscard]] Tower& tower() { return tower_; }
  [[nodiscard]] const Tower& tower() const { return tower_; }
  /// Conditions on the parameters that are left, which hold there.
  [[nodiscard]] ConditionSet& given() { return *given_; }
  [[nodiscard]] const ConditionSet& given() const { return *given_; }
  /// By variable of the ring: the parameters that are left.
  [[nodiscard]] const std::vector<bool>& free() const { return free_; }
  /// f of X
  [[nodiscard]] PhaseFunction put(const PhaseFunction& f) const { return in_.composed(f, images_); }
  /// 1/h, where the name stands for 1/p, h = c p/n, p primitive.
  PhaseFunction inverse(std::size_t name, const PhaseFunction& h);

private:
  Ring ring_;
  Functions in_;
  Tower tower_;
  std::vector<bool> free_;
  Functions::Values images_;
  std::optional<ConditionSet> given_;
};

/// The names that the Hamiltonian and the brackets, or the field, the gradients and the inverses in
/// them use.
[[nodiscard]] std::vector<bool> used_names(const PhaseSystem& s);
/// Refuses a system in which a function occurs.
void need_no_functions(const PhaseSystem& s);

} // namespace kov::certify
