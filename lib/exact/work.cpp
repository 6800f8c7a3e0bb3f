#include "exact/work.hpp"

#include <algorithm>
#include <cstdio>

namespace kov {
namespace {

double size_of(const fmpz_mpoly_struct* f) noexcept {
  const auto bits = std::abs(static_cast<double>(fmpz_mpoly_max_bits(f)));
  return static_cast<double>(f->length) * std::max(1.0, bits / 64);
}

} // namespace

double size_of(const MPoly& f) noexcept { return f.ring() ? std::max(1.0, size_of(f.raw())) : 1; }

double size_of(const MFraction& f) noexcept {
  if (!f.ring()) return 1;
  return std::max({1.0, size_of(&f.raw()->num), size_of(&f.raw()->den)});
}

void Work::stop() const {
  throw OutOfBudget(std::string("work limit: ") + what_ + " would need more than " +
                    Budget::number(budget_.max_work) + " products of terms");
}

} // namespace kov
