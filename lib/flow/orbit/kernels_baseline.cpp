// The double kernels for one instruction set; lib/CMakeLists.txt gives this file its compiler flags.
#define KOV_ISA baseline
#include "flow/orbit/kernel_double.inl"
