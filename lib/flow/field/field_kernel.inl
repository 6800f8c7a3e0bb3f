// Included by field_kernels_<isa>.cpp, which defines KOV_ISA.
#include "flow/field/field_stepper.hpp"

#include <cstdlib>
#include <new>

namespace kov::flow {
namespace entry {

#define KOV_JOIN2(a, b) a##b
#define KOV_JOIN(a, b) KOV_JOIN2(a, b)

template <class T, class R>
static void integrate_as(const FieldTapes<R>& tapes, const FieldRun<R>& run) {
  // Not std::vector: its members would be shared by the linker between instruction sets.
  std::size_t bytes = FieldStepper<T>::storage_size(tapes) * sizeof(T);
  bytes = (bytes + 63) / 64 * 64;
  T* storage = static_cast<T*>(std::aligned_alloc(64, bytes));
  if (storage == nullptr) throw std::bad_alloc();
  std::memset(static_cast<void*>(storage), 0, bytes);
  FieldStepper<T> stepper(tapes, run, storage);
  stepper.integrate();
  std::free(storage);
}

void KOV_JOIN(integrate_field_, KOV_ISA)(int lanes, const FieldTapes<double>& tapes,
                                         const FieldRun<double>& run) {
  if (lanes <= 1)
    integrate_as<double>(tapes, run);
  else if (lanes <= 4)
    integrate_as<Pack4>(tapes, run);
  else
    integrate_as<Pack8>(tapes, run);
}

void KOV_JOIN(integrate_field_, KOV_ISA)(const FieldTapes<Twin1>& tapes,
                                         const FieldRun<Twin1>& run) {
  // one pack only: twins are for references, and slow to compile
#if defined(__AVX512F__)
  integrate_as<Twin<Pack8>>(tapes, run);
#elif defined(__FMA__)
  integrate_as<Twin<Pack4>>(tapes, run);
#else
  integrate_as<Twin<double>>(tapes, run);
#endif
}

} // namespace entry
} // namespace kov::flow
