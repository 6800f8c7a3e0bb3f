# FLINT 2.9 with Arb, Antic and Calcium, as Debian 12 ships them: four libraries, no .pc file.
# With FLINT 3 the four are one library; lib/exact/flint.hpp is the only header that would change.
find_path(FLINT_INCLUDE_DIR flint/flint.h)
find_library(FLINT_LIBRARY flint)
find_library(ARB_LIBRARY NAMES flint-arb arb)
find_library(ANTIC_LIBRARY antic)
find_library(CALCIUM_LIBRARY calcium)
find_library(MPFR_LIBRARY mpfr)
find_library(GMP_LIBRARY gmp)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Flint REQUIRED_VARS FLINT_LIBRARY ARB_LIBRARY ANTIC_LIBRARY
                                  CALCIUM_LIBRARY MPFR_LIBRARY GMP_LIBRARY FLINT_INCLUDE_DIR)
if(Flint_FOUND AND NOT TARGET flint::flint)
  add_library(flint::flint INTERFACE IMPORTED)
  target_include_directories(flint::flint SYSTEM INTERFACE ${FLINT_INCLUDE_DIR})
  target_link_libraries(flint::flint INTERFACE ${CALCIUM_LIBRARY} ${ANTIC_LIBRARY} ${ARB_LIBRARY}
                        ${FLINT_LIBRARY} ${MPFR_LIBRARY} ${GMP_LIBRARY})
endif()
