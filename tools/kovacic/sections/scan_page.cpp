// A scan as one HTML file.

#include "sections/data_page.hpp"
#include "sections/scan_files.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace kov::cli {
namespace {

std::string base64(const std::string& bytes) {
  static constexpr const char* digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve(bytes.size() * 4 / 3 + 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      out += i + k > bytes.size() ? '=' : digits[three >> (18 - 6 * k) & 63U];
  }
  return out;
}

} // namespace

std::string scan_page(const ScanPlot& plot, const std::vector<double>& values) {
  std::string bytes;
  bytes.reserve(values.size() * sizeof(float));
  for (const double x : values) {
    const auto one = static_cast<float>(x);
    bytes.append(reinterpret_cast<const char*>(&one), sizeof one);
  }
  const auto& x = plot.axes.front();
  const bool flat = plot.axes.size() == 1;
  const auto ends = [](const flow::ScanAxis& a) {
    return nlohmann::json{a.from.as<double>(), a.to.as<double>()};
  };
  const nlohmann::json j{{"title", plot.title},
                         {"caption", plot.caption},
                         {"labels", {x.name, flat ? plot.label : plot.axes[1].name}},
                         {"label", plot.label},
                         {"counts", {x.count, flat ? 1 : plot.axes[1].count}},
                         {"flat", flat},
                         {"x", ends(x)},
                         {"y", flat ? nlohmann::json{0, 1} : ends(plot.axes[1])},
                         {"low", plot.colours.low},
                         {"high", plot.colours.high},
                         {"logarithmic", plot.colours.logarithmic},
                         {"numbers", base64(bytes)}};
  return data_page("scan.html", script_text(j));
}

} // namespace kov::cli
