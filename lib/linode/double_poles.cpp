#include "linode/double_poles.hpp"

#include "exact/modular.hpp"

#include <map>

namespace kov {
namespace {

// Delta^2 of many double poles at once.  For a double pole den''(c)/2 is the leading coefficient of
// den, so that Delta^2 = 1 + 8 num(c)/den''(c).  A value that is a rational number of moderate size
// is guessed modulo one prime; all places with the same guess are then checked by one exact
// division.
void find_equal_ones(const RationalFunction& r, const std::vector<Factor>& factors,
                     std::vector<std::optional<Rational>>& answer) {
  const PrimeIdeal prime = PrimeIdeals::large(r.field()).next();
  const auto num = prime.reduce(r.num());
  const auto den = prime.reduce(r.den());
  if (!num || !den) return;
  const NmodPoly second = derivative(derivative(*den));
  const nmod_t mod = num->mod();
  std::map<Rational, std::vector<std::size_t>> guesses;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    if (factors[i].exponent != 2) continue;
    const auto q = prime.reduce(factors[i].base);
    const auto at = q ? roots(*q) : std::vector<mp_limb_t>{};
    const mp_limb_t below = at.empty() ? 0 : evaluate(second, at.front());
    if (below == 0) continue;
    const mp_limb_t value = nmod_div(nmod_mul(8, evaluate(*num, at.front()), mod), below, mod);
    if (const auto guess =
            rational_reconstruction(Integer(nmod_add(value, 1, mod)), Integer(prime.p)))
      guesses[*guess].push_back(i);
  }
  const Poly exact_second = derivative(derivative(r.den()));
  for (const auto& [guess, places] : guesses) {
    if (places.size() < 4) continue; // a few places are as cheap one by one
    std::vector<Poly> layer;
    for (const std::size_t i : places)
      layer.push_back(factors[i].base);
    const Poly difference =
        scale(r.num(), NfElem(8)) - scale(exact_second, NfElem(guess - Rational(1)));
    if (!divides(product(std::move(layer)), difference)) continue;
    for (const std::size_t i : places)
      answer[i] = guess;
  }
}

// With q the product of (z - c) over the open places, den = q^2 s:  b = num(c)/(q'(c)^2 s(c)), and
// num may be replaced by its remainder modulo q.
void evaluate_the_rest(const RationalFunction& r, const std::vector<Factor>& factors,
                       std::vector<std::optional<Rational>>& answer, const Budget& budget) {
  if (!r.field()->is_rational()) return;
  std::vector<std::size_t> open;
  std::vector<Poly> layer;
  for (std::size_t i = 0; i < factors.size(); ++i)
    if (factors[i].exponent == 2 && degree(factors[i].base) == 1 && !answer[i]) {
      open.push_back(i);
      layer.push_back(factors[i].base);
    }
  if (open.empty()) return;
  const Poly q = product(std::move(layer));
  const Poly num = r.num() % q;
  const Poly slope = derivative(q);
  const Poly rest = exact_div(r.den(), q * q);
  for (const std::size_t i : open) {
    budget.check();
    const NfElem c = -factors[i].base.coeff(0);
    const NfElem d = evaluate(slope, c);
    answer[i] =
        Rational(1) + Rational(4) * to_rational(evaluate(num, c) / (d * d * evaluate(rest, c)));
  }
}

} // namespace

std::vector<std::optional<Rational>> double_pole_delta_squared(const RationalFunction& r,
                                                               const std::vector<Factor>& factors,
                                                               const Budget& budget) {
  std::vector<std::optional<Rational>> answer(factors.size());
  find_equal_ones(r, factors, answer);
  evaluate_the_rest(r, factors, answer, budget);
  return answer;
}

} // namespace kov
