// The transforms that were told of the robot's frames, whoever tells them: /tf and /tf_static of a
// robot that runs (transforms.h), or a record of it.
//
// tf2 believes every stamp. One in the far future makes all transforms that follow old ones, and
// one that no difference of times can hold ends the program; so these are left out, and one that
// is ahead a little counts as of now, or the robot would stand where it said for so long. And tf2
// never forgets a frame: who gives each person or box that he sees a frame of its own takes a
// kilobyte for each, in every program that listens. So those that are not heard of any more are
// forgotten when there are too many; what holds always stays.
#ifndef COPPICE_ROBOT_APP_COMMON_TRANSFORMS_TRANSFORM_MEMORY_H_
#define COPPICE_ROBOT_APP_COMMON_TRANSFORMS_TRANSFORM_MEMORY_H_

#include <geometry_msgs/TransformStamped.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>

#include "bt_core/base/outcome.h"

namespace coppice::robot {

/// Any thread.
class TransformMemory {
 public:
  static constexpr std::size_t kMostFrames = 1000;  ///< that move, and as many that do not
  static constexpr std::size_t kLongestName = 256;  ///< bytes
  static constexpr double kForgottenAfter = 10;     ///< not heard of; if there are too many [s]

  /// `now`: the time in which the message came. Where it goes back, what was known is of another
  /// time and forgotten. How many transforms there was no room for.
  std::size_t Store(const tf2_msgs::TFMessage& message, bool is_static, const ros::Time& now);

  /// Of the child in the parent at a time; 0: the newest that is known for both frames. A problem
  /// if it is not known, or not at that time.
  Expected<geometry_msgs::TransformStamped> Find(const std::string& parent,
                                                 const std::string& child,
                                                 const ros::Time& time) const;
  /// On which frame it hangs now; empty: not known.
  std::string ParentOf(const std::string& child) const;

 private:
  using Frames = std::unordered_map<std::string, ros::Time>;  // when each was heard of last

  void StoreFixed(geometry_msgs::TransformStamped transform);
  void StoreMoving(geometry_msgs::TransformStamped transform);
  static bool HasRoom(const Frames& frames, const geometry_msgs::TransformStamped& transform);
  void ForgetTheSilent();
  void Renew();

  // Has a lock of its own; replaced by whoever stores, while others look something up.
  std::shared_ptr<tf2::BufferCore> buffer_ = std::make_shared<tf2::BufferCore>();
  std::mutex mutex_;  // a program hears its own transforms in the thread that sends them
  ros::Time newest_;  // that was heard of
  ros::Time looked_;  // for frames that are silent
  std::unordered_map<std::string, geometry_msgs::TransformStamped> fixed_;  // by the child
  Frames fixed_frames_, moving_frames_;                                     // with their parents
  std::size_t refused_ = 0;                                                 // of this message
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_TRANSFORMS_TRANSFORM_MEMORY_H_
