// The transforms that were told of the robot's frames, whoever tells them: /tf and /tf_static of a
// robot that runs (transforms.h), or a record of it.
//
// tf2 believes every stamp. One in the far future makes all transforms that follow old ones, and
// one that no difference of times can hold ends the program; so these are left out.
#ifndef COPPICE_ROBOT_APP_COMMON_TRANSFORMS_TRANSFORM_MEMORY_H_
#define COPPICE_ROBOT_APP_COMMON_TRANSFORMS_TRANSFORM_MEMORY_H_

#include <geometry_msgs/TransformStamped.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <mutex>
#include <string>

#include "bt_core/base/outcome.h"

namespace coppice::robot {

/// Any thread.
class TransformMemory {
 public:
  /// `now`: the time in which the message came. Where it goes back, what was known is of another
  /// time and forgotten.
  void Store(const tf2_msgs::TFMessage& message, bool is_static, const ros::Time& now);

  /// Of the child in the parent at a time; 0: the newest that is known for both frames. A problem
  /// if it is not known, or not at that time.
  Expected<geometry_msgs::TransformStamped> Find(const std::string& parent,
                                                 const std::string& child,
                                                 const ros::Time& time) const;
  /// On which frame it hangs now; empty: not known.
  std::string ParentOf(const std::string& child) const;

 private:
  tf2::BufferCore buffer_;  // has a lock of its own
  std::mutex mutex_;        // a program hears its own transforms in the thread that sends them
  ros::Time newest_;        // that was heard of
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_TRANSFORMS_TRANSFORM_MEMORY_H_
