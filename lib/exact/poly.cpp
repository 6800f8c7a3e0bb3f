#include "exact/poly.hpp"

#include "exact/error.hpp"
#include "exact/modular.hpp"
#include "exact/modular_gcd.hpp"

namespace kov {
namespace {

// numerator(v) <- blocks reduced modulo the minimal polynomial
void reduce(fmpq_poly_t v, const NumberField& k) {
  if (k.is_rational()) return;
  fmpz_poly_t flat;
  fmpz_poly_init(flat);
  fmpq_poly_get_numerator(flat, v);
  reduce_blocks(flat, k);
  fmpq_poly_t reduced;
  fmpq_poly_init(reduced);
  fmpq_poly_set_fmpz_poly(reduced, flat);
  fmpq_poly_scalar_div_fmpz(reduced, reduced, fmpq_poly_denref(v));
  fmpq_poly_swap(v, reduced);
  fmpq_poly_clear(reduced);
  fmpz_poly_clear(flat);
}

} // namespace

Poly::Poly(const NfElem& constant) : Poly(constant.field()) { fmpq_poly_set(v_, constant.raw()); }

Poly Poly::monomial(const NfElem& c, long i) {
  Poly f(c.field());
  fmpq_poly_shift_left(f.v_, c.raw(), i * f.stride());
  return f;
}

Poly Poly::from_coefficients(const std::vector<NfElem>& c) {
  Field k = rationals();
  for (const auto& e : c)
    k = common_field(k, e.field());
  Poly f(k);
  // One common denominator first: setting coefficients one by one would rescale each time.
  Integer den(1);
  for (const auto& e : c)
    fmpz_lcm(den.raw(), den.raw(), fmpq_poly_denref(e.raw()));
  const long stride = f.stride();
  fmpz_poly_t flat;
  fmpz_poly_init2(flat, stride * static_cast<long>(c.size()) + 1);
  Integer factor;
  Integer entry;
  for (std::size_t i = 0; i < c.size(); ++i) {
    fmpz_divexact(factor.raw(), den.raw(), fmpq_poly_denref(c[i].raw()));
    for (long j = 0; j < fmpq_poly_length(c[i].raw()); ++j) {
      fmpz_mul(entry.raw(), fmpq_poly_numref(c[i].raw()) + j, factor.raw());
      fmpz_poly_set_coeff_fmpz(flat, static_cast<long>(i) * stride + j, entry.raw());
    }
  }
  fmpq_poly_set_fmpz_poly(f.v_, flat);
  fmpq_poly_scalar_div_fmpz(f.v_, f.v_, den.raw());
  fmpz_poly_clear(flat);
  return f;
}

NfElem Poly::coeff(long i) const {
  NfElem c(k_);
  if (i < 0) return c;
  const long first = i * stride();
  const long n = std::min(k_->degree(), v_->length - first);
  if (n <= 0) return c;
  fmpq_poly_fit_length(c.raw(), n);
  _fmpz_vec_set(c.raw()->coeffs, v_->coeffs + first, n);
  fmpz_set(c.raw()->den, v_->den);
  _fmpq_poly_set_length(c.raw(), n);
  fmpq_poly_canonicalise(c.raw());
  return c;
}

void Poly::set_coeff(long i, const NfElem& c) { *this += monomial(c - coeff(i), i); }

Poly coerce(const Poly& f, const Field& k) {
  if (f.field() == k) return f;
  if (!f.field()->is_rational())
    throw InvalidArgument("a polynomial over Q(" + f.field()->name() +
                          ") cannot be moved to another field");
  Poly g(k);
  if (k->is_rational()) {
    fmpq_poly_set(g.raw(), f.raw());
    return g;
  }
  // f(z) flat is f in y; stretch y -> y^stride
  const long s = g.stride();
  fmpz_poly_t flat;
  fmpz_poly_init(flat);
  for (long i = fmpq_poly_degree(f.raw()); i >= 0; --i)
    fmpz_poly_set_coeff_fmpz(flat, i * s, fmpq_poly_numref(f.raw()) + i);
  fmpq_poly_set_fmpz_poly(g.raw(), flat);
  fmpq_poly_scalar_div_fmpz(g.raw(), g.raw(), fmpq_poly_denref(f.raw()));
  fmpz_poly_clear(flat);
  return g;
}

namespace {

// Applies op to two polynomials brought to their common field.
template <class Op> Poly combined(const Poly& a, const Poly& b, Op op) {
  const Field& k = common_field(a.field(), b.field());
  Poly c(k);
  if (a.field() == b.field()) {
    op(c.raw(), a.raw(), b.raw());
  } else {
    const Poly x = coerce(a, k);
    const Poly y = coerce(b, k);
    op(c.raw(), x.raw(), y.raw());
  }
  return c;
}

} // namespace

Poly operator+(const Poly& a, const Poly& b) { return combined(a, b, fmpq_poly_add); }
Poly operator-(const Poly& a, const Poly& b) { return combined(a, b, fmpq_poly_sub); }

Poly operator*(const Poly& a, const Poly& b) {
  Poly c = combined(a, b, fmpq_poly_mul);
  reduce(c.raw(), *c.field());
  return c;
}

Poly operator-(Poly a) {
  fmpq_poly_neg(a.v_, a.v_);
  return a;
}

bool Poly::equal_over_two_fields(const Poly& a, const Poly& b) {
  if (degree(a) != degree(b)) return false;
  for (long i = degree(a); i >= 0; --i)
    if (!(a.coeff(i) == b.coeff(i))) return false;
  return true;
}

long degree(const Poly& f) noexcept {
  const long top = fmpq_poly_degree(f.raw());
  return top < 0 ? -1 : top / f.stride();
}

NfElem lead(const Poly& f) { return f.coeff(degree(f)); }

Poly derivative(const Poly& f) {
  Poly g(f.field());
  if (f.stride() == 1) {
    fmpq_poly_derivative(g.raw(), f.raw());
    return g;
  }
  fmpz_poly_t flat;
  fmpz_poly_init(flat);
  fmpq_poly_get_numerator(flat, f.raw());
  const long s = f.stride();
  for (long i = 0; i < flat->length; ++i)
    fmpz_mul_si(flat->coeffs + i, flat->coeffs + i, i / s);
  _fmpz_poly_normalise(flat);
  fmpz_poly_shift_right(flat, flat, s);
  fmpq_poly_set_fmpz_poly(g.raw(), flat);
  fmpq_poly_scalar_div_fmpz(g.raw(), g.raw(), fmpq_poly_denref(f.raw()));
  fmpz_poly_clear(flat);
  return g;
}

Poly monic(const Poly& f) {
  if (is_zero(f)) throw DomainError("the zero polynomial has no monic form");
  if (f.stride() == 1) {
    Poly g(f.field());
    fmpq_poly_make_monic(g.raw(), f.raw());
    return g;
  }
  const NfElem c = lead(f);
  return is_one(c) ? f : scale(f, inverse(c));
}

Poly scale(const Poly& f, const NfElem& c) {
  if (is_rational(c)) {
    Poly g = coerce(f, common_field(f.field(), c.field()));
    if (is_one(c)) return g;
    fmpq_poly_scalar_mul_fmpq(g.raw(), g.raw(), c.coeff(0).raw());
    return g;
  }
  return f * Poly(c);
}

Poly pow(const Poly& f, unsigned long e) {
  if (f.stride() == 1) {
    Poly g(f.field());
    fmpq_poly_pow(g.raw(), f.raw(), e);
    return g;
  }
  Poly result(Rational(1));
  Poly base = f;
  for (; e != 0; e >>= 1) {
    if (e & 1) result *= base;
    if (e > 1) base *= base;
  }
  return coerce(result, f.field());
}

Poly shift_left(const Poly& f, long k) {
  Poly g(f.field());
  fmpq_poly_shift_left(g.raw(), f.raw(), k * f.stride());
  return g;
}

Poly shift_right(const Poly& f, long k) {
  Poly g(f.field());
  fmpq_poly_shift_right(g.raw(), f.raw(), k * f.stride());
  return g;
}

Poly truncate(const Poly& f, long n) {
  Poly g = f;
  if (n <= 0) return Poly(f.field());
  fmpq_poly_truncate(g.raw(), n * f.stride());
  return g;
}

Poly reverse(const Poly& f, long n) {
  if (f.stride() == 1) {
    Poly g(f.field());
    fmpq_poly_reverse(g.raw(), f.raw(), n);
    return g;
  }
  std::vector<NfElem> c;
  for (long i = 0; i < n; ++i)
    c.push_back(f.coeff(n - 1 - i));
  return coerce(Poly::from_coefficients(c), f.field());
}

Poly inverse_series(const Poly& f, long n) {
  if (is_zero(f.coeff(0))) throw DomainError("a power series without constant term has no inverse");
  if (f.stride() == 1) {
    Poly g(f.field());
    fmpq_poly_inv_series(g.raw(), f.raw(), n);
    return g;
  }
  Poly g(inverse(f.coeff(0))); // Newton: g <- g (2 - f g)
  for (long k = 1; k < n;) {
    k = std::min(2 * k, n);
    g = truncate(g * (Poly(2) - truncate(truncate(f, k) * g, k)), k);
  }
  return coerce(g, f.field());
}

namespace {

bool has_rational_coefficients(const Poly& f) {
  for (long i = 0; i < fmpq_poly_length(f.raw()); ++i)
    if (i % f.stride() != 0 && fmpz_is_zero(fmpq_poly_numref(f.raw()) + i) == 0) return false;
  return true;
}

// The polynomial over Q that stands before a^j.
Poly coordinate(const Poly& f, long j) {
  std::vector<NfElem> c;
  for (long i = 0; i <= degree(f); ++i)
    c.emplace_back(f.coeff(i).coeff(j));
  return Poly::from_coefficients(c);
}

// A divisor over Q divides each coordinate.
std::pair<Poly, Poly> divrem_by_rational(const Poly& a, const Poly& b) {
  const Field& k = a.field();
  const Poly divisor = coordinate(b, 0);
  std::pair<Poly, Poly> qr{Poly(k), Poly(k)};
  NfElem power(1);
  for (long j = 0; j < k->degree(); ++j) {
    const auto [q, r] = divrem(coordinate(a, j), divisor);
    qr.first += scale(coerce(q, k), power);
    qr.second += scale(coerce(r, k), power);
    power *= NfElem::generator(k);
  }
  return qr;
}

} // namespace

std::pair<Poly, Poly> divrem(const Poly& a0, const Poly& b0) {
  if (is_zero(b0)) throw DomainError("division by the zero polynomial");
  const Field& k = common_field(a0.field(), b0.field());
  if (degree(a0) < degree(b0)) return {Poly(k), coerce(a0, k)};
  if (k->is_rational()) {
    std::pair<Poly, Poly> qr{Poly(k), Poly(k)};
    fmpq_poly_divrem(qr.first.raw(), qr.second.raw(), a0.raw(), b0.raw());
    return qr;
  }
  const Poly a = coerce(a0, k);
  const Poly b = coerce(b0, k);
  const long n = degree(a) - degree(b) + 1; // number of coefficients of the quotient
  if (degree(b) == 0) return {scale(a, inverse(lead(b))), Poly(k)};
  if (has_rational_coefficients(b)) return divrem_by_rational(a, b);
  const Poly top = truncate(reverse(a, degree(a) + 1), n);
  const Poly bottom = truncate(reverse(b, degree(b) + 1), n);
  const Poly q = reverse(truncate(top * inverse_series(bottom, n), n), n);
  return {q, a - q * b};
}

Poly operator%(const Poly& a, const Poly& b) { return divrem(a, b).second; }
Poly quotient(const Poly& a, const Poly& b) { return divrem(a, b).first; }

namespace {

// Over Q(a) a long division goes through coefficients that are far larger than those of an exact
// quotient.
ModularQuotient long_quotient(const Poly& a, const Poly& b) {
  constexpr long long_division = 16;
  const bool rational = common_field(a.field(), b.field())->is_rational();
  if (rational || has_rational_coefficients(b) ||
      std::min(degree(b), degree(a) - degree(b)) < long_division)
    return {};
  return modular_quotient(a, b);
}

} // namespace

Poly exact_div(const Poly& a, const Poly& b) {
  ModularQuotient known = long_quotient(a, b);
  KOV_ENSURE(known.divides != Truth::no);
  if (known.divides == Truth::yes) return std::move(known.quotient);
  auto [q, r] = divrem(a, b);
  KOV_ENSURE(is_zero(r));
  return q;
}

bool divides(const Poly& b, const Poly& a) {
  const Truth known = long_quotient(a, b).divides;
  return known == Truth::unknown ? is_zero(a % b) : known == Truth::yes;
}

std::pair<long, Poly> remove_factor(const Poly& f, const Poly& q) {
  KOV_ENSURE(!is_zero(f) && degree(q) > 0);
  if (degree(f) < degree(q)) return {0, f};
  const auto [rest, r] = divrem(f, q);
  if (!is_zero(r)) return {0, f};
  // f = q rest; take q^2 out of the rest as often as possible, then perhaps one q more.
  auto [pairs, left] = remove_factor(rest, q * q);
  const auto [last, remainder] = divrem(left, q);
  if (!is_zero(remainder)) return {1 + 2 * pairs, left};
  return {2 + 2 * pairs, last};
}

Poly gcd(const Poly& a0, const Poly& b0) {
  const Field& k = common_field(a0.field(), b0.field());
  if (degree(a0) == 0 || degree(b0) == 0) return coerce(Poly(1), k);
  const bool small = degree(a0) + degree(b0) < 24;
  if (k->is_rational() && (small || is_zero(a0) || is_zero(b0))) {
    Poly g(k);
    fmpq_poly_gcd(g.raw(), a0.raw(), b0.raw());
    return g;
  }
  Poly a = coerce(a0, k);
  Poly b = coerce(b0, k);
  if (is_zero(a)) return is_zero(b) ? b : monic(b);
  if (is_zero(b)) return monic(a);
  if (degree(a) < degree(b)) std::swap(a, b);
  // One prime bounds the degree of the gcd: that settles the two common cases, 1 and b itself.
  const auto bound = gcd_degree_bound(a, b);
  if (bound && *bound == 0) return coerce(Poly(1), k);
  if (bound && *bound == degree(b) && divides(b, a)) return monic(b);
  if (k->is_rational()) {
    Poly g(k);
    fmpq_poly_gcd(g.raw(), a.raw(), b.raw());
    return g;
  }
  if (degree(b) > 2)
    if (auto g = modular_gcd(a, b)) return *std::move(g);
  a = monic(a);
  b = monic(b);
  while (!is_zero(b)) {
    Poly r = a % b;
    a = std::move(b);
    b = is_zero(r) ? r : monic(r);
  }
  return a;
}

Poly lcm(const Poly& a, const Poly& b) {
  if (is_zero(a) || is_zero(b)) return Poly(common_field(a.field(), b.field()));
  return monic(exact_div(a, gcd(a, b)) * b);
}

Poly inverse_mod(const Poly& a0, const Poly& q0) {
  const Field& k = common_field(a0.field(), q0.field());
  const Poly q = coerce(q0, k);
  Poly a = coerce(a0, k) % q;
  if (degree(q) == 0) return Poly(k);
  if (k->is_rational()) {
    Poly g(k);
    Poly s(k);
    Poly t(k);
    fmpq_poly_xgcd(g.raw(), s.raw(), t.raw(), a.raw(), q.raw());
    if (degree(g) != 0)
      throw DomainError("no inverse modulo a polynomial: common factor " + to_string(g));
    return s;
  }
  if (degree(q) > 2)
    if (auto s = modular_inverse(a, q)) return *std::move(s);
  // Euclid with monic remainders; s*a = r (mod q) throughout.
  Poly r0 = q;
  Poly r1 = a;
  Poly s0(k);
  Poly s1 = coerce(Poly(1), k);
  while (degree(r1) > 0) {
    auto [quot, r] = divrem(r0, r1);
    Poly s = (s0 - quot * s1) % q;
    if (!is_zero(r)) {
      const NfElem c = inverse(lead(r));
      r = scale(r, c);
      s = scale(s, c);
    }
    r0 = std::move(r1);
    r1 = std::move(r);
    s0 = std::move(s1);
    s1 = std::move(s);
  }
  if (is_zero(r1))
    throw DomainError("no inverse modulo a polynomial: common factor " + to_string(r0));
  return scale(s1, inverse(r1.coeff(0)));
}

Poly compose(const Poly& f, const Poly& g) {
  Poly result(common_field(f.field(), g.field()));
  for (long i = degree(f); i >= 0; --i)
    result = result * g + Poly(f.coeff(i));
  return result;
}

Poly taylor_shift(const Poly& f, const NfElem& c) {
  if (f.stride() == 1 && c.field()->is_rational()) {
    Poly g(f.field());
    Poly line = Poly::z() + Poly(c);
    fmpq_poly_compose(g.raw(), f.raw(), line.raw());
    return g;
  }
  const long n = degree(f) + 1;
  if (n < 16) return compose(f, Poly::z() + Poly(c));
  // f = low + z^(n/2) high
  const long half = n / 2;
  return taylor_shift(truncate(f, half), c) +
         pow(Poly::z() + Poly(c), static_cast<unsigned long>(half)) *
             taylor_shift(shift_right(f, half), c);
}

NfElem evaluate(const Poly& f, const NfElem& c) {
  if (f.stride() == 1 && is_rational(c)) {
    const Rational at = c.coeff(0);
    Rational value;
    if (is_integer(at)) {
      Integer num;
      Integer den;
      _fmpz_poly_evaluate_fmpz(num.raw(), f.raw()->coeffs, f.raw()->length, at.num().raw());
      fmpz_set(den.raw(), f.raw()->den);
      value = Rational(num, den);
    } else {
      fmpq_poly_evaluate_fmpq(value.raw(), f.raw(), at.raw());
    }
    return {value, common_field(f.field(), c.field())};
  }
  NfElem value(common_field(f.field(), c.field()));
  for (long i = degree(f); i >= 0; --i)
    value = value * c + f.coeff(i);
  return value;
}

ComplexBall evaluate(const Poly& f, const ComplexBall& z, long bits) {
  ComplexBall value;
  for (long i = degree(f); i >= 0; --i) {
    acb_mul(value.raw(), value.raw(), z.raw(), bits);
    acb_add(value.raw(), value.raw(), embed(f.coeff(i), bits).raw(), bits);
  }
  return value;
}

std::optional<Poly> exact_sqrt(const Poly& f) {
  KOV_ENSURE(is_one(lead(f)));
  const long n = degree(f) / 2;
  if (degree(f) % 2 != 0) return std::nullopt;
  if (f.field()
          ->is_rational()) { // den f has leading coefficient den, so den * (den f) is the square
    fmpz_poly_t square;
    fmpz_poly_init(square);
    fmpq_poly_get_numerator(square, f.raw());
    fmpz_poly_scalar_mul_fmpz(square, square, fmpq_poly_denref(f.raw()));
    const int ok = fmpz_poly_sqrt(square, square);
    Poly root;
    if (ok != 0) fmpq_poly_set_fmpz_poly(root.raw(), square);
    fmpz_poly_clear(square);
    if (ok == 0) return std::nullopt;
    return monic(root);
  }
  // From the top: f_(2n-k) = 2 s_(n-k) + sum of products of known coefficients.
  std::vector<NfElem> s(static_cast<std::size_t>(n) + 1, NfElem(f.field()));
  s[static_cast<std::size_t>(n)] = NfElem(Rational(1), f.field());
  const NfElem half(Rational(1, 2));
  for (long k = 1; k <= n; ++k) {
    NfElem sum = f.coeff(2 * n - k);
    for (long i = 1; i < k; ++i)
      sum -= s[static_cast<std::size_t>(n - i)] * s[static_cast<std::size_t>(n - k + i)];
    s[static_cast<std::size_t>(n - k)] = sum * half;
  }
  const Poly root = Poly::from_coefficients(s);
  if (!(root * root == f)) return std::nullopt;
  return root;
}

namespace {

// "+ c z^i" for a rational number c that is not 0.
void append_term(std::string& s, std::string_view c, const std::string& power) {
  const bool negative = c.front() == '-';
  if (negative) c.remove_prefix(1);
  if (!s.empty())
    s += negative ? " - " : " + ";
  else if (negative)
    s += '-';
  if (power.empty() || c != "1") s += c;
  if (!power.empty() && c != "1") s += '*';
  s += power;
}

// The same for a constant of a number field.
void append_irrational_term(std::string& s, const NfElem& c, const std::string& power) {
  const std::string text = to_string(c);
  if (power.empty() && s.empty()) {
    s = text;
    return;
  }
  const bool sum = text.find(' ') != std::string::npos;
  const bool minus = !sum && text.front() == '-';
  if (!s.empty()) s += minus ? " - " : " + ";
  s += sum ? "(" + text + ")" : (minus && !s.empty() ? text.substr(1) : text);
  if (!power.empty()) s += "*" + power;
}

} // namespace

std::string to_string(const Poly& f, const std::string& variable) {
  if (is_zero(f)) return "0";
  const bool integral = f.stride() == 1 && fmpz_is_one(fmpq_poly_denref(f.raw()));
  std::string s;
  for (long i = degree(f); i >= 0; --i) {
    const std::string power = i == 0 ? "" : i == 1 ? variable : variable + "^" + std::to_string(i);
    if (integral) { // no canonical fraction has to be found
      const fmpz* c = f.raw()->coeffs + i;
      if (fmpz_is_zero(c)) continue;
      char* text = fmpz_get_str(nullptr, 10, c);
      append_term(s, text, power);
      flint_free(text);
      continue;
    }
    const NfElem c = f.coeff(i);
    if (is_zero(c)) continue;
    if (is_rational(c))
      append_term(s, to_string(to_rational(c)), power);
    else
      append_irrational_term(s, c, power);
  }
  return s;
}

int compare(const Poly& a, const Poly& b) {
  if (degree(a) != degree(b)) return degree(a) < degree(b) ? -1 : 1;
  return fmpq_poly_cmp(a.raw(), b.raw());
}

} // namespace kov
