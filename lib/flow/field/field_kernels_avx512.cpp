// The field stepper for one instruction set; lib/CMakeLists.txt gives this file its compiler flags.
#if defined(__x86_64__)
#define KOV_ISA avx512
#include "flow/field/field_kernel.inl"
#endif
