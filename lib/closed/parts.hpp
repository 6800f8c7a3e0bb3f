#pragma once
// The parts of a stratum, while they are told apart by one arithmetic statement after the other.
// docs/theory/strata.md, 10

#include "closed/possible.hpp"
#include "closed/statement.hpp"

namespace kov::strata {

/// The bound of the group where it is not the same on the whole stratum, or not known.
enum class GroupBound : std::uint8_t {
  unknown,
  SL2_or_Borel,
  torus_normaliser,          ///< inside the normaliser of a torus
  torus_normaliser_or_T,     ///< or in T_n
  finite_or_normaliser_or_T, ///< or finite
  triangular_or_cyclic,      ///< T_n, or cyclic
  finite                     ///< finite
};

/// The points of a stratum that satisfy arithmetic conditions, with their own answer.
struct Part {
  std::vector<Statement> where;
  Truth abelian = Truth::unknown;
  std::optional<GaloisGroup> group{}; ///< n unset: not the same on the whole part
  GroupBound bound = GroupBound::unknown;
};
/// "n is an integer, m is rational"; "": everywhere.
[[nodiscard]] std::string in_words(const Part& part);

/// yes, no: at every point of the region where `before` holds.
/// Given   const Assertion in_z = SumIn{{a * a}, {{0, 1}}};
/// Example holds_on(AllRational{{a * a}}, {{in_z}}, everywhere)  // -> Truth::yes
[[nodiscard]] Truth holds_on(const Assertion& s, const std::vector<Statement>& before,
                             const ParametrisedSet& region);

/// A statement that the region and the statements before it decide is not a condition, and a side that
/// has no points is not visited.
///
/// Given   Parts parts(everywhere);
/// Example parts.known(AllRational{{a * a}})  // -> Truth::unknown
class Parts {
public:
  explicit Parts(const ParametrisedSet& region) : region_(region) {}

  /// Calls yes() where s holds, then no() where it does not.
  template <class Yes, class No> void split(const Assertion& s, Yes yes, No no) {
    const Truth known = this->known(s);
    for (const bool holds : {true, false}) {
      if (known == truth(!holds)) continue;
      if (known == Truth::unknown) path_.push_back({s, holds});
      holds ? yes() : no();
      if (known == Truth::unknown) path_.pop_back();
    }
  }
  /// yes, no: at every point of the part that is looked at.
  [[nodiscard]] Truth known(const Assertion& s) const { return holds_on(s, path_, region_); }

  /// The rational number x >= 0 with this square, if it is one for all parameters.
  [[nodiscard]] static std::optional<Rational> root(const MFraction& square) {
    return constant_root(square);
  }
  [[nodiscard]] static bool varies(const MFraction& square) { return !is_number(square); }

  // The reason is the path.
  void add(GroupType type, std::optional<Integer> n = {}, const char* reason = "");
  void add(Truth abelian, GroupBound bound, const char* /*reason*/ = "") {
    parts_.push_back({path_, abelian, {}, bound});
  }

  [[nodiscard]] std::vector<Part> take() { return std::move(parts_); }

private:
  const ParametrisedSet& region_;
  std::vector<Statement> path_;
  std::vector<Part> parts_;
};

} // namespace kov::strata
