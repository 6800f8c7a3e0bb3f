#pragma once
// Emptiness over the complex numbers by case distinctions along factors of equations, as NODEs of
// docs/theory/theorem_certificates.md 2.  A proof not found says nothing.

#include "parameters/complex_proof.hpp"

namespace kov {

/// Given   const Ring plane = make_ring({"s", "t"});
/// Given   const MPoly s = MPoly::variable(plane, "s"), t = MPoly::variable(plane, "t");
/// Given   const std::vector<Condition> axes{{s * t, Sign::zero}, {s - t, Sign::zero}, {s, Sign::nonzero}};
/// Example CaseProof(ComplexProof(plane, {true, true})).refutation(axes).has_value()  // -> yes
/// Example CaseProof(ComplexProof(plane, {true, true})).refutation({{s * t, Sign::zero}}).has_value()  // -> no
class CaseProof {
public:
  explicit CaseProof(ComplexProof proof) : proof_(std::move(proof)) {}

  /// No point satisfies the conditions.   Errors  OutOfBudget
  [[nodiscard]] std::optional<Json> refutation(const std::vector<Condition>& given) const {
    return by_cases(given, most_depth);
  }
  /// f is nowhere 0, or everywhere: a node for the conditions and the negation.
  [[nodiscard]] std::optional<Json> shown(std::vector<Condition> given, const MPoly& f,
                                          Sign sign) const;

private:
  using Conditions = std::vector<Condition>;
  struct Equation { ///< one of the conditions, or a consequence of them
    MPoly f;
    std::optional<std::size_t> condition;
    std::vector<MPoly>
        unknown; ///< irreducible factors of which it is not known that they are not 0
  };

  [[nodiscard]] std::optional<Json> by_cases(const Conditions& given, int depth) const;
  [[nodiscard]] std::optional<Json> along(const Equation& e, Conditions given, int depth) const;
  [[nodiscard]] std::optional<Json> factors_of(const Equation& e, std::size_t next,
                                               Conditions given, int depth) const;
  /// All factors of condition i are known not to be 0.
  [[nodiscard]] static Json product(const Conditions& given, std::size_t i);
  [[nodiscard]] std::optional<Equation> best(const Conditions& given) const;

  static constexpr int most_depth = 12;
  ComplexProof proof_;
};

} // namespace kov
