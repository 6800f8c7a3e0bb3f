#pragma once
// The rules of kovacic-theorem/1, each with a file and a section of theorem_certificates.md.  What a rule
// says becomes a fact by Derivation::put_step alone.

#include "certify/theorem/derivation.hpp"

#include <array>

namespace kov::certify {

namespace rule {

// Each reads all data of a step and refuses what does not follow.   Errors  Refused, InvalidArgument
Said certificate(Keys& step, Derivation& d);   // 5: of one system
Said leaf(Keys& step, Derivation& d);          // 5
Said literature(Keys& step, Derivation& d);    // 9
Said integrals(Keys& step, Derivation& d);     // 5
Said splitting(Keys& step, Derivation& d);     // 6: of separatrices
Said place(Keys& step, Derivation& d);         // 4, 12
Said symmetry(Keys& step, Derivation& d);      // 4
Said lowest_order(Keys& step, Derivation& d);  // 7
Said scale(Keys& step, Derivation& d);         // 18: in all units
Said integrable(Keys& step, Derivation& d);    // 13
Said darboux(Keys& step, Derivation& d);       // 16
Said common_values(Keys& step, Derivation& d); // 17: of two exponent differences
Said trusted(Keys& step, Derivation& d);       // 14
Said open(Keys& step, Derivation& d);          // 15
Said cover(Keys& step, Derivation& d);         // 8

} // namespace rule

/// Names for the inverses of Y that X has not.
[[nodiscard]] std::vector<std::string> inverse_names(const Ring& x, const PhaseSystem& y);

struct TheoremRule {
  std::string_view name; ///< in a file
  Said (*said)(Keys& step, Derivation& d);
};

inline constexpr std::array rules{TheoremRule{"certificate", rule::certificate},
                                  TheoremRule{"leaf", rule::leaf},
                                  TheoremRule{"literature", rule::literature},
                                  TheoremRule{"integrals", rule::integrals},
                                  TheoremRule{"splitting", rule::splitting},
                                  TheoremRule{"place", rule::place},
                                  TheoremRule{"symmetry", rule::symmetry},
                                  TheoremRule{"lowest-order", rule::lowest_order},
                                  TheoremRule{"scale", rule::scale},
                                  TheoremRule{"integrable", rule::integrable},
                                  TheoremRule{"darboux", rule::darboux},
                                  TheoremRule{"common-values", rule::common_values},
                                  TheoremRule{"trusted", rule::trusted},
                                  TheoremRule{"open", rule::open},
                                  TheoremRule{"cover", rule::cover}};

} // namespace kov::certify
