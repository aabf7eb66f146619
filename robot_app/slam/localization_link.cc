#include "robot_app/slam/localization_link.h"

#include <cmath>
#include <utility>

#include "robot_app/common/ros_support.h"

namespace coppice::robot::slam {
namespace {

using coppice_msgs::LocalizationState;

constexpr double kFresh = 1;        // s
constexpr double kElsewhere = 1;    // m: more than the odometry may be corrected at once
constexpr double kDeviation = 0.3;  // of a hint [m]
constexpr double kTurn = 0.1;       // rad
constexpr char kMap[] = "map";

}  // namespace

LocalizationLink::LocalizationLink(ros::NodeHandle node, const localization::PoseHistory& odometry,
                                   std::function<void()> carried)
    : odometry_(odometry), carried_(std::move(carried)) {
  hints_ = node.advertise<geometry_msgs::PoseWithCovarianceStamped>("/localization/hint", 5);
  state_subscriber_ = node.subscribe<LocalizationState>(
      "/localization/state", 5,
      [this](const LocalizationState::ConstPtr& state) { OnState(*state); });
  using Pose = geometry_msgs::PoseWithCovarianceStamped;
  pose_subscriber_ = node.subscribe<Pose>(
      "/localization/pose", 5, [this](const Pose::ConstPtr& message) { OnPose(*message); });
}

std::optional<Pose2D> LocalizationLink::PlaceOf(double stamp, const Pose2D& odometry) const {
  if (!is_sure_ || !odom_in_map_ || frame_ != odometry_.frame() ||
      std::abs(stamp - stamp_) > kFresh) {
    return std::nullopt;
  }
  return Compose(*odom_in_map_, odometry);
}

void LocalizationLink::Tell(double stamp, const Pose2D& pose) {
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header.stamp = ros::Time(stamp);
  message.header.frame_id = kMap;
  message.pose.pose = ToPoseMessage(pose);
  message.pose.covariance[0] = message.pose.covariance[7] = kDeviation * kDeviation;
  message.pose.covariance[35] = kTurn * kTurn;
  hints_.publish(message);
}

void LocalizationLink::OnState(const LocalizationState& state) {
  is_sure_ = state.phase == LocalizationState::OK;
  recognized_ = state.header.stamp.toSec() - state.seconds_since_recognized;
  if (state.phase == LocalizationState::LOST && odom_in_map_) {
    odom_in_map_.reset();
    carried_();
  }
}

void LocalizationLink::OnPose(const geometry_msgs::PoseWithCovarianceStamped& message) {
  const auto odometry = odometry_.At(message.header.stamp.toSec());
  if (!is_sure_ || !odometry || !IsValid(message.pose.pose)) return;
  const Pose2D pose = ToPose2D(message.pose.pose);
  const bool was_elsewhere = odom_in_map_ && frame_ == odometry_.frame() &&
                             Distance(Compose(*odom_in_map_, *odometry), pose) > kElsewhere;
  odom_in_map_ = Compose(pose, RelativeTo(*odometry, Pose2D{}));
  stamp_ = message.header.stamp.toSec();
  frame_ = odometry_.frame();
  if (was_elsewhere) carried_();
}

}  // namespace coppice::robot::slam
