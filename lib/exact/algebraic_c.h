#pragma once
/* A C face for Calcium's qqbar, whose headers do not compile as C++ (they assign void * without a
   cast).  Only algebraic.cpp includes this; everything else uses the class QQbar. */

#include <flint/fmpq_poly.h>
#include <flint/fmpz_poly.h>

#include <acb.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct kov_qqbar_struct kov_qqbar;

const char* kov_calcium_version(void);

kov_qqbar* kov_qqbar_new(void); /* the number 0 */
kov_qqbar* kov_qqbar_copy(const kov_qqbar* x);
void kov_qqbar_free(kov_qqbar* x);

void kov_qqbar_set_fmpq(kov_qqbar* x, const fmpq_t q);
void kov_qqbar_set_i(kov_qqbar* x);
/* The roots of a polynomial, with multiplicity: deg f numbers.  Real ones first, descending. */
void kov_qqbar_roots(kov_qqbar** roots, const fmpz_poly_t f);
/* c[0] + c[1] x + ... */
void kov_qqbar_evaluate(kov_qqbar* y, const fmpq_poly_t c, const kov_qqbar* x);

void kov_qqbar_add(kov_qqbar* z, const kov_qqbar* x, const kov_qqbar* y);
void kov_qqbar_mul(kov_qqbar* z, const kov_qqbar* x, const kov_qqbar* y);
void kov_qqbar_mul_fmpz(kov_qqbar* z, const kov_qqbar* x, const fmpz_t n);
void kov_qqbar_root(kov_qqbar* y, const kov_qqbar* x, unsigned long n); /* principal */
int kov_qqbar_equal(const kov_qqbar* x, const kov_qqbar* y);

const fmpz_poly_struct* kov_qqbar_minpoly(const kov_qqbar* x); /* primitive, positive lead */
void kov_qqbar_enclosure(acb_t z, const kov_qqbar* x, long bits);

#ifdef __cplusplus
}
#endif
