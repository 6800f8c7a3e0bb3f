#pragma once
// The systems and the facts of a certificate of a theorem, on which its next step is built
// (theorem_certificates.md 1), and how a step names them.

#include "certify/theorem/fact.hpp"

namespace kov::certify {

class Derivation {
public:
  void put_family(const Node& n);
  /// The fact of a step, by its rule (rules.hpp).
  void put_step(const Node& n, bool is_last);
  [[nodiscard]] const TheoremFact& last() const { return *last_; }
  /// Refuses steps that no other names, but for the last one.
  void need_all_used(const std::vector<Node>& steps) const;

  // ---- for rules

  /// The id of the step that is read.
  [[nodiscard]] const std::string& id() const { return id_; }
  /// The counted work of the step.
  [[nodiscard]] Arithmetic& arithmetic() { return arithmetic_; }
  /// The nodes that the proofs of all steps may still have.
  [[nodiscard]] std::size_t& nodes() { return nodes_; }

  /// The family that the step calls `system`.
  [[nodiscard]] const Family& family(Keys& step) const;
  /// Refuses all but Hamiltonian systems with real parameters.
  [[nodiscard]] const Family& plain_family(Keys& step) const;
  /// The family where the parameters `at` are functions of the others, and on the `region`.
  [[nodiscard]] StepPlace place(Keys& step, const Family& x) const;
  /// The same, where both may be missing.
  [[nodiscard]] StepPlace place_if_told(Keys& step, const Family& x) const;
  /// A step before this one, by its id; the fact of this step rests on it.
  const TheoremFact& fact(const Node& id) { return facts_.premise(id.text()); }
  /// A fact from which a rule makes another one: of one region, and not on trust.
  const TheoremFact& proved(const Node& id);

  /// Parts of the cover, its symmetries, and the parts to which one of these leads.
  std::vector<const TheoremFact*> parts, symmetries;
  std::set<const TheoremFact*> led;

private:
  std::vector<std::unique_ptr<Family>> families_;
  Facts facts_;
  const TheoremFact* last_ = nullptr;
  Arithmetic arithmetic_;
  std::size_t nodes_ = max_nodes;
  std::string id_;

  static constexpr std::size_t max_nodes = 200000;
};

inline void need_kind(bool is_right) { need(is_right, "the step says something else"); }
/// An index below this size.
[[nodiscard]] std::size_t read_index(const Node& n, std::size_t size, const char* why);
/// Refuses what is not one.
[[nodiscard]] std::size_t read_coordinate(const PhaseSystem& s, const Node& n);
/// Shows (value, sign) by `by`, both read from k: the computed polynomial is a multiple of the value by a number.
void show_value(Keys& k, const StepPlace& x, const MPoly& computed, Sign sign, SetProof& proof,
                const char* why);
/// A function on the phase space of the family.
[[nodiscard]] PhaseFunction read_function(const Family& y, const Node& n);
/// Levels that have values, functions of the parameters that are left.  n: rows, or nothing
[[nodiscard]] LevelValues read_levels(const StepPlace& here, const std::optional<Node>& n);
/// "at h = ..., l = ..."
[[nodiscard]] std::string shown_levels(const LevelValues& levels);
/// The functions of which a fact about Y speaks, "for some value of ..." a parameter that X has not.
[[nodiscard]] FunctionsThere with_levels(FunctionsThere there, const PhaseSystem& y,
                                         const PhaseSystem& x);

} // namespace kov::certify
