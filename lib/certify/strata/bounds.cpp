// strata_certificates.md 7.4: degree bounds, exponential solutions and invariants that do not
// exist.

#include "certify/strata/places.hpp"
#include "exact/modular.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

// e_c of local_exponents.md 2.1 for an exponent difference that is rational.
Integer lowest_rational(long m, const Rational& delta, bool log) {
  const Integer half(m / 2);
  const Integer d = delta.den();
  const Rational steps = log ? Rational(half) : Rational(-(floor_div(half, d) * d));
  return (Rational(half) + steps * delta).num();
}

std::optional<Integer> lowest(const ProvedPlace& x, long m, const std::optional<Rational>& open) {
  if (x.ordinary()) return Integer(0);
  if (x.simple()) return Integer(m);
  if (x.irregular()) {
    const Integer four = Integer(m) * Integer(x.order);
    if (!is_zero(four - Integer(4) * floor_div(four, Integer(4)))) return std::nullopt;
    return floor_div(four, Integer(4));
  }
  if (x.delta) return lowest_rational(m, *x.delta, x.log);
  if (x.open() && open) return lowest_rational(m, *open, false);
  return Integer(m / 2);
}

// An upper bound of |Re Delta| (local_exponents.md 4), if there is one.
std::optional<Rational> real_part(const ProvedPlace& x) {
  if (x.delta) return x.delta;
  if (x.by == Irrational::positive && x.linear()) return Rational(0);
  if (x.by == Irrational::constant) return root_above(*x.square, 8);
  return x.linear() ? x.largest() : std::nullopt;
}

} // namespace

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

bool Places::any(bool (ProvedPlace::*property)() const) const {
  return std::ranges::any_of(all_, [&](const auto& x) { return (x.*property)(); });
}

bool Places::torus() const { return any(&ProvedPlace::irregular) || any(&ProvedPlace::irrational); }

bool Places::log() const {
  return std::ranges::any_of(all_, [](const ProvedPlace& x) { return x.log; });
}

std::optional<Integer> Places::degree_bound(long m, const std::optional<Rational>& open) const {
  Integer D(m);
  for (const ProvedPlace& x : all_) {
    const auto e = lowest(x, m, open);
    if (!e) return std::nullopt;
    D -= *e * Integer(x.d);
  }
  return D;
}

std::optional<Rational> Places::degree_bound_1() const {
  Rational D(1);
  for (const ProvedPlace& x : all_) {
    if (x.irregular()) return std::nullopt;
    if (x.simple()) D -= Rational(x.d);
    if (!x.regular()) continue;
    const auto real = real_part(x);
    if (!real) return std::nullopt;
    D -= Rational(x.d) * (Rational(1) + (x.log ? *real : -*real)) / Rational(2);
  }
  return D;
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
  if (!x.log) c.insert(s * half * (Rational(1) + s * *x.delta));
  return c;
}

bool Places::no_line() const {
  if (no_line_by_degree()) return true;
  std::optional<Sums> sums{Sums{0}};
  for (const ProvedPlace& x : all_) {
    const auto choices = line_choices(x);
    if (!choices) return false;
    sums = add_choices(a_, std::move(sums), *choices, x.d);
    if (!sums) return false;
  }
  return std::ranges::none_of(*sums, is_natural_number);
}

std::vector<InvariantPlace> Places::exponents(long m) const {
  std::vector<InvariantPlace> factors;
  for (const ProvedPlace& x : all_)
    if (x.q) factors.push_back({*x.q, x.order, *lowest(x, m, {})});
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
    NmodPoly f(p);
    long k = 0;
    for (const MPoly& c : coefficients(rest, variable.value_or(0)))
      f.set_coeff(k++, is_zero(c) ? 0 : fmpz_fdiv_ui(c.coefficient(0).raw(), p));
    need(!is_zero(common) || degree(f) == k - 1, "the degree of the first minor drops modulo p");
    common = is_zero(common) ? f : gcd(common, f);
  }
  need(degree(common) == 0, "the minors have a common factor modulo p");
}

} // namespace kov::certify
