#include "exact/ideal.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

namespace kov {
namespace {

std::uint64_t total(const Monomial& m, std::size_t begin, std::size_t end) {
  return std::accumulate(m.begin() + static_cast<long>(begin), m.begin() + static_cast<long>(end),
                         std::uint64_t{0});
}

bool divides(const Monomial& a, const Monomial& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] > b[i]) return false;
  return true;
}
bool coprime(const Monomial& a, const Monomial& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] > 0 && b[i] > 0) return false;
  return true;
}
Monomial quotient(const Monomial& a, const Monomial& b) {
  Monomial q(a);
  for (std::size_t i = 0; i < a.size(); ++i)
    q[i] -= b[i];
  return q;
}
Monomial lcm(const Monomial& a, const Monomial& b) {
  Monomial m(a);
  for (std::size_t i = 0; i < a.size(); ++i)
    m[i] = std::max(a[i], b[i]);
  return m;
}

const Monomial& lead(const KPoly& f) { return f.begin()->first; }

// f <- f - c x^m g
void subtract_multiple(KPoly& f, const MFraction& c, const Monomial& m, const KPoly& g,
                       Work& work) {
  for (const auto& [n, coefficient] : g) {
    work.add(c, coefficient);
    Monomial product(n);
    for (std::size_t i = 0; i < product.size(); ++i)
      product[i] += m[i];
    const auto [place, fresh] = f.try_emplace(std::move(product));
    const MFraction product_of_coefficients = c * coefficient;
    work.add(place->second, product_of_coefficients);
    place->second = place->second - product_of_coefficients;
    if (is_zero(place->second)) f.erase(place);
  }
}

std::vector<MPoly> numerators(const Ideal& ideal) {
  return mapped<MPoly>(ideal.basis(), [&](const auto& g) { return ideal.from_kpoly(g).num(); });
}

} // namespace

bool MonomialOrder::operator()(const Monomial& a, const Monomial& b) const {
  const std::size_t n = a.size();
  const std::size_t m = n - eliminate;
  if (eliminate > 0) {
    const auto ta = total(a, m, n);
    const auto tb = total(b, m, n);
    if (ta != tb) return ta > tb;
  }
  const auto da = total(a, 0, m);
  const auto db = total(b, 0, m);
  if (da != db) return da > db;
  for (std::size_t i = m; i-- > 0;)
    if (a[i] != b[i]) return a[i] < b[i];
  return false;
}

Ideal::Ideal(Ring ring, std::vector<std::size_t> main, const std::vector<MPoly>& generators,
             const std::vector<MPoly>& nonzero, const Budget& budget)
    : ring_(std::move(ring)), main_(std::move(main)), budget_(budget) {
  if (std::set<std::size_t>(main_.begin(), main_.end()).size() != main_.size())
    throw InvalidArgument("a main variable of an ideal is repeated");
  MPoly product(ring_, Integer(1));
  for (const auto& g : nonzero) {
    if (is_zero(g)) { // I : 0^infinity is the whole ring
      basis_.push_back(to_kpoly(MFraction(ring_, Rational(1))));
      return;
    }
    if (!is_constant(g)) product *= g;
  }
  const bool saturate = !is_constant(product);
  extra_ = saturate ? 1 : 0;
  std::vector<KPoly> start;
  for (const auto& g : generators)
    if (!is_zero(g)) start.push_back(to_kpoly(g));
  if (saturate) { // t * product - 1
    KPoly relation(MonomialOrder{1});
    for (const auto& [monomial, c] : to_kpoly(product)) {
      Monomial m = monomial;
      m.back() = 1;
      relation.emplace(std::move(m), c);
    }
    relation.emplace(one(), MFraction(ring_, Rational(-1)));
    start.push_back(std::move(relation));
  }
  buchberger(std::move(start));
  if (!saturate) return;
  extra_ = 0; // keep what does not use t
  std::vector<KPoly> kept;
  for (const auto& g : basis_) {
    if (lead(g).back() > 0) continue;
    KPoly f(MonomialOrder{0});
    for (const auto& [monomial, c] : g)
      f.emplace(Monomial(monomial.begin(), monomial.end() - 1), c);
    kept.push_back(std::move(f));
  }
  basis_ = std::move(kept);
}

Monomial Ideal::one() const { return Monomial(main_.size() + extra_, 0); }

bool Ideal::is_unit() const { return basis_.size() == 1 && lead(basis_.front()) == one(); }

KPoly Ideal::to_kpoly(const MFraction& f) const {
  KPoly result(MonomialOrder{extra_});
  if (is_zero(f)) return result;
  for (const std::size_t i : main_)
    if (uses(f.den(), i))
      throw InvalidArgument("a polynomial in " + ring_->name(i) + " was expected, not " +
                            to_string(f));
  const MPoly num = f.num();
  std::map<Monomial, MPoly> groups;
  for (long t = 0; t < num.length(); ++t) {
    auto e = num.exponents(t);
    Monomial m = one();
    for (std::size_t i = 0; i < main_.size(); ++i) {
      m[i] = static_cast<std::uint32_t>(e[main_[i]]);
      e[main_[i]] = 0;
    }
    MPoly& group = groups.try_emplace(std::move(m), ring_).first->second;
    fmpz_mpoly_push_term_fmpz_ui(group.raw(), num.coefficient(t).raw(), e.data(), group.ctx());
  }
  for (auto& [m, c] : groups) {
    fmpz_mpoly_sort_terms(c.raw(), c.ctx());
    result.emplace(m, MFraction(c, f.den()));
  }
  return result;
}

MFraction Ideal::from_kpoly(const KPoly& f) const {
  MPoly den(ring_, Integer(1)); // of all coefficients, so that there is one gcd at the end
  for (const auto& [m, c] : f)
    if (!divides(c.den(), den)) den = exact_div(den * c.den(), gcd(den, c.den()));
  MPoly num(ring_);
  for (const auto& [m, c] : f) {
    std::vector<unsigned long> e(ring_->size());
    for (std::size_t i = 0; i < main_.size(); ++i)
      e[main_[i]] = m[i];
    num += c.num() * exact_div(den, c.den()) * MPoly::term(ring_, Integer(1), e);
  }
  return {num, den};
}

void Ideal::note_inverted(const MFraction& c) {
  for (const MPoly& part : {c.num(), c.den()}) {
    if (is_constant(part)) continue;
    for (auto& f : factor(part).second)
      add_once(inverted_, std::move(f.base));
  }
}

// The remainder with respect to basis_, whose elements are monic.
KPoly Ideal::divide(KPoly f, Work& work) const {
  KPoly rest(MonomialOrder{extra_});
  while (!f.empty()) {
    const auto top = f.begin();
    const auto divisor =
        std::ranges::find_if(basis_, [&](const KPoly& g) { return divides(lead(g), top->first); });
    if (divisor == basis_.end()) {
      rest.insert(f.extract(top));
      continue;
    }
    const MFraction c = top->second;
    const Monomial m = quotient(top->first, lead(*divisor));
    subtract_multiple(f, c, m, *divisor, work);
  }
  return rest;
}

void Ideal::buchberger(std::vector<KPoly> generators) {
  Work work(budget_, "a Gröbner basis");
  struct CriticalPair {
    std::size_t i, j;
    Monomial l;
  };
  std::vector<CriticalPair> pairs;
  const MonomialOrder order{extra_};
  const auto add = [&](KPoly f) {
    const MFraction c = f.begin()->second;
    note_inverted(c);
    for (auto& [m, coefficient] : f) {
      work.add(coefficient, c);
      coefficient = coefficient / c;
    }
    for (std::size_t i = 0; i < basis_.size(); ++i)
      if (!coprime(lead(basis_[i]), lead(f)))
        pairs.push_back({i, basis_.size(), lcm(lead(basis_[i]), lead(f))});
    basis_.push_back(std::move(f));
  };
  // Buchberger's second criterion: another element divides the least common multiple, and its pairs with
  // both of them are done.
  const auto is_waiting = [&](std::size_t i, std::size_t j) {
    return std::ranges::any_of(pairs, [&](const CriticalPair& p) {
      return p.i == std::min(i, j) && p.j == std::max(i, j);
    });
  };
  const auto follows = [&](const CriticalPair& p) {
    for (std::size_t k = 0; k < basis_.size(); ++k)
      if (k != p.i && k != p.j && divides(lead(basis_[k]), p.l) && !is_waiting(p.i, k) &&
          !is_waiting(p.j, k))
        return true;
    return false;
  };
  std::ranges::sort(generators,
                    [&](const KPoly& a, const KPoly& b) { return order(lead(b), lead(a)); });
  for (auto& g : generators)
    if (KPoly f = divide(std::move(g), work); !f.empty()) add(std::move(f));
  while (!pairs.empty()) {
    work.add(static_cast<double>(pairs.size()));
    // normal strategy: the smallest least common multiple first
    const auto next = std::ranges::min_element(
        pairs, [&](const CriticalPair& a, const CriticalPair& b) { return order(b.l, a.l); });
    const CriticalPair pair = *next;
    pairs.erase(next);
    if (follows(pair)) continue;
    KPoly s(order);
    const MFraction unit(ring_, Rational(1));
    subtract_multiple(s, -unit, quotient(pair.l, lead(basis_[pair.i])), basis_[pair.i], work);
    subtract_multiple(s, unit, quotient(pair.l, lead(basis_[pair.j])), basis_[pair.j], work);
    if (KPoly f = divide(std::move(s), work); !f.empty()) add(std::move(f));
  }
  minimise(work);
}

// The reduced Gröbner basis, sorted ascending by leading monomial.
void Ideal::minimise(Work& work) {
  std::vector<KPoly> all = std::move(basis_);
  basis_.clear();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool redundant = [&] {
      for (std::size_t j = 0; j < all.size(); ++j)
        if (j != i && divides(lead(all[j]), lead(all[i])) &&
            (lead(all[j]) != lead(all[i]) || j < i))
          return true;
      return false;
    }();
    if (!redundant) basis_.push_back(all[i]);
  }
  const MonomialOrder order{extra_};
  std::ranges::sort(basis_,
                    [&](const KPoly& a, const KPoly& b) { return order(lead(b), lead(a)); });
  for (std::size_t i = 0; i < basis_.size(); ++i) {
    KPoly f = std::move(basis_[i]);
    basis_[i] = KPoly(order);
    auto top = f.extract(f.begin());
    const KPoly hold = std::move(basis_[i]);
    basis_.erase(basis_.begin() + static_cast<long>(i));
    KPoly rest = divide(std::move(f), work);
    rest.insert(std::move(top));
    basis_.insert(basis_.begin() + static_cast<long>(i), std::move(rest));
  }
  std::ranges::sort(inverted_, [](const MPoly& a, const MPoly& b) { return compare(a, b) < 0; });
}

KPoly Ideal::reduce(const MFraction& f) const {
  Work work(budget_, "a reduction modulo an ideal");
  return divide(to_kpoly(f), work);
}
bool Ideal::contains(const MPoly& f) const { return reduce(f).empty(); }
MFraction Ideal::normal_form(const MFraction& f) const { return from_kpoly(reduce(f)); }

bool Ideal::vanishes(const MPoly& f) const {
  const MFraction reduced = normal_form(MFraction(f));
  if (is_zero(reduced)) return true;
  if (is_constant(f)) return is_unit();
  if (is_unit()) return true;
  if (nonzero_on_a_fibre(reduced)) return false;
  return Ideal(ring_, main_, numerators(*this), {reduced.num()}, budget_).is_unit();
}

// Over K(U), U a largest independent set, the algebra A = K(U)[other variables]/I has finite
// dimension.  Division by its (monic) Gröbner basis uses ring operations on the coefficients only,
// so that at a point where these are defined A becomes an algebra over Q with the same basis, and a
// nilpotent f becomes nilpotent.  So one point where f is not nilpotent shows that f does not
// vanish.
bool Ideal::nonzero_on_a_fibre(const MFraction& f) const {
  const auto independent = independent_variables();
  std::vector<std::size_t> rest;
  for (const std::size_t i : main_)
    if (!is_among(i, independent)) rest.push_back(i);
  const Ideal generic(ring_, rest, numerators(*this), {}, budget_);
  if (generic.dimension() != 0) return false;
  const MFraction g = generic.normal_form(MFraction(f.num()));
  std::mt19937 generator(31);
  std::uniform_int_distribution<int> number(2, 1000);
  for (int attempt = 0; attempt < 3; ++attempt) {
    Substitution point;
    for (std::size_t i = 0; i < ring_->size(); ++i)
      if (!is_among(i, rest)) point[i] = MFraction(ring_, Rational(number(generator)));
    try {
      std::vector<MPoly> fibre;
      for (const auto& b : generic.basis_)
        fibre.push_back(substitute(generic.from_kpoly(b), point).num());
      const Ideal special(ring_, rest, fibre, {}, budget_);
      MFraction power = special.normal_form(substitute(g, point));
      const std::size_t size = special.standard_monomials().size();
      for (std::size_t e = 1; e < size && !is_zero(power); e *= 2)
        power = special.normal_form(power * power);
      if (!is_zero(power)) return true;
    } catch (const DomainError&) {
      continue; // a denominator vanishes at this point
    }
  }
  return false;
}

int Ideal::dimension() const {
  return is_unit() ? -1 : static_cast<int>(independent_variables().size());
}

namespace {

using Support = std::vector<std::size_t>;

// The largest subset of `kept` that contains no support whole: some variable of each must go.
void largest_independent(const std::vector<Support>& supports, std::vector<bool>& kept,
                         std::size_t size, std::vector<bool>& best, std::size_t& best_size,
                         Work& work) {
  if (size <= best_size) return;
  work.add(static_cast<double>(supports.size()));
  const auto whole = std::ranges::find_if(supports, [&](const Support& s) {
    return std::ranges::all_of(s, [&](std::size_t i) { return kept[i]; });
  });
  if (whole == supports.end()) {
    best = kept;
    best_size = size;
    return;
  }
  for (const std::size_t i : *whole) {
    kept[i] = false;
    largest_independent(supports, kept, size - 1, best, best_size, work);
    kept[i] = true;
  }
}

} // namespace

// A set of variables such that no leading monomial lies in the set alone.
std::vector<std::size_t> Ideal::independent_variables() const {
  KOV_ENSURE(!is_unit());
  const std::size_t n = main_.size();
  std::vector<Support> supports;
  for (const auto& g : basis_) {
    supports.emplace_back();
    for (std::size_t i = 0; i < n; ++i)
      if (lead(g)[i] > 0) supports.back().push_back(i);
  }
  std::ranges::sort(supports,
                    [](const Support& a, const Support& b) { return a.size() < b.size(); });
  std::vector<bool> kept(n, true);
  std::vector<bool> best(n, false);
  std::size_t best_size = 0;
  Work work(budget_, "a largest independent set of variables");
  largest_independent(supports, kept, n, best, best_size, work);
  std::vector<std::size_t> variables;
  for (std::size_t i = 0; i < n; ++i)
    if (best[i]) variables.push_back(main_[i]);
  return variables;
}

std::vector<Monomial> Ideal::standard_monomials() const {
  KOV_ENSURE(dimension() == 0);
  std::set<Monomial, MonomialOrder> found(MonomialOrder{0});
  std::vector<Monomial> queue{one()};
  Work work(budget_, "the monomials outside an ideal");
  while (!queue.empty()) {
    work.add(static_cast<double>((1 + basis_.size()) * main_.size()));
    Monomial m = std::move(queue.back());
    queue.pop_back();
    const bool standard =
        std::ranges::none_of(basis_, [&](const KPoly& g) { return divides(lead(g), m); });
    if (!standard || !found.insert(m).second) continue;
    for (std::size_t i = 0; i < main_.size(); ++i) {
      ++m[i];
      queue.push_back(m);
      --m[i];
    }
  }
  return {found.rbegin(), found.rend()};
}

} // namespace kov
