#pragma once
// Where the repository lies: one object file knows the path, so that checkouts share their builds.

#include <string>

namespace kov::test {

/// in_source("/cases/classics/airy.toml") is the path of that file in this checkout.
[[nodiscard]] std::string in_source(const std::string& path);

} // namespace kov::test
