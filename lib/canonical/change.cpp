#include "canonical/change.hpp"

#include "exact/error.hpp"
#include "exact/finite_algebra.hpp"
#include "exact/tried.hpp"

#include <algorithm>

namespace kov {
namespace {

// A ring with both sets of names, the old ones first.
Ring common_ring(const Ring& old, const Ring& more) {
  auto names = old->names();
  for (const std::string& name : more->names())
    if (!old->find(name)) names.push_back(name);
  return make_ring(names);
}

/// New variables written in the old ones.
class PutBack {
public:
  PutBack(const CanonicalChange& change, const Ring& old)
      : ring_(common_ring(old, change.system.ring())) {
    const VectorField& v = change.system.field;
    for (std::size_t k = 0; k < v.dimension(); ++k)
      values_[ring_->index(v.name(k))] = transfer(change.variables[k], ring_);
    for (const auto& [i, value] : change.functions)
      values_[ring_->index(v.ring->name(i))] = transfer(value, ring_);
  }
  [[nodiscard]] MFraction operator()(const MFraction& f) const {
    return substitute(transfer(f, ring_), values_);
  }

private:
  Ring ring_;
  Substitution values_;
};

/// The comparisons of is_canonical().
class ComparedSystems {
public:
  ComparedSystems(const System& old, const CanonicalChange& change, const Budget& budget)
      : old_(old.field), change_(change), back_(change, old.ring()),
        relations_(relation_ideal(old.field, {}, {}, budget)) {}

  [[nodiscard]] bool everything() const {
    return has_the_same_hamiltonian() && has_the_same_brackets() && is_invertible() &&
           functions_are_the_same();
  }

private:
  [[nodiscard]] const VectorField& now() const { return change_.system.field; }
  [[nodiscard]] MFraction in_old(const MFraction& f) const { return transfer(back_(f), old_.ring); }
  [[nodiscard]] bool vanishes(const MFraction& f) const { return is_zero_modulo(f, relations_); }

  [[nodiscard]] bool has_the_same_hamiltonian() const {
    return vanishes(in_old(*now().hamiltonian) - *old_.hamiltonian);
  }

  [[nodiscard]] bool has_the_same_brackets() const {
    const auto& x = change_.variables;
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t j = 0; j < x.size(); ++j)
        if (!vanishes(poisson_bracket(old_, x[i], x[j]) - in_old((*now().poisson)[i][j])))
          return false;
    return true;
  }
  // The Jacobian J of canonical variables is: J Omega J^T = Omega.
  [[nodiscard]] bool is_invertible() const {
    const auto& x = change_.variables;
    if (*now().poisson == canonical_structure(now().ring, x.size() / 2)) return true;
    Matrix slopes;
    for (const MFraction& f : x) {
      slopes.emplace_back();
      for (std::size_t j = 0; j < x.size(); ++j)
        slopes.back().push_back(partial(old_, f, j));
    }
    return null_space(std::move(slopes), x.size(), old_.ring).empty();
  }

  // Each symbol has the derivatives that the new system says, and each relation holds.
  [[nodiscard]] bool functions_are_the_same() const {
    for (const FunctionSymbol& f : now().functions) {
      const MFraction value = in_old(MFraction::variable(now().ring, f.variable));
      for (std::size_t j = 0; j < old_.dimension(); ++j) {
        MFraction slope = partial(old_, value, j);
        for (std::size_t k = 0; k < now().dimension(); ++k)
          if (!is_zero(f.gradient[k]))
            slope -= in_old(f.gradient[k]) * partial(old_, change_.variables[k], j);
        if (!vanishes(slope)) return false;
      }
    }
    return std::ranges::all_of(now().relations,
                               [&](const MPoly& r) { return vanishes(in_old(MFraction(r))); });
  }

  const VectorField& old_;
  const CanonicalChange& change_;
  PutBack back_;
  Ideal relations_;
};

} // namespace

bool is_canonical(const System& old, const CanonicalChange& change, const Budget& budget) {
  const VectorField& now = change.system.field;
  if (!old.field.hamiltonian || !old.field.poisson || !now.hamiltonian || !now.poisson ||
      change.variables.size() != now.dimension() || now.dimension() != old.field.dimension() ||
      now.components != hamiltonian_field(now, *now.poisson, *now.hamiltonian))
    return false;
  // not where something has no value
  return tried<DomainError>([&] { return ComparedSystems(old, change, budget).everything(); });
}

std::vector<std::string> in_words(const CanonicalChange& change) {
  std::vector<std::string> all;
  const VectorField& v = change.system.field;
  for (std::size_t k = 0; k < v.dimension(); ++k) {
    const std::string value = to_string(change.variables[k]);
    all.push_back(v.name(k) + (value == v.name(k) ? "" : " = " + value));
  }
  for (const auto& [i, value] : change.functions)
    all.push_back(v.ring->name(i) + " = " + to_string(value));
  return all;
}

MFraction in_old_variables(const CanonicalChange& change, const Ring& old, const MFraction& f) {
  return transfer(PutBack(change, old)(f), old);
}

} // namespace kov
