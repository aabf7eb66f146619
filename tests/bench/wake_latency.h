// How soon a sleeping tree ticks after a message.
#ifndef COPPICE_TESTS_BENCH_WAKE_LATENCY_H_
#define COPPICE_TESTS_BENCH_WAKE_LATENCY_H_

#include <cstdint>
#include <vector>

#include "bt_core/base/clock.h"

namespace coppice::bench {

/// From just before a post in one thread to the start of the tick in the other, which slept
/// without a timer; sorted. Before each post the poster waits a random time of up to `gap`. The
/// number of results is less than `posts` if a wake-up was lost.
std::vector<Duration> WakeLatencies(int posts, Duration gap);

/// Posts that never reached the tree, of so many from four threads as fast as they can.
std::uint64_t LostPosts(std::uint64_t posts);

}  // namespace coppice::bench

#endif  // COPPICE_TESTS_BENCH_WAKE_LATENCY_H_
