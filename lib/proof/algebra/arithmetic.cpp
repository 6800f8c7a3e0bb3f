#include "proof/algebra/arithmetic.hpp"

#include "proof/text/limits.hpp"
#include "proof/text/meter.hpp"
#include "proof/text/refused.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace kov::certify {

namespace {

double words(const MPoly& f) { // of the largest coefficient
  if (is_zero(f)) return 1;
  const auto top = std::abs(_fmpz_vec_max_bits(f.raw()->coeffs, f.length()));
  return 1 + static_cast<double>(top) / 64;
}

double words(const Integer& n) { return 1 + static_cast<double>(fmpz_bits(n.raw())) / 64; }

// The work of a product of two numbers of these lengths, for the limit.
double work(double a, double b) { return (a + b) * std::sqrt(std::min(a, b)); }

double terms(const MPoly& f) { return static_cast<double>(f.length()); }

std::vector<slong> degrees(const MPoly& f) {
  std::vector<slong> d(f.ring()->size());
  fmpz_mpoly_degrees_si(d.data(), f.raw(), f.ctx());
  return d;
}

Integer content(const MPoly& f) {
  Integer c;
  if (!is_zero(f)) _fmpz_vec_content(c.raw(), f.raw()->coeffs, f.length());
  return c;
}

// f + c x^k, not yet sorted
void push(MPoly& f, const MPoly& c, std::size_t x, std::size_t k) {
  for (long i = 0; i < c.length(); ++i) {
    auto e = c.exponents(i);
    e[x] += k;
    fmpz_mpoly_push_term_fmpz_ui(f.raw(), c.coefficient(i).raw(), e.data(), f.ctx());
  }
}

void trim(Coefficients& f) {
  while (!f.empty() && is_zero(f.back()))
    f.pop_back();
}

} // namespace

MPoly primitive(const MPoly& f) {
  MPoly g = f;
  if (!is_zero(g)) fmpz_mpoly_scalar_divexact_fmpz(g.raw(), f.raw(), content(f).raw(), f.ctx());
  return g;
}

MPoly scaled(const MPoly& f, const Integer& c) {
  MPoly g(f.ring());
  if (g.ring()) fmpz_mpoly_scalar_mul_fmpz(g.raw(), f.raw(), c.raw(), f.ctx());
  return g;
}

bool is_multiple(const MPoly& f, const MPoly& g) {
  const MPoly a = primitive(f), b = primitive(g);
  return a == b || a == -b;
}

bool is_in(const MPoly& f, const std::vector<bool>& names) {
  const auto used = used_variables(f);
  return std::ranges::all_of(used, [&](std::size_t i) { return names[i]; });
}

MPoly in_ring(const MPoly& f, const Ring& ring) {
  MPoly g(ring);
  for (long t = 0; t < f.length(); ++t) {
    const auto from = f.exponents(t);
    std::vector<unsigned long> e(ring->size(), 0);
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (from[i] == 0) continue;
      const auto at = ring->find(f.ring()->name(i));
      need(at.has_value(), "another name");
      e[*at] = from[i];
    }
    fmpz_mpoly_push_term_fmpz_ui(g.raw(), f.coefficient(t).raw(), e.data(), g.ctx());
  }
  fmpz_mpoly_sort_terms(g.raw(), g.ctx());
  return g;
}

static thread_local FileMeter* meter = nullptr;

FileMeter::FileMeter() : outer_(meter) { meter = outer_ == nullptr ? this : outer_; }
FileMeter::~FileMeter() { meter = outer_; }

void FileMeter::charge(double products, double words, double operations) {
  if (meter == nullptr) return;
  meter->products_ += products;
  meter->words_ += words;
  meter->operations_ += operations;
  need_within(meter->products_ <= max_products && meter->words_ <= max_word_work &&
                  meter->operations_ <= max_total,
              "a limit: the file is too much work");
}

void Arithmetic::charge(double products, double words) {
  FileMeter::charge(products, words);
  products_ += products;
  words_ += words;
  need_within(products_ <= max_products && words_ <= max_word_work,
              "a limit: the certificate is too much work");
}

MPoly Arithmetic::times(const MPoly& a, const MPoly& b) {
  if (is_zero(a) || is_zero(b)) return a.ring() ? MPoly(a.ring()) : MPoly(b.ring());
  const double wa = words(a);
  const double wb = words(b);
  const double pairs = terms(a) * terms(b);
  charge(1 + pairs, pairs * work(wa, wb));
  const auto da = degrees(a);
  const auto db = degrees(b);
  double box = 1; // an upper bound for the terms of the product
  for (std::size_t i = 0; i < da.size(); ++i) {
    need_within(da[i] + db[i] <= max_degree, "a limit: the degree of a polynomial");
    box *= static_cast<double>(da[i] + db[i] + 1);
  }
  need_within(std::min(box, pairs) * (wa + wb) <= max_result, "a limit: the size of a polynomial");
  return a * b;
}

MPoly Arithmetic::power(const MPoly& f, unsigned long e) {
  MPoly r(f.ring(), Integer(1));
  if (e == 0) return r;
  const auto top = static_cast<int>(std::bit_width(e));
  for (int i = top - 1; i >= 0; --i) {
    r = times(r, r);
    if ((e >> i) & 1UL) r = times(r, f);
  }
  return r;
}

MPoly Arithmetic::homogeneous(const Coefficients& c, const MPoly& p, const MPoly& q) {
  MPoly sum(q.ring());
  MPoly power(q.ring(), Integer(1)); // of q
  for (std::size_t i = c.size(); i-- > 0;) {
    sum = times(sum, p);
    if (!is_zero(c[i])) sum = plus(sum, times(c[i], power));
    if (i > 0) power = times(power, q);
  }
  return sum;
}

MPoly Arithmetic::plus(const MPoly& a, const MPoly& b) {
  charge(1 + terms(a) + terms(b), terms(a) * words(a) + terms(b) * words(b));
  return a + b;
}

MPoly Arithmetic::minus(const MPoly& a, const MPoly& b) {
  charge(1 + terms(a) + terms(b), terms(a) * words(a) + terms(b) * words(b));
  return a - b;
}

Integer Arithmetic::times(const Integer& a, const Integer& b) {
  const double m = words(a), n = words(b);
  charge(0, work(m, n));
  need_within(m + n <= max_number, "a limit: the length of a number");
  return a * b;
}

Integer Arithmetic::common_multiple(const Integer& a, const Integer& b) {
  const double m = words(a), n = words(b);
  charge(0, 10 * work(m, n));
  need_within(m + n <= max_number, "a limit: the length of a number");
  return lcm(a, b);
}

MPoly Arithmetic::scaled(const MPoly& f, const Integer& c) {
  const double w = words(f), n = words(c);
  charge(0, terms(f) * work(w, n));
  need_within(terms(f) * (w + n) <= max_result, "a limit: the size of a polynomial");
  return certify::scaled(f, c);
}

// School division in the first variable of b, whose coefficients are divided in the same way.
std::optional<MPoly> Arithmetic::quotient(const MPoly& a, const MPoly& b) {
  charge(1 + terms(a) + terms(b));
  if (is_zero(a)) return a;
  if (is_constant(b)) {
    const Integer c = b.coefficient(0);
    MPoly q(a.ring());
    if (fmpz_mpoly_scalar_divides_fmpz(q.raw(), a.raw(), c.raw(), a.ctx()) == 0)
      return std::nullopt;
    return q;
  }
  const auto da = degrees(a);
  const auto db = degrees(b);
  for (std::size_t i = 0; i < da.size(); ++i)
    if (db[i] > da[i]) return std::nullopt;
  const auto x = static_cast<std::size_t>(std::ranges::find_if(db, [](slong d) { return d > 0; }) -
                                          db.begin());
  charge(static_cast<double>(da[x]));
  Coefficients rest = coefficients(a, x);
  const Coefficients g = coefficients(b, x);
  const std::size_t m = g.size() - 1;
  MPoly q(a.ring());
  for (std::size_t k = rest.size() - 1;; --k) {
    if (!is_zero(rest[k])) {
      if (k < m) return std::nullopt;
      const auto c = quotient(rest[k], g[m]);
      if (!c) return std::nullopt;
      for (std::size_t j = 0; j < m; ++j)
        if (!is_zero(g[j])) rest[k - m + j] = minus(rest[k - m + j], times(*c, g[j]));
      push(q, *c, x, k - m);
    }
    if (k == 0) break;
  }
  fmpz_mpoly_sort_terms(q.raw(), q.ctx());
  return q;
}

MPoly Arithmetic::divided(const MPoly& a, const MPoly& b) {
  auto q = quotient(a, b);
  need(q.has_value(), "internal: a division is not exact");
  return *std::move(q);
}

Coefficients Elimination::pseudo_remainder(Coefficients f, const Coefficients& g) {
  std::size_t missing = f.size() < g.size() ? 0 : f.size() - g.size() + 1; // factors lead(g)
  for (; f.size() >= g.size(); --missing) {
    const MPoly top = f.back();
    const std::size_t shift = f.size() - g.size();
    for (std::size_t i = 0; i + 1 < f.size(); ++i) {
      f[i] = a_.times(f[i], g.back());
      if (i >= shift) f[i] = a_.minus(f[i], a_.times(top, g[i - shift]));
    }
    f.pop_back();
    trim(f);
  }
  if (missing > 0 && !f.empty()) {
    const MPoly factor = a_.power(g.back(), missing);
    for (MPoly& c : f)
      c = a_.times(c, factor);
  }
  return f;
}

MPoly Elimination::resultant(Coefficients f, Coefficients g) {
  trim(f);
  trim(g);
  need(!f.empty() || !g.empty(), "internal: a resultant of zeros");
  if (f.empty() || g.empty()) return MPoly((f.empty() ? g : f).front().ring());
  if (f.size() < g.size()) std::swap(f, g);
  MPoly lead(f.front().ring(), Integer(1));
  MPoly h = lead;
  // h^(1 - k) c^k
  const auto next = [&](const MPoly& c, std::size_t k) {
    if (k == 0) return h;
    return k == 1 ? c : a_.divided(a_.power(c, k), a_.power(h, k - 1));
  };
  while (g.size() > 1) {
    const std::size_t drop = f.size() - g.size();
    Coefficients r = pseudo_remainder(std::move(f), g);
    const MPoly divisor = a_.times(lead, a_.power(h, drop));
    for (MPoly& c : r)
      c = a_.divided(c, divisor);
    f = std::move(g);
    g = std::move(r);
    if (g.empty()) return MPoly(f.front().ring());
    lead = f.back();
    h = next(lead, drop);
  }
  return next(g.back(), f.size() - 1);
}

MPoly Elimination::determinant(std::vector<std::vector<MPoly>> rows) {
  const std::size_t n = rows.size();
  need_within(n > 0 && n <= static_cast<std::size_t>(max_unknowns),
              "a limit: the size of a matrix");
  bool negative = false;
  MPoly before(rows[0][0].ring(), Integer(1));
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = n;
    for (std::size_t i = k; i < n; ++i)
      if (!is_zero(rows[i][k]) && (pivot == n || rows[i][k].length() < rows[pivot][k].length()))
        pivot = i;
    if (pivot == n) return MPoly(before.ring());
    if (pivot != k) {
      std::swap(rows[k], rows[pivot]);
      negative = !negative;
    }
    for (std::size_t i = k + 1; i < n; ++i)
      for (std::size_t j = k + 1; j < n; ++j) {
        const MPoly x =
            a_.minus(a_.times(rows[k][k], rows[i][j]), a_.times(rows[i][k], rows[k][j]));
        rows[i][j] = a_.divided(x, before);
      }
    before = rows[k][k];
  }
  return negative ? -before : before;
}

} // namespace kov::certify
