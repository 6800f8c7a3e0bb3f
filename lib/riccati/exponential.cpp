#include "riccati/exponential.hpp"

#include "exact/chinese_lift.hpp"
#include "exact/error.hpp"
#include "riccati/lift.hpp"

#include <algorithm>
#include <variant>

namespace kov {
namespace {

constexpr int prime_tries = 2000;
constexpr int double_tries = 20; ///< primes with two solutions, by accident or not

// Fewest lines first, then the smallest residue field.
const Singularity* best_place(const Singularities& s, long& index) {
  const Singularity* best = nullptr;
  index = -1;
  const auto better = [&](const Singularity& p) {
    const int lines = formal_lines(p);
    if (lines < 1) return false;
    if (best == nullptr) return true;
    const int old = formal_lines(*best);
    return lines != old ? lines < old : p.degree() < best->degree();
  };
  for (std::size_t i = 0; i < s.finite.size(); ++i)
    if (better(s.finite[i])) {
      best = &s.finite[i];
      index = static_cast<long>(i);
    }
  if (better(s.infinity)) {
    best = &s.infinity;
    index = -1;
  }
  return best;
}

bool logs_are_known(const Singularities& s) {
  return s.infinity.log != Truth::unknown &&
         std::ranges::all_of(s.finite,
                             [](const Singularity& p) { return p.log != Truth::unknown; });
}

NmodPoly reversed_to(const NmodPoly& f, long n) {
  NmodPoly g(f.modulus());
  nmod_poly_reverse(g.raw(), f.raw(), n);
  return g;
}

// omega modulo p from its local series, if the recurrence is short enough.
std::optional<ModularOmega> reconstruct(const ModularPlace& m, const NmodPoly& local,
                                        long nu_infinity, long terms, long length) {
  const nmod_t mod = local.mod();
  NmodPoly series = local;
  if (m.at_infinity) { // -t^(nu_inf + 2 - nu) (t^nu omega~ - t^(nu-1))
    series.set_coeff(m.nu() - 1, nmod_sub(series.coeff(m.nu() - 1), 1, mod));
    nmod_poly_neg(series.raw(), series.raw());
    nmod_poly_shift_left(series.raw(), series.raw(), nu_infinity + 2 - m.nu());
    nmod_poly_truncate(series.raw(), terms);
  }
  const Recurrence recurrence = shortest_recurrence(series, terms);
  if (recurrence.length > length) return std::nullopt;
  NmodPoly den = reversed_to(recurrence.characteristic, recurrence.length + 1);
  NmodPoly num = mul_series(series, den, std::max(recurrence.length, 1L));
  if (m.at_infinity) {
    const long k = std::max({degree(num), degree(den), 0L}) + 1;
    num = reversed_to(num, k);
    den = reversed_to(den, k);
    nmod_poly_shift_left(num.raw(), num.raw(), nu_infinity);
  } else {
    nmod_poly_shift_left(den.raw(), den.raw(), m.nu());
    num = taylor_shift(num, nmod_neg(m.root, mod));
    den = taylor_shift(den, nmod_neg(m.root, mod));
  }
  const NmodPoly g = gcd(num, den);
  if (degree(g) > 0) {
    num = exact_div(num, g);
    den = exact_div(den, g);
  }
  const mp_limb_t unit = nmod_inv(den.coeff(degree(den)), mod);
  return ModularOmega{m.prime, scale(num, unit), scale(den, unit)};
}

bool solves_riccati(const ModularOmega& w, const Singularities& s) {
  const auto num = w.prime.reduce(s.r.num());
  const auto den = w.prime.reduce(s.r.den());
  KOV_ENSURE(num && den);
  const NmodPoly left = derivative(w.num) * w.den - w.num * derivative(w.den) + w.num * w.num;
  return left * *den == *num * (w.den * w.den);
}

struct Search {
  const Singularities& s;
  const Singularity& place;
  long index; ///< of the place; -1 at infinity
  ExponentialShape shape;
  long length;
  long terms;

  // The solutions modulo one prime; unset when the prime is not good.
  [[nodiscard]] std::optional<std::vector<ModularOmega>> modulo(const PrimeIdeal& prime,
                                                                ModularPlace* used) const {
    const auto m = reduce_place(s, place, prime, terms);
    if (!m) return std::nullopt;
    if (used != nullptr) *used = *m;
    std::vector<ModularOmega> found;
    for (int i = 0; i < formal_lines(place); ++i) {
      const int sign = i == 0 ? 1 : -1;
      auto omega = reconstruct(*m, expand_line(*m, sign, terms), shape.nu_infinity, terms, length);
      if (omega && solves_riccati(*omega, s)) found.push_back(std::move(*omega));
    }
    return found;
  }
};

ExponentialSolution checked(ExponentialSolution y, const Singularities& s) {
  KOV_ENSURE(solves(y, s.r));
  return y;
}

NoExponential absence(const Search& search, const PrimeIdeal& prime, const ModularPlace& used) {
  return {.at_infinity = search.place.at_infinity,
          .place = search.index,
          .prime = prime,
          .root = used.root,
          .delta = used.delta,
          .terms = search.terms,
          .length = search.length};
}

ModularPlace unset(const PrimeIdeal& prime) {
  return {prime, 0, false, 0, NmodPoly(prime.p), NmodPoly(prime.p), 0};
}

// omega from its images modulo split primes; or one of these has none, which proves that there is
// none.
std::variant<ExponentialSolution, NoExponential> lift_by_primes(const Search& search,
                                                                const Budget& budget) {
  const Field& k = search.s.r.field();
  PrimeIdeals primes = PrimeIdeals::large(k);
  std::optional<ChineseLift> lift;
  long n = -1;
  long d = -1;
  for (int tries = 0; tries < 200 * prime_tries; ++tries) {
    budget.check();
    const auto ideals = primes.next_split();
    std::vector<std::vector<mp_limb_t>> residues;
    bool larger = false;
    for (const PrimeIdeal& ideal : ideals) {
      ModularPlace used = unset(ideal);
      const auto found = search.modulo(ideal, &used);
      if (found && found->empty()) return absence(search, ideal, used);
      if (!found || found->size() != 1) break;
      const ModularOmega& w = found->front();
      if (degree(w.den) > d || (degree(w.den) == d && degree(w.num) > n)) {
        d = degree(w.den);
        n = degree(w.num);
        larger = true; // what came before was unlucky
      } else if (degree(w.den) < d || degree(w.num) < n) {
        break;
      }
      std::vector<mp_limb_t> row;
      for (long i = 0; i <= n; ++i)
        row.push_back(w.num.coeff(i));
      for (long i = 0; i <= d; ++i)
        row.push_back(w.den.coeff(i));
      residues.push_back(std::move(row));
    }
    if (residues.size() != ideals.size() || residues.front().size() != residues.back().size())
      continue;
    if (larger || !lift) lift.emplace(k, residues.front().size());
    lift->add(ideals, residues);
    if (!worth_a_try(lift->primes())) continue;
    const auto c = lift->reconstruct();
    if (!c) continue;
    const auto middle = c->begin() + n + 1;
    const RationalFunction omega(Poly::from_coefficients({c->begin(), middle}),
                                 Poly::from_coefficients({middle, c->end()}));
    ExponentialSolution y{omega, Poly(1)};
    if (solves(y, search.s.r)) return y;
  }
  throw OutOfBudget("a solution modulo primes could not be lifted");
}

} // namespace

ExponentialSearch exponential_solutions(const Singularities& s, const Budget& budget) {
  ExponentialSearch answer;
  const ExponentialShape shape = exponential_shape(s);
  if (shape.obstruction) {
    answer.none = NoExponential{.obstruction = shape.obstruction};
    return answer;
  }
  budget.check_degree(shape.degree + shape.denominator);
  long index = -1;
  const Singularity* place = best_place(s, index);
  if (place == nullptr) {
    if (!logs_are_known(s))
      throw OutOfBudget(
          "the logarithms at places with large integral exponent differences are not known");
    answer.projectively_trivial = true;
    return answer;
  }
  const long length = shape.denominator + shape.degree + shape.nu_infinity + 1;
  const Search search{s, *place, index, shape, length, 2 * length + 2};
  PrimeIdeals primes = PrimeIdeals::large(s.r.field());
  int doubles = 0;
  for (int tries = 0; tries < prime_tries; ++tries) {
    budget.check();
    const PrimeIdeal prime = primes.next();
    ModularPlace used = unset(prime);
    const auto found = search.modulo(prime, &used);
    if (!found) continue;
    if (found->empty()) {
      answer.none = absence(search, prime, used);
      return answer;
    }
    if (found->size() > 1) { // one more than in characteristic 0, if it is an accident
      if (++doubles < double_tries) continue;
      throw OutOfBudget("modulo each prime that was tried there are two exponential solutions");
    }
    if (auto omega = lift_by_exponents(s, found->front(), budget)) {
      answer.solutions.push_back(checked(*omega, s));
      return answer;
    }
    auto lifted = lift_by_primes(search, budget);
    if (auto* none = std::get_if<NoExponential>(&lifted))
      answer.none = std::move(*none);
    else
      answer.solutions.push_back(checked(std::get<ExponentialSolution>(std::move(lifted)), s));
    return answer;
  }
  throw OutOfBudget("no good prime found for the place " + place_name(*place));
}

} // namespace kov
