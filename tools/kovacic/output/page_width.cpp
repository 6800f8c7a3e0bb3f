#include "output/page_width.hpp"

#include "exact/lists.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>
#include <sys/ioctl.h>
#include <unistd.h>
#include <vector>

namespace kov::cli {
namespace {

constexpr std::size_t widest = 98, narrowest = 40;

std::size_t& width_in_use() {
  static std::size_t width = widest;
  return width;
}

bool& with_colours() {
  static bool on = false;
  return on;
}

// Where the text of a line begins: behind the label, if it has one.
std::size_t text_column(const std::string& line) {
  const std::size_t first = line.find_first_not_of(' ');
  if (first == std::string::npos || first == 0) return 2;
  const std::size_t gap = line.find("  ", first);
  const std::size_t text = gap == std::string::npos ? gap : line.find_first_not_of(' ', gap);
  return text == std::string::npos || text > 18 ? first + 2 : text;
}

} // namespace

std::size_t columns_of(int descriptor, std::size_t otherwise) {
  winsize size = {};
  if (::isatty(descriptor) == 0 || ::ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0)
    return otherwise;
  return size.ws_col;
}

void set_colours(bool on) { with_colours() = on; }

std::string painted(const std::string& text, Meaning meaning) {
  if (!with_colours()) return text;
  const char* code = meaning == Meaning::positive   ? "32"
                     : meaning == Meaning::negative ? "31"
                                                    : "33";
  return std::string("\033[1;") + code + "m" + text + "\033[0m";
}

std::size_t page_width() { return width_in_use(); }

void set_page_width(bool on_standard_output) {
  if (on_standard_output)
    width_in_use() = std::clamp(columns_of(STDOUT_FILENO, widest), narrowest, widest);
}

std::string folded(const std::string& text, std::size_t width) {
  std::ostringstream out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const bool comment = line.starts_with("# ");
    const std::size_t indent = std::min(text_column(line), width / 2);
    const std::string before = comment ? "#   " : std::string(indent, ' ');
    while (line.size() > width) {
      std::size_t blank = line.rfind(' ', width);
      if (blank == std::string::npos || line.find_first_not_of(' ') >= blank)
        blank = line.find(' ', std::max(width, line.find_first_not_of(' ')));
      if (blank == std::string::npos) break;
      out << line.substr(0, line.find_last_not_of(' ', blank) + 1) << '\n';
      const std::size_t rest = line.find_first_not_of(' ', blank);
      line = rest == std::string::npos ? "" : before + line.substr(rest);
    }
    out << line << '\n';
  }
  std::string all = out.str();
  if (!text.ends_with('\n') && !all.empty()) all.pop_back();
  return all;
}

namespace {

constexpr long page_lines = 40;

/// A title; a line of an answer with its label, and the deeper lines that belong to it.
struct Paragraph {
  std::string label, text;
  long lines = 0;
  bool is_first = false; ///< a title or a headline, or what answers the question
  bool is_shown = false;
};

// "stratum" of "  stratum   a = 0"; empty: no label
std::string label_of(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(' ');
  if (begin != 2) return "";
  const std::size_t end = std::min(line.find("  ", begin), line.find(' ', begin + 9));
  if (end == std::string::npos) return "";
  const std::size_t text = line.find_first_not_of(' ', end);
  return text == 12 || text == 14 ? line.substr(begin, end - begin) : "";
}

bool answers_first(const std::string& label) {
  static constexpr std::array<std::string_view, 18> labels{
      "theorem", "so far",      "assumed", "solution", "solutions", "values",
      "domain",  "next",        "expect",  "trusted",  "proof",     "certificate",
      "failed",  "NOT CHECKED", "error",   "order 1",  "given",     "decided"};
  return is_among(label, labels);
}

bool is_case(const std::string& label) {
  static constexpr std::array<std::string_view, 6> labels{"stratum", "integrable", "excluded",
                                                          "where",   "open",       "at"};
  return is_among(label, labels);
}

std::vector<Paragraph> paragraphs(const std::string& text) {
  std::vector<Paragraph> all;
  std::istringstream lines(text);
  bool is_headline = false;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    const bool is_title = indent == 0 && !line.empty();
    const std::string label = label_of(line);
    is_headline = is_title || (is_headline && label.empty());
    if (all.empty() || is_title || (indent == 2 && (!label.empty() || is_headline)))
      all.push_back({label, "", 0, is_headline || answers_first(label)});
    all.back().text += line + '\n';
    ++all.back().lines;
  }
  return all;
}

// "9 more cases and 12 more lines: --verbose"
std::string left_out(const std::vector<Paragraph>& all) {
  long cases = 0, lines = 0;
  for (const Paragraph& p : all)
    if (!p.is_shown) (is_case(p.label) ? cases : lines) += is_case(p.label) ? 1 : p.lines;
  const auto counted = [](long n, const std::string& one) {
    return std::to_string(n) + " more " + one + (n == 1 ? "" : "s");
  };
  return (cases > 0 ? counted(cases, "case") : "") + (cases > 0 && lines > 0 ? " and " : "") +
         (lines > 0 ? counted(lines, "line") : "") + ": --verbose";
}

} // namespace

std::string one_page(const std::string& text) {
  if (std::ranges::count(text, '\n') <= page_lines) return text;
  std::vector<Paragraph> all = paragraphs(text);
  long room = page_lines - 1;
  for (const bool first : {true, false})
    for (Paragraph& p : all)
      if (p.is_first == first && p.lines <= room) {
        p.is_shown = true;
        room -= p.lines;
      }
  std::string page;
  for (const Paragraph& p : all)
    if (p.is_shown) page += p.text;
  return page + "  more      " + left_out(all) + '\n';
}

std::string for_standard_output(const std::string& text) {
  const std::size_t width = columns_of(STDOUT_FILENO, 0);
  return width == 0 ? text : folded(text, std::max(width, narrowest));
}

} // namespace kov::cli
