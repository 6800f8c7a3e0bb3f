// Every sentence about a classification and its solutions: read from values, never read back.

#include "exact/joined.hpp"
#include "galois/solutions.hpp"

#include "exact/letters.hpp"

namespace kov {
namespace {

std::string place(const Classification& c, const std::string& z) {
  return place_name(place_at(*c.local, c.decisive), z);
}

// The statement of the places, in words.
std::string branch(const Classification& c, const std::string& z) {
  switch (c.kind) {
  case Trichotomy::irregular_or_irrational:
    return place_at(*c.local, c.decisive).kind == PlaceKind::regular
               ? "the exponent difference at " + place(c, z) + " is not rational"
               : "the equation is irregular at " + place(c, z);
  case Trichotomy::logarithmic:
    return "the equation is regular singular with rational exponents and has a logarithm at " +
           place(c, z);
  case Trichotomy::undetermined:
    return "whether there is a logarithm at " + place(c, z) + " is not known";
  default:
    return "the equation is regular singular with rational exponents and without logarithms";
  }
}

std::string in_brackets(const std::optional<Obstruction>& o, const Classification& c,
                        const std::string& z) {
  return o ? " (" + to_string(*o, *c.local, z) + ")" : "";
}

// " (D_m < 0)" behind "Sym^m has no rational solution", if the exponents alone say it.
std::string why_no_invariant(const Classification& c, long m, const std::string& z) {
  for (const NoInvariant& none : c.no_invariants)
    if (none.m == m) return in_brackets(none.obstruction, c, z);
  return "";
}
std::string why_no_line(const Classification& c, const std::string& z) {
  return c.no_exponential ? in_brackets(c.no_exponential->obstruction, c, z) : "";
}

std::string torus(const Classification& c, const std::string& z) {
  return branch(c, z) + ", so that the identity component contains a torus";
}
std::string torus_without_invariant(const Classification& c, const std::string& z) {
  return torus(c, z) + ", and Sym^4 has no rational solution" + why_no_invariant(c, 4, z);
}

std::string at(const std::optional<Poly>& pole, const std::string& z) {
  return pole ? "at the roots of " + to_string(*pole, z) : "at infinity";
}

std::string orders(const DihedralAnswer& d, const std::string& z) {
  const ReducedOrder& one = d.orders.front();
  const ReducedOrder& other = d.orders.back();
  return "the divisor class of w d" + z + "/v has order " + to_string(one.order) + " modulo " +
         std::to_string(one.prime.p) + " and order " + to_string(other.order) + " modulo " +
         std::to_string(other.prime.p) + ", so that it has infinite order";
}

std::string curvatures(const InfiniteTorsion& t, const std::string& z) {
  std::string primes = joined(t.nonzero, [&](const PrimeIdeal& p) { return std::to_string(p.p); });
  return "the divisor class of w d" + z +
         "/v has infinite order: the p-curvatures for p = " + primes +
         " are not 0, so that a finite order would be divisible by these primes, and its " +
         "part prime to " + std::to_string(t.good.p) + " is at most " + to_string(t.bound);
}

std::string torsion(const DihedralAnswer& d, const DihedralCurve& curve, const std::string& z) {
  const std::string genus = std::to_string(curve.genus);
  switch (d.by) {
  case Torsion::irrational_residue:
    return "the residue of w d" + z + "/v " + at(d.pole, z) + " is not rational" +
           (d.residue_squared ? " (its square is " + to_string(*d.residue_squared) + ")" : "");
  case Torsion::multiple_pole:
    return "w d" + z + "/v has a multiple pole " + at(d.pole, z);
  case Torsion::holomorphic:
    return "w d" + z + "/v is a nonzero holomorphic differential on a curve of genus " + genus;
  case Torsion::genus_zero:
    return "on a curve of genus 0 the residues of w d" + z + "/v, with common denominator " +
           to_string(d.n) + ", give y1/y2 as a " + to_string(d.n) + "-th root of a function";
  case Torsion::orders_differ:
    return orders(d, z) + " (genus " + genus + ")";
  case Torsion::no_function:
    return "the divisor class of w d" + z + "/v could only have order " +
           to_string(d.orders.front().order) +
           " (that of its reductions), and no function has that divisor and logarithmic "
           "differential";
  case Torsion::curvatures:
    return curvatures(*d.curvatures, z) + " (genus " + genus + ")";
  case Torsion::function:
    return "y1/y2 is a " + to_string(d.n) + "-th root of a function on a curve of genus " + genus;
  case Torsion::undecided:
    break;
  }
  return "finite or infinite: the curve has genus " + genus + ", the divisor class of w d" + z +
         "/v has no small order, and the p-curvatures of the first primes vanish";
}

std::string dihedral(const Classification& c, const std::string& z) {
  const std::string shape = "(y1*y2)^2 is rational and y1*y2 is not: a dihedral group";
  const std::string why = torsion(*c.dihedral, *c.curve, z);
  switch (c.dihedral->finite) {
  case Truth::yes:
    return shape + ", finite: " + why;
  case Truth::no:
    return shape + ", infinite: " + why;
  default:
    return shape + "; undecided which of the two: " + why;
  }
}

std::string integral(const Classification& c, const std::string& z) {
  return branch(c, z) + "; all exponent differences are integers" +
         (c.group->n == Integer(1) ? ", odd at every finite place: all solutions are rational"
                                   : ": all solutions are square roots of rational functions");
}

std::string primitive(const Classification& c) {
  const char* first = c.group->type == GroupType::A4   ? "6"
                      : c.group->type == GroupType::S4 ? "8"
                                                       : "12";
  return std::string("there is no exponential solution; Sym^4 has no rational solution; the first "
                     "symmetric power of even degree that has one is Sym^") +
         first;
}

std::string argument(const Classification& c, const std::string& z) {
  switch (c.argument) {
  case Argument::none:
    return "";
  case Argument::zero:
    return "r = 0: the solutions are 1 and the variable itself";
  case Argument::p_curvature:
    return "the p-curvature modulo p = " + std::to_string(c.p_curvature->prime.p) +
           " has places of odd order that no solvable or finite group allows";
  case Argument::torus_two_lines:
    return torus(c, z) + "; y1*y2 is rational, so that there are two exponential solutions";
  case Argument::torus_dihedral:
    return torus(c, z) + "; (y1*y2)^2 is rational and y1*y2 is not";
  case Argument::torus_no_invariant:
    return torus_without_invariant(c, z);
  case Argument::torus_one_line:
    return torus_without_invariant(c, z) + "; there is exactly one exponential solution";
  case Argument::torus_no_line:
    return torus_without_invariant(c, z) + "; there is no exponential solution";
  case Argument::logarithm_one_line:
    return branch(c, z) + "; there is one exponential solution, a radical";
  case Argument::logarithm_no_line:
    return branch(c, z) + ", and there is no exponential solution" + why_no_line(c, z);
  case Argument::integral_exponents:
    return integral(c, z);
  case Argument::two_quartics:
    return "Sym^4 has exactly two independent rational solutions: the quaternion group";
  case Argument::two_radicals:
    return "two exponential solutions, both radicals of order " + to_string(*c.group->n);
  case Argument::fourth_power:
    return "the rational solution of Sym^4 is the fourth power of a solution, the only "
           "exponential one";
  case Argument::dihedral:
    return dihedral(c, z);
  case Argument::one_radical:
    return "there is exactly one exponential solution, a radical";
  case Argument::line_alone:
    return branch(c, z) + "; y is an exponential solution and the only one: the equation v' = "
                          "2*(y'/y)*v + 1 for the product v of two has no rational solution";
  case Argument::no_invariant:
    return "there is no exponential solution, and Sym^12 has no rational solution" +
           why_no_invariant(c, 12, z);
  case Argument::primitive:
    return primitive(c);
  }
  return "";
}

} // namespace

std::string reason(const Classification& c, const std::string& z) {
  std::string text = FreshLetters(names_in_text(z)).in(argument(c, FreshLetters::mark), z);
  if (c.undecided && c.undecided->why == Unable::Why::budget)
    text += (text.empty() ? "" : "; ") + ("undecided: " + c.undecided->detail);
  return text;
}

std::string text(const LiouvillianSolution& s, const std::string& variable, const Budget& budget) {
  if (!s.exponential) return "";
  const auto& [theta, p] = *s.exponential;
  return exponential_text(p, is_zero(theta) ? LogarithmicParts() : logarithmic_parts(theta, budget),
                          variable);
}

std::string note(const LiouvillianSolution& s) {
  if (s.adjoined) return "over Q(" + s.exponential->theta.field()->letter() + ")";
  if (s.radicand)
    return "both roots are rational functions over K(sqrt(" + to_string(*s.radicand) + "))";
  if (s.three_quadratics)
    return "the product of three quadratics that are conjugate over the constants";
  return "";
}

} // namespace kov
