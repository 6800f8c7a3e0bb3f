#pragma once
// Pictures by gnuplot: a script that the user can edit, and what it draws if gnuplot is there.

#include <array>
#include <compare>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace kov::cli {

struct FixedPointMark {
  std::string kind; ///< as in the column "kind"
  bool proved = false;
  auto operator<=>(const FixedPointMark&) const = default;
};

/// A section: two columns of BASE.dat.
struct PlanePlot {
  std::string title;
  std::vector<std::string> caption; ///< lines; long ones are broken
  std::array<std::string, 2> labels, columns;
  std::array<bool, 2> angle{}; ///< in [-pi, pi)
  bool turned = false;         ///< the first one is in [0, 2 pi), and is drawn from -pi/4 on
  bool plain = false;          ///< one colour for all orbits
  std::string form;            ///< two colours by the sign of this form, in the column "sign"
  std::optional<std::array<std::array<double, 2>, 2>> range;
  std::string colour,
      colour_label;         ///< a column for the colour of the points, or empty: one for each orbit
  bool logarithmic = false; ///< the colour
  std::size_t points = 0;   ///< how many: many points are drawn smaller
  bool errors = false;      ///< a column "error": points that are only statistical are lighter
  std::set<FixedPointMark> marks = {}; ///< those that occur in BASE.fixed.dat
  bool manifolds = false;              ///< and a homoclinic orbit, in BASE.homoclinic.dat
};

/// Writes BASE.gp for BASE.dat and draws BASE.png, ...; returns the pictures drawn (none without
/// gnuplot).
std::vector<std::string> draw_plane(const std::string& base, const PlanePlot& plot,
                                    const std::vector<std::string>& formats);

/// Curves in a (doubly logarithmic) chart, one for each value of a text column.
struct ChartPlot {
  std::string title, data; ///< data: a file beside the script, with a line of column names
  std::string x, x_label, y, y_label; ///< columns
  std::string series_column;
  std::vector<std::string> series;
  std::string series_name = {}; ///< before each of them in the legend: "l = "
  bool falling = false;  ///< x falls from left to right (errors: accuracy grows to the right)
  bool linear_x = false; ///< only the other axis is logarithmic, and points are not joined
};

/// Writes BASE.gp and draws it, as draw_plane does.
std::vector<std::string> draw_chart(const std::string& base, const ChartPlot& chart,
                                    const std::vector<std::string>& formats);

/// The title above the picture, and the caption below it in lines that fit.
void print_words(std::ofstream& out, const std::string& title,
                 const std::vector<std::string>& caption);

/// Runs a gnuplot script with `-e "format='png'"` for each format; the pictures that appeared.
std::vector<std::string> run_gnuplot(const std::string& base,
                                     const std::vector<std::string>& formats);

/// The lines of a script that choose the terminal from the variable `format`; size in pixels of the
/// png.
[[nodiscard]] std::string gnuplot_terminal(const std::string& output_base, int width, int height);

/// The lines of a palette with its bar: around MEGNO's 2, or from dark to light.
[[nodiscard]] std::string gnuplot_colours(bool around_two);

/// Text for a gnuplot string in double quotes, enhanced text switched off by the caller.
[[nodiscard]] std::string gnuplot_quoted(const std::string& text);

} // namespace kov::cli
