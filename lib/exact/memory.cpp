#include "exact/memory.hpp"

#include "exact/flint.hpp"
#include "exact/meter.hpp"

#include <array>
#include <cstdlib>
#include <cstring>
#include <malloc.h>
#include <new>

namespace kov {

constinit thread_local double meter_reading = 0;

namespace {

void* checked(void* p) {
  if (p == nullptr) {
    if (const auto handler = std::get_new_handler()) handler();
    std::abort();
  }
  return p;
}

// Small pieces that were given back, by their size: polynomials live for a moment, and the lists that
// malloc keeps for this purpose are too short for them.
class SmallPieces {
public:
  static constexpr std::size_t largest = 256;

  void* take(std::size_t n) {
    const std::size_t k = (n + unit - 1) / unit;
    if (const Piece piece = lists_[k].first; piece != nullptr) {
      std::memcpy(&lists_[k].first, piece, sizeof piece); // a piece begins with its successor
      --lists_[k].length;
      return piece;
    }
    return std::malloc(k * unit);
  }
  void give(void* piece) {
    const std::size_t k = ::malloc_usable_size(piece) / unit;
    if (k == 0 || k > largest / unit || lists_[k].length == longest) return std::free(piece);
    std::memcpy(piece, &lists_[k].first, sizeof piece);
    lists_[k].first = piece;
    ++lists_[k].length;
  }

private:
  using Piece = void*;
  struct List {
    Piece first = nullptr;
    std::size_t length = 0;
  };
  static constexpr std::size_t unit = 16;
#ifdef __SANITIZE_ADDRESS__ // sees what is used after it was given back
  static constexpr std::size_t longest = 0;
#else
  static constexpr std::size_t longest = 256;
#endif
  std::array<List, largest / unit + 1> lists_{};
};
thread_local SmallPieces small_pieces;

// Measured (docs/theory/work.md).
constexpr double units_per_piece = 1;
constexpr double units_per_byte = 3.0 / 64; // sums of such fractions are exact

void count(std::size_t n) { charge(units_per_piece + units_per_byte * static_cast<double>(n)); }

void* counted(std::size_t n) {
  count(n);
  return allocate(n);
}
void* counted_zeros(std::size_t n, std::size_t size) {
  constexpr std::size_t is_small = SmallPieces::largest;
  if (n <= is_small && size <= is_small && n * size <= is_small)
    return std::memset(counted(n * size), 0, n * size);
  count(n * size);
  return checked(std::calloc(n == 0 ? 1 : n, size == 0 ? 1 : size));
}
void* counted_again(void* p, std::size_t n) {
  count(n);
  return reallocate(p, n);
}

[[maybe_unused]] const bool is_set =
    (__flint_set_memory_functions(counted, counted_zeros, counted_again, release), true);

} // namespace

void* allocate(std::size_t n) {
  return checked(n > 0 && n <= SmallPieces::largest ? small_pieces.take(n)
                                                    : std::malloc(n == 0 ? 1 : n));
}
void* reallocate(void* p, std::size_t n) { return checked(std::realloc(p, n == 0 ? 1 : n)); }
void release(void* p) {
  if (p != nullptr) small_pieces.give(p);
}

} // namespace kov
