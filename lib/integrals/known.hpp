#pragma once
// The first integrals that are known on a set of parameter values, which of them are in involution, and the commuting
// fields; what decides integrability from them.
//
// Source  docs/theory/integrals.md (3)

#include "integrals/darboux.hpp"
#include "integrals/find.hpp"
#include "integrals/independence.hpp"

namespace kov {

struct KnownIntegrals {
  const PhaseSpace* space;
  Set where;
  IndependentRows gradients{*space};
  std::vector<FoundIntegral> found = {};
  std::vector<std::size_t> commuting = {}; ///< indices of integrals in involution
  std::vector<MFraction> dependent = {};   ///< some that depend on those found
  std::vector<DarbouxPolynomial> darboux = {};
  std::vector<std::vector<MFraction>> fields = {}; ///< beside that of the system
  std::size_t combined = 0; ///< how many were found and chosen when functions of them were tried

  [[nodiscard]] KnownIntegrals on(const Set& part) const;
  [[nodiscard]] std::size_t casimirs() const;
  [[nodiscard]] std::size_t found_and_chosen() const { return found.size() + commuting.size(); }

  /// By the formulas of lib/system: f is an integral; y commutes with the field, and integrals are constant along it.
  /// Throws InternalError.
  void verify(const FoundIntegral& f) const;
  void verify(const std::vector<MFraction>& y) const;
  /// Adds an independent integral, and chooses it where it commutes with those chosen before; or a field that
  /// commutes with the others, if it is independent of them and of that of the system.  The result, if any: a
  /// condition by which the parameters must be divided first.
  std::optional<MPoly> add(const FoundIntegral& f, const Budget& budget);
  std::optional<MPoly> add(const std::vector<MFraction>& y, const Budget& budget);

  /// Liouville's theorem for those that are chosen; requires a bracket.
  [[nodiscard]] bool is_liouville(const Budget& budget) const;
  /// The same after a choice in the order of discovery, if it is not smaller.
  [[nodiscard]] bool is_liouville_in_order(const Budget& budget);
  /// Liouville's theorem, or without a bracket Bogoyavlensky's.
  [[nodiscard]] bool is_integrable(const Budget& budget) const;
  [[nodiscard]] bool has_all_casimirs(const Budget& budget) const;

  [[nodiscard]] bool commutes(const FoundIntegral& f, const FoundIntegral& g) const;
  /// [y, z] = 0
  [[nodiscard]] bool commute(const std::vector<MFraction>& y,
                             const std::vector<MFraction>& z) const;
  /// The chosen integrals, those of `more` that commute with them and one another, and the others that are known:
  /// others of `more`, and sums, come when these are chosen.
  [[nodiscard]] std::vector<FoundIntegral>
  commuting_first(const std::vector<FoundIntegral>& more) const;

  /// The fields of the chosen integrals, without those of Casimirs and of the Hamiltonian.
  [[nodiscard]] std::vector<std::vector<MFraction>> fields_of_chosen() const;
  /// An ansatz of degree 1 and 2 in the known integrals, but for functions of those in involution.
  [[nodiscard]] Ansatz quadratic() const;
  /// Products of known integrals inside the ansatz, and 1 where it is not a constant term there.
  [[nodiscard]] std::vector<SparseRow> products(const Ansatz& ansatz, long degree) const;
};

// ---- fields without a bracket: docs/theory/integrals.md (5), (6)

/// The first equation, by its factors, if it may hold somewhere on the set and not everywhere; then
/// where the cofactor may have no value, or the polynomial be 0.
[[nodiscard]] std::vector<MPoly> special_conditions(const KnownIntegrals& s,
                                                    const DarbouxPolynomial& f);
/// For all parameters of the set, at none of which it is 0.
[[nodiscard]] bool is_darboux(const KnownIntegrals& s, const PolynomialField& x,
                              const DarbouxPolynomial& f);
/// The parts of the set with the kernel there: all of them, or none at a limit.
[[nodiscard]] std::vector<std::pair<KnownIntegrals, EchelonForm>>
kernel_parts(const KnownIntegrals& s, const EchelonForm& e, const Budget& budget);
/// Without logarithms where a product of powers says the same.
[[nodiscard]] std::vector<FoundIntegral> logarithmic_integrals(const KnownIntegrals& s,
                                                               const LogarithmicAnsatz& ansatz,
                                                               const EchelonForm& kernel);

/// Numerators over a product of Darboux polynomials, of which 0 is none, then each, and the last all of them.
struct FieldAnsatz {
  FieldAnsatz(const KnownIntegrals& s, long degree, std::size_t denominator);

  std::vector<MPoly> numerators;
  MFraction below, cofactor;

  [[nodiscard]] std::vector<std::vector<MFraction>> fields(const KnownIntegrals& s,
                                                           const EchelonForm& kernel) const;
};

} // namespace kov
