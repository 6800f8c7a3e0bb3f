#pragma once
// The verdict on one stratum with what proves it.  docs/theory/strata.md, 5 to 8

#include "strata/evidence.hpp"

#include <memory>

namespace kov::strata {

struct Leaf {
  Truth abelian = Truth::unknown;         ///< of the identity component
  std::optional<GaloisGroup> group{};     ///< where it is the same on the whole stratum
  GroupBound bound = GroupBound::unknown; ///< where it is not
  Conclusion by = Conclusion::none;
  std::shared_ptr<const Scheme> scheme{}; ///< the places; unset for numbers and other equations
  std::vector<Evidence> because{};
  std::optional<OpenReason> open{}; ///< set exactly where `abelian` is unknown
  /// Disjoint; they cover the stratum.  Empty: the leaf is one part.  Where they agree, so does the
  /// leaf; who knows nothing of parts may use the leaf alone.
  std::vector<Part> parts{};
  kovacic::Trace trace{}; ///< if asked for: the first case, as it is done by hand

  // In evidence.cpp, as for Evidence.
  Leaf();
  Leaf(const Leaf&);
  Leaf(Leaf&&) noexcept;
  Leaf& operator=(const Leaf&);
  Leaf& operator=(Leaf&&) noexcept;
  ~Leaf();

  /// Undecided because r does not mean anything here.
  [[nodiscard]] bool no_equation() const {
    return open && std::holds_alternative<NoEquation>(*open);
  }
};

/// The first piece of evidence of this kind, or null.
/// Given   const Leaf airy = std::get<Leaf>(decide_leaf(z + a, 0, everywhere));
/// Example evidence<strata::NoExponential>(airy)->bound.odd_order  // -> yes
template <class E> [[nodiscard]] const E* evidence(const Leaf& leaf) {
  for (const Evidence& e : leaf.because)
    if (const auto* found = std::get_if<E>(&e)) return found;
  return nullptr;
}

[[nodiscard]] inline Leaf open_leaf(OpenReason open) {
  Leaf leaf;
  leaf.open = std::move(open);
  return leaf;
}

/// Some singular place is irregular on the stratum.
[[nodiscard]] bool has_irregular_place(const Leaf& leaf);

} // namespace kov::strata
