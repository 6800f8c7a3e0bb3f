#pragma once
// Properties that hold for every correct answer, tested on this one.  The enclosures must contain
// what is known; one that does not is a bug of ours, and the answer is withdrawn.

#include "linode/normal_form.hpp"
#include "monodromy/monodromy.hpp"

namespace kov::monodromy {

/// The ordered product against the large circle; Liouville's formula det M = exp(2 pi i res tr A)
/// where tr A has a simple pole or none.
/// Errors   InternalError when one fails
[[nodiscard]] std::vector<std::string> tested_identities(const DifferentialSystem& s,
                                                         const Monodromy& m);

/// At a regular singular place with exponent difference Delta: tr(M)^2 = 4 cos(pi Delta)^2 det M,
/// and tr M = -2 cos(pi Delta) when the equation has no first-order term.
[[nodiscard]] std::vector<std::string> tested_traces(const NormalForm& equation, const Monodromy& m,
                                                     const Budget& budget = {});

} // namespace kov::monodromy
