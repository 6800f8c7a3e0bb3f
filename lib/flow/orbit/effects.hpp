#pragma once
// The effects that a scene asks for.  The Taylor recurrences (jets.hpp) are compiled once for every
// set of effects in `effect_sets`, so that an effect that a scene does not name costs no
// instruction.
//
//   gravity        the weight m g acts                        O(p) operations per step of order p
//   sliding        the tip slides on the smooth plane;        9 products of series (O(p^2)), minus 2
//                  otherwise the tip is a fixed point         when L lies on an axis
//   gyrostat       constant gyrostatic moment B               O(p)
//   full_inertia   the body axes are not principal axes       3 more products of series
//   axial          L lies on the first body axis (the caller may turn the labels of the axes
//                  cyclically, see Model): no linear combinations, and d(Gamma_1)/dt is known from
//                  the height of the centre of mass
//
// L matters only if gravity or sliding is there.

#include <array>
#include <cstddef>

namespace kov::flow {

struct Effects {
  bool gravity = false;
  bool sliding = false;
  bool gyrostat = false;
  bool full_inertia = false;
  bool axial = false;
  [[nodiscard]] constexpr bool lever() const { return gravity || sliding; }
  friend constexpr bool operator==(const Effects&, const Effects&) = default;
};

/// A kernel for `have` computes the right thing for a scene that asks for `want`: effects that the scene does
/// not name become multiplications by zero.  (Not so the tip: sliding or fixed is another motion.)
[[nodiscard]] constexpr bool covers(const Effects& have, const Effects& want) {
  return have.gravity >= want.gravity && (have.sliding == want.sliding || !want.lever()) &&
         have.gyrostat >= want.gyrostat && have.full_inertia >= want.full_inertia &&
         (!have.axial || want.axial || !want.lever());
}

namespace detail {
constexpr bool is_canonical(const Effects& e) {
  return !e.axial || (e.lever() && !e.full_inertia); // axial is a simplification of the lever L
}
constexpr Effects effects_from_bits(unsigned b) {
  return {(b & 1) != 0, (b & 2) != 0, (b & 4) != 0, (b & 8) != 0, (b & 16) != 0};
}
constexpr std::size_t canonical_count() {
  std::size_t n = 0;
  for (unsigned b = 0; b < 32; ++b)
    n += is_canonical(effects_from_bits(b)) ? 1 : 0;
  return n;
}
} // namespace detail

/// The sets that are compiled: 22.
inline constexpr auto effect_sets = [] {
  std::array<Effects, detail::canonical_count()> sets{};
  std::size_t n = 0;
  for (unsigned b = 0; b < 32; ++b)
    if (detail::is_canonical(detail::effects_from_bits(b)))
      sets[n++] = detail::effects_from_bits(b);
  return sets;
}();

/// The set in `effect_sets` that is exactly `want`; `want` must be canonical.
[[nodiscard]] constexpr std::size_t effect_index(const Effects& want) {
  for (std::size_t i = 0; i < effect_sets.size(); ++i)
    if (effect_sets[i] == want) return i;
  return effect_sets.size();
}

/// For arithmetic so slow to compile that 22 kernels would be too many: the first that covers is taken.
inline constexpr std::array<Effects, 6> coarse_sets{{{true, false, false, false, true},
                                                     {true, false, false, false, false},
                                                     {true, false, true, true, false},
                                                     {true, true, false, false, true},
                                                     {true, true, false, false, false},
                                                     {true, true, true, true, false}}};

[[nodiscard]] constexpr std::size_t coarse_index(const Effects& want) {
  for (std::size_t i = 0; i < coarse_sets.size(); ++i)
    if (covers(coarse_sets[i], want)) return i;
  return coarse_sets.size();
}

} // namespace kov::flow
