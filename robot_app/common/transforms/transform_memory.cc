#include "robot_app/common/transforms/transform_memory.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "robot_app/common/transforms/message_time.h"

namespace coppice::robot {

std::size_t TransformMemory::Store(const tf2_msgs::TFMessage& message, bool is_static,
                                   const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (now < newest_) Renew();
  newest_ = now;
  refused_ = 0;
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    if (std::max(transform.child_frame_id.size(), transform.header.frame_id.size()) >
        kLongestName) {
      ++refused_;
    } else if (is_static) {
      StoreFixed(transform);
    } else if (!IsOfTheFuture(transform.header.stamp, now)) {
      StoreMoving(transform);
    }
  }
  return refused_;
}

// Whatever else is wrong with it is refused by the buffer and then missed by Find.
void TransformMemory::StoreFixed(geometry_msgs::TransformStamped transform) {
  transform.header.stamp = ros::Time();  // holds always
  if (!HasRoom(fixed_frames_, transform)) {
    ++refused_;
    return;
  }
  fixed_frames_[transform.child_frame_id] = fixed_frames_[transform.header.frame_id] = newest_;
  buffer_->setTransform(transform, "tf", true);
  fixed_[transform.child_frame_id] = std::move(transform);
}

void TransformMemory::StoreMoving(geometry_msgs::TransformStamped transform) {
  transform.header.stamp = BelievedStamp(transform.header.stamp, newest_);
  if (!HasRoom(moving_frames_, transform)) ForgetTheSilent();
  if (!HasRoom(moving_frames_, transform)) {
    ++refused_;
    return;
  }
  moving_frames_[transform.child_frame_id] = moving_frames_[transform.header.frame_id] = newest_;
  buffer_->setTransform(transform, "tf", false);
}

bool TransformMemory::HasRoom(const Frames& frames,
                              const geometry_msgs::TransformStamped& transform) {
  std::size_t count = frames.size();
  for (const std::string* const name : {&transform.child_frame_id, &transform.header.frame_id}) {
    if (frames.count(*name) == 0) ++count;
  }
  return count <= kMostFrames;
}

// tf2 can forget no frames, only all of them: the others come again in a moment.
void TransformMemory::ForgetTheSilent() {
  if (std::exchange(looked_, newest_) == newest_) return;  // for this message
  const double now = newest_.toSec();
  const bool has_silent =
      std::any_of(moving_frames_.begin(), moving_frames_.end(),
                  [&](const auto& frame) { return now - frame.second.toSec() > kForgottenAfter; });
  if (has_silent) Renew();
}

void TransformMemory::Renew() {
  moving_frames_.clear();
  auto buffer = std::make_shared<tf2::BufferCore>();
  for (const auto& [child, transform] : fixed_) buffer->setTransform(transform, "tf", true);
  std::atomic_store(&buffer_, std::move(buffer));
}

// What tf2 throws for times that are too far from each other is none of its own exceptions.
Expected<geometry_msgs::TransformStamped> TransformMemory::Find(const std::string& parent,
                                                                const std::string& child,
                                                                const ros::Time& time) const {
  try {
    return std::atomic_load(&buffer_)->lookupTransform(parent, child, time);
  } catch (const std::runtime_error& problem) {
    return Problem{problem.what()};
  }
}

std::string TransformMemory::ParentOf(const std::string& child) const {
  std::string parent;
  return std::atomic_load(&buffer_)->_getParent(child, ros::Time(), parent) ? parent : "";
}

}  // namespace coppice::robot
