// Trees with somebody who follows every event of them, on threads of his own.
#ifndef COPPICE_TESTS_BENCH_WATCHED_H_
#define COPPICE_TESTS_BENCH_WATCHED_H_

#include <string>
#include <vector>

namespace coppice::bench {

enum class Watcher { kNobody, kRecorder, kLiveView };

/// A full tree of 1 000 nodes that is ticked 100 times in a round. Nobody is connected to the live
/// view.
struct WatchedCase {
  std::string name;
  Watcher watcher;
  bool leaves_fail;  ///< some of them, so that no tick is like the one before it
  double limit;      ///< instructions per change of status, of all threads; 0: no limit
};

const std::vector<WatchedCase>& WatchedCases();

/// The one of that name, or null.
const WatchedCase* FindWatchedCase(const std::string& name);

void Run(const WatchedCase& watched, int rounds);

/// Changes of status in one round, to IDLE too.
double ChangesPerRound(const WatchedCase& watched);

}  // namespace coppice::bench

#endif  // COPPICE_TESTS_BENCH_WATCHED_H_
