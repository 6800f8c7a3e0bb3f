// kovacic-effects [COUNT KERNEL]: what an effect costs, and that an absent one costs nothing.
//
// Without arguments: nanoseconds of the Taylor jets of order 25 for each compiled set of effects,
// and next to three of them a kernel written by hand for exactly that motion, which never knew of
// any other effect. With arguments: runs one kernel COUNT times and nothing else, for counting
// instructions (tools/bench/effects):
//   kovacic-effects 1000 free | free-by-hand | heavy | heavy-by-hand | sliding | sliding-by-hand

#define KOV_ISA bench
#include "flow/orbit/kernel_table.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

namespace {

using namespace kov::flow;
using Pack = Pack4;
constexpr int order = 25;
using Recurrence = void (*)(const Model<Pack>&, const Jet<Pack>&, int);

// Gamma x Omega of order k, and Omega_i Omega_j.
struct Products {
  Pack g1{}, g1n{}, g2{}, g2n{}, g3{}, g3n{}, y1{}, y2{}, y3{};
};

// The free top: Euler's equations and Poisson's.
void free_by_hand(const Model<Pack>& c, const Jet<Pack>& j, int p) {
  Pack *o1 = j.s[0], *o2 = j.s[1], *o3 = j.s[2], *g1 = j.s[3], *g2 = j.s[4], *g3 = j.s[5];
  for (int k = 0; k < p; ++k) {
    Products s;
    for (int a = 0; a <= k; ++a) {
      const int b = k - a;
      add_product(s.g1, g2[a], o3[b]);
      add_product(s.g1n, g3[a], o2[b]);
      add_product(s.g2, g3[a], o1[b]);
      add_product(s.g2n, g1[a], o3[b]);
      add_product(s.g3, g1[a], o2[b]);
      add_product(s.g3n, g2[a], o1[b]);
      add_product(s.y1, o2[a], o3[b]);
      add_product(s.y2, o3[a], o1[b]);
      add_product(s.y3, o1[a], o2[b]);
    }
    const double rate = 1.0 / (k + 1);
    o1[k + 1] = c.euler[0] * s.y1 * rate;
    o2[k + 1] = c.euler[1] * s.y2 * rate;
    o3[k + 1] = c.euler[2] * s.y3 * rate;
    g1[k + 1] = (s.g1 - s.g1n) * rate;
    g2[k + 1] = (s.g2 - s.g2n) * rate;
    g3[k + 1] = (s.g3 - s.g3n) * rate;
  }
}

// The heavy top with a fixed tip, L on the first axis.
void heavy_by_hand(const Model<Pack>& c, const Jet<Pack>& j, int p) {
  Pack *o1 = j.s[0], *o2 = j.s[1], *o3 = j.s[2], *g1 = j.s[3], *g2 = j.s[4], *g3 = j.s[5];
  for (int k = 0; k < p; ++k) {
    Products s;
    for (int a = 0; a <= k; ++a) {
      const int b = k - a;
      add_product(s.g1, g2[a], o3[b]);
      add_product(s.g1n, g3[a], o2[b]);
      add_product(s.g2, g3[a], o1[b]);
      add_product(s.g2n, g1[a], o3[b]);
      add_product(s.g3, g1[a], o2[b]);
      add_product(s.g3n, g2[a], o1[b]);
      add_product(s.y1, o2[a], o3[b]);
      add_product(s.y2, o3[a], o1[b]);
      add_product(s.y3, o1[a], o2[b]);
    }
    const double rate = 1.0 / (k + 1);
    o1[k + 1] = c.euler[0] * s.y1 * rate;
    o2[k + 1] = (c.euler[1] * s.y2 + c.g_alpha * g3[k]) * rate;
    o3[k + 1] = (c.euler[2] * s.y3 - c.g_beta * g2[k]) * rate;
    g1[k + 1] = (s.g1 - s.g1n) * rate;
    g2[k + 1] = (s.g2 - s.g2n) * rate;
    g3[k + 1] = (s.g3 - s.g3n) * rate;
  }
}

// The sliding top without gravity, L on the first axis: w = Gamma_1', q = Gamma_1'', D = 1 + m
// v.I^-1 v.
void sliding_by_hand(const Model<Pack>& c, const Jet<Pack>& j, int p) {
  Pack *o1 = j.s[0], *o2 = j.s[1], *o3 = j.s[2], *g1 = j.s[3], *g2 = j.s[4], *g3 = j.s[5];
  Pack *y2 = j.s[6], *y3 = j.s[7], *r2 = j.s[8], *r3 = j.s[9], *q = j.s[10], *d = j.s[11],
       *w = j.s[12];
  w[0] = g2[0] * o3[0] - g3[0] * o2[0];
  Pack inverse{};
  for (int k = 0; k < p; ++k) {
    Pack s2{}, s2n{}, s3{}, s3n{}, t1{}, t2{}, t3{}, aa{}, bb{}, ra{}, rb{}, sa{}, sb{}, qd{}, qa{},
        qb{};
    const auto state = [&](int a, int b) {
      add_product(s2, g3[a], o1[b]);
      add_product(s2n, g1[a], o3[b]);
      add_product(s3, g1[a], o2[b]);
      add_product(s3n, g2[a], o1[b]);
      add_product(t1, o2[a], o3[b]);
      add_product(t2, o3[a], o1[b]);
      add_product(t3, o1[a], o2[b]);
      add_product(aa, g3[a], g3[b]);
      add_product(bb, g2[a], g2[b]);
    };
    d[k] = Pack{};
    for (int a = 0; a < k; ++a) {
      const int b = k - a;
      state(a, b);
      add_product(ra, r3[a], o2[b]);
      add_product(rb, r2[a], o3[b]);
      add_product(sa, y2[a], g3[b]);
      add_product(sb, y3[a], g2[b]);
      add_product(qd, q[a], d[b]);
      add_product(qa, q[a], g3[b]);
      add_product(qb, q[a], g2[b]);
    }
    state(k, 0);
    const double rate = 1.0 / (k + 1);
    r2[k] = s2 - s2n;
    r3[k] = s3 - s3n;
    const Pack y1 = c.euler[0] * t1;
    y2[k] = c.euler[1] * t2;
    y3[k] = c.euler[2] * t3;
    add_product(ra, r3[k], o2[0]);
    add_product(rb, r2[k], o3[0]);
    add_product(sa, y2[k], g3[0]);
    add_product(sb, y3[k], g2[0]);
    d[k] = c.c_alpha * aa;
    add_product(d[k], c.c_beta, bb);
    Pack r = (rb + sb) - (ra + sa) - qd;
    if (k == 0) {
      d[0] = d[0] + 1.0;
      inverse = 1.0 / d[0];
    } else {
      sub_product(r, q[0], d[k]);
    }
    q[k] = r * inverse;
    add_product(qa, q[k], g3[0]);
    add_product(qb, q[k], g2[0]);
    w[k + 1] = q[k] * rate;
    o1[k + 1] = y1 * rate;
    o2[k + 1] = (y2[k] + c.c_alpha * qa) * rate;
    o3[k + 1] = (y3[k] - c.c_beta * qb) * rate;
    g1[k + 1] = w[k] * rate;
    g2[k + 1] = r2[k] * rate;
    g3[k + 1] = r3[k] * rate;
  }
}

struct Named {
  const char* name;
  Effects effects;
  Recurrence by_hand;
};
const Named named[] = {{"free", {false, false, false, false, false}, free_by_hand},
                       {"heavy", {true, false, false, false, true}, heavy_by_hand},
                       {"sliding", {false, true, false, false, true}, sliding_by_hand}};

// A body and a point that have everything, and the memory for one jet.
struct Bench {
  Model<Pack> model;
  Jet<Pack> jet{};
  Pack* memory;
  explicit Bench(const Effects& e) {
    Body<double> b;
    b.inertia = {{{1, 0, 0}, {0, 2.0 / 3, 0}, {0, 0, 0.5}}};
    b.lever = {0.5, e.axial ? 0.0 : 0.25, e.axial ? 0.0 : 0.125};
    b.gravity = e.gravity ? 1 : 0;
    b.sliding = e.sliding;
    model = widen<Pack>(model_of(b, e));
    const std::size_t bytes = storage_size<Pack>(order) * sizeof(Pack);
    memory = static_cast<Pack*>(std::aligned_alloc(64, (bytes + 63) / 64 * 64));
    std::fill_n(memory, storage_size<Pack>(order), Pack{});
    for (int i = 0; i < Jet<Pack>::count; ++i)
      jet.s[i] = memory + static_cast<std::ptrdiff_t>(i) * (order + 2);
    for (int i = 0; i < 6; ++i)
      jet.s[i][0] = Pack{} + (0.3 + 0.1 * i);
  }
  ~Bench() { std::free(memory); }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;
  void run(Recurrence f, int count) const {
    for (int i = 0; i < count; ++i)
      f(model, jet, order);
  }
};

// The best of 15 times, in nanoseconds for one pack; both in turn, so that a change of clock hits
// both.
void compare(const Bench& bench, Recurrence a, Recurrence b, double& ta, double& tb) {
  constexpr int count = 4000;
  ta = tb = 1e300;
  const auto once = [&](Recurrence f) {
    const std::clock_t begun = std::clock();
    bench.run(f, count);
    return 1e9 * static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC / count;
  };
  for (int i = 0; i < 15; ++i) {
    ta = std::min(ta, once(a));
    if (b != nullptr) tb = std::min(tb, once(b));
  }
}

int count_mode(int count, const std::string& which) {
  for (const Named& n : named) {
    const bool by_hand = which == std::string(n.name) + "-by-hand";
    if (which != n.name && !by_hand) continue;
    const Bench bench(n.effects);
    bench.run(by_hand ? n.by_hand : kernel_table<Pack>.of[effect_index(n.effects)].jets, count);
    return 0;
  }
  std::fprintf(stderr, "no kernel is called %s\n", which.c_str());
  return 2;
}

} // namespace

int main(int argc, char** argv) {
  if (argc == 3) return count_mode(std::atoi(argv[1]), argv[2]);
  std::printf("gravity sliding gyrostat full_inertia axial  ns/jet  by_hand  ratio\n");
  for (std::size_t i = 0; i < effect_sets.size(); ++i) {
    const Effects& e = effect_sets[i];
    Recurrence by_hand = nullptr;
    for (const Named& n : named)
      if (n.effects == e) by_hand = n.by_hand;
    const Bench bench(e);
    double ours = 0, hand = 0;
    compare(bench, kernel_table<Pack>.of[i].jets, by_hand, ours, hand);
    std::printf("%7d %7d %8d %12d %5d  %6.0f", e.gravity, e.sliding, e.gyrostat, e.full_inertia,
                e.axial, ours);
    if (by_hand != nullptr) std::printf("  %7.0f  %5.3f", hand, ours / hand);
    std::printf("\n");
  }
  return 0;
}
