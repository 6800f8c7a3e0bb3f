#pragma once
// Arb's matrices of balls, for the one room that uses them (the rest of FLINT: exact/flint.hpp).

#include "exact/flint.hpp"

#include <acb_mat.h>
