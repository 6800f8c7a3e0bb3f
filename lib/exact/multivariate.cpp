#include "exact/multivariate.hpp"

#include "exact/error.hpp"
#include "exact/meter.hpp"
#include "exact/quick_size.hpp"

#include <algorithm>
#include <set>

namespace kov {
namespace {

const Ring& common_ring(const Ring& a, const Ring& b) {
  if (!b || a == b) return a;
  if (!a) return b;
  throw InvalidArgument("two multivariate values from different rings cannot be combined");
}

// Measured, in units of the meter (docs/theory/work.md).
constexpr double units_per_product = 3.0 / 8;
constexpr double units_per_term = 3; // of a dividend

// FLINT reads beyond its exponents when it is asked for a variable that the ring has not.
slong variable_of(const Ring& ring, std::size_t i) {
  KOV_ENSURE(i < ring->size());
  return static_cast<slong>(i);
}

// FLINT stops the program when it is asked for an exponent that is not a machine word.
MPoly checked_exponents(MPoly f) {
  if (fmpz_mpoly_degrees_fit_si(f.raw(), f.ctx()) == 0)
    throw DomainError("the exponents of a polynomial are too large");
  return f;
}

} // namespace

Variables::Variables(std::vector<std::string> names) : names_(std::move(names)) {
  std::set<std::string> seen;
  for (const auto& name : names_) {
    if (name.empty()) throw InvalidArgument("a variable needs a name");
    if (!seen.insert(name).second)
      throw InvalidArgument("the variable '" + name + "' is declared twice");
  }
  fmpz_mpoly_ctx_init(ctx_, static_cast<slong>(names_.size()), ORD_LEX);
}

Variables::~Variables() { fmpz_mpoly_ctx_clear(ctx_); }

std::optional<std::size_t> Variables::find(std::string_view name) const {
  for (std::size_t i = 0; i < names_.size(); ++i)
    if (names_[i] == name) return i;
  return std::nullopt;
}

std::size_t Variables::index(std::string_view name) const {
  if (const auto i = find(name)) return *i;
  throw InvalidArgument("there is no variable '" + std::string(name) + "'");
}

Ring make_ring(std::vector<std::string> names) {
  return std::make_shared<const Variables>(std::move(names));
}

// ---- MPoly

MPoly::MPoly(Ring ring) : ring_(std::move(ring)) {
  if (ring_) fmpz_mpoly_init(v_, ctx());
}
MPoly::MPoly(Ring ring, const Integer& c) : MPoly(std::move(ring)) {
  fmpz_mpoly_set_fmpz(v_, c.raw(), ctx());
}
MPoly::MPoly(const MPoly& o) : MPoly(o.ring_) {
  if (ring_) fmpz_mpoly_set(v_, o.v_, ctx());
}
MPoly::MPoly(MPoly&& o) noexcept : ring_(std::move(o.ring_)) { std::swap(*v_, *o.v_); }
MPoly& MPoly::operator=(MPoly o) noexcept {
  ring_.swap(o.ring_);
  std::swap(*v_, *o.v_);
  return *this;
}
MPoly::~MPoly() {
  if (ring_) fmpz_mpoly_clear(v_, ctx());
}

MPoly MPoly::variable(const Ring& ring, std::size_t i) {
  MPoly f(ring);
  fmpz_mpoly_gen(f.v_, variable_of(ring, i), f.ctx());
  return f;
}
MPoly MPoly::variable(const Ring& ring, std::string_view name) {
  return variable(ring, ring->index(name));
}
MPoly MPoly::term(const Ring& ring, const Integer& c, const std::vector<unsigned long>& e) {
  KOV_ENSURE(e.size() == ring->size());
  MPoly f(ring);
  fmpz_mpoly_set_coeff_fmpz_ui(f.v_, c.raw(), e.data(), f.ctx());
  return f;
}

long MPoly::length() const noexcept { return ring_ ? fmpz_mpoly_length(v_, ctx()) : 0; }
Integer MPoly::coefficient(long i) const {
  KOV_ENSURE(0 <= i && i < length());
  Integer c;
  fmpz_mpoly_get_term_coeff_fmpz(c.raw(), v_, i, ctx());
  return c;
}
std::vector<unsigned long> MPoly::exponents(long i) const {
  KOV_ENSURE(0 <= i && i < length());
  std::vector<unsigned long> e(ring_->size());
  fmpz_mpoly_get_term_exp_ui(e.data(), v_, i, ctx());
  return e;
}

MPoly operator+(const MPoly& a, const MPoly& b) {
  MPoly r(common_ring(a.ring_, b.ring_));
  if (!a.ring_ || !b.ring_) return a.ring_ ? a : b;
  fmpz_mpoly_add(r.v_, a.v_, b.v_, r.ctx());
  return r;
}
MPoly operator-(const MPoly& a, const MPoly& b) {
  if (!b.ring_) return a;
  if (!a.ring_) return -b;
  MPoly r(common_ring(a.ring_, b.ring_));
  fmpz_mpoly_sub(r.v_, a.v_, b.v_, r.ctx());
  return r;
}
MPoly operator*(const MPoly& a, const MPoly& b) {
  MPoly r(common_ring(a.ring_, b.ring_));
  if (!a.ring_ || !b.ring_) return r;
  charge(units_per_product * quick_size(a.v_) * quick_size(b.v_));
  fmpz_mpoly_mul(r.v_, a.v_, b.v_, r.ctx());
  return checked_exponents(std::move(r));
}
MPoly operator-(const MPoly& a) {
  MPoly r(a.ring_);
  if (r.ring_) fmpz_mpoly_neg(r.v_, a.v_, r.ctx());
  return r;
}
bool operator==(const MPoly& a, const MPoly& b) {
  if (!a.ring_ || !b.ring_) return is_zero(a) && is_zero(b);
  return fmpz_mpoly_equal(a.v_, b.v_, common_ring(a.ring_, b.ring_)->ctx()) != 0;
}

bool is_zero(const MPoly& f) { return f.length() == 0; }
bool is_one(const MPoly& f) { return f.ring() && fmpz_mpoly_is_one(f.raw(), f.ctx()) != 0; }
bool is_constant(const MPoly& f) { return !f.ring() || fmpz_mpoly_is_fmpz(f.raw(), f.ctx()) != 0; }

MPoly pow(const MPoly& f, unsigned long e) {
  MPoly r(f.ring());
  if (r.ring() && fmpz_mpoly_pow_ui(r.raw(), f.raw(), e, r.ctx()) == 0)
    throw DomainError("the power " + std::to_string(e) + " of a polynomial is too large");
  return r.ring() ? checked_exponents(std::move(r)) : r;
}

MPoly derivative(const MPoly& f, std::size_t i) {
  MPoly r(f.ring());
  if (r.ring()) fmpz_mpoly_derivative(r.raw(), f.raw(), variable_of(f.ring(), i), r.ctx());
  return r;
}

long degree(const MPoly& f, std::size_t i) {
  return f.ring() ? fmpz_mpoly_degree_si(f.raw(), variable_of(f.ring(), i), f.ctx()) : -1;
}
bool uses(const MPoly& f, std::size_t i) { return degree(f, i) > 0; }
std::vector<std::size_t> used_variables(const MPoly& f) {
  std::vector<std::size_t> used;
  for (std::size_t i = 0; f.ring() && i < f.ring()->size(); ++i)
    if (uses(f, i)) used.push_back(i);
  return used;
}

MPoly gcd(const MPoly& a, const MPoly& b) {
  MPoly r(common_ring(a.ring(), b.ring()));
  if (!r.ring()) return r;
  const MPoly zero(r.ring());
  const auto raw = [&](const MPoly& f) { return f.ring() ? f.raw() : zero.raw(); };
  if (fmpz_mpoly_gcd(r.raw(), raw(a), raw(b), r.ctx()) == 0)
    throw DomainError("a greatest common divisor could not be computed: exponents too large");
  return r;
}

std::optional<MPoly> divides(const MPoly& b, const MPoly& a) {
  if (is_zero(b)) return is_zero(a) ? std::optional(a) : std::nullopt;
  if (!a.ring()) return a;
  MPoly q(common_ring(a.ring(), b.ring()));
  charge(units_per_term * quick_size(a.raw()));
  if (fmpz_mpoly_divides(q.raw(), a.raw(), b.raw(), q.ctx()) == 0) return std::nullopt;
  return q;
}
MPoly exact_div(const MPoly& a, const MPoly& b) {
  auto q = divides(b, a);
  KOV_ENSURE(q.has_value());
  return *std::move(q);
}

std::vector<MPoly> coefficients(const MPoly& f, std::size_t i) {
  std::vector<MPoly> c;
  if (is_zero(f)) return c;
  const slong x = variable_of(f.ring(), i);
  fmpz_mpoly_univar_t u;
  fmpz_mpoly_univar_init(u, f.ctx());
  fmpz_mpoly_to_univar(u, f.raw(), x, f.ctx());
  c.assign(static_cast<std::size_t>(degree(f, i) + 1), MPoly(f.ring()));
  for (slong k = 0; k < fmpz_mpoly_univar_length(u, f.ctx()); ++k) {
    const slong e = fmpz_mpoly_univar_get_term_exp_si(u, k, f.ctx());
    fmpz_mpoly_univar_get_term_coeff(c[static_cast<std::size_t>(e)].raw(), u, k, f.ctx());
  }
  fmpz_mpoly_univar_clear(u, f.ctx());
  return c;
}

MPoly resultant(const MPoly& a, const MPoly& b, std::size_t i) {
  MPoly r(common_ring(a.ring(), b.ring()));
  if (!a.ring() || !b.ring()) return r;
  if (fmpz_mpoly_resultant(r.raw(), a.raw(), b.raw(), variable_of(r.ring(), i), r.ctx()) == 0)
    throw DomainError("a resultant could not be computed: exponents too large");
  return r;
}
MPoly discriminant(const MPoly& f, std::size_t i) {
  MPoly r(f.ring());
  if (!f.ring()) return r;
  if (fmpz_mpoly_discriminant(r.raw(), f.raw(), variable_of(r.ring(), i), r.ctx()) == 0)
    throw DomainError("a discriminant could not be computed: exponents too large");
  return r;
}

std::pair<Integer, std::vector<MFactor>> factor(const MPoly& f) {
  KOV_ENSURE(!is_zero(f));
  fmpz_mpoly_factor_t fac;
  fmpz_mpoly_factor_init(fac, f.ctx());
  const bool ok = fmpz_mpoly_factor(fac, f.raw(), f.ctx()) != 0;
  Integer content;
  std::vector<MFactor> factors;
  if (ok) fmpz_mpoly_factor_get_constant_fmpz(content.raw(), fac, f.ctx());
  for (slong i = 0; ok && i < fmpz_mpoly_factor_length(fac, f.ctx()); ++i) {
    MFactor one{MPoly(f.ring()), fmpz_mpoly_factor_get_exp_si(fac, i, f.ctx())};
    fmpz_mpoly_factor_get_base(one.base.raw(), fac, i, f.ctx());
    if (sign(one.base.coefficient(0)) < 0) {
      one.base = -one.base;
      if (one.exponent % 2 != 0) content = -content;
    }
    factors.push_back(std::move(one));
  }
  fmpz_mpoly_factor_clear(fac, f.ctx());
  if (!ok) throw DomainError("a polynomial could not be factored: " + to_string(f));
  std::ranges::sort(factors, [](const MFactor& a, const MFactor& b) {
    return a.exponent != b.exponent ? a.exponent < b.exponent : compare(a.base, b.base) < 0;
  });
  return {content, std::move(factors)};
}

int compare(const MPoly& a, const MPoly& b) {
  if (is_zero(a) || is_zero(b)) return static_cast<int>(is_zero(b)) - static_cast<int>(is_zero(a));
  return fmpz_mpoly_cmp(a.raw(), b.raw(), common_ring(a.ring(), b.ring())->ctx());
}

std::string to_string(const MPoly& f) {
  if (is_zero(f)) return "0";
  std::string s;
  for (long i = 0; i < f.length(); ++i) {
    const Integer c = f.coefficient(i);
    const Integer size = sign(c) < 0 ? -c : c;
    if (!s.empty())
      s += sign(c) < 0 ? " - " : " + ";
    else if (sign(c) < 0)
      s += "-";
    const auto e = f.exponents(i);
    std::string monomial;
    for (std::size_t k = 0; k < e.size(); ++k) {
      if (e[k] == 0) continue;
      if (!monomial.empty()) monomial += "*";
      monomial += f.ring()->name(k);
      if (e[k] > 1) monomial += "^" + std::to_string(e[k]);
    }
    if (monomial.empty())
      s += to_string(size);
    else
      s += size == Integer(1) ? monomial : to_string(size) + "*" + monomial;
  }
  return s;
}

} // namespace kov
