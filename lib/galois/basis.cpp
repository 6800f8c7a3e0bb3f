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

std::string product(const std::string& a, const std::string& b) {
  return a == "1" ? b : a + "*" + b;
}

// A sum, or what begins with a sign, between parentheses.
std::string as_factor(const std::string& text) {
  return text.find_first_of("+- ") == std::string::npos ? text : "(" + text + ")";
}

// Solutions are written in this variable, times exp(int gauge).
struct Paper {
  const std::string& z;
  const RationalFunction& gauge;
  const Budget& budget;

  // P exp(int theta)
  [[nodiscard]] std::string exponential(const Poly& p, const RationalFunction& theta) const {
    // of r = 0 theta is over Q, wherever the gauge is
    const Field field = common_field(theta.field(), gauge.field());
    const RationalFunction sum = coerce(theta, field) + coerce(gauge, field);
    return exponential_text(p, logarithmic_parts(sum, budget), z);
  }
  // f^(1/n)
  [[nodiscard]] std::string root(const RationalFunction& f, long n) const {
    const std::string text = to_string(f, z);
    if (!is_zero(gauge)) return exponential(Poly(1), derivative(f) / (RationalFunction(n) * f));
    if (text == "1") return text;
    return n == 2 ? "sqrt(" + text + ")" : bracketed(text) + "^(1/" + std::to_string(n) + ")";
  }
};

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
  KOV_ENSURE(derivative(a) / a + phi == RationalFunction(-2) * y.omega());
  return reduced_integral(a, phi, places, budget);
}

bool is_long(const ExponentialSolution& y) {
  return degree(y.p) > printable_degree || degree(y.theta.den()) > printable_degree;
}

Basis with_second_line(const LiouvillianSolution& found, const RationalFunction& r,
                       const Paper& paper) {
  const ExponentialSolution& y = *found.exponential;
  KOV_ENSURE(solves(y, r));
  const std::string first = paper.exponential(y.p, y.theta);
  if (degree(y.p) > readable_degree || degree(y.theta.den()) > readable_degree)
    return {first, product(first, "int(1/(" + text(found, paper.z, paper.budget) + ")^2, " +
                                      paper.z + ")")};
  const std::string integral = to_string(inverse_square(y, paper.budget), paper.z, paper.budget);
  return {first, first == "1" ? integral : product(first, as_factor(integral))};
}

// ----- y1 y2 = v with a Wronskian outside K

Basis two_lines(const ExponentialPair& pair, const RationalFunction& r, const Paper& paper) {
  const RationalFunction& v = pair.v;
  const RationalFunction slope = derivative(v);
  KOV_ENSURE(slope * slope - RationalFunction(2) * v * derivative(slope) +
                 RationalFunction(4) * r * v * v ==
             RationalFunction(Poly(pair.w_squared)));
  const HyperexponentialIntegral inverse =
      reduced_integral(RationalFunction(1) / v, RationalFunction(), {}, paper.budget);
  const std::string exponent = "1/2*sqrt(" + to_string(pair.w_squared) + ")*" +
                               as_factor(to_string(inverse, paper.z, paper.budget));
  const std::string front = paper.root(v, 2);
  return {product(front, "exp(" + exponent + ")"), product(front, "exp(-" + exponent + ")")};
}

// ----- (y1 y2)^2 = F = k F0 g^2; T = sqrt(k F0/w^2), u'/u = 1/(g T)

class Dihedral {
public:
  Dihedral(const DihedralCurve& c, const RationalFunction& r, const Paper& paper)
      : c_(c), z_(paper.z), budget_(paper.budget), t_squared_(scale(c.branch, c.k / c.w_squared)),
        phi_(derivative(c.branch), scale(c.branch, NfElem(2))), root_(c.branch),
        front_(paper.root(RationalFunction(c.branch) * c.g * c.g, 4)) {
    if (const auto square = exact_sqrt(c.k / c.w_squared))
      unit_ = *square;
    else
      root_ = t_squared_;
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
    const std::string h = "(" + to_string(a, z_) + " + " + times_t(b) + ")";
    const std::string root = "1/" + to_string(Integer(2) * n);
    return {product(front_, h + "^(" + root + ")"), product(front_, h + "^(-" + root + ")")};
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
    return exponentials(is_zero(u.b) ? times_t(u.w * RationalFunction(Rational(1, 2)))
                                     : as_it_is());
  }

private:
  [[nodiscard]] Basis exponentials(const std::string& exponent) const {
    return {product(front_, "exp(" + exponent + ")"), product(front_, "exp(-" + exponent + ")")};
  }
  [[nodiscard]] std::string as_it_is() const {
    return "1/2*int(" +
           bracketed(to_string(RationalFunction(1) / (RationalFunction(Poly(unit_)) * c_.g), z_)) +
           "/" + root_text() + ", " + z_ + ")";
  }
  [[nodiscard]] std::string root_text() const { return "sqrt(" + to_string(root_, z_) + ")"; }
  [[nodiscard]] std::string times_t(const RationalFunction& f) const {
    return factor_times(f * RationalFunction(Poly(unit_)), root_text(), z_);
  }

  static std::vector<Poly> distinct(const std::vector<Poly>& places) {
    std::vector<Poly> all;
    for (const Poly& q : places)
      if (std::ranges::none_of(all, [&](const Poly& p) { return degree(gcd(p, q)) > 0; }))
        all.push_back(q);
    return all;
  }

  const DihedralCurve& c_;
  std::string z_;
  const Budget& budget_;
  Poly t_squared_;
  RationalFunction phi_; ///< T'/T
  NfElem unit_{1};       ///< T = unit sqrt(root)
  Poly root_;
  std::string front_;
};

// F = exp(2 int phi), if it is a rational function with a constant w^2.
std::optional<QuarticRoot> square_of_product(const RationalFunction& phi, const Singularities& s,
                                             const Budget& budget) {
  QuarticRoot root{coerce(Poly(1), phi.field()), std::vector<long>(s.finite.size()), NfElem(1), {}};
  const LogarithmicParts parts = logarithmic_parts(phi, budget);
  if (!is_zero(parts.rational_part)) return std::nullopt;
  RationalFunction f(1);
  for (const auto& [q, rho] : parts.residues) {
    if (degree(rho) > 0 || !is_rational(rho.coeff(0))) return std::nullopt;
    const Rational e = Rational(2) * to_rational(rho.coeff(0));
    if (!is_integer(e) || abs(e) > Rational(printable_degree)) return std::nullopt;
    f *= pow(RationalFunction(q), to_long(e.num()));
    const auto place =
        std::ranges::find_if(s.finite, [&q = q](const Singularity& p) { return p.place == q; });
    if (place == s.finite.end())
      root.q *= q; // y1 y2 has a simple zero at an ordinary point
    else
      root.e[static_cast<std::size_t>(place - s.finite.begin())] = to_long(e.num());
  }
  const RationalFunction slope = derivative(f);
  const RationalFunction w_squared = RationalFunction(Rational(3, 4)) * slope * slope / f -
                                     derivative(slope) + RationalFunction(4) * s.r * f;
  if (degree(w_squared.num()) != 0 || degree(w_squared.den()) != 0) return std::nullopt;
  root.w_squared = w_squared.num().coeff(0);
  return root;
}

// The quaternion group has three products y1 y2; one of them is known where they are not conjugate.
std::optional<Basis> quaternion(const LiouvillianSolution& found, const Classification& c,
                                const RationalFunction& r, const Paper& paper) {
  if (found.minimal_polynomial.size() != 3 || !c.local) return std::nullopt;
  const auto root = square_of_product(-found.minimal_polynomial[1], *c.local, paper.budget);
  if (!root) return std::nullopt;
  const DihedralCurve curve = dihedral_curve(*root, *c.local);
  const Integer n(2);
  const auto a = torsion_function(curve, n, paper.budget);
  return a ? std::optional(Dihedral(curve, r, paper).finite(*a, n)) : std::nullopt;
}

std::optional<Basis> dihedral(const LiouvillianSolution& found, const Classification& c,
                              const RationalFunction& r, const Paper& paper) {
  if (!c.curve) return quaternion(found, c, r, paper);
  const Dihedral formulas(*c.curve, r, paper);
  if (!c.dihedral || c.dihedral->finite != Truth::yes) return formulas.infinite();
  const auto a =
      c.dihedral->a ? c.dihedral->a : torsion_function(*c.curve, c.dihedral->n, paper.budget);
  return a ? std::optional(formulas.finite(*a, c.dihedral->n)) : std::nullopt;
}

} // namespace

std::optional<Basis> basis(const Classification& c, const RationalFunction& r,
                           const std::vector<LiouvillianSolution>& found,
                           const std::string& variable, const RationalFunction& gauge,
                           const Budget& budget) {
  if (!c.group || found.empty()) return std::nullopt;
  const Paper paper{variable, gauge, budget};
  if (found.size() == 2) {
    const ExponentialSolution &y = *found[0].exponential, &other = *found[1].exponential;
    return Basis{paper.exponential(y.p, y.theta), paper.exponential(other.p, other.theta)};
  }
  if (found[0].exponential)
    return is_long(*found[0].exponential) ? std::nullopt
                                          : std::optional(with_second_line(found[0], r, paper));
  if (c.pair) return two_lines(*c.pair, r, paper);
  if (c.group->type == GroupType::D || c.group->type == GroupType::Dinf)
    return dihedral(found[0], c, r, paper);
  return std::nullopt;
}

} // namespace kov
