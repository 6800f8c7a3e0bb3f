#include "exact/algebraic_c.h"

#include <calcium/qqbar.h>

#include <stdlib.h>

struct kov_qqbar_struct {
  qqbar_t v;
};

const char* kov_calcium_version(void) { return calcium_version(); }

kov_qqbar* kov_qqbar_new(void) {
  kov_qqbar* x = flint_malloc(sizeof(kov_qqbar));
  qqbar_init(x->v);
  return x;
}

kov_qqbar* kov_qqbar_copy(const kov_qqbar* x) {
  kov_qqbar* y = kov_qqbar_new();
  qqbar_set(y->v, x->v);
  return y;
}

void kov_qqbar_free(kov_qqbar* x) {
  if (x == NULL) return;
  qqbar_clear(x->v);
  flint_free(x);
}

void kov_qqbar_set_fmpq(kov_qqbar* x, const fmpq_t q) { qqbar_set_fmpq(x->v, q); }
void kov_qqbar_set_i(kov_qqbar* x) { qqbar_i(x->v); }

void kov_qqbar_roots(kov_qqbar** roots, const fmpz_poly_t f) {
  const slong n = fmpz_poly_degree(f);
  qqbar_ptr r = _qqbar_vec_init(n);
  qqbar_roots_fmpz_poly(r, f, 0);
  for (slong i = 0; i < n; ++i) {
    roots[i] = kov_qqbar_new();
    qqbar_swap(roots[i]->v, r + i);
  }
  _qqbar_vec_clear(r, n);
}

void kov_qqbar_evaluate(kov_qqbar* y, const fmpq_poly_t c, const kov_qqbar* x) {
  qqbar_evaluate_fmpq_poly(y->v, c, x->v);
}

void kov_qqbar_add(kov_qqbar* z, const kov_qqbar* x, const kov_qqbar* y) {
  qqbar_add(z->v, x->v, y->v);
}
void kov_qqbar_mul(kov_qqbar* z, const kov_qqbar* x, const kov_qqbar* y) {
  qqbar_mul(z->v, x->v, y->v);
}
void kov_qqbar_mul_fmpz(kov_qqbar* z, const kov_qqbar* x, const fmpz_t n) {
  qqbar_mul_fmpz(z->v, x->v, n);
}
void kov_qqbar_root(kov_qqbar* y, const kov_qqbar* x, unsigned long n) {
  qqbar_root_ui(y->v, x->v, n);
}
int kov_qqbar_equal(const kov_qqbar* x, const kov_qqbar* y) { return qqbar_equal(x->v, y->v); }

const fmpz_poly_struct* kov_qqbar_minpoly(const kov_qqbar* x) { return QQBAR_POLY(x->v); }
void kov_qqbar_enclosure(acb_t z, const kov_qqbar* x, long bits) { qqbar_get_acb(z, x->v, bits); }
