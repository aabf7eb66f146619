// Exact and repeatable figures where the clock is too noisy: instructions counted by callgrind, and
// bytes of memory.
#ifndef COPPICE_TESTS_BENCH_COUNTS_H_
#define COPPICE_TESTS_BENCH_COUNTS_H_

#include <string>

namespace coppice::bench {

/// Runs this program under callgrind for every case and prints instructions per node or access,
/// then bytes per node. Returns the exit status.
int PrintCounts(const std::string& program);

/// One case, `rounds` times. The difference of two runs is free of starting and loading.
int RunCase(const std::string& name, int rounds);

}  // namespace coppice::bench

#endif  // COPPICE_TESTS_BENCH_COUNTS_H_
