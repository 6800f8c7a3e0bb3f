#pragma once
// One leaf of a certificate over strata: the places, the exponents and the theorem of the leaf in
// the words of the format.  The lemmas are searched for here, proofs that polynomials do
// not vanish.  docs/theory/strata_certificates.md, 6 and 7

#include "strata/known_facts.hpp"
#include "strata/proof_tree.hpp"

#include <stdexcept>

namespace kov::strata {

/// The reason why a verdict cannot be written down.
enum class Gap : std::uint8_t {
  rule,       ///< the theorem has no rule in the format
  places,     ///< lemma: places stay apart, orders and degrees stay
  irrational, ///< lemma: an exponent difference is irrational
  bound,      ///< lemma: a bound of an exponent difference
  difference, ///< lemma: an exponent difference has not a value
  degree,     ///< an open exponent difference of degree > 1
  invariant,  ///< lemma: a symmetric power has no solution, or the solution is not 0
  logarithm,  ///< lemma: a logarithm, or no rule for it
  number,     ///< the equation without parameters has no certificate
  relation,   ///< a rule for an equation between parameters that is not solved for one
  division,   ///< lemma: the polynomial that an equation is solved by division by is not 0
  assumption, ///< the condition that an equation follows from
  emptiness   ///< the stratum is empty by Z3
};
/// Example to_string(Gap::emptiness)  // -> no exact proof that the stratum is empty
[[nodiscard]] const char* to_string(Gap gap);
/// The subject that a rule of the format would have: "the family of Bessel".
[[nodiscard]] std::string rule_name(Conclusion theorem);

/// The verdict of the solver is not a case of the certificate's rules, or rests on Z3.
class NoProof : public std::runtime_error {
public:
  NoProof(Gap what, const std::string& why) : std::runtime_error(why), gap(what) {}
  Gap gap;
};

/// The leaf node on the stratum `region`, known to the checker as `facts`, where the equation is
/// y'' = r y; the lemmas that it needs are appended.  Requires leaf.abelian = yes or no.
/// Throws  NoProof, OutOfBudget
[[nodiscard]] certify::LeafNode leaf_certificate(const Leaf& leaf, const MFraction& r,
                                                 const ParametrisedSet& region, KnownFacts& facts,
                                                 std::vector<Lemma>& lemmas, const Budget& budget);

/// The same for an open leaf whose parts are decided by a closed criterion; unset for others.
[[nodiscard]] std::optional<certify::LeafNode>
criterion_certificate(const Leaf& leaf, const MFraction& r, const ParametrisedSet& region,
                      KnownFacts& facts, std::vector<Lemma>& lemmas, const Budget& budget);

/// The certificate of an equation without parameters.
[[nodiscard]] certify::Certificate number_certificate(const Decision& d);

} // namespace kov::strata
