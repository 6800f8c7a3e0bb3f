#pragma once
// The surface on which the section map of a system file lives: { section = 0, level_i = value_i } in the n
// coordinates, n - 2 equations.  Its charts are two of the coordinates; the others are solved for.
//
// Proofs about the map need: no function symbols (they are not enclosed), levels of proved first
// integrals, as many that a surface is left, and one direction of crossing.

#include "flow/chaos/not_proved.hpp"
#include "flow/number/double_ball.hpp"
#include "flow/number/dual.hpp"
#include "flow/scene/system_scene.hpp"

#include <array>
#include <vector>

namespace kov::flow {

/// A point of phase space with derivatives with respect to two chart coordinates.
template <class R> using PhasePoint = std::vector<Dual<R>>;

/// The scene's formulas as programs.
class SectionSurface {
public:
  /// Errors  InputError: the scene has no section map of the kind above
  explicit SectionSurface(const SystemScene& scene);
  /// For orbits from boxes of phase space (EnclosedMapOf::landing_from), not from a surface: the section alone, with the
  /// second derivative of its function.
  [[nodiscard]] static SectionSurface section_alone(const SystemScene& scene);

  [[nodiscard]] std::size_t dimension() const noexcept { return dimension_; }
  [[nodiscard]] std::size_t equations() const noexcept { return targets_.size(); }
  [[nodiscard]] bool rising() const noexcept { return rising_; }
  /// The functions that are drawn follow the field among the outputs of `at_point`.
  [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }
  /// The map keeps an area, where the bracket has rank four: canonical, or H and Casimirs.
  [[nodiscard]] const std::vector<MFraction>& bracket() const noexcept { return bracket_; }

private:
  template <class R> friend class SurfaceCode;
  using Equation = std::pair<MFraction, Quantity>; ///< function, value
  SectionSurface(const SystemScene& s, const std::vector<Equation>& equations, bool bends);
  [[nodiscard]] static std::vector<Equation> equations_of(const SystemScene& s);
  std::size_t dimension_;
  bool rising_, bends_;
  std::size_t drawn_; ///< how many functions say what is drawn
  std::vector<std::string> names_;
  std::vector<Quantity> targets_;  ///< values of the equations' functions: 0, levels
  std::vector<Quantity> values_;   ///< of parameters without a rational value
  std::vector<MFraction> bracket_; ///< upper triangle of J; empty: no area is known to be kept
  std::size_t inputs_ = 0;         ///< coordinates and values
  Program field_, at_point_;
  std::uint32_t field_registers_ = 0, point_registers_ = 0;
};

/// The values of the formulas at a point.
template <class R> struct SurfaceValues {
  std::vector<Dual<R>> equations;          ///< section, then levels, minus their values
  std::vector<std::vector<Dual<R>>> slope; ///< their gradients
  std::vector<Dual<R>> field;              ///< X
  std::array<Dual<R>, 2> drawn;            ///< not in double balls
  Dual<R> side;                            ///< of `where`; 1 without
  std::optional<Dual<R>> bend;             ///< X(X(section's function)); of a section alone
  std::vector<Dual<R>> bracket;            ///< upper triangle by rows
};

/// The programs with numbers of type R, and storage for series up to an order.
template <class R> class SurfaceCode {
public:
  using T = Dual<R>;
  SurfaceCode(const SectionSurface& s, int order);

  [[nodiscard]] SurfaceValues<R> at(const PhasePoint<R>& x);
  /// Taylor coefficients 0 .. order of the orbit through x.
  void expand(const PhasePoint<R>& x, int order);
  [[nodiscard]] const T& coefficient(std::size_t variable, int k) const {
    return series_[variable * stride_ + static_cast<std::size_t>(k)];
  }
  /// The Taylor polynomial at time t.
  [[nodiscard]] PhasePoint<R> polynomial(const R& t, int order) const;

private:
  void run(const std::vector<Instruction>& code, const std::vector<T>& numbers,
           const std::vector<SumTerm>& terms, std::vector<T>& registers, int k) const;
  const SectionSurface& s_;
  std::size_t stride_;
  std::vector<Instruction> field_once_, field_each_;
  std::vector<SumTerm> field_terms_;
  std::vector<T> field_numbers_, point_numbers_, targets_, series_, point_;
};

extern template class SurfaceCode<double>;
extern template class SurfaceCode<Enclosure>;
extern template class SurfaceCode<DoubleBall>;

/// a x = b by elimination with pivots; in balls x is enclosed (or not finite).
template <class R> std::vector<R> solved(std::vector<std::vector<R>> a, std::vector<R> b);
extern template std::vector<double> solved(std::vector<std::vector<double>>, std::vector<double>);
extern template std::vector<Enclosure> solved(std::vector<std::vector<Enclosure>>,
                                              std::vector<Enclosure>);
extern template std::vector<DoubleBall> solved(std::vector<std::vector<DoubleBall>>,
                                               std::vector<DoubleBall>);

/// Two coordinates of phase space that are coordinates on the surface near a point.
struct Chart {
  std::array<std::size_t, 2> free{};
  std::vector<std::size_t> rest; ///< the others, n - 2
};
/// The rest is chosen by elimination with full pivots: as well determined as it can be.
[[nodiscard]] Chart chart_at(SurfaceCode<double>& code, const std::vector<double>& x);

} // namespace kov::flow
