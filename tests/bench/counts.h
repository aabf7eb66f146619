// The table of `coppice_bench --counts`.
#ifndef COPPICE_TESTS_BENCH_COUNTS_H_
#define COPPICE_TESTS_BENCH_COUNTS_H_

#include <string>

namespace coppice::bench {

/// Measures instructions, allocations, bytes, loading, wake-up and timers, and prints each beside
/// its limit. `program` is this program's path. Returns the exit status: 1 if a limit is exceeded.
int PrintCounts(const std::string& program);

}  // namespace coppice::bench

#endif  // COPPICE_TESTS_BENCH_COUNTS_H_
