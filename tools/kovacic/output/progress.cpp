#include "output/progress.hpp"

#include "output/page_width.hpp"
#include "process/supervisor.hpp"
#include "systems/mechanics.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace kov::cli {

using Seconds = std::chrono::duration<double>;

Progress::Progress(std::uintmax_t bytes) : terminal_(::isatty(STDERR_FILENO) != 0), bytes_(bytes) {}

void Progress::answered(std::uintmax_t bytes, bool decided) {
  ++answered_;
  open_ += !decided;
  seen_ += bytes;
  if (terminal_ && Clock::now() - last_ >= std::chrono::milliseconds(500)) show();
}

void Progress::show() {
  last_ = Clock::now();
  const double seconds = Seconds(last_ - start_).count();
  std::string line = fmt::format("{} answers", found_ + answered_);
  if (bytes_ > 0)
    line += fmt::format(" ({:.0f} %)", 100.0 * static_cast<double>(std::min(seen_, bytes_)) /
                                           static_cast<double>(bytes_));
  line += fmt::format(", {:.1f} per second", static_cast<double>(answered_) / seconds);
  if (open_ > 0) line += fmt::format(", {} not decided", open_);
  if (bytes_ > seen_ && seen_ > before_)
    line += fmt::format(", about {:.0f} s left", seconds * static_cast<double>(bytes_ - seen_) /
                                                     static_cast<double>(seen_ - before_));
  std::fprintf(stderr, "\r\033[K%s", line.c_str());
  std::fflush(stderr);
  shown_ = true;
}

void Progress::clear() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void show_that_it_works(const std::string& name, double seconds) {
  if (::isatty(STDERR_FILENO) == 0) return;
  Worker::while_waiting([=, shown = false](double spent, std::string_view early) mutable {
    constexpr double soon = 2;
    if (spent < 0 && shown) {
      std::fputs("\r\033[K", stderr);
      shown = false;
    }
    if (spent < soon) return;
    std::string line = fmt::format("{}: {:.0f} s", name, spent);
    if (seconds > 0) line += fmt::format(" of at most {:.0f}", seconds);
    line += "; Ctrl-C keeps what is proved";
    if (const std::string stage = stage_in(early); !stage.empty()) line += "; now " + stage;
    const std::size_t width = columns_of(STDERR_FILENO, 80) - 1;
    if (line.size() > width) line.resize(width);
    std::fprintf(stderr, "\r\033[K%s", line.c_str());
    std::fflush(stderr);
    shown = true;
  });
}

} // namespace kov::cli
