// The transforms of /tf and /tf_static, stored by the thread that reads the sockets: no other
// thread is woken for them, and none is there for them alone, as a tf2_ros listener has one.
#ifndef COPPICE_ROBOT_APP_MONITORING_TF_TREE_H_
#define COPPICE_ROBOT_APP_MONITORING_TF_TREE_H_

#include <ros/node_handle.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <string>

#include "robot_app/monitoring/aggregator/at_once_queue.h"
#include "robot_app/monitoring/tf_monitor.h"

namespace coppice::robot::monitoring {

/// For the thread that spins.
class TfTree {
 public:
  /// Subscribes.
  explicit TfTree(ros::NodeHandle& node);

  /// The newest transform that is known for both frames, and where the child hangs now.
  Expected<TransformSample> Look(const std::string& parent, const std::string& child) const;

 private:
  void OnTransforms(const tf2_msgs::TFMessage& message, bool is_static);

  tf2::BufferCore buffer_;  // has a lock of its own
  AtOnceQueue at_once_;
  ros::Subscriber moving_, fixed_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_TF_TREE_H_
