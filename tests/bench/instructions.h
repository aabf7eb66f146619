// Instructions counted by callgrind: exact and repeatable where the clock is too noisy.
#ifndef COPPICE_TESTS_BENCH_INSTRUCTIONS_H_
#define COPPICE_TESTS_BENCH_INSTRUCTIONS_H_

#include <optional>
#include <string>

#include "tests/bench/workloads.h"

namespace coppice::bench {

/// Instructions of one round of a case: this program (`program`) is run under callgrind twice, with
/// different numbers of rounds, and the difference is free of starting and loading. Nothing if
/// there is no valgrind.
std::optional<double> InstructionsPerRound(const std::string& program, const std::string& name);

/// The same of the peer: of coppice_peer_bench, which lies beside this program if the peer was
/// installed when it was built. Nothing if it was not, or if the peer cannot run the tree.
std::optional<double> PeerInstructionsPerRound(const std::string& program,
                                               const Workload& workload);

/// What callgrind runs: the case of that name, `rounds` times. A workload is ticked; "script" runs
/// a compiled script 1000 times in each round; a WatchedCase is ticked and followed. Returns the
/// exit status.
int RunCase(const std::string& name, int rounds);

}  // namespace coppice::bench

#endif  // COPPICE_TESTS_BENCH_INSTRUCTIONS_H_
