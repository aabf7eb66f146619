// The transforms of /tf and /tf_static, stored by the thread that reads the sockets: no other
// thread is woken for them, and none is there for them alone, as a tf2_ros listener has one.
#ifndef COPPICE_ROBOT_APP_COMMON_TRANSFORMS_TRANSFORMS_H_
#define COPPICE_ROBOT_APP_COMMON_TRANSFORMS_TRANSFORMS_H_

#include <ros/node_handle.h>

#include <string>

#include "robot_app/common/transforms/at_once_queue.h"
#include "robot_app/common/transforms/transform_memory.h"

namespace coppice::robot {

/// Any thread.
class Transforms {
 public:
  /// Subscribes.
  explicit Transforms(ros::NodeHandle node = {});

  /// As TransformMemory.
  Expected<geometry_msgs::TransformStamped> Find(const std::string& parent,
                                                 const std::string& child,
                                                 const ros::Time& time) const {
    return memory_.Find(parent, child, time);
  }
  std::string ParentOf(const std::string& child) const { return memory_.ParentOf(child); }

 private:
  TransformMemory memory_;
  AtOnceQueue at_once_;
  ros::NodeHandle node_;
  ros::Subscriber moving_, fixed_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_TRANSFORMS_TRANSFORMS_H_
