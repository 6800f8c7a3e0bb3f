// A Hamiltonian that comes from a Lagrangian: theorem_certificates.md 1, (L1) to (L3).

#include "certify/theorem/family.hpp"

#include "certify/equation/facts.hpp"
#include "certify/system/check.hpp"
#include "exact/lists.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

class LegendreCheck {
public:
  LegendreCheck(const Node& n, const PhaseSystem& s, Arithmetic& a) : s_(s), in_(s.ring, a) {
    Keys k(n);
    const Node velocities = k.at("velocities");
    std::vector<std::string> names = s.ring->names();
    for (const Node& row : velocities.items())
      names.push_back(Keys(row).at("name").text());
    if (names.size() == s.ring->size()) velocities.fail("a velocity is expected");
    if (names.size() > max_phase_names) n.fail("more than 64 names");
    l_.value = read_phase_function(ring_of(velocities, names), k.at("value"));
    k.done();
    for (const Node& row : velocities.items()) {
      Keys one(row);
      static_cast<void>(one.at("name"));
      const auto i = s.ring->find(one.at("momentum").text());
      if (!i || *i >= s.dimension) velocities.fail("a momentum is not a coordinate");
      need(!is_among(*i, l_.momenta), "a momentum occurs twice");
      l_.momenta.push_back(*i);
      l_.velocities.push_back(read_phase_function(s.ring, one.at("value")));
      one.done();
    }
  }

  LagrangianForm operator()() {
    need_quadratic();
    const PhaseSpace space(s_, in_.arithmetic());
    PhaseFunction energy = in_.minus(in_.zero(), at_velocities(l_.value));
    for (std::size_t i = 0; i < l_.momenta.size(); ++i) {
      const PhaseFunction momentum = in_.variable(l_.momenta[i]);
      const PhaseFunction slope{derivative(l_.value.p, s_.ring->size() + i), l_.value.n};
      space.need_cleared(in_.minus(at_velocities(slope), momentum), {},
                         "a momentum is not the derivative of the Lagrangian");
      energy = in_.plus(energy, in_.times(momentum, l_.velocities[i]));
    }
    space.need_cleared(in_.minus(energy, *s_.hamiltonian), {},
                       "the Hamiltonian is not that of the Lagrangian");
    return l_;
  }

private:
  // (L1)
  void need_quadratic() const {
    const MPoly& f = l_.value.p;
    std::vector<std::size_t> used;
    for (const std::size_t x : used_variables(f))
      if (x < s_.ring->size()) used.push_back(x);
    const std::vector<bool> behind = names_behind(s_, std::move(used));
    need(std::ranges::none_of(l_.momenta, [&](std::size_t m) { return behind[m]; }),
         "the Lagrangian depends on a momentum");
    for (long t = 0; t < f.length(); ++t) {
      const auto e = f.exponents(t);
      unsigned long degree = 0;
      for (std::size_t i = s_.ring->size(); i < e.size(); ++i)
        degree = std::max(degree + e[i], e[i]); // no overflow
      need(degree <= 2, "the Lagrangian is not quadratic in the velocities");
    }
  }

  PhaseFunction at_velocities(const PhaseFunction& f) const {
    auto images = in_.variables();
    images.insert(images.end(), l_.velocities.begin(), l_.velocities.end());
    return in_.composed(f, images);
  }

  const PhaseSystem& s_;
  Functions in_;
  LagrangianForm l_;
};

} // namespace

LagrangianForm read_lagrangian(const Node& n, const PhaseSystem& s, Arithmetic& a) {
  return LegendreCheck(n, s, a)();
}

std::string shown_lagrangian(const LagrangianForm& l, const PhaseSystem& s) {
  const Ring& ring = l.value.p.ring();
  std::string line = "  H is the energy of the Lagrangian L = " + to_string(l.value);
  for (std::size_t i = 0; i < l.momenta.size(); ++i)
    line += ", " + ring->name(l.momenta[i]) + " = dL/d" + ring->name(s.ring->size() + i);
  return line;
}

} // namespace kov::certify
