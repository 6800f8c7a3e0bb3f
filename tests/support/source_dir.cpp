#include "support/source_dir.hpp"

namespace kov::test {

std::string in_source(const std::string& path) { return KOV_SOURCE_DIR + path; }

} // namespace kov::test
