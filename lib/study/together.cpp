#include "study/together.hpp"

#include "integrability/one_level.hpp"
#include "study/pieces.hpp"

namespace kov {
SystemClassification together(const System& s, const std::vector<Exclusion>& all,
                              const std::stop_token& stop) {
  SystemClassification c = nothing_known(s);
  std::vector<Undecided> pieces{{all_parameters(s, free_levels(s), stop, c)}};
  for (const Exclusion& e : all)
    static_cast<void>(exclude(pieces, e, s, c)); // what is too hard stays open
  for (Undecided& piece : pieces)
    leave_open(std::move(piece), c);
  finish(s, c);
  return c;
}

} // namespace kov
