#pragma once
// How far a long run is, on a terminal.

#include <chrono>
#include <cstdint>
#include <string>

namespace kov::cli {

/// One line on standard error, at most twice a second; nothing where that is not a terminal.
class Progress {
public:
  /// `bytes` of the input in all; 0 = not known.
  explicit Progress(std::uintmax_t bytes);
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more answer to a question of so many bytes.
  void answered(std::uintmax_t bytes, bool decided);
  /// The same for one that was there before.
  void found(std::uintmax_t bytes) { ++found_, seen_ += bytes, before_ += bytes; }

private:
  using Clock = std::chrono::steady_clock;
  void show();
  void clear();

  bool terminal_;
  bool shown_ = false;
  std::uintmax_t bytes_;
  std::uintmax_t seen_ = 0;
  std::uintmax_t before_ = 0;
  long found_ = 0;
  long answered_ = 0;
  long open_ = 0;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

/// On a terminal: one line on standard error while a question takes more than two seconds.
/// name: of the command; seconds: its time limit, 0 = none
void show_that_it_works(const std::string& name, double seconds);

} // namespace kov::cli
