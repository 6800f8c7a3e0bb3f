#pragma once
// One transport of facts: a system X(p) is a system Y(q) in other coordinates, at the points p of a stratum
// of X (calculus.md 4; theorem_certificates.md 4, 12).  What a map is not known to carry over is refused.

#include "certify/theorem/family.hpp"
#include "literature/integral_class.hpp"
#include "proof/text/refused.hpp"

namespace kov::certify {

/// Parameters of Y that X has not, as functions of the parameters of X that are left.
using LevelValues = std::map<std::string, PhaseFunction>;

/// Y in the coordinates of X, checked.
class Map {
public:
  /// By the data of a place or a symmetry.  Requires that X and Y stay alive.
  Map(const StepPlace& x, const Target& y, Keys& data, Arithmetic& a, std::size_t& nodes_left);
  /// The names of Y are those of X, or levels: these have the values that are given, or some.
  Map(const StepPlace& x, const Target& y, const LevelValues& levels, const Node& shown,
      Arithmetic& a, std::size_t& nodes_left);

  [[nodiscard]] bool moves_origin() const { return moves_origin_; }
  /// The class, of the system in other coordinates, as it is named there; refuses what is not known of it.
  [[nodiscard]] const IntegralClass& carried(const IntegralClass& c) const;
  /// phi of a parameter of Y.
  [[nodiscard]] PhaseFunction parameter(std::size_t i) const { return *values_[i]; }
  /// Conditions on the parameters of Y as conditions on those of X, in its ring, that suffice for each choice
  /// of the roots.
  [[nodiscard]] Conditions before(const Conditions& all) const;
  /// "y = ..." of this name of Y; empty: it is the same.  arrow: between them
  [[nodiscard]] std::string moved(std::size_t i, const char* arrow) const;
  /// "where r^2 = ...", unless nothing is adjoined.
  [[nodiscard]] std::string adjoined() const;
  /// "its names: y = ..., A = ...", what stands for the names of Y, unless they are the same; "where
  /// r^2 = ...", unless nothing is adjoined.
  [[nodiscard]] std::vector<std::string> shown() const;

private:
  using Row = std::vector<PhaseFunction>; ///< by coordinate of X

  [[nodiscard]] bool has_same_coordinates() const;
  /// phi of each coordinate that is not among these contains none of these; X and Y call them alike.
  [[nodiscard]] bool keeps_others(const std::vector<std::string>& names) const;
  /// phi(f) is f or -f, in coordinates of the same names; refuses otherwise.
  void need_level(const std::string& f) const;
  void adjoin(const Node& n);
  void read_values(const Node& n);
  void read_names(const LevelValues& levels);
  [[nodiscard]] std::size_t of_x(std::size_t j) const; ///< the name of X for one of Y
  void need_rows();
  [[nodiscard]] Row linear_part(const PhaseFunction& f);
  void need_inverse(const Node& back) const;
  [[nodiscard]] PhaseFunction unit(const Node& pair) const;
  void need_same(const PhaseFunction& bracket, const PhaseFunction& energy) const;
  void need_same_functions() const;
  [[nodiscard]] bool has_function_of_y(const MPoly& f) const;
  [[nodiscard]] bool holds(const MPoly& f) const; ///< Is it 0 along the curve?
  void need_shown(const Node& n);
  [[nodiscard]] bool is_plain(const AskedCondition& c);
  void show(const AskedCondition& c, const Node& n);
  void show_group(const AskedCondition& c, const Node& n);
  void show_by_name(const AskedCondition& c, const Node& n);
  using Parts = std::map<Exponents, MPoly>;
  /// f by the monomials in the levels without a value, in the names of X.
  [[nodiscard]] Parts by_levels(const MPoly& f) const;
  /// over and value of f: f over^2 = value
  void need_value(const PhaseFunction& f, const MPoly& over, const MPoly& value) const;

  [[nodiscard]] PhaseFunction element(const Node& n) const; ///< in adjoined names so far
  void need_constant(const PhaseFunction& f) const;
  void need_equal(const PhaseFunction& f, const PhaseFunction& g, const char* why) const {
    need(here_.tower().clears(in().minus(f, g)), why);
  }
  [[nodiscard]] PhaseFunction phi(const PhaseFunction& f) const {
    return in().composed(f, values_);
  }
  [[nodiscard]] PhaseFunction phi(const MPoly& f) const { return phi({f, Integer(1)}); }
  [[nodiscard]] const Functions& in() const { return here_.in(); }

  const StepPlace stratum_;
  const PhaseSystem& x_;
  const Target y_;
  Arithmetic& a_;
  std::size_t& nodes_;
  const bool by_name_;
  Here here_;                          ///< names of X, then the adjoined ones, or the inverses of Y
  std::vector<bool> constant_, known_; ///< by variable of the ring
  Functions::Values values_;
  std::vector<Row> rows_;
  std::set<std::size_t> bounded_; ///< levels in an interval
  bool moves_origin_ = false;
};

inline constexpr const char* rigid_level = "M1*Gamma1 + M2*Gamma2 + M3*Gamma3";

} // namespace kov::certify
