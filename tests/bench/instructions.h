// Instructions counted by callgrind: exact and repeatable where the clock is too noisy.
#ifndef COPPICE_TESTS_BENCH_INSTRUCTIONS_H_
#define COPPICE_TESTS_BENCH_INSTRUCTIONS_H_

#include <optional>
#include <string>

namespace coppice::bench {

/// Instructions of one round of a case: this program (`program`) is run under callgrind twice, with
/// different numbers of rounds, and the difference is free of starting and loading. Nothing if
/// there is no valgrind.
std::optional<double> InstructionsPerRound(const std::string& program, const std::string& name);

/// What callgrind runs: the case of that name, `rounds` times. A workload is ticked; "script" runs
/// a compiled script 1000 times in each round. Returns the exit status.
int RunCase(const std::string& name, int rounds);

}  // namespace coppice::bench

#endif  // COPPICE_TESTS_BENCH_INSTRUCTIONS_H_
