// Publishes what the trees do against faults on /recovery/events (coppice_msgs/RecoveryEvent), and
// judges each recovery when it is certain whether it helped.
#ifndef COPPICE_ROBOT_APP_ROS_ROS_RECOVERY_LOG_H_
#define COPPICE_ROBOT_APP_ROS_ROS_RECOVERY_LOG_H_

#include <ros/node_handle.h>

#include <mutex>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_nodes/recovery/recovery_judge.h"
#include "bt_nodes/recovery/recovery_log.h"

namespace coppice::robot::adapters {

class RosRecoveryLog : public leaves::RecoveryLog {
 public:
  /// `clock`: that of the trees; must live as long.
  RosRecoveryLog(ros::NodeHandle& node, const Clock& clock);

  void Record(const leaves::RecoveryEvent& event) override;

 private:
  void Publish(const std::vector<leaves::RecoveryVerdict>& verdicts);
  void OnTimer();

  const Clock& clock_;
  ros::Publisher events_;
  std::mutex mutex_;  // of the judge: the trees' threads and the timer's
  leaves::RecoveryJudge judge_;
  ros::WallTimer timer_;
};

}  // namespace coppice::robot::adapters

#endif  // COPPICE_ROBOT_APP_ROS_ROS_RECOVERY_LOG_H_
