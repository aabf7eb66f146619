// The transforms of /tf and /tf_static, stored by the thread that reads the sockets: no other
// thread is woken for them, and none is there for them alone, as a tf2_ros listener has one.
//
// tf2 believes every stamp. One in the far future makes all transforms that follow old ones, and
// one that no difference of times can hold ends the program; so these are left out.
#ifndef COPPICE_ROBOT_APP_COMMON_TRANSFORMS_H_
#define COPPICE_ROBOT_APP_COMMON_TRANSFORMS_H_

#include <geometry_msgs/TransformStamped.h>
#include <ros/node_handle.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <mutex>
#include <string>

#include "bt_core/base/outcome.h"
#include "robot_app/common/at_once_queue.h"

namespace coppice::robot {

/// Any thread.
class Transforms {
 public:
  /// Subscribes.
  explicit Transforms(ros::NodeHandle node = {});

  /// Of the child in the parent at a time; 0: the newest that is known for both frames. A problem
  /// if it is not known, or not at that time.
  Expected<geometry_msgs::TransformStamped> Find(const std::string& parent,
                                                 const std::string& child,
                                                 const ros::Time& time) const;
  /// On which frame it hangs now; empty: not known.
  std::string ParentOf(const std::string& child) const;

 private:
  void Store(const tf2_msgs::TFMessage& message, bool is_static);

  tf2::BufferCore buffer_;  // has a lock of its own
  std::mutex mutex_;        // a program hears its own transforms in the thread that sends them
  ros::Time newest_;        // that was heard of
  AtOnceQueue at_once_;
  ros::NodeHandle node_;
  ros::Subscriber moving_, fixed_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_TRANSFORMS_H_
