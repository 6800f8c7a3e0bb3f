#include "closed/confluent.hpp"

#include "closed/half.hpp"
#include "closed/riemann.hpp"

#include <algorithm>

namespace kov {
namespace {

std::optional<Rational> rational_root(const NfElem& square) {
  return is_rational(square) ? exact_sqrt(to_rational(square)) : std::nullopt;
}

bool natural(const Rational& q) { return is_integer(q) && sign(q) >= 0; }
bool negative(const Rational& q) { return is_integer(q) && sign(q) < 0; }

} // namespace

ClosedAnswer whittaker_answer(const NfElem& k2, const NfElem& m2) {
  const auto odd = [](const Rational& s) { return is_integer(s) && !is_integer(s * half); };
  const auto k = rational_root(k2);
  const auto m = rational_root(m2);
  bool reducible = false;
  if (k && m) {
    reducible = odd(*k + *k + *m + *m) || odd(*k + *k - *m - *m);
  } else {
    const auto sums = integer_sums(NfElem(4) * (k2 + m2), NfElem(16) * k2 * m2); // of 2k and 2m
    reducible = std::ranges::any_of(sums, [&](const Integer& s) { return odd(Rational(s)); });
  }
  if (!reducible)
    return ClosedAnswer::of({GroupType::SL2, {}}, "no k +- m is half of an odd integer");
  if (k && m) {
    const Rational p = *k + *m - half;
    const Rational q = *k - *m - half;
    if ((natural(p) && negative(q)) || (negative(p) && natural(q)))
      return ClosedAnswer::of({GroupType::Gm, {}},
                              "of k + m - 1/2 and k - m - 1/2 one is a natural number and one a "
                              "negative integer (Martinet and Ramis): both exponentials occur");
  }
  return ClosedAnswer::of({GroupType::Borel, {}},
                          "some k +- m is half of an odd integer, and k + m - 1/2, k - m - 1/2 are "
                          "not a natural number and a negative integer (Martinet and Ramis)");
}

ClosedAnswer ramified_bessel_answer(const NfElem& m2) {
  const auto m = rational_root(m2);
  if (m && m->den() == Integer(2))
    return ClosedAnswer::of({GroupType::Dinf, {}}, "the order of Bessel's equation is in 1/2 + Z");
  return ClosedAnswer::of({GroupType::SL2, {}}, "the order of Bessel's equation is not in 1/2 + Z");
}

ClosedAnswer weber_answer(const NfElem& a2) {
  const auto a = rational_root(a2);
  if (a && is_integer(*a) && !is_integer(*a * half))
    return ClosedAnswer::of({GroupType::Borel, {}},
                            "a = +-" + to_string(*a) +
                                " is an odd integer: one exponential solution");
  return ClosedAnswer::of({GroupType::SL2, {}}, "a is not an odd integer");
}

ClosedAnswer polynomial_answer(long degree) {
  if (degree % 2 != 0)
    return ClosedAnswer::of({GroupType::SL2, {}},
                            "r is a polynomial of odd degree: no exponential solution, and the "
                            "identity component is not abelian");
  return {std::nullopt, Truth::no,
          "r is a polynomial, not constant: an invariant of degree 4 would "
          "have no poles and decrease at infinity"};
}

ClosedAnswer constant_answer() {
  return ClosedAnswer::of({GroupType::Gm, {}}, "two exponential functions are the solutions");
}

ClosedAnswer airy_answer() { return ClosedAnswer::of({GroupType::SL2, {}}, "Airy's equation"); }

} // namespace kov
