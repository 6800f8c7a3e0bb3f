// Rule "local": the places are what they claim to be (docs/theory/local_exponents.md §1).

#include "certify/equation/rules.hpp"
#include "exact/factor.hpp"
#include "exact/in_pairs.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>
#include <functional>
#include <set>

namespace kov::certify {

namespace {

// f modulo q, quickly when q is linear.
Poly mod(const Poly& f, const Poly& q) {
  if (degree(f) < degree(q)) return f;
  if (degree(q) == 1) return Poly(evaluate(f, -q.coeff(0)));
  return f % q;
}

// f^(i)/i! as a polynomial.
Poly taylor_coefficient(const Poly& f, long i) {
  Poly g(f.field());
  Integer b(1);
  for (long k = i; k <= degree(f); ++k) {
    g.set_coeff(k - i, f.coeff(k) * NfElem(Rational(b)));
    b = exact_div(b * Integer(k + 1), Integer(k + 1 - i));
  }
  return g;
}

// Is every root of q the place of an irrational Delta?  local_exponents.md (1.7): e^((p+1)/2) - e
// is a unit modulo (p, q), e = 1 + 8 num/den''.
void need_irrational(const Judge& j, const PlaceFact& x, const PrimeIdeal& prime) {
  const Reduced r = j.reduced(prime);
  j.spend(2000 * static_cast<double>(x.n) + 20 * j.length());
  const NmodPoly q = reduce(*x.q, prime);
  const NmodPoly second = derivative(derivative(r.den));
  const NmodPoly e = remainder((second + scale(r.num, 8 % prime.p)) * inverse_mod(second, q), q);
  NmodPoly power(prime.p);
  nmod_poly_powmod_ui_binexp(power.raw(), e.raw(), (prime.p + 1) / 2, q.raw());
  const NmodPoly v = power - e;
  need(!is_zero(v) && degree(gcd(v, q)) == 0, "irrationality is not seen modulo p");
}

// The ring K[c]/q, or K at infinity.
class ResidueRing {
public:
  explicit ResidueRing(const std::optional<Poly>& q) : q_(q) {}
  [[nodiscard]] Poly operator()(const Poly& f) const { return q_ ? mod(f, *q_) : f; }

private:
  const std::optional<Poly>& q_;
};

using Coefficient = std::function<Poly(long)>;

// eps^2 = (beta/a)^2 at an irregular place of order 2 nu; n and d give the Taylor coefficients of
// the numerator and denominator of t^(2nu) r.  Nothing is inverted: local_exponents.md (1.5).
void need_eps2(const Judge& j, const PlaceFact& x, const Coefficient& n, const Coefficient& d,
               const Poly& value) {
  const ResidueRing red(x.q);
  const long nu = x.order / 2;
  need_within(nu <= max_irregular, "the order of the pole is too large");
  const double size = bits(j.equation.num) + bits(j.equation.den) +
                      (x.q ? j.length() / static_cast<double>(x.n) * bits(*x.q) : 0);
  need_within(static_cast<double>(nu * nu * x.n) * size <= max_bulk,
              "the coefficients are too large");
  std::vector<Poly> N, D, G;
  for (long i = 0; i < nu; ++i) {
    N.push_back(n(i));
    D.push_back(d(i));
    Poly g;
    for (std::size_t k = 0; k < N.size(); ++k)
      g += N[k] * D[N.size() - 1 - k];
    G.push_back(red(g));
  }
  // square root of G/G0 and inverse of D/D0, scaled by powers of G0 and D0
  std::vector<Poly> root{Poly(1)}, inverse{Poly(1)}, g_power{Poly(1)}, d_power{Poly(1)};
  for (std::size_t k = 1; k < G.size(); ++k) {
    g_power.push_back(red(g_power.back() * G[0]));
    d_power.push_back(red(d_power.back() * D[0]));
    Poly t = G[k] * g_power[k - 1];
    for (std::size_t i = 1; i < k; ++i)
      t -= root[i] * root[k - i];
    root.push_back(red(scale(t, NfElem(Rational(1, 2)))));
    Poly s;
    for (std::size_t i = 1; i <= k; ++i)
      s -= red(D[i] * d_power[i - 1]) * inverse[k - i];
    inverse.push_back(red(s));
  }
  Poly total;
  const auto top = static_cast<std::size_t>(nu - 1);
  for (std::size_t i = 0; i <= top; ++i)
    total += red(red(root[i] * inverse[top - i]) * red(g_power[top - i] * d_power[i]));
  const Poly both = red(g_power[top] * d_power[top]);
  const Poly left = red(red(red(value * D[0]) * D[0]) * red(both * both));
  need(is_zero(red(left - scale(red(G[0] * red(total * total)), NfElem(4)))), "eps2 is wrong");
}

// Delta^2 = value at every root of q, for all poles of order 2 at once: local_exponents.md (1.8).
// With Q the product of their q, den = Q^2 S and W = sum (value - 1) q' Q/q, all claims together
// say that Q divides 4 num - W Q' S.
class ExponentTest {
public:
  explicit ExponentTest(const Judge& judge) : judge_(judge) {}

  void operator()(const PlaceFact& x, const Poly& value) {
    need(x.order == 2 && degree(value) < x.n, "delta2 belongs to a pole of order 2");
    need(!judge_.field->is_rational() || bits(value) <= largest(x), wrong);
    claims_.push_back({*x.q, (value - Poly(1)) * derivative(*x.q)});
    size_ += bits(*x.q) + bits(claims_.back().num);
  }
  // Requires the product of the places to be squarefree.
  void finish() const {
    if (claims_.empty()) return;
    const auto& [num, den] = judge_.equation;
    need_within(judge_.length() * size_ <= max_bulk, "the exponents are too large");
    judge_.spend(4 * judge_.words() + judge_.length() * size_ / 16);
    const auto [Q, W] = sum(claims_);
    const Poly S = mod(quotient(den, Q * Q), Q);
    const Poly right = mod(mod(mod(W, Q) * derivative(Q), Q) * S, Q);
    need(mod(scale(num, NfElem(4)), Q) == right, wrong);
  }

private:
  static constexpr const char* wrong = "delta2 is wrong";

  // More bits than this 8 num/den'' cannot have modulo q over Q: Cramer's rule.
  [[nodiscard]] double largest(const PlaceFact& x) const {
    const auto n = static_cast<double>(x.n);
    return 2 * (n + 1) *
           (bits(judge_.equation.num) + bits(judge_.equation.den) + 128 +
            4 * (judge_.length() + n) * (bits(*x.q) + 2));
  }
  const Judge& judge_;
  std::vector<PolyQuotient> claims_;
  double size_ = 0; // of the claims, in bits: W is not larger
};

void spend_on_annihilator(const Judge& j, const PlaceFact& x, const Poly& value,
                          const std::optional<Poly>& chi) {
  if (!chi) return;
  const auto n = static_cast<double>(degree(*chi) + 1);
  const double size = bits(value) + bits(*x.q) + bits(*chi);
  j.spend(n * n * static_cast<double>(x.n) * (1 + size / 64));
}

void check_log(const Judge& j, PlaceFact& x, const LogWitness& log) {
  const std::set<mp_limb_t> roots(log.roots.begin(), log.roots.end());
  need(x.order == 2 && !roots.empty() && roots.size() == log.roots.size(),
       "distinct roots are expected");
  need(x.delta.has_value(), "a logarithm needs a natural exponent difference below p");
  const Reduced r = j.reduced(log.prime);
  const NmodPoly q = reduce(*x.q, log.prime);
  const double terms = *x.delta < Rational(1000000) ? fmpz_get_d(x.delta->num().raw()) : 1e6;
  for (const mp_limb_t c : log.roots) {
    j.spend(terms * terms + 40 * j.length());
    need(c < log.prime.p && evaluate(q, c) == 0, "not a root of the place modulo p");
    need_log(r, c, *x.delta);
  }
  x.logs = static_cast<long>(roots.size());
}

PlaceFact check_place(const Judge& j, const LocalPlace& data, ExponentTest& test) {
  PlaceFact x(data.q, degree(data.q), data.order);
  if (data.delta2) {
    test(x, *data.delta2);
    spend_on_annihilator(j, x, *data.delta2, data.annihilator);
    x.set_square(*data.delta2, data.annihilator);
  }
  if (data.irrational) {
    need(x.order == 2 && !x.delta, "irrational belongs to a pole of order 2");
    need_irrational(j, x, *data.irrational);
    x.irrational = true;
  }
  if (data.log) check_log(j, x, *data.log);
  if (data.eps2) {
    need(x.order >= 4 && x.order % 2 == 0 && degree(*data.eps2) < x.n,
         "eps2 belongs to a pole of even order >= 4");
    const ResidueRing red(x.q);
    j.spend(static_cast<double>(x.order) * static_cast<double>(x.n) * j.words());
    need_eps2(
        j, x, [&](long i) { return red(taylor_coefficient(j.equation.num, i)); },
        [&](long i) { return red(taylor_coefficient(j.equation.den, i + x.order)); }, *data.eps2);
    spend_on_annihilator(j, x, *data.eps2, data.annihilator);
    x.set_square(*data.eps2, data.annihilator);
  }
  return x;
}

PlaceFact check_infinity(const Judge& j, const Local& data) {
  const Poly& n = j.equation.num;
  const Poly& d = j.equation.den;
  PlaceFact x(std::nullopt, 1, is_zero(n) ? 0 : 4 - (degree(d) - degree(n)));
  if (x.order == 2) x.set_square(Poly(NfElem(1) + NfElem(4) * lead(n)), data.infinity_annihilator);
  if (data.infinity_log) {
    need(x.order == 2 && data.infinity_log->roots.empty() && x.delta,
         "no logarithm to prove at infinity");
    need_log(j.reduced(data.infinity_log->prime), std::nullopt, *x.delta);
    x.logs = 1;
  }
  if (data.infinity_eps2) {
    need(x.order >= 4 && x.order % 2 == 0 && degree(*data.infinity_eps2) < 1,
         "eps2 belongs to an irregular place");
    const auto from_top = [](const Poly& f) {
      return [&f](long i) { return i > degree(f) ? Poly(0) : Poly(f.coeff(degree(f) - i)); };
    };
    need_eps2(j, x, from_top(n), from_top(d), *data.infinity_eps2);
    x.set_square(*data.infinity_eps2, data.infinity_annihilator);
  }
  return x;
}

// The places are all there are: product and orders.
void need_all_places(const Judge& j, const Local& data) {
  need_within(data.places.size() <= max_places, "too many places");
  std::vector<Poly> powers, bases;
  long total = 0;
  double size = 0;
  for (const LocalPlace& e : data.places) {
    need(degree(e.q) >= 1 && is_one(lead(e.q)), "a place is not a monic polynomial");
    need(e.order >= 1 && e.order <= static_cast<long>(max_length), "an order is not positive");
    total += degree(e.q) * e.order;
    need(total <= degree(j.equation.den), "the degrees do not add up to deg den");
    size += static_cast<double>(e.order) * bits(e.q);
    need_within(static_cast<double>(degree(j.equation.den)) * size <= max_bulk,
                "the places are too large");
    bases.push_back(e.q);
    powers.push_back(pow(e.q, static_cast<unsigned long>(e.order)));
  }
  need(product(std::move(powers)) == j.equation.den, "the product of the places is not den");
  need_squarefree(product(std::move(bases)), j.reduced(data.prime), &j.equation.num);
}

LocalFact place_by_place(const Judge& j, const Local& data, ExponentTest& test) {
  LocalFact local;
  for (const LocalPlace& e : data.places)
    local.all.push_back(check_place(j, e, test));
  local.all.push_back(check_infinity(j, data));
  return local;
}

} // namespace

LocalFact check_local(const Judge& j, const Local& data) {
  need_all_places(j, data);
  ExponentTest test(j);
  LocalFact local = place_by_place(j, data, test);
  test.finish();
  return local;
}

LocalFact claimed_local(const Judge& j, const Local& data) {
  ExponentTest untested(j);
  return place_by_place(j, data, untested);
}

} // namespace kov::certify
