#include "exact/number_field.hpp"

#include "exact/error.hpp"

namespace kov {

namespace {

bool is_irreducible(const fmpz_poly_struct* p) {
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  fmpz_poly_factor(factors, p);
  const bool one = factors->num == 1 && factors->exp[0] == 1;
  fmpz_poly_factor_clear(factors);
  return one;
}

// monic, irreducible, of degree >= 1
fmpz_poly_struct checked(const std::vector<Integer>& ascending) {
  if (ascending.size() < 2)
    throw InvalidArgument("a number field needs a minimal polynomial of degree >= 1");
  if (ascending.back() != Integer(1))
    throw InvalidArgument("the minimal polynomial of a field generator must be monic");
  fmpz_poly_struct m;
  fmpz_poly_init(&m);
  for (std::size_t i = 0; i < ascending.size(); ++i)
    fmpz_poly_set_coeff_fmpz(&m, static_cast<slong>(i), ascending[i].raw());
  if (is_irreducible(&m)) return m;
  fmpz_poly_clear(&m);
  throw InvalidArgument("the minimal polynomial of a field generator is reducible");
}

} // namespace

NumberField::NumberField(const std::vector<Integer>& minpoly, std::string letter, int root,
                         Integer scale)
    : degree_(static_cast<long>(minpoly.size()) - 1), letter_(std::move(letter)), root_(root),
      scale_(std::move(scale)), minpoly_{checked(minpoly)} {
  fmpq_poly_t m;
  fmpq_poly_init(m);
  fmpq_poly_set_fmpz_poly(m, minpoly_);
  nf_init(nf_, m);
  fmpq_poly_clear(m);
}

NumberField::~NumberField() {
  nf_clear(nf_);
  fmpz_poly_clear(minpoly_);
}

std::string NumberField::name() const {
  return scale_ == Integer(1) ? letter_ : "(" + to_string(scale_) + "*" + letter_ + ")";
}

std::vector<Integer> NumberField::minpoly_coefficients() const {
  std::vector<Integer> c(static_cast<std::size_t>(degree_) + 1);
  for (long i = 0; i <= degree_; ++i)
    fmpz_poly_get_coeff_fmpz(c[static_cast<std::size_t>(i)].raw(), minpoly_, i);
  return c;
}

ComplexBall NumberField::generator(long bits) const {
  // Arb sorts the roots deterministically once they are isolated, so the index means one root at
  // every precision.
  acb_ptr roots = _acb_vec_init(degree_);
  arb_fmpz_poly_complex_roots(roots, minpoly_, 0, bits + 16);
  ComplexBall r;
  acb_set(r.raw(), roots + root_);
  _acb_vec_clear(roots, degree_);
  return r;
}

const Field& rationals() {
  static const Field q = std::make_shared<const NumberField>(std::vector<Integer>{0, 1}, "", 0);
  return q;
}

Field make_field(const std::vector<Integer>& minpoly, std::string letter, int root, Integer scale) {
  return std::make_shared<const NumberField>(minpoly, std::move(letter), root, std::move(scale));
}

bool same_minimal_polynomial(const Field& a, const Field& b) {
  return a == b || fmpz_poly_equal(a->minpoly(), b->minpoly()) != 0;
}

const Field& common_field(const Field& a, const Field& b) {
  if (a == b || b->is_rational()) return a;
  if (a->is_rational()) return b;
  throw InvalidArgument("two different number fields, Q(" + a->name() + ") and Q(" + b->name() +
                        "), cannot be mixed");
}

void reduce_blocks(fmpz_poly_t flat, const NumberField& k) {
  const long d = k.degree();
  if (d == 1) return;
  const long stride = 2 * d - 1;
  const fmpz* m = k.minpoly()->coeffs;
  for (long start = 0; start < flat->length; start += stride) {
    const long top = std::min(stride, flat->length - start) - 1;
    for (long i = top; i >= d; --i) {
      fmpz* lead = flat->coeffs + start + i;
      if (fmpz_is_zero(lead)) continue;
      for (long j = 0; j < d; ++j)
        fmpz_submul(flat->coeffs + start + i - d + j, lead, m + j);
      fmpz_zero(lead);
    }
  }
  _fmpz_poly_normalise(flat);
}

namespace {

void reduce_element(NfElem& a) {
  const NumberField& k = *a.field();
  if (k.is_rational()) return;
  fmpz_poly_t flat;
  fmpz_poly_init(flat);
  fmpq_poly_get_numerator(flat, a.raw());
  reduce_blocks(flat, k);
  fmpq_poly_t reduced;
  fmpq_poly_init(reduced);
  fmpq_poly_set_fmpz_poly(reduced, flat);
  fmpq_poly_scalar_div_fmpz(reduced, reduced, fmpq_poly_denref(a.raw()));
  fmpq_poly_swap(a.raw(), reduced);
  fmpq_poly_clear(reduced);
  fmpz_poly_clear(flat);
}

} // namespace

NfElem NfElem::generator(const Field& k) {
  NfElem a(k);
  if (k->is_rational()) { // the root of m = x + m0
    const auto m = k->minpoly_coefficients();
    return {Rational(-m[0]), k};
  }
  fmpq_poly_set_coeff_si(a.v_, 1, 1);
  return a;
}

Rational NfElem::coeff(long i) const {
  Rational q;
  if (i == 0 && v_->length == 1) { // in lowest terms already
    fmpz_set(fmpq_numref(q.raw()), v_->coeffs);
    fmpz_set(fmpq_denref(q.raw()), v_->den);
    return q;
  }
  fmpq_poly_get_coeff_fmpq(q.raw(), v_, i);
  return q;
}

NfElem operator+(const NfElem& a, const NfElem& b) {
  NfElem c(common_field(a.k_, b.k_));
  fmpq_poly_add(c.v_, a.v_, b.v_);
  return c;
}

NfElem operator-(const NfElem& a, const NfElem& b) {
  NfElem c(common_field(a.k_, b.k_));
  fmpq_poly_sub(c.v_, a.v_, b.v_);
  return c;
}

NfElem operator*(const NfElem& a, const NfElem& b) {
  NfElem c(common_field(a.k_, b.k_));
  fmpq_poly_mul(c.v_, a.v_, b.v_);
  reduce_element(c);
  return c;
}

NfElem operator/(const NfElem& a, const NfElem& b) { return a * inverse(b); }

NfElem operator-(NfElem a) {
  fmpq_poly_neg(a.v_, a.v_);
  return a;
}

bool is_rational(const NfElem& a) { return fmpq_poly_degree(a.raw()) <= 0; }

Rational to_rational(const NfElem& a) {
  KOV_ENSURE(is_rational(a));
  return a.coeff(0);
}

NfElem inverse(const NfElem& a) {
  if (is_zero(a)) throw DomainError("division by zero in a number field");
  if (is_rational(a)) return {Rational(1) / a.coeff(0), a.field()};
  const nf_struct* k = a.field()->raw();
  nf_elem_t x;
  nf_elem_init(x, k);
  nf_elem_set_fmpq_poly(x, a.raw(), k);
  nf_elem_inv(x, x, k);
  NfElem r(a.field());
  nf_elem_get_fmpq_poly(r.raw(), x, k);
  nf_elem_clear(x, k);
  return r;
}

NfElem pow(const NfElem& a, unsigned long e) {
  NfElem result(Rational(1), a.field());
  NfElem base = a;
  for (; e != 0; e >>= 1) {
    if (e & 1) result *= base;
    if (e > 1) base *= base;
  }
  return result;
}

NfElem coerce(const NfElem& a, const Field& k) {
  if (a.field() == k) return a;
  KOV_ENSURE(is_rational(a));
  return {a.coeff(0), k};
}

ComplexBall embed(const NfElem& a, long bits) {
  ComplexBall z;
  if (is_rational(a)) {
    arb_set_fmpq(acb_realref(z.raw()), a.coeff(0).raw(), bits);
    return z;
  }
  const ComplexBall g = a.field()->generator(bits);
  acb_zero(z.raw());
  for (long i = fmpq_poly_degree(a.raw()); i >= 0; --i) {
    acb_mul(z.raw(), z.raw(), g.raw(), bits + 16);
    arb_t c;
    arb_init(c);
    arb_set_fmpq(c, a.coeff(i).raw(), bits + 16);
    acb_add_arb(z.raw(), z.raw(), c, bits + 16);
    arb_clear(c);
  }
  return z;
}

std::vector<Rational> shown_coefficients(const NfElem& a) {
  std::vector<Rational> all;
  Rational power(1);
  for (long i = 0; i <= fmpq_poly_degree(a.raw()); ++i, power *= Rational(a.field()->scale()))
    all.push_back(a.coeff(i) * power);
  return all;
}

std::string to_string(const NfElem& a) {
  if (is_zero(a)) return "0";
  const std::vector<Rational> shown = shown_coefficients(a);
  std::string s;
  for (long i = static_cast<long>(shown.size()) - 1; i >= 0; --i) {
    const Rational& c = shown[static_cast<std::size_t>(i)];
    if (is_zero(c)) continue;
    const bool negative = sign(c) < 0;
    const Rational size = abs(c);
    if (!s.empty())
      s += negative ? " - " : " + ";
    else if (negative)
      s += "-";
    if (i == 0) {
      s += to_string(size);
      continue;
    }
    if (size != Rational(1)) s += to_string(size) + "*";
    s += a.field()->letter();
    if (i > 1) s += "^" + std::to_string(i);
  }
  return s;
}

} // namespace kov
