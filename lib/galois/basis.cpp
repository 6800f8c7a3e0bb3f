#include "galois/basis.hpp"

#include "exact/error.hpp"
#include "galois/hyperexponential_integral.hpp"
#include "galois/torsion_function.hpp"

#include <algorithm>

namespace kov {
namespace {

// Above these degrees what a reduction leaves is longer than anybody reads, and the integral is
// written as it is; or left out.
constexpr long readable_degree = 60;
constexpr long printable_degree = 1000;

std::string bracketed(const std::string& text) {
  return text.find_first_of("+-*/^ ") == std::string::npos ? text : "(" + text + ")";
}

std::string factor_times(const RationalFunction& f, const std::string& text, const std::string& z) {
  const std::string factor = to_string(f, z);
  return factor == "1" ? text : bracketed(factor) + "*" + text;
}

// ----- one line: y and y int y^-2

// y^-2 = a E: simple poles of y'/y with a residue in 1/2 Z go into the rational factor a.
HyperexponentialIntegral inverse_square(const ExponentialSolution& y, const Budget& budget) {
  const LogarithmicParts parts = logarithmic_parts(y.theta, budget);
  RationalFunction phi = RationalFunction(-2) * y.theta;
  RationalFunction a = RationalFunction(1) / RationalFunction(y.p * y.p);
  std::vector<Poly> places;
  if (degree(y.p) > 0) places.push_back(y.p);
  for (const auto& [q, rho] : parts.residues) {
    places.push_back(q);
    if (degree(rho) > 0 || !is_rational(rho.coeff(0))) continue;
    const Rational twice = Rational(2) * to_rational(rho.coeff(0));
    if (!is_integer(twice) || !fits_long(twice.num()) || abs(twice) > Rational(readable_degree))
      continue;
    const long k = to_long(twice.num());
    phi += RationalFunction(scale(derivative(q), NfElem(k)), q);
    a *= pow(RationalFunction(q), -k);
  }
  return reduced_integral(a, phi, places, budget);
}

bool is_long(const ExponentialSolution& y) {
  return degree(y.p) > printable_degree || degree(y.theta.den()) > printable_degree;
}

Basis with_second_line(const LiouvillianSolution& found, const RationalFunction& r,
                       const std::string& z, const Budget& budget) {
  const ExponentialSolution& y = *found.exponential;
  KOV_ENSURE(solves(y, r));
  const std::string first = text(found, z, budget);
  if (degree(y.p) > readable_degree || degree(y.theta.den()) > readable_degree)
    return {first, bracketed(first) + "*int(1/(" + first + ")^2, " + z + ")"};
  const std::string integral = to_string(inverse_square(y, budget), z, budget);
  return {first, (first == "1" ? "" : first + "*") +
                     (integral.find_first_of("+- ") == std::string::npos && first != "1"
                          ? integral
                          : "(" + integral + ")")};
}

// ----- y1 y2 = v with a Wronskian outside K

Basis two_lines(const ExponentialPair& pair, const RationalFunction& r, const std::string& z,
                const Budget& budget) {
  const RationalFunction& v = pair.v;
  const RationalFunction slope = derivative(v);
  KOV_ENSURE(slope * slope - RationalFunction(2) * v * derivative(slope) +
                 RationalFunction(4) * r * v * v ==
             RationalFunction(Poly(pair.w_squared)));
  const HyperexponentialIntegral inverse =
      reduced_integral(RationalFunction(1) / v, RationalFunction(), {}, budget);
  const std::string exponent =
      "1/2*sqrt(" + to_string(pair.w_squared) + ")*(" + to_string(inverse, z, budget) + ")";
  const std::string front = "sqrt(" + to_string(v, z) + ")*exp(";
  return {front + exponent + ")", front + "-" + exponent + ")"};
}

// ----- (y1 y2)^2 = F = k F0 g^2; T = sqrt(k F0/w^2), u'/u = 1/(g T)

class Dihedral {
public:
  Dihedral(const DihedralCurve& c, const RationalFunction& r, const std::string& z,
           const Budget& budget)
      : c_(c), z_(z), budget_(budget), t_squared_(scale(c.branch, c.k / c.w_squared)),
        phi_(derivative(c.branch), scale(c.branch, NfElem(2))),
        t_("sqrt(" + to_string(t_squared_, z) + ")"),
        front_(bracketed(to_string(RationalFunction(c.branch) * c.g * c.g, z)) + "^(1/4)") {
    const RationalFunction f = RationalFunction(scale(c.branch, c.k)) * c.g * c.g;
    const RationalFunction slope = derivative(f);
    KOV_ENSURE(RationalFunction(Rational(3, 4)) * slope * slope / f - derivative(slope) +
                   RationalFunction(4) * r * f ==
               RationalFunction(Poly(c.w_squared)));
  }

  // h = a + b T with h'/h = n/(g T): a' = n b/g and (b' + phi b) T^2 = n a/g.
  [[nodiscard]] Basis finite(const RationalFunction& a, const Integer& n) const {
    const RationalFunction order{Rational(n)};
    const RationalFunction b = c_.g * derivative(a) / order;
    KOV_ENSURE((derivative(b) + phi_ * b) * RationalFunction(t_squared_) == order * a / c_.g);
    const std::string h = "(" + to_string(a, z_) + " + " + factor_times(b, t_, z_) + ")";
    const std::string root = "1/" + to_string(Integer(2) * n);
    return {front_ + "*" + h + "^(" + root + ")", front_ + "*" + h + "^(-" + root + ")"};
  }

  // u = exp int 1/(g T) = exp int T/(g T^2)
  [[nodiscard]] Basis infinite() const {
    if (degree(c_.branch) + degree(c_.g.num()) > readable_degree) return exponentials(as_it_is());
    const RationalFunction a = RationalFunction(1) / (c_.g * RationalFunction(t_squared_));
    std::vector<Poly> places = c_.singular;
    for (const Factor& f : irreducible_factors(c_.branch, budget_))
      places.push_back(f.base);
    if (degree(c_.ordinary) > 0) places.push_back(c_.ordinary);
    const HyperexponentialIntegral u = reduced_integral(a, phi_, distinct(places), budget_);
    return exponentials(is_zero(u.b) ? factor_times(u.w * RationalFunction(Rational(1, 2)), t_, z_)
                                     : as_it_is());
  }

private:
  [[nodiscard]] Basis exponentials(const std::string& exponent) const {
    return {front_ + "*exp(" + exponent + ")", front_ + "*exp(-" + exponent + ")"};
  }
  [[nodiscard]] std::string as_it_is() const {
    return "1/2*int(" + bracketed(to_string(RationalFunction(1) / c_.g, z_)) + "/" + t_ + ", " +
           z_ + ")";
  }

  static std::vector<Poly> distinct(const std::vector<Poly>& places) {
    std::vector<Poly> all;
    for (const Poly& q : places)
      if (std::none_of(all.begin(), all.end(),
                       [&](const Poly& p) { return degree(gcd(p, q)) > 0; }))
        all.push_back(q);
    return all;
  }

  const DihedralCurve& c_;
  std::string z_;
  const Budget& budget_;
  Poly t_squared_;
  RationalFunction phi_; ///< T'/T
  std::string t_, front_;
};

std::optional<Basis> dihedral(const Classification& c, const RationalFunction& r,
                              const std::string& z, const Budget& budget) {
  if (!c.curve) return std::nullopt; // the quaternion group has three curves
  const Dihedral formulas(*c.curve, r, z, budget);
  if (!c.dihedral || c.dihedral->finite != Truth::yes) return formulas.infinite();
  const auto a = c.dihedral->a ? c.dihedral->a : torsion_function(*c.curve, c.dihedral->n, budget);
  return a ? std::optional(formulas.finite(*a, c.dihedral->n)) : std::nullopt;
}

} // namespace

std::optional<Basis> basis(const Classification& c, const RationalFunction& r,
                           const std::vector<LiouvillianSolution>& found,
                           const std::string& variable, const Budget& budget) {
  if (!c.group || found.empty()) return std::nullopt;
  if (found.size() == 2)
    return Basis{text(found[0], variable, budget), text(found[1], variable, budget)};
  if (found[0].exponential)
    return is_long(*found[0].exponential)
               ? std::nullopt
               : std::optional(with_second_line(found[0], r, variable, budget));
  if (c.pair) return two_lines(*c.pair, r, variable, budget);
  if (c.group->type == GroupType::D || c.group->type == GroupType::Dinf)
    return dihedral(c, r, variable, budget);
  return std::nullopt;
}

} // namespace kov
