// The fixed table of conclusions (docs/theory/trichotomy.md; the table in certificates.md §2).

#include "certify/equation/rules.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace kov::certify {

namespace {

constexpr std::array<std::string_view, 18> theorem_ids{"sl2-p-curvature",
                                                       "sl2-irreducible-log",
                                                       "sl2-irreducible-infinite",
                                                       "sl2-irreducible-12",
                                                       "borel",
                                                       "additive",
                                                       "diagonal",
                                                       "dihedral-genus-0",
                                                       "dihedral-infinite",
                                                       "dihedral-holomorphic",
                                                       "dihedral-finite",
                                                       "dihedral-torsion",
                                                       "quaternion",
                                                       "tetrahedral",
                                                       "octahedral",
                                                       "icosahedral",
                                                       "invariant-abelian",
                                                       "torus-nonabelian"};

// The premises of one conclusion, sorted by kind.
class Given {
public:
  Given(Theorem theorem, const Premises& premises)
      : theorem_(theorem), premises_(premises), local(certify::find<LocalFact>(premises)),
        invariant(certify::find<InvariantFact>(premises)),
        torsion(certify::find<TorsionFact>(premises)),
        reduction(certify::find<ReductionFact>(premises)),
        curvature(certify::find<PCurvatureFact>(premises)) {}

  void need(bool condition) const {
    if (!condition) throw Refused{"the premises of " + to_string(theorem_) + " are not all given"};
  }
  [[nodiscard]] bool exponential() const {
    return certify::find<ExponentialFact>(premises_) != nullptr;
  }
  [[nodiscard]] bool irreducible() const {
    return certify::find<IrreducibleFact>(premises_) ||
           (curvature && (curvature->shows == "irreducible" || curvature->shows == "sl2"));
  }
  [[nodiscard]] bool absent(long m) const {
    return std::ranges::any_of(premises_, [&](const Fact* f) {
      const auto* x = std::get_if<AbsentFact>(f);
      return x && x->m == m;
    });
  }
  [[nodiscard]] bool log() const { return local && local->has_log(); }
  [[nodiscard]] bool infinite() const { return local && local->infinite_order(); }
  [[nodiscard]] bool non_diagonal() const { return log() || absent(2) || absent(4); }
  [[nodiscard]] bool split() const {
    return invariant && is_quadratic(*invariant) && degree(invariant->branch) == 0;
  }
  [[nodiscard]] bool dihedral() const {
    return invariant && is_quadratic(*invariant) && degree(invariant->branch) > 0;
  }
  [[nodiscard]] std::set<mp_limb_t> curvature_primes() const {
    std::set<mp_limb_t> primes;
    for (const Fact* f : premises_)
      if (const auto* x = std::get_if<PCurvatureFact>(f)) primes.insert(x->p);
    return primes;
  }
  [[nodiscard]] std::vector<const InvariantFact*> invariants(long m) const {
    std::vector<const InvariantFact*> found;
    for (const Fact* f : premises_)
      if (const auto* x = std::get_if<InvariantFact>(f); x && x->data.m == m) found.push_back(x);
    return found;
  }

private:
  Theorem theorem_;
  const Premises& premises_;

public:
  const LocalFact* local;
  const InvariantFact* invariant;
  const TorsionFact* torsion;
  const ReductionFact* reduction;
  const PCurvatureFact* curvature;
};

Conclusion group(const char* name, std::optional<Integer> n = {}) {
  const std::string g = name;
  return {g, std::move(n), g != "SL2" && g != "Borel"};
}

// D_1 is cyclic of order 4: both lines are exchanged, but -1 is the only diagonal element
// besides 1.
Conclusion dihedral_or_cyclic(const Integer& n) {
  return n == Integer(1) ? group("cyclic", 4) : group("D", n);
}

// Does some exponent difference exclude the finite primitive groups?
bool excludes_primitive(const LocalFact& local) {
  if (local.infinite_order() || local.has_log()) return true;
  bool four = false;
  bool five = false;
  bool large = false;
  const auto look = [&](const PlaceFact& x) {
    if (!x.delta) return;
    four |= x.delta->den() == Integer(4);
    five |= x.delta->den() == Integer(5);
    large |= x.delta->den() >= Integer(6);
  };
  look(local.infinity);
  std::ranges::for_each(local.places, look);
  return large || (four && five);
}

Conclusion sl2_irreducible_infinite(const Given& g) {
  g.need(g.irreducible() && g.absent(4) && g.local && excludes_primitive(*g.local));
  return group("SL2");
}

Conclusion borel(const Given& g) {
  g.need(g.exponential() && g.non_diagonal() && g.infinite());
  return group("Borel");
}

Conclusion additive(const Given& g) {
  g.need(g.exponential() && g.local && g.non_diagonal());
  return group("T", g.local->character_order());
}

Conclusion diagonal(const Given& g) {
  g.need(g.local && g.split());
  return g.infinite() ? group("Gm") : group("cyclic", g.local->character_order());
}

Conclusion dihedral_genus_0(const Given& g) {
  g.need(g.dihedral() && g.local && !g.infinite() && degree(g.invariant->branch) <= 2);
  return dihedral_or_cyclic(g.local->residue_denominator(*g.invariant));
}

Conclusion dihedral_finite(const Given& g) {
  g.need(g.dihedral() && g.torsion && g.torsion->of == g.invariant);
  return dihedral_or_cyclic(g.torsion->n);
}

// If G were finite of order 4 L N', every p with nonzero p-curvature would divide 2 L N', but the
// part of N' prime to q is bounded by the number of points of a Jacobian over F_q.
Conclusion dihedral_torsion(const Given& g) {
  g.need(g.dihedral() && g.local && g.reduction && g.reduction->of == g.invariant);
  Integer product(1);
  for (const mp_limb_t p : g.curvature_primes())
    if (p != g.reduction->p) product *= Integer(p);
  const Integer L = g.local->residue_denominator(*g.invariant);
  g.need(gcd(Integer(2) * L, product) == Integer(1) && product > g.reduction->bound);
  return group("Dinf");
}

// Two invariants of degree 4 that are not proportional.
Conclusion quaternion(const Given& g) {
  const auto v = g.invariants(4);
  g.need(g.irreducible() && v.size() == 2);
  const auto [a, b] = v[0]->fraction();
  const auto [c, d] = v[1]->fraction();
  const Poly f = a * d;
  const Poly h = c * b;
  g.need(!(scale(f, lead(h)) == scale(h, lead(f))));
  return group("D", 2);
}

Conclusion primitive(const Given& g, const char* name, long m, std::initializer_list<long> absent) {
  g.need(g.irreducible() && !g.invariants(m).empty());
  for (const long k : absent)
    g.need(g.absent(k));
  return group(name);
}

} // namespace

std::string to_string(Theorem t) {
  return std::string(theorem_ids.at(static_cast<std::size_t>(t)));
}
std::optional<Theorem> theorem_of(std::string_view id) {
  const auto* at = std::ranges::find(theorem_ids, id);
  if (at == theorem_ids.end()) return std::nullopt;
  return static_cast<Theorem>(at - theorem_ids.begin());
}

Conclusion conclude(Theorem theorem, const Premises& premises) {
  const Given g(theorem, premises);
  const auto sl2 = [&](bool condition) {
    g.need(condition);
    return group("SL2");
  };
  const auto abelian = [&](bool condition, bool value) {
    g.need(condition);
    return Conclusion{{}, {}, value};
  };
  switch (theorem) {
  case Theorem::sl2_p_curvature:
    return sl2(g.curvature && g.curvature->shows == "sl2");
  case Theorem::sl2_irreducible_log:
    return sl2(g.irreducible() && g.log());
  case Theorem::sl2_irreducible_infinite:
    return sl2_irreducible_infinite(g);
  case Theorem::sl2_irreducible_12:
    return sl2(g.irreducible() && g.absent(12));
  case Theorem::borel:
    return borel(g);
  case Theorem::additive:
    return additive(g);
  case Theorem::diagonal:
    return diagonal(g);
  case Theorem::dihedral_genus_0:
    return dihedral_genus_0(g);
  case Theorem::dihedral_infinite:
    g.need(g.dihedral() && g.infinite());
    return group("Dinf");
  case Theorem::dihedral_holomorphic:
    g.need(g.dihedral() && g.invariant->holomorphic_quotient());
    return group("Dinf");
  case Theorem::dihedral_finite:
    return dihedral_finite(g);
  case Theorem::dihedral_torsion:
    return dihedral_torsion(g);
  case Theorem::quaternion:
    return quaternion(g);
  case Theorem::tetrahedral:
    return primitive(g, "A4", 6, {4});
  case Theorem::octahedral:
    return primitive(g, "S4", 8, {4, 6});
  case Theorem::icosahedral:
    return primitive(g, "A5", 12, {8});
  case Theorem::invariant_abelian:
    return abelian(g.invariant != nullptr, true);
  case Theorem::torus_nonabelian:
    return abelian(g.infinite() && g.absent(4), false);
  }
  throw Refused{"an unknown theorem"};
}

} // namespace kov::certify
