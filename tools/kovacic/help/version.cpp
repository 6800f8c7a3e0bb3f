// kovacic --version: the version of kovacic and of its libraries that the answer depends on.

#include "commands.hpp"
#include "exact/algebraic_c.h"
#include "exact/flint.hpp"

#include <cln/version.h>
#include <cstdio>
#include <fmt/format.h>
#include <ginac/version.h>
#include <mpfr.h>

namespace kov::cli {

std::string libraries() {
  return fmt::format(
      "GiNaC {}.{}.{}, CLN {}.{}.{}, FLINT {}, Arb {}, Antic {}, Calcium {}, GMP {}, MPFR {}",
      GINACLIB_MAJOR_VERSION, GINACLIB_MINOR_VERSION, GINACLIB_MICRO_VERSION, CL_VERSION_MAJOR,
      CL_VERSION_MINOR, CL_VERSION_PATCHLEVEL, FLINT_VERSION, arb_version, ANTIC_VERSION,
      kov_calcium_version(), gmp_version, mpfr_get_version());
}

std::string program_version() { return std::string("kovacic ") + KOV_VERSION; }

int version() {
  std::printf("%s\n%s\nLicense GPL-3.0-or-later\n", program_version().c_str(), libraries().c_str());
  return exit_decided;
}

} // namespace kov::cli
