#include "jets/subspace.hpp"

#include <algorithm>

namespace kov::jets {
namespace {

class Subspaces {
public:
  Subspaces(const System& s, const ManifoldSpec& m)
      : s_(s), m_(m), z_(s.field.coordinates), n_(z_.size() / 2) {}

  std::vector<Subspace> operator()() const {
    std::vector<std::size_t> zero;
    for (std::size_t i = 0; i < n_; ++i)
      if (vanishes(i)) zero.push_back(i);
    std::vector<Subspace> all;
    if (zero.size() + 1 != n_) return all;
    for (const std::size_t across : zero) {
      std::vector<std::size_t> others = zero;
      std::erase(others, across);
      if (is_invariant(others)) all.push_back(inside(others));
    }
    return all;
  }

private:
  // q_i = 0 is one of the equations, up to a factor.
  [[nodiscard]] bool vanishes(std::size_t i) const {
    return std::ranges::any_of(m_.equations, [&](const Equation& e) {
      const MFraction slope = derivative(e.difference, z_[i]);
      return !is_zero(slope) && is_constant(slope) &&
             is_zero(e.difference - slope * MFraction::variable(s_.ring(), z_[i]));
    });
  }

  [[nodiscard]] Substitution zeros(const std::vector<std::size_t>& others) const {
    Substitution at;
    for (const std::size_t l : others)
      for (const std::size_t i : {z_[l], z_[l + n_]})
        at[i] = MFraction(s_.ring());
    return at;
  }

  [[nodiscard]] bool is_invariant(const std::vector<std::size_t>& others) const {
    const Substitution at = zeros(others);
    return std::ranges::all_of(others, [&](std::size_t l) {
      return is_zero(substitute(derivative(*s_.field.hamiltonian, z_[l]), at)) &&
             is_zero(substitute(derivative(*s_.field.hamiltonian, z_[l + n_]), at));
    });
  }

  [[nodiscard]] Subspace inside(const std::vector<std::size_t>& others) const {
    const Substitution at = zeros(others);
    Subspace all{s_, m_, others};
    VectorField& v = all.system.field;
    v.hamiltonian = substitute(*v.hamiltonian, at);
    std::erase_if(v.coordinates, [&](std::size_t i) { return at.count(i) > 0; });
    for (auto* equations : {&all.manifold.equations, &all.manifold.levels})
      for (Equation& e : *equations)
        e.difference = substitute(e.difference, at);
    std::erase_if(all.manifold.equations, [](const Equation& e) { return is_zero(e.difference); });
    return all;
  }

  const System& s_;
  const ManifoldSpec& m_;
  const std::vector<std::size_t>& z_;
  std::size_t n_;
};

} // namespace

std::vector<Subspace> invariant_subspaces(const System& s, const ManifoldSpec& m) {
  if (s.kind != SystemKind::hamiltonian || s.field.dimension() <= 4) return {{s, m, {}}};
  return Subspaces(s, m)();
}

} // namespace kov::jets
