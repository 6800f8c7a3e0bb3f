#include "exact/multivariate_c.h"

#include <calcium/fmpz_mpoly_q.h>

#include <stddef.h>

_Static_assert(sizeof(kov_mpoly_q) == sizeof(fmpz_mpoly_q_struct), "layout of fmpz_mpoly_q");
_Static_assert(offsetof(kov_mpoly_q, den) == offsetof(fmpz_mpoly_q_struct, den),
               "layout of fmpz_mpoly_q");

#define Q(x) ((fmpz_mpoly_q_struct*)(x))

void kov_mpoly_q_init(kov_mpoly_q* x, const fmpz_mpoly_ctx_t ctx) { fmpz_mpoly_q_init(Q(x), ctx); }
void kov_mpoly_q_clear(kov_mpoly_q* x, const fmpz_mpoly_ctx_t ctx) {
  fmpz_mpoly_q_clear(Q(x), ctx);
}
void kov_mpoly_q_set(kov_mpoly_q* r, const kov_mpoly_q* x, const fmpz_mpoly_ctx_t ctx) {
  fmpz_mpoly_q_set(Q(r), Q(x), ctx);
}
void kov_mpoly_q_canonicalise(kov_mpoly_q* x, const fmpz_mpoly_ctx_t ctx) {
  fmpz_mpoly_q_canonicalise(Q(x), ctx);
}
void kov_mpoly_q_neg(kov_mpoly_q* r, const kov_mpoly_q* a, const fmpz_mpoly_ctx_t ctx) {
  fmpz_mpoly_q_neg(Q(r), Q(a), ctx);
}
void kov_mpoly_q_add(kov_mpoly_q* r, const kov_mpoly_q* a, const kov_mpoly_q* b,
                     const fmpz_mpoly_ctx_t ctx) {
  fmpz_mpoly_q_add(Q(r), Q(a), Q(b), ctx);
}
void kov_mpoly_q_sub(kov_mpoly_q* r, const kov_mpoly_q* a, const kov_mpoly_q* b,
                     const fmpz_mpoly_ctx_t ctx) {
  fmpz_mpoly_q_sub(Q(r), Q(a), Q(b), ctx);
}
void kov_mpoly_q_mul(kov_mpoly_q* r, const kov_mpoly_q* a, const kov_mpoly_q* b,
                     const fmpz_mpoly_ctx_t ctx) {
  fmpz_mpoly_q_mul(Q(r), Q(a), Q(b), ctx);
}
void kov_mpoly_q_div(kov_mpoly_q* r, const kov_mpoly_q* a, const kov_mpoly_q* b,
                     const fmpz_mpoly_ctx_t ctx) {
  fmpz_mpoly_q_div(Q(r), Q(a), Q(b), ctx);
}
