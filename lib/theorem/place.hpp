#pragma once
// The place of the system of a step among those of the theorem.
//
// A theorem is about one vector field X(p) with parameters p.  A step computes with a field Y(q) of
// a file of its own.  The step is about X(p) for the p of its place if there are
//
//   q = q(p)          parameters of Y as functions of p,
//   y = S(p) x        an affine change of variables, det S != 0,
//   tau(p) != 0       a change of time,
//
// with S X(p)(x) = tau Y(q(p))(S x) for all x: an identity of rational functions, which is
// expanded.  Substitution of parameters, scaling, the choice of units and a change of axes are of
// this form.  docs/theory/composition.md

#include "literature/trusted.hpp"
#include "parameters/conditions.hpp"
#include "splitting/checked.hpp"
#include "system/system.hpp"
#include "theorem/roots.hpp"

namespace kov {

/// The place of a step, as a theorem file says it.
struct Place {
  std::string of;                      ///< id of a lowest-order step; empty: the theorem's system
  ParameterValues at;                  ///< parameters of X that are functions of the others there
  std::vector<std::string> conditions; ///< on the parameters of X, besides
  ParameterValues roots;               ///< names, and what each is a square root of
  ParameterValues as;                  ///< parameters and variables of Y, by those of X
  std::string time;                    ///< tau, or empty: 1
};

/// The map of a place, as it was checked.  Parameters in `at` do not occur.
struct PlaceMap {
  Ring ring;                                    ///< the names of X, and the roots
  Roots roots;                                  ///< r^2 = f, in this ring
  std::map<std::string, MFraction> values;      ///< coordinates and parameters of Y, by name
  std::vector<std::vector<MFraction>> jacobian; ///< S
  std::optional<MFraction> bracket;             ///< c, unless both brackets are 0
  MFraction time;                               ///< tau
};

struct Located {
  std::string objection;        ///< why the step is not about the system; empty: it is
  Assumptions region;           ///< where it is
  CheckedIdentities checks;     ///< what was verified
  std::vector<Trusted> trusted; ///< decisions of Z3
  std::optional<PlaceMap> map;  ///< if it is about the system
};

/// f, which may use the names of another ring, with its variables replaced by values in `ring`.
[[nodiscard]] MFraction composed(const MFraction& f, const std::map<std::size_t, MFraction>& values,
                                 const Ring& ring);

/// The parameters that a place describes, and nothing else; by the names of the system's ring.
/// Errors  InputError: a formula that cannot be read
[[nodiscard]] Assumptions region_of(const System& whole, const Place& place);
/// The conditions of `if` alone, in the ring of the system.
[[nodiscard]] std::vector<Condition> conditions_of(const System& whole, const Place& place);

/// Checks that `single` is `base` in other words.
/// Requires that `whole` is the theorem's system and `base` has parameters of the same names; both
///          without values for `at`.
/// Errors  InputError: a formula that cannot be read
[[nodiscard]] Located locate(const std::string& whole, const std::string& base,
                             const System& single, const Place& place);

} // namespace kov
