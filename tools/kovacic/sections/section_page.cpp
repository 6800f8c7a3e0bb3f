#include "sections/section_page.hpp"

#include "sections/data_page.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace kov::cli {
namespace {

std::string number(double x) { return std::isfinite(x) ? fmt::format("{:.6g}", x) : "null"; }

std::string orbit(const SectionPage::Orbit& o) {
  std::string points;
  std::size_t right = 0;
  for (std::size_t i = 0; i < o.points.size(); ++i) {
    const auto& [x, y] = o.points[i];
    if (!std::isfinite(x) || !std::isfinite(y)) continue;
    points += fmt::format("{}{:.6g},{:.6g}", points.empty() ? "" : ",", x, y);
    right += i < o.right ? 1 : 0;
  }
  return fmt::format("{{\"text\":{},\"value\":{},\"right\":{},\"points\":[{}]}}",
                     script_text(o.text), number(o.value), right, points);
}

} // namespace

std::string section_page(const SectionPage& page) {
  std::string caption, orbits;
  for (const std::string& line : page.caption)
    caption += (caption.empty() ? "" : ",") + script_text(line);
  for (const SectionPage::Orbit& o : page.orbits)
    orbits += (orbits.empty() ? "\n" : ",\n") + orbit(o);
  return data_page(
      "section.html",
      fmt::format("{{\"title\":{},\"caption\":[{}],\"labels\":[{},{}],\"colour_label\":{},"
                  "\"logarithmic\":{},\"orbits\":[{}]}}",
                  script_text(page.title), caption, script_text(page.labels[0]),
                  script_text(page.labels[1]), script_text(page.colour_label), page.logarithmic,
                  orbits));
}

} // namespace kov::cli
