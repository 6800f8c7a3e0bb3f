#pragma once
// All points of the section over a box of the picture, whatever their sheet: in which boxes of phase space they are, and
// that none of them comes back to itself.
//
// A sheet ends where the level has no real point any more, or where the section is not crossed but touched.  There it has
// no chart by the two drawn coordinates, and boxes over it are decided without one (docs/theory/chaos.md 2.2).

#include "flow/chaos/return_map.hpp"

#include <memory>
#include <optional>

namespace kov::flow {

class SectionPieces {
public:
  using Ball = DoubleBall;
  struct Piece {
    std::vector<Ball> x; ///< a box of phase space: all coordinates
    /// There may be no chart: two points over one place, or the section is touched instead of crossed.
    bool folded = false;
  };
  SectionPieces(const SystemScene& scene, const Chart& chart, const std::atomic<bool>* stop);

  /// Pieces that together hold all points over the box at which the section is crossed as wanted.  None: there is no such
  /// point.  Nothing: not known.
  [[nodiscard]] std::optional<std::vector<Piece>> over(const std::array<Ball, 2>& box);
  /// None of the points of the section in the piece, crossed as wanted, is its own image after so many returns.
  [[nodiscard]] bool moves(const Piece& piece, int turns);

private:
  /// A polynomial in the drawn coordinates, the unknown one, and numbers of the scene.
  struct Polynomial {
    struct Term {
      Ball c;
      std::vector<int> exponents;
    };
    std::vector<Term> terms;
    [[nodiscard]] Ball at(const std::vector<Ball>& x) const;
    [[nodiscard]] Polynomial derivative(std::size_t i) const;
  };
  /// With derivatives by the drawn coordinates.
  struct Coefficient {
    Polynomial f;
    std::array<Polynomial, 2> slope;
    [[nodiscard]] Ball over(const std::vector<Ball>& box, const std::vector<Ball>& middle) const;
  };
  struct Interval {
    double low, high;
  };
  /// Errors  InvalidArgument: it uses something else
  [[nodiscard]] Polynomial polynomial(const MPoly& f) const;
  [[nodiscard]] Coefficient coefficient(const MPoly& f) const;
  void solve(const SystemScene& scene, const Chart& chart);
  [[nodiscard]] std::vector<Ball> equation_over(const std::array<Ball, 2>& box);
  [[nodiscard]] Piece piece(const std::array<Ball, 2>& box, const Ball& unknown) const;
  [[nodiscard]] std::vector<Interval> zeros(const std::array<Ball, 2>& box,
                                            const std::vector<Ball>& equation);
  /// The rate of the section's function, and the value of `where`.
  [[nodiscard]] std::array<Ball, 2> rate_and_side(const Piece& p);
  [[nodiscard]] bool is_crossed(const Piece& p);

  Chart chart_;
  std::size_t dimension_;
  std::vector<std::size_t> inputs_; ///< of polynomials, as variables of the ring
  std::vector<Ball> values_;        ///< of the inputs behind the third
  bool known_ = false;
  // numerator - target * denominator = 0, by powers of the unknown coordinate; the others are polynomials of it.
  std::vector<Coefficient> numerator_, denominator_;
  Ball target_;
  std::size_t unknown_ = 0;
  std::vector<std::pair<std::size_t, Polynomial>> others_;
  /// A map with what it refers to.
  struct Map {
    SectionSurface surface;
    EnclosedMapOf<Ball> map;
    Map(const SystemScene& s, const std::atomic<bool>* stop)
        : surface(SectionSurface::section_alone(s)), map(surface, stop) {}
  };
  std::unique_ptr<Map> plain_;
  /// With sigma/sigma'(0), where the set on which both vanish is invariant: orbits are followed up to there.
  std::unique_ptr<Map> ratio_;
};

} // namespace kov::flow
