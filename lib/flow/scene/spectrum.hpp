#pragma once
// All Lyapunov exponents of an orbit, and how deviations fall together: SALI and GALI.
//
// Deviation vectors v_1, ..., v_k are followed over short times and made orthonormal again, W = Q R [BenettinGalganiGiorgilliStrelcyn1980]:
//
//   exponents  the means of log R_ii over the time, each with the bar of growth.hpp
//              (spectrum_bars_test.cpp); a part is so short that errors of the deviation that grows most do not drown the
//              one that grows least
//   GALI_m     the volume of the first m deviations that were never made orthogonal, each of length 1: with
//              C = R_n ... R_1 it is C_11 ... C_mm/(|C e_1| ... |C e_m|)       [SkokosBountisAntonopoulos2007]
//   SALI       min |v_1 +- v_2| of the first two, of length 1                  [Skokos2001]
//
// Logarithms of GALI and SALI are decimal: on a chaotic orbit they fall like -(l_1 - l_2) t, ..., on a regular one GALI_m
// stays (m up to the dimension of the torus) or falls like a power of t.

#include "flow/scene/section_stage.hpp"

namespace kov::flow {

struct Spectrum {
  struct Exponent {
    double rate = 0, error = 0;
  };
  std::vector<Exponent> exponents; ///< from the largest; empty: not known
  double log_sali = 0;             ///< with two vectors and more
  std::vector<double> log_gali;    ///< of 2, 3, ... vectors
};

/// Follows orbits of a stage with k deviations each.
class SpectrumRun {
public:
  SpectrumRun(const Stage& stage, std::size_t deviations);
  ~SpectrumRun();
  /// The orbit from the i-th start of the stage over a time in which the run without deviations took so many steps.
  /// Empty if it ends before, or when *stop is set.
  [[nodiscard]] Spectrum operator()(std::size_t start, double time, long steps,
                                    const std::atomic<bool>* stop = nullptr);

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace kov::flow
