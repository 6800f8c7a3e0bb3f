#pragma once
// Runs for the tests of lib/flow: scenes from text, orbits, and what is measured on them.

#include "flow/scene/simulate.hpp"
#include "support/source_dir.hpp"

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace kov::flow::test {

inline std::string scene_path(const std::string& name) {
  return kov::test::in_source("/cases/sliding_top/scenes/") + name + ".toml";
}

/// Keeps everything.
template <class R> struct Record : Sink<R> {
  std::map<std::size_t, std::vector<Crossing<R>>> crossings;
  std::map<std::size_t, Finish<R>> ends;
  void crossing(const Crossing<R>& c) override { crossings[c.orbit].push_back(c); }
  void finished(std::size_t orbit, const Finish<R>& f) override { ends[orbit] = f; }
};

template <class R> std::vector<R> numbers(const std::vector<State<R>>& states) {
  std::vector<R> out;
  for (const State<R>& s : states) {
    out.insert(out.end(), s.omega.begin(), s.omega.end());
    out.insert(out.end(), s.gamma.begin(), s.gamma.end());
  }
  return out;
}

template <class R> State<R> state_of(const R (&x)[6]) {
  return {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}};
}

struct Goal {
  double t_end = 100;
  double log2_tolerance = -53;
  long max_crossings = -1;
  bool section = true;
  int lanes = 0;
  int check_every = 16;
  Isa isa = best_isa();
};

template <class R>
Record<R> run(const Body<R>& body, const std::vector<State<R>>& starts, const Goal& goal,
              const SectionRule& rule = {}) {
  const Effects e = effects_of(body);
  const Model<R> model = model_of(body, e);
  const std::vector<R> x = numbers(starts);
  Record<R> record;
  Run<R> r;
  r.section = rule;
  r.section.on = goal.section;
  r.log2_tolerance = goal.log2_tolerance;
  r.order = static_cast<int>(-0.38 * goal.log2_tolerance) + 3;
  r.t_end = R(goal.t_end);
  r.max_crossings = goal.max_crossings;
  r.check_every = goal.check_every;
  r.starts = x.data();
  r.orbits = starts.size();
  r.sink = &record;
  if constexpr (std::is_same_v<R, double> || std::is_same_v<R, Twin1>)
    integrate(e, model, body.sliding, r, goal.lanes, goal.isa);
  else
    integrate(e, model, body.sliding, r);
  return record;
}

template <class R> double largest_drift(const Record<R>& r) {
  double worst = 0;
  for (const auto& [orbit, end] : r.ends)
    for (const R& d : end.drift)
      worst = std::max(worst, static_cast<double>(d));
  return worst;
}

template <class R> std::vector<State<R>> states_of(const Scene& s) {
  std::vector<State<R>> out;
  if constexpr (std::is_same_v<R, Twin1>) {
    const PrecisionScope scope(160);
    for (const State<BigReal>& x : states_of<BigReal>(s)) {
      out.emplace_back();
      for (int i = 0; i < 3; ++i) {
        out.back().omega[i] = to_twin(x.omega[i]);
        out.back().gamma[i] = to_twin(x.gamma[i]);
      }
    }
    return out;
  } else {
    const Body<R> b = s.body<R>();
    const Levels<R> f = s.levels<R>();
    for (const Start& start : starts_of(s))
      out.push_back(refine_point(b, f, s.section, R(start.l), R(start.y), start.g_size));
    return out;
  }
}

template <class R> State<double> rounded(const R (&x)[6]) {
  const auto d = [&](int i) { return static_cast<double>(x[i]); };
  return {{d(0), d(1), d(2)}, {d(3), d(4), d(5)}};
}

} // namespace kov::flow::test
