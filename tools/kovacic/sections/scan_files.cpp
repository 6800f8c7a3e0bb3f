#include "sections/scan_files.hpp"

#include "sections/axis_label.hpp"
#include "sections/plot.hpp"
#include "sections/section_files.hpp"
#include "symbol/input_error.hpp"
#include "theorem/setting.hpp"

#include <fmt/core.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <sstream>

namespace kov::cli {

namespace fs = std::filesystem;

// ---- the journal ----

namespace {

constexpr std::uint64_t block_mark = 0x6b6f766163696302; // of a block that is whole

template <class T> void put(std::ostream& out, const T& x) {
  out.write(reinterpret_cast<const char*>(&x), sizeof x);
}
template <class T> bool take(std::istream& in, T& x) {
  return static_cast<bool>(in.read(reinterpret_cast<char*>(&x), sizeof x));
}

// What a block says, and what its checksum is of.
std::string bytes_of(std::uint64_t number, const flow::ScanBlock& block) {
  std::ostringstream all;
  put(all, number);
  put(all, static_cast<std::uint64_t>(block.values.size()));
  put(all, block.drift);
  put(all, block.crossings);
  for (const double x : block.values)
    put(all, x);
  return all.str();
}

// False: cut off.  right: is it what was written?
bool take_block(std::istream& in, std::uint64_t& number, flow::ScanBlock& block, bool& right) {
  std::uint64_t mark = 0, size = 0;
  if (!take(in, mark) || mark != block_mark || !take(in, number) || !take(in, size) ||
      size > flow::scan_block || !take(in, block.drift) || !take(in, block.crossings))
    return false;
  block.values.resize(size);
  for (double& x : block.values)
    if (!take(in, x)) return false;
  std::array<char, 64> sum{};
  if (!in.read(sum.data(), sum.size()) || !take(in, mark) || mark != ~block_mark) return false;
  right = std::string(sum.data(), sum.size()) == sha256(bytes_of(number, block));
  return true;
}

} // namespace

ScanJournal::ScanJournal(std::string path, std::string about)
    : path_(std::move(path)),
      head_("kovacic-scan/2\n" + std::to_string(about.size()) + "\n" + about) {}

// whole: how many bytes of the file are whole blocks.
std::map<std::size_t, flow::ScanBlock> ScanJournal::read(const std::string& path,
                                                         std::uintmax_t& whole) const {
  std::map<std::size_t, flow::ScanBlock> blocks;
  std::ifstream in(path, std::ios::binary);
  if (!in) return blocks;
  std::string head(head_.size(), ' ');
  if (!in.read(head.data(), static_cast<std::streamsize>(head.size())) || head != head_)
    throw InputError(path, 0, 0, 1, "this is what another scan has left",
                     "without --resume it is written anew");
  whole = static_cast<std::uintmax_t>(in.tellg());
  for (;;) {
    std::uint64_t number = 0;
    flow::ScanBlock block;
    bool right = false;
    if (!take_block(in, number, block, right)) break;
    if (right) blocks[number] = std::move(block); // else it is computed again
    whole = static_cast<std::uintmax_t>(in.tellg());
  }
  return blocks;
}

std::map<std::size_t, flow::ScanBlock> ScanJournal::kept() const {
  std::uintmax_t whole = 0;
  auto blocks = read(path_, whole);
  if (fs::exists(path_)) fs::resize_file(path_, whole);
  return blocks;
}

std::map<std::size_t, flow::ScanBlock> ScanJournal::kept_in(const std::string& path) const {
  std::uintmax_t whole = 0;
  return read(path, whole);
}

std::vector<std::string> journals_of_parts(const std::string& base) {
  const fs::path path(base), folder = path.has_parent_path() ? path.parent_path() : ".";
  const std::string begin = path.filename().string() + ".", end = ".scan-part";
  std::vector<std::string> all;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(begin) || !name.ends_with(end) || name.size() < begin.size() + end.size())
      continue;
    const std::string part = name.substr(begin.size(), name.size() - begin.size() - end.size());
    const std::size_t of = part.find("-of-");
    const auto is_number = [](const std::string& s) {
      return !s.empty() && s.find_first_not_of("0123456789") == std::string::npos;
    };
    if (of != std::string::npos && is_number(part.substr(0, of)) && is_number(part.substr(of + 4)))
      all.push_back((folder / name).string());
  }
  std::ranges::sort(all);
  return all;
}

void ScanJournal::begin() {
  const bool fresh = !fs::exists(path_);
  out_.open(path_, std::ios::binary | std::ios::app);
  if (fresh) out_ << head_;
  if (!out_) throw InputError(path_, 0, 0, 1, "cannot be written");
}

void ScanJournal::append(std::size_t number, const flow::ScanBlock& block) {
  if (!out_.is_open()) begin();
  std::ostringstream whole;
  const std::string bytes = bytes_of(number, block);
  put(whole, block_mark);
  whole << bytes << sha256(bytes);
  put(whole, ~block_mark);
  out_ << whole.str() << std::flush;
  if (!out_) throw InputError(path_, 0, 0, 1, "cannot be written");
}

void ScanJournal::remove() {
  if (out_.is_open()) out_.close();
  std::error_code ignored;
  fs::remove(path_, ignored);
}

// ---- NumPy ----

namespace {

std::string npy_head(const std::vector<std::size_t>& shape) {
  std::string sizes;
  for (const std::size_t n : shape)
    sizes += std::to_string(n) + ", ";
  std::string head = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + sizes + "), }";
  while ((10 + head.size() + 1) % 64 != 0)
    head += ' ';
  head += '\n';
  std::string all = "\x93NUMPY";
  all += std::string("\x01\x00", 2);
  all += static_cast<char>(head.size() & 0xff);
  all += static_cast<char>(head.size() >> 8);
  return all + head;
}

} // namespace

std::size_t npy_head_size(const std::vector<std::size_t>& shape) { return npy_head(shape).size(); }

void write_npy(const std::string& path, const std::vector<double>& values,
               const std::vector<std::size_t>& shape) {
  write_whole(path, [&](std::ofstream& out) {
    out << npy_head(shape);
    out.write(reinterpret_cast<const char*>(values.data()),
              static_cast<std::streamsize>(values.size() * sizeof(double)));
  });
}

// ---- the picture ----

namespace {

std::vector<std::size_t> shape_of(const ScanPlot& plot) {
  std::vector<std::size_t> shape;
  for (auto axis = plot.axes.rbegin(); axis != plot.axes.rend(); ++axis)
    shape.push_back(axis->count);
  return shape;
}

void print_map(std::ofstream& out, const std::string& name, const ScanPlot& plot) {
  const auto& [x, y] = std::pair(plot.axes[0], plot.axes[1]);
  const auto width = [](const flow::ScanAxis& a) {
    return (a.to.as<double>() - a.from.as<double>()) / static_cast<double>(a.count);
  };
  for (const auto& [axis, letter] : {std::pair{&x, 'x'}, {&y, 'y'}})
    fmt::print(out, "set {}range [{:.17g}:{:.17g}]\n", letter, axis->from.as<double>(),
               axis->to.as<double>());
  fmt::print(out, "{}set cblabel {} noenhanced\n", gnuplot_colours(plot.colours.logarithmic),
             gnuplot_quoted(plot.label));
  if (!plot.colours.logarithmic)
    fmt::print(out, "set cbrange [{:.6g}:{:.6g}]\n", plot.colours.low, plot.colours.high);
  fmt::print(out, "set object 1 rectangle from graph 0,0 to graph 1,1 fillcolor rgb \"#e0e0e0\" "
                  "fillstyle solid noborder behind\n");
  fmt::print(out,
             "plot {} binary skip={} array=({},{}) format=\"%float64\" origin=({:.17g},{:.17g}) "
             "dx={:.17g} dy={:.17g} using (abs($1) < 1e300 ? $1 : NaN) with image notitle\n",
             gnuplot_quoted(name + ".npy"), npy_head_size(shape_of(plot)), x.count, y.count,
             scanned_value(x, 0), scanned_value(y, 0), width(x), width(y));
}

void print_curve(std::ofstream& out, const std::string& name, const ScanPlot& plot) {
  const flow::ScanAxis& x = plot.axes[0];
  fmt::print(out, "set ylabel {} noenhanced\n{}", gnuplot_quoted(plot.label),
             plot.colours.logarithmic ? "set logscale y\n" : "");
  fmt::print(
      out,
      "plot {} binary skip={} record=({}) format=\"%float64\" using ({:.17g} + $0*({:.17g})):"
      "(abs($1) < 1e300 ? $1 : NaN) with linespoints pt 7 ps 0.3 lc rgb \"#5b1d72\" notitle\n",
      gnuplot_quoted(name + ".npy"), npy_head_size(shape_of(plot)), x.count, scanned_value(x, 0),
      scanned_value(x, 1) - scanned_value(x, 0));
}

} // namespace

std::vector<std::string> draw_scan(const std::string& base, const ScanPlot& plot,
                                   const std::vector<std::string>& formats) {
  const std::string name = fs::path(base).filename().string();
  std::ofstream out(base + ".gp");
  fmt::print(out, "# gnuplot -e \"format='pdf'\" {}    (png, svg, pdf)\n{}",
             gnuplot_quoted(name + ".gp"), gnuplot_terminal(name, 960, 760));
  print_words(out, plot.title, plot.caption);
  fmt::print(out, "set lmargin 11\nset rmargin {}\n", plot.axes.size() == 2 ? 18 : 4);
  fmt::print(out, "set xlabel {}\nset tics out nomirror\n",
             gnuplot_quoted(axis_label(plot.axes[0].name)));
  if (plot.axes.size() == 2) {
    fmt::print(out, "set ylabel {}\n", gnuplot_quoted(axis_label(plot.axes[1].name)));
    print_map(out, name, plot);
  } else {
    print_curve(out, name, plot);
  }
  close_file(out, base + ".gp");
  return run_gnuplot(base, formats);
}

} // namespace kov::cli
