// kovacic check on a system file: the mechanics pipeline.

#include "case_file.hpp"

namespace kov::cli {

CaseReport check_system(const Settings&, const Entry& document) {
  throw InputError(document.file(), 0, 0, 1, "system files are not connected yet",
                   "equation files are: see kovacic new ode");
}

} // namespace kov::cli
