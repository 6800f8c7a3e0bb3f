#pragma once
// What the functions on systems are asked about.

#include "symbol/document.hpp"

#include <string>

namespace kov::python {

/// A file, or the text of one.
struct Source {
  std::string text; ///< empty: `name` is a path
  std::string name;

  [[nodiscard]] Entry document() const {
    return text.empty() ? read_document(name) : parse_document(text, name);
  }
};

} // namespace kov::python
