// Included by kernels_<isa>.cpp, which defines KOV_ISA.
#include "flow/orbit/kernel_table.hpp"

#include <cstdlib>
#include <new>

namespace kov::flow {
namespace entry {

#define KOV_JOIN2(a, b) a##b
#define KOV_JOIN(a, b) KOV_JOIN2(a, b)

template <class T, class R>
static void with_storage(std::size_t set, const Model<R>& model, bool sliding, const Run<R>& run) {
  // Not std::vector: its members would be shared by the linker between instruction sets.
  std::size_t bytes = storage_size<T>(run.order) * sizeof(T);
  bytes = (bytes + 63) / 64 * 64;
  T* storage = static_cast<T*>(std::aligned_alloc(64, bytes));
  if (storage == nullptr) throw std::bad_alloc();
  std::memset(static_cast<void*>(storage), 0, bytes);
  integrate_with<T>(set, model, sliding, run, storage);
  std::free(storage);
}

void KOV_JOIN(integrate_, KOV_ISA)(std::size_t set, int lanes, const Model<double>& model,
                                   bool sliding, const Run<double>& run) {
  if (lanes <= 1)
    with_storage<double>(set, model, sliding, run);
  else if (lanes <= 4)
    with_storage<Pack4>(set, model, sliding, run);
  else
    with_storage<Pack8>(set, model, sliding, run);
}

void KOV_JOIN(integrate_, KOV_ISA)(std::size_t set, int lanes, const Model<Twin1>& model,
                                   bool sliding, const Run<Twin1>& run) {
  static_cast<void>(lanes); // one pack only: twins are for references, and slow to compile
#if defined(__AVX512F__)
  with_storage<Twin<Pack8>>(set, model, sliding, run);
#elif defined(__FMA__)
  with_storage<Twin<Pack4>>(set, model, sliding, run);
#else
  with_storage<Twin<double>>(set, model, sliding, run);
#endif
}

} // namespace entry
} // namespace kov::flow
