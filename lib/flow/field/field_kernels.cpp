#include "flow/field/field_kernels.hpp"

#include "exact/error.hpp"
#include "flow/field/machine_code.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace kov::flow {
namespace entry {
void integrate_field_baseline(int, const FieldTapes<double>&, const FieldRun<double>&);
void integrate_field_avx2(int, const FieldTapes<double>&, const FieldRun<double>&);
void integrate_field_avx512(int, const FieldTapes<double>&, const FieldRun<double>&);
void integrate_field_baseline(const FieldTapes<Twin1>&, const FieldRun<Twin1>&);
void integrate_field_avx2(const FieldTapes<Twin1>&, const FieldRun<Twin1>&);
void integrate_field_avx512(const FieldTapes<Twin1>&, const FieldRun<Twin1>&);
} // namespace entry

namespace {

Isa isa_of_processor() {
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    return Isa::avx512;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return Isa::avx2;
#endif
  return Isa::baseline;
}

Isa isa_allowed() {
  const char* name = std::getenv("KOVACIC_ISA");
  const std::string word = name == nullptr ? "" : name;
  return word == "baseline" ? Isa::baseline : word == "avx2" ? Isa::avx2 : Isa::avx512;
}

} // namespace

Isa best_isa() {
  static const Isa best = std::min(isa_of_processor(), isa_allowed());
  return best;
}

int best_lanes(Isa isa) { return isa == Isa::avx512 ? 8 : isa == Isa::avx2 ? 4 : 1; }

std::string to_string(Isa isa) {
  return isa == Isa::avx512 ? "AVX-512" : isa == Isa::avx2 ? "AVX2" : "baseline";
}

namespace {

template <class R> void check_order(const FieldRun<R>& run) {
  if (run.order < 4 || run.order > max_degree)
    throw InvalidArgument("the order of the Taylor steps must be 4 to " +
                          std::to_string(max_degree));
}

template <class R> void in_one_lane(const FieldTapes<R>& tapes, const FieldRun<R>& run) {
  check_order(run);
  std::vector<R> storage(FieldStepper<R>::storage_size(tapes));
  FieldStepper<R>(tapes, run, storage.data()).integrate();
}

void integrate_in(Isa isa, int lanes, const FieldTapes<double>& tapes,
                  const FieldRun<double>& run) {
#if defined(__x86_64__)
  if (isa == Isa::avx512) return entry::integrate_field_avx512(lanes, tapes, run);
  if (isa == Isa::avx2) return entry::integrate_field_avx2(lanes, tapes, run);
#endif
  static_cast<void>(isa);
  entry::integrate_field_baseline(lanes, tapes, run);
}

// The tapes with code of the processor, where there is some for packs of this size.
class NativeTapes {
public:
  NativeTapes(const FieldTapes<double>& tapes, int order, int lanes, Isa isa) : tapes_(tapes) {
    if (!((lanes == 4 && isa >= Isa::avx2) || (lanes == 8 && isa >= Isa::avx512))) return;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> moving;
    for (std::size_t m = 0; m < tapes.moving_count; ++m)
      moving.emplace_back(tapes.moving[m], tapes.derivatives[m]);
    const MachineCode::Moving still;
    code_.emplace_back(tapes.field, moving, lanes, 0, order);
    code_.emplace_back(tapes.section, still, lanes, 0, order);
    code_.emplace_back(tapes.last, still, lanes, order, order + 1);
    code_.emplace_back(tapes.followers, still, lanes, order, order + 1);
    tapes_.field.code = code_[0].code();
    tapes_.section.code = code_[1].code();
    tapes_.last.code = code_[2].code();
    tapes_.followers.code = code_[3].code();
  }
  [[nodiscard]] const FieldTapes<double>& tapes() const { return tapes_; }

private:
  FieldTapes<double> tapes_;
  std::vector<MachineCode> code_;
};

} // namespace

void integrate_field(const FieldTapes<double>& tapes, const FieldRun<double>& run, int lanes,
                     Isa isa) {
  check_order(run);
  isa = std::min(isa, best_isa());
  if (lanes == 0) lanes = best_lanes(isa);
  lanes = lanes <= 1 ? 1 : lanes <= 4 ? 4 : 8;
  const NativeTapes native(tapes, run.order, run.native ? lanes : 1, isa);
  integrate_in(isa, lanes, native.tapes(), run);
}

void integrate_field(const FieldTapes<Twin1>& tapes, const FieldRun<Twin1>& run, int, Isa isa) {
  check_order(run);
  isa = std::min(isa, best_isa());
#if defined(__x86_64__)
  if (isa == Isa::avx512) return entry::integrate_field_avx512(tapes, run);
  if (isa == Isa::avx2) return entry::integrate_field_avx2(tapes, run);
#endif
  entry::integrate_field_baseline(tapes, run);
}

void integrate_field(const FieldTapes<long double>& tapes, const FieldRun<long double>& run) {
  in_one_lane(tapes, run);
}
void integrate_field(const FieldTapes<BigReal>& tapes, const FieldRun<BigReal>& run) {
  in_one_lane(tapes, run);
}

namespace {

// The series of one orbit after another, at states that the caller gives.
class Probe {
public:
  Probe(const Field& f, int order)
      : order_(order), kept_(f, order), n_(f.variables().size()),
        storage_(FieldStepper<double>::storage_size(kept_.tapes())) {
    const FieldTapes<double>& t = kept_.tapes();
    for (std::size_t i = 0; i < t.values; ++i)
      storage_[(n_ + t.tangent + i) * stride()] = kept_.values()[i];
    run_once(t.field, storage_.data());
  }

  void at(const double* x) {
    const FieldTapes<double>& t = kept_.tapes();
    for (std::size_t i = 0; i < n_; ++i)
      storage_[i * stride()] = x[i];
    for (int k = 0; k < order_; ++k) {
      run_order(t.field, storage_.data(), k);
      for (std::size_t m = 0; m < t.moving_count; ++m)
        storage_[t.moving[m] + static_cast<std::size_t>(k) + 1] =
            storage_[t.derivatives[m] + static_cast<std::size_t>(k)] / (k + 1);
    }
    run_order(t.followers, storage_.data(), order_);
  }

  // log2 of ||x_k|| in units of the scales
  [[nodiscard]] double log2_size(int k, const std::vector<double>& scale) const {
    double most = 1e-300;
    for (std::size_t i = 0; i < n_; ++i)
      most = std::max(most, std::abs(storage_[i * stride() + static_cast<std::size_t>(k)]) /
                                std::max(scale[i], std::abs(storage_[i * stride()])));
    return std::log2(most);
  }

  [[nodiscard]] double log2_step(int p, double log2_tolerance,
                                 const std::vector<double>& scale) const {
    const double reach = log2_reach(log2_tolerance, log2_estimate(unit_roundoff<double>()));
    double log_h = std::min(reach - log2_size(1, scale), reach - (log2_size(2, scale) + 1) / 2);
    for (const int k : {p - 1, p})
      log_h = std::min(log_h, (log2_tolerance - log2_size(k, scale)) / k);
    double rate = -2000; // as in FieldStepper::log2_careful_step
    for (int k = p / 2; k <= p; ++k)
      rate = std::max(rate, log2_size(k, scale) / k);
    return std::min(log_h, log2_tolerance / p - rate + 0.5);
  }

  [[nodiscard]] double moved(std::size_t i, double h) const {
    const double* x = storage_.data() + i * stride();
    return x[0] + increment(x, order_, h);
  }

private:
  [[nodiscard]] std::size_t stride() const { return static_cast<std::size_t>(order_) + 1; }
  int order_;
  Tapes<double> kept_;
  std::size_t n_;
  std::vector<double> storage_;
};

constexpr int pilot_order = 16, pilot_steps = 300, path_every = 10;
constexpr std::size_t pilot_orbits = 8;
constexpr double pilot_tolerance = -40, far_away = 1024;

// Grows the scales along the orbit from x; one that flies away is not followed far.
void follow(Probe& probe, std::vector<double> x, double t_end, const std::vector<double>& begun,
            Scales& s) {
  double t = 0;
  for (int step = 0; step < pilot_steps && t < t_end; ++step) {
    if (step % path_every == 0) s.path.insert(s.path.end(), x.begin(), x.end());
    probe.at(x.data());
    const double h =
        std::min(std::exp2(probe.log2_step(pilot_order, pilot_tolerance, s.of)), t_end - t);
    t += h;
    if (!(h > 0) || !std::isfinite(h)) return;
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = probe.moved(i, h);
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!(std::abs(x[i]) <= far_away * begun[i])) return;
      s.of[i] = std::max(s.of[i], std::abs(x[i]));
    }
  }
}

} // namespace

Scales scales_of(const Field& f, const std::vector<double>& starts, double t_end) {
  const std::size_t n = f.variables().size(), orbits = starts.size() / n;
  Scales s;
  s.of.assign(n, 0);
  for (std::size_t i = 0; i < starts.size(); ++i)
    s.of[i % n] = std::max(s.of[i % n], std::abs(starts[i]));
  const double largest = std::max(*std::ranges::max_element(s.of), 1e-100);
  const std::vector<double> at_start = s.of;
  for (double& size : s.of)
    size = size > 1e-14 * largest ? size : largest; // what rounding leaves of 0 is not a scale
  std::vector<double> begun =
      s.of; // a small number may be what a start near 0 has left: it may grow
  for (double& size : begun)
    size = size > largest / far_away ? size : largest;
  Probe probe(f, pilot_order);
  const std::size_t every = std::max<std::size_t>(1, orbits / pilot_orbits);
  for (std::size_t i = 0; i < orbits; i += every)
    follow(probe,
           {starts.begin() + static_cast<long>(i * n),
            starts.begin() + static_cast<long>((i + 1) * n)},
           t_end, begun, s);
  std::vector<double> seen = at_start;
  for (std::size_t i = 0; i < s.path.size(); ++i)
    seen[i % n] = std::max(seen[i % n], std::abs(s.path[i]));
  for (std::size_t i = 0; i < n; ++i)
    s.of[i] = std::exp2(std::round(std::log2(seen[i] > 0 ? seen[i] : largest)));
  return s;
}

int choose_order(const Field& f, const Scales& scales, double log2_tolerance) {
  const int expected = static_cast<int>(-0.35 * log2_tolerance) + 2; // -ln(epsilon)/2 + 2
  const int least = std::max(4, expected / 2), most = std::clamp(2 * expected, 8, max_degree);
  const std::size_t n = f.variables().size(), states = scales.path.size() / n;
  Probe probe(f, most);
  std::vector<double> work(static_cast<std::size_t>(most) + 1, 0.0);
  const double products = std::max(f.cost(), 0.5);
  for (std::size_t i = 0; i < states; i += std::max<std::size_t>(1, states / 32)) {
    probe.at(scales.path.data() + i * n);
    for (int p = least; p <= most; ++p) {
      // in units of one product: the convolutions, what is done once in an order, and once in a step
      const double step = p * (p / 2.0 * products + 4.0 * static_cast<double>(n) + 8) +
                          40.0 * static_cast<double>(n);
      work[static_cast<std::size_t>(p)] +=
          step * std::exp2(-probe.log2_step(p, log2_tolerance, scales.of));
    }
  }
  return static_cast<int>(std::min_element(work.begin() + least, work.end()) - work.begin());
}

} // namespace kov::flow
