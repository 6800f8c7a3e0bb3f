// The field stepper for any processor.
#define KOV_ISA baseline
#include "flow/field/field_kernel.inl"
