/* Calcium's fmpz_mpoly_q behind plain C declarations: calcium.h assigns void* without a cast and so
 * does not compile as C++.  The struct has the layout of fmpz_mpoly_q_struct (checked in the .c
 * file). */
#ifndef KOV_MULTIVARIATE_C_H
#define KOV_MULTIVARIATE_C_H

#include <gmp.h>

#include <flint/flint.h>

#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_mpoly_factor.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
  fmpz_mpoly_struct num;
  fmpz_mpoly_struct den;
} kov_mpoly_q;

void kov_mpoly_q_init(kov_mpoly_q* x, const fmpz_mpoly_ctx_t ctx);
void kov_mpoly_q_clear(kov_mpoly_q* x, const fmpz_mpoly_ctx_t ctx);
void kov_mpoly_q_set(kov_mpoly_q* r, const kov_mpoly_q* x, const fmpz_mpoly_ctx_t ctx);
void kov_mpoly_q_canonicalise(kov_mpoly_q* x, const fmpz_mpoly_ctx_t ctx);
void kov_mpoly_q_neg(kov_mpoly_q* r, const kov_mpoly_q* a, const fmpz_mpoly_ctx_t ctx);
void kov_mpoly_q_add(kov_mpoly_q* r, const kov_mpoly_q* a, const kov_mpoly_q* b,
                     const fmpz_mpoly_ctx_t ctx);
void kov_mpoly_q_sub(kov_mpoly_q* r, const kov_mpoly_q* a, const kov_mpoly_q* b,
                     const fmpz_mpoly_ctx_t ctx);
void kov_mpoly_q_mul(kov_mpoly_q* r, const kov_mpoly_q* a, const kov_mpoly_q* b,
                     const fmpz_mpoly_ctx_t ctx);
/* Requires b != 0. */
void kov_mpoly_q_div(kov_mpoly_q* r, const kov_mpoly_q* a, const kov_mpoly_q* b,
                     const fmpz_mpoly_ctx_t ctx);

#ifdef __cplusplus
}
#endif

#endif
