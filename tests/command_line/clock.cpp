#include "clock.hpp"

#include <atomic>
#include <ctime>
#include <new>

#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

constexpr long a_year = 366L * 24 * 3600;

// Shared with the children.
struct Shared {
  std::atomic<long> jump_at{0}, readings{0};
  pid_t owner = ::getpid();
};

Shared* shared = [] {
  void* memory =
      ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  return memory == MAP_FAILED ? nullptr : new (memory) Shared;
}();

} // namespace

// In place of the one of the C library, which std::chrono::steady_clock asks.
extern "C" int clock_gettime(clockid_t clock, timespec* now) noexcept {
  const auto result = static_cast<int>(::syscall(SYS_clock_gettime, clock, now));
  if (clock != CLOCK_MONOTONIC || shared == nullptr || ::getpid() == shared->owner) return result;
  const long k = ++shared->readings;
  if (const long jump = shared->jump_at; jump > 0 && k >= jump) now->tv_sec += a_year;
  return result;
}

namespace kov::test {

void clock_jumps_at(long k) {
  shared->jump_at = k;
  shared->readings = 0;
}

long clock_readings() { return shared->readings; }

} // namespace kov::test
