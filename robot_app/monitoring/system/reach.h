// Can other computers be reached? Asked by a TCP connection, for which no privileges are needed;
// a computer that refuses it is up too.
#ifndef COPPICE_ROBOT_APP_MONITORING_SYSTEM_REACH_H_
#define COPPICE_ROBOT_APP_MONITORING_SYSTEM_REACH_H_

#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/outcome.h"

namespace coppice::robot::monitoring {

struct ReachTarget {
  std::string address;
  int port = 22;
};

/// How long the answer took [s].
using ReachDelay = Expected<double>;

/// Asks all at the same time; blocks until all have answered or the deadline has passed (the
/// resolution of names takes its own time). For any thread.
std::vector<ReachDelay> TryToReach(const std::vector<ReachTarget>& targets, Duration deadline);

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_SYSTEM_REACH_H_
