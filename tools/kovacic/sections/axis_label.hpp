#pragma once
// A formula beside the axis of a picture.

#include <string>

namespace kov::cli {

/// For gnuplot's enhanced text: names in italics, Greek letters, indices and powers.
/// Example: axis_label("px") is "{/:Italic p_{x}}", axis_label("theta1") is "{/:Italic θ}_{1}"
[[nodiscard]] std::string axis_label(const std::string& formula);

} // namespace kov::cli
