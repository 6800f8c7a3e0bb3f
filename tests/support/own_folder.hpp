#pragma once
// Files of a test: tests run beside each other, so that no two processes may share a name.

#include <string>

namespace kov::test {

/// A folder of this process alone, removed when it ends; ends with "/".
[[nodiscard]] const std::string& own_folder();

} // namespace kov::test
