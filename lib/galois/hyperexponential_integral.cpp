#include "galois/hyperexponential_integral.hpp"

#include "exact/error.hpp"
#include "galois/exponential_form.hpp"

#include <optional>

namespace kov {
namespace {

// The residue of phi at the roots of q: 0 where phi has no pole; unset where it is not a constant, or
// the pole is not a simple one.
std::optional<NfElem> residue_at(const RationalFunction& phi, const Poly& q) {
  const auto [order, rest] = remove_factor(phi.den(), q);
  if (order > 1) return std::nullopt;
  if (order == 0) return NfElem(0);
  const Poly rho = phi.num() * inverse_mod(derivative(q) * rest % q, q) % q;
  if (degree(rho) > 0) return std::nullopt;
  return rho.coeff(0);
}

class Reduction {
public:
  Reduction(const RationalFunction& a, const RationalFunction& phi, const Budget& budget)
      : budget_(budget), a_(a), all_{phi, {}, a} {}

  // (u/q^(k-1))' + phi u/q^(k-1) = (lambda - k + 1) u q'/q^k + ... lowers the order k >= 2 of b at
  // q.
  void at(const Poly& q) {
    if (degree(gcd(q, all_.phi.den())) % std::max(degree(q), 1L) != 0) return; // only partly a pole
    const auto lambda = residue_at(all_.phi, q);
    if (!lambda) return;
    while (true) {
      budget_.check();
      const auto [k, rest] = remove_factor(all_.b.den(), q);
      const NfElem factor = *lambda - NfElem(k - 1);
      if (k < 2 || kov::is_zero(factor) || degree(gcd(rest, q)) > 0) return;
      const Poly u =
          scale(all_.b.num() * inverse_mod(derivative(q) * rest % q, q) % q, inverse(factor));
      take(RationalFunction(u, pow(q, static_cast<unsigned long>(k - 1))));
    }
  }

  // (c z^i)' + phi c z^i lowers the degree of b, as long as b grows like a polynomial.
  void at_infinity() {
    const RationalFunction& phi = all_.phi;
    const long m = is_zero(phi) ? -2 : -order_at_infinity(phi);
    while (!is_zero(all_.b)) {
      budget_.check();
      const long j = -order_at_infinity(all_.b);
      const long i = m >= 0 ? j - m : j + 1;
      if (i < 0) return;
      NfElem factor(m >= 0 ? 0 : i);
      if (m >= -1) factor += lead(phi.num()) / lead(phi.den());
      if (kov::is_zero(factor)) return;
      take(RationalFunction(Poly::monomial(lead(all_.b.num()) / lead(all_.b.den()) / factor, i)));
    }
  }

  HyperexponentialIntegral checked() {
    KOV_ENSURE(derivative(all_.w) + all_.phi * all_.w + all_.b == a_);
    return std::move(all_);
  }

private:
  void take(const RationalFunction& piece) {
    all_.w += piece;
    all_.b -= derivative(piece) + all_.phi * piece;
  }

  const Budget& budget_;
  RationalFunction a_;
  HyperexponentialIntegral all_;
};

} // namespace

HyperexponentialIntegral reduced_integral(const RationalFunction& a, const RationalFunction& phi,
                                          const std::vector<Poly>& places, const Budget& budget) {
  Reduction reduction(a, phi, budget);
  for (const Poly& q : places)
    reduction.at(q);
  reduction.at_infinity();
  return reduction.checked();
}

namespace {

// Factors and summands with as few signs and parentheses as the reader needs.
std::string bracketed_sum(const std::string& text) {
  return text.find_first_of("+-/ ") == std::string::npos ? text : "(" + text + ")";
}

std::string times(const std::string& a, const std::string& b) {
  if (a == "1") return b;
  if (b == "1") return a;
  return bracketed_sum(a) + "*" + b;
}

// a + b; a - b' where b begins with a negative number between parentheses: "(-1/2)*log(z)".
std::string plus(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return a + b;
  const auto end = b.find(')');
  if (!b.starts_with("(-") || b.find_first_not_of("0123456789/", 2) != end) return a + " + " + b;
  const std::string number = b.substr(2, end - 2);
  return a + " - " + times(number, b.substr(end + 2));
}

// int b dz
std::string rational_integral(const RationalFunction& b, const std::string& z,
                              const Budget& budget) {
  const LogarithmicParts parts = logarithmic_parts(b, budget);
  std::string text = is_zero(parts.rational_part) ? "" : to_string(parts.rational_part, z);
  for (const auto& [q, rho] : parts.residues)
    text = plus(text, degree(rho) == 0
                          ? times(to_string(rho.coeff(0)), "log(" + to_string(q, z) + ")")
                          : "int(" + to_string(RationalFunction(rho * derivative(q) % q, q), z) +
                                ", " + z + ")");
  return text;
}

// "2", "(1/2)", "sqrt(2)", "(1/2*sqrt(6))": the root of a positive rational number.
std::string root_text(const Rational& square) {
  const auto [outside, inside] = square_part(square.num() * square.den());
  const std::string factor = to_string(Rational(outside, square.den()));
  if (inside == Integer(1)) return bracketed_sum(factor);
  const std::string root = "sqrt(" + to_string(inside) + ")";
  return factor == "1" ? root : "(" + factor + "*" + root + ")";
}

// c int exp(a z^2 + b z) dz = c/2 sqrt(pi/-a) exp(-b^2/(4a)) erf(sqrt(-a) (z + b/(2a))), a < 0;
// erfi and sqrt(a) for a > 0.
std::optional<std::string> error_function(const HyperexponentialIntegral& x, const std::string& z) {
  const Poly& phi = x.phi.num();
  if (degree(x.phi.den()) > 0 || degree(phi) != 1 || degree(x.b.num()) > 0 ||
      degree(x.b.den()) > 0 || !is_rational(phi.coeff(1)))
    return std::nullopt;
  const Rational a = to_rational(phi.coeff(1)) * Rational(1, 2);
  const NfElem shift = phi.coeff(0) / phi.coeff(1); // b/(2a)
  const NfElem constant = -NfElem(a) * shift * shift;
  const std::string root = root_text(sign(a) < 0 ? -a : a);
  std::string text = times(to_string(x.b.num().coeff(0) * NfElem(Rational(1, 2))), "sqrt(pi)");
  if (root != "1") text += "/" + root;
  if (!is_zero(constant)) text += "*exp(" + to_string(constant) + ")";
  const std::string argument = to_string(Poly::z() + Poly(shift), z);
  return text + (sign(a) < 0 ? "*erf(" : "*erfi(") +
         (root == "1" ? argument : root + "*" + bracketed_sum(argument)) + ")";
}

// int c exp(a z)/(z - d) dz = c exp(a d) Ei(a (z - d)), for each simple pole d in K.
std::optional<std::string> exponential_integral(const HyperexponentialIntegral& x,
                                                const std::string& z, const Budget& budget) {
  if (degree(x.phi.den()) > 0 || degree(x.phi.num()) != 0) return std::nullopt;
  const LogarithmicParts parts = logarithmic_parts(x.b, budget);
  if (!is_zero(parts.rational_part)) return std::nullopt;
  const NfElem a = x.phi.num().coeff(0);
  std::string text;
  for (const auto& [q, rho] : parts.residues) {
    if (degree(q) > 1) return std::nullopt;
    const NfElem d = -q.coeff(0) / lead(q);
    const std::string factor =
        is_zero(a * d) ? to_string(rho.coeff(0))
                       : times(to_string(rho.coeff(0)), "exp(" + to_string(a * d) + ")");
    text = plus(text, times(factor, "Ei(" + to_string(scale(Poly::z() - Poly(d), a), z) + ")"));
  }
  return text;
}

} // namespace

std::string to_string(const HyperexponentialIntegral& x, const std::string& z,
                      const Budget& budget) {
  if (is_zero(x.phi))
    return plus(is_zero(x.w) ? "" : to_string(x.w, z), rational_integral(x.b, z, budget));
  const std::string e = exponential_text(Poly(1), logarithmic_parts(x.phi, budget), z);
  const std::string elementary = is_zero(x.w) ? "" : times(to_string(x.w, z), e);
  if (is_zero(x.b)) return elementary.empty() ? "0" : elementary;
  if (const auto named = error_function(x, z)) return plus(elementary, *named);
  if (const auto named = exponential_integral(x, z, budget)) return plus(elementary, *named);
  return plus(elementary, "int(" + times(to_string(x.b, z), e) + ", " + z + ")");
}

} // namespace kov
