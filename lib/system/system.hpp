#pragma once
// A system file ([system], claims, manifolds, reduction, expectations) as exact values.
//
// Formulas are evaluated with the fixed parameter values ([set] in the file, --set on the command
// line) put in at the leaves, so that nothing is computed with a parameter whose value is known.
// docs/guide/system-files.md describes the format.

#include "proof/condition/condition.hpp"
#include "symbol/document.hpp"
#include "system/domain.hpp"
#include "system/formula.hpp"
#include "system/vector_field.hpp"

#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace kov {

enum class SystemKind : std::uint8_t {
  hamiltonian,
  vector_field,
  euler_poisson,
  lagrangian,
  poisson,
  newton ///< while it is read: then a vector field of positions and velocities
};

/// A statement of the file about the system, to be proved or refuted (claims.hpp).
struct SystemClaim {
  enum class Kind : std::uint8_t { integral, casimir, darboux, poisson, equal };
  Kind kind = Kind::integral;
  std::string name;
  MFraction value;          ///< the function; poisson: the bracket claimed; equal: left - right
  MFraction first, second;  ///< poisson: the two functions
  std::string other;        ///< equal: "euler-lagrange", or the other system file
  std::vector<Equation> on; ///< the level on which it is claimed
  bool holds = true;        ///< the file may also claim that it fails
  std::string text;         ///< the formula as written
  std::string source;
  long line = 0;
};

/// [[manifold]]: equations of a set that is to be proved invariant, and levels of integrals on it.
struct ManifoldSpec {
  std::string name;
  std::vector<Equation> equations;
  std::vector<Equation> levels; ///< first integral = value
  std::vector<MPoly> nonzero;   ///< components on which one of these vanishes are left out
  long line = 0;
};

/// z = phi(x), or nothing: then it is proposed.
struct ReduceSpec {
  std::string manifold;            ///< empty: applies to all
  std::string variable_name = "z"; ///< the new independent variable
  std::optional<MFraction> change; ///< phi
  std::string change_text;
  std::vector<std::string> normal;    ///< order of the normal variables, if given
  std::optional<std::size_t> unknown; ///< the coordinate whose variation the scalar equation is for
  std::string energy;                 ///< "auto", or empty
  std::string energy_parameter = "h";
  long line = 0;
};

using certify::Sign;
/// The numbers among which a value lies.
enum class Sort : std::uint8_t { real, rational, integer };

/// One condition on the parameters, as written and as what it says of `value`.
struct Assumption {
  using Says = std::variant<Sign, Sort>;
  Says says = Sign::nonzero;
  MFraction value;
  std::string text = {};
  long line = 0;

  [[nodiscard]] bool is(const Says& s) const { return says == s; }
  /// It says that the value is positive, or not negative.
  [[nodiscard]] bool is_ordered() const;
  /// The value is not 0.
  [[nodiscard]] bool is_nonzero() const { return is(Sign::nonzero) || is(Sign::positive); }
  /// It holds where the value is v; and where it is any real number near v.
  [[nodiscard]] bool holds_at(const Rational& v) const;
  [[nodiscard]] bool holds_near(const Rational& v) const;
};

/// [[expect]]: what a test of this file requires.
struct SystemExpectation {
  std::vector<std::pair<std::string, std::string>> where; ///< parameter values, as text
  std::string manifold;
  std::string verdict;            ///< "non-integrable", "no-obstruction", "undecided", or empty
  std::string group;              ///< as in the JSON, with the index: "SL2", "D_3", or empty
  std::string identity_component; ///< or empty
  std::string abelian;            ///< "yes", "no", or empty
  std::optional<long> kovacic_case;
  std::optional<MFraction> p, q, r;
  std::string source;
  long line = 0;
};

/// All that a system file says.
struct System {
  std::string file, title;
  std::vector<std::string> cite;
  SystemKind kind = SystemKind::vector_field;
  VectorField field;
  std::map<std::string, MFraction> named;  ///< H, definitions, integrals: usable in formulas
  std::map<std::string, MFraction> values; ///< fixed parameters
  std::vector<SystemClaim> claims;
  std::vector<ManifoldSpec> manifolds;
  std::vector<ReduceSpec> reductions;
  std::vector<Assumption> assumptions;
  /// Parameters that the file's own words make real: what stands in an inequality, and what is said
  /// to be real, rational or an integer.  Recorded when the file is read; rewritten assumptions add
  /// nothing.
  std::set<std::string> real;
  /// The parameters for which the formulas of [system] and [assume] mean something.
  ParameterDomain domain;
  std::vector<SystemExpectation> expectations;
  std::map<std::size_t, long> weights; ///< [expansion] weights, by variable
  long expansion_terms = 2;
  std::optional<MFraction> lagrangian;    ///< L(Omega, Gamma); kind lagrangian
  std::vector<std::size_t> velocities;    ///< Omega as variables of the ring
  std::vector<MFraction> velocity_values; ///< Omega(M, Gamma)
  std::vector<MFraction> gyrostat;        ///< B, for the systems on e(3)
  std::vector<std::string> adjoined;      ///< constants that the file does not have, in words
  /// Roots of numbers and of parameters as the file writes them, by the names of their constants: root1 is sqrt(2).
  std::map<std::string, std::string> roots;
  std::size_t z = 0; ///< the variable that stands for the new independent one

  [[nodiscard]] const Ring& ring() const noexcept { return field.ring; }
};

/// The entry of the file about the way to r(z) along this manifold; null: there is none.
[[nodiscard]] const ReduceSpec* reduction_for(const System& s, const std::string& manifold);

/// p != 0 from now on, if that is not assumed already and says something.
void assume_nonzero(const MPoly& p, long line, System& s);

/// Assumptions on this parameter are not used from now on.
void forget_assumptions(std::size_t parameter, System& s);

/// The name of the file, the same on every machine, with the values of the parameters.
[[nodiscard]] inline std::string title_of(const System& s) {
  std::string text = s.file.substr(s.file.rfind('/') + 1);
  for (const auto& [name, value] : s.values)
    text += ", " + name + " = " + to_string(value);
  return text;
}

/// Parameter values from the command line or from an [[expect]] block: name, text of the value.
using ParameterValues = std::vector<std::pair<std::string, std::string>>;

/// Errors  InputError with the place in the file; a setting for an unknown parameter; a violated
///         assumption; a structure matrix that is not Poisson; a relation that is not invariant
/// Given   const System oscillator = read_system(parse_document(
///             "system = {kind = 'hamiltonian', coordinates = ['q'], momenta = ['p'], "
///             "parameters = ['a'], hamiltonian = 'p^2/2 + a*q^2/2'}", "oscillator.toml"));
/// Example oscillator.field.components  // -> {p, -q*a}
/// Example read_system(parse_document("system = {kind = 'newtonian'}", "n.toml")).kind
///         // -> throws InputError
[[nodiscard]] System read_system(const Entry& document, const ParameterValues& settings = {});
/// The same from a file.
[[nodiscard]] System read_system(const std::string& path, const ParameterValues& settings = {});

/// A formula in the names of the system (variables, fixed values, definitions, integrals).
/// Errors  InputError
/// Example formula(oscillator, "2*H - p^2")  // -> q^2*a
[[nodiscard]] MFraction formula(const System& s, const std::string& text);

/// "A <= B" as B - A and the sign of it; the sides are parts of the text.
struct Comparison {
  Sign sign = Sign::zero;
  std::string_view left, right; ///< left - right is meant
};
/// Unset: no sign stands in it.
/// Example comparison("a < 2").value().sign == Sign::positive  // -> yes
/// Example comparison("a is real").has_value()  // -> no
[[nodiscard]] std::optional<Comparison> comparison(std::string_view text);
/// A comparison of two formulas.   Errors  InputError
/// Example condition(oscillator, "p^2 < 2*H").value  // -> q^2*a
[[nodiscard]] Assumption condition(const System& s, const std::string& text);

/// True if the document has a [system] table (and is not a scalar equation).
[[nodiscard]] bool is_system_document(const Entry& document);

} // namespace kov
