#include "robot_app/common/transforms/transform_memory.h"

#include <stdexcept>

#include "robot_app/common/transforms/message_time.h"

namespace coppice::robot {

void TransformMemory::Store(const tf2_msgs::TFMessage& message, bool is_static,
                            const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (now < newest_) buffer_.clear();
  newest_ = now;
  for (geometry_msgs::TransformStamped transform : message.transforms) {
    if (is_static) transform.header.stamp = ros::Time();  // holds always
    // Whatever else is wrong with it is refused by the buffer and then missed by Find.
    if (!IsOfTheFuture(transform.header.stamp, now))
      buffer_.setTransform(transform, "tf", is_static);
  }
}

// What tf2 throws for times that are too far from each other is none of its own exceptions.
Expected<geometry_msgs::TransformStamped> TransformMemory::Find(const std::string& parent,
                                                                const std::string& child,
                                                                const ros::Time& time) const {
  try {
    return buffer_.lookupTransform(parent, child, time);
  } catch (const std::runtime_error& problem) {
    return Problem{problem.what()};
  }
}

std::string TransformMemory::ParentOf(const std::string& child) const {
  std::string parent;
  return buffer_._getParent(child, ros::Time(), parent) ? parent : "";
}

}  // namespace coppice::robot
