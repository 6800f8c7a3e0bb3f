// What `kovacic explain` knows.  A topic has a name and, behind "|", what else it is called; the texts are
// wrapped when they are printed.

#include "explain_topics.hpp"

namespace kov::cli {
namespace {

// clang-format off: one topic per block reads better than what the tool makes of it
constexpr Topic all_topics[] = {
    // groups
    {"SL2|SL(2, C)|special linear group",
     "The Galois group is SL(2, C): no solution can be written with integrals, exponentials and "
     "algebraic functions "
     "(Kovacic's case 4).  The identity component is SL(2, C), not abelian: if the equation is the "
     "normal variational "
     "equation of a Hamiltonian system, the system has no second first integral that is "
     "meromorphic (Morales-Ramis; "
     "where the equation is irregular: meromorphic also at the ends of the phase curve)."},
    {"Borel|triangular|triangular group|triangular matrices|full triangular group",
     "All triangular matrices.  Exactly one exponential solution y = exp(int omega) up to a "
     "factor, and y is "
     "transcendental with a transcendental integral of y^-2.  Not abelian (solvable)."},
    {"T", "T_n = {(c d; 0 1/c) : c^n = 1}: one exponential solution, whose n-th power is rational; "
          "the other solution needs "
          "one integral.  Identity component Ga, abelian.  T_1 is Ga itself."},
    {"Ga|additive|additive group",
     "The additive group: a rational solution, and a second one that needs an integral.  Abelian."},
    {"Gm|diagonal|diagonal matrices|multiplicative group",
     "All diagonal matrices, a torus: two exponential solutions with product rational; neither is "
     "algebraic.  Abelian."},
    {"cyclic", "Diagonal matrices of order n: two solutions whose n-th powers are rational.  "
               "Identity component trivial, abelian. "
               " n = 1: both solutions are rational."},
    {"trivial|trivial group", "The group of one element: every solution is rational in the "
                              "variable.  A trivial identity component means that the "
                              "Galois group is finite and all solutions are algebraic."},
    {"Dinf|infinite dihedral", "Infinite dihedral: the normaliser of the diagonal matrices.  y'/y "
                               "is quadratic over C(z) (Kovacic's case 2).  "
                               "Identity component Gm, abelian."},
    {"D|dihedral|binary dihedral|dihedral group|quaternion|quaternion group",
     "D_n, binary dihedral of order 4n (D_2: the quaternion group): like Dinf, but all solutions "
     "are algebraic.  "
     "Identity component trivial, abelian.  Finite or infinite is decided by a torsion test on a "
     "curve.  In the reason "
     "of an answer D_1, D_4, D_12 are degree bounds: see degree-bound."},
    {"A4|tetrahedral|binary tetrahedral",
     "Binary tetrahedral group, order 24: all solutions are algebraic (case 3)."},
    {"S4|octahedral|binary octahedral",
     "Binary octahedral group, order 48: all solutions are algebraic (case 3)."},
    {"A5|icosahedral|binary icosahedral",
     "Binary icosahedral group, order 120: all solutions are algebraic (case 3)."},
    {"Galois|galois group|differential galois group|G",
     "The differential Galois group G of a linear equation: the linear maps of its solutions that "
     "keep every "
     "polynomial relation with rational coefficients among the solutions and their derivatives.  "
     "The smaller G is, the "
     "simpler the solutions: finite for algebraic ones, solvable for Liouvillian ones."},
    {"identity-component|connected component|G0",
     "The connected component of the Galois group: trivial, Ga, Gm, the Borel group, or SL(2, C).  "
     "The theorem of "
     "Morales and Ramis asks whether it is abelian: the first three are, the last two are not.  It "
     "does not change "
     "under algebraic changes of the variable."},
    {"abelian|commutative", "Whether the identity component of the Galois group is abelian.  'no' "
                            "on the normal variational equation proves "
                            "non-integrability; 'yes' proves nothing by itself."},
    {"solvable|solvable group", "A group that is built from abelian ones in finitely many steps.  "
                                "An equation has a Liouvillian solution exactly "
                                "when the identity component of its Galois group is solvable."},
    {"torus|tori", "A subgroup of SL(2, C) that is conjugate to the diagonal matrices.  An "
                   "irregular place, or an irrational exponent "
                   "difference, puts one into the Galois group."},
    {"unipotent", "A matrix whose only eigenvalue is 1.  A logarithm in the solutions gives one "
                  "that is not the identity; two that do "
                  "not commute prove that the identity component is not abelian."},
    {"irreducible|irreducible-infinite|irreducible-log|sl2-irreducible-log|sl2-irreducible-"
     "infinite|sl2-irreducible-12",
     "The Galois group keeps no line of solutions: there is no exponential solution.  Certificates "
     "conclude SL(2, C) from an "
     "irreducible equation with a logarithm (sl2-irreducible-log), without an invariant of degree "
     "4 where the group is not "
     "finite primitive (sl2-irreducible-infinite), or without one of degree 12 "
     "(sl2-irreducible-12)."},
    {"reducible", "There is an exponential solution: y'/y is rational, and the group is triangular "
                  "(Kovacic's case 1)."},
    {"imprimitive", "The group permutes two lines of solutions and fixes none: y'/y is quadratic "
                    "over C(z) (Kovacic's case 2)."},
    {"primitive", "Irreducible and not imprimitive.  A finite primitive group in SL(2, C) is A4, "
                  "S4 or A5 (case 3)."},
    {"Zariski|Zariski dense|dense|Zariski closure",
     "A set of matrices is Zariski dense in a group if every polynomial that vanishes on the set "
     "vanishes on the group. "
     " Monodromy matrices are Zariski dense in the Galois group when no place is irregular "
     "(Schlesinger); with Stokes "
     "matrices and the exponential torus always (Ramis)."},
    {"commute|commuting|commutes|commutator",
     "Two matrices commute if A B = B A; two vector fields commute if their Lie bracket is 0.  "
     "Commuting fields can "
     "take the place of first integrals (see Bogoyavlenskij)."},
    {"PGL|PGL(2, C)|projective group|scalar",
     "2x2 matrices up to a common factor.  Scalars commute with everything, so that factors of the "
     "solutions change "
     "nothing in whether the identity component is abelian."},
    // one equation
    {"case|Kovacic|Kovacic's case|Kovacic's algorithm",
     "Kovacic's cases: 1 an exponential solution exists (the group is triangular); 2 y'/y is "
     "quadratic (imprimitive); "
     "3 all solutions are algebraic with a primitive group; 4 the group is SL(2, C) and there is "
     "no Liouvillian "
     "solution.  --case N looks at one of them only."},
    {"Liouvillian|Liouvillian solution|closed form",
     "Written with rational functions, algebraic functions, exponentials and integrals, in any "
     "order and any number.  "
     "NO LIOUVILLIAN SOLUTION is a theorem about the equation, not a failure to find one."},
    {"exponential|exponential solution|hyperexponential",
     "A solution y whose y'/y is a rational function: y = exp of an integral of a rational "
     "function.  It spans a line "
     "that the Galois group keeps."},
    {"radical", "A function whose n-th power is rational, for some n."},
    {"algebraic|algebraic function|transcendental",
     "A root of a polynomial whose coefficients are rational functions of the variable; any "
     "other function is "
     "transcendental.  All solutions are algebraic exactly when the Galois group is finite."},
    {"rational|rational function", "A quotient of two polynomials."},
    {"normal-form|r|u", "y'' + p y' + q y = 0 becomes u'' = r u with y = u exp(-1/2 int p), r = "
                        "p^2/4 + p'/2 - q.  The factor multiplies "
                        "the group by scalars, which are central, so that the identity component "
                        "is abelian for both equations or for "
                        "none.  JSON reports it under 'original'."},
    {"Riccati|Riccati equation|w", "w = y'/y solves w' + w^2 = r exactly when y solves y'' = r y."},
    {"singularity|place|pole|regular|singular",
     "A place is a point of the z-sphere, or the roots of one irreducible polynomial together, or "
     "infinity.  r has a "
     "singularity at its poles and, mostly, at infinity.  Regular: a pole of order at most 2 (at "
     "infinity: r falls at "
     "least like 1/z^2), where solutions are powers and logarithms times convergent series."},
    {"irregular|irregular place",
     "A place where r has a pole of order above 2 (infinity: where r does not fall like 1/z^2): "
     "solutions grow "
     "exponentially there.  The identity component then contains a torus.  Non-integrability is "
     "then proved for first "
     "integrals that are meromorphic also at the ends of the phase curve."},
    {"exponent|local exponent", "At a regular place c the solutions behave like (z-c)^e; the two "
                                "values of e are the exponents.  See Delta."},
    {"degree-bound", "D_m bounds the degree of the polynomial part of a rational solution of the "
                     "m-th symmetric power (m = 4, 6, 8, "
                     "12), D_1 that of an exponential solution.  It is a sum of local exponents.  "
                     "D_m < 0 proves that there is none.  "
                     "docs/theory/local_exponents.md"},
    {"Delta|exponent difference",
     "The exponent difference at a pole of order 2: exponents (1 + Delta)/2 and (1 - Delta)/2, "
     "Delta^2 = 1 + 4 a with "
     "r = a/(z-c)^2 + ...  Irrational at one place: the identity component contains a torus."},
    {"logarithm|log", "Delta is an integer and the solutions near the pole contain log(z-c): the "
                      "group contains a unipotent matrix.  "
                      "With a torus, or without an exponential solution, it is not abelian."},
    {"resonance|resonant", "Exponents at one place that differ by an integer.  Only then can a "
                           "logarithm appear, and each such place is "
                           "tested for one.  For frequencies at an equilibrium: an integer "
                           "combination of them that vanishes."},
    {"Sym|symmetric power|symmetric-power|invariant of degree m|no-invariant",
     "Sym^m is the m-th symmetric power of the equation: its solutions are the products of m "
     "solutions.  A rational one "
     "is an invariant of the group; SL(2) and the full triangular group have none.  'no-invariant' "
     "in a certificate is "
     "the proof that Sym^m has no rational solution, 'no-exponential' that there is no exponential "
     "solution."},
    {"p-curvature",
     "A matrix that is computed from the equation modulo a prime p.  What it cannot be for a "
     "finite or solvable group "
     "proves, for one good prime, that the group is larger.  docs/theory/p_curvature.md"},
    {"torsion|genus|divisor class|divisor",
     "For a dihedral group y1*y2 is known, and the group is finite exactly when a certain divisor "
     "class on the curve "
     "v^2 = F(z) has finite order (torsion).  Different orders modulo two primes prove that it is "
     "infinite.  The genus of "
     "the curve is 0 when F has at most two roots of odd multiplicity."},
    {"engine|method",
     "One of the ways in which this program decides an equation: Kovacic's algorithm, invariants "
     "of symmetric powers, "
     "the Riccati equation, p-curvature.  --method all runs several and compares them."},
    {"family-limit|family|families", "Kovacic's algorithm would look at more families of exponents "
                                     "than --max-families.  The other engines (--method "
                                     "engines) do not enumerate families."},
    {"recognized|classical equation|this is",
     "The equation is a classical one after a Moebius map of the variable (and perhaps a square): "
     "Lame, Riemann, Euler, "
     "Heun, Whittaker, Bessel, Weber or Airy.  The form is proved by transforming back, and the "
     "classical criterion of "
     "the family is compared with the answer that was computed.  See kovacic lame and kovacic "
     "potential."},
    {"Airy|Airy's equation|Ai|Bi",
     "y'' = a x y, solved by Ai(x) and Bi(x) for a = 1: SL(2, C), never Liouvillian."},
    {"Bessel|Bessel's equation|J_n|Y_n|nu",
     "y'' = (a + (m^2-1/4)/x^2) y, solved by sqrt(x) J_m(x) and sqrt(x) Y_m(x) for a = -1: "
     "Liouvillian exactly when m "
     "is half of an odd integer (a != 0)."},
    {"Weber|Weber's equation|parabolic cylinder|Hermite",
     "y'' = (u x^2 + w) y with u != 0, the equation of parabolic cylinder functions and of the "
     "harmonic oscillator: "
     "Liouvillian exactly when w/sqrt(u) is an odd integer; then with Hermite polynomials."},
    {"Whittaker|Whittaker's equation|M_(k,m)|W_(k,m)",
     "y'' = (1/4 - k/x + (m^2-1/4)/x^2) y, the confluent hypergeometric equation in normal form: "
     "Liouvillian exactly "
     "when k + m or k - m is half of an odd integer."},
    {"Euler|Euler's equation",
     "y'' = (l^2-1)/(4 x^2) y: the solutions are x^((1+l)/2) and x^((1-l)/2)."},
    {"Riemann|Riemann's equation|hypergeometric|2F1|Gauss",
     "The equation with three regular places and nothing else; three exponent differences "
     "determine it.  Its solutions "
     "are hypergeometric functions 2F1.  The table of Schwarz and Kimura says when they are "
     "Liouvillian."},
    {"Heun|Heun's equation", "An equation with four regular places and nothing else."},
    {"Lame|Lame's equation|Brioschi|Brioschi's determinant|wp",
     "y_tt = (n(n+1) wp(t; g2, g3) + B) y with Weierstrass' function wp.  Abelian identity "
     "components exist only for "
     "integer n, for n half of an odd integer where Brioschi's determinant vanishes (a polynomial "
     "in B), and for finite "
     "groups.  Ask: kovacic lame -n N"},
    {"Kimura|Schwarz|Schwarz and Kimura|table of Schwarz and Kimura|row",
     "Kimura (1969) lists the exponent differences l, m, n of Riemann's equation for which a "
     "solution is Liouvillian: one "
     "of the sums l +- m +- n is an odd integer, or the three stand, up to order, signs and "
     "integers (some rows: of even "
     "sum), in one of fifteen rows; those of finite groups were known to Schwarz (1873).  "
     "docs/theory/kimura.md"},
    {"special-solution|special function",
     "No solution is Liouvillian, but y = sqrt(h) (A F(x) + B F'(x)) solves the equation, where "
     "F'' = R(x) F is Airy's, "
     "Bessel's, Weber's, Whittaker's or Riemann's equation and x, A, B, h are rational functions "
     "of the variable: the "
     "solutions of an answer below NO LIOUVILLIAN SOLUTION, proved by differentiating twice.  "
     "Where a search of two seconds "
     "finds none nothing is "
     "said; for the lines of a batch it is made with --special-functions only."},
    {"spectrum|energy levels|exactly solvable",
     "The values of a parameter (mostly an energy E) for which y'' = r y has a Liouvillian "
     "solution: kovacic spectrum."},
    {"constants|root|number field|minimal polynomial|minpoly",
     "Constants are algebraic numbers: integers, fractions, I, sqrt(c), c^(1/n), root(p(x), "
     "approx), and a name with a "
     "minimal polynomial (--minpoly 'a^2 - 5').  All constants of one input are put into one "
     "number field, so that "
     "sqrt(2)*sqrt(3) - sqrt(6) is zero.  Pi and e are not algebraic; treat them as parameters."},
    // numbers with proven radii
    {"monodromy|monodromy matrix|loop|base point|continued",
     "Continue a basis of solutions along a closed path around a singularity: it comes back as a "
     "linear combination of "
     "itself, a monodromy matrix.  kovacic monodromy computes these with proven error bounds "
     "(radius); what is proved from "
     "them is a theorem."},
    {"Stokes|Stokes matrix|Stokes matrices|multiplier|exponential torus|formal monodromy",
     "At an irregular place asymptotic series describe solutions only in sectors; a Stokes matrix "
     "relates neighbouring "
     "sectors.  Monodromy, Stokes matrices and the exponential torus (the diagonal part) together "
     "determine the Galois "
     "group."},
    {"enclosure|radius|ball|Krawczyk", "A number that is given as [middle +/- radius] with a proof "
                                       "that the exact value lies inside.  Krawczyk's test proves "
                                       "that a ball contains exactly one solution of equations."},
    {"hyperbolic", "A matrix of SL(2, C) whose trace is not in [-2, 2]; an orbit from which nearby "
                   "orbits move away "
                   "exponentially fast."},
    {"second-opinion",
     "--second-opinion: the answer by algebra is compared with what monodromy matrices prove."},
    // mechanics
    {"NVE|normal variational equation|normal part|normal form of the variational equation",
     "The normal variational equation: the variational equation without the directions along the "
     "invariant manifold.  For "
     "two degrees of freedom it is one equation y'' = r y, whose Galois group decides."},
    {"VE|variational equation|variation|VE_1|VE_2|VE_3",
     "Linearise the equations of motion along a known solution: the result is the variational "
     "equation.  VE_k is that of "
     "order k, for the k-th derivatives; first integrals of the system become invariants of its "
     "Galois group."},
    {"higher-order|higher variational equation|order k|residue|quadrature",
     "--order K: where the first variational equation has an abelian group, those of order 2, ..., "
     "K can still have a "
     "non-abelian one: a logarithm (a residue) or a new integral (a quadrature) that does not "
     "commute with the group "
     "proves non-integrability (Morales-Ruiz, Ramis and Simo).  No obstruction up to order K "
     "proves nothing."},
    {"Morales-Ramis|Morales|Ramis|Morales-Ruiz and Ramis",
     "Morales-Ruiz and Ramis (2001): if a Hamiltonian system is integrable with first integrals "
     "that are meromorphic near "
     "a phase curve, the identity component of the Galois group of the variational equation along "
     "it is abelian.  So a "
     "group that is not abelian proves non-integrability; an abelian one proves nothing."},
    {"Morales-Ramis-Simo|Simo|Morales-Ruiz, Ramis and Simo",
     "Morales-Ruiz, Ramis and Simo (2007): the theorem of Morales-Ramis for the variational "
     "equations of every order."},
    {"Ayoul-Zung|Ayoul and Zung|Bogoyavlenskij",
     "Ayoul and Zung (2010): the theorem of Morales-Ramis for vector fields without a Hamiltonian "
     "structure.  Integrable "
     "(Bogoyavlenskij) means: n variables, q independent first integrals and n - q independent "
     "commuting vector fields "
     "that keep them."},
    {"Ziglin|Ziglin's lemma|lowest order part",
     "Ziglin's lemma (1982): meromorphic first integrals that are independent can be replaced by "
     "polynomials in them whose "
     "lowest-order parts are independent.  Also his theorem (1980) that a splitting of "
     "separatrices with a residue that is "
     "not 0 leaves no second real-analytic first integral."},
    {"Hamiltonian|H|hamiltonian system",
     "A system q' = dH/dp, p' = -dH/dq, or x' = J(x) grad H with a Poisson "
     "structure J; H is its energy and always a first integral."},
    {"first-integral|integral|conserved quantity",
     "A function that is constant along every solution, beside constants.  H is one; n in "
     "involution make a system with n "
     "degrees of freedom integrable."},
    {"involution|in involution|Poisson bracket|bracket",
     "Functions are in involution if their Poisson brackets are 0: each is constant along the flow "
     "of the others."},
    {"Poisson|Poisson structure|Jacobi|Jacobi's identity",
     "A bracket {f, g} of functions that is skew, a derivation in each argument, and satisfies "
     "Jacobi's identity; with H it "
     "gives the motion x' = {x, H}.  The program proves Jacobi's identity when it reads a file."},
    {"Casimir|Casimir function",
     "A function whose Poisson bracket with every function is 0, so that it is constant for every "
     "Hamiltonian: |Gamma|^2 "
     "and M.Gamma of a heavy top.  Its levels contain the symplectic leaves."},
    {"symplectic leaf|symplectic-leaf|leaf|leaves|symplectic",
     "A Poisson structure divides the phase space into leaves, on each of which it is "
     "nondegenerate (symplectic); every "
     "motion stays on one leaf.  Regular leaves have the largest dimension; near one, the common "
     "levels of the Casimir "
     "functions are the leaves."},
    {"integrable|Liouville|Liouville integrable|integrable in Liouville's sense|integrability",
     "A Hamiltonian system with n degrees of freedom (a symplectic leaf of dimension 2n) is "
     "integrable in Liouville's "
     "sense if it has n first integrals in involution that are independent almost everywhere.  A "
     "proof of "
     "non-integrability always names the class of functions (rational, meromorphic, real-analytic) "
     "that is excluded."},
    {"non-integrable|obstruction|no obstruction|verdict",
     "NON-INTEGRABLE is a theorem: there are not enough first integrals of the class that the "
     "answer names.  NO OBSTRUCTION "
     "means that this test does not exclude integrability; it is not a proof of integrability.  "
     "DEPENDS ON THE PARAMETERS: "
     "see the sets below it."},
    {"meromorphic|class of first integrals",
     "A quotient of two convergent power series near each point; rational functions are "
     "meromorphic everywhere.  'near a "
     "phase curve': in a neighbourhood of the particular solution, so that even a local integral "
     "is excluded.  'also at "
     "the ends': at points at infinity, equilibria and poles of the system, too; that excludes "
     "fewer functions."},
    {"real-analytic|analytic", "Given near each real point by a convergent power series.  More "
                               "functions than the meromorphic ones of the complex "
                               "phase space; splitting of separatrices excludes them."},
    {"phase-curve|ends of the phase curve",
     "A solution as a curve in phase space, without its parametrisation by time.  Its ends are the "
     "points at infinity, "
     "equilibria and poles of the system that it tends to."},
    {"manifold|invariant manifold|invariant set|particular solution|invariant-manifold",
     "A set of states that motion never leaves, given by equations; together with levels of first "
     "integrals it gives the "
     "particular solution along which the system is linearised.  kovacic find-manifolds FILE "
     "proposes some."},
    {"level|energy level|all levels", "The states at which first integrals have given values, H = "
                                      "h mostly.  One level with an obstruction excludes "
                                      "integrals near it; 'for all but countably many values' is "
                                      "said where that is what was proved."},
    {"equilibrium|equilibria|fixed point", "A state at which nothing moves."},
    {"homogeneous|potential|eigenvalue",
     "V(s q) = s^k V(q): a homogeneous potential of degree k.  At a Darboux point the eigenvalues "
     "of V'' must lie in a "
     "list that depends on k (Morales-Ruiz and Ramis): kovacic potential --degree K."},
    {"Darboux|Darboux point|Darboux points",
     "A vector c with V'(c) = c for a homogeneous potential V: a straight-line solution through "
     "the origin in the "
     "direction of c.  The eigenvalues of V''(c) decide its variational equation."},
    {"weight|parts of highest weight|highest weight|lowest weight|homogeneous part",
     "Give each variable a weight; the terms of H of highest (or lowest) weight are a simpler "
     "system.  Rational integrals "
     "of the whole have leading parts that are integrals of that one, so that its "
     "non-integrability carries over."},
    {"coupling|block|couples|whole variational equation",
     "A diagonal block of the variational equation is one equation or a small system of it; the "
     "coupling of blocks can make "
     "the group of the whole non-abelian although each block has an abelian one.  Monodromy "
     "matrices of the whole equation "
     "decide some of these (a Jordan block: two equal blocks with a coupling)."},
    {"separatrix|separatrices|splitting|doubly asymptotic",
     "A solution that tends to an unstable motion for t to both infinities.  A perturbation that "
     "splits it leaves no "
     "second analytic first integral (Ziglin 1980)."},
    {"homoclinic|homoclinic point|horseshoe|Smale|Moser|Smale-Moser|transverse",
     "A point whose orbit tends to the same unstable periodic orbit in both directions of time.  "
     "Where the stable and the "
     "unstable curve cross transversally, some power of the return map has a horseshoe (Smale, "
     "Moser), and no "
     "real-analytic first integral exists nearby.  kovacic section --homoclinic proves it with "
     "enclosures."},
    {"algebraize|change|change of variable|change-of-variable",
     "The variable t of the variational equation is replaced by z, a function of the motion, so "
     "that the coefficients become "
     "rational.  The identity component stays the same under algebraic changes; the line 'change' "
     "says which z."},
    {"moment|moments of inertia|Euler-Poisson|heavy top|rigid body|top",
     "The Euler-Poisson equations describe a rigid body with a fixed point: angular momentum M, "
     "vertical direction Gamma, "
     "moments of inertia A, B, C, centre of mass L.  Integrable cases: Euler, Lagrange, "
     "Kovalevskaya, and Goryachev and "
     "Chaplygin at M.Gamma = 0."},
    {"Moebius|Moebius map|Möbius", "A change of variable z = (a x + b)/(c x + d) of the whole "
                                   "sphere.  It moves the singularities and changes nothing in "
                                   "the Galois group."},
    {"normaliser", "The matrices N with N D N^-1 diagonal for every diagonal D: the diagonal and "
                   "the antidiagonal ones."},
    {"elliptic|elliptic function|elliptic-time",
     "Doubly periodic functions of time, as Weierstrass' wp: the motion along many particular "
     "solutions.  With z = wp(t) the "
     "variational equation gets rational coefficients."},
    {"canonical|canonical variables|coordinates|momenta|momentum",
     "Coordinates q and momenta p with {q_i, p_j} = 1 for i = j and 0 else; the equations are q' = "
     "dH/dp, p' = -dH/dq.  A "
     "canonical change of variables keeps this form."},
    {"symmetry|symmetry field", "A map of the phase space that takes solutions to solutions, or a "
                                "vector field that commutes with the motion.  What is "
                                "proved of one solution holds for its images."},
    {"perturbation", "A small change of an integrable system, mu H1 in H = H0 + mu H1."},
    {"gyrostat", "A rigid body with a rotor that turns at constant speed: H has terms linear in "
                 "the angular momentum."},
    {"degenerate", "Where a curve or a bracket loses its type: g2^3 = 27 g3^2 for Lame's equation "
                   "(two roots of the cubic "
                   "meet), or a Poisson structure on leaves of smaller dimension."},
    // parameters
    {"parameter|free parameter|decided for all parameters|depends on the parameters",
     "A name without a value.  Declared with --parameter n (or [ode] parameters, [system] "
     "parameters) the question is "
     "decided for all its values at once, on strata; --assume 'n > 0' says which values are meant. "
     " --set n=1/2 gives one "
     "value.  'free parameters' in an answer: the equation has constants that parameters do not go "
     "with (root(...), sqrt "
     "of a parameter)."},
    {"assumption|assume|assumed|domain",
     "A condition on the parameters that is given before anything is decided: --assume, or "
     "[assume] in a "
     "file.  It is part of every "
     "answer.  Without one, parameters are any complex numbers.  'domain': where the equation "
     "exists at all."},
    {"stratum|strata|conditions|for all parameters|excluded|open",
     "A set of parameter values, given by equations and inequations that the program found: where "
     "poles merge, an order "
     "drops, an exponent difference takes a special value.  The strata are disjoint and cover "
     "everything that is assumed.  "
     "In a classification a stratum is integrable, excluded (proved not integrable) or open "
     "(neither is proved)."},
    {"generic|general|special values|countably many",
     "For all values of the parameters (or of the energy) except those of an exception: finitely "
     "many values, or countably "
     "many, or where a polynomial vanishes, as the answer says.  In the exceptions nothing "
     "follows."},
    {"classify|classification|theorem",
     "kovacic classify FILE divides the parameters of a system into strata, disjoint and covering. "
     " integrable: as many "
     "first integrals in involution as Liouville's theorem wants, proved by expansion.  excluded: "
     "not integrable with first "
     "integrals of the class that the theorem names (meromorphic near the solutions, also at their "
     "ends, or rational), by "
     "one particular solution at one level.  open: neither; what was tried is listed.  Nothing "
     "follows from a limit, or from "
     "integrals that were not found.  The system file needs no manifolds: solutions and first "
     "integrals are looked for.  "
     "What is proved is kept when the time is over.  docs/theory/classify.md"},
    // proofs and limits
    {"certificate|proof|verify|accepted|rejected|loops",
     "A proof of the answer as data, written with --certificate.  kovacic verify checks it "
     "(--explain: step by step; --needs: what must be believed) and uses of the solver only "
     "exact arithmetic; tools/verify/kovacic_verify.py shares nothing with it but the "
     "text of the format.  What a "
     "certificate takes on trust (a theorem of the literature, an answer of Z3) is counted; "
     "--strict refuses it, and a "
     "hypothesis of a theorem that nothing checks."},
    {"trusted|Z3", "A step that is not checked: a theorem of the literature, the way from a system "
                   "to r, or an answer of Z3 (a program "
                   "for real inequalities).  It is named and counted."},
    {"premise|lemma|hypothesis",
     "A step of a theorem file on which another rests.  'violated' or 'open' premises are "
     "named, and nothing is concluded from them: kovacic prove FILE."},
    {"Groebner|Groebner basis|Gröbner basis|ideal|reduction modulo an ideal",
     "Equations in a form in which one can decide whether another equation follows from them.  "
     "Computing it can need much "
     "work: --max-work."},
    {"budget|limit|work limit|size limit|--max-work|--timeout",
     "A limit was reached before the question was decided: time (--timeout), memory (--memory), "
     "degree (--max-degree), "
     "number of families (--max-families) or work in one search among polynomials (--max-work).  "
     "The answer is 'undecided', "
     "never 'no'.  Raise the limit that the message names.  Exit code 3."},
    {"undecided|unknown",
     "Neither yes nor no was proved; the answer says why: a limit (see budget), a part that is not "
     "implemented, an enclosure that was too wide (inexact).  It is never a verdict.  Exit code "
     "3."},
    {"internal", "An error of the program, not of the input.  Where it happened behind the verdict "
                 "(in the solutions, the certificate, "
                 "a search that nobody needs for the answer), the verdict stays and the answer "
                 "names the part that is missing "
                 "('failed'); the exit code is that of a decided question.  An error before any "
                 "verdict ends in exit code 4.  A "
                 "certificate that our own checker refuses, and two methods that contradict each "
                 "other, withdraw the verdict.  Please "
                 "send us the question."},
    {"time-limit", "See budget: raise --timeout S (seconds; 0 means no limit)."},
    {"memory-limit", "See budget: raise --memory N (MiB; 0 means no limit)."},
    {"degree-limit", "A polynomial of higher degree than --max-degree would have been needed, in "
                     "the input (a high power) or as the "
                     "polynomial part of a solution.  The answer is 'undecided'.  Raise the limit "
                     "if you have the memory: degree 10^6 with "
                     "coefficients of a few digits is possible."},
    {"not-implemented", "The question is decidable in principle, but this program does not know "
                        "how yet; the message says which part is "
                        "missing.  What is reported as known is proved.  Exit code 3."},
    {"inexact",
     "A certified enclosure did not settle a question that has no exact test here.  Exit code 3."},
    // input
    {"decimal", "Decimals are refused in files because 0.5 could mean 1/2 or a measured number.  "
                "Write 1/2.  Only the second argument "
                "of root(p(x), approx) may be decimal: it chooses a root and nothing else."},
    {"syntax|formula", "Formulas: integers, names, + - * / ^ (or **), parentheses, sqrt, root, "
                       "primes for derivatives, diff(y, z, 2).  -a^2 is "
                       "-(a^2), a^b^c is a^(b^c).  Files want products written out: 2*z, not 2z; "
                       "the command line forgives and says how it "
                       "read the formula."},
    {"exit-codes", "0 decided; 1 a failed expectation or a rejected certificate; 2 usage error or "
                   "bad input; 3 something is undecided, the "
                   "reason is printed; 4 internal error; 130 interrupted by Ctrl-C, 143 by SIGTERM "
                   "(what is proved by then is printed).  With --exit-verdict: 10 "
                   "identity component not abelian, 20 "
                   "abelian, 0 undecided."},
    {"batch", "kovacic solve --batch FILE.jsonl reads one JSON object per line, with an id and r, "
              "or p and q, or ode, and optionally "
              "variable, minpoly, parameters and assumptions, and writes one object per line in "
              "the same order.  A bad line gives "
              "{\"id\", \"error\"}, and the run goes on."},
    // simulation
    {"section|Poincare|Poincare section|return map|scene|drift|orbit|grid",
     "kovacic section FILE draws the points in which orbits meet a surface in phase space (a "
     "Poincare section).  FILE is a "
     "system file with [scene] tables, a scene that names a system, or a scene of a rigid body "
     "([body]).  The integrals of "
     "the file are watched: their drift, relative to their sizes, is in every caption, and beyond "
     "the drift that a scene "
     "allows nothing is drawn.  Orbits that end at a singularity (a collision) are counted.  A "
     "picture proves nothing.  "
     "docs/guide/sections.md"},
    {"scan|plane of parameters",
     "A scene with a [scene.scan] table computes one number of each orbit (megno, lyapunov, fli, "
     "crossings, time) over one or two axes: what is drawn, coordinates of a state, or parameters. "
     " "
     "No points are kept: a million orbits are a matrix (NAME.npy), a picture and a page (html).  "
     "kovacic section FILE -o DIR --jobs 4, and --resume after a kill; --part K/N on several "
     "machines.  kovacic new scan writes an "
     "example."},
    {"megno|Lyapunov", "Mean exponential growth of nearby orbits: the mean <Y> tends to 2 on a "
                       "regular orbit and grows like half the largest "
                       "Lyapunov exponent times the time on a chaotic one.  A number, not a proof: "
                       "orbits that stick to islands look regular "
                       "for a while."},
};
// clang-format on

} // namespace

std::span<const Topic> explain_topics() { return all_topics; }

} // namespace kov::cli
