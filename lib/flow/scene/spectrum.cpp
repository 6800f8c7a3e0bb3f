#include "flow/scene/spectrum.hpp"

#include <algorithm>
#include <cmath>

namespace kov::flow {
namespace {

constexpr double least_parts = 256;  // of the time
constexpr double steps_of_part = 24; // a part of the time has about so many steps
constexpr double most_apart = 24;    // log of how much two deviations may grow apart in a part
constexpr double error_of_part =
    1e-4; // of what is left of the one that grows least, by the tolerance
constexpr double log_of_10 = 2.302585092994046;

// The ends of the copies of an orbit, each with its deviation.
struct Ends : FieldSink<double> {
  Ends(std::size_t copies, std::size_t all)
      : x(copies, std::vector<double>(all)), log_factor(copies) {}
  bool crossing(std::size_t, const double&, const double*, bool) override { return true; }
  void look(std::size_t, const double*) override {}
  double section_noise(std::size_t, const double*, const double&) override { return 0; }
  void ends_at(std::size_t orbit, const double* at, double log) override {
    std::copy_n(at, x[orbit].size(), x[orbit].begin());
    log_factor[orbit] = log;
  }
  void finished(std::size_t, const FieldFinish<double>& f) override {
    whole = whole && f.ended == Ended::time;
  }
  std::vector<std::vector<double>> x;
  std::vector<double> log_factor;
  bool whole = true;
};

using Vectors = std::vector<std::vector<double>>;

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

// Makes the vectors orthonormal, twice where much cancels; r[i][j]: of vector j in the direction of i, j >= i.
Vectors make_orthonormal(Vectors& v) {
  const std::size_t k = v.size();
  Vectors r(k, std::vector<double>(k));
  for (std::size_t j = 0; j < k; ++j) {
    for (int again = 0; again < 2; ++again)
      for (std::size_t i = 0; i < j; ++i) {
        const double part = dot(v[i], v[j]);
        r[i][j] += part;
        for (std::size_t c = 0; c < v[j].size(); ++c)
          v[j][c] -= part * v[i][c];
      }
    r[j][j] = std::sqrt(dot(v[j], v[j]));
    for (double& c : v[j])
      c /= r[j][j];
  }
  return r;
}

// The exponents and what became of deviations that were never made orthogonal.
class Account {
public:
  explicit Account(std::size_t k) : growth_(k), logs_(k), directions_(k), lengths_(k) {
    for (std::size_t i = 0; i < k; ++i) {
      growth_[i].begin(0);
      directions_[i].assign(i + 1, 0);
      directions_[i][i] = 1;
    }
  }

  // log_unit[j]: of vector j before it was made orthonormal.
  void add(double time, long steps, const Vectors& r, const std::vector<double>& log_unit) {
    for (std::size_t i = 0; i < logs_.size(); ++i) {
      logs_[i] += std::log(r[i][i]) + log_unit[i];
      growth_[i].step(time, logs_[i], steps);
    }
    for (std::size_t j = 1; j < directions_.size(); ++j)
      carry(directions_[j], lengths_[j], r, log_unit);
    lengths_[0] = logs_[0];
  }

  [[nodiscard]] Spectrum spectrum() const {
    Spectrum s;
    double volume = 0;
    for (std::size_t i = 0; i < logs_.size(); ++i) {
      const Indicators one = growth_[i].indicators();
      s.exponents.push_back({one.lyapunov, one.lyapunov_error});
      volume += logs_[i] - lengths_[i];
      if (i > 0) s.log_gali.push_back(volume / log_of_10);
      if (i == 1) { // 2 sin(a/2) for the angle a with this sine
        const double sine = std::min(1.0, std::exp(volume));
        s.log_sali =
            sine < 1e-100 ? volume / log_of_10 : std::log10(2 * std::sin(std::asin(sine) / 2));
      }
    }
    // where two are equal but for their bars, the order of the run is one of many
    std::stable_sort(s.exponents.begin(), s.exponents.end(),
                     [](const auto& a, const auto& b) { return a.rate > b.rate; });
    return s;
  }

private:
  static void carry(std::vector<double>& c, double& length, const Vectors& r,
                    const std::vector<double>& log_unit) {
    const double unit = *std::ranges::max_element(log_unit);
    std::vector<double> next(c.size());
    for (std::size_t j = 0; j < c.size(); ++j)
      for (std::size_t i = 0; i <= j; ++i)
        next[i] += r[i][j] * c[j] * std::exp(log_unit[j] - unit);
    const double size = std::sqrt(dot(next, next));
    for (double& x : next)
      x /= size;
    length += std::log(size) + unit;
    c = std::move(next);
  }

  std::vector<Growth> growth_;
  std::vector<double> logs_;
  Vectors directions_;          ///< of each deviation, in terms of the orthonormal ones
  std::vector<double> lengths_; ///< logarithms
};

std::vector<MFraction> gradients_of(const SystemScene& s, const Field& f) {
  std::vector<MFraction> all;
  for (std::size_t i = f.coordinates(); i < f.variables().size(); ++i)
    for (const FunctionSymbol& symbol : s.system.field.functions)
      if (symbol.variable == f.variables()[i])
        all.insert(all.end(), symbol.gradient.begin(), symbol.gradient.end());
  return all;
}

} // namespace

struct SpectrumRun::Parts {
  const Stage& stage;
  std::size_t k;
  std::unique_ptr<Field> field;
  Tapes<double> tapes;
  StartRefiner<double> refine;
  Evaluator<double> gradients;
  std::size_t n = field->coordinates(), all = field->variables().size();

  Parts(const Stage& s, std::size_t deviations)
      : stage(s), k(deviations), field(s.field_alone(true)), tapes(*field, s.order),
        refine(s.scene, *field), gradients(*field, gradients_of(s.scene, *field)) {}

  // x with each deviation: of the coordinates in units of their scales, of the functions by their gradients.
  std::vector<double> copies(const std::vector<double>& x, const Vectors& v) {
    const std::vector<double> gradient = gradients(x.data());
    std::vector<double> out;
    for (const std::vector<double>& one : v) {
      out.insert(out.end(), x.begin(), x.begin() + static_cast<std::ptrdiff_t>(all));
      const std::size_t first = out.size();
      for (std::size_t j = 0; j < n; ++j)
        out.push_back(one[j] / stage.per_scale[j]);
      for (std::size_t i = 0; i + n < all; ++i) {
        double d = 0;
        for (std::size_t j = 0; j < n; ++j)
          d += gradient[i * n + j] * out[first + j];
        out.push_back(d);
      }
    }
    return out;
  }

  bool follow(const std::vector<double>& starts, double time, Ends& ends,
              const std::atomic<bool>* stop) {
    FieldRun<double> run;
    run.log2_tolerance = stage.log2_tolerance();
    run.order = stage.order;
    run.t_end = time;
    run.check_every = -1;
    run.section = false;
    run.per_scale = stage.per_scale.data();
    run.values = tapes.values();
    run.starts = starts.data();
    run.orbits = k;
    run.stop = stop;
    run.sink = &ends;
    integrate_field(tapes.tapes(), run, k <= 1 ? 1 : k <= 4 ? 4 : 0);
    return ends.whole;
  }

  Vectors deviations_at(const Ends& ends) const {
    Vectors v(k, std::vector<double>(n));
    for (std::size_t j = 0; j < k; ++j)
      for (std::size_t c = 0; c < n; ++c)
        v[j][c] = ends.x[j][all + c] * stage.per_scale[c];
    return v;
  }

  // Any directions will do, but none of a symmetry.
  Vectors begin() const {
    Vectors v(k, std::vector<double>(n));
    for (std::size_t j = 0; j < k; ++j)
      for (std::size_t c = 0; c < n; ++c)
        v[j][c] =
            std::cos(1 + 2.4 * static_cast<double>(c) + 1.7 * static_cast<double>(j * (c + 1)));
    make_orthonormal(v);
    return v;
  }
};

SpectrumRun::SpectrumRun(const Stage& stage, std::size_t deviations)
    : parts_(new Parts(stage, std::min(deviations, stage.field.coordinates()))) {}
SpectrumRun::~SpectrumRun() = default;

Spectrum SpectrumRun::operator()(std::size_t start, double time, long steps,
                                 const std::atomic<bool>* stop) {
  Parts& p = *parts_;
  if (!(time > 0) || p.k == 0) return {};
  std::vector<double> x = p.refine(p.stage.starts[start]);
  Vectors v = p.begin();
  Account account(p.k);
  const double longest = time / least_parts;
  // Copies of a chaotic orbit part like its deviations do, and then what grows most is not the same in all of them: what is
  // left of the deviation that grows least loses twice the digits by which they are apart.
  const double apart = std::clamp(
      (std::log(error_of_part) - p.stage.log2_tolerance() * std::log(2.0)) / 2, 2.0, most_apart);
  double part = std::min(longest, time * steps_of_part / static_cast<double>(std::max(1L, steps)));
  double done = 0;
  while (done < time * (1 - 1e-12)) {
    const double now = std::min(part, time - done);
    Ends ends(p.k, p.all + p.field->tangent());
    if (!p.follow(p.copies(x, v), now, ends, stop)) return {};
    Vectors grown = p.deviations_at(ends);
    const Vectors r = make_orthonormal(grown);
    std::vector<double> logs;
    for (std::size_t i = 0; i < p.k; ++i)
      logs.push_back(std::log(r[i][i]) + ends.log_factor[i]);
    const auto [least, most] = std::minmax_element(logs.begin(), logs.end());
    if (!std::isfinite(*most - *least)) return {};
    if (*most - *least > apart && part > longest * 0x1p-20) {
      part = now / 2;
      continue;
    }
    account.add(now, std::lround(static_cast<double>(steps) * now / time), r, ends.log_factor);
    if (*most - *least < apart / 4) part = std::min(longest, 2 * part);
    v = std::move(grown);
    x = ends.x.front();
    done += now;
  }
  return account.spectrum();
}

} // namespace kov::flow
