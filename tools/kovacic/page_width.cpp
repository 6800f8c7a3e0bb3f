#include "page_width.hpp"

#include <algorithm>
#include <sstream>
#include <sys/ioctl.h>
#include <unistd.h>

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

std::string for_standard_output(const std::string& text) {
  const std::size_t width = columns_of(STDOUT_FILENO, 0);
  return width == 0 ? text : folded(text, std::max(width, narrowest));
}

} // namespace kov::cli
