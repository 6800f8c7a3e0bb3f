#include "galois/exponential_form.hpp"

#include "exact/error.hpp"

namespace kov {
namespace {

RationalFunction antiderivative(const Poly& f) {
  Poly sum(f.field());
  for (long i = 0; i <= degree(f); ++i)
    sum += Poly::monomial(f.coeff(i) / NfElem(i + 1), i + 1);
  return RationalFunction(sum);
}

// f % q, by one value where q is linear.
Poly modulo(const Poly& f, const Poly& q) {
  return degree(q) == 1 ? Poly(evaluate(f, -q.coeff(0) / lead(q))) : f % q;
}

} // namespace

LogarithmicParts logarithmic_parts(const RationalFunction& omega, const Budget& budget) {
  LogarithmicParts parts;
  auto [polynomial, rest_num] = divrem(omega.num(), omega.den());
  parts.rational_part = antiderivative(polynomial);
  RationalFunction rest(rest_num, omega.den());
  if (is_zero(rest)) return parts;
  const auto places = irreducible_factors(omega.den(), budget);
  for (const Factor& place : places) {
    const Poly& q = place.base;
    // lower the order of the pole at q one by one: (b/q^(k-1))' = -(k-1) b q'/q^k + b'/q^(k-1)
    for (long k = place.exponent; k > 1; --k) {
      const Poly qk = pow(q, static_cast<unsigned long>(k));
      if (!divides(qk, rest.den())) continue;
      const Poly cofactor = exact_div(rest.den(), qk);
      const Poly b = scale(rest.num() * inverse_mod(derivative(q) * cofactor % q, q) % q,
                           NfElem(Rational(-1, k - 1)));
      const RationalFunction piece(b, pow(q, static_cast<unsigned long>(k - 1)));
      parts.rational_part += piece;
      rest -= derivative(piece);
    }
  }
  const Poly slope = derivative(rest.den());
  for (const Factor& place : places) {
    const Poly& q = place.base;
    if (place.exponent == 1) { // num/den' at the roots of q
      parts.residues.push_back({q, modulo(rest.num(), q) * inverse_mod(modulo(slope, q), q) % q});
      continue;
    }
    if (!divides(q, rest.den())) continue;
    const Poly cofactor = exact_div(rest.den(), q);
    const Poly rho = rest.num() * inverse_mod(derivative(q) * cofactor % q, q) % q;
    parts.residues.push_back({q, rho});
  }
  return parts;
}

// v = N/D, v' = a/D^2, v'' = b/D^3, r = A/B.
NfElem wronskian_squared(const RationalFunction& v, const RationalFunction& r) {
  const Poly &N = v.num(), &D = v.den(), &A = r.num(), &B = r.den();
  const Poly a = derivative(N) * D - N * derivative(D);
  const Poly b = derivative(a) * D - scale(a * derivative(D), NfElem(2));
  const Poly w = B * (a * a - scale(N * b, NfElem(2))) + scale(A * N * N * D * D, NfElem(4));
  const Poly unit = B * pow(D, 4);
  if (is_zero(w)) return NfElem(0);
  const NfElem constant = lead(w) / lead(unit);
  KOV_ENSURE(w == scale(unit, constant));
  return constant;
}

std::optional<Integer> radical_order(const LogarithmicParts& parts) {
  if (degree(parts.rational_part.num()) > 0 || degree(parts.rational_part.den()) > 0)
    return std::nullopt;
  Integer m(1);
  for (const auto& residue : parts.residues) {
    if (degree(residue.rho) > 0 || !is_rational(residue.rho.coeff(0))) return std::nullopt;
    m = lcm(m, to_rational(residue.rho.coeff(0)).den());
  }
  return m;
}

std::string exponential_text(const Poly& p, const LogarithmicParts& parts,
                             const std::string& variable) {
  std::string text;
  if (degree(p) > 0) {
    text = to_string(p, variable);
    if (text != variable) text = "(" + text + ")";
  }
  const auto times = [&](const std::string& factor) {
    text += text.empty() ? factor : "*" + factor;
  };
  std::string integrals;
  for (const auto& [q, rho] : parts.residues) {
    if (degree(rho) > 0) {
      const std::string piece = to_string(RationalFunction(rho * derivative(q) % q, q), variable);
      integrals += integrals.empty() ? piece : " + " + piece;
      continue;
    }
    const NfElem e = rho.coeff(0);
    const std::string base = to_string(q, variable);
    const std::string wrapped = base == variable ? base : "(" + base + ")";
    const std::string exponent = to_string(e);
    if (is_one(e))
      times(wrapped);
    else if (is_rational(e) && is_integer(to_rational(e)) && sign(to_rational(e)) > 0)
      times(wrapped + "^" + exponent);
    else
      times(wrapped + "^(" + exponent + ")");
  }
  if (!is_zero(parts.rational_part)) times("exp(" + to_string(parts.rational_part, variable) + ")");
  if (!integrals.empty()) times("exp(int(" + integrals + ", " + variable + "))");
  return text.empty() ? "1" : text;
}

std::optional<Integer> radical_order(const ExponentialPair& pair, const Budget& budget) {
  const Poly& zeros = pair.v.num();
  const Poly& poles = pair.v.den();
  if (degree(zeros) - degree(poles) <= 0) return std::nullopt; // w/v has a pole at infinity
  Integer m(1);
  for (const Factor& pole : irreducible_factors(poles, budget))
    if (pole.exponent % 2 == 1) m = lcm(m, Integer(2));
  for (const Factor& zero : irreducible_factors(zeros, budget)) {
    if (zero.exponent > 1) return std::nullopt; // a multiple pole of w/v
    // residues 1/2 +- rho with rho^2 = w^2/(4 v'(c)^2)
    const Poly& q = zero.base;
    const Poly slope = derivative(q) * exact_div(zeros, q) % q;
    const Poly rho_squared = scale(poles * poles % q * inverse_mod(slope * slope % q, q) % q,
                                   pair.w_squared * NfElem(Rational(1, 4)));
    if (degree(rho_squared) > 0 || !is_rational(rho_squared.coeff(0))) return std::nullopt;
    const auto rho = exact_sqrt(to_rational(rho_squared.coeff(0)));
    if (!rho) return std::nullopt;
    m = lcm(m, (Rational(1, 2) + *rho).den());
  }
  return m;
}

} // namespace kov
