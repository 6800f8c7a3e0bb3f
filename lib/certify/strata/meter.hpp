#pragma once
// One meter for all the work of a file: every Arithmetic of this thread is counted by it, too.

namespace kov::certify {

class FileMeter {
public:
  FileMeter();
  ~FileMeter();
  FileMeter(const FileMeter&) = delete;
  FileMeter& operator=(const FileMeter&) = delete;

  /// Refuses when the file is too much work; does nothing where nobody counts.
  static void charge(double products, double words);

private:
  double products_ = 0, words_ = 0;
  FileMeter* outer_;
};

} // namespace kov::certify
