#pragma once
// What `check` says of the first manifold of a system, by its first variational equation.

#include "study/study.hpp"

namespace kov::test {

inline ManifoldReport checked(study::FileStudy file, const CheckOptions& options = {}) {
  return file.manifold(0, {.check = options}).first;
}
inline ManifoldReport checked(const std::string& text, const CheckOptions& options = {},
                              const ParameterValues& values = {}) {
  return checked(study::FileStudy(parse_document(text, "test.toml"), values), options);
}

} // namespace kov::test
