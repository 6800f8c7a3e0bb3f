#pragma once
// A section as one HTML file: pan, zoom, and click an orbit.  No network, no library.

#include <array>
#include <string>
#include <vector>

namespace kov::cli {

struct SectionPage {
  struct Orbit {
    std::string text; ///< what is said of it when it is clicked
    double value = 0; ///< its colour
    std::size_t right =
        0; ///< so many first points are not statistical; the others are drawn lighter
    std::vector<std::array<double, 2>> points;
  };
  std::string title;
  std::vector<std::string> caption;
  std::array<std::string, 2> labels;
  std::string colour_label; ///< empty: neighbours in the list have different colours
  bool logarithmic = false; ///< the colour, from 1 to 40
  std::vector<Orbit> orbits;
};

/// The page; what texts say is text, never markup or a script.
[[nodiscard]] std::string section_page(const SectionPage& page);

} // namespace kov::cli
