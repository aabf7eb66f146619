// What is measured in exact figures, and how much each may cost.
#ifndef COPPICE_TESTS_BENCH_WORKLOADS_H_
#define COPPICE_TESTS_BENCH_WORKLOADS_H_

#include <string>
#include <vector>

namespace coppice::bench {

/// A tree whose steady ticks are counted.
struct Workload {
  std::string name;
  std::string unit;  ///< "node", "access", "tick"
  double per_tick;   ///< so many of the unit in one tick
  double limit;      ///< instructions per unit; 0: no limit
  double peer;       ///< of BehaviorTree.CPP 4.10.0 where it is not installed; 0: not known
  std::string text;
  int sinks = 0;         ///< watchers that look at nothing
  bool streams = false;  ///< with an EventStream and a listener that looks at nothing
};

const std::vector<Workload>& Workloads();

/// The one of that name; throws std::invalid_argument if there is none.
const Workload& FindWorkload(const std::string& name);

}  // namespace coppice::bench

#endif  // COPPICE_TESTS_BENCH_WORKLOADS_H_
