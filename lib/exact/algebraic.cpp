#include "exact/algebraic.hpp"

#include "exact/algebraic_c.h"
#include "exact/error.hpp"

namespace kov {

void QQbar::Free::operator()(kov_qqbar_struct* x) const noexcept { kov_qqbar_free(x); }

QQbar::QQbar() : v_(kov_qqbar_new()) {}
QQbar::QQbar(const Rational& q) : QQbar() { kov_qqbar_set_fmpq(v_.get(), q.raw()); }
QQbar::QQbar(const QQbar& o) : v_(kov_qqbar_copy(o.v_.get())) {}

QQbar QQbar::i() {
  QQbar a;
  kov_qqbar_set_i(a.v_.get());
  return a;
}

QQbar operator+(const QQbar& a, const QQbar& b) {
  QQbar c;
  kov_qqbar_add(c.v_.get(), a.v_.get(), b.v_.get());
  return c;
}

QQbar operator*(const QQbar& a, const QQbar& b) {
  QQbar c;
  kov_qqbar_mul(c.v_.get(), a.v_.get(), b.v_.get());
  return c;
}

QQbar operator*(const Integer& n, const QQbar& a) {
  QQbar c;
  kov_qqbar_mul_fmpz(c.v_.get(), a.v_.get(), n.raw());
  return c;
}

bool operator==(const QQbar& a, const QQbar& b) {
  return kov_qqbar_equal(a.v_.get(), b.v_.get()) != 0;
}

std::vector<Integer> minimal_polynomial(const QQbar& a) {
  const fmpz_poly_struct* f = kov_qqbar_minpoly(a.raw());
  std::vector<Integer> c;
  for (long i = 0; i < f->length; ++i)
    c.emplace_back(f->coeffs + i);
  return c;
}

long degree(const QQbar& a) { return fmpz_poly_degree(kov_qqbar_minpoly(a.raw())); }

ComplexBall enclosure(const QQbar& a, long bits) {
  ComplexBall z;
  kov_qqbar_enclosure(z.raw(), a.raw(), bits);
  return z;
}

std::vector<QQbar> roots(const std::vector<Integer>& f) {
  fmpz_poly_t g;
  fmpz_poly_init(g);
  for (std::size_t i = 0; i < f.size(); ++i)
    fmpz_poly_set_coeff_fmpz(g, static_cast<slong>(i), f[i].raw());
  std::vector<kov_qqbar*> raw(static_cast<std::size_t>(std::max(0L, fmpz_poly_degree(g))));
  if (!raw.empty()) kov_qqbar_roots(raw.data(), g);
  fmpz_poly_clear(g);
  std::vector<QQbar> result(raw.size());
  for (std::size_t i = 0; i < raw.size(); ++i)
    result[i].v_.reset(raw[i]);
  return result;
}

QQbar principal_root(const QQbar& a, unsigned long n) {
  QQbar b;
  kov_qqbar_root(b.v_.get(), a.v_.get(), n);
  return b;
}

QQbar evaluate(const fmpq_poly_struct* f, const QQbar& a) {
  QQbar b;
  kov_qqbar_evaluate(b.v_.get(), f, a.v_.get());
  return b;
}

// w x^2 + b x + c = 0:  2w x + b = +-sqrt(b^2 - 4wc), the sign read off an enclosure.
// (Calcium 0.4.1 has qqbar_get_quadratic, which loses the sign of the radicand of I.)
Quadratic quadratic_parts(const QQbar& a) {
  KOV_ENSURE(degree(a) == 2);
  const std::vector<Integer> m = minimal_polynomial(a);
  const auto [s, n] = square_part(m[1] * m[1] - Integer(4) * m[2] * m[0]);
  Quadratic q{.u = -m[1], .v = s, .w = Integer(2) * m[2], .n = n};
  const QQbar root = q.w * a + QQbar(Rational(m[1]));
  for (long bits = 64;; bits *= 2) {
    const ComplexBall z = enclosure(root, bits);
    const arb_struct* part = sign(n) > 0 ? acb_realref(z.raw()) : acb_imagref(z.raw());
    if (arb_contains_zero(part)) continue;
    if (arb_is_negative(part)) q.v = -q.v;
    return q;
  }
}

Field field_of(const QQbar& a, std::string letter, Integer scale) {
  const std::vector<Integer> m = minimal_polynomial(a);
  if (m.back() != Integer(1))
    throw InvalidArgument("the generator of a number field must be an algebraic integer");
  const int n = static_cast<int>(m.size()) - 1;
  if (n == 1) return rationals();
  // Arb's list of roots is the same at every precision, and the roots are isolated: exactly one
  // index survives once the balls are small enough.
  const Field k = make_field(m, letter);
  for (long bits = 64; bits < (1L << 20); bits *= 2) {
    const ComplexBall chosen = enclosure(a, bits);
    acb_ptr all = _acb_vec_init(n);
    arb_fmpz_poly_complex_roots(all, k->minpoly(), 0, bits + 16);
    int found = -1;
    int count = 0;
    for (int i = 0; i < n; ++i)
      if (acb_overlaps(all + i, chosen.raw())) {
        found = i;
        ++count;
      }
    _acb_vec_clear(all, n);
    if (count == 1) return make_field(m, std::move(letter), found, std::move(scale));
  }
  throw InternalError("the roots of a minimal polynomial could not be separated");
}

bool equals(const NfElem& x, const QQbar& a) {
  // x is a root of the minimal polynomial of a, and the right one of its roots
  const std::vector<Integer> m = minimal_polynomial(a);
  NfElem value(x.field());
  for (std::size_t i = m.size(); i-- > 0;)
    value = value * x + NfElem(Rational(m[i]));
  if (!is_zero(value)) return false;
  if (m.size() == 2) return true;
  const std::vector<QQbar> conjugates = roots(m);
  for (long bits = 64; bits < (1L << 20); bits *= 2) {
    const ComplexBall left = embed(x, bits);
    if (!acb_overlaps(left.raw(), enclosure(a, bits).raw())) return false;
    long near = 0;
    for (const QQbar& root : conjugates)
      near += acb_overlaps(left.raw(), enclosure(root, bits).raw()) != 0;
    if (near == 1) return true;
  }
  throw InternalError("the roots of a minimal polynomial could not be separated");
}

} // namespace kov
