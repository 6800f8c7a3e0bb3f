#pragma once
// How much of the state is left where it matters: angles that may be kept within a turn, and close encounters.

#include "flow/scene/system_scene.hpp"

#include <optional>

namespace kov::flow {

/// Coordinates that nothing but sin, cos, ... of them and an angle of the picture depend on: whole turns may be dropped.
/// As places among the coordinates.
[[nodiscard]] std::vector<std::uint32_t> turning_angles(const SystemScene& s,
                                                        const std::vector<SceneFormula>& watched);

/// A turn as a sum of three numbers, of which the first two have few digits.
template <class R> [[nodiscard]] std::array<R, 3> turn_in_parts();

/// The noise of a polynomial by rounding of the state, in units of a unit roundoff: the size of its
/// terms; of a sum of squares of differences, which are known as exactly as the state with its low
/// parts, hardly more than the sum. low: what rounding leaves of the low parts, in the same units.
class PolynomialNoise {
public:
  PolynomialNoise(const Field& f, const VectorField& v, const MPoly& p);
  [[nodiscard]] double operator()(const double* x, double low);
  void set(const double* numbers);

private:
  struct Part {
    TermSize number;
    Evaluator<double> form;
    TermSize form_size;
    bool is_difference;
  };
  std::vector<Part> squares_;
  std::vector<TermSize> whole_; ///< one, if it is not a sum of squares
};

/// Has a state digits enough for an encounter?  It has not where rounding makes more than 2^-10 of what the field
/// divides by or of the argument of a root, or of an integral as large as it was at the start: not of its terms alone, but
/// also by what it does to a root or a denominator of which the integral is a function (1/r changes by |d/dr 1/r| of the
/// rounding of r).
///
/// Without an energy the same is asked of the motion: a relative error e of the forces in an encounter is one of
/// e (v/v_usual)^2 outside, because energies, which are sums of v^2 and of potentials, are of that size there; v is the
/// largest of the coordinates that grow in the encounter.
class Resolution {
public:
  Resolution(const Field& f, const SystemScene& s, const std::vector<SceneFormula>& integrals);
  struct State {
    const double *start, *x, *usual; ///< usual: sizes in the longest step
    std::uint64_t& grown; ///< which coordinates have grown far above that; 0 at the start
  };
  /// Are there places where the field ends, that orbits may come near to?
  [[nodiscard]] bool has_encounters() const noexcept { return !parts_.empty(); }
  /// low: as in PolynomialNoise
  [[nodiscard]] bool operator()(const State& s, double roundoff, double low);
  /// Other values of the field's numbers.
  void set(const double* numbers);

private:
  struct Part { ///< a denominator of the field, or the argument of a function
    Evaluator<double> value;
    PolynomialNoise noise;
    std::optional<std::size_t> root; ///< the place of the square root of it
  };
  struct Integral {
    TermSize size;
    Evaluator<double> slopes; ///< by the roots
    std::vector<Part> denominator;
  };
  [[nodiscard]] static double relative(Part& part, const double* x, double low);
  [[nodiscard]] double faster(const State& s) const;
  std::vector<Part> parts_;
  std::vector<Integral> integrals_;
  std::vector<std::size_t> roots_; ///< the parts with a root
  std::size_t coordinates_ = 0;
  bool has_energy_ = false;
};

} // namespace kov::flow
