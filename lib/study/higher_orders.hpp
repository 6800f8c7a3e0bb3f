#pragma once
// The variational equations of higher order along one manifold of a file: along an invariant plane
// (lib/jets), or by quadratures.

#include "study/exclusion.hpp"

namespace kov::study {

struct HigherOrders {
  int up_to = 0;             ///< the order that was looked at
  jets::HigherOrders planes; ///< along an invariant plane; what ended them, in `open`
  /// Not integrable where this says; unset: nothing is excluded that the file admits.
  std::optional<Exclusion> excluded;
  std::vector<std::string> exceptions; ///< "A - B = 0", "B = 0": where nothing follows
};
/// "except where A - B = 0; or B = 0"; empty: everywhere something follows.  Possibly: a limit left them.
[[nodiscard]] std::string exceptions(const HigherOrders& h, bool possibly = false);

/// Errors  those of jets::higher_orders; a limit is named in planes.open
[[nodiscard]] HigherOrders higher_orders(const System& s, const ManifoldSpec& m, int order,
                                         const Options& options);

} // namespace kov::study
