#pragma once
// The starting points of a scene: the solutions of its equations.
//
//   section = 0,  levels,  `start` = 0,  and the two functions that are drawn = the wanted values,
//
// as many as coordinates.  An equation that is linear in one coordinate alone gives that coordinate; if then one
// equation in one coordinate is left that is polynomial in it, all its real roots are taken (all sheets of the level);
// otherwise Newton's method looks for solutions from many guesses.  Every solution is refined in the arithmetic of
// the run, and taken if the section is crossed in the wanted direction there.

#include "flow/scene/system_scene.hpp"

#include <atomic>

namespace kov::flow {

struct FieldStart {
  std::vector<double> x;                  ///< the coordinates
  std::array<double, 2> drawn{};          ///< where it is in the picture
  std::optional<std::size_t> seed, state; ///< its number there
  bool given = false;                     ///< x is what it is, and solves no equations
};

/// The functions that the starts of a scene evaluate.
[[nodiscard]] Field field_of_starts(const SystemScene& s);

/// Stop    when *stop is set, what was found so far
/// Errors  InputError: not as many equations as coordinates, a seed that is not on the level, no start at all
[[nodiscard]] std::vector<FieldStart> starts_of(const SystemScene& scene, const Field& field,
                                                std::size_t* skipped,
                                                const std::atomic<bool>* stop = nullptr);

/// The states over one place of the picture after the other.
class Places {
public:
  Places(const SystemScene& scene, const Field& field);
  ~Places();
  [[nodiscard]] std::vector<std::vector<double>> over(const std::array<double, 2>& drawn);
  /// Other values of the field's numbers.
  void set(const std::vector<double>& numbers);

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// All variables (and the tangent vector, if the field has one) at a start, to the last digit of R.
template <class R> class StartRefiner {
public:
  StartRefiner(const SystemScene& scene, const Field& field);
  ~StartRefiner();
  [[nodiscard]] std::vector<R> operator()(const FieldStart& start);
  /// Other values of the field's numbers.
  void set(const std::vector<R>& numbers);

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The error of each function symbol s: |s - f(argument)|, e.g. |s - sin(q)|, in the arithmetic of
/// the run.
template <class R> class MeaningCheck {
public:
  MeaningCheck(const SystemScene& scene, const Field& field);
  ~MeaningCheck();
  [[nodiscard]] std::size_t size() const noexcept { return places_.size(); }
  /// The place of the i-th symbol among the variables.
  [[nodiscard]] std::size_t place(std::size_t i) const { return places_[i]; }
  [[nodiscard]] double deviation(std::size_t i, const R* x);

private:
  struct One;
  std::vector<std::size_t> places_;
  std::vector<One> all_;
};

} // namespace kov::flow
