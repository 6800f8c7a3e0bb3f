// The fixed table of conclusions (docs/theory/trichotomy.md; the table in certificates.md §2).

#include "certify/equation/rules.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace kov::certify {

namespace {

// The premises of one conclusion, sorted by kind.
class Given {
public:
  explicit Given(const Premises& premises)
      : local(find<LocalFact>(premises)), invariant(find<InvariantFact>(premises)),
        torsion(find<TorsionFact>(premises)), reduction(find<ReductionFact>(premises)),
        curvature(find<PCurvatureFact>(premises)), premises_(premises) {}

  [[nodiscard]] bool exponential() const { return find<ExponentialFact>(premises_) != nullptr; }
  [[nodiscard]] bool irreducible() const {
    return find<IrreducibleFact>(premises_) ||
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
  [[nodiscard]] bool has_invariant(long m) const { return !invariants(m).empty(); }

  const LocalFact* local;
  const InvariantFact* invariant;
  const TorsionFact* torsion;
  const ReductionFact* reduction;
  const PCurvatureFact* curvature;

private:
  const Premises& premises_;
};

// Nothing where the premises are not all given.
using Found = std::optional<Conclusion>;

Found group(bool given, const std::string& g, std::optional<Integer> n = {}) {
  if (!given) return std::nullopt;
  return Conclusion{g, std::move(n), g != "SL2" && g != "Borel"};
}

// D_1 is cyclic of order 4: both lines are exchanged, but -1 is the only diagonal element
// besides 1.
Found dihedral_or_cyclic(const Integer& n) {
  return n == Integer(1) ? group(true, "cyclic", 4) : group(true, "D", n);
}

// Does some exponent difference exclude the finite primitive groups?
bool excludes_primitive(const LocalFact& local) {
  if (local.infinite_order() || local.has_log()) return true;
  bool four = false;
  bool five = false;
  bool large = false;
  for (const PlaceFact& x : local.all) {
    if (!x.delta) continue;
    four |= x.delta->den() == Integer(4);
    five |= x.delta->den() == Integer(5);
    large |= x.delta->den() >= Integer(6);
  }
  return large || (four && five);
}

Found additive(const Given& g) {
  if (!g.exponential() || !g.local || !g.non_diagonal()) return std::nullopt;
  return group(true, "T", g.local->character_order());
}

Found diagonal(const Given& g) {
  if (!g.local || !g.split()) return std::nullopt;
  return g.infinite() ? group(true, "Gm") : group(true, "cyclic", g.local->character_order());
}

Found dihedral_genus_0(const Given& g) {
  if (!g.dihedral() || !g.local || g.infinite() || degree(g.invariant->branch) > 2)
    return std::nullopt;
  return dihedral_or_cyclic(g.local->residue_denominator(*g.invariant));
}

Found dihedral_finite(const Given& g) {
  if (!g.dihedral() || !g.torsion || g.torsion->of != g.invariant) return std::nullopt;
  return dihedral_or_cyclic(g.torsion->n);
}

// If G were finite of order 4 L N', every p with nonzero p-curvature would divide 2 L N', but the
// part of N' prime to q is bounded by the number of points of a Jacobian over F_q.
Found dihedral_torsion(const Given& g) {
  if (!g.dihedral() || !g.local || !g.reduction || g.reduction->of != g.invariant)
    return std::nullopt;
  Integer product(1);
  for (const mp_limb_t p : g.curvature_primes())
    if (p != g.reduction->p) product *= Integer(p);
  const Integer L = g.local->residue_denominator(*g.invariant);
  return group(gcd(Integer(2) * L, product) == Integer(1) && product > g.reduction->bound, "Dinf");
}

// Two invariants of degree 4 that are not proportional.
Found quaternion(const Given& g) {
  const auto v = g.invariants(4);
  if (!g.irreducible() || v.size() != 2) return std::nullopt;
  const auto [a, b] = v[0]->fraction();
  const auto [c, d] = v[1]->fraction();
  const Poly f = a * d;
  const Poly h = c * b;
  return group(!(scale(f, lead(h)) == scale(h, lead(f))), "D", 2);
}

Found component(bool given, bool abelian) {
  return given ? Found({{}, {}, abelian}) : std::nullopt;
}

struct Theorem {
  std::string_view id;
  Found (*from)(const Given&);
};
constexpr std::array<Theorem, 18> theorems{{
    {"sl2-p-curvature",
     [](const Given& g) { return group(g.curvature && g.curvature->shows == "sl2", "SL2"); }},
    {"sl2-irreducible-log",
     [](const Given& g) { return group(g.irreducible() && g.log(), "SL2"); }},
    {"sl2-irreducible-infinite",
     [](const Given& g) {
       return group(g.irreducible() && g.absent(4) && g.local && excludes_primitive(*g.local),
                    "SL2");
     }},
    {"sl2-irreducible-12",
     [](const Given& g) { return group(g.irreducible() && g.absent(12), "SL2"); }},
    {"borel",
     [](const Given& g) {
       return group(g.exponential() && g.non_diagonal() && g.infinite(), "Borel");
     }},
    {"additive", additive},
    {"diagonal", diagonal},
    {"dihedral-genus-0", dihedral_genus_0},
    {"dihedral-infinite",
     [](const Given& g) { return group(g.dihedral() && g.infinite(), "Dinf"); }},
    {"dihedral-holomorphic",
     [](const Given& g) {
       return group(g.dihedral() && g.invariant->holomorphic_quotient(), "Dinf");
     }},
    {"dihedral-finite", dihedral_finite},
    {"dihedral-torsion", dihedral_torsion},
    {"quaternion", quaternion},
    {"tetrahedral",
     [](const Given& g) {
       return group(g.irreducible() && g.absent(4) && g.has_invariant(6), "A4");
     }},
    {"octahedral",
     [](const Given& g) {
       return group(g.irreducible() && g.absent(4) && g.absent(6) && g.has_invariant(8), "S4");
     }},
    {"icosahedral",
     [](const Given& g) {
       return group(g.irreducible() && g.absent(8) && g.has_invariant(12), "A5");
     }},
    {"invariant-abelian", [](const Given& g) { return component(g.invariant != nullptr, true); }},
    {"torus-nonabelian",
     [](const Given& g) { return component(g.infinite() && g.absent(4), false); }},
}};

} // namespace

bool is_theorem(std::string_view id) {
  return std::ranges::find(theorems, id, &Theorem::id) != theorems.end();
}

Conclusion conclude(const std::string& theorem, const Premises& premises) {
  const auto* row = std::ranges::find(theorems, theorem, &Theorem::id);
  need(row != theorems.end(), "an unknown theorem");
  auto found = row->from(Given(premises));
  if (!found) throw Refused{"the premises of " + theorem + " are not all given"};
  return *std::move(found);
}

} // namespace kov::certify
