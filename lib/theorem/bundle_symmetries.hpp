#pragma once
// The symmetries of a family with real parameters, as steps of a certificate and words of its cover
// (docs/theory/theorem_certificates.md 4, 8).

#include "moves/discrete.hpp"
#include "proof/text/json.hpp"
#include "theorem/bundle_place.hpp"

namespace kov {

/// The members of the step; here: the place at which it is one.
/// Errors  DomainError: what is not shown; OutOfBudget
[[nodiscard]] Json::Object symmetry_members(const BundleFamily& family, const PartPlace& here,
                                            const PlaceMap& map, const Budget& budget);

/// Signed permutations of variables and parameters that carry the family into itself, and rotations that do
/// so at some of its parameters.
class BundleSymmetries {
public:
  /// None where the family is of another kind.
  BundleSymmetries(const BundleFamily& family, const Budget& budget);

  void clear() {
    all_.clear();
    is_plain_ = false;
  }
  /// Looks for rotations where one of the equations of the region holds; in the ring of the family.
  void look_for_rotations(const std::vector<Condition>& region);

  /// A product of symmetries, the last one first, and the conditions on a point to be sent into the region.
  struct Word {
    std::vector<std::size_t> letters;
    std::vector<Condition> conditions;
  };
  /// Words of one letter, and of a rotation and another one.
  [[nodiscard]] std::vector<Word> before(const std::vector<Condition>& region) const;
  /// The same word in the numbers of those that the certificate has: its letters become some of them.  Unset:
  /// one cannot.
  [[nodiscard]] std::optional<std::vector<std::size_t>>
  use(const std::vector<std::size_t>& letters);
  [[nodiscard]] const std::vector<Json::Object>& steps() const { return steps_; }

private:
  /// p -> values(p) where `conditions` hold.
  struct One {
    Substitution at;
    PlaceMap map;
    Substitution values;               ///< in a ring that begins with the names of the family
    std::optional<MPoly> square;       ///< of the root, the last name of that ring
    std::vector<Condition> conditions; ///< in the ring of the family
  };
  [[nodiscard]] std::vector<Condition> before(const One& one,
                                              const std::vector<Condition>& region) const;
  void add(const Equivalence& e, const Substitution& at);
  [[nodiscard]] std::optional<std::size_t> use(std::size_t s);

  const BundleFamily& family_;
  Budget budget_;
  bool is_plain_; ///< else there are none
  std::vector<One> all_;
  std::vector<Substitution> tried_; ///< for rotations
  std::map<std::size_t, std::optional<std::size_t>> used_;
  std::vector<Json::Object> steps_;
};

} // namespace kov
