#include "riccati/second_line.hpp"

#include "exact/error.hpp"
#include "linode/polynomial_solution.hpp"

#include <set>

namespace kov {
namespace {

long as_degree(const Integer& n, const Budget& budget) {
  if (!fits_long(n) || n > Integer(budget.max_degree) || -n > Integer(budget.max_degree))
    throw OutOfBudget("degree limit: a polynomial of degree " + to_string(n) +
                      " would be needed, the limit is " + std::to_string(budget.max_degree));
  return to_long(n);
}

bool has_residue(const RationalFunction& omega, const Poly& q, const Rational& alpha) {
  if (!divides(q, omega.den())) return sign(alpha) == 0;
  const Poly rest = exact_div(omega.den(), q);
  return divides(q, omega.num() - scale(derivative(q) * rest, NfElem(alpha)));
}

// The least order that v may have at a finite place; unset: there is no v.
std::optional<long> least_order(const Singularity& place, const RationalFunction& omega,
                                const Budget& budget) {
  if (place.kind == PlaceKind::irregular) return place.nu();
  if (place.kind != PlaceKind::regular || place.log == Truth::yes) return std::nullopt;
  if (!place.delta || !is_integer(*place.delta)) return 1;
  const Rational twice = Rational(1) - *place.delta; // 2 alpha for the lower exponent
  if (twice >= Rational(1) || !has_residue(omega, place.place, twice * Rational(1, 2))) return 1;
  return as_degree(twice.num(), budget);
}

// v = N D with the known part D = poles prod q^e.
struct KnownPart {
  Poly zeros;           ///< of y at ordinary points, each simple
  std::vector<long> e;  ///< parallel to Singularities::finite
  RationalFunction phi; ///< D'/D
  long degree = 0;      ///< of D

  [[nodiscard]] RationalFunction value(const Singularities& s) const {
    RationalFunction d(zeros);
    for (std::size_t i = 0; i < e.size(); ++i)
      d *= pow(RationalFunction(s.finite[i].place), e[i]);
    return d;
  }
};

std::optional<KnownPart> known_part(const RationalFunction& omega, const Singularities& s,
                                    const Budget& budget) {
  KnownPart known{omega.den(), {}, {}, 0};
  for (const Singularity& place : s.finite) {
    const auto e = least_order(place, omega, budget);
    if (!e) return std::nullopt;
    known.e.push_back(*e);
    known.degree += *e * place.degree();
    known.phi +=
        RationalFunction(scale(derivative(place.place), NfElem(Rational(*e))), place.place);
    known.zeros = remove_factor(known.zeros, place.place).second;
  }
  known.degree += degree(known.zeros);
  known.phi += RationalFunction(derivative(known.zeros), known.zeros);
  return known;
}

// The degrees that v may have at infinity.
std::set<Integer> degrees_of(const RationalFunction& omega) {
  const long order = degree(omega.den()) - degree(omega.num());
  if (order <= 0) return {Integer(order)};
  std::set<Integer> d{Integer(1)};
  if (order > 1) return d;
  const NfElem twice = NfElem(2) * lead(omega.num()) / lead(omega.den());
  if (is_rational(twice) && is_integer(to_rational(twice)) && to_rational(twice) > Rational(1))
    d.insert(to_rational(twice).num());
  return d;
}

// (N D)'' = 2 (omega N D)', cleared of denominators.
PolynomialEquation equation_of(const RationalFunction& phi, const RationalFunction& omega) {
  const RationalFunction c1 = RationalFunction(2) * (phi - omega);
  const RationalFunction c0 =
      derivative(phi) + phi * phi - RationalFunction(2) * (omega * phi + derivative(omega));
  const Poly common = lcm(c1.den(), c0.den());
  return {common, exact_div(common, c1.den()) * c1.num(), exact_div(common, c0.den()) * c0.num()};
}

} // namespace

std::optional<RationalFunction> product_with_second_line(const ExponentialSolution& y,
                                                         const Singularities& s,
                                                         const Budget& budget) {
  if (s.infinity.log == Truth::yes) return std::nullopt;
  const RationalFunction omega = y.omega();
  const auto known = known_part(omega, s, budget);
  if (!known) return std::nullopt;
  const PolynomialEquation equation = equation_of(known->phi, omega);
  for (const Integer& total : degrees_of(omega)) {
    const Integer d = total - Integer(known->degree);
    if (sign(d) < 0) continue;
    const auto n =
        polynomial_solution(equation.c2, equation.c1, equation.c0, as_degree(d, budget), budget);
    if (!n) continue;
    const RationalFunction v = RationalFunction(*n) * known->value(s);
    const RationalFunction constant = derivative(v) - RationalFunction(2) * omega * v;
    KOV_ENSURE(degree(constant.num()) == 0 && degree(constant.den()) == 0);
    return v / constant;
  }
  return std::nullopt;
}

} // namespace kov
