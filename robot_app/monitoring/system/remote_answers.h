// What other computers answer when they are asked for their time and whether they are there.
#ifndef COPPICE_ROBOT_APP_MONITORING_SYSTEM_REMOTE_ANSWERS_H_
#define COPPICE_ROBOT_APP_MONITORING_SYSTEM_REMOTE_ANSWERS_H_

#include <vector>

#include "robot_app/monitoring/system/reach.h"
#include "robot_app/monitoring/system/sntp.h"

namespace coppice::robot::monitoring {

struct RemoteQuestions {
  std::vector<ClockServer> clocks;
  std::vector<ReachTarget> hosts;
  Duration deadline{0};  ///< of the clocks, then of the hosts
};

struct RemoteAnswers {
  std::vector<Expected<ClockReading>> clocks;  ///< in the order of the questions
  std::vector<ReachDelay> hosts;
};

/// Waits for the answers: for a thread that has time.
RemoteAnswers AskComputers(const RemoteQuestions& questions);

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_SYSTEM_REMOTE_ANSWERS_H_
