#pragma once
// A system X(p) and the system Y that it is in other coordinates: theorem_certificates.md 4.

#include "certify/system/phase_space.hpp"
#include "certify/theorem/legendre.hpp"
#include "certify/theorem/tower.hpp"
#include "proof/condition/show.hpp"

#include <map>
#include <memory>
#include <set>

namespace kov::certify {

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
  /// Refuses a polynomial with coordinates or inverses.
  void need_parameters(const MPoly& f) const;
  [[nodiscard]] Conditions region(const Node& n) const;
};

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

/// Values of parameters of X that are functions of the others.
using ParameterFunctions = std::map<std::size_t, PhaseFunction>;

class Map {
public:
  /// Checks all of it.  Requires that X and Y stay alive.
  Map(const Family& x, const ParameterFunctions& at, const Conditions& region, const Target& y,
      Keys& data, Arithmetic& a, std::size_t& nodes_left);

  [[nodiscard]] bool has_roots() const { return tower_->has_roots(); }
  [[nodiscard]] bool moves_origin() const { return moves_origin_; }
  /// phi of each coordinate that is not among these contains none of these; X and Y call them alike.
  [[nodiscard]] bool keeps_others(const std::vector<std::string>& names) const;
  /// phi(f) is f or -f, in coordinates of the same names; refuses otherwise.
  void need_level(const std::string& f) const;
  /// phi of a parameter of Y.
  [[nodiscard]] PhaseFunction parameter(std::size_t i) const { return *values_[i]; }
  /// Conditions on the parameters of Y as conditions on those of X, in its ring, that suffice for each choice
  /// of the roots.
  [[nodiscard]] Conditions before(const Conditions& all) const;
  /// "y = ..." of this name of Y; empty: it is the same.  arrow: between them
  [[nodiscard]] std::string moved(std::size_t i, const char* arrow) const;
  /// "where r^2 = ...", unless nothing is adjoined.
  [[nodiscard]] std::string adjoined() const;
  /// phi of a polynomial in the names of Y, in the ring of the map.
  [[nodiscard]] PhaseFunction phi(const MPoly& f) const;
  /// "its names: y = ..., A = ...", what stands for the names of Y, unless they are the same; "where
  /// r^2 = ...", unless nothing is adjoined.
  [[nodiscard]] std::vector<std::string> shown() const;

private:
  using Row = std::vector<PhaseFunction>;
  using Square = std::vector<Row>;

  [[nodiscard]] bool has_same_coordinates() const;
  void read_names(const Node& adjoined);
  void start(const ParameterFunctions& at);
  void adjoin(const Node& n);
  void read_values(const Node& n);
  void need_change(const Node& back);
  [[nodiscard]] Row linear_part(const PhaseFunction& f);
  [[nodiscard]] PhaseFunction unit(const Node& pair) const;
  void need_same(const PhaseFunction& bracket, const PhaseFunction& energy) const;
  void need_shown(const Node& n);
  void need_group(const AskedCondition& c, const Node& n);
  /// over and value of f: f over^2 = value
  void need_value(const PhaseFunction& f, const MPoly& over, const MPoly& value) const;

  [[nodiscard]] PhaseFunction element(const Node& n) const; ///< in adjoined names so far
  void need_constant(const PhaseFunction& f) const;
  [[nodiscard]] PhaseFunction moved(const PhaseFunction& f) const; ///< of X, with `at` put in
  [[nodiscard]] PhaseFunction put_in(const PhaseFunction& f) const;
  [[nodiscard]] const Functions& in() const { return *functions_; }

  const Family& x_;
  const Target y_;
  Arithmetic& a_;
  std::size_t& nodes_;
  Ring ring_; ///< names of X, then the adjoined ones
  std::unique_ptr<Functions> functions_;
  std::unique_ptr<Tower> tower_;
  std::vector<bool> constant_, known_, free_; ///< by variable of the ring
  std::vector<std::optional<PhaseFunction>> put_, values_;
  std::optional<ConditionSet> given_;
  Square s_;
  bool moves_origin_ = false;
};

/// The names that the Hamiltonian and the brackets, or the field, the gradients and the inverses in
/// them use.
[[nodiscard]] std::vector<bool> used_names(const PhaseSystem& s);
/// Refuses a system in which a function occurs.
void need_no_functions(const PhaseSystem& s);

} // namespace kov::certify
