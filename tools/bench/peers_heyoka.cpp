// heyoka's Taylor integrator with its events, 4 or 8 orbits at a time.  Its kernel for a tolerance
// is compiled when that is first asked for, and kept: that time is not measured.

#include "peers.hpp"

#include <heyoka/expression.hpp>
#include <heyoka/kw.hpp>
#include <heyoka/taylor.hpp>

#include <cstdint>
#include <memory>

namespace kov::peers {
namespace {

namespace hy = heyoka;
using Formulas = std::array<hy::expression, 6>;
using Batch = hy::taylor_adaptive_batch<double>;

Formulas variables() {
  Formulas x;
  const char* const names[] = {"w1", "w2", "w3", "g1", "g2", "g3"};
  for (std::size_t i = 0; i < 6; ++i)
    x[i] = hy::expression(hy::variable(names[i]));
  return x;
}

template <bool sliding> Formulas field(const Problem& p, const Formulas& x) {
  Formulas d;
  Field<sliding>(p.body)(x, d);
  return d;
}

// S, as in section(): of the momentum I Omega + m z' v with v = L x Gamma, z' = v.Omega where the tip slides.
hy::expression section_formula(const Body<double>& b, const Formulas& x) {
  const Formulas::value_type v[] = {b.lever[1] * x[5] - b.lever[2] * x[4],
                                    b.lever[2] * x[3] - b.lever[0] * x[5],
                                    b.lever[0] * x[4] - b.lever[1] * x[3]};
  const hy::expression push =
      (b.sliding ? b.mass : 0.0) * (v[0] * x[0] + v[1] * x[1] + v[2] * x[2]);
  const hy::expression n1 = b.inertia[0][0] * x[0] + push * v[0],
                       n2 = b.inertia[1][1] * x[1] + push * v[1],
                       n3 = b.inertia[2][2] * x[2] + push * v[2];
  return (n1 * x[3] + n2 * x[4] + n3 * x[5]) * n3 - (n1 * n1 + n2 * n2 + n3 * n3) * x[5];
}

// All orbits with one tolerance.
class Integrator {
public:
  Integrator(const Problem& p, std::uint32_t lanes, double tolerance)
      : p_(p), lanes_(lanes), batch_(made(tolerance)) {}

  void run(Tally& tally) {
    for (first_ = 0; first_ < p_.starts.size(); first_ += lanes_) {
      load();
      batch_->propagate_until(p_.t_end);
      for (std::size_t lane = 0; lane < used(); ++lane) {
        tally.begin(first_ + lane);
        for (const X& x : crossings_[lane])
          tally.cross(x);
        tally.end(state(batch_->get_state_data(), lane));
      }
    }
  }

private:
  const Problem& p_;
  std::uint32_t lanes_;
  std::unique_ptr<Batch> batch_;
  std::size_t first_ = 0; // orbit in the first lane
  std::vector<double> times_ = std::vector<double>(lanes_);
  std::vector<std::vector<X>> crossings_ = std::vector<std::vector<X>>(lanes_); // by lane

  std::unique_ptr<Batch> made(double tolerance) {
    const Formulas x = variables(), d = p_.body.sliding ? field<true>(p_, x) : field<false>(p_, x);
    std::vector<std::pair<hy::expression, hy::expression>> system;
    for (std::size_t i = 0; i < 6; ++i)
      system.emplace_back(x[i], d[i]);
    const Batch::nt_event_t event(
        section_formula(p_.body, x),
        [this](Batch& batch, double t, int, std::uint32_t lane) { cross(batch, t, lane); },
        hy::kw::direction = hy::event_direction::negative);
    return std::make_unique<Batch>(system, std::vector<double>(6 * lanes_, 1.0), lanes_,
                                   hy::kw::tol = tolerance,
                                   hy::kw::nt_events = std::vector<Batch::nt_event_t>{event},
                                   hy::kw::force_avx512 = lanes_ > 4);
  }

  [[nodiscard]] std::size_t used() const {
    return std::min<std::size_t>(lanes_, p_.starts.size() - first_);
  }
  void load() {
    double* x = batch_->get_state_data();
    for (std::size_t lane = 0; lane < lanes_; ++lane)
      for (std::size_t i = 0; i < 6; ++i)
        x[i * lanes_ + lane] = p_.starts[first_ + std::min(lane, used() - 1)][i];
    for (std::vector<X>& of_lane : crossings_)
      of_lane.clear();
    batch_->set_time(0.0);
    batch_->reset_cooldowns();
  }
  [[nodiscard]] X state(const double* x, std::size_t lane) const {
    X out;
    for (std::size_t i = 0; i < 6; ++i)
      out[i] = x[i * lanes_ + lane];
    return out;
  }
  void cross(Batch& batch, double t, std::uint32_t lane) {
    if (lane >= used() || t < 1e-9) return; // the starts are on the section
    std::fill(times_.begin(), times_.end(), t);
    const X x = state(batch.update_d_output(times_).data(), lane);
    double side = 0;
    section(p_.body, x, side);
    if (side > 0) crossings_[lane].push_back(x);
  }
};

Method batches_of(const Problem& p, std::uint32_t lanes) {
  auto made = std::make_shared<std::map<double, std::unique_ptr<Integrator>>>();
  return [&p, lanes, made](double tolerance, Tally& t) {
    auto& integrator = (*made)[tolerance];
    if (!integrator) integrator = std::make_unique<Integrator>(p, lanes, tolerance);
    integrator->run(t);
  };
}

} // namespace

std::map<std::string, Method> heyoka_methods(const Problem& p) {
  return {{"heyoka-4-lanes", batches_of(p, 4)}, {"heyoka-8-lanes", batches_of(p, 8)}};
}

} // namespace kov::peers
