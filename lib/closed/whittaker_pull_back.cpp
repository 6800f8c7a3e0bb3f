#include "closed/whittaker_pull_back.hpp"

#include "closed/number_answers.hpp"
#include "exact/lists.hpp"
#include "galois/exponential_form.hpp"
#include "kovacic/residue_field.hpp"
#include "linode/value_at.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr std::size_t most_irregular_places = 6;
constexpr long largest_degree_of_r = 100; ///< of num(r) and den(r)

std::vector<const Singularity*> irregular_places(const Singularities& s) {
  std::vector<const Singularity*> found;
  if (s.infinity.kind == PlaceKind::irregular) found.push_back(&s.infinity);
  for (const Singularity& place : s.finite)
    if (place.kind == PlaceKind::irregular) found.push_back(&place);
  return found;
}

bool has_shape(const Singularities& s) {
  const auto ramified = [](const Singularity& p) { return p.kind == PlaceKind::ramified; };
  return degree(s.r.num()) <= largest_degree_of_r && degree(s.r.den()) <= largest_degree_of_r &&
         !ramified(s.infinity) && std::ranges::none_of(s.finite, ramified);
}

// The square root of u/a in the residue field.
std::optional<Poly> root_of(const Singularity& place, const NfElem& a, const Budget& budget) {
  const Poly square = scale(place.leading, inverse(a));
  if (degree(square) > 0 || place.degree() > 1)
    return kovacic::square_root(square, place.place, budget);
  const auto root = exact_sqrt(square.coeff(0));
  return root ? std::optional(Poly(*root)) : std::nullopt;
}

// The principal part of f' at one place, for one of its two signs.
RationalFunction slope_at(const Singularity& place, const Poly& root) {
  RationalFunction slope;
  for (std::size_t i = 0; i < place.sqrt_tail.size(); ++i) {
    const long order = place.nu() - static_cast<long>(i);
    slope +=
        place.at_infinity
            ? RationalFunction(Poly::monomial((root * place.sqrt_tail[i]).coeff(0), order))
            : kovacic::sum_over_roots(root * place.sqrt_tail[i] % place.place, place.place, order);
  }
  return slope;
}

// The candidates for the constant of f: the values that it has at the regular places.
std::vector<NfElem> values(const RationalFunction& f, const Singularities& s) {
  std::vector<NfElem> found;
  const auto add = [&](const std::optional<NfElem>& value) {
    if (value && !is_among(*value, found)) found.push_back(*value);
  };
  for (const Singularity& place : s.finite)
    if (place.kind != PlaceKind::irregular) add(value_at(f, place.place));
  if (s.infinity.kind != PlaceKind::irregular) add(value_at_infinity(f));
  return found;
}

bool is_constant(const RationalFunction& f) { return degree(f.num()) <= 0 && degree(f.den()) == 0; }

class Candidate {
public:
  Candidate(const Singularities& s, NfElem a, const RationalFunction& slope)
      : a_(std::move(a)), slope_(slope) {
    const RationalFunction u = derivative(slope) / slope;
    const RationalFunction half(Rational(1, 2));
    const RationalFunction schwarzian = derivative(u) - u * u * half;
    quotient_ = (s.r + schwarzian * half) / (slope * slope);
  }

  // (r + S/2)/f'^2 = a + b/f + c/f^2?
  [[nodiscard]] std::optional<WhittakerPullBack> with(const RationalFunction& f) const {
    const RationalFunction rest = (quotient_ - RationalFunction(Poly(a_))) * f * f; // b f + c
    const RationalFunction b = derivative(rest) / slope_;
    if (!is_constant(b)) return std::nullopt;
    const RationalFunction c = rest - b * f;
    if (!is_constant(c)) return std::nullopt;
    return WhittakerPullBack{a_, b.num().coeff(0), c.num().coeff(0), f};
  }

private:
  NfElem a_;
  RationalFunction slope_, quotient_;
};

std::optional<WhittakerPullBack> of_slope(const Singularities& s, const NfElem& a,
                                          const RationalFunction& slope, const Budget& budget) {
  const LogarithmicParts parts = logarithmic_parts(slope, budget);
  if (is_zero(slope) || !parts.residues.empty()) return std::nullopt;
  const Candidate candidate(s, a, slope);
  for (const NfElem& value : values(parts.rational_part, s)) {
    budget.check();
    const RationalFunction f = parts.rational_part - RationalFunction(Poly(value));
    if (auto found = candidate.with(f)) return found;
  }
  return std::nullopt;
}

std::optional<WhittakerPullBack> with_constant(const Singularities& s,
                                               const std::vector<const Singularity*>& places,
                                               const NfElem& a, const Budget& budget) {
  std::vector<RationalFunction> slopes;
  for (const Singularity* place : places) {
    const auto root = root_of(*place, a, budget);
    if (!root) return std::nullopt;
    slopes.push_back(slope_at(*place, *root));
  }
  // the sign of the first one is that of f
  for (unsigned long signs = 0; signs < 1UL << (slopes.size() - 1); ++signs) {
    RationalFunction slope = slopes.front();
    for (std::size_t i = 1; i < slopes.size(); ++i)
      slope += (signs >> (i - 1) & 1) != 0 ? -slopes[i] : slopes[i];
    if (auto found = of_slope(s, a, slope, budget)) return found;
  }
  return std::nullopt;
}

} // namespace

std::optional<WhittakerPullBack> whittaker_pull_back(const Singularities& s, const Budget& budget) {
  const auto places = irregular_places(s);
  if (places.empty() || places.size() > most_irregular_places || !has_shape(s)) return std::nullopt;
  const auto smallest = std::ranges::min_element(
      places, [](const auto* p, const auto* q) { return p->degree() < q->degree(); });
  for (const NfElem& a : kovacic::square_classes((*smallest)->leading, (*smallest)->place))
    if (auto found = with_constant(s, places, a, budget)) return found;
  return std::nullopt;
}

std::optional<Recognized> recognize_pull_back(const Singularities& s, const std::string& variable,
                                              const Budget& budget) {
  const auto found = whittaker_pull_back(s, budget);
  if (!found) return std::nullopt;
  const auto& [a, b, c, f] = *found;
  const NfElem m_squared = c + NfElem(Rational(1, 4));
  const bool bessel = is_zero(b);
  Recognized known;
  known.family = bessel ? Classical::bessel : Classical::whittaker;
  known.equation = std::string("u'' = (a ") + (bessel ? "" : "+ b/x ") +
                   "+ (m^2-1/4)/x^2) u in x = " + to_string(f, variable) + ", y = u/sqrt(x')";
  const auto root = exact_sqrt(m_squared);
  known.parameters = {{"m", root ? to_string(*root) : "sqrt(" + to_string(m_squared) + ")"},
                      {"a", to_string(a)}};
  if (!bessel) known.parameters.emplace_back("b", to_string(b));
  ClosedAnswer answer = whittaker_answer(b * b / (NfElem(4) * a), m_squared);
  const auto connected = [](GroupType t) {
    return t == GroupType::SL2 || t == GroupType::Borel || t == GroupType::Gm;
  };
  if (answer.group && connected(answer.group->type)) known.answer = std::move(answer);
  return known;
}

} // namespace kov
