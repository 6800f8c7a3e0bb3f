#include "closed/recognize_families.hpp"

#include "closed/number_answers.hpp"
#include "exact/error.hpp"

namespace kov::recognition {
namespace {

// z = c + 1/x takes the place c to infinity.
Moebius to_infinity(const Singularities& s) {
  for (const Singularity& place : s.finite)
    if (place.kind == PlaceKind::irregular || place.kind == PlaceKind::ramified)
      return {-place.place.coeff(0), NfElem(1), NfElem(1), NfElem(0)};
  return {};
}

Moebius shift(const NfElem& by) { return {NfElem(1), by, NfElem(0), NfElem(1)}; }

// a/sqrt(b)
std::string quotient_text(const NfElem& a, const NfElem& b) {
  if (is_zero(a)) return "0";
  if (const auto root = root_in(b)) return to_string(a / *root);
  const std::string text = to_string(a);
  const bool plain = text.find_first_of("+-*/ ") == std::string::npos;
  return (plain ? text : "(" + text + ")") + "/" + root_text(b);
}

std::optional<Recognized> polynomial(const RationalFunction& r, Moebius m) {
  const Poly& f = r.num();
  Recognized out;
  out.family = polynomial_family(degree(f));
  out.equation = canonical_equation(out.family);
  out.answer = polynomial_answer(f);
  if (degree(f) == 0) {
    out.parameters = {{"c", to_string(f.coeff(0))}};
  } else if (degree(f) == 1) { // a x + b: x + b/a, scaled by the cube root of a
    m = composed(m, shift(-f.coeff(0) / f.coeff(1)));
    out.parameters = {{"a", to_string(f.coeff(1))}};
  } else if (degree(f) == 2) { // u x^2 + v x + w = u (x + v/(2u))^2 + w - v^2/(4u)
    const NfElem u = f.coeff(2);
    m = composed(m, shift(-f.coeff(1) / (u + u)));
    const NfElem w = f.coeff(0) - f.coeff(1) * f.coeff(1) / (NfElem(4) * u);
    out.parameters = {{"u", to_string(u)}, {"w", to_string(w)}, {"a", quotient_text(w, u)}};
  } else {
    out.parameters = {{"r", to_string(f, "x")}};
  }
  out.z_of_x = m;
  return out;
}

// A + b/x + c/x^2.
std::optional<Recognized> one_regular(const RationalFunction& r, Moebius m) {
  const RationalFunction times_x2 = r * RationalFunction(Poly::z() * Poly::z());
  if (degree(times_x2.den()) > 0 || degree(times_x2.num()) > 2) return std::nullopt;
  NfElem a = times_x2.num().coeff(2);
  NfElem b = times_x2.num().coeff(1);
  const NfElem c = times_x2.num().coeff(0);
  const NfElem m2 = c + NfElem(Rational(1, 4));
  if (is_zero(a)) // the order of infinity is 1
    return Recognized{Classical::bessel,
                      canonical_equation(Classical::bessel, true),
                      {{"m", root_text(NfElem(4) * m2)}, {"b", to_string(b)}},
                      m,
                      ramified_bessel_answer(NfElem(4) * m2)};
  const NfElem k2 = b * b / (NfElem(4) * a);
  const ClosedAnswer answer = whittaker_answer(k2, m2);
  if (is_zero(b))
    return Recognized{Classical::bessel,
                      canonical_equation(Classical::bessel),
                      {{"m", root_text(m2)}, {"a", to_string(a)}},
                      m,
                      answer};
  if (const auto root = root_in(a)) { // x / (2 sqrt a): 1/4 - k/x + ...
    const NfElem scale = NfElem(1) / (*root + *root);
    m = composed(m, {scale, NfElem(0), NfElem(0), NfElem(1)});
    return Recognized{Classical::whittaker,
                      "y'' = (1/4 - k/x + (m^2-1/4)/x^2) y",
                      {{"k", to_string(-b * scale)}, {"m", root_text(m2)}},
                      m,
                      answer};
  }
  return Recognized{Classical::whittaker,
                    canonical_equation(Classical::whittaker),
                    {{"k", quotient_text(-b, NfElem(4) * a)},
                     {"m", root_text(m2)},
                     {"a", to_string(a)},
                     {"b", to_string(b)}},
                    m,
                    answer};
}

// Two regular places, a and q by the identity of recognition.md 7.
std::optional<Recognized> mathieu(const RationalFunction& r, const Moebius& m) {
  const auto p = exact_sqrt(r.den());
  if (!p || degree(*p) != 2) return std::nullopt;
  const Moebius centre = shift(-p->coeff(1) / NfElem(2));
  const Poly places = taylor_shift(*p, centre.b); // x^2 - d
  const NfElem d = -places.coeff(0);
  const Poly squares = scale(Poly::z() * Poly::z() + Poly(d), NfElem(Rational(3, 8)));
  const auto [line, rest] = divrem(taylor_shift(r.num(), centre.b) + squares, places);
  if (!is_zero(rest) || degree(line) != 1) return std::nullopt;
  const NfElem alpha = line.coeff(1);
  const ClassicalWords& words = words_of(Classical::mathieu);
  return Recognized{words.family,
                    words.equation,
                    {{"a", to_string(NfElem(4) * line.coeff(0) - NfElem(Rational(1, 2)))},
                     {"q", root_text(NfElem(4) * d * alpha * alpha)}},
                    composed(m, centre),
                    ClosedAnswer::of({GroupType::SL2, {}}, words.sl2)};
}

} // namespace

std::optional<Recognized> irregular(const Singularities& s, long regular_places) {
  if (regular_places > 2) return std::nullopt;
  Moebius m = to_infinity(s);
  RationalFunction r = m.is_identity() ? s.r : pull_back(s.r, m);
  if (regular_places == 0) {
    if (degree(r.den()) > 0) return std::nullopt;
    return polynomial(r, m);
  }
  if (regular_places == 2) return mathieu(r, m);
  const NfElem at = -r.den().coeff(degree(r.den()) - 1) / NfElem(degree(r.den())); // the only pole
  if (is_zero(at)) return one_regular(r, m);
  const Moebius centre = shift(at);
  return one_regular(pull_back(r, centre), composed(m, centre));
}

} // namespace kov::recognition
