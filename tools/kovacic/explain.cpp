// kovacic explain CODE: what a word in an answer or an error means, and what to do about it.

#include "commands.hpp"
#include "symbol/suggest.hpp"

#include <algorithm>

namespace kov::cli {
namespace {

struct Topic {
  const char* code;
  const char* text;
};

// clang-format off: one topic per block reads better than what the tool makes of it
constexpr Topic topics[] = {
    {"SL2",
     "The Galois group is SL(2, C): no solution can be written with integrals, exponentials and\n"
     "algebraic functions (Kovacic's case 4).  The identity component is SL(2, C), not abelian:\n"
     "if the equation is the normal variational equation of a Hamiltonian system, the system has\n"
     "no second first integral that is meromorphic (Morales-Ramis; where the equation is "
     "irregular:\n"
     "meromorphic also at the ends of the phase curve)."},
    {"Borel",
     "All triangular matrices.  Exactly one exponential solution y = exp(int omega) up to a "
     "factor,\n"
     "and y is transcendental with a transcendental integral of y^-2.  Not abelian (solvable)."},
    {"T",
     "T_n = {(c d; 0 1/c) : c^n = 1}: one exponential solution, whose n-th power is rational; the\n"
     "other solution needs one integral.  Identity component Ga, abelian.  T_1 is Ga itself."},
    {"Ga",
     "The additive group: a rational solution, and a second one that needs an integral.  Abelian."},
    {"Gm",
     "All diagonal matrices, a torus: two exponential solutions with product rational; neither is\n"
     "algebraic.  Abelian."},
    {"cyclic",
     "Diagonal matrices of order n: two solutions whose n-th powers are rational.  Identity\n"
     "component trivial, abelian.  n = 1: both solutions are rational."},
    {"Dinf",
     "Infinite dihedral: the normaliser of the diagonal matrices.  y'/y is quadratic over C(z)\n"
     "(Kovacic's case 2).  Identity component Gm, abelian."},
    {"D",
     "D_n, binary dihedral of order 4n: like Dinf, but all solutions are algebraic.  Identity\n"
     "component trivial, abelian.  Finite or infinite is decided by a torsion test on a curve.\n"
     "In the reason of an answer D_1, D_4, D_12 are degree bounds: see degree-bound."},
    {"A4", "Binary tetrahedral group, order 24: all solutions are algebraic (case 3)."},
    {"S4", "Binary octahedral group, order 48: all solutions are algebraic (case 3)."},
    {"A5", "Binary icosahedral group, order 120: all solutions are algebraic (case 3)."},
    {"case",
     "Kovacic's cases: 1 an exponential solution exists (the group is triangular); 2 y'/y is\n"
     "quadratic (imprimitive); 3 all solutions are algebraic with a primitive group; 4 the group\n"
     "is SL(2, C) and there is no Liouvillian solution.  --case N looks at one of them only."},
    {"identity-component",
     "The connected component of the Galois group: trivial, Ga, Gm, the Borel group, or SL(2, C).\n"
     "The theorem of Morales and Ramis asks whether it is abelian: the first three are, the last\n"
     "two are not.  It does not change under algebraic changes of the variable."},
    {"abelian",
     "Whether the identity component of the Galois group is abelian.  'no' on the normal\n"
     "variational equation proves non-integrability; 'yes' proves nothing by itself."},
    {"normal-form",
     "y'' + p y' + q y = 0 becomes u'' = r u with y = u exp(-1/2 int p), r = p^2/4 + p'/2 - q.\n"
     "The factor multiplies the group by scalars, which are central, so that the identity\n"
     "component is abelian for both equations or for none.  JSON reports it under 'original'."},
    {"budget",
     "A limit was reached before the question was decided: time (--timeout), memory (--memory),\n"
     "degree (--max-degree), number of families (--max-families) or work in one search among\n"
     "polynomials (--max-work).  The answer is 'undecided', never 'no'.  Raise the limit that the "
     "message names.  Exit code 3."},
    {"internal",
     "An error of the program, not of the input.  Where it happened behind the verdict (in the\n"
     "solutions, the certificate, a search that nobody needs for the answer), the verdict stays "
     "and\n"
     "the answer names the part that is missing ('failed'); the exit code is that of a decided\n"
     "question.  An error before any verdict ends in exit code 4.  A certificate that our own\n"
     "checker refuses, and two methods that contradict each other, withdraw the verdict.  Please\n"
     "send us the question."},
    {"time-limit", "See budget: raise --timeout S (seconds; 0 means no limit)."},
    {"memory-limit", "See budget: raise --memory N (MiB; 0 means no limit)."},
    {"degree-limit",
     "A polynomial of higher degree than --max-degree would have been needed, in the input (a "
     "high\n"
     "power) or as the polynomial part of a solution.  The answer is 'undecided'.  Raise the "
     "limit\n"
     "if you have the memory: degree 10^6 with coefficients of a few digits is possible."},
    {"family-limit", "Kovacic's algorithm would look at more families of exponents than "
                     "--max-families.  The other\n"
                     "engines (--method engines) do not enumerate families."},
    {"recognized",
     "The equation is a classical one after a Moebius map of the variable (and perhaps a square):\n"
     "Lame, Riemann, Euler, Heun, Whittaker, Bessel, Weber or Airy.  The form is proved by\n"
     "transforming back, and the closed answer of the family is compared with the answer that was\n"
     "computed.  See kovacic lame and kovacic potential."},
    {"special-solution",
     "No solution is Liouvillian, but y = sqrt(h) (A F(x) + B F'(x)) solves the equation, where\n"
     "F'' = R(x) F is Airy's, Bessel's, Weber's, Whittaker's or Riemann's equation and x, A, B, h\n"
     "are rational functions of the variable: the line 'but' of an answer, proved by\n"
     "differentiating twice.  Where a search of two seconds finds none nothing is said; for the\n"
     "lines of a batch it is made with --special-functions only."},
    {"parameter",
     "A name without a value.  Declared with --parameter n (or [ode] parameters, [system]\n"
     "parameters) the question is decided for all its values at once, on strata; --assume 'n > 0'\n"
     "says which values are meant.  --set n=1/2 gives one value.  'free parameters' in an answer:\n"
     "the equation has constants that parameters do not go with (root(...), sqrt of a parameter)."},
    {"stratum",
     "A set of parameter values, given by equations and inequations that the program found: where\n"
     "poles merge, an order drops, an exponent difference takes a special value.  The strata are\n"
     "disjoint and cover everything that is assumed; 'always' means: wherever the assumptions "
     "hold."},
    {"classify",
     "kovacic classify FILE divides the parameters of a system into strata, disjoint and "
     "covering.\n"
     "integrable: as many first integrals in involution as Liouville's theorem wants, proved by\n"
     "expansion.  excluded: not integrable with first integrals of the class that the theorem "
     "names\n"
     "(meromorphic near the solutions, also at their ends, or rational), by one particular "
     "solution\n"
     "at one level.  open: neither; what was tried is listed.  Nothing follows from a limit, or "
     "from\n"
     "integrals that were not found.  The system file needs no manifolds: solutions and first\n"
     "integrals are looked for.  What is proved is kept when the time is over.\n"
     "docs/theory/classify.md"},
    {"degree-bound",
     "D_m bounds the degree of the polynomial part of a rational solution of the m-th symmetric\n"
     "power (m = 4, 6, 8, 12), D_1 that of an exponential solution.  It is a sum of local "
     "exponents.\n"
     "D_m < 0 proves that there is none.  docs/theory/local_exponents.md"},
    {"Delta",
     "The exponent difference at a pole of order 2: exponents (1 + Delta)/2 and (1 - Delta)/2,\n"
     "Delta^2 = 1 + 4 a with r = a/(z-c)^2 + ...  Irrational at one place: the identity component\n"
     "contains a torus."},
    {"logarithm",
     "Delta is an integer and the solutions near the pole contain log(z-c): the group contains a\n"
     "unipotent matrix.  With a torus, or without an exponential solution, it is not abelian."},
    {"Sym",
     "Sym^m is the m-th symmetric power of the equation: its solutions are the products of m\n"
     "solutions.  A rational one is an invariant of the group; SL(2) and the full triangular "
     "group\n"
     "have none."},
    {"certificate",
     "A proof of the answer as data, written with --certificate.  kovacic verify checks it and\n"
     "shares with the solver only the arithmetic (lib/exact); tools/verify/kovacic_verify.py\n"
     "shares nothing with it but the text of the format.  What a certificate takes on trust\n"
     "(a theorem of the literature, an answer of Z3) is counted; --strict refuses it, and\n"
     "a hypothesis of a theorem that nothing checks."},
    {"trusted",
     "A step that is not checked: a theorem of the literature, the way from a system to r, or an\n"
     "answer of Z3 about real inequalities.  It is named and counted."},
    {"not-implemented",
     "The question is decidable in principle, but this program does not know how yet; the message\n"
     "says which part is missing.  What is reported as known is proved.  Exit code 3."},
    {"inexact",
     "A certified enclosure did not settle a question that has no exact test here.  Exit code 3."},
    {"decimal",
     "Decimals are refused because 0.5 could mean 1/2 or a measured number.  Write 1/2.  Only the\n"
     "second argument of root(p(x), approx) may be decimal: it chooses a root and nothing else."},
    {"constants",
     "Constants are algebraic numbers: integers, fractions, I, sqrt(c), c^(1/n), root(p(x), "
     "approx),\n"
     "and a name with a minimal polynomial (--minpoly 'a^2 - 5').  All constants of one input are\n"
     "put into one number field, so that sqrt(2)*sqrt(3) - sqrt(6) is zero.  Pi and e are not\n"
     "algebraic; treat them as parameters."},
    {"syntax",
     "Formulas: integers, names, + - * / ^ (or **), parentheses, sqrt, root, primes for "
     "derivatives,\n"
     "diff(y, z, 2).  -a^2 is -(a^2), a^b^c is a^(b^c).  Products are written out: 2*z, not 2z."},
    {"exit-codes",
     "0 decided; 1 a failed expectation or a rejected certificate; 2 usage error or bad input;\n"
     "3 something is undecided, the reason is printed; 4 internal error; 130 interrupted.\n"
     "With --exit-verdict: 10 identity component not abelian, 20 abelian, 0 undecided."},
    {"section",
     "kovacic section FILE draws the points in which orbits meet a surface in phase space.  FILE "
     "is "
     "a\n"
     "system file with [scene] tables, a scene that names a system, or a scene of a rigid body\n"
     "([body]).  The integrals of the file are watched: their drift, relative to their sizes, is "
     "in\n"
     "every caption, and beyond the drift that a scene allows nothing is drawn.  Orbits that end "
     "at\n"
     "a singularity (a collision) are counted.  A picture proves nothing.  docs/guide/sections.md"},
    {"megno",
     "Mean exponential growth of nearby orbits: the mean <Y> tends to 2 on a regular orbit and\n"
     "grows like half the largest Lyapunov exponent times the time on a chaotic one.  A number,\n"
     "not a proof: orbits that stick to islands look regular for a while."},
    {"batch", "kovacic solve --batch FILE.jsonl reads one JSON object per line, with an id and r, "
              "or p and q,\n"
              "or ode, and optionally variable, minpoly, parameters and assumptions, and writes "
              "one object per "
              "line in the\n"
              "same order.  A bad line gives {\"id\", \"error\"}, and the run goes on."},
};
// clang-format on

} // namespace

int explain(const Settings& settings, const std::string& code) {
  std::vector<std::string> codes;
  for (const Topic& t : topics)
    codes.emplace_back(t.code);
  if (code.empty()) {
    std::string list =
        "kovacic explain CODE, where CODE is one of\n\n  " + wrapped(enumerate(codes), 2) + "\n";
    write_output(settings, list);
    return exit_decided;
  }
  const std::string family = code.substr(0, code.find('_')); // T_4 -> T
  for (const Topic& t : topics)
    if (code == t.code || family == t.code) {
      write_output(settings, std::string(t.code) + "\n\n" + t.text + "\n");
      return exit_decided;
    }
  const auto near = nearest(code, codes);
  complain(settings, "nothing is known about '" + code + "'",
           near ? "did you mean " + *near + "?" : "codes: " + enumerate(codes));
  return exit_input;
}

} // namespace kov::cli
