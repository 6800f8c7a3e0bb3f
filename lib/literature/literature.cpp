#include "literature/literature.hpp"

#include "exact/error.hpp"

#include <algorithm>

namespace kov {
namespace {

// A product of no more conditions than a system file can assume: for real parameters "not both are
// 0" is "the sum of the squares is positive".
const char* symmetric_heavy_top = R"(
format = "equation/1"
title  = "the symmetric heavy top outside the four classical cases"
[system]
kind        = "euler-poisson"
coordinates = ["M1", "M2", "M3", "Gamma1", "Gamma2", "Gamma3"]
parameters  = ["A", "C", "L1", "L2", "L3"]
hamiltonian = "(M1^2 + M2^2)/(2*A) + M3^2/(2*C) + Gamma1*L1 + Gamma2*L2 + Gamma3*L3"
[assume]
A  = "positive"
C  = "positive"
L1 = "real"
L2 = "real"
L3 = "real"
conditions = ["L1^2 + L2^2 > 0", "A - C != 0", "L3^2 + (A - 2*C)^2 > 0", "L3^2 + (A - 4*C)^2 > 0"]
)";

std::vector<LiteratureTheorem> all_theorems() {
  const TheoremHypothesis independent{
      "the first integrals are independent on the symplectic leaf that carries the phase curve; "
      "where the leaves around it are regular, of dimension four, together with the Casimir "
      "functions",
      Settled::stated, "that is what is excluded"};
  return {
      {"Morales-Ramis",
       "Morales-Ruiz and Ramis (2001)",
       "If a Hamiltonian system is integrable with first integrals that are meromorphic near a "
       "phase curve, the identity component of the differential Galois group of the variational "
       "equations along it is abelian.",
       "MoralesRamis2001",
       {},
       {{"the system is Hamiltonian on the leaves of a Poisson structure", Settled::checked,
         "Jacobi's identity, when the system is read"},
        {"the curve is a phase curve and no equilibrium", Settled::checked,
         "the manifold of the step is proved to be invariant"},
        {"the first integrals are meromorphic near the curve (also at the ends of the curve, at "
         "infinity, equilibria and poles of the system, where one is irregular)",
         Settled::stated, "that is what is excluded"},
        independent}},
      {"Ayoul-Zung",
       "Ayoul and Zung (2010)",
       "If a vector field is meromorphically integrable near a phase curve, the identity component "
       "of the differential Galois group of the variational equations along it is abelian.",
       "AyoulZung2010",
       {.liouville = false},
       {{"the curve is a phase curve and no equilibrium", Settled::checked,
         "the manifold of the step is proved to be invariant"},
        {"the first integrals and symmetry fields are meromorphic near the curve", Settled::stated,
         "that is what is excluded"}}},
      {"Morales-Ramis-Simo",
       "Morales-Ruiz, Ramis and Simo (2007)",
       "If a Hamiltonian system is integrable with first integrals that are meromorphic near a "
       "phase curve, the identity component of the differential Galois group of the variational "
       "equations of each order along it is abelian.",
       "MoralesRamisSimo2007",
       {},
       {{"the system is Hamiltonian", Settled::checked, "its form: kinetic energy and potential"},
        {"the curve is a phase curve and no equilibrium", Settled::checked,
         "the plane of the step is proved to be invariant, and the energy is not a critical value"},
        {"the first integrals are meromorphic near the curve", Settled::stated,
         "that is what is excluded"},
        independent}},
      {"Ziglin 1980",
       "Ziglin on the splitting of separatrices (1980)",
       "Let H = H0(q, p, I) + mu H1(q, p, phi, I) + ... and let hypotheses 1 to 6 hold for a "
       "doubly "
       "asymptotic orbit. If for some k != 0 the sum of the residues in t of the k-th Fourier mode "
       "of H1 on the orbit, over the strip 0 <= Im t <= 2 pi/lambda, is not 0, then for small "
       "mu != 0 there is no first integral independent of H.",
       "Ziglin1980",
       {.kind = IntegralClass::Kind::real_analytic, .near = IntegralClass::Near::phase_space},
       {{"hypotheses 1 to 6", Settled::checked, "the identities of the step"},
        {"the first integral is real-analytic near the closure of the orbit", Settled::stated,
         "that is what is excluded"}}},
      {"Ziglin 1982",
       "Ziglin's lemma on lowest-order parts (1982)",
       "Functionally independent meromorphic first integrals can be replaced by polynomials in "
       "them "
       "whose lowest-order parts are functionally independent; lowest-order parts of first "
       "integrals are first integrals of the lowest-order system.",
       "Ziglin1983",
       {.near = IntegralClass::Near::origin},
       {{"the bracket and the lowest-order terms are weight-homogeneous", Settled::checked,
         "the step lowest-order"},
        {"the first integrals are meromorphic near the origin", Settled::stated,
         "that is what is excluded"}},
       "",
       ""},
      {"Ziglin 1983",
       "Ziglin on the symmetric heavy top (1983)",
       "The heavy top with A = B is integrable with complex meromorphic first integrals on F2 = 0 "
       "only in the four classical cases.",
       "Ziglin1983",
       {.near = IntegralClass::Near::level},
       {{"the first integrals are meromorphic on the leaves with F2 = 0", Settled::stated,
         "that is what is excluded"},
        {"first integrals that are independent are so on the leaves with F2 = 0", Settled::open,
         ""}},
       symmetric_heavy_top}};
}

} // namespace

const std::vector<LiteratureTheorem>& literature() {
  static const std::vector<LiteratureTheorem> all = all_theorems();
  return all;
}

const LiteratureTheorem* literature_theorem(const std::string& id) {
  const auto& all = literature();
  const auto found = std::ranges::find_if(all, [&](const auto& t) { return t.id == id; });
  return found == all.end() ? nullptr : &*found;
}

namespace {

const LiteratureTheorem& known(const char* id) {
  const LiteratureTheorem* theorem = literature_theorem(id);
  KOV_ENSURE(theorem != nullptr);
  return *theorem;
}

} // namespace

const LiteratureTheorem& morales_ramis() { return known("Morales-Ramis"); }
const LiteratureTheorem& ayoul_zung() { return known("Ayoul-Zung"); }
const LiteratureTheorem& morales_ramis_simo() { return known("Morales-Ramis-Simo"); }
const LiteratureTheorem& ziglin_1980() { return known("Ziglin 1980"); }
const LiteratureTheorem& ziglin_1982() { return known("Ziglin 1982"); }

const LiteratureTheorem& smale_moser() {
  static const LiteratureTheorem theorem{
      "Smale-Moser",
      "Smale (1965) and Moser (1973) on homoclinic points",
      "Near a transverse homoclinic point of a diffeomorphism some power of it has an invariant "
      "Cantor set on which it is the shift on two symbols.  If the diffeomorphism and its domain "
      "are real-analytic, then every real-analytic first integral on a connected neighbourhood of "
      "the closure of the orbit is constant.",
      "Moser1973",
      {.kind = IntegralClass::Kind::real_analytic},
      {{"the map is a real-analytic diffeomorphism near the closure of the orbit", Settled::checked,
        "the enclosed crossings of the section are transverse"},
       {"the fixed point is hyperbolic", Settled::checked,
        "the cones of the map and of its inverse"},
       {"its stable and unstable manifold cross transversally at the homoclinic point",
        Settled::checked, "Krawczyk's test"},
       {"the first integral is real-analytic on a connected neighbourhood of that closure",
        Settled::stated, "that is what is excluded"}}};
  return theorem;
}

namespace {

LiteratureTheorem ziglin_for(const std::string& weight) {
  return {"Ziglin-" + weight,
          "Ziglin's lemma for rational integrals in involution, applied to parts of " + weight +
              " weight",
          "If a Hamiltonian system has a complete set of rational first integrals in involution, "
          "so has "
          "that of the part of " +
              weight +
              " weight of its Hamiltonian, for weights in which the bracket is homogeneous.",
          "Ziglin1983",
          {.kind = IntegralClass::Kind::rational, .near = IntegralClass::Near::phase_space},
          {{"the bracket is homogeneous in these weights", Settled::checked, "the weights"},
           {"the first integrals are rational", Settled::stated, "that is what is excluded"}},
          "",
          ""};
}

} // namespace

const LiteratureTheorem& ziglin_highest() {
  static const LiteratureTheorem theorem = ziglin_for("highest");
  return theorem;
}
const LiteratureTheorem& ziglin_lowest() {
  static const LiteratureTheorem theorem = ziglin_for("lowest");
  return theorem;
}

TheoremUsed used(const LiteratureTheorem& theorem) {
  return {&theorem, theorem.hypotheses, theorem.integrals};
}

} // namespace kov
