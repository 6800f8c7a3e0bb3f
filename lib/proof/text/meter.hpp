#pragma once
// One meter for all the work of a file: every Arithmetic and Judge of this thread is counted by it, too.

namespace kov::certify {

/// That of a file inside another one is the meter of the other.
class FileMeter {
public:
  FileMeter();
  ~FileMeter();
  FileMeter(const FileMeter&) = delete;
  FileMeter& operator=(const FileMeter&) = delete;

  /// Refuses when the file is too much work; does nothing where nobody counts.
  static void charge(double products, double words, double operations = 0);

private:
  double products_ = 0, words_ = 0, operations_ = 0;
  FileMeter* outer_;
};

} // namespace kov::certify
