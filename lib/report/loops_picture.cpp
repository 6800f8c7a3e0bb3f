#include "report/loops_picture.hpp"

#include "exact/joined.hpp"
#include "report/formula.hpp"

#include <algorithm>
#include <utility>

namespace kov::report {
namespace {

using monodromy::Path;
using monodromy::Point;
using monodromy::Real;

constexpr long side = 640, margin = 60, line_height = 20;
constexpr std::size_t most_in_legend = 24;

// The nearest integer; what is far outside of the picture is cut.
long nearest(const Real& x) {
  if (Real(1000000) < x) return 1000000;
  if (x < Real(-1000000)) return -1000000;
  return arf_get_si(arb_midref(x.raw()), ARF_RND_NEAR);
}

class PicturePlane {
public:
  PicturePlane(const monodromy::LoopTree& tree, std::vector<Point> points)
      : tree_(tree), points_(std::move(points)) {
    Real low_x = tree.base.x, high_x = low_x, low_y = tree.base.y, high_y = low_y;
    const auto hold = [&](const std::vector<Point>& all) {
      for (const Point& p : all) {
        low_x = min(low_x, p.x), high_x = max(high_x, p.x);
        low_y = min(low_y, p.y), high_y = max(high_y, p.y);
      }
    };
    hold(points_);
    for (const auto& loop : tree.loops)
      hold(loop.circle.vertices);
    const Real size = max(max(high_x - low_x, high_y - low_y), Real(1) / Real(1L << 40));
    scale_ = Real(10 * (side - 2 * margin)) / size; // tenths of a pixel
    centre_ = {(low_x + high_x) / Real(2), (low_y + high_y) / Real(2)};
  }

  [[nodiscard]] std::string draw() const {
    std::string out;
    for (const auto& loop : tree_.loops)
      for (const Point& v : loop.approach.vertices)
        out += convergence(v);
    for (const auto& loop : tree_.loops)
      out += polyline(loop.approach.vertices, "loop") + polyline(loop.circle.vertices, "loop");
    for (std::size_t i = 0; i < tree_.loops.size(); ++i) {
      const Point& s = points_[tree_.loops[i].singularity];
      out += dot(s, "place") + words(s, std::to_string(tree_.loops[i].singularity + 1), shift(i));
    }
    return out + dot(tree_.base, "base") + words(tree_.base, "base");
  }

private:
  [[nodiscard]] std::string x(const Point& p) const { return tenths(p.x - centre_.x, false); }
  [[nodiscard]] std::string y(const Point& p) const { return tenths(p.y - centre_.y, true); }
  [[nodiscard]] std::string tenths(const Real& d, bool down) const {
    const Real shift = down ? Real(0) - d * scale_ : d * scale_;
    return decimal(nearest(shift) + 10 * side / 2);
  }
  static std::string decimal(long tenths) {
    const std::string digits = std::to_string(std::abs(tenths));
    const std::string padded = digits.size() < 2 ? "0" + digits : digits;
    return (tenths < 0 ? "-" : "") + padded.substr(0, padded.size() - 1) + "." + padded.back();
  }

  // Up to the next singular point: there the expansion at v converges.
  [[nodiscard]] std::string convergence(const Point& v) const {
    Real radius = abs(points_.front() - v);
    for (const Point& p : points_)
      radius = min(radius, abs(p - v));
    const long r = nearest(radius * scale_);
    return r < 10 ? ""
                  : "<circle class=\"disc\" cx=\"" + x(v) + "\" cy=\"" + y(v) + "\" r=\"" +
                        decimal(r) + "\"/>\n";
  }
  [[nodiscard]] std::string polyline(const std::vector<Point>& points, const char* kind) const {
    std::string at = joined(
        points, [&](const Point& p) { return x(p) + "," + y(p); }, " ");
    return std::string("<polyline class=\"") + kind + "\" points=\"" + at + "\"/>\n";
  }
  [[nodiscard]] std::string dot(const Point& p, const char* kind) const {
    return std::string("<circle class=\"") + kind + "\" cx=\"" + x(p) + "\" cy=\"" + y(p) +
           "\" r=\"4\"/>\n";
  }
  [[nodiscard]] std::string words(const Point& p, const std::string& text, long right = 8) const {
    return "<text x=\"" + x(p) + "\" y=\"" + y(p) + "\" dx=\"" + std::to_string(right) +
           "\" dy=\"-7\">" + text + "</text>\n";
  }
  // Numbers of places that are too near to each other for the eye stand side by side.
  [[nodiscard]] long shift(std::size_t i) const {
    const Real near = Real(10 * line_height) / scale_;
    long right = 8;
    for (std::size_t j = 0; j < i; ++j)
      if (abs(points_[tree_.loops[i].singularity] - points_[tree_.loops[j].singularity]) < near)
        right += line_height;
    return right;
  }

  const monodromy::LoopTree& tree_;
  std::vector<Point> points_;
  Real scale_;
  Point centre_;
};

constexpr const char* style =
    "<style>text{font:14px \"Source Serif 4\",Georgia,\"DejaVu Serif\",serif;fill:#1d2430}"
    ".title{font-weight:bold;font-size:16px}.soft{fill:#5b6472}"
    ".disc{fill:#2458a6;fill-opacity:.02;stroke:#9aa4b2;stroke-width:.7}"
    ".loop{fill:none;stroke:#2458a6;stroke-width:1.5}.place{fill:#b3261e}.base{fill:#1d2430}"
    "</style>\n";

// Lines of text below the picture.
class Legend {
public:
  void add(const std::string& kind, const std::string& text, std::size_t width = 84) {
    std::string line, word;
    for (const char c : text + " ") {
      if (c != ' ') {
        word += c;
        continue;
      }
      if (!line.empty() && line.size() + 1 + word.size() > width)
        put(kind, std::exchange(line, ""));
      line += (line.empty() ? "" : " ") + std::exchange(word, "");
    }
    put(kind, line);
  }
  explicit Legend(long below) : y_(below) {}
  [[nodiscard]] const std::string& svg() const { return svg_; }
  [[nodiscard]] long height() const { return y_ + line_height; }

private:
  void put(const std::string& kind, const std::string& line) {
    y_ += line_height;
    svg_ += "<text class=\"" + kind + "\" x=\"20\" y=\"" + std::to_string(y_) + "\">" +
            label(line, Markup::html) + "</text>\n";
  }
  long y_;
  std::string svg_;
};

} // namespace

std::string loops_svg(const monodromy::Monodromy& m, const std::string& title,
                      const std::vector<std::string>& places) {
  std::vector<monodromy::SingularPoint> singular;
  std::vector<Point> points;
  for (const auto& loop : m.loops) {
    singular.push_back(loop.place);
    points.push_back(monodromy::point(loop.place.at));
  }
  const auto tree = monodromy::loops_of(singular, m.base);
  const long drawn = points.empty() ? 0 : side;
  Legend legend(drawn);
  legend.add("title", shortened(title, 240), 66);
  for (std::size_t i = 0; i < std::min(places.size(), most_in_legend); ++i)
    legend.add("", std::to_string(i + 1) + ": around " + places[i]);
  if (places.size() > most_in_legend)
    legend.add("", "and " + std::to_string(places.size() - most_in_legend) + " more");
  if (points.empty())
    legend.add("soft", "There is no finite singularity: every loop gives the identity.");
  else
    legend.add("soft", "Loops from the base, counterclockwise, in this order; grey: where the "
                       "expansions on the way converge.");
  const std::string height = std::to_string(legend.height());
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + std::to_string(side) + " " +
         height + "\" width=\"" + std::to_string(side) + "\" height=\"" + height + "\">\n" + style +
         "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n<svg width=\"" +
         std::to_string(side) + "\" height=\"" + std::to_string(drawn) + "\">\n" +
         (points.empty() ? "" : PicturePlane(tree, points).draw()) + "</svg>\n" + legend.svg() +
         "</svg>\n";
}

} // namespace kov::report
