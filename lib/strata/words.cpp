#include "strata/words.hpp"

#include "closed/generic_form.hpp"
#include "decide/words.hpp"
#include "exact/joined.hpp"
#include "exact/letters.hpp"
#include "exact/overloaded.hpp"

namespace kov::strata {
namespace {

std::string power(long m) { return "Sym^" + std::to_string(m); }

std::string name(const Leaf& leaf, PlaceIndex i) {
  return place_name(place_at(*leaf.scheme, i), leaf.scheme->z);
}
// Our letters beside the names in the equation.
FreshLetters letters(const Leaf& leaf) {
  return leaf.scheme ? FreshLetters(leaf.scheme->r.ring()) : FreshLetters();
}
std::string delta(const Leaf& leaf) { return letters(leaf)("Delta"); }
std::string difference(const Leaf& leaf, PlaceIndex i) {
  return delta(leaf) + " at " + name(leaf, i) + ", " + square_text(place_at(*leaf.scheme, i));
}

// A stratum on which there are no parameters left.
std::string of_number(const Leaf& leaf) {
  const Decision& d = evidence<Number>(leaf)->decision;
  if (!leaf.scheme) return kov::reason(d);
  const Ring& ring = leaf.scheme->r.ring();
  return letters(leaf).in(kov::reason(d, FreshLetters::mark), ring->name(leaf.scheme->z));
}

// ---- the evidence

std::string irrational(const ParametricPlace& p) {
  const std::size_t n = p.chi.size() - 1;
  switch (p.irrational) {
  case Irrationality::constant:
    return n > 1 ? "is an algebraic number of degree " + std::to_string(n)
                 : "is not the square of a rational number";
  case Irrationality::discriminant:
    return "is not real";
  case Irrationality::coefficients:
    if (n == 1) return "is negative";
    [[fallthrough]];
  default:
    return "is not a real number >= 0";
  }
}

// Why G0 contains a torus; empty if that is not known.
std::string torus(const Leaf& leaf) {
  if (const auto* e = evidence<IrregularPlace>(leaf))
    return "the equation is irregular at " + name(leaf, e->place);
  const auto* e = evidence<IrrationalDifference>(leaf);
  if (e == nullptr) return "";
  const ParametricPlace& p = place_at(*leaf.scheme, e->place);
  return "at " + name(leaf, e->place) + " " + square_text(p) + " " + irrational(p) + ", so that " +
         delta(leaf) + " is not rational";
}

std::string logarithm(const Leaf& leaf) {
  return "there is a logarithm at " + name(leaf, evidence<Logarithm>(leaf)->place);
}

// Empty: not known.
std::string irreducible(const Leaf& leaf) {
  const auto* none = evidence<NoExponential>(leaf);
  if (none == nullptr) return "";
  return none->bound.odd_order
             ? "a place of odd order admits no exponential solution"
             : "no exponential solution: its polynomial part would have degree at most " +
                   to_string(*none->bound.d) + " < 0";
}
std::string and_irreducible(const Leaf& leaf) {
  const std::string text = irreducible(leaf);
  return text.empty() ? "" : "; " + text;
}

std::string obstruction(const Leaf& leaf, const NoInvariant& none) {
  if (none.bound.no_exponent)
    return "at " + name(leaf, *none.bound.no_exponent) + " no exponent of " + power(none.m) +
           " is an integer";
  return "D_" + std::to_string(none.m) + " = " + std::to_string(none.bound.degree) + " < 0";
}
std::string without_invariant(const Leaf& leaf) {
  const auto* none = evidence<NoInvariant>(leaf);
  return power(none->m) + " has no rational solution" +
         (none->bound.form ? "" : " (" + obstruction(leaf, *none) + ")");
}

std::string listed(const std::vector<Rational>& values) {
  return joined(values, [&](const auto& v) { return to_string(v); });
}

// ---- one sentence for each theorem

// A factor of a product.
std::string factor(const MPoly& q, long exponent) {
  const std::string base = q.length() > 1 ? "(" + to_string(q) + ")" : to_string(q);
  if (exponent == 1) return base;
  const std::string e = std::to_string(exponent);
  return base + "^" + (exponent < 0 ? "(" + e + ")" : e);
}

std::string product(const ParametricInvariant& v, const Leaf& leaf) {
  std::string text = is_constant(v.p) ? "" : factor(v.p, 1);
  for (PlaceIndex i = 0; i < v.form.e.size(); ++i)
    if (v.form.e[i] != 0)
      text += (text.empty() ? "" : "*") + factor(place_at(*leaf.scheme, i).q, v.form.e[i]);
  return text.empty() ? "1" : text;
}

std::string invariant(const Leaf& leaf, std::size_t longest) {
  const ParametricInvariant& v = evidence<InvariantFound>(leaf)->v;
  const std::string text = product(v, leaf);
  return power(v.form.m) +
         (text.size() <= longest ? " has the rational solution " + letters(leaf)("v") + " = " + text
                                 : " has a rational solution") +
         ", so the group has an invariant; SL(2, C) and the full triangular group have none";
}

std::string irreducible_log(const Leaf& leaf) {
  if (evidence<DifferenceBound>(leaf) != nullptr) // exponents that depend on the parameters
    return "there is a logarithm, and no exponential solution: its polynomial part would have a "
           "degree < 0";
  return "the exponents are rational, " + logarithm(leaf) + and_irreducible(leaf);
}

std::string rational(const Leaf& leaf) {
  std::string text;
  const auto also = [&](const std::string& more) { text += (text.empty() ? "" : ", and ") + more; };
  if (evidence<Logarithm>(leaf) != nullptr)
    also(logarithm(leaf));
  else if (evidence<NoExponential>(leaf) != nullptr)
    also(irreducible(leaf));
  if (evidence<NoFamilies>(leaf) != nullptr)
    also("no exponents of an exponential solution leave a natural number for the degree of its "
         "polynomial part");
  std::string none;
  for (const Evidence& e : leaf.because)
    if (const auto* one = std::get_if<NoInvariant>(&e))
      none += (none.empty() ? "" : ", ") + power(one->m) + " has no rational solution" +
              (one->bound.form ? "" : " (" + obstruction(leaf, *one) + ")");
  if (!none.empty()) also(none);
  return "the exponents are rational constants; " + text;
}

std::string one_open(const Leaf& leaf) {
  const auto& bound = *evidence<DifferenceBound>(leaf);
  const std::string list = listed(evidence<ExcludedDifferences>(leaf)->values);
  const std::string torus_text = torus(leaf);
  return difference(leaf, bound.place) + " is not larger than " + to_string(bound.square) + "; " +
         torus_text +
         letters(leaf).in(torus_text.empty() ? "if Delta is not rational, "
                                             : ", and unless 2*Delta is an integer, ") +
         without_invariant(leaf) + "; an abelian identity component is possible only for " +
         (list.empty() ? "no value of " + delta(leaf)
                       : delta(leaf) + " in {" + list + "}, none of which occurs here");
}

std::string several_open(const Leaf& leaf) {
  std::string text = torus(leaf);
  if (text.empty()) text = "there is no exponential solution";
  for (const Evidence& e : leaf.because)
    if (const auto* one = std::get_if<ExcludedDifferences>(&e))
      text += "; " + difference(leaf, one->place) + ", 2*" + delta(leaf) + " is not an integer";
  return text + "; " + without_invariant(leaf);
}

std::string assumed_integers(const Leaf& leaf) {
  const auto& e = *evidence<AssumedNotInteger>(leaf);
  return torus(leaf) + "; " + difference(leaf, e.place) + ", and by assumption " +
         (e.twice ? "2*" : "") + delta(leaf) + " is not an integer; " + without_invariant(leaf);
}

// d1, d2 where two differences are not rational.
std::string pair_of(const Leaf& leaf, const SeparatedNowhere& e) {
  return joined(e.pair, [&](const PlaceIndex i) { return name(leaf, i); });
}
std::string separated_law(const Leaf& leaf) {
  return letters(leaf).in("three singular places, all regular, and two exponent differences d1, d2 "
                          "that are not rational: "
                          "abelian only if the third is an integer n >= 1 and some +-d1 +- d2 is "
                          "one of n - 1, n - 3, ..., "
                          "1 - n");
}
std::string separated(const Leaf& leaf) {
  const auto* e = evidence<SeparatedNowhere>(leaf);
  if (e == nullptr) return torus(leaf) + "; " + separated_law(leaf);
  const FreshLetters letter = letters(leaf);
  std::string text = torus(leaf) + "; " + separated_law(leaf) + letter.in(" (d1, d2 at ") +
                     pair_of(leaf, *e) + "); " + difference(leaf, e->third);
  if (e->growth)
    text += letter.in(", and d1^2 and d2^2 are conjugate with 2*(d1^2 + d2^2) >= ") +
            to_string(e->growth->factor) + letter.in("*n^2 - ") + to_string(e->growth->shift) +
            letter.in(", so that (d1 +- d2)^2 is larger than that, or negative");
  return text + ": no such n is possible here";
}

std::string condition(const Leaf& leaf, const OpenReason& open);

std::string not_special(const Leaf& leaf) {
  return condition(leaf, evidence<ConditionFails>(leaf)->condition) + "; this fails on the stratum";
}

std::string classical(const Leaf& leaf) {
  const auto& form = *evidence<ClassicalForm>(leaf);
  const Ring& ring = leaf.scheme->r.ring();
  const FreshLetters letter = letters(leaf);
  std::string text = form.family == Classical::constant ? letter.in("y'' = c y")
                     : form.family == Classical::polynomial
                         ? letter("r") + " is a polynomial"
                         : to_string(form.family) + std::string("'s equation");
  if (form.power != 1)
    text += " in " + letter("w") + " = " +
            (is_zero(form.centre)
                 ? ring->name(leaf.scheme->z)
                 : "(" + to_string(MFraction::variable(ring, leaf.scheme->z) - form.centre) + ")") +
            "^" + std::to_string(form.power);
  std::string numbers;
  for (const auto& [name, value] : numbers_of(form, ring).all)
    if (value != name) numbers += (numbers.empty() ? " (" : ", ") + name + " = " + value;
  return "by the classical criterion for " + text + numbers + (numbers.empty() ? "" : ")");
}

std::string argument(const Leaf& leaf, std::size_t longest) {
  switch (leaf.by) {
  case Conclusion::none:
    return "";
  case Conclusion::number:
    return of_number(leaf);
  case Conclusion::invariant:
    return invariant(leaf, longest);
  case Conclusion::half_integers:
    return "all exponents are half-integers and there is no logarithm";
  case Conclusion::torus_log:
    return torus(leaf) + ", and " + logarithm(leaf) +
           ": the group contains a torus and a unipotent matrix" + and_irreducible(leaf);
  case Conclusion::irreducible_log:
    return irreducible_log(leaf);
  case Conclusion::torus:
    return torus(leaf) + ": the identity component contains a torus; " + without_invariant(leaf) +
           ", so that it is larger" + and_irreducible(leaf);
  case Conclusion::rational:
    return rational(leaf);
  case Conclusion::one_open:
    return one_open(leaf);
  case Conclusion::several_open:
    return several_open(leaf);
  case Conclusion::separated:
    return separated(leaf);
  case Conclusion::no_products:
    return torus(leaf) + "; " + difference(leaf, evidence<NoProducts>(leaf)->place) +
           letters(leaf).in("; no exponents of y1*y2 are possible");
  case Conclusion::assumed_integers:
    return assumed_integers(leaf);
  case Conclusion::classical:
    return classical(leaf);
  case Conclusion::not_special:
    return not_special(leaf);
  case Conclusion::other_blocks:
    return "the normal system has other blocks here" + evidence<OtherBlocks>(leaf)->shown;
  }
  return "";
}

// ---- what is left open

std::string some_difference(const Leaf& leaf, const SomeDifference& open) {
  std::string text =
      letters(leaf).in(open.torus ? "some 2*Delta is an integer"
                                  : "every Delta is rational or some 2*Delta is an integer");
  for (const PlaceIndex i : open.places)
    text += ", " + difference(leaf, i);
  return text;
}

std::string condition(const Leaf& leaf, const MinorsVanish& open) {
  const std::string otherwise =
      std::visit(Overloaded{[](std::monostate) { return std::string(); },
                            [](long m) { return power(m) + " has a rational solution"; },
                            [&](const SomeDifference& d) { return some_difference(leaf, d); }},
                 open.otherwise);
  return "abelian only if " + otherwise + (otherwise.empty() ? "" : ", or ") +
         "these polynomials all vanish, which they do not for generic parameters";
}
std::string condition(const Leaf&, const NoEquation& open) {
  switch (open.why) {
  case NoEquation::Why::no_value:
    return "r has no value here";
  case NoEquation::Why::reduction:
    return "the reduction to y'' = r y is not valid here: " + open.shown;
  default:
    return open.shown;
  }
}
std::string condition(const Leaf&, const NotSolved& open) {
  return to_string(open.p) + " = 0 (" + to_string(open.why) + ") is not solved for a parameter";
}
std::string condition(const Leaf& leaf, const SomeDifference& open) {
  return "abelian only if " + some_difference(leaf, open) +
         ", and a symmetric power has a rational solution";
}
std::string condition(const Leaf& leaf, const RationalDifference& open) {
  return "abelian only if " + delta(leaf) + " is rational, " + difference(leaf, open.place) +
         ", and the equation is reducible or a symmetric power has a rational solution";
}
std::string condition(const Leaf& leaf, const IntegralDifference& open) {
  return std::string("abelian only if ") + (open.twice ? "2*" : "") + delta(leaf) +
         " is a positive integer, " + difference(leaf, open.place) +
         ", and Sym^4 has a rational solution";
}
std::string condition(const Leaf&, const TooManyUnknowns& open) {
  return power(open.m) + " has a rational solution or not: not looked at";
}
std::string condition(const Leaf&, const LargeDenominator&) {
  return "reducible or not: not looked at";
}
std::string condition(const Leaf& leaf, const OpenNumber&) { return of_number(leaf); }
std::string condition(const Leaf& leaf, const ByParts&) {
  return "abelian exactly where " + abelian_where(leaf.parts) + " (" +
         (evidence<ClassicalForm>(leaf) != nullptr ? classical(leaf) : separated_law(leaf)) + ")";
}
std::string condition(const Leaf&, const RefusedByChecker& open) {
  return "our own checker refuses the certificate of what was found: " + open.shown;
}
std::string condition(const Leaf&, const NotStudied& open) { return open.shown; }

std::string condition(const Leaf& leaf, const OpenReason& open) {
  return std::visit([&](const auto& one) { return condition(leaf, one); }, open);
}

std::string undecided(const Leaf& leaf, std::size_t longest) {
  const std::string plain = "undecided: " + open_condition(leaf);
  return std::visit(Overloaded{[&](const MinorsVanish& open) {
                                 std::string together = joined(open.together, [&](const auto& p) {
                                   return brief(MFraction(p), 120);
                                 });
                                 return plain + ": " + together;
                               },
                               [](const TooManyUnknowns& open) {
                                 return power(open.m) + " has " + std::to_string(open.degree + 1) +
                                        " unknowns, the limit is " + std::to_string(most_unknowns);
                               },
                               [](const LargeDenominator& open) {
                                 return "the exponents have the common denominator " +
                                        to_string(open.n);
                               },
                               [&](const OpenNumber&) { return open_condition(leaf); },
                               [&](const NotStudied& open) {
                                 const std::string known = argument(leaf, longest);
                                 return known.empty() ? open.shown : known + "; " + open.shown;
                               },
                               [&](const auto&) { return plain; }},
                    *leaf.open);
}

std::string prefix(const Leaf& leaf, std::size_t longest) {
  std::string text;
  for (const Evidence& e : leaf.because)
    if (const auto* of = std::get_if<OfEquation>(&e)) {
      const std::string r = to_factored_string(of->r);
      text += "with the equation for the variation of " + of->unknown +
              (r.size() <= longest ? ", r = " + r : "") + ": ";
    }
  return text;
}

std::string exponential(const Leaf& leaf, std::size_t longest) {
  if (leaf.by != Conclusion::rational && evidence<NoFamilies>(leaf) != nullptr)
    return "; there is no exponential solution: no exponents leave a polynomial part";
  const auto* found = evidence<ExponentialFound>(leaf);
  if (found == nullptr) return "";
  const std::string w = to_string(found->w);
  return "; there is an exponential solution" +
         (w.size() <= longest ? ", y'/y = " + w : std::string());
}

std::string reason(const Leaf& leaf, std::size_t longest) {
  return prefix(leaf, longest) + (leaf.open ? undecided(leaf, longest) : argument(leaf, longest)) +
         exponential(leaf, longest);
}

constexpr std::size_t one_line = 80; // longer formulas are none for a terminal

} // namespace

std::vector<std::string> condition_texts(const Stratum& s) {
  std::vector<std::string> all;
  for (const Condition& c : in_pairs(s.conditions))
    all.push_back(to_string(c));
  for (const WithContrary& c : with_contraries(s.arithmetic))
    all.push_back(c.text);
  return all;
}

std::string reason(const Leaf& leaf) { return reason(leaf, std::string::npos); }
std::string reason_in_brief(const Leaf& leaf) { return reason(leaf, one_line); }

std::string group_text(const Leaf& leaf) {
  if (leaf.group) return letters(leaf).in(describe(*leaf.group));
  const std::string t = letters(leaf).in(describe({GroupType::T, {}}));
  switch (leaf.bound) {
  case GroupBound::SL2_or_Borel:
    return "SL(2, C) or the full triangular group";
  case GroupBound::torus_normaliser:
    return "diagonal or dihedral";
  case GroupBound::torus_normaliser_or_T:
    return "diagonal, dihedral or " + t;
  case GroupBound::finite_or_normaliser_or_T:
    return "finite, diagonal, dihedral or " + t;
  case GroupBound::triangular_or_cyclic:
    return "cyclic or " + t;
  case GroupBound::finite:
    return "finite";
  case GroupBound::unknown:
    break;
  }
  return "";
}

std::string open_condition(const Leaf& leaf) {
  if (!leaf.open) return "";
  return condition(leaf, *leaf.open);
}

std::string to_string(const Event& e) {
  const std::string at = place_name(e.place);
  switch (e.kind) {
  case Event::Kind::assumed:
    return "assumed";
  case Event::Kind::no_value:
    return "r has no value";
  case Event::Kind::pole_to_infinity:
    return "a pole goes to infinity";
  case Event::Kind::poles_meet:
    return "two poles meet";
  case Event::Kind::order_drops:
    return "the order of the pole at " + at + " drops";
  case Event::Kind::exponents_change:
    return "the exponents at " + at + " change";
  case Event::Kind::difference_real:
    return "the exponent difference at " + at + " becomes real";
  case Event::Kind::logarithm_vanishes:
    return "there is no logarithm at " + at;
  case Event::Kind::difference_is:
    return FreshLetters(e.place.q.ring())("Delta") + " = " + to_string(e.value) + " at " + at;
  case Event::Kind::invariant_vanishes:
    return "the invariant that was found may vanish";
  case Event::Kind::invariant_appears:
    return power(e.m) + " may have a rational solution";
  case Event::Kind::exponential_appears:
    return "there may be an exponential solution";
  case Event::Kind::divided_by:
    return "the equation " + to_string(e.solved) + " = 0 is solved by division by it";
  case Event::Kind::reduction:
    return e.shown;
  }
  return "";
}

std::string sentence(const Genericity& g) {
  using Else = Genericity::Else;
  return g.otherwise == Else::no_value    ? "a coefficient of the equation has no value"
         : g.otherwise == Else::no_order  ? "the coefficient of " + g.of + "'' is 0"
         : g.otherwise == Else::relations ? "the relations of the functions fall apart there"
                                          : "the reduction divides by " + g.of;
}

std::string to_string(const WhyEnded& why) {
  return std::visit(
      Overloaded{
          [](std::monostate) { return std::string(); },
          [](const TooManyStrata&) { return std::string("the limit of strata"); },
          [](const Ended& x) { return x.shown; },
          [](const ContradictsAssumptions&) { return std::string("contradicts the assumptions"); },
          [](const AssumedEquationFails&) { return std::string("an assumed equation fails"); },
          [](const Trusted& t) { return sentence(t); }},
      why);
}

std::string place_name(const PlaceName& p) {
  if (p.at_infinity || !p.q.ring()) return "infinity";
  if (kov::degree(p.q, p.z) > 1) return to_string(p.q) + " = 0";
  const auto c = coefficients(p.q, p.z);
  return p.q.ring()->name(p.z) + " = " + to_factored_string(-(MFraction(c[0]) / MFraction(c[1])));
}
std::string place_name(const ParametricPlace& p, std::size_t z) {
  return place_name(name_of(p, z));
}

std::string square_text(const ParametricPlace& p) {
  FreshLetters letter;
  for (const MFraction& c : p.chi)
    if (c.ring()) letter = FreshLetters(c.ring());
  const std::string square = letter("Delta") + "^2", root = letter("T");
  if (p.chi.size() == 2) return square + " = " + to_factored_string(-p.chi[0]);
  std::string s;
  for (std::size_t i = p.chi.size(); i-- > 0;) {
    if (is_zero(p.chi[i])) continue;
    const bool number = is_constant(p.chi[i]);
    const bool negative = number && sign(to_rational(p.chi[i])) < 0;
    const std::string t = i == 0 ? "" : i == 1 ? root : root + "^" + std::to_string(i);
    std::string c = to_factored_string(negative ? -p.chi[i] : p.chi[i]);
    if (!number) c = "(" + c + ")";
    if (!t.empty()) c = number && is_one(negative ? -p.chi[i] : p.chi[i]) ? t : c + "*" + t;
    s += (s.empty() ? (negative ? "-" : "") : negative ? " - " : " + ") + c;
  }
  return square + " a root " + root + " of " + s;
}

} // namespace kov::strata
