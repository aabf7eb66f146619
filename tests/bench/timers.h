// What timers cost that are armed and wait.
#ifndef COPPICE_TESTS_BENCH_TIMERS_H_
#define COPPICE_TESTS_BENCH_TIMERS_H_

namespace coppice::bench {

struct TimerCost {
  int threads;         ///< that the tree has made
  double cpu_percent;  ///< of one core, of the whole program, while the tree waits
};

/// A running tree of so many Timeout nodes, observed for one second.
TimerCost ArmedTimers(int count);

}  // namespace coppice::bench

#endif  // COPPICE_TESTS_BENCH_TIMERS_H_
