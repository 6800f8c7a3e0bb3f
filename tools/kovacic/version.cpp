// kovacic --version: ours, and the libraries that the answer depends on.

#include "commands.hpp"
#include "exact/algebraic_c.h"
#include "exact/flint.hpp"

#include <cln/version.h>
#include <cstdio>
#include <ginac/version.h>
#include <mpfr.h>

namespace kov::cli {

int version() {
  std::printf(
      "kovacic %s\n"
      "GiNaC %d.%d.%d, CLN %d.%d.%d, FLINT %s, Arb %s, Antic %s, Calcium %s, GMP %s, MPFR %s\n"
      "License GPL-3.0-or-later\n",
      KOV_VERSION, GINACLIB_MAJOR_VERSION, GINACLIB_MINOR_VERSION, GINACLIB_MICRO_VERSION,
      CL_VERSION_MAJOR, CL_VERSION_MINOR, CL_VERSION_PATCHLEVEL, FLINT_VERSION, arb_version,
      ANTIC_VERSION, kov_calcium_version(), gmp_version, mpfr_get_version());
  return exit_decided;
}

} // namespace kov::cli
