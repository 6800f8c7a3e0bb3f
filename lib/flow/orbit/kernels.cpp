#include "flow/orbit/kernel_table.hpp"

#include "exact/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace kov::flow {
namespace entry {
void integrate_baseline(std::size_t, int, const Model<double>&, bool, const Run<double>&);
void integrate_avx2(std::size_t, int, const Model<double>&, bool, const Run<double>&);
void integrate_avx512(std::size_t, int, const Model<double>&, bool, const Run<double>&);
void integrate_baseline(std::size_t, int, const Model<Twin1>&, bool, const Run<Twin1>&);
void integrate_avx2(std::size_t, int, const Model<Twin1>&, bool, const Run<Twin1>&);
void integrate_avx512(std::size_t, int, const Model<Twin1>&, bool, const Run<Twin1>&);
} // namespace entry

namespace {

std::size_t set_of(const Effects& e) {
  const std::size_t set = effect_index(e);
  if (set == effect_sets.size()) throw InvalidArgument("this set of effects is not compiled");
  return set;
}

void check_order(int order) {
  if (order < 4 || order > max_degree)
    throw InvalidArgument("the order of the Taylor steps must be 4 to " +
                          std::to_string(max_degree) + ", not " + std::to_string(order));
}

template <class R>
void dispatch(const Effects& e, const Model<R>& model, bool sliding, const Run<R>& run, int lanes,
              Isa isa) {
  check_order(run.order);
  const std::size_t set = std::is_same_v<R, Twin1> ? coarse_index(e) : set_of(e);
  isa = std::min(isa, best_isa());
  if (lanes == 0) lanes = best_lanes(isa);
#if defined(__x86_64__)
  if (isa == Isa::avx512) return entry::integrate_avx512(set, lanes, model, sliding, run);
  if (isa == Isa::avx2) return entry::integrate_avx2(set, lanes, model, sliding, run);
#endif
  entry::integrate_baseline(set, lanes, model, sliding, run);
}

} // namespace

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

void integrate(const Effects& e, const Model<double>& model, bool sliding, const Run<double>& run,
               int lanes, Isa isa) {
  dispatch(e, model, sliding, run, lanes, isa);
}

void integrate(const Effects& e, const Model<Twin1>& model, bool sliding, const Run<Twin1>& run,
               int lanes, Isa isa) {
  dispatch(e, model, sliding, run, lanes, isa);
}

void integrate(const Effects& e, const Model<long double>& model, bool sliding,
               const Run<long double>& run) {
  check_order(run.order);
  std::vector<long double> storage(storage_size<long double>(run.order));
  integrate_with<long double>(set_of(e), model, sliding, run, storage.data());
}

namespace {

// For one orbit: log2 of ||x_k|| as the stepper measures it, k = 0 ... most.
std::vector<double> log2_sizes(const Jet<double>& jet, int most) {
  double spin = 1e-100;
  for (int i = 0; i < 3; ++i)
    spin = std::max(spin, std::abs(jet.s[i][0]));
  std::vector<double> sizes;
  for (int k = 0; k <= most; ++k) {
    double size = 1e-300;
    for (int i = 0; i < 3; ++i)
      size = std::max({size, std::abs(jet.s[i][k]) / spin, std::abs(jet.s[3 + i][k])});
    sizes.push_back(std::log2(size));
  }
  return sizes;
}

// Work for a unit of time with steps of order p: p^2 for the products, 6 p for what is done once in
// each order, 40 for what is done once in a step.
double work(const std::vector<double>& log2_size, int p, double log2_tolerance) {
  const double reach = log2_reach(log2_tolerance, log2_estimate(unit_roundoff<double>()));
  double log_h = std::min(reach - log2_size[1], reach - (log2_size[2] + 1) / 2);
  for (const int k : {p - 1, p})
    log_h = std::min(log_h, (log2_tolerance - log2_size[static_cast<std::size_t>(k)]) / k);
  return (p * (p + 6.0) + 40.0) * std::exp2(-log_h);
}

} // namespace

int choose_order(const Effects& e, const Model<double>& model, const double* starts,
                 std::size_t orbits, double log2_tolerance) {
  const std::size_t set = set_of(e);
  const int expected = static_cast<int>(-0.35 * log2_tolerance) + 2; // -ln(epsilon)/2 + 2
  const int least = std::max(4, expected / 2), most = std::clamp(2 * expected, 8, max_degree);
  std::vector<double> storage(storage_size<double>(most));
  Jet<double> jet{};
  for (int i = 0; i < Jet<double>::count; ++i)
    jet.s[i] = storage.data() + i * (most + 2);
  std::vector<double> cost(static_cast<std::size_t>(most) + 1, 0.0);
  for (std::size_t s = 0; s < orbits; ++s) {
    for (int i = 0; i < 3; ++i) {
      const int inner = (i + 3 - model.shift) % 3;
      jet.s[inner][0] = starts[6 * s + i];
      jet.s[3 + inner][0] = starts[6 * s + 3 + i];
    }
    kernel_table<double>.of[set].jets(model, jet, most);
    const std::vector<double> sizes = log2_sizes(jet, most);
    for (int p = least; p <= most; ++p)
      cost[static_cast<std::size_t>(p)] += work(sizes, p, log2_tolerance);
  }
  return static_cast<int>(std::min_element(cost.begin() + least, cost.end()) - cost.begin());
}

} // namespace kov::flow
