#pragma once
// First integrals of a system, at all values of its parameters.
//
// Hamiltonian systems: polynomials in the momenta.  Poisson systems: polynomials in all variables,
// modulo Casimirs, which are found first.  Vector fields: polynomials, then powers and logarithms of
// Darboux polynomials, and commuting fields.
//
// Every integral is expanded again by lie_derivative (lib/system), which shares nothing with the
// linear algebra that found it.  Nothing that the file claims is used.
//
// Source  docs/theory/integrals.md

#include "integrals/ansatz.hpp"

namespace kov {

struct IntegralOptions {
  long degree = 2; ///< in the momenta; in all variables for systems without momenta
  /// The largest degree of the coefficients in the coordinates.  Unset: where the Hamiltonian is
  /// p^T G p/2 + V(q) with a constant G and polynomial V, what is needed for a complete answer;
  /// else the same as `degree`.
  std::optional<long> coefficients = {};
  unsigned long power = 1; ///< of the denominator of a system without momenta
  /// For the question "integrable?": on each set the search ends as soon as Liouville's theorem
  /// applies (without a bracket: one integral less than variables is known), what is cheap comes
  /// first, and only integrals in involution with those chosen so far are looked for.
  bool until_integrable = false;
  Budget budget = {};
  std::size_t max_sets = 200; ///< of parameter values
  /// For polynomial fields without a bracket also Darboux polynomials, the integrals that are made
  /// of them, and, for the question "integrable?", commuting fields.
  bool darboux = true;
};

/// c log f, c in the parameters.
struct LogarithmicTerm {
  MFraction times;
  MPoly of;
};

struct FoundIntegral {
  MFraction value; ///< without the logarithms
  long degree = 0;
  bool casimir = false;
  bool hamiltonian = false;                     ///< H itself, and not found
  std::vector<LogarithmicTerm> logarithms = {}; ///< their sum is to be added to the value
};
/// Given   const Ring ring = make_ring({"x", "y"});
/// Given   const MPoly x = MPoly::variable(ring, "x"), y = MPoly::variable(ring, "y");
/// Given   const FoundIntegral sir{.value = x + y, .logarithms = {{-MFraction(y), x}}};
/// Example to_string(sir)  // -> x + y - y*log(x)
[[nodiscard]] std::string to_string(const FoundIntegral& f);
/// A number times f, primitive and with a positive first coefficient; x^2 = g is put in for functions x with such a
/// relation where that is shorter: (p*cos^2 - p)/sin^2 is p.
[[nodiscard]] MFraction shortest_form(const VectorField& v, const MFraction& f);
/// A rational function for each coordinate.
[[nodiscard]] std::vector<MFraction> gradient(const VectorField& v, const FoundIntegral& f);

/// "y*d/dx - x*d/dy".
[[nodiscard]] std::string field_text(const VectorField& v, const std::vector<MFraction>& field);

/// The integrals known at the parameter values with these equations and inequations.
struct IntegralsOfSet {
  std::string searched; ///< the class of functions, in words
  std::vector<MPoly> equations, inequations;
  /// Functionally independent at each parameter value of the set (integrals.md, Lemma 1).
  std::vector<FoundIntegral> integrals;
  std::vector<std::size_t> commuting; ///< indices of integrals in involution, Casimirs among them
  bool liouville = false; ///< as many of them in involution as Liouville's theorem wants
  /// Without a bracket: fields that commute with that of the system and with one another, independent
  /// together with it, all integrals being constant along them.
  std::vector<std::vector<MFraction>> fields = {};
  /// There are function symbols: independence is proved for symbols that satisfy no relations but
  /// those declared, and nothing is complete.
  bool only_declared_relations = false;
  /// Every integral of the class depends on those listed.
  bool complete = false;
  /// The same for all coefficients that are smooth functions of the coordinates.
  bool complete_for_smooth = false;
  std::string open; ///< why the search ended early, or empty

  /// The number of integrals beside the Hamiltonian and the Casimirs.
  [[nodiscard]] std::size_t found() const;
  /// Liouville's theorem, or without a bracket Bogoyavlensky's, applies.
  [[nodiscard]] bool integrable(const VectorField& v) const;
};

struct IntegralSearch {
  std::string searched;             ///< the class, in words
  std::vector<IntegralsOfSet> sets; ///< disjoint
  /// All parameter values that are in none of the sets: nothing was found there beside the
  /// Hamiltonian and the Casimirs.  Without conditions of its own; only where no set is open.
  std::optional<IntegralsOfSet> elsewhere;
  std::vector<MPoly> not_covered;       ///< nothing is said where one of these vanishes
  std::vector<MPoly> assumed;           ///< those of the file that were used, each != 0
  std::vector<MPoly> assumed_equations; ///< of the file, each = 0; the sets lie where they hold
  [[nodiscard]] bool finished() const;
};

/// Errors  InvalidArgument: contradictory assumptions.  A budget that is spent is not an error.
/// Given   const System oscillator = read_system(parse_document(
///             "system = {kind = 'hamiltonian', coordinates = ['x', 'y'], momenta = ['u', 'v'], "
///             "parameters = ['a'], hamiltonian = '(u^2 + v^2 + x^2 + a*y^2)/2'}", "o.toml"));
/// Given   const IntegralSearch found = find_integrals(oscillator, {.degree = 1});
/// Example to_string(found.sets.at(0).equations.at(0))  // -> a
/// Example to_string(found.sets.at(0).integrals.at(1).value)  // -> v
[[nodiscard]] IntegralSearch find_integrals(const System& s, const IntegralOptions& options = {});

/// The class that find_integrals looks at for most parameters, in words: what is absent from it
/// need not be absent from that of a special system.
/// Given   const System line = read_system(parse_document(
///             "system = {kind = 'hamiltonian', coordinates = ['x'], momenta = ['u'], "
///             "hamiltonian = 'u^2/2 + x^3'}", "l.toml"));
/// Example searched_class(line)  // -> polynomials of degree <= 2 in the momenta
[[nodiscard]] std::string searched_class(const System& s, const IntegralOptions& options = {});
/// A theorem bounds the coefficients for most parameters, and the search uses it: larger ones say nothing more.
[[nodiscard]] bool is_bounded_by_a_theorem(const System& s, const IntegralOptions& options = {});

} // namespace kov
