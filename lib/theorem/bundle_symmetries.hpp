#pragma once
// The symmetries of a family with real parameters, as steps of a certificate and words of its cover
// (docs/theory/theorem_certificates.md 4, 8).

#include "certify/text/json.hpp"
#include "moves/discrete.hpp"
#include "theorem/strata.hpp"

namespace kov {

/// Signed permutations of variables and parameters that carry the family into itself.
class BundleSymmetries {
public:
  /// None where the family is of another kind.   file: of the system
  BundleSymmetries(const StrataFamily& family, std::string file, std::string name,
                   const Budget& budget);

  [[nodiscard]] std::size_t size() const { return all_.size(); }
  void clear() { all_.clear(); }
  /// The conditions on p to be sent into the region; in the ring of the family.
  [[nodiscard]] std::vector<Condition> before(std::size_t s,
                                              const std::vector<Condition>& region) const;
  /// Its number among those that the certificate has: it becomes one of them.  Unset: it cannot.
  [[nodiscard]] std::optional<std::size_t> use(std::size_t s);
  [[nodiscard]] const std::vector<Json::Object>& steps() const { return steps_; }

private:
  [[nodiscard]] Json::Object step(std::size_t s) const;

  const StrataFamily& family_;
  std::string file_, name_;
  Budget budget_;
  std::vector<FamilySymmetry> all_;
  std::vector<Substitution> parameters_; ///< in the ring of the family
  std::map<std::size_t, std::optional<std::size_t>> used_;
  std::vector<Json::Object> steps_;
};

} // namespace kov
