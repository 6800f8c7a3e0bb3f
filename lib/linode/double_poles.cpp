#include "linode/double_poles.hpp"

#include "exact/in_pairs.hpp"
#include "exact/lists.hpp"
#include "exact/modular.hpp"

namespace kov {
namespace {

constexpr int max_primes = 64;      // for one guess: numbers of about 550 digits
constexpr std::size_t worth_it = 4; // a few places are as cheap one by one

using Places = std::vector<std::size_t>; // indices of factors

// Guesses of Delta^2 modulo primes, for each place until one more prime agrees.  For a double pole
// den''(c)/2 is the leading coefficient of den, so that Delta^2 = 1 + 8 num(c)/den''(c).
class Guesses {
public:
  Guesses(const RationalFunction& r, const std::vector<Factor>& factors, const Budget& budget)
      : r_(r), factors_(factors), budget_(budget) {}

  void run(const Places& places, std::vector<std::optional<Rational>>& answer) {
    for (const std::size_t i : places)
      open_.push_back({i, Integer(0), std::nullopt});
    PrimeIdeals primes = PrimeIdeals::large(r_.field());
    for (int k = 0; k < max_primes && !open_.empty(); ++k) {
      budget_.check();
      one_prime(primes.next(), answer);
    }
  }

private:
  struct ResidueGuess {
    std::size_t place;
    Integer residue;
    std::optional<Rational> value;
  };

  void one_prime(const PrimeIdeal& prime, std::vector<std::optional<Rational>>& answer) {
    const auto num = prime.reduce(r_.num());
    const auto den = prime.reduce(r_.den());
    if (!num || !den) return;
    const NmodPoly second = derivative(derivative(*den));
    const Integer next = modulus_ * Integer(prime.p);
    std::vector<ResidueGuess> still;
    for (ResidueGuess& g : open_) {
      const auto image = value_at(factors_[g.place].base, prime, *num, second);
      if (!image) continue;
      if (g.value && prime.reduce(*g.value) == *image) {
        answer[g.place] = std::move(g.value);
        continue;
      }
      if (g.value && !sees_all_of(g.place)) continue;
      fmpz_CRT_ui(g.residue.raw(), g.residue.raw(), modulus_.raw(), *image, prime.p, 0);
      g.value = rational_reconstruction(g.residue, next);
      if (g.value || sees_all_of(g.place)) still.push_back(std::move(g));
    }
    modulus_ = next;
    open_ = std::move(still);
  }

  static std::optional<mp_limb_t> value_at(const Poly& place, const PrimeIdeal& prime,
                                           const NmodPoly& num, const NmodPoly& second) {
    const auto q = prime.reduce(place);
    const auto at = q ? roots(*q) : std::vector<mp_limb_t>{};
    if (at.empty()) return std::nullopt;
    const mp_limb_t below = evaluate(second, at.front());
    if (below == 0) return std::nullopt;
    const nmod_t mod = num.mod();
    return nmod_add(1, nmod_div(nmod_mul(8, evaluate(num, at.front()), mod), below, mod), mod);
  }

  // One root modulo one prime of degree one tells all about a number only if it is rational.
  [[nodiscard]] bool sees_all_of(std::size_t place) const {
    return r_.field()->is_rational() && degree(factors_[place].base) == 1;
  }

  const RationalFunction& r_;
  const std::vector<Factor>& factors_;
  const Budget& budget_;
  std::vector<ResidueGuess> open_;
  Integer modulus_{1};
};

// Q = prod q and W = sum (v - 1) q' Q/q over the places q with values v.
PolyQuotient claims(const Places& places, const std::vector<Factor>& factors,
                    const std::vector<std::optional<Rational>>& values) {
  return sum(mapped<PolyQuotient>(places, [&](std::size_t i) {
    const Poly& q = factors[i].base;
    return PolyQuotient{q, scale(derivative(q), NfElem(*values[i] - Rational(1)))};
  }));
}

// All values at once: with den = Q^2 S they are right iff Q divides 4 num - W Q' S
// (docs/theory/local_exponents.md 1.8).
bool proved(const RationalFunction& r, const Places& places, const std::vector<Factor>& factors,
            const std::vector<std::optional<Rational>>& values) {
  const auto [q, w] = claims(places, factors, values);
  const Poly s = exact_div(r.den(), q * q) % q;
  return is_zero((scale(r.num(), NfElem(4)) - w * derivative(q) % q * s) % q);
}

// With q the product of (z - c) over the open places, den = q^2 s:  b = num(c)/(q'(c)^2 s(c)), and
// num may be replaced by its remainder modulo q.
void evaluate_the_rest(const RationalFunction& r, const std::vector<Factor>& factors,
                       std::vector<std::optional<Rational>>& answer, const Budget& budget) {
  if (!r.field()->is_rational()) return;
  Places open;
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
  Places places;
  for (std::size_t i = 0; i < factors.size(); ++i)
    if (factors[i].exponent == 2) places.push_back(i);
  if (places.size() >= worth_it) {
    Guesses(r, factors, budget).run(places, answer);
    std::erase_if(places, [&](std::size_t i) { return !answer[i]; });
    if (!places.empty() && !proved(r, places, factors, answer))
      for (const std::size_t i : places)
        answer[i].reset();
  }
  evaluate_the_rest(r, factors, answer, budget);
  return answer;
}

} // namespace kov
