// The double kernels for one instruction set; lib/CMakeLists.txt gives this file its compiler flags.
#if defined(__x86_64__)
#define KOV_ISA avx512
#include "flow/orbit/kernel_double.inl"
#endif
