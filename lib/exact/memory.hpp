#pragma once
// Memory for FLINT, which lives on small pieces that it gives back at once.  Where there is none the
// handler of operator new is called, and else the program ends.

#include <cstddef>

namespace kov {

[[nodiscard]] void* allocate(std::size_t n);
[[nodiscard]] void* reallocate(void* p, std::size_t n);
void release(void* p); ///< from one of these, or from malloc

} // namespace kov
