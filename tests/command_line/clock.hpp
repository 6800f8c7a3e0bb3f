#pragma once
// The seam for limits of time: in a worker process (never in the test's own) the clock can be made to
// jump beyond every deadline at its k-th reading, and each call of Budget::check with a deadline reads
// it once.

namespace kov::test {

/// In the processes that begin from now on the clock jumps at the k-th reading; 0: it does not.
void clock_jumps_at(long k);
/// How often such a process has read the clock since the last clock_jumps_at.
[[nodiscard]] long clock_readings();

} // namespace kov::test
