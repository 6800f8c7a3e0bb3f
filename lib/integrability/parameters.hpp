#pragma once
// From a system with free parameters to the question of lib/strata.

#include "integrability/report.hpp"
#include "literature/trusted.hpp"

namespace kov {

/// r, the assumptions on the parameters, and what must not vanish for r to be what it is.
/// Errors  InvalidArgument: r depends on something that is not a parameter
[[nodiscard]] strata::Question strata_question(const System& s, const AlgebraicOde& ode);

/// The assumptions of the file, as far as they are about variables of this ring.  What is real is
/// what the file says (System::real), and what must be real by that.
/// Given   const System product = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['q'], momenta = ['p'], parameters = ['a', 'b', 'c'], "
///             "hamiltonian = 'p^2/2 + (a + b + c)*q^2'}\n"
///             "assume = {conditions = ['a > 0', 'a*b - c > 0']}", "product.toml"));
/// Example assumptions_on(product, product.ring()).real.size()  // -> 3
[[nodiscard]] Assumptions assumptions_on(const System& s, const Ring& ring);

/// Parameters of the levels only: the vector field does not contain them, and they may be chosen.
/// One that occurs in assumptions and in no manifold or reduction labels no level.
/// Given   const System free = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['q'], momenta = ['p'], parameters = ['a', 'h'], "
///             "hamiltonian = 'p^2/2 + a*q^2'}\n"
///             "manifold = [{name = 'all', equations = [], level = ['H = h']}]", "free.toml"));
/// Example level_parameters(free).size()  // -> 1
[[nodiscard]] std::vector<std::size_t> level_parameters(const System& s);

/// No parameter values satisfy what the file assumes: proved.  Not all contradictions are seen.
/// Given   const System empty = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['q'], momenta = ['p'], parameters = ['a'], "
///             "hamiltonian = 'p^2/2 + a*q^2'}\n"
///             "assume = {a = 'real', conditions = ['a^2 = -1']}", "empty.toml"));
/// Example contradicts_itself(empty)  // -> yes
[[nodiscard]] bool contradicts_itself(const System& s);
/// Errors  InvalidArgument: contradicts_itself
void require_consistent(const System& s);
/// No parameters satisfy the assumptions and these conditions, all of whose variables are real: what that
/// rests on; nothing where a sum of squares or the like proves it, which the judge of certificates accepts.
/// Unset: not proved.
/// Given   const Condition below_zero{MPoly(empty.ring(), Integer(-1)), Sign::positive};
/// Example refuted_over_the_reals(empty, {below_zero}).has_value()  // -> yes
[[nodiscard]] std::optional<std::vector<Trusted>>
refuted_over_the_reals(const System& s, const std::vector<Condition>& conditions);
/// 1 or -1: the sign that p has wherever the file's assumptions hold, by a proof that the judge of
/// certificates accepts (sign_follows); 0: none was found, or not all of p is real.
[[nodiscard]] int sign_that_follows(const System& s, const MPoly& p);
/// The same system, of whose parameters the assumptions say the signs that follow from them: A > B and
/// B > C^2 say that A is positive.  What follows is not an assumption of its own: it has no text.
/// Given   const System ordered = read_system(parse_document("system = {kind = 'hamiltonian', "
///             "coordinates = ['q'], momenta = ['p'], parameters = ['a', 'b'], "
///             "hamiltonian = 'p^2/2 + a*b*q^2'}\n"
///             "assume = {conditions = ['a > b', 'b > a/2']}", "ordered.toml"));
/// Example with_signs_that_follow(ordered).assumptions.size()  // -> 4
[[nodiscard]] System with_signs_that_follow(System s);
/// The polynomials in the parameters that may vanish under the assumptions of the file.
[[nodiscard]] std::vector<MPoly> not_excluded(const System& s, const std::vector<MPoly>& generic);
/// For some parameters that the file admits all coefficients of d may be 0.
[[nodiscard]] bool may_vanish_identically(const System& s, const MPoly& d);

/// Some stratum has a non-abelian identity component.
[[nodiscard]] bool somewhere_not_abelian(const strata::StrataAnswer& answer);

/// The limits for the strata of this equation, in the names of the system.
[[nodiscard]] strata::StrataLimits strata_limits(const System& s, const AlgebraicOde& ode,
                                                 const CheckOptions& options);

} // namespace kov
