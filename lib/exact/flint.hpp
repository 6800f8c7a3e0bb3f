#pragma once
// The one place that includes FLINT 2.9, Arb and Antic; a move to FLINT 3 changes this file only.
// Calcium's headers do not compile as C++ (they assign void* without a cast): see algebraic_c.h.

#include <gmp.h>

#include <flint/flint.h>

#include <flint/fmpq.h>
#include <flint/fmpq_mat.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpz.h>
#include <flint/fmpz_mat.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>
#include <flint/nmod_mat.h>
#include <flint/nmod_poly.h>
#include <flint/nmod_poly_factor.h>
#include <flint/nmod_vec.h>
#include <flint/ulong_extras.h>

#include <antic/nf.h>
#include <antic/nf_elem.h>

#include <acb.h>
#include <acb_poly.h>
#include <arb.h>
#include <arb_fmpz_poly.h>
