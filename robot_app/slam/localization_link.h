// What passes between coppice-slam and the localization over ROS: where the robot is on the map
// that it navigates on, one way; places that are recognized in pictures, the other.
#ifndef COPPICE_ROBOT_APP_SLAM_LOCALIZATION_LINK_H_
#define COPPICE_ROBOT_APP_SLAM_LOCALIZATION_LINK_H_

#include <coppice_msgs/LocalizationState.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/node_handle.h>

#include <functional>
#include <limits>
#include <optional>

#include "robot_app/localization/pose_history.h"

namespace coppice::robot::slam {

/// On the callback queue's thread.
class LocalizationLink {
 public:
  /// `odometry` must outlive it. `carried` is called when the robot is not where it was believed:
  /// somebody has carried it away, or the localization was wrong.
  LocalizationLink(ros::NodeHandle node, const localization::PoseHistory& odometry,
                   std::function<void()> carried);

  /// The localization says that it is sure.
  bool is_sure() const { return is_sure_; }

  /// The stamp at which it last believed what it was told [s]; -infinity: never.
  double recognized() const { return recognized_; }

  /// base_link on the map for base_link in odom at `stamp`; nothing unless the localization was
  /// sure within the last second.
  std::optional<Pose2D> PlaceOf(double stamp, const Pose2D& odometry) const;

  /// Whether anybody wants to hear of recognized places.
  bool IsAsked() const { return hints_.getNumSubscribers() > 0; }
  /// base_link was at `pose` on the map at `stamp`, as a picture says.
  void Tell(double stamp, const Pose2D& pose);

 private:
  void OnState(const coppice_msgs::LocalizationState& state);
  void OnPose(const geometry_msgs::PoseWithCovarianceStamped& message);

  const localization::PoseHistory& odometry_;
  std::function<void()> carried_;
  bool is_sure_ = false;
  double recognized_ = -std::numeric_limits<double>::infinity();
  std::optional<Pose2D> odom_in_map_;  // when it was sure last, in this frame of the odometry
  double stamp_ = 0;                   // of that
  int frame_ = 0;                      // of the odometry
  ros::Publisher hints_;
  ros::Subscriber state_subscriber_, pose_subscriber_;
};

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_LOCALIZATION_LINK_H_
