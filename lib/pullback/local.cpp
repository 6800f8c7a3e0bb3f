#include "pullback/local.hpp"

#include "exact/factor.hpp"
#include "kovacic/residue_field.hpp"
#include "pullback/kernel.hpp"

#include <algorithm>

namespace kov::pullback {

Point point_of(const Singularity& s) {
  return s.at_infinity ? Point{Poly::z(), true} : Point{s.place, false};
}

Laurent laurent(const RationalFunction& f, const Point& p, long n) {
  if (p.at_infinity) {
    const auto top = [n](const Poly& g) {
      ResidueSeries c;
      for (long i = 0; i < n; ++i)
        c.emplace_back(g.coeff(degree(g) - i));
      return c;
    };
    return {degree(f.den()) - degree(f.num()), divide(top(f.num()), top(f.den()), p.q)};
  }
  const long zeros = remove_factor(f.num(), p.q).first;
  const long poles = remove_factor(f.den(), p.q).first;
  ResidueSeries num = taylor_at(f.num(), p.q, zeros + n);
  ResidueSeries den = taylor_at(f.den(), p.q, poles + n);
  num.erase(num.begin(), num.begin() + zeros);
  den.erase(den.begin(), den.begin() + poles);
  return {zeros - poles, divide(num, den, p.q)};
}

// B = A^e: A B' = e A' B.
ResidueSeries power(const ResidueSeries& a, const Rational& e, const Poly& q) {
  ResidueSeries b{Poly(1)};
  for (std::size_t k = 1; k < a.size(); ++k) {
    Poly sum(0);
    for (std::size_t j = 1; j <= k; ++j) {
      const Rational factor =
          e * Rational(static_cast<long>(j)) - Rational(static_cast<long>(k - j));
      sum += scale(a[j] * b[k - j] % q, NfElem(factor));
    }
    b.push_back(scale(sum, NfElem(Rational(1, static_cast<long>(k)))));
  }
  return b;
}

Phase phase(const RationalFunction& r, const Singularity& s) {
  const Point p = point_of(s);
  Phase out;
  out.pole = p.at_infinity ? 2 - s.order : s.order - 2;
  const long n = (out.pole + 1) / 2;
  const Laurent here = laurent(r, p, n);
  const Poly unit = inverse_mod(here.terms.front(), p.q);
  ResidueSeries root;
  for (const Poly& c : here.terms)
    root.push_back(c * unit % p.q);
  root = power(root, Rational(1, 2), p.q);
  // the integral of t^(-m/2 - 1 + i) has the factor 1/(i - m/2)
  for (long i = 0; i < n; ++i)
    root[static_cast<std::size_t>(i)] =
        scale(root[static_cast<std::size_t>(i)], NfElem(Rational(out.pole, out.pole - 2 * i)));
  out.terms = power(root, Rational(2), p.q);
  out.leading = scale(here.terms.front(), NfElem(Rational(4, out.pole * out.pole)));
  return out;
}

RationalFunction principal_part(const ResidueSeries& terms, long pole, const Point& p) {
  RationalFunction sum;
  for (long i = 0; i < pole && i < static_cast<long>(terms.size()); ++i) {
    const Poly& c = terms[static_cast<std::size_t>(i)];
    if (p.at_infinity)
      sum += RationalFunction(Poly::monomial(c.coeff(0), pole - i));
    else
      sum += kovacic::sum_over_roots(c, p.q, pole - i);
  }
  return sum;
}

namespace {

// The relations sum_i x_i v_i = 0.
std::vector<Row> relations(const std::vector<Poly>& v, long n, const Budget& budget) {
  std::vector<Row> rows;
  for (long i = 0; i < n; ++i) {
    Row& row = rows.emplace_back();
    for (const Poly& f : v)
      row.push_back(f.coeff(i));
  }
  return kernel(rows, v.size(), budget);
}

std::vector<Poly> powers(const Poly& v, long n, const Poly& q) {
  std::vector<Poly> all{Poly(1)};
  while (static_cast<long>(all.size()) <= n)
    all.push_back(all.back() * v % q);
  return all;
}

// The roots of v, whose powers generate K[c]/q, with the minimal polynomial chi.
std::vector<Poly> roots_of_generator(const Poly& v, const Poly& chi, long n, const Poly& q,
                                     const Budget& budget) {
  const long d = degree(q);
  std::vector<Poly> found;
  for (const Factor& f : irreducible_factors(compose(chi, Poly::monomial(NfElem(1), n)), budget)) {
    if (degree(f.base) != d) continue;
    // T as a polynomial in T^n modulo this factor: the root as a polynomial in v
    std::vector<Poly> all = powers(Poly::monomial(NfElem(1), n) % f.base, d - 1, f.base);
    all.push_back(Poly::z() % f.base);
    const auto relation = relations(all, d, budget);
    if (relation.size() != 1 || is_zero(relation[0].back())) continue;
    Poly root(0);
    const std::vector<Poly> of_v = powers(v, d - 1, q);
    for (std::size_t i = 0; i < of_v.size(); ++i)
      root += scale(of_v[i], -(relation[0][i] / relation[0].back()));
    found.push_back(root);
  }
  return found;
}

} // namespace

std::vector<Poly> roots_of(const Poly& v, long n, const Poly& q, const Budget& budget) {
  const long d = degree(q);
  for (long shift = 0; shift < 10; ++shift) { // v s^n generates the residue field
    const Poly s = shift == 0 ? Poly(1) : (Poly::z() + Poly(shift - 1)) % q;
    if (is_zero(s)) continue;
    Poly w = v % q;
    for (long i = 0; i < n; ++i)
      w = w * s % q;
    const auto relation = relations(powers(w, d, q), d, budget);
    if (relation.size() != 1) continue; // a power below the d-th depends on the others
    const Poly chi = monic(Poly::from_coefficients(relation[0]));
    if (degree(chi) != d) continue;
    std::vector<Poly> found;
    for (const Poly& root : roots_of_generator(w, chi, n, q, budget))
      found.push_back(root * inverse_mod(s, q) % q);
    return found;
  }
  return {};
}

std::vector<const Singularity*> irregular_places(const Singularities& s) {
  std::vector<const Singularity*> found;
  const auto add = [&](const Singularity& p) {
    if (p.kind == PlaceKind::irregular || p.kind == PlaceKind::ramified) found.push_back(&p);
  };
  add(s.infinity);
  for (const Singularity& p : s.finite)
    add(p);
  return found;
}

bool is_lasting(const Singularity& s) {
  if (s.kind == PlaceKind::ordinary) return false;
  if (s.kind == PlaceKind::simple) return true;
  if (s.kind != PlaceKind::regular) return false;
  return !s.delta || !is_integer(*s.delta) || s.log != Truth::no;
}

} // namespace kov::pullback
