#include "closed/recognize_families.hpp"

#include "closed/lame.hpp"
#include "closed/number_answers.hpp"
#include "exact/error.hpp"

#include <algorithm>

namespace kov::recognition {
namespace {

const NfElem quarter{Rational(1, 4)};

bool counts(const Singularity& s) {
  return s.kind == PlaceKind::simple || s.kind == PlaceKind::regular;
}

// All places, infinity last.
std::vector<Singularity> places_of(const Singularities& s) {
  std::vector<Singularity> all = s.finite;
  if (counts(s.infinity)) all.push_back(s.infinity);
  return all;
}

// The product of the finite places.
Poly singular_polynomial(const Singularities& s) {
  Poly p(1);
  for (const Singularity& place : s.finite)
    p *= place.place;
  return p;
}

// An equation with at most three regular places is fixed by them and by the exponents: r = N/P^2
// with deg N <= 2, N = (Delta^2 - 1)/4 P'^2 at the roots of P and at infinity.
RationalFunction rebuilt(const Singularities& s) {
  const Poly p = singular_polynomial(s);
  const Poly slope = derivative(p) * derivative(p);
  Poly n(0);
  for (const Singularity& place : s.finite) {
    const Poly& q = place.place;
    const Poly cofactor = exact_div(p, q);
    const Poly value = scale(place.delta_squared - Poly(1), quarter) * slope % q;
    n += (value * inverse_mod(cofactor % q, q) % q) * cofactor;
  }
  if (counts(s.infinity)) n += scale(p, (s.infinity.delta_squared.coeff(0) - NfElem(1)) * quarter);
  return {n, p * p};
}

NfElem trace(const Poly& g, const Poly& q) {
  NfElem sum(0);
  for (long j = 0; j < degree(q); ++j)
    sum += (shift_left(g, j) % q).coeff(j);
  return sum;
}

// The characteristic polynomial of g in K[c]/q, deg q <= 3, by Newton's identities.
Poly characteristic(const Poly& g, const Poly& q) {
  const long n = degree(q);
  std::vector<NfElem> p{NfElem(0)};
  Poly power(1);
  for (long k = 1; k <= n; ++k)
    p.push_back(trace(power = power * g % q, q));
  std::vector<NfElem> e{NfElem(1)};
  for (long k = 1; k <= n; ++k) {
    NfElem sum(0);
    for (long i = 1; i <= k; ++i) {
      const NfElem term = e[static_cast<std::size_t>(k - i)] * p[static_cast<std::size_t>(i)];
      sum += i % 2 == 1 ? term : -term;
    }
    e.push_back(sum / NfElem(k));
  }
  Poly f(0);
  for (long k = 0; k <= n; ++k)
    f += Poly::monomial(
        k % 2 == 0 ? e[static_cast<std::size_t>(k)] : -e[static_cast<std::size_t>(k)], n - k);
  return f;
}

std::string exponent_text(const Singularity& place) {
  if (degree(place.delta_squared) <= 0) return root_text(place.delta_squared.coeff(0));
  return "sqrt(" + to_string(place.delta_squared, "c") + ") at c: " + to_string(place.place, "c") +
         " = 0";
}

// 0, 1, infinity to three rational places.
std::optional<Moebius> standard_map(const std::vector<Singularity>& places) {
  for (const Singularity& place : places)
    if (place.degree() != 1) return std::nullopt;
  const auto at = [&](std::size_t i) { return -places[i].place.coeff(0); };
  const NfElem p1 = at(0);
  const NfElem p2 = at(1);
  if (places[2].at_infinity) return Moebius{p2 - p1, p1, NfElem(0), NfElem(1)};
  const NfElem p3 = at(2);
  const NfElem k = (p2 - p1) / (p3 - p2);
  return Moebius{p3 * k, p1, k, NfElem(1)};
}

// The exponents alone, where every square is a constant.
std::optional<SquaredExponents> constant_squares(const std::vector<Singularity>& places) {
  SquaredExponents e;
  std::size_t i = 0;
  for (const Singularity& place : places)
    for (long j = 0; j < place.degree(); ++j) {
      if (degree(place.delta_squared) > 0) return std::nullopt;
      e[i++] = place.delta_squared.coeff(0);
    }
  return e;
}

Poly product_of_squares(const std::vector<Singularity>& places) {
  Poly squares(1);
  for (const Singularity& place : places)
    squares *= place.at_infinity ? Poly::z() - place.delta_squared
                                 : characteristic(place.delta_squared, place.place);
  return squares;
}

std::optional<Recognized> riemann(const Singularities& s) {
  const std::vector<Singularity> places = places_of(s);
  const auto squares = constant_squares(places);
  Recognized out;
  out.family = Classical::riemann;
  out.equation = canonical_equation(out.family);
  out.z_of_x = standard_map(places);
  if (out.z_of_x)
    KOV_ENSURE(pull_back(s.r, *out.z_of_x) == riemann_equation(*squares));
  else
    KOV_ENSURE(rebuilt(s) == s.r);
  static const char* const names[] = {"l", "m", "n"};
  for (const Singularity& place : places) {
    const std::string text = exponent_text(place);
    for (long i = 0; i < place.degree(); ++i)
      out.parameters.emplace_back(names[out.parameters.size()],
                                  i > 0 && degree(place.delta_squared) > 0 ? "its conjugate"
                                                                           : text);
  }
  out.answer = squares ? riemann_answer(*squares) : riemann_answer(product_of_squares(places));
  return out;
}

// r = (l^2 - 1)/4 disc(P)/P^2, or (l^2 - 1)/(4 P^2) with one place at infinity.
std::optional<Recognized> euler(const Singularities& s) {
  const Poly p = singular_polynomial(s);
  const Singularity& place = s.finite.front();
  if (degree(place.delta_squared) > 0) throw InternalError("two regular places differ");
  const NfElem square = place.delta_squared.coeff(0);
  NfElem factor = (square - NfElem(1)) * quarter;
  if (degree(p) == 2) factor *= p.coeff(1) * p.coeff(1) - NfElem(4) * p.coeff(0);
  KOV_ENSURE(s.r == RationalFunction(Poly(factor), p * p));
  Recognized out{Classical::euler,
                 canonical_equation(Classical::euler),
                 {{"l", root_text(square)}},
                 {},
                 euler_answer(square)};
  if (place.degree() == 1) {
    const NfElem c = -place.place.coeff(0);
    if (degree(p) == 1)
      out.z_of_x = Moebius{NfElem(1), c, NfElem(0), NfElem(1)};
    else // (d x + c)/(x + 1)
      out.z_of_x = Moebius{-s.finite[1].place.coeff(0), c, NfElem(1), NfElem(1)};
  }
  return out;
}

// The place that is to go to infinity: of degree 1, and Delta^2 = 1/4 at all others.
std::optional<Moebius> star_to_infinity(const Singularities& s) {
  const auto half = [](const Singularity& p) { return p.delta_squared == Poly(quarter); };
  const auto finite = static_cast<long>(s.finite.size());
  const auto halves = std::ranges::count_if(s.finite, half);
  if (counts(s.infinity) && halves == finite) return Moebius{};
  if (counts(s.infinity) && !half(s.infinity)) return std::nullopt;
  for (const Singularity& p : s.finite)
    if (p.degree() == 1 && halves - (half(p) ? 1 : 0) == finite - 1)
      return Moebius{-p.place.coeff(0), NfElem(1), NfElem(1), NfElem(0)};
  return std::nullopt;
}

std::string index_text(const NfElem& alpha) {
  const LameIndex index = lame_index(alpha);
  if (index.n) return to_string(*index.n);
  return "-1/2 + sqrt(" + to_string(NfElem(1) + NfElem(4) * alpha) + ")/2";
}

// n up to here is asked for its classical criterion: n^2 operations with numbers of about n digits.
bool moderate(const LameIndex& index) { return !index.n || *index.n < Rational(40); }

// r = f''/(4f) - 3 f'^2/(16 f^2) + (alpha x + B)/f with f = 4P, r = N/P^2:
// 16 f (alpha x + B) = 256 N - 4 f f'' + 3 f'^2.
std::optional<Recognized> lame(const Singularities& s, const Budget& budget) {
  const auto star = star_to_infinity(s);
  if (!star) return std::nullopt;
  RationalFunction r = star->is_identity() ? s.r : pull_back(s.r, *star);
  const auto cubic = exact_sqrt(r.den());
  if (!cubic || degree(*cubic) != 3) throw InternalError("three places with Delta = 1/2 expected");
  const Moebius centre{NfElem(1), -cubic->coeff(2) / NfElem(3), NfElem(0), NfElem(1)};
  const Poly f = scale(taylor_shift(*cubic, centre.b), NfElem(4));
  const Poly slope = derivative(f);
  const Poly left = scale(taylor_shift(r.num(), centre.b), NfElem(256)) -
                    scale(f * derivative(slope), NfElem(4)) + scale(slope * slope, NfElem(3));
  const auto [line, remainder] = divrem(left, scale(f, NfElem(16)));
  KOV_ENSURE(is_zero(remainder) && degree(line) <= 1 && is_zero(f.coeff(2)));
  const NfElem alpha = line.coeff(1);
  const LameParameters<NfElem> p{line.coeff(0), -f.coeff(1), -f.coeff(0)};
  Recognized out;
  out.family = Classical::lame;
  out.equation = canonical_equation(out.family);
  out.parameters = {{"n", index_text(alpha)},
                    {"B", to_string(p.b)},
                    {"g2", to_string(p.g2)},
                    {"g3", to_string(p.g3)}};
  out.z_of_x = composed(*star, centre);
  if (moderate(lame_index(alpha))) out.answer = lame_answer(alpha, p, budget);
  return out;
}

std::optional<Recognized> heun(const Singularities& s) {
  Recognized out;
  out.family = Classical::heun;
  out.equation = canonical_equation(out.family);
  for (const Singularity& place : places_of(s))
    for (long i = 0; i < place.degree(); ++i)
      out.parameters.emplace_back(
          "exponent difference " + std::to_string(out.parameters.size() + 1), exponent_text(place));
  return out;
}

} // namespace

std::optional<Recognized> regular(const Singularities& s, long places, const Budget& budget) {
  if (places == 2) return euler(s);
  if (places == 3) return riemann(s);
  if (auto found = lame(s, budget)) return found;
  return heun(s);
}

} // namespace kov::recognition
