// strata_certificates.md 7.4: degree bounds, exponential solutions and invariants that do not
// exist.

#include "certify/strata/places.hpp"
#include "exact/to_poly.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

std::optional<Sums> add_choices(Arithmetic& a, std::optional<Sums> sums, const Sums& choices,
                                long times) {
  for (long i = 0; i < times && sums; ++i) {
    a.charge(work_of_a_rational * static_cast<double>(sums->size() * choices.size()));
    Sums next;
    for (const Rational& s : *sums)
      for (const Rational& c : choices)
        next.insert(s + c);
    if (next.size() > max_sums)
      sums.reset();
    else
      sums = std::move(next);
  }
  return sums;
}

bool Places::no_line_by_degree() const {
  if (any(&ProvedPlace::ramified)) return true;
  const auto D = degree_bound_1();
  return D && sign(*D) < 0;
}

std::optional<Sums> Places::line_choices(const ProvedPlace& x) {
  const Rational half(1, 2);
  if (x.ordinary()) return Sums{0, 1}; // infinity: finite places have order 1 at least
  if (x.simple()) return Sums{x.q ? -1 : 0};
  if (!x.delta) return std::nullopt;
  const Rational s(x.sign());
  // infinity (1 - Delta)/2, finite -(1 + Delta)/2, and without logarithm the other sign as well
  Sums c{s * half * (Rational(1) - s * *x.delta)};
  if (!x.has_log()) c.insert(s * half * (Rational(1) + s * *x.delta));
  return c;
}

bool Places::no_line() const {
  if (no_line_by_degree()) return true;
  std::optional<Sums> sums{Sums{0}};
  for (const ProvedPlace& x : all) {
    const auto choices = line_choices(x);
    if (!choices) return false;
    sums = add_choices(a_, std::move(sums), *choices, x.n);
    if (!sums) return false;
  }
  return std::ranges::none_of(*sums, is_natural_number);
}

std::vector<InvariantPlace> Places::exponents(long m) const {
  std::vector<InvariantPlace> factors;
  for (const ProvedPlace& x : all)
    if (x.q) factors.push_back({*x.q, x.order, *x.lowest(m)});
  return factors;
}

bool Places::no_invariant(long m) const {
  need_within(m >= 2 && m <= max_sym && m % 2 == 0, "a limit: the degree of an invariant");
  const auto D = degree_bound(m);
  if (!D || sign(*D) < 0) return true;
  return std::ranges::any_of(leaf_.absent, [&](const AbsentInvariant& x) {
    if (x.m != m) return false;
    need_within(*D < Integer(max_unknowns), "a limit: the size of a linear system");
    need_full_rank(x, to_long(*D));
    return true;
  });
}

// The matrix of T_(m+1) = 0 in the n coefficients of p; the minors of the given rows.
Coefficients Places::minors(const AbsentInvariant& x, std::size_t n) const {
  const Ring& ring = leaf_.content.ring();
  const InvariantRecurrence recurrence(s_, leaf_.content, exponents(x.m));
  std::vector<Coefficients> columns;
  for (std::size_t j = 0; j < n; ++j) {
    const MPoly z = a_.power(MPoly::variable(ring, 0), j);
    columns.push_back(coefficients(recurrence.last(z, x.m), 0));
  }
  Coefficients values;
  for (const Minor& minor : x.minors) {
    need(minor.rows.size() == n && std::set<long>(minor.rows.begin(), minor.rows.end()).size() == n,
         "a minor needs as many different rows as there are unknowns");
    std::vector<std::vector<MPoly>> rows;
    for (const long i : minor.rows) {
      std::vector<MPoly> row;
      for (const Coefficients& c : columns)
        row.push_back(i < static_cast<long>(c.size()) ? c[static_cast<std::size_t>(i)]
                                                      : MPoly(ring));
      rows.push_back(std::move(row));
    }
    values.push_back(Elimination(a_).determinant(std::move(rows)));
  }
  return values;
}

// Full rank at every point: a combination of the minors vanishes nowhere, or they have no common
// root.
void Places::need_full_rank(const AbsentInvariant& x, long D) const {
  const Coefficients values = minors(x, static_cast<std::size_t>(D + 1));
  for (const Minor& minor : x.minors)
    s_.need_parameters(minor.times);
  if (x.prime) {
    need_no_common_root(values, x);
    return;
  }
  MPoly sum(leaf_.content.ring());
  for (std::size_t i = 0; i < values.size(); ++i)
    sum = a_.plus(sum, a_.times(x.minors[i].times, values[i]));
  need(s_.is_unit(sum), "the minors are not known to give full rank");
}

// A common root of polynomials over Q in one parameter is one of a common factor, which is one
// modulo p as well, where the degree of the first does not drop.
void Places::need_no_common_root(const Coefficients& minors, const AbsentInvariant& x) const {
  const mp_limb_t p = *x.prime;
  need(p < (mp_limb_t{1} << 31) && n_is_prime(p) != 0, "the prime is none below 2^31");
  need(minors.size() >= 2, "two minors at least are expected");
  std::optional<std::size_t> variable;
  NmodPoly common(p);
  for (std::size_t i = 0; i < minors.size(); ++i) {
    need(is_one(x.minors[i].times), "with a prime all times are 1");
    if (is_zero(minors[i])) continue; // says nothing
    const MPoly rest = s_.rest(minors[i]);
    for (const std::size_t v : used_variables(rest)) {
      need(!variable || variable == v, "the minors have several parameters");
      variable = v;
    }
    const std::size_t x = variable.value_or(0);
    const NmodPoly f = to_poly(rest, x, p);
    need(!is_zero(common) || degree(f) == degree(rest, x),
         "the degree of the first minor drops modulo p");
    common = is_zero(common) ? f : gcd(common, f);
  }
  need(degree(common) == 0, "the minors have a common factor modulo p");
}

} // namespace kov::certify
