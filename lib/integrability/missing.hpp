#pragma once
// The gaps and reservations of a study along a curve: values; sentence() puts them into words.

#include <cstdint>
#include <string>

namespace kov {

/// A gap or a reservation: of a block, of a level, or of the whole.
struct Missing {
  enum class What : std::uint8_t {
    limit,                       ///< of: which, as the budget says it
    undefined,                   ///< of: what has no value, or does not exist
    program_error,               ///< of: which
    no_change,                   ///< of: what was tried; nothing leads to an equation over K(z)
    no_change_on_all_components, ///< the same; more: the product that vanishes on the curve
    parameters_in_r,             ///< of: their names
    only_where,                  ///< of: a polynomial that is not 0; more: what is decided there
    relations_fall_apart,        ///< of the functions, for some parameters
    large_block,                 ///< of: its order
    not_on_the_leaf,             ///< what it says is not seen on the symplectic leaves
    refused_way,                 ///< of: what our own checker has against the way to r(z)
    elsewhere,                   ///< of: what a study at this level ended with
    other_blocks,                ///< at this level
    no_curve                     ///< of: why, at these values of the parameters
  };
  What what = What::limit;
  std::string of = {}, more = {};

  /// Nothing was concluded after it.
  [[nodiscard]] bool ends_all() const {
    return what == What::limit || what == What::undefined || what == What::no_curve;
  }
};
[[nodiscard]] std::string sentence(const Missing& m);

/// Why there is no accepted certificate of the way from the system to r(z).
struct NoWay {
  enum class Why : std::uint8_t {
    refused,   ///< by our own checker: what the block said is withdrawn
    too_large, ///< for it
    no_rule,
    failed ///< a limit, or an error of the program
  };
  Why why = Why::failed;
  std::string of = {};
};
/// Example sentence(NoWay{NoWay::Why::refused, "S1"})  // -> the checker refuses it, S1
[[nodiscard]] std::string sentence(const NoWay& n);

/// A part of the variational equations that the blocks leave out.
struct LeftOut {
  enum class What : std::uint8_t {
    coupling,   ///< of: a clause
    parameters, ///< of: a polynomial that vanishes for them
    component,  ///< of the phase curve; of: a function that vanishes there
    components, ///< whether there are such was not found out; of: why
  };
  What what = What::coupling;
  std::string of = {};
};
/// As a clause.
[[nodiscard]] std::string sentence(const LeftOut& l);

} // namespace kov
