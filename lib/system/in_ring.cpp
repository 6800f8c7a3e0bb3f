#include "system/in_ring.hpp"

#include "exact/error.hpp"

#include <algorithm>

namespace kov {
namespace {

/// Every function that a system speaks of, in the new ring.
struct Move {
  const Ring& ring;

  void operator()(MFraction& f) const { f = transfer(f, ring); }
  void operator()(MPoly& f) const { f = transfer(MFraction(f), ring).num(); }
  void operator()(Equation& e) const { (*this)(e.difference); }
  template <class T> void operator()(std::optional<T>& f) const {
    if (f) (*this)(*f);
  }
  template <class T> void operator()(std::vector<T>& all) const {
    for (T& f : all)
      (*this)(f);
  }
  void operator()(std::map<std::string, MFraction>& all) const {
    for (auto& [name, f] : all)
      (*this)(f);
  }
  void operator()(FunctionSymbol& f) const {
    (*this)(f.gradient);
    if (!is_zero(f.argument)) (*this)(f.argument);
  }
  void operator()(Assumption& a) const { (*this)(a.value); }
  void operator()(ReduceSpec& r) const { (*this)(r.change); }
  void operator()(ManifoldSpec& m) const {
    (*this)(m.equations);
    (*this)(m.levels);
    (*this)(m.nonzero);
  }
  void operator()(SystemClaim& c) const {
    (*this)(c.value);
    (*this)(c.first);
    (*this)(c.second);
    (*this)(c.on);
  }
  void operator()(SystemExpectation& x) const {
    (*this)(x.p);
    (*this)(x.q);
    (*this)(x.r);
  }
  void operator()(VectorField& v) const {
    (*this)(v.functions);
    (*this)(v.relations);
    (*this)(v.components);
    (*this)(v.hamiltonian);
    (*this)(v.poisson);
    v.ring = ring;
  }
};

} // namespace

System in_ring(const System& s, const Ring& ring) {
  const auto& names = s.ring()->names();
  KOV_ENSURE(names.size() <= ring->size() &&
             std::equal(names.begin(), names.end(), ring->names().begin()));
  System all = s;
  const Move move{ring};
  move(all.field);
  move(all.named);
  move(all.values);
  move(all.claims);
  move(all.manifolds);
  move(all.reductions);
  move(all.assumptions);
  all.domain = s.domain.in(ring);
  move(all.expectations);
  move(all.lagrangian);
  move(all.velocity_values);
  move(all.gyrostat);
  return all;
}

MFraction in_names_of(const System& s, const MFraction& f) {
  Substitution values;
  for (const auto& [name, value] : s.values)
    values[s.ring()->index(name)] = value;
  const MFraction here = transfer(f, s.ring());
  return is_zero(here) ? here : substitute(here, values);
}

ManifoldSpec in_names_of(const System& s, ManifoldSpec m) {
  for (auto* equations : {&m.equations, &m.levels})
    for (Equation& e : *equations)
      e.difference = in_names_of(s, e.difference);
  for (MPoly& f : m.nonzero)
    f = in_names_of(s, MFraction(f)).num();
  return m;
}

} // namespace kov
