#pragma once
// Searches for proofs over the complex numbers: that no point satisfies all of a list of conditions,
// as a NODE `empty` with one term (docs/theory/theorem_certificates.md 2): a product of what is not 0
// is a combination of what is 0.  A proof not found says nothing.

#include "parameters/refutation.hpp"

namespace kov {

/// Given   const Ring line = make_ring({"t"});
/// Given   const MPoly t = MPoly::variable(line, "t"), squares = t * t + MPoly(line, Integer(1));
/// Given   const std::vector<Condition> at_zero{{squares, Sign::zero}, {t, Sign::zero}};
/// Example ComplexProof(line, {true}).contradiction(at_zero).has_value()  // -> yes
/// Example ComplexProof(line, {true}).contradiction({{squares, Sign::zero}}).has_value()  // -> no
/// Example ComplexProof(line, {false}).contradiction({{squares, Sign::zero}}).has_value()  // -> yes
class ComplexProof {
public:
  /// complex: by variable of the ring, the names that need not be real.
  ComplexProof(Ring ring, std::vector<bool> complex, Budget budget = {})
      : ring_(std::move(ring)), complex_(std::move(complex)), budget_(std::move(budget)) {}

  [[nodiscard]] const Ring& ring() const { return ring_; }
  /// Errors  OutOfBudget
  [[nodiscard]] std::optional<Json> contradiction(const std::vector<Condition>& given) const;
  /// The same for the conditions and the negation of c.
  [[nodiscard]] std::optional<Json> shown(std::vector<Condition> given, const Condition& c) const;

  /// No real point, with case distinctions: where all that is used is real; other conditions say nothing.
  /// Given   const Ring plane = make_ring({"u", "v"});
  /// Given   const MPoly u = MPoly::variable(plane, "u"), v = MPoly::variable(plane, "v");
  /// Given   const std::vector<Condition> origin{{u * u + v * v, Sign::zero}, {v, Sign::nonzero}};
  /// Example ComplexProof(plane, {false, false}).real_contradiction(origin).has_value()  // -> yes
  /// Example ComplexProof(plane, {true, false}).real_contradiction(origin).has_value()  // -> no
  [[nodiscard]] std::optional<Json> real_contradiction(const std::vector<Condition>& given) const;

  /// Polynomials that vanish where the equations do.
  [[nodiscard]] std::vector<MPoly> consequences(const std::vector<Condition>& given) const;

private:
  [[nodiscard]] std::optional<Json> by_products(const std::vector<Condition>& given) const;
  [[nodiscard]] std::optional<Json> by_squares(const std::vector<Condition>& given) const;
  [[nodiscard]] std::optional<Json> by_signs(const std::vector<Condition>& given) const;
  /// 1 > 0 in the place of conditions on what need not be real.
  [[nodiscard]] std::vector<Condition> real_ones(std::vector<Condition> given) const;

  Ring ring_;
  std::vector<bool> complex_;
  Budget budget_;
};

/// A region, with the number of its part and which of the part's regions it is.
struct RegionOfPart {
  std::size_t part = 0;
  std::optional<std::size_t> region;
  std::vector<Condition> conditions;
  std::vector<std::size_t> word =
      {}; ///< symmetries that send the point there (theorem_certificates.md 8)
};

/// A tree whose leaves are regions (theorem_certificates.md 8); nothing if none is found: `gap` says
/// where.   Errors  OutOfBudget
[[nodiscard]] std::optional<Json> tree_of_regions(const ComplexProof& proof,
                                                  const std::vector<Condition>& assumed,
                                                  const std::vector<RegionOfPart>& regions,
                                                  const Budget& budget,
                                                  std::vector<Condition>* gap = nullptr);

} // namespace kov
