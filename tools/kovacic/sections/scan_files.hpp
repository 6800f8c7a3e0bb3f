#pragma once
// What a scan leaves behind: the matrix, a picture, a page, and on the way a journal of finished blocks.

#include "flow/scene/scan.hpp"

#include <fstream>

namespace kov::cli {

/// Blocks as they are finished, appended to a file: after a kill the whole ones are there.
class ScanJournal {
public:
  /// about: what the numbers depend on; another text is another scan
  ScanJournal(std::string path, std::string about);
  /// What an earlier run has left; a block that is cut off is removed.  Errors  InputError: of another scan
  [[nodiscard]] std::map<std::size_t, flow::ScanBlock> kept() const;
  /// The whole blocks of another journal of the same scan, which may be still growing.
  [[nodiscard]] std::map<std::size_t, flow::ScanBlock> kept_in(const std::string& path) const;
  void append(std::size_t number, const flow::ScanBlock& block);
  void remove();

private:
  void begin();
  std::map<std::size_t, flow::ScanBlock> read(const std::string& path, std::uintmax_t& whole) const;
  std::string path_, head_;
  std::ofstream out_;
};

/// The journals BASE.K-of-N.scan-part that the parts of a scan have left.
[[nodiscard]] std::vector<std::string> journals_of_parts(const std::string& base);

/// A NumPy file, format 1.0: float64, the first axis side by side.
void write_npy(const std::string& path, const std::vector<double>& values,
               const std::vector<std::size_t>& shape);
/// Bytes before the numbers in it: a multiple of 64.
[[nodiscard]] std::size_t npy_head_size(const std::vector<std::size_t>& shape);

/// From which number to which the colours go: 1 of 100 numbers lie beyond each end.
struct ColourRange {
  double low = 0, high = 1;
  bool logarithmic = false;
};

struct ScanPlot {
  std::string title;
  std::vector<std::string> caption;
  std::vector<flow::ScanAxis> axes;
  std::string label; ///< of the number
  ColourRange colours;
};

/// BASE.gp for BASE.npy, and what it draws.
std::vector<std::string> draw_scan(const std::string& base, const ScanPlot& plot,
                                   const std::vector<std::string>& formats);
/// One HTML file: pan, zoom, and the number of the cell under the pointer.
[[nodiscard]] std::string scan_page(const ScanPlot& plot, const std::vector<double>& values);

} // namespace kov::cli
