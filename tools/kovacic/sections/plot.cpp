#include "sections/plot.hpp"

#include "sections/axis_label.hpp"

#include "process/settings.hpp"
#include "process/subprocess.hpp"

#include <fmt/core.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace kov::cli {
namespace fs = std::filesystem;

std::string gnuplot_quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '`') { // which would run a command, even in a string
      out += "\\140";
      continue;
    }
    if (c == '"' || c == '\\') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out + "\"";
}

std::string gnuplot_terminal(const std::string& output_base, int width, int height) {
  return fmt::format(
      "set encoding utf8\nif (!exists(\"format\")) format = \"png\"\n"
      "if (format eq \"png\") set terminal pngcairo size {5},{6} enhanced font \"sans,12\" "
      "fontscale 1.5 linewidth 1.5 pointscale 1.5 background \"#ffffff\"\n"
      "if (format eq \"svg\") set terminal svg size {0},{1} enhanced font \"sans,12\" "
      "background \"#ffffff\"\n"
      "if (format eq \"pdf\") set terminal pdfcairo size {2}cm,{3}cm enhanced font "
      "\"sans,11\"\n"
      "set output {4} . \".\" . format\n",
      width, height, width / 50, height / 50, gnuplot_quoted(output_base), width * 3 / 2,
      height * 3 / 2);
}

std::vector<std::string> run_gnuplot(const std::string& base,
                                     const std::vector<std::string>& formats) {
  std::vector<std::string> drawn;
  const fs::path path(base);
  const std::string directory = path.has_parent_path() ? path.parent_path().string() : ".";
  for (const std::string& format : formats) {
    if (format == "none") continue;
    const int code = run_program(
        {"gnuplot", "-e", "format='" + format + "'", path.filename().string() + ".gp"}, directory);
    const std::string picture = base + "." + format;
    if (code == 0 && fs::exists(picture)) drawn.push_back(picture);
  }
  return drawn;
}

namespace {

// 10^-16 with a raised exponent, pi as a letter.
std::string typeset_caption(const std::string& caption) {
  static constexpr std::array<const char*, 10> raised{"⁰", "¹", "²", "³", "⁴",
                                                      "⁵", "⁶", "⁷", "⁸", "⁹"};
  const auto letter = [&](std::size_t i) {
    return i < caption.size() && std::isalpha(static_cast<unsigned char>(caption[i])) != 0;
  };
  std::string out;
  for (std::size_t i = 0; i < caption.size(); ++i) {
    if (caption.compare(i, 4, "10^-") == 0) {
      out += "10⁻";
      for (i += 4; i < caption.size() && std::isdigit(static_cast<unsigned char>(caption[i])) != 0;
           ++i)
        out += raised.at(static_cast<std::size_t>(caption[i] - '0'));
      --i;
    } else if (caption.compare(i, 2, "pi") == 0 && (i == 0 || !letter(i - 1)) && !letter(i + 2)) {
      out += "π";
      ++i;
    } else {
      out += caption[i];
    }
  }
  return out;
}

} // namespace

std::string gnuplot_colours(bool around_two) {
  // Lightness and hue change evenly.  Around 2, the value of regular motion, MEGNO's map is dark, with
  // green below and purple to orange above; the logarithmic bar has 2 in its middle.
  return around_two ? "set palette defined (0 \"#4fb99f\", 0.25 \"#127a6b\", 0.5 \"#22304a\", 0.62 "
                      "\"#5b1d72\", "
                      "0.75 \"#a5317e\", 0.88 \"#e2505f\", 1 \"#fb9a62\")\n"
                      "set logscale cb\nset cbrange [0.1:40]\n"
                      "set cbtics (\"0.1\" 0.1, \"0.5\" 0.5, \"1\" 1, \"2\" 2, \"4\" 4, \"10\" 10, "
                      "\"40\" 40)\n"
                    : "set palette defined (0 \"#22304a\", 0.25 \"#5b1d72\", 0.5 \"#a5317e\", 0.75 "
                      "\"#e2505f\", 1 "
                      "\"#fb9a62\")\n";
}

namespace {

// The legend stands above the picture, which has the whole width; a bar of colours stands beside it.
constexpr const char* key_above =
    "set key outside center top horizontal Left reverse samplen 1 spacing 1.2 width 1\n";
constexpr const char* bar_beside =
    "set rmargin at screen 0.84\nset colorbox user origin screen 0.86, screen 0.3 size screen "
    "0.022, screen 0.55\n";

// Unproved points have shapes and a colour of their own.
std::string style_of(const FixedPointMark& m) {
  struct Shapes {
    const char *kind, *colour;
    int proved, unproved; // gnuplot's point types
  };
  static constexpr Shapes styles[] = {{"elliptic", "#007020", 6, 4},
                                      {"hyperbolic", "#c00000", 2, 8},
                                      {"inverse-hyperbolic", "#8000a0", 1, 10},
                                      {"parabolic", "#0060c0", 12, 14},
                                      {"undecided", "#0060c0", 12, 14}};
  const Shapes* style = std::begin(styles);
  while (m.kind != style->kind && style + 1 != std::end(styles))
    ++style;
  return fmt::format("with points pt {} ps 1 lw 2 lc rgb \"{}\" title \"{}{}\"",
                     m.proved ? style->proved : style->unproved,
                     m.proved ? style->colour : "#e08000", m.kind,
                     m.proved ? ", proved" : ", not proved");
}

} // namespace

void print_words(std::ofstream& out, const std::string& title,
                 const std::vector<std::string>& caption) {
  constexpr std::size_t width = 100;
  std::vector<std::string> all;
  for (std::string rest : caption) {
    while (rest.size() > width) {
      const std::size_t part = rest.rfind("; ", width - 1), space = rest.rfind(' ', width);
      const std::size_t cut = part != std::string::npos && 2 * part > width ? part + 1
                              : space == std::string::npos || space == 0    ? width
                                                                            : space;
      all.push_back(rest.substr(0, cut));
      rest.erase(0, rest[cut] == ' ' ? cut + 1 : cut);
    }
    all.push_back(rest);
  }
  const auto lines = static_cast<double>(all.size());
  fmt::print(out, "set title {} noenhanced\nset bmargin {:.1f}\n", gnuplot_quoted(title),
             4 + 1.15 * lines);
  for (std::size_t i = 0; i < all.size(); ++i)
    fmt::print(out, "set label {} {} at screen 0.5, screen {:.3f} center noenhanced\n", i + 1,
               gnuplot_quoted(typeset_caption(all[i])),
               0.02 + 0.03 * (lines - 1 - static_cast<double>(i)));
}

namespace {

void print_axes(std::ofstream& out, const PlanePlot& plot) {
  for (std::size_t i = 0; i < 2; ++i) {
    const char* axis = i == 0 ? "x" : "y";
    fmt::print(out, "set {}label {}\n", axis, gnuplot_quoted(axis_label(plot.labels[i])));
    if (plot.turned)
      fmt::print(out, "{}",
                 i == 0 ? "set xrange [-pi/4:7*pi/4]\nset xtics (\"0\" 0, \"π/2\" pi/2, \"π\" pi, "
                          "\"3π/2\" 3*pi/2)\nwrap(l) = l >= 7*pi/4 ? l - 2*pi : l\n"
                        : "set yrange [-1.03:1.03]\nset ytics 0.5\n");
    else if (plot.angle[i])
      fmt::print(
          out,
          "set {0}range [-pi:pi]\nset {0}tics (\"-π\" -pi, \"-π/2\" -pi/2, \"0\" 0, \"π/2\" pi/2, "
          "\"π\" pi)\n",
          axis);
    else if (plot.range)
      fmt::print(out, "set {}range [{:.6g}:{:.6g}]\n", axis, (*plot.range)[i][0],
                 (*plot.range)[i][1]);
  }
}

// The abscissa as gnuplot computes it.
std::string abscissa(const PlanePlot& plot) {
  const std::string column = "column(" + gnuplot_quoted(plot.columns[0]) + ")";
  return plot.turned ? "wrap(" + column + ")" : column;
}

// Layers over the orbits: what BASE.homoclinic.dat and BASE.fixed.dat have.
void print_proved(std::ofstream& out, const std::string& name, const PlanePlot& plot) {
  const auto layer = [&](const char* ending, const std::string& condition,
                         const std::string& style) {
    fmt::print(out, ", \\\n     {} using ({} ? {} : NaN):{} {}", gnuplot_quoted(name + ending),
               condition, abscissa(plot), gnuplot_quoted(plot.columns[1]), style);
  };
  if (plot.manifolds) {
    const auto is = [](const char* what) {
      return fmt::format("strcol(\"what\") eq \"{}\"", what);
    };
    layer(".homoclinic.dat", is("unstable"),
          "with points pt 7 ps 0.25 lc rgb \"#c00000\" title \"unstable manifold\"");
    layer(".homoclinic.dat", is("stable"),
          "with points pt 7 ps 0.25 lc rgb \"#0040c0\" title \"stable manifold\"");
    layer(".homoclinic.dat", is("homoclinic"),
          "with points pt 6 ps 1.2 lw 2 lc rgb \"#000000\" title \"homoclinic orbit, proved\"");
  }
  for (const FixedPointMark& m : plot.marks)
    layer(".fixed.dat",
          fmt::format("strcol(\"kind\") eq \"{}\" && strcol(\"error\") {} \"inf\"", m.kind,
                      m.proved ? "ne" : "eq"),
          style_of(m));
}

// The colour of a point as the palette has it, mixed with white.
constexpr const char* lighter =
    "light(c) = int(255 - 0.4*(255 - (int(c) & 255)))\n"
    "mixed(c) = (light(int(c) >> 16) << 16) + (light(int(c) >> 8) << 8) + "
    "light(c)\n";

// Points that are right, over those that are only statistical.
void print_points(std::ofstream& out, const std::string& name, const PlanePlot& plot, double size) {
  const bool one_each = plot.colour.empty();
  const std::string colour =
      one_each ? "int(column(\"orbit\")) % 6" : "column(" + gnuplot_quoted(plot.colour) + ")";
  const std::string x = gnuplot_quoted(plot.columns[0]), y = gnuplot_quoted(plot.columns[1]);
  const auto layer = [&](const std::string& abscissa, const std::string& value,
                         const std::string& lc) {
    return fmt::format(
        "{} using {}:{}:({}) notitle with points pt 7 ps (format eq \"png\" ? {} : {}) lc {}",
        gnuplot_quoted(name + ".dat"), abscissa, y, value, size + 0.04, size, lc);
  };
  if (plot.manifolds) { // which lie over the orbits
    fmt::print(out, "plot {}", layer(x, colour, "rgb \"#c0c0c0\""));
  } else if (!plot.form.empty()) {
    const char* start = "plot ";
    for (const auto& [relation, rgb] : {std::pair{">", "#c00000"}, {"<", "#0030c0"}}) {
      fmt::print(out, "{}{}, \\\n     NaN title {} with points pt 7 ps 0.6 lc rgb \"{}\"", start,
                 layer(fmt::format("(column(\"sign\") {} 0 ? {} : NaN)", relation, abscissa(plot)),
                       "0", fmt::format("rgb \"{}\"", rgb)),
                 gnuplot_quoted(axis_label(plot.form) + " " + relation + " 0"), rgb);
      start = ", \\\n     ";
    }
  } else if (plot.plain) {
    fmt::print(out, "plot {}", layer("(" + abscissa(plot) + ")", "0", "rgb \"#102040\""));
  } else if (!plot.errors) {
    fmt::print(out, "plot {}", layer(x, colour, "palette"));
  } else {
    const auto only = [&](const char* condition) {
      return fmt::format("(column(\"error\") {} 1e-3 ? column({}) : NaN)", condition, x);
    };
    if (!one_each && !plot.logarithmic) // palette(z) needs the range before the points are read
      fmt::print(out,
                 "stats {} using ({}) name \"colour\" nooutput\n"
                 "if (colour_max > colour_min) set cbrange [colour_min:colour_max]\n",
                 gnuplot_quoted(name + ".dat"), colour);
    fmt::print(out, "{}plot {}, \\\n     {}", lighter,
               layer(only(">"), "mixed(palette(" + colour + "))", "rgb variable"),
               layer(only("<="), colour, "palette"));
  }
}

} // namespace

std::vector<std::string> draw_plane(const std::string& base, const PlanePlot& plot,
                                    const std::vector<std::string>& formats) {
  const std::string name = fs::path(base).filename().string();
  const bool proved = plot.manifolds || !plot.marks.empty() || !plot.form.empty(),
             one_each = plot.colour.empty();
  std::ofstream out(base + ".gp");
  fmt::print(out, "# gnuplot -e \"format='pdf'\" {}    (png, svg, pdf)\n",
             gnuplot_quoted(name + ".gp"));
  fmt::print(out, "{}", gnuplot_terminal(name, 960, 760));
  print_words(out, plot.title, plot.caption);
  fmt::print(out, "set lmargin 9\n");
  print_axes(out, plot);
  const std::string key = (one_each || plot.manifolds ? "set rmargin at screen 0.97\n" : "") +
                          std::string(proved ? key_above : "unset key\n");
  const double size = std::clamp(12 / std::sqrt(static_cast<double>(plot.points + 1)), 0.06, 0.5);
  if (one_each || plot.manifolds) // neighbours in the list of orbits have different colours
    fmt::print(out,
               "{}unset colorbox\nset palette defined (0 \"#102040\", 1 \"#0060c0\", "
               "2 \"#007020\", "
               "3 \"#b06000\", 4 \"#a00040\", 5 \"#6000a0\")\nset cbrange [0:5]\n",
               key);
  else
    fmt::print(out, "{}{}{}set cblabel {} noenhanced\n", key, bar_beside,
               gnuplot_colours(plot.logarithmic), gnuplot_quoted(plot.colour_label));
  print_points(out, name, plot, size);
  print_proved(out, name, plot);
  fmt::print(out, "\n");
  close_file(out, base + ".gp");
  return run_gnuplot(base, formats);
}

namespace {

// Ten kinds of lines that the colour-blind tell apart by shape, too.
std::string line_styles() {
  static constexpr std::array<const char*, 5> colours{"#1f4e9c", "#c4483a", "#2a8c6e", "#8c4fa8",
                                                      "#c98a1b"};
  std::string all;
  for (std::size_t i = 0; i < 10; ++i)
    all += fmt::format("set style line {} lc rgb \"{}\" lw 1.3 ps 0.8 pt {}\n", i + 1,
                       colours.at(i % 5), std::array{7, 5, 9, 11, 13, 6, 4, 8, 10, 12}.at(i));
  return all;
}

} // namespace

std::vector<std::string> draw_chart(const std::string& base, const ChartPlot& chart,
                                    const std::vector<std::string>& formats) {
  const std::string name = fs::path(base).filename().string();
  std::ofstream out(base + ".gp");
  fmt::print(out, "# gnuplot -e \"format='pdf'\" {}    (png, svg, pdf)\n",
             gnuplot_quoted(name + ".gp"));
  fmt::print(out, "{}", gnuplot_terminal(name, 900, 600));
  fmt::print(out,
             "set title {} noenhanced\nset grid lc rgb \"#d8dce4\" lt 1\nset tics nomirror\n{}",
             gnuplot_quoted(chart.title), line_styles());
  fmt::print(out, "{}",
             chart.linear_x ? "set logscale y\nset offsets graph 0.03, graph 0.03\n"
                            : "set logscale xy\nset mxtics 1\nset format x \"10^{{%L}}\"\n");
  if (!chart.linear_x) fmt::print(out, "set format y \"10^{{%L}}\"\n");
  if (chart.falling) fmt::print(out, "set xrange [*:*] reverse\n");
  fmt::print(out, "set xlabel {} noenhanced\nset ylabel {} noenhanced\n",
             gnuplot_quoted(chart.x_label), gnuplot_quoted(chart.y_label));
  fmt::print(out, "set key outside right top Left reverse noenhanced spacing 1.2\nplot ");
  const std::string x = gnuplot_quoted(chart.x), y = gnuplot_quoted(chart.y),
                    by = gnuplot_quoted(chart.series_column);
  for (std::size_t i = 0; i < chart.series.size(); ++i)
    fmt::print(out,
               "{}{} using (strcol({}) eq {} && column({}) > 0 ? column({}) : NaN):(column({})) "
               "with {} ls {} title {}",
               i == 0 ? "" : ", \\\n     ", gnuplot_quoted(chart.data), by,
               gnuplot_quoted(chart.series[i]), x, x, y, chart.linear_x ? "points" : "linespoints",
               i % 10 + 1, gnuplot_quoted(chart.series_name + chart.series[i]));
  fmt::print(out, "\n");
  close_file(out, base + ".gp");
  return run_gnuplot(base, formats);
}

} // namespace kov::cli
